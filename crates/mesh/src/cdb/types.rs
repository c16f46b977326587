//! ANSYS's element types.

/// What the elements of a type are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Family {
    /// Solids of 8 or 20 nodes; with repeated nodes wedges, pyramids and tetrahedra.
    Brick,
    /// Tetrahedra of 4 or 10 nodes.
    Tetrahedron,
    /// Shells, beams, contact and all else.
    Other,
}

/// Structural, thermal and coupled solids of 8 nodes, then those of 20, by the number in their names.
const BRICKS: [u32; 27] = [
    5, 45, 46, 62, 64, 65, 69, 70, 96, 97, 164, 185, 190, 215, 278, 90, 95, 117, 122, 147, 186, 191, 226,
    231, 236, 239, 279,
];
/// Solids of 4 and 10 nodes.
const TETRAHEDRA: [u32; 15] = [87, 92, 98, 119, 123, 127, 148, 168, 187, 227, 232, 237, 240, 285, 291];

/// The family of a type given as `185` or `SOLID185`.
pub(super) fn family(name: &str) -> Family {
    let digits = name.trim_start_matches(|c: char| c.is_ascii_alphabetic());
    match digits.parse() {
        Ok(number) if BRICKS.contains(&number) => Family::Brick,
        Ok(number) if TETRAHEDRA.contains(&number) => Family::Tetrahedron,
        _ => Family::Other,
    }
}

/// The number of nodes of a solid of a type.
pub(super) fn nodes(name: &str) -> usize {
    const LINEAR: usize = 15;
    let number = name.trim_start_matches(|c: char| c.is_ascii_alphabetic()).parse().unwrap_or(0);
    match family(name) {
        Family::Brick if BRICKS[..LINEAR].contains(&number) => 8,
        Family::Brick => 20,
        Family::Tetrahedron if number == 285 => 4,
        Family::Tetrahedron => 10,
        Family::Other => 0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_are_known_by_number_and_by_name() {
        assert_eq!(
            (family("185"), family("SOLID186"), family("solid45")),
            (Family::Brick, Family::Brick, Family::Brick)
        );
        assert_eq!((family("187"), family("SOLID285")), (Family::Tetrahedron, Family::Tetrahedron));
        assert_eq!(
            ["185", "SOLID278", "90", "SOLID186", "187", "SOLID285"].map(nodes),
            [8, 8, 20, 20, 10, 4]
        );
        assert_eq!(
            (family("SHELL181"), family("174"), family("")),
            (Family::Other, Family::Other, Family::Other)
        );
    }
}
