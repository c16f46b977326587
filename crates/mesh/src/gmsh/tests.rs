use std::io::Cursor;

use super::*;
use crate::note::Note;
use crate::quality::{by_group, summary};
use crate::sample::Random;
use crate::topology::vector_areas;
use crate::{Face, Mesh, Shape};

mod versions;

use versions::TWICE;

const TUNNEL: &[u8] = include_bytes!("../../tests/data/tunnel.msh");
const SHAPES: &[u8] = include_bytes!("../../tests/data/shapes.msh");
const SHAPES_BINARY: &[u8] = include_bytes!("../../tests/data/shapes_binary.msh");
const SHAPES_V2: &[u8] = include_bytes!("../../tests/data/shapes_v2.msh");
const SHAPES_V2_BINARY: &[u8] = include_bytes!("../../tests/data/shapes_v2_binary.msh");
const SHAPES_ORDER2: &[u8] = include_bytes!("../../tests/data/shapes_order2.msh");

fn with_notes(bytes: &[u8]) -> Result<(Mesh, Vec<Note>), Fault> {
    super::parse(&mut Input::new(Cursor::new(bytes)), Path::new(""))
}

fn parse(bytes: &[u8]) -> Result<Mesh, Fault> {
    with_notes(bytes).map(|(mesh, _)| mesh)
}

/// Two stacked cubes with large numbers, an unused node, and the upper one numbered in mirror image.
const CUBES: &str = "\
$Comments
$Nodes are not here
$EndComments
$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
2 3 \"the bed\"
3 9 \"rock\"
$EndPhysicalNames
$Entities
1 0 1 2
5 0.5 0.5 2 1 8
4 0 0 1 1 1 1 1 -3 0
1 0 0 0 1 1 1 1 9 0
2 0 0 1 1 1 2 0 0
$EndEntities
$Nodes
2 13 1 900000000013
3 1 0 5
900000000001
900000000002
900000000003
900000000004
900000000013
0 0 0
1 0 0
1 1 0
0 1 0
7 7 7
3 2 1 8
5
6
7
8
9
10
11
12
0 0 1 0.5 0.5 0.5
1 0 1 0.5 0.5 0.5
1 1 1 0.5 0.5 0.5
0 1 1 0.5 0.5 0.5
0 0 2 0.5 0.5 0.5
1 0 2 0.5 0.5 0.5
1 1 2 0.5 0.5 0.5
0 1 2 0.5 0.5 0.5
$EndNodes
$Surprise
1 2 3
$EndSurprise
$Elements
4 4 1 40
1 3 8 1
1 5 6 77777
2 4 3 1
20 8 7 6 5
3 1 5 1
30 900000000001 900000000002 900000000003 900000000004 5 6 7 8
3 2 5 1
40 9 10 11 12 5 6 7 8
$EndElements
";

fn cubes_with(from: &str, to: &str) -> String {
    assert!(CUBES.contains(from), "{from}");
    CUBES.replacen(from, to, 1)
}

/// The line and text of the fault in a file.
fn fault(text: &str) -> (Option<usize>, String) {
    let Err(Fault { line, problem, .. }) = parse(text.as_bytes()) else { panic!("it was read") };
    (line, problem)
}

/// The number of the line that begins with `start`.
fn line_of(text: &str, start: &str) -> Option<usize> {
    text.lines().position(|line| line.starts_with(start)).map(|before| before + 1)
}

fn count(mesh: &Mesh, shape: Shape) -> usize {
    mesh.elements.iter().filter(|e| e.shape == shape).count()
}

fn area(mesh: &Mesh, group: &str) -> [f64; 3] {
    vector_areas(mesh, &mesh.faces[group])
        .values()
        .fold([0.0; 3], |s, a| [s[0] + a[0], s[1] + a[1], s[2] + a[2]])
}

/// Counts by meshio 5.3.5.
#[test]
fn a_tunnel_has_the_counts_that_meshio_finds() {
    let mesh = parse(TUNNEL).unwrap();
    assert_eq!((mesh.nodes.len(), count(&mesh, Shape::Hex8)), (288, 160));
    let groups: Vec<(&str, usize)> = mesh.groups.iter().map(|(n, g)| (n.as_str(), g.len())).collect();
    assert_eq!(groups, [("everything", 160), ("lining", 32), ("rock mass", 128)]);
    // The interface lies inside: each of its 32 quadrilaterals is a face of two elements.
    let faces: Vec<(&str, usize)> = mesh.faces.iter().map(|(n, f)| (n.as_str(), f.len())).collect();
    assert_eq!(faces, [("interface", 64), ("intrados", 32), ("surface 77", 16)]);
    assert_eq!(mesh.points.len(), 1);
    assert!((mesh.points["corner"][0] - 16.0).abs() < 1e-12);
    assert_eq!(mesh.node_ids, []);
}

