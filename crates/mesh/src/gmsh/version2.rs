//! Nodes and elements of MSH 2: one list of each; an element names its physical group.

use std::collections::{BTreeMap, HashMap};

use super::entities::{Names, named_points, physical_name};
use super::kinds::{FACETS, Kind, Role, SOLIDS, kind, unusable};
use super::node;
use super::numbers::{Encoding, Numbers};
use crate::assembly::{Draft, Facet, Numbering};
use crate::fault::Fault;

/// Reads the section $Nodes into the mesh, all of them, with their numbers.
pub(super) fn nodes(numbers: &mut Numbers, draft: &mut Draft) -> Result<(), Fault> {
    numbers.input.expect("the number of nodes")?;
    let count = numbers.input.count("the number of nodes")?;
    for _ in 0..count {
        numbers.begin("a node")?;
        draft.mesh.node_ids.push(numbers.short("a node's number")?);
        let mut x = [0.0; 3];
        for x in &mut x {
            *x = numbers.real("a coordinate")?;
        }
        numbers.end()?;
        draft.mesh.nodes.push(x);
    }
    Ok(())
}

/// Reads the section $Elements.
pub(super) fn elements(
    numbers: &mut Numbers,
    draft: &mut Draft,
    numbering: &Numbering,
    names: &Names,
) -> Result<(), Fault> {
    numbers.input.expect("the number of elements")?;
    let count = numbers.input.count("the number of elements")?;
    let mut reader = Elements {
        draft,
        numbering,
        names,
        groups: BTreeMap::new(),
        lists: HashMap::new(),
        points: BTreeMap::new(),
    };
    let mut left = count;
    while left > 0 {
        // A binary file groups elements of one type; in a text file each is a group of its own.
        let (number, group, tags, id);
        if numbers.encoding == Encoding::Ascii {
            numbers.begin("an element")?;
            id = Some(numbers.short("an element's number")?);
            number = numbers.short("an element's type")?;
            tags = numbers.short("the number of tags")?;
            group = 1;
        } else {
            number = numbers.short("an element's type")?;
            group = numbers.short("the number of elements in the block")?;
            tags = numbers.short("the number of tags")?;
            id = None;
        }
        if group == 0 || group > left {
            let problem = format!("a block of {group} elements where {left} are left; the file is damaged");
            return Err(numbers.input.fault(problem));
        }
        for _ in 0..group {
            let id = match id {
                Some(id) => id,
                None => numbers.short("an element's number")?,
            };
            reader.element(numbers, id, number, tags)?;
        }
        left -= group;
    }
    let Elements { groups, points, .. } = reader;
    for (tag, list) in groups {
        draft.mesh.groups.entry(physical_name(names, 3, tag)).or_default().extend(list);
    }
    draft.mesh.points = named_points(points);
    Ok(())
}

struct Elements<'a> {
    draft: &'a mut Draft,
    numbering: &'a Numbering,
    names: &'a Names,
    /// Solids by physical tag.
    groups: BTreeMap<i64, Vec<u32>>,
    /// The list of names for each physical tag of a surface.
    lists: HashMap<i64, u32>,
    points: BTreeMap<String, Vec<[f64; 3]>>,
}

impl Elements<'_> {
    /// One element, after its number, type and number of tags.
    fn element(&mut self, numbers: &mut Numbers, id: u64, number: u64, tags: u64) -> Result<(), Fault> {
        let mut physical = 0;
        for tag in 0..tags {
            let value = numbers.tag("a tag")?;
            match tag {
                0 => physical = value.saturating_abs(),
                2 if value > 0 => return Err(numbers.input.fault(super::PARTITIONED)),
                _ => {}
            }
        }
        let Some(kind) = kind(number) else { return Err(numbers.input.fault(unusable(number, SOLIDS))) };
        let mut corners = [0; 8];
        for k in 0..kind.nodes {
            let number = numbers.short("a node's number")?;
            let index = node(numbers, self.numbering, number)?;
            if let Some(corner) = corners.get_mut(k) {
                *corner = index;
            }
        }
        numbers.end()?;
        self.take(numbers, kind, id, number, physical, &corners)
    }

    fn take(
        &mut self,
        numbers: &Numbers,
        kind: Kind,
        id: u64,
        number: u64,
        physical: i64,
        corners: &[u32; 8],
    ) -> Result<(), Fault> {
        match kind.role {
            Role::Solid(shape) => {
                let corners = &corners[..shape.nodes()];
                // Gmsh writes an element of two physical groups twice, one after the other.
                let again =
                    self.draft.mesh.elements.last().is_some_and(|e| e.shape == shape && e.nodes() == corners);
                if !again {
                    self.draft.push(id, shape, corners);
                    self.draft.reduce(kind.nodes, shape);
                }
                if physical != 0 {
                    let last = self.draft.mesh.elements.len() as u32 - 1;
                    self.groups.entry(physical).or_default().push(last);
                }
            }
            Role::Facet(sides) if physical != 0 => {
                let (draft, names) = (&mut *self.draft, self.names);
                let list = *self.lists.entry(physical).or_insert_with(|| {
                    draft.names.push(vec![physical_name(names, 2, physical)]);
                    draft.names.len() as u32 - 1
                });
                self.draft.facets.push(Facet::new(&corners[..sides], id, list));
            }
            Role::Point if physical != 0 => {
                let name = physical_name(self.names, 0, physical);
                self.points.entry(name).or_default().push(self.draft.mesh.nodes[corners[0] as usize]);
            }
            Role::Other if kind.nodes > 4 => {
                let usable = if kind.name.contains("hedra") { SOLIDS } else { FACETS };
                return Err(numbers.input.fault(unusable(number, usable)));
            }
            _ => self.draft.skip(kind.name, 1),
        }
        Ok(())
    }
}
