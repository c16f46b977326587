use std::fs;
use std::io::Cursor;

use super::*;
use crate::fault::Fault;
use crate::note::Note;
use crate::quality::{by_group, summary};
use crate::sample::Random;
use crate::topology::vector_areas;
use crate::{Face, Mesh, Shape};

mod parts;

use parts::ASSEMBLED;

const SHAPES: &[u8] = include_bytes!("../../tests/data/shapes.inp");

/// Two cubes and a wedge, with what an input file may have.
const FLAT: &str = "\
** a comment
*Heading
 *Node, 1, 2, 3 : this is a title
*NODE, nset=ALL
1, 0, 0, 0.
2, 1.,
3, 1., 1., 0
4, 0, 1e0, 0
 5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
*Material, name=rock
*Elastic
1e10, 0.25
*node
900000009, 0, 0, 2
900000010, 1, 0, 2.0D0
11, 1, 1, 2
12, 0, 1, 2
13, 2, 0, 0
14, 2, 0, 1
99, 7, 7, 7
*ELEMENT, TYPE=C3D8R,
 ELSET=Rock
70, 1, 2, 3, 4,
5, 6, 7, 8
*element, type=c3d8, elset=\"Lining, old\"
80, 900000009, 900000010, 11, 12, 5, 6, 7, 8
*Element, type=C3D6
90, 2, 13, 3, 6, 14, 7
*Element, type=S4R, elset=floor
100, 1, 2, 3, 4
*Element, type=T3D2
200, 1, 2
201, 1, 3
*Elset, elset=both, generate
70, 80, 10
*ELSET, ELSET=all
 both, 90,
 200
*Nset, nset=Crown
11
*Nset, nset=away
99
*Surface, type=element, name=side
rock, s6
80, S2
*Surface, name=skin
all,
*Tie, name=glue
a, b
*Step
*End Step
";

fn with_notes(text: &str) -> Result<(Mesh, Vec<Note>), Fault> {
    parse(&mut Input::new(Cursor::new(text.as_bytes())), Path::new("model.inp"))
}

fn fault(text: &str) -> (Option<usize>, String) {
    let Err(Fault { line, problem, .. }) = with_notes(text) else { panic!("it was read") };
    (line, problem)
}

fn area(mesh: &Mesh, name: &str) -> [f64; 3] {
    let areas = vector_areas(mesh, &mesh.faces[name]);
    areas.values().fold([0.0; 3], |s, a| [s[0] + a[0], s[1] + a[1], s[2] + a[2]])
}

#[test]
fn a_flat_file_gives_groups_faces_and_points() {
    let (mesh, notes) = with_notes(FLAT).unwrap();
    assert_eq!((mesh.nodes.len(), mesh.elements.len()), (14, 3));
    assert_eq!(mesh.element_ids, [70, 80, 90]);
    assert_eq!(mesh.node_ids[8], 900_000_009);
    let groups: Vec<(&str, &[u32])> = mesh.groups.iter().map(|(n, g)| (n.as_str(), g.as_slice())).collect();
    assert_eq!(
        groups,
        [("Lining, old", [1].as_slice()), ("Rock", &[0]), ("all", &[0, 1, 2]), ("both", &[0, 1])]
    );
    assert_eq!(mesh.points["Crown"], [1.0, 1.0, 2.0]);
    assert_eq!(mesh.points["away"], [7.0; 3]);
    assert_eq!(summary(&mesh).volume, 2.5);
    // S6 of the first cube is x = 0; S2 of the second, which is turned over, is what it shares with the first.
    assert_eq!(area(&mesh, "side"), [-1.0, 0.0, -1.0]);
    assert_eq!(mesh.faces["side"], [Face { element: 0, side: 0 }, Face { element: 1, side: 4 }]);
    assert_eq!(mesh.faces["floor"], [Face { element: 0, side: 4 }]);
    // All but the shared faces: 5 + 4 of the cubes, 4 of the wedge.
    assert_eq!(mesh.faces["skin"].len(), 13);
    assert!(area(&mesh, "skin").iter().all(|a| a.abs() < 1e-15));
    let skipped = Note::Skipped { kind: "elements of type T3D2".into(), count: 2 };
    let not_taken = |what: &str| Note::NotTaken { what: what.into(), count: 1 };
    assert_eq!(notes.len(), 5, "{notes:?}");
    for note in
        [skipped, not_taken("*TIE"), not_taken("sets of several nodes"), Note::UnusedNodes { count: 1 }]
    {
        assert!(notes.contains(&note), "{note:?} in {notes:?}");
    }
    assert!(notes.contains(&Note::Turned { count: 1, first: 80 }));
    assert!(with_notes(&FLAT.replace('\n', "\r\n")).unwrap() == (mesh.clone(), notes.clone()));
    // A set that holds itself is no more than without.
    assert!(with_notes(&FLAT.replace(" both, 90,", " both, 90, ALL,")).unwrap() == (mesh, notes));
}

/// Counts by meshio 5.3.5; Gmsh writes 10 digits.
#[test]
fn gmsh_writes_surfaces_as_plane_elements_in_sets() {
    let (mesh, notes) = parse(&mut Input::new(Cursor::new(SHAPES)), Path::new("")).unwrap();
    assert_eq!((mesh.nodes.len(), mesh.elements.len(), notes), (54, 55, vec![]));
    let volumes = by_group(&mesh);
    for (name, elements, volume) in [("bricks", 8, 8.0), ("wedges", 16, 8.0), ("roof", 31, 8.0 / 3.0)] {
        assert_eq!(volumes[name].elements, elements);
        assert!((volumes[name].volume - volume).abs() < 1e-9, "{name}");
    }
    assert_eq!(
        [&mesh.faces["eaves"], &mesh.faces["ground"], &mesh.faces["slope"]].map(Vec::len),
        [8, 12, 16]
    );
    assert!((area(&mesh, "ground")[2] + 8.0).abs() < 1e-9);
}

