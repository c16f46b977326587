//! Writing Abaqus input files.

use std::collections::HashMap;
use std::io::{self, Write};

use super::kinds;
use crate::Mesh;
use crate::note::Note;
use crate::shortest::Shortest;
use crate::trouble::Trouble;

/// The largest number that Abaqus takes.
const LARGEST: u64 = 999_999_999;

/// Writes a mesh as an Abaqus input file without parts.
///
/// Groups become element sets, faces surfaces, and named points node sets of one node: that of the mesh at the
/// very place, or one of its own.
pub(crate) fn write_mesh(mesh: &Mesh, out: &mut dyn Write) -> Result<Vec<Note>, Trouble> {
    let largest = |count: usize, number: &dyn Fn(usize) -> u64| (0..count).map(number).max().unwrap_or(0);
    let last_node = largest(mesh.nodes.len(), &|n| mesh.node_id(n));
    let last_element = largest(mesh.elements.len(), &|e| mesh.element_id(e));
    let most = last_node.saturating_add(mesh.points.len() as u64).max(last_element);
    if most > LARGEST {
        return Err(Trouble::Mesh(format!(
            "Abaqus takes numbers up to {LARGEST}, this mesh has {most}; renumber it"
        )));
    }
    writeln!(out, "*HEADING\nMesh in metres, z up, written by Tremolite\n*NODE")?;
    let node = |out: &mut dyn Write, number: u64, [x, y, z]: [f64; 3]| {
        writeln!(out, "{number}, {}, {}, {}", Shortest(x), Shortest(y), Shortest(z))
    };
    for (n, &x) in mesh.nodes.iter().enumerate() {
        node(out, mesh.node_id(n), x)?;
    }
    let mut points = Vec::new();
    let mut free = last_node;
    for (name, &place) in &mesh.points {
        let bits = place.map(f64::to_bits);
        let number = match mesh.nodes.iter().position(|x| x.map(f64::to_bits) == bits) {
            Some(n) => mesh.node_id(n),
            None => {
                free += 1;
                node(out, free, place)?;
                free
            }
        };
        points.push((name, number));
    }
    elements(mesh, out)?;
    let quoted = quoted(mesh.groups.keys())?;
    for (name, list) in &mesh.groups {
        let name = &quoted[name.as_str()];
        let numbers: Vec<u64> = list.iter().map(|&e| mesh.element_id(e as usize)).collect();
        if let ([first, .., last], true) = (numbers.as_slice(), numbers.is_sorted_by(|a, b| a + 1 == *b)) {
            writeln!(out, "*ELSET, ELSET={name}, GENERATE\n{first}, {last}, 1")?;
            continue;
        }
        writeln!(out, "*ELSET, ELSET={name}")?;
        for line in numbers.chunks(16) {
            let line: Vec<String> = line.iter().map(u64::to_string).collect();
            writeln!(out, "{}", line.join(", "))?;
        }
    }
    let quoted = self::quoted(mesh.faces.keys())?;
    for (name, list) in &mesh.faces {
        writeln!(out, "*SURFACE, TYPE=ELEMENT, NAME={}", quoted[name.as_str()])?;
        for face in list {
            let shape = mesh.elements[face.element as usize].shape;
            let number = kinds::face_numbers(shape)[face.side as usize];
            writeln!(out, "{}, S{number}", mesh.element_id(face.element as usize))?;
        }
    }
    let quoted = self::quoted(mesh.points.keys())?;
    for (name, number) in points {
        writeln!(out, "*NSET, NSET={}\n{number}", quoted[name.as_str()])?;
    }
    Ok(Vec::new())
}

/// Elements in their order; a new block begins wherever the shape changes.
fn elements(mesh: &Mesh, out: &mut dyn Write) -> io::Result<()> {
    let mut before = None;
    for (e, element) in mesh.elements.iter().enumerate() {
        if before != Some(element.shape) {
            writeln!(out, "*ELEMENT, TYPE={}", kinds::name(element.shape))?;
            before = Some(element.shape);
        }
        write!(out, "{}", mesh.element_id(e))?;
        for &node in element.nodes() {
            write!(out, ", {}", mesh.node_id(node as usize))?;
        }
        writeln!(out)?;
    }
    Ok(())
}

/// Names as they are written: in quotes where Abaqus would not take them, or take two for the same.
fn quoted<'a>(names: impl Iterator<Item = &'a String> + Clone) -> Result<HashMap<&'a str, String>, Trouble> {
    let mut times: HashMap<String, usize> = HashMap::new();
    for name in names.clone() {
        *times.entry(name.to_uppercase()).or_default() += 1;
    }
    let mut all = HashMap::new();
    for name in names {
        let fits =
            !name.is_empty() && name.len() <= 80 && !name.contains(|c: char| c == '"' || c.is_control());
        if !fits {
            return Err(Trouble::Mesh(format!(
                "Abaqus cannot hold the name {name:?}: names have 1 to 80 bytes and no quotes; rename it"
            )));
        }
        let plain = name.starts_with(|c: char| c.is_ascii_alphabetic())
            && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '-')
            && times[&name.to_uppercase()] == 1;
        all.insert(name.as_str(), if plain { name.clone() } else { format!("\"{name}\"") });
    }
    Ok(all)
}
