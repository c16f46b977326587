//! Versions, encodings, byte orders, second order.

use super::*;

fn close(a: &Mesh, b: &Mesh) -> bool {
    a.nodes.len() == b.nodes.len()
        && a.nodes.iter().flatten().zip(b.nodes.iter().flatten()).all(|(x, y)| (x - y).abs() < 1e-12)
}

#[test]
fn versions_and_encodings_hold_the_same_mesh() {
    let (mesh, notes) = with_notes(SHAPES).unwrap();
    assert_eq!(notes, []);
    assert_eq!(with_notes(SHAPES_BINARY).unwrap().1, []);
    let same = |mut other: Mesh, mesh: &Mesh| {
        assert!(close(&other, mesh));
        other.nodes.clone_from(&mesh.nodes);
        assert!(other == *mesh);
    };
    same(parse(SHAPES_BINARY).unwrap(), &mesh);
    let version2 = parse(SHAPES_V2).unwrap();
    same(parse(SHAPES_V2_BINARY).unwrap(), &version2);
    // Version 2 has the elements in another order.
    assert!(close(&version2, &mesh));
    let (groups, others) = (by_group(&mesh), by_group(&version2));
    assert_eq!(groups.len(), 3);
    for (name, group) in groups {
        assert_eq!(
            (group.elements, group.min_scaled_jacobian),
            (others[name].elements, others[name].min_scaled_jacobian)
        );
        assert!((group.volume - others[name].volume).abs() < 1e-12, "{name}");
    }
    for name in ["ground", "slope", "eaves"] {
        let difference = (area(&mesh, name)[2] - area(&version2, name)[2]).abs();
        assert!(mesh.faces[name].len() == version2.faces[name].len() && difference < 1e-12, "{name}");
    }
}

#[test]
fn bytes_in_the_other_order_are_read_too() {
    // The file of one tetrahedron, most significant byte first.
    let mut file = b"$MeshFormat\n4.1 1 8\n\x00\x00\x00\x01\n$EndMeshFormat\n$Nodes\n".to_vec();
    let (i, q, d) = (i32::to_be_bytes, u64::to_be_bytes, f64::to_be_bytes);
    file.extend([q(1), q(4), q(1), q(4)].concat());
    file.extend([i(3), i(1), i(0)].concat());
    file.extend([q(4), q(1), q(2), q(3), q(4)].concat());
    file.extend(
        [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].concat().into_iter().flat_map(d),
    );
    file.extend(b"\n$EndNodes\n$Elements\n");
    file.extend([q(1), q(1), q(9), q(9)].concat());
    file.extend([i(3), i(1), i(4)].concat());
    file.extend([q(1), q(9), q(1), q(2), q(3), q(4)].concat());
    file.extend(b"\n$EndElements\n");
    let mesh = parse(&file).unwrap();
    assert_eq!((mesh.nodes[3], mesh.element_id(0)), ([0.0, 0.0, 1.0], 9));
    for cut in 0..file.len() - 2 {
        assert!(parse(&file[..cut]).is_err(), "cut at {cut}");
    }
    let problem = parse(&file[..file.len() - 40]).unwrap_err().problem;
    assert!(problem.contains("near byte") && problem.contains("expected a node's number"), "{problem}");
}

#[test]
fn elements_of_second_order_are_reduced_with_a_note() {
    let (mesh, notes) = with_notes(SHAPES_ORDER2).unwrap();
    let plain = parse(SHAPES).unwrap();
    assert!(close(&mesh, &plain));
    assert_eq!((&mesh.elements, &mesh.faces), (&plain.elements, &plain.faces));
    let reduced = |nodes, shape, count| Note::Reduced { nodes, shape, count };
    assert_eq!(notes[0], reduced(10, Shape::Tet4, 27));
    assert_eq!(notes[1], reduced(14, Shape::Pyramid5, 4));
    assert_eq!(notes[2], reduced(18, Shape::Wedge6, 16));
    assert_eq!(notes[3], reduced(27, Shape::Hex8, 8));
    assert!(matches!(notes[4], Note::UnusedNodes { .. }));
    assert!(notes[0].to_string().contains("too stiff"), "{}", notes[0]);
}

/// In version 2 an element of two physical groups is there twice, with two numbers.
pub(super) const TWICE: &str = "\
$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
0 5 \"apex\"
3 1 \"all\"
3 2 \"half\"
$EndPhysicalNames
$Nodes
5
1 0 0 0
2 1 0 0
3 0 1 0
4 0 0 1
9 0 0 -1
$EndNodes
$Elements
6
1 15 2 5 4 4
2 1 2 0 1 1 2
3 4 2 1 1 1 2 3 4
4 4 2 2 1 1 2 3 4
5 4 2 1 1 1 3 2 9
6 2 3 7 1 0 1 2 3
$EndElements
";

#[test]
fn an_element_of_two_physical_groups_in_version_2_is_one_element() {
    let (mesh, notes) = with_notes(TWICE.as_bytes()).unwrap();
    assert_eq!((mesh.elements.len(), mesh.element_id(1)), (2, 5));
    assert_eq!((&mesh.groups["all"], &mesh.groups["half"]), (&vec![0, 1], &vec![0]));
    assert_eq!(mesh.points["apex"], [0.0, 0.0, 1.0]);
    assert_eq!(mesh.faces["surface 7"].len(), 2);
    assert_eq!(notes, [Note::Skipped { kind: "2-node lines".into(), count: 1 }]);
    let partitioned = TWICE.replace("3 4 2 1 1", "3 4 4 1 1 1 2");
    let fault = parse(partitioned.as_bytes()).unwrap_err();
    assert!(fault.line == Some(22) && fault.problem.contains("the mesh is partitioned"), "{fault:?}");
}