#[test]
fn second_order_is_reduced_and_collapsed_hexahedra_become_wedges() {
    let mut text = String::from("*NODE\n");
    let corners = [[0, 0, 0], [2, 0, 0], [2, 2, 0], [0, 2, 0], [0, 0, 2], [2, 0, 2], [2, 2, 2], [0, 2, 2]];
    for (n, [x, y, z]) in (1..).zip(corners) {
        text += &format!("{n}, {x}, {y}, {z}\n");
    }
    for n in 9..=20 {
        text += &format!("{n}, 1, 1, 1\n");
    }
    text +=
        "*ELEMENT, TYPE=C3D20R\n1, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15,\n16, 17, 18, 19, 20\n";
    let (mesh, notes) = with_notes(&text).unwrap();
    assert_eq!(summary(&mesh).volume, 8.0);
    assert_eq!(
        notes,
        [Note::Reduced { nodes: 20, shape: Shape::Hex8, count: 1 }, Note::UnusedNodes { count: 12 }]
    );
    let wedge = text.replace("C3D20R", "C3D8").replace(
        "1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15,\n16, 17, 18, 19, 20\n",
        "1, 2, 3, 3, 5, 6, 7, 7\n*SURFACE, NAME=flat\n1, S6\n1, S1\n1, S5\n",
    );
    let (mesh, notes) = with_notes(&wedge).unwrap();
    assert_eq!(notes[0], Note::Collapsed { shape: Shape::Wedge6, count: 1 });
    assert_eq!(summary(&mesh).volume, 4.0);
    // S1 is the triangle below; S6 is x = y; S5 is gone.
    let faces = &mesh.faces["flat"];
    assert_eq!(faces.len(), 2);
    assert_eq!(area(&mesh, "flat"), [-4.0, 4.0, -2.0]);
}

#[test]
fn what_cannot_be_used_is_refused_with_a_way_out() {
    // The line at fault is the one that begins with the third text; none if that is empty.
    for (from, to, at, words) in [
        ("*Elset, elset=both, gen", "*NGEN\n1, 2\n*Elset, elset=both, gen", "*NGEN", "*NGEN cannot be read"),
        ("type=c3d8,", "type=C3D99,", "*element, type=C3D99", "elements of type C3D99 are not supported"),
        ("70, 80, 10", "80, 70, 10", "80, 70, 10", "a range needs a first and a last number"),
        ("4, 0, 1e0, 0", "4, 0, 1e0, z", "4, 0, 1e0, z", "`z` stands where a coordinate should"),
        ("4, 0, 1e0, 0", "4.5, 0, 1e0, 0", "4.5", "`4.5` stands where a node's number should"),
        ("rock, s6", "rock, s7", "rock, s7", "`S7` is no face of a hex8; faces are S1 to S6"),
        ("rock, s6", "stone, s6", "stone", "there is no set `STONE`"),
        (" both, 90,", " both, 91,", " both, 91", "element 91 is not there"),
        ("90, 2, 13, 3", "90, 2, 77, 3", "", "element 90 uses node 77, which is not there"),
        ("90, 2, 13, 3", "80, 2, 13, 3", "", "there are two elements 80"),
        ("11, 1, 1, 2", "12, 1, 1, 2", "", "there are two nodes 12"),
        (
            "90, 2, 13, 3, 6, 14, 7",
            "90, 2, 13, 3, 6, 14",
            "*Element, type=S4R",
            "element 90 before this line has too few",
        ),
        ("*NODE, nset=ALL", "*NODE, SYSTEM=C", "*NODE, SY", "nodes in the system C cannot be read"),
        ("type=c3d8,", "typ=c3d8,", "*element, typ=", "*ELEMENT needs the parameter TYPE"),
    ] {
        assert!(FLAT.contains(from), "{from}");
        let text = FLAT.replacen(from, to, 1);
        let (line, problem) = fault(&text);
        let wanted =
            if at.is_empty() { None } else { text.lines().position(|l| l.starts_with(at)).map(|l| l + 1) };
        assert_eq!(line, wanted, "{problem}");
        assert!(problem.contains(words), "{problem}");
    }
    assert!(fault("*HEADING\n").1.contains("there are no solid elements"));
    let (line, problem) = fault(&ASSEMBLED.replace("part=block", "part=stone"));
    assert!(line == Some(22) && problem.contains("there is no part `STONE`"), "{problem}");
    let alone = ASSEMBLED.split("*Assembly").next().unwrap();
    let two = [alone, &alone.replace("Block", "Other")].concat();
    assert!(fault(&two).1.contains("part `BLOCK` has no instance"));
}

/// Whatever is done to a file, it is read or refused.
#[test]
fn a_damaged_file_never_makes_the_reader_panic() {
    let mut random = Random(7);
    for original in [FLAT, ASSEMBLED] {
        for cut in 0..original.len() {
            let _ = with_notes(&original[..cut]);
        }
        for _ in 0..3000 {
            let bytes = random.damaged(original.as_bytes());
            if let Ok((mesh, _)) = parse(&mut Input::new(Cursor::new(bytes.as_slice())), Path::new("")) {
                let nodes = mesh.nodes.len() as u32;
                assert!(mesh.elements.iter().all(|e| e.nodes.iter().all(|&n| n < nodes)));
            }
        }
    }
}
