//! Gmsh's MSH 4.1 files in ASCII.
//!
//! Physical volumes become groups of elements, physical surfaces groups of faces, physical points named
//! points; physical curves are passed over. Elements of no physical volume form the group `ungrouped`.
//! A physical group without a name is called by its dimension and tag, as `volume 3` or `surface 7`.
//! Sections that are not needed are skipped.

mod entities;
mod fields;
mod sections;

use std::collections::HashMap;
use std::path::Path;

use crate::assembly::{Draft, Facet, Numbering};
use crate::input::Input;
use crate::note::Note;
use crate::read::{Fault, Format};
use crate::{Element, Mesh, Shape};
use entities::{Entities, physical_names};
use fields::{Fields, Lines};
use sections::{Section, Sections, is_msh};

/// MSH 4.1 ASCII, for [`crate::read::read`].
pub(crate) const FORMAT: Format = Format { name: "Gmsh MSH 4.1 ASCII", recognises: is_msh, parse: read };

fn read(input: &mut Input, _: &Path) -> Result<(Mesh, Vec<Note>), Fault> {
    sound(&input.rest()?)
}

#[cfg(test)]
fn parse(bytes: &[u8]) -> Result<Mesh, Fault> {
    sound(bytes).map(|(mesh, _)| mesh)
}

/// Group of the elements of no physical volume.
const UNGROUPED: &str = "ungrouped";

fn sound(bytes: &[u8]) -> Result<(Mesh, Vec<Note>), Fault> {
    let sections = Sections::find(bytes)?;
    let names = sections.get("PhysicalNames").map_or(Ok(HashMap::new()), physical_names)?;
    let entities =
        sections.get("Entities").map_or(Ok(Entities::default()), |s| Entities::parse(s, &names))?;
    let missing = |name| Fault::whole(format!("there is no section ${name}; save the whole mesh from Gmsh"));
    let mut mesh = Mesh { points: entities.points, ..Mesh::default() };
    let numbering = nodes(sections.get("Nodes").ok_or_else(|| missing("Nodes"))?, &mut mesh)?;
    let section = sections.get("Elements").ok_or_else(|| missing("Elements"))?;
    let mut elements = Elements { numbering, groups: entities.groups, mesh, facets: vec![], names: vec![] };
    elements.parse(section)?;
    let Elements { mesh, facets, names, .. } = elements;
    let mut draft = Draft::default();
    (draft.mesh, draft.facets, draft.names) = (mesh, facets, names);
    draft.finish(
        "mesh the volumes (Mesh > 3D) and save with them in a physical volume, or with Mesh.SaveAll = 1",
    )
}

/// Reads the nodes into the mesh, all of them, with their numbers.
fn nodes(section: &Section, mesh: &mut Mesh) -> Result<Numbering, Fault> {
    let mut lines = section.lines();
    let mut header = lines.expect("the numbers of blocks and nodes")?;
    let blocks = header.count("the number of blocks")?;
    let total = header.count("the number of nodes")?;
    for _ in 0..blocks {
        let mut block = lines.expect("a block of nodes")?;
        block.integer("an entity's dimension")?;
        block.integer("an entity's tag")?;
        let parametric = block.count("0 or 1 for parametric coordinates")? != 0;
        let count = block.count("the number of nodes in the block")?;
        block.end()?;
        for _ in 0..count {
            let mut line = lines.expect("a node's number")?;
            mesh.node_ids.push(line.count("a node's number")?);
            line.end()?;
        }
        for _ in 0..count {
            let mut line = lines.expect("a node's coordinates")?;
            let mut x = [0.0; 3];
            for x in &mut x {
                *x = line.real("a coordinate")?;
            }
            if !parametric {
                line.end()?;
            }
            mesh.nodes.push(x);
        }
    }
    ended(&mut lines, header.line, "nodes", total, mesh.nodes.len() as u64)?;
    if mesh.nodes.len() >= u32::MAX as usize {
        return Err(Fault::at(header.line, "there are more nodes than 32 bits can number"));
    }
    Numbering::new(&mesh.node_ids)
        .map_err(|number| Fault::at(header.line, format!("there are two nodes {number}; renumber the nodes")))
}

/// A section must end after its blocks and hold as many items as its header says.
fn ended(lines: &mut Lines, header: usize, what: &str, wanted: u64, found: u64) -> Result<(), Fault> {
    if let Some(line) = lines.next() {
        return Err(Fault::at(
            line.line,
            format!("this line follows the last block of {what} in the section's count"),
        ));
    }
    if wanted != found {
        return Err(Fault::at(header, format!("{wanted} {what} are announced, {found} are there")));
    }
    Ok(())
}

/// The mesh while its elements are read.
struct Elements {
    numbering: Numbering,
    groups: HashMap<(u64, i64), Vec<String>>,
    mesh: Mesh,
    facets: Vec<Facet>,
    /// The lists of groups that facets refer to.
    names: Vec<Vec<String>>,
}

