//! Nodes and elements of MSH 4.1: blocks, one or more an entity.

use std::collections::HashMap;

use super::kinds::{FACETS, Kind, Role, SOLIDS, kind, unusable};
use super::node;
use super::numbers::Numbers;
use crate::assembly::{Draft, Facet, Numbering};
use crate::fault::Fault;

/// Reads the section $Nodes into the mesh, all of them, with their numbers.
pub(super) fn nodes(numbers: &mut Numbers, draft: &mut Draft) -> Result<(), Fault> {
    let mesh = &mut draft.mesh;
    let (blocks, total) = header(numbers, "nodes")?;
    for _ in 0..blocks {
        numbers.begin("a block of nodes")?;
        let dimension = numbers.tag("an entity's dimension")?;
        numbers.tag("an entity's tag")?;
        let parametric = numbers.short("0 or 1 for parametric coordinates")? != 0;
        let count = numbers.count("the number of nodes in the block")?;
        numbers.end()?;
        for _ in 0..count {
            numbers.begin("a node's number")?;
            mesh.node_ids.push(numbers.count("a node's number")?);
            numbers.end()?;
        }
        for _ in 0..count {
            numbers.begin("a node's coordinates")?;
            let mut x = [0.0; 3];
            for x in &mut x {
                *x = numbers.real("a coordinate")?;
            }
            if parametric {
                numbers.pass(dimension.clamp(0, 3) as u64, 8, "a parametric coordinate")?;
            } else {
                numbers.end()?;
            }
            mesh.nodes.push(x);
        }
    }
    agree(numbers, "nodes", total, mesh.nodes.len() as u64)
}

/// The first line of both sections; the numbers of blocks and of what is in them.
fn header(numbers: &mut Numbers, what: &str) -> Result<(u64, u64), Fault> {
    numbers.begin(&format!("the numbers of blocks and {what}"))?;
    let blocks = numbers.count("the number of blocks")?;
    let total = numbers.count(&format!("the number of {what}"))?;
    numbers.count("the smallest number")?;
    numbers.count("the largest number")?;
    numbers.end()?;
    Ok((blocks, total))
}

fn agree(numbers: &Numbers, what: &str, wanted: u64, found: u64) -> Result<(), Fault> {
    if wanted == found {
        return Ok(());
    }
    Err(numbers.input.fault(format!(
        "the section announces {wanted} {what} and has {found} up to here; the file is damaged"
    )))
}

/// Reads the section $Elements. `groups` has the names of the physical groups by entity.
pub(super) fn elements(
    numbers: &mut Numbers,
    draft: &mut Draft,
    numbering: &Numbering,
    groups: &HashMap<(u64, i64), Vec<String>>,
) -> Result<(), Fault> {
    let (blocks, total) = header(numbers, "elements")?;
    let mut found = 0_u64;
    for _ in 0..blocks {
        numbers.begin("a block of elements")?;
        let dimension = numbers.short("an entity's dimension")?;
        let entity = numbers.tag("an entity's tag")?;
        let number = numbers.short("the type of the elements")?;
        let count = numbers.count("the number of elements in the block")?;
        numbers.end()?;
        let names = groups.get(&(dimension, entity)).map_or([].as_slice(), Vec::as_slice);
        let kind = kind(number);
        match (dimension, kind) {
            (3, Some(Kind { nodes, role: Role::Solid(shape), .. })) => {
                let first = draft.mesh.elements.len() as u32;
                for _ in 0..count {
                    numbers.begin("an element")?;
                    let id = numbers.count("an element's number")?;
                    let corners = corners(numbers, numbering, nodes, shape.nodes())?;
                    draft.push(id, shape, &corners[..shape.nodes()]);
                    draft.reduce(nodes, shape);
                }
                for name in names {
                    let group = draft.mesh.groups.entry(name.clone()).or_default();
                    group.extend(first..draft.mesh.elements.len() as u32);
                }
            }
            (3, _) => return Err(numbers.input.fault(unusable(number, SOLIDS))),
            (2, Some(Kind { nodes, role: Role::Facet(sides), .. })) if !names.is_empty() => {
                let list = draft.names.len() as u32;
                draft.names.push(names.to_vec());
                for _ in 0..count {
                    numbers.begin("an element")?;
                    let id = numbers.count("an element's number")?;
                    let corners = corners(numbers, numbering, nodes, sides)?;
                    draft.facets.push(Facet::new(&corners[..sides], id, list));
                }
            }
            (2, _) if !names.is_empty() => return Err(numbers.input.fault(unusable(number, FACETS))),
            (_, Some(kind)) => {
                for _ in 0..count {
                    numbers.begin("an element")?;
                    numbers.pass(1 + kind.nodes as u64, 8, "an element")?;
                }
                draft.skip(kind.name, usize::try_from(count).unwrap_or(usize::MAX));
            }
            (_, None) => return Err(numbers.input.fault(unusable(number, FACETS))),
        }
        found = found.saturating_add(count);
    }
    agree(numbers, "elements", total, found)
}

/// The first `corners` of an element's `nodes` nodes; the others must be there too.
fn corners(
    numbers: &mut Numbers,
    numbering: &Numbering,
    nodes: usize,
    corners: usize,
) -> Result<[u32; 8], Fault> {
    let mut all = [0; 8];
    for k in 0..nodes {
        let number = numbers.count("a node's number")?;
        let index = node(numbers, numbering, number)?;
        if let Some(corner) = all[..corners].get_mut(k) {
            *corner = index;
        }
    }
    numbers.end()?;
    Ok(all)
}
