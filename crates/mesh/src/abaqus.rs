//! Abaqus input files (`.inp`).
//!
//! Read are nodes, elements, sets, surfaces, parts and their instances, and included files. Keywords and names
//! do not depend on case. Element sets become groups; node sets of one node named points; surfaces of element
//! faces named faces, and so do sets of surface elements (shells, membranes, plane elements) that lie on solids.
//! Sets that Abaqus/CAE marks as internal are used and not kept. A set name that several instances use gets the
//! instance's name in front, as `Part-1-1.rock`. Elements of no set are in a group named after their instance,
//! else in `ungrouped`. Other keywords are passed over, except those that would make nodes or elements, which
//! are refused, and those that join parts, which are noted.

mod assemble;
mod deck;
mod elements;
mod entries;
mod kinds;
mod model;
mod part;
mod sets;
mod write;

use std::path::Path;

use crate::format::{Format, Outcome};
use crate::input::Input;
use deck::Deck;
use model::Model;

pub(crate) use write::write_mesh;

/// Abaqus, for [`crate::read::read`].
pub(crate) const FORMAT: Format = Format { name: "Abaqus input", recognises: is_abaqus, parse };

/// Whether the first line that is no comment is a keyword.
fn is_abaqus(head: &[u8]) -> bool {
    let mut lines = head.split(|&b| b == b'\n').map(<[u8]>::trim_ascii);
    let first = lines.find(|line| !line.is_empty() && !line.starts_with(b"**"));
    first.is_some_and(|line| line[0] == b'*' && line.get(1).is_some_and(u8::is_ascii_alphabetic))
}

fn parse(input: &mut Input, path: &Path) -> Outcome {
    let model = Model::read(&mut Deck::new(input, path))?;
    assemble::assemble(model)?
        .finish("only elements such as C3D8 make a model; write the mesh of the solid parts")
}

#[cfg(test)]
mod tests;
