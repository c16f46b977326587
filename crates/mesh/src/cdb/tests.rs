use std::io::Cursor;

use super::*;
use crate::Mesh;
use crate::quality::{by_group, summary};
use crate::sample::Random;

/// A brick, and beside it in one layer a wedge, a pyramid and a tetrahedron as bricks with repeated nodes, a shell,
/// a tetrahedron of 10 nodes and a brick of 20.
fn archive() -> String {
    let mut text = String::from(
        "/COM,ANSYS RELEASE 19.2\n/PREP7\n! comment\nET,1,185\net,2,SOLID187\nET,3,181\nET, 7,186 $ KEYOPT,7,2,1\n",
    );
    text += "NBLOCK,6,SOLID,        40,        40\n(3i9,6e21.13e3)\n";
    let mut nodes = vec![];
    for z in 0..2 {
        for y in 0..2 {
            for x in 0..3 {
                nodes.push([f64::from(x), f64::from(y), f64::from(z)]);
            }
        }
    }
    nodes.push([0.5, 0.5, 2.0]);
    for (n, x) in (1..).zip(&nodes) {
        text += &format!("{n:9}{:9}{:9}", 0, 0);
        let last = x.iter().rposition(|&c| c != 0.0).map_or(0, |k| k + 1);
        for c in &x[..last] {
            let e = format!("{c:.13e}");
            let (mantissa, exponent) = e.split_once('e').unwrap();
            text += &format!("{:>21}", format!("{mantissa}E{:+04}", exponent.parse::<i32>().unwrap()));
        }
        text.push('\n');
    }
    text += "N,R5.3,LOC,       -1,\n";
    text += "EBLOCK,19,SOLID,        50,         6\n(19i9)\n";
    let mut element = |material: u64, kind: u64, number: u64, nodes: &[u64]| {
        for k in [material, kind, 1, 1, 0, 0, 0, 0, nodes.len() as u64, 0, number] {
            text += &format!("{k:9}");
        }
        for (k, n) in nodes.iter().enumerate() {
            text += &format!("{}{n:9}", if k == 8 { "\n" } else { "" });
        }
        text.push('\n');
    };
    element(1, 1, 10, &[1, 2, 5, 4, 7, 8, 11, 10]);
    element(2, 1, 20, &[2, 3, 6, 6, 8, 9, 12, 12]);
    element(2, 1, 30, &[7, 8, 11, 10, 13, 13, 13, 13]);
    element(2, 1, 40, &[2, 6, 5, 5, 8, 8, 8, 8]);
    element(3, 3, 50, &[1, 2, 5, 4]);
    element(1, 2, 60, &[5, 6, 11, 8, 1, 2, 3, 4, 7, 9]);
    text += "       -1\n";
    text += "EBLOCK,10,,,1\n(15i9)\n        1        1        1\n       -1\n";
    text += "CMBLOCK,TOP PART,ELEM,       3  ! comment\n(8i10)\n        20       -40        60\n";
    text += "CMBLOCK,crown,NODE,       1\n(8i10)\n        13\n";
    text += "CMBLOCK,BASE,NODE,       4\n(8i10)\n         1         2         4         5\n/GO\nFINISH\n";
    text
}

fn with_notes(text: &[u8]) -> Result<(Mesh, Vec<Note>), Fault> {
    parse(&mut Input::new(Cursor::new(text)), Path::new(""))
}