#[test]
fn named_faces_look_outwards_from_their_elements() {
    let mesh = parse(TUNNEL).unwrap();
    // The lining's end face: a ring between two polygons of 16 sides.
    let ring = 8.0 * (std::f64::consts::PI / 8.0).sin() * (4.5_f64.powi(2) - 4.0_f64.powi(2));
    let end = area(&mesh, "surface 77");
    assert!((end[2] + ring).abs() < 1e-12, "{end:?} {ring}");
    for name in ["interface", "intrados"] {
        assert!(area(&mesh, name).iter().all(|a| a.abs() < 1e-12), "{name} is closed around the axis");
    }
}

/// Counts by meshio 5.3.5; the volume is that of two bricks and a pyramid of height 2.
#[test]
fn all_four_shapes_are_read() {
    let mesh = parse(SHAPES).unwrap();
    let counts = [Shape::Hex8, Shape::Wedge6, Shape::Pyramid5, Shape::Tet4].map(|s| count(&mesh, s));
    assert_eq!((mesh.nodes.len(), counts), (54, [8, 16, 4, 27]));
    let all = summary(&mesh);
    assert!((all.volume - (8.0 + 8.0 + 8.0 / 3.0)).abs() < 1e-12, "{all:?}");
    assert!(all.min_scaled_jacobian > 0.1);
    let faces: Vec<(&str, usize)> = mesh.faces.iter().map(|(n, f)| (n.as_str(), f.len())).collect();
    assert_eq!(faces, [("eaves", 8), ("ground", 12), ("slope", 16)]);
    assert!((area(&mesh, "ground")[2] + 8.0).abs() < 1e-12);
    assert!((area(&mesh, "slope")[2] - 4.0).abs() < 1e-12);
}

#[test]
fn numbers_gaps_comments_and_unknown_sections_do_no_harm() {
    let mesh = parse(CUBES.as_bytes()).unwrap();
    assert_eq!(mesh.nodes.len(), 12);
    assert_eq!((mesh.node_id(0), mesh.node_id(4)), (900_000_000_001, 5));
    assert_eq!((mesh.element_id(0), mesh.element_id(1)), (30, 40));
    assert_eq!(mesh.groups["rock"], [0]);
    assert_eq!(mesh.groups["ungrouped"], [1]);
    assert_eq!(mesh.faces["the bed"], [Face { element: 0, side: 5 }, Face { element: 1, side: 4 }]);
    assert_eq!(mesh.points["point 8"], [0.5, 0.5, 2.0]);
    assert!((summary(&mesh).volume - 2.0).abs() < 1e-15);
    let windows = CUBES.replace('\n', "\r\n");
    assert!(parse(windows.as_bytes()).unwrap() == mesh);
    let marked = format!("\u{feff}{CUBES}");
    assert!(parse(marked.as_bytes()).unwrap() == mesh);
}

#[test]
fn an_element_in_mirror_image_is_turned() {
    let mesh = parse(CUBES.as_bytes()).unwrap();
    assert_eq!(mesh.elements[1].nodes, [4, 5, 6, 7, 8, 9, 10, 11]);
    // Swapping two neighbours of one face turns it inside out at some corners only.
    let (line, problem) = fault(&cubes_with("40 9 10 11 12", "40 10 9 11 12"));
    assert_eq!(line, None);
    assert!(problem.starts_with("element 40 is flat or partly inside out"), "{problem}");
    let (_, problem) = fault(&cubes_with("40 9 10 11 12", "40 9 10 9 12"));
    assert!(problem.starts_with("element 40 is flat"), "{problem}");
}

#[test]
fn other_kinds_of_file_are_refused_with_a_way_out() {
    for (from, to, at, words) in [
        ("4.1 0 8", "4 0 8", "4 0", "MSH version 4, expected 4.1 or 2; export it as MSH 4.1 (in Gmsh"),
        ("$Comments", "$NOD", "$NOD", "MSH version 1, expected 4.1 or 2"),
        ("4.1 0 8", "4.1 1 4", "4.1", "its numbers have 4 bytes, expected 8"),
        ("$Surprise", "$ParametricNodes", "$Param", "save with Mesh.SaveParametric = 0"),
        ("$Surprise", "$PartitionedEntities", "$Part", "partitioned; remove the partition"),
        ("3 1 5 1\n", "3 1 92 1\n", "3 1 92", "64-node hexahedra are not supported"),
        ("3 1 5 1\n", "3 1 98 1\n", "3 1 98", "elements of Gmsh's type 98 are not supported"),
        ("2 4 3 1\n", "2 4 36 1\n", "2 4 36", "16-node quadrilaterals are not supported"),
    ] {
        let text = cubes_with(from, to);
        let (line, problem) = fault(&text);
        assert_eq!(line, line_of(&text, at), "{problem}");
        assert!(problem.contains(words), "{problem}");
    }
}

