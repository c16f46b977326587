//! Writing MSH 4.1.

use std::collections::{BTreeMap, HashMap};
use std::io::{self, Write};

use super::kinds;
use super::out::Out;
use crate::note::Note;
use crate::topology::{all_faces, face_key};
use crate::trouble::Trouble;
use crate::{Face, Mesh};

/// Writes a mesh as MSH 4.1 ASCII.
///
/// Elements keep their order: a new block begins wherever the shape or the groups change.
pub(crate) fn ascii(mesh: &Mesh, out: &mut dyn Write) -> Result<Vec<Note>, Trouble> {
    write(mesh, &mut Out { out, binary: false, fresh: true })
}

/// Writes a mesh as MSH 4.1 binary.
pub(crate) fn binary(mesh: &Mesh, out: &mut dyn Write) -> Result<Vec<Note>, Trouble> {
    write(mesh, &mut Out { out, binary: true, fresh: true })
}

/// The different combinations of groups that things belong to; Gmsh gives each its own entity.
struct Combinations {
    /// Groups of each combination; the first has none.
    groups: Vec<Vec<u32>>,
    /// The combination that another becomes with one more group.
    next: HashMap<(u32, u32), u32>,
}

impl Combinations {
    fn new() -> Self {
        Combinations { groups: vec![Vec::new()], next: HashMap::new() }
    }

    fn with(&mut self, combination: u32, group: u32) -> u32 {
        if self.groups[combination as usize].last() == Some(&group) {
            return combination;
        }
        *self.next.entry((combination, group)).or_insert_with(|| {
            let mut groups = self.groups[combination as usize].clone();
            groups.push(group);
            self.groups.push(groups);
            self.groups.len() as u32 - 1
        })
    }
}

fn write(mesh: &Mesh, out: &mut Out) -> Result<Vec<Note>, Trouble> {
    let mut volumes = Combinations::new();
    let mut of_element = vec![0; mesh.elements.len()];
    for (group, list) in (1..).zip(mesh.groups.values()) {
        for &e in list {
            of_element[e as usize] = volumes.with(of_element[e as usize], group);
        }
    }
    let mut surfaces = Combinations::new();
    let mut of_facet: BTreeMap<[u32; 4], (Face, u32)> = BTreeMap::new();
    for (group, list) in (1..).zip(mesh.faces.values()) {
        for &face in list {
            let (_, combination) = of_facet.entry(face_key(mesh, face)).or_insert((face, 0));
            *combination = surfaces.with(*combination, group);
        }
    }
    let notes = named_for_one_side(mesh, &of_facet);

    out.text("$MeshFormat")?;
    out.text(if out.binary { "4.1 1 8" } else { "4.1 0 8" })?;
    if out.binary {
        out.tag(1)?;
        writeln!(out.out)?;
    }
    out.text("$EndMeshFormat")?;
    physical_names(mesh, out)?;
    entities(mesh, out, &volumes, &surfaces)?;
    nodes(mesh, out)?;
    let mut facets: Vec<(u32, Face)> = of_facet.into_values().map(|(face, c)| (c, face)).collect();
    facets.sort_unstable();
    elements(mesh, out, &of_element, &facets)?;
    Ok(notes)
}

/// Faces inside the mesh that a surface names for one of their two elements only: the format cannot say which.
fn named_for_one_side(mesh: &Mesh, facets: &BTreeMap<[u32; 4], (Face, u32)>) -> Vec<Note> {
    if facets.is_empty() {
        return Vec::new();
    }
    let mut both: HashMap<[u32; 4], Vec<Face>> = HashMap::new();
    for face in all_faces(mesh, None) {
        let key = face_key(mesh, face);
        if facets.contains_key(&key) {
            both.entry(key).or_default().push(face);
        }
    }
    let mut notes = Vec::new();
    for (name, list) in &mesh.faces {
        let mut sorted = list.clone();
        sorted.sort_unstable();
        let alone =
            |&&face: &&Face| both[&face_key(mesh, face)].iter().any(|f| sorted.binary_search(f).is_err());
        let count = list.iter().filter(alone).count();
        if count > 0 {
            notes.push(Note::BothSides { name: name.clone(), count });
        }
    }
    notes
}

fn physical_names(mesh: &Mesh, out: &mut Out) -> Result<(), Trouble> {
    let (points, faces, groups) = (mesh.points.keys(), mesh.faces.keys(), mesh.groups.keys());
    out.text("$PhysicalNames")?;
    out.text(&(points.len() + faces.len() + groups.len()).to_string())?;
    let of = |dimension: u32, tag: u32, name: &str| {
        let holds =
            !name.is_empty() && name.trim() == name && !name.contains(|c: char| c == '"' || c.is_control());
        if holds {
            return Ok(format!("{dimension} {tag} \"{name}\""));
        }
        Err(Trouble::Mesh(format!(
            "MSH cannot hold the name {name:?}: names are not empty, without quotes, and without blanks at their ends; \
             rename it"
        )))
    };
    for (tag, name) in (1..).zip(points) {
        out.text(&of(0, tag, name)?)?;
    }
    for (tag, name) in (1..).zip(faces) {
        out.text(&of(2, tag, name)?)?;
    }
    for (tag, name) in (1..).zip(groups) {
        out.text(&of(3, tag, name)?)?;
    }
    out.text("$EndPhysicalNames")?;
    Ok(())
}

