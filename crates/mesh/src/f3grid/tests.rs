use std::io::Cursor;

use super::*;
use crate::Mesh;
use crate::quality::{by_group, summary};
use crate::sample::Random;

/// Written by FLAC3D 6.00; from the test data of meshio (MIT).
const FLAC3D: &[u8] = include_bytes!("../../tests/data/flac3d_mesh_ex.f3grid");
const BINARY: &[u8] = include_bytes!("../../tests/data/shapes_binary.f3grid");

/// A brick, a wedge, a pyramid, a tetrahedron and a brick with a collapsed edge, on and beside one another.
const ZONES: &str = "\
* all types of zones
* GRIDPOINTS
G 1 0 0 0
G 2 1 0 0
G 3 0 1 0
G,4,0,0,1
G 5 1 1 0
G 6 0 1 1
G 7 1 0 1
G 8 1 1 1
G 9 2 0 0
G 10 2 1 0
G 11 0.5 0.5 2
G 12 5 0 0
G 13 6 0 0
G 14 5 1 0
G 15 5 0 1
G 16 6 1 0
G 17 5 1 1
G 18 6 0 1
* ZONES
Z B8 10 1 2 3 4 5 6 7 8
Z W6 20 2 9 5 7 10 8
Z P5 30 4 7 6 11 8
Z T4 40 11 7 8 9
z b7 50 12 13 14 15 16 17 18
* ZONE GROUPS
ZGROUP \"hard rock\" SLOT \"geology\"
 10 20
 30
ZGROUP 'bench 1' SLOT Construction
10
zg soft sl geology
40, 50
ZGROUP \"soft\" SLOT 2
10
* FACES
F Q4 1 1 2 5 3
F T3 2 4 7 11
F Q4 3 2 5 8 7
F T3 4 2 9 7
FGROUP \"base\" SLOT \"Default\"
1
FGROUP \"inner\" SLOT \"Default\"
3 2
IFACE 1 2 3
7 8
";

fn with_notes(bytes: &[u8]) -> Result<(Mesh, Vec<Note>), Fault> {
    parse(&mut Input::new(Cursor::new(bytes)), Path::new(""))
}

/// Counts by meshio 5.3.5; volumes of the convex hulls of each group's gridpoints, which no order of nodes enters.
#[test]
fn a_file_of_flac3d_is_read_with_its_groups() {
    let (mesh, notes) = with_notes(FLAC3D).unwrap();
    let count = |shape| mesh.elements.iter().filter(|e| e.shape == shape).count();
    let counts = [Shape::Hex8, Shape::Pyramid5, Shape::Wedge6, Shape::Tet4].map(count);
    assert_eq!(counts, [75, 15, 15, 3]);
    let groups = by_group(&mesh);
    assert_eq!(groups.len(), 4);
    for (name, volume) in
        [("Brick1", 1.0), ("Pyramid2", 1.0 / 6.0), ("Tetrahedron4", 1.0 / 24.0), ("Wedge3", 0.5)]
    {
        assert_eq!(groups[name].elements, 27, "{name}");
        assert!((groups[name].volume - volume).abs() < 1e-12, "{name}");
    }
    assert!(summary(&mesh).min_scaled_jacobian > 0.0);
    assert_eq!(notes, [], "zones of FLAC3D are not in mirror image");
}