#[test]
fn damage_is_reported_with_its_line() {
    // The line at fault is the one that begins with the third text; none if that is empty.
    for (from, to, at, words) in [
        ("30 900000000001", "30 900000000099", "30 9", "node 900000000099 is not in the section $Nodes"),
        ("7 7 7", "7 nan 7", "7 nan", "`nan` stands where a coordinate should"),
        ("7 7 7", "7 7", "7 7", "the line ends where a coordinate should stand"),
        ("1 1 0\n", "1 1 0 4\n", "1 1 0 4", "`4` stands where the end of the line should"),
        ("2 13 1", "2 99 1", "0 1 2", "the section announces 99 nodes and has 13 up to here"),
        ("2 13 1", "1 5 1", "3 2 1 8", "the section $Nodes should end here with $EndNodes"),
        (
            "4 4 1 40",
            "9999999999999 4 1 40",
            "$EndElements",
            "the section ends here, expected a block of elements",
        ),
        ("3 2 1 8", "3 2 1 99999999999", "0 0 1 0.5", "`0 1 0.5 0.5 0.5` stands where the end"),
        ("$EndElements", "$EndElement", "$EndElement", "the section $Elements should end here"),
        ("$EndElements\n", "", "40 9", "the file ends here, expected $EndElements"),
        ("$EndSurprise", "", "$Surprise", "the section $Surprise is not closed by $EndSurprise"),
        ("$MeshFormat", "$MeshForma", "$MeshForma", "the section $MeshForma is not closed"),
        ("$Nodes\n2", "$Nods\n2", "$Nods", "the section $Nods is not closed"),
        ("\n6\n7\n8\n9", "\n6\n7\n8\n8", "0 1 2", "there are two nodes 8"),
        ("40 9 10", "30 9 10", "", "there are two solid elements 30"),
        ("20 8 7 6 5", "20 8 7 6 9", "", "surface `the bed`, element 20"),
        ("3 1 5 1\n", "3 1 5 18446744073709551616\n", "3 1 5 1", "`18446744073709551616` stands where"),
        ("\n3 9 \"rock\"", "\n3 9 \"\"", "3 9 \"", "the physical name is empty"),
    ] {
        let text = cubes_with(from, to);
        let (line, problem) = fault(&text);
        let wanted = if at.is_empty() { None } else { line_of(&text, at) };
        assert_eq!(line, wanted, "{problem}");
        assert!(problem.contains(words), "{problem}");
    }
    let (line, problem) = fault(&format!("{CUBES}$Nodes\n$EndNodes\n"));
    assert_eq!((line, problem.as_str()), (Some(64), "a second section $Nodes; save the mesh in one piece"));
    let surfaces = cubes_with("3 1 5 1\n30 ", "1 9 5 1\n30 ").replace("3 2 5 1\n40", "1 9 5 1\n40");
    assert!(fault(&surfaces).1.contains("there are no solid elements; mesh the volumes"));
    assert!(fault("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n").1.contains("there is no section $Nodes"));
}

#[test]
fn coincident_nodes_of_separate_parts_are_told() {
    let apart =
        CUBES.replace("2 13 1", "2 14 1").replace("3 2 1 8", "3 2 1 9").replace("\n12\n", "\n12\n13\n");
    let apart = apart.replace("0 1 2 0.5 0.5 0.5\n", "0 1 2 0.5 0.5 0.5\n0 0 1.0000001 0 0 0\n");
    let (_, notes) = with_notes(apart.replace("12 5 6 7 8", "12 13 6 7 8").as_bytes()).unwrap();
    let Some(Note::Coincident { count: 1, first: 13, second: 5, tolerance }) = notes.last() else {
        panic!("{notes:?}")
    };
    assert!((tolerance - 1e-3).abs() < 1e-9);
}

/// Whatever is done to a file, it is read or refused.
#[test]
fn a_damaged_file_never_makes_the_reader_panic() {
    let mut random = Random(2018);
    let tokens =
        ["-1", "0", "1e999", "18446744073709551615", "$EndNodes\n", "nan", "\n", " ", "\u{fffd}", "$"];
    for original in [CUBES.as_bytes(), TWICE.as_bytes(), SHAPES, SHAPES_BINARY, SHAPES_V2_BINARY] {
        for cut in (0..original.len()).step_by(11) {
            let _ = parse(&original[..cut]);
        }
        for _ in 0..1500 {
            let mut bytes = original.to_vec();
            for _ in 0..=random.below(3) {
                let at = random.below(bytes.len());
                match random.below(4) {
                    0 => bytes[at] = random.below(256) as u8,
                    1 => drop(bytes.drain(at..(at + random.below(40)).min(bytes.len()))),
                    2 => drop(bytes.splice(at..at, tokens[random.below(tokens.len())].bytes())),
                    _ => bytes[at] = b'0' + random.below(10) as u8,
                }
            }
            if let Ok(mesh) = parse(&bytes) {
                let nodes = mesh.nodes.len() as u32;
                assert!(mesh.elements.iter().all(|e| e.nodes.iter().all(|&n| n < nodes)));
            }
        }
    }
}
