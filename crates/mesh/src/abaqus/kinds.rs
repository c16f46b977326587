//! Abaqus's element types, and the numbering of their faces.

use crate::Shape;

/// What an element of a type is to a mesh of solids.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Kind {
    /// A solid with so many nodes, corners first; of C3D27 and C3D15V some at the end may be left out.
    Solid { shape: Shape, nodes: usize },
    /// A surface element with so many corners, which come first.
    Flat { corners: usize },
    /// Lines, points, springs, cohesive and infinite elements.
    Other,
    /// A solid of a kind that cannot be read.
    Unknown,
}

/// Prefixes of solid types: stress, heat transfer, acoustic, coupled, Eulerian, continuum shells.
const SOLIDS: [&str; 7] = ["C3D", "DC3D", "DCC3D", "AC3D", "Q3D", "EC3D", "SC"];
/// Prefixes of surface types: plane, axisymmetric, shell, membrane, rigid.
const FLATS: [&str; 10] = ["CPS", "CPEG", "CPE", "CAX", "SFM3D", "M3D", "R3D", "STRI", "DS", "S"];

/// The kind of a type such as `C3D8R`, in upper case.
pub(super) fn kind(name: &str) -> Kind {
    let number = |prefix: &&str| -> Option<usize> {
        let rest = name.strip_prefix(prefix)?;
        let digits = rest.find(|c: char| !c.is_ascii_digit()).unwrap_or(rest.len());
        rest[..digits].parse().ok()
    };
    if let Some(nodes) = SOLIDS.iter().find_map(number) {
        let shape = match nodes {
            4 | 10 => Shape::Tet4,
            5 | 13 => Shape::Pyramid5,
            6 | 15 => Shape::Wedge6,
            8 | 20 | 27 => Shape::Hex8,
            _ => return Kind::Unknown,
        };
        return Kind::Solid { shape, nodes };
    }
    match FLATS.iter().find_map(number) {
        Some(3 | 6 | 65) => Kind::Flat { corners: 3 },
        Some(4 | 8 | 9) => Kind::Flat { corners: 4 },
        _ => Kind::Other,
    }
}

/// How many nodes an element of so many must have at least.
pub(super) fn fewest(nodes: usize) -> usize {
    if nodes == 27 { 21 } else { nodes }
}

/// The type in which a shape is written.
pub(super) const fn name(shape: Shape) -> &'static str {
    match shape {
        Shape::Hex8 => "C3D8",
        Shape::Wedge6 => "C3D6",
        Shape::Pyramid5 => "C3D5",
        Shape::Tet4 => "C3D4",
    }
}

/// For each side by the numbering of [`Shape::faces`], the number `n` of Abaqus's face `Sn`.
pub(super) const fn face_numbers(shape: Shape) -> &'static [u8] {
    match shape {
        Shape::Hex8 => &[6, 4, 3, 5, 1, 2],
        Shape::Wedge6 | Shape::Pyramid5 => &[1, 2, 3, 4, 5],
        Shape::Tet4 => &[1, 2, 3, 4],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_are_told_apart() {
        let hex = |nodes| Kind::Solid { shape: Shape::Hex8, nodes };
        for (name, wanted) in [
            ("C3D8", hex(8)),
            ("C3D8RH", hex(8)),
            ("C3D20R", hex(20)),
            ("DC3D8", hex(8)),
            ("SC8R", hex(8)),
            ("C3D10M", Kind::Solid { shape: Shape::Tet4, nodes: 10 }),
            ("C3D99", Kind::Unknown),
            ("S4R", Kind::Flat { corners: 4 }),
            ("STRI65", Kind::Flat { corners: 3 }),
            ("CPS6", Kind::Flat { corners: 3 }),
            ("SFM3D4R", Kind::Flat { corners: 4 }),
            ("COH3D8", Kind::Other),
            ("CIN3D8", Kind::Other),
            ("SPRINGA", Kind::Other),
            ("T3D2", Kind::Other),
            ("B31", Kind::Other),
        ] {
            assert_eq!(kind(name), wanted, "{name}");
        }
    }

    /// Faces by their corners, from the element library of the Abaqus manual.
    #[test]
    fn faces_have_the_corners_that_the_manual_gives() {
        let manual: [(Shape, &[&[usize]]); 4] = [
            (
                Shape::Hex8,
                &[&[1, 2, 3, 4], &[5, 8, 7, 6], &[1, 5, 6, 2], &[2, 6, 7, 3], &[3, 7, 8, 4], &[4, 8, 5, 1]],
            ),
            (Shape::Wedge6, &[&[1, 2, 3], &[4, 6, 5], &[1, 4, 5, 2], &[2, 5, 6, 3], &[3, 6, 4, 1]]),
            (Shape::Pyramid5, &[&[1, 2, 3, 4], &[1, 5, 2], &[2, 5, 3], &[3, 5, 4], &[4, 5, 1]]),
            (Shape::Tet4, &[&[1, 2, 3], &[1, 4, 2], &[2, 4, 3], &[3, 4, 1]]),
        ];
        for (shape, faces) in manual {
            for (side, nodes) in shape.faces().iter().enumerate() {
                let number = face_numbers(shape)[side] as usize;
                let mut ours: Vec<usize> = nodes.iter().map(|n| n + 1).collect();
                let mut theirs = faces[number - 1].to_vec();
                ours.sort_unstable();
                theirs.sort_unstable();
                assert_eq!(ours, theirs, "{shape:?} S{number}");
            }
        }
    }
}