impl Elements {
    fn parse(&mut self, section: &Section) -> Result<(), Fault> {
        let mut lines = section.lines();
        let mut header = lines.expect("the numbers of blocks and elements")?;
        let blocks = header.count("the number of blocks")?;
        let total = header.count("the number of elements")?;
        let mut found = 0;
        for _ in 0..blocks {
            let mut block = lines.expect("a block of elements")?;
            let dimension = block.count("an entity's dimension")?;
            let entity = block.integer("an entity's tag")?;
            let kind = block.count("the type of the elements")?;
            let count = block.count("the number of elements in the block")?;
            block.end()?;
            let groups = self.groups.get(&(dimension, entity)).cloned().unwrap_or_default();
            match (dimension, groups.is_empty()) {
                (3, _) => self.solids(&mut lines, block.line, kind, count, groups)?,
                (2, false) => self.surface(&mut lines, block.line, kind, count, groups)?,
                _ => {
                    for _ in 0..count {
                        lines.expect("an element")?;
                    }
                }
            }
            found += count;
        }
        ended(&mut lines, header.line, "elements", total, found)?;
        if self.mesh.elements.len() >= u32::MAX as usize {
            return Err(Fault::at(header.line, "there are more elements than 32 bits can number"));
        }
        Ok(())
    }

    /// A block of solid elements.
    fn solids(
        &mut self,
        lines: &mut Lines,
        block: usize,
        kind: u64,
        count: u64,
        mut groups: Vec<String>,
    ) -> Result<(), Fault> {
        let shape = match kind {
            4 => Shape::Tet4,
            5 => Shape::Hex8,
            6 => Shape::Wedge6,
            7 => Shape::Pyramid5,
            _ => return Err(unusable(block, kind, "4 to 8 nodes (tetrahedra, pyramids, wedges, hexahedra)")),
        };
        let first = self.mesh.elements.len() as u32;
        for _ in 0..count {
            let mut line = lines.expect("an element")?;
            self.mesh.element_ids.push(line.count("an element's number")?);
            let mut nodes = [0; 8];
            for node in &mut nodes[..shape.nodes()] {
                *node = self.node(&mut line)?;
            }
            line.end()?;
            self.mesh.elements.push(Element::new(shape, &nodes[..shape.nodes()]));
        }
        if count == 0 {
            return Ok(());
        }
        if groups.is_empty() {
            groups.push(UNGROUPED.to_owned());
        }
        for group in groups {
            self.mesh.groups.entry(group).or_default().extend(first..self.mesh.elements.len() as u32);
        }
        Ok(())
    }

    /// A block of elements of a named surface.
    fn surface(
        &mut self,
        lines: &mut Lines,
        block: usize,
        kind: u64,
        count: u64,
        groups: Vec<String>,
    ) -> Result<(), Fault> {
        let corners = match kind {
            2 => 3,
            3 => 4,
            _ => return Err(unusable(block, kind, "3 or 4 nodes (triangles, quadrilaterals)")),
        };
        let list = self.names.len() as u32;
        self.names.push(groups);
        for _ in 0..count {
            let mut line = lines.expect("an element")?;
            let number = line.count("an element's number")?;
            let mut key = [u32::MAX; 4];
            for node in &mut key[..corners] {
                *node = self.node(&mut line)?;
            }
            line.end()?;
            key.sort_unstable();
            self.facets.push(Facet { key, number, list });
        }
        Ok(())
    }

    /// The index of the node whose number is next in the line.
    fn node(&self, line: &mut Fields) -> Result<u32, Fault> {
        let number = line.count("a node's number")?;
        self.numbering.index(number).ok_or_else(|| {
            Fault::at(
                line.line,
                format!("node {number} is not in the section $Nodes; save the whole mesh again"),
            )
        })
    }
}

/// The fault of a block of elements that no model can hold.
fn unusable(line: usize, kind: u64, usable: &str) -> Fault {
    let name = match kind {
        8 => "3-node lines",
        9 => "6-node triangles",
        10 => "9-node quadrilaterals",
        11 => "10-node tetrahedra",
        12 => "27-node hexahedra",
        13 => "18-node wedges",
        14 => "14-node pyramids",
        16 => "8-node quadrilaterals",
        17 => "20-node hexahedra",
        18 => "15-node wedges",
        19 => "13-node pyramids",
        29 => "20-node tetrahedra",
        92 => "64-node hexahedra",
        _ => "",
    };
    let name = if name.is_empty() { format!("elements of Gmsh's type {kind}") } else { name.to_owned() };
    Fault::at(
        line,
        format!(
            "{name} are not supported, only elements of {usable}; set Mesh.ElementOrder = 1 and mesh again"
        ),
    )
}

#[cfg(test)]
mod tests;
