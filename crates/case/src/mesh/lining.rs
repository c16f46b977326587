//! `[[mesh.lining]]`: linings cast against the walls of empty holes.

use std::ops::Range;

use super::LENGTH;
use super::place::POINT;
use crate::fields::{Fields, Node};
use crate::keys::{Key, Kind, Table};
use crate::{Diagnostic, Spanned};

pub(super) static LINING: Table = Table {
    path: "mesh.lining",
    doc: "A lining cast against the walls of holes that the mesh has, of hexahedra or wedges which share the nodes of the wall. A later \
          entry is cast against an earlier one. What finds no room is refused.",
    keys: &[
        Key::required("name", Kind::Name, "name of its group, which no other has"),
        Key::required("thickness", LENGTH, "thickness at right angles to the wall"),
        Key::default("layers", Kind::Count(100), "1", "Elements through the thickness"),
        Key::optional(
            "box",
            Kind::List(&POINT, 2, 2),
            "",
            "Two opposite corners of a box in which the middles of the wall's faces lie; left out: all holes that do not reach the \
             ground's surface",
        ),
    ],
    choice: &[],
};

/// A lining cast against the walls of holes. Lengths in m.
#[derive(Clone, Debug, PartialEq)]
pub struct HoleLining {
    /// Unique.
    pub name: Spanned<String>,
    pub thickness: Spanned<f64>,
    /// Elements through the thickness.
    pub layers: Spanned<u32>,
    /// Two opposite corners round the walls; nothing: all holes.
    pub place: Option<[Spanned<[f64; 3]>; 2]>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

impl HoleLining {
    pub(super) fn read(f: &Fields) -> Option<Self> {
        let place = match f.get("box").map(Node::list) {
            Some([one, other]) => Some([one.numbers()?, other.numbers()?]),
            _ => None,
        };
        Some(HoleLining {
            name: f.text("name")?,
            thickness: f.number("thickness")?,
            layers: f.count("layers")?,
            place,
            span: f.span.clone(),
        })
    }

    /// What lies between keys of an entry.
    pub(super) fn check(f: &Fields, problems: &mut Vec<Diagnostic>) {
        super::place::check_box(f, problems);
    }
}