#[test]
fn blocks_types_and_components_are_read() {
    let text = archive();
    let (mesh, notes) = with_notes(text.as_bytes()).unwrap();
    let shapes: Vec<Shape> = mesh.elements.iter().map(|e| e.shape).collect();
    assert_eq!(shapes, [Shape::Hex8, Shape::Wedge6, Shape::Pyramid5, Shape::Tet4, Shape::Tet4]);
    assert_eq!(mesh.element_ids, [10, 20, 30, 40, 60]);
    assert_eq!(mesh.points["crown"], [0.5, 0.5, 2.0]);
    let groups: Vec<(&str, &[u32])> = mesh.groups.iter().map(|(n, g)| (n.as_str(), g.as_slice())).collect();
    assert_eq!(groups, [("TOP PART", [1, 2, 3, 4].as_slice()), ("material 1", &[0])]);
    let volumes = by_group(&mesh);
    // Half a cube, a third, and two sixths.
    assert!((volumes["TOP PART"].volume - 7.0 / 6.0).abs() < 1e-15, "{volumes:?}");
    assert_eq!(volumes["material 1"].volume, 1.0);
    let skipped = |kind: &str| Note::Skipped { kind: kind.into(), count: 1 };
    for note in [
        Note::Reduced { nodes: 10, shape: Shape::Tet4, count: 1 },
        skipped("elements of ANSYS's type 181"),
        skipped("elements of a block without the key SOLID"),
        Note::NotTaken { what: "node components of several nodes".into(), count: 1 },
        Note::Collapsed { shape: Shape::Wedge6, count: 1 },
    ] {
        assert!(notes.contains(&note), "{note:?} in {notes:?}");
    }
    assert!(with_notes(text.replace('\n', "\r\n").as_bytes()).unwrap() == (mesh, notes));
}

#[test]
fn a_brick_of_twenty_nodes_is_reduced() {
    let long = archive().replace(
        "        1        1        1        1        0        0        0        0        8        0       10",
        "        1        7        1        1        0        0        0        0       20        0       10",
    );
    let long = long.replace("        7        8       11       10\n        2",
        "        7        8       11       10\n        1        1        1        1        1        1        1        1        1        1        1        1\n        2");
    let (mesh, notes) = with_notes(long.as_bytes()).unwrap();
    assert!(notes.contains(&Note::Reduced { nodes: 20, shape: Shape::Hex8, count: 1 }), "{notes:?}");
    assert!(summary(&mesh).volume > 2.0);
}

#[test]
fn what_cannot_be_used_is_refused_with_a_way_out() {
    let mut lines = Vec::new();
    for (from, to, at, words) in [
        ("ET,1,185\n", "", Some(25), "element 10 has type 1, which no ET before it defines"),
        ("(3i9,6e21.13e3)", "(nonsense)", Some(9), "stands where a format such as (3i9,6e21.13e3) should"),
        (
            "        2        0        0 1.0",
            "        x        0        0 1.0",
            Some(11),
            "stands where a node in the columns",
        ),
        (
            "        1        2        5        4        7",
            "        1        2        5       44        7",
            Some(26),
            "element 10 uses node 44",
        ),
        ("       13\nCM", "       1x\nCM", Some(43), "`1x` stands where a member of the component should"),
        (
            "N,R5.3,LOC,       -1,\n",
            "",
            Some(23),
            "stands where a node in the columns of the block's format should",
        ),
        (
            "        8        0       20",
            "       28        0       20",
            Some(27),
            "element 20 has 28 nodes, expected at most 20",
        ),
        (
            "        8        0       20",
            "        9        0       20",
            Some(28),
            "element 20 of type 185 has 9 nodes",
        ),
        (
            "EBLOCK,10,,,1",
            "TYPE,1\nEBLOCK,9,,,1",
            Some(35),
            "of type 185 stand in a block without the key SOLID",
        ),
    ] {
        let text = archive();
        assert!(text.contains(from), "{from}");
        let fault = with_notes(text.replacen(from, to, 1).as_bytes()).unwrap_err();
        assert!(fault.problem.contains(words), "{fault:?}");
        lines.push((fault.line, at));
    }
    assert!(lines.iter().all(|(line, wanted)| line == wanted), "{lines:?}");
    let single = with_notes(b"/PREP7\nET,1,185\nN,1,0,0,0\nEN,1,1\n").unwrap_err();
    assert!(single.problem.contains("single commands, not blocks; write it with CDWRITE"), "{single:?}");
}

/// Whatever is done to a file, it is read or refused.
#[test]
fn a_damaged_file_never_makes_the_reader_panic() {
    let (text, mut random) = (archive(), Random(12));
    for cut in 0..text.len() {
        let _ = with_notes(&text.as_bytes()[..cut]);
    }
    for _ in 0..3000 {
        let _ = with_notes(&random.damaged(text.as_bytes()));
    }
}