fn entities(mesh: &Mesh, out: &mut Out, volumes: &Combinations, surfaces: &Combinations) -> io::Result<()> {
    out.text("$Entities")?;
    for count in [mesh.points.len(), 0, surfaces.groups.len(), volumes.groups.len()] {
        out.count(count as u64)?;
    }
    out.end()?;
    for (tag, place) in (1..).zip(mesh.points.values()) {
        out.tag(tag)?;
        for &x in place {
            out.real(x)?;
        }
        out.count(1)?;
        out.tag(tag)?;
        out.end()?;
    }
    let (low, high) = if mesh.nodes.is_empty() { ([0.0; 3], [0.0; 3]) } else { mesh.bounds() };
    for combinations in [surfaces, volumes] {
        for (tag, groups) in (1..).zip(&combinations.groups) {
            out.tag(tag)?;
            for x in low.into_iter().chain(high) {
                out.real(x)?;
            }
            out.count(groups.len() as u64)?;
            for &group in groups {
                out.tag(group)?;
            }
            out.count(0)?;
            out.end()?;
        }
    }
    out.close("Entities")
}

fn nodes(mesh: &Mesh, out: &mut Out) -> io::Result<()> {
    out.text("$Nodes")?;
    let (low, high) = range(mesh.nodes.len(), |n| mesh.node_id(n));
    for number in [1, mesh.nodes.len() as u64, low, high] {
        out.count(number)?;
    }
    out.end()?;
    for number in [3, 1, 0] {
        out.tag(number)?;
    }
    out.count(mesh.nodes.len() as u64)?;
    out.end()?;
    for n in 0..mesh.nodes.len() {
        out.count(mesh.node_id(n))?;
        out.end()?;
    }
    for node in &mesh.nodes {
        for &x in node {
            out.real(x)?;
        }
        out.end()?;
    }
    out.close("Nodes")
}

/// Smallest and largest of the numbers of `count` things; 0 and 0 if there are none.
fn range(count: usize, number: impl Fn(usize) -> u64) -> (u64, u64) {
    (0..count)
        .map(&number)
        .fold(None, |range: Option<(u64, u64)>, n| match range {
            Some((low, high)) => Some((low.min(n), high.max(n))),
            None => Some((n, n)),
        })
        .unwrap_or((0, 0))
}

fn elements(mesh: &Mesh, out: &mut Out, of_element: &[u32], facets: &[(u32, Face)]) -> Result<(), Trouble> {
    out.text("$Elements")?;
    let corners = |face: Face| mesh.elements[face.element as usize].shape.faces()[face.side as usize].len();
    let surface_blocks: Vec<&[(u32, Face)]> =
        facets.chunk_by(|a, b| a.0 == b.0 && corners(a.1) == corners(b.1)).collect();
    let all: Vec<u32> = (0..mesh.elements.len() as u32).collect();
    let alike = |a: usize, b: usize| {
        of_element[a] == of_element[b] && mesh.elements[a].shape == mesh.elements[b].shape
    };
    let volume_blocks: Vec<&[u32]> = all.chunk_by(|&a, &b| alike(a as usize, b as usize)).collect();
    let (low, high) = range(mesh.elements.len(), |e| mesh.element_id(e));
    let Some(last) = high.checked_add(facets.len() as u64) else {
        return Err(Trouble::Mesh(
            "the element numbers leave no room for those of surfaces; renumber them".into(),
        ));
    };
    let low = if facets.is_empty() { low } else { low.min(high + 1) };
    let blocks = surface_blocks.len() + volume_blocks.len();
    for number in [blocks as u64, (facets.len() + mesh.elements.len()) as u64, low, last] {
        out.count(number)?;
    }
    out.end()?;
    let block = |out: &mut Out, dimension: u32, entity: u32, kind: u32, count: usize| -> io::Result<()> {
        for number in [dimension, entity, kind] {
            out.tag(number)?;
        }
        out.count(count as u64)?;
        out.end()
    };
    let mut number = high;
    for facets in surface_blocks {
        let (combination, first) = facets[0];
        // Triangle 2, quadrilateral 3.
        block(out, 2, combination + 1, corners(first) as u32 - 1, facets.len())?;
        for &(_, face) in facets {
            number += 1;
            out.count(number)?;
            for node in mesh.face_nodes(face) {
                out.count(mesh.node_id(node as usize))?;
            }
            out.end()?;
        }
    }
    for elements in volume_blocks {
        let first = elements[0] as usize;
        block(out, 3, of_element[first] + 1, kinds::number(mesh.elements[first].shape), elements.len())?;
        for &e in elements {
            out.count(mesh.element_id(e as usize))?;
            for &node in mesh.elements[e as usize].nodes() {
                out.count(mesh.node_id(node as usize))?;
            }
            out.end()?;
        }
    }
    out.close("Elements")?;
    Ok(())
}