#[test]
fn every_type_of_zone_slots_and_faces_are_read() {
    let (mesh, notes) = with_notes(ZONES.as_bytes()).unwrap();
    assert_eq!(mesh.element_ids, [10, 20, 30, 40, 50, 51]);
    assert_eq!(mesh.elements[0].nodes, [0, 1, 4, 2, 3, 6, 7, 5]);
    let of = |e: usize| crate::quality::of(&mesh, e).volume;
    for (e, exact) in [(0, 1.0), (1, 0.5), (2, 1.0 / 3.0), (4, 1.0 / 3.0), (5, 1.0 / 3.0)] {
        assert!((of(e) - exact).abs() < 1e-15, "{e}");
    }
    let groups: Vec<(&str, &[u32])> = mesh.groups.iter().map(|(n, g)| (n.as_str(), g.as_slice())).collect();
    let wanted: [(&str, &[u32]); 4] =
        [("2=soft", &[0]), ("bench 1", &[0]), ("geology=soft", &[3, 4, 5]), ("hard rock", &[0, 1, 2])];
    assert_eq!(groups, wanted);
    // The face between brick and wedge belongs to both.
    assert_eq!([&mesh.faces["base"], &mesh.faces["inner"]].map(Vec::len), [1, 3]);
    assert!(notes.contains(&Note::Split { count: 1, first: 50 }), "{notes:?}");
    assert!(notes.contains(&Note::NotTaken { what: "records `IFACE`".into(), count: 1 }), "{notes:?}");
    assert!(notes.contains(&Note::Skipped { kind: "faces of no group".into(), count: 1 }), "{notes:?}");
    assert!(with_notes(ZONES.replace('\n', "\r\n").as_bytes()).unwrap() == (mesh, notes));
}

/// Counts and volume as of the Gmsh file it was made from.
#[test]
fn a_binary_grid_is_read() {
    let (mesh, _) = with_notes(BINARY).unwrap();
    assert_eq!((mesh.nodes.len(), mesh.elements.len()), (54, 55));
    assert!((summary(&mesh).volume - (8.0 + 8.0 + 8.0 / 3.0)).abs() < 1e-10);
    for cut in 8..BINARY.len() {
        assert!(with_notes(&BINARY[..cut]).is_err(), "cut at {cut}");
    }
    let fault = |bytes: Vec<u8>| with_notes(&bytes).unwrap_err().problem;
    assert!(fault([BINARY, &[0]].concat()).contains("the grid ends here and the file goes on"));
    assert!(fault([&BINARY[..4], &[4, 0, 0, 0], &BINARY[8..]].concat()).contains("its layout is 4"));
}

#[test]
fn what_cannot_be_used_is_refused_with_its_line() {
    for (from, to, at, words) in [
        ("Z T4 40", "Z T5 40", "Z T5", "a zone of type `T5`, expected B8, W6, P5, T4, B7"),
        ("Z T4 40 11", "Z T4 40 111", "Z T4", "gridpoint 111 is not there"),
        ("Z T4 40 11", "Z T4 40", "Z T4", "the line ends where a gridpoint's number"),
        ("Z T4 40", "Z T4 30", "", "there are two zones 30"),
        ("G 9 2 0 0", "G 8 2 0 0", "", "there are two gridpoints 8"),
        ("G 9 2 0 0", "G 9 2 0 inf", "G 9", "`inf` stands where a coordinate should"),
        ("40, 50", "40, 51", "zg soft", "zone 51 of group `soft` is not there"),
        ("* FACES", "FGROUP \"\"", "FGROUP", "the group has no name"),
        ("Z B8", "9 9\nZ B8", "9 9", "`9 9` stands where a record such as G, Z or F should"),
    ] {
        let text = ZONES.replacen(from, to, 1);
        let fault = with_notes(text.as_bytes()).unwrap_err();
        let wanted =
            if at.is_empty() { None } else { text.lines().position(|l| l.starts_with(at)).map(|l| l + 1) };
        assert_eq!(fault.line, wanted, "{fault:?}");
        assert!(fault.problem.contains(words), "{fault:?}");
    }
    assert!(with_notes(b"G 1 0 0 0\n").unwrap_err().problem.contains("there are no solid elements"));
}

/// Whatever is done to a file, it is read or refused.
#[test]
fn a_damaged_file_never_makes_the_reader_panic() {
    let mut random = Random(44);
    for original in [ZONES.as_bytes(), BINARY] {
        for cut in 0..original.len() {
            let _ = with_notes(&original[..cut]);
        }
        for _ in 0..2000 {
            let _ = with_notes(&random.damaged(original));
        }
    }
}
