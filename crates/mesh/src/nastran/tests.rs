use std::io::Cursor;

use super::*;
use crate::Mesh;
use crate::quality::{by_group, summary};
use crate::sample::Random;

const SHAPES: &[u8] = include_bytes!("../../tests/data/shapes.bdf");
const FREE: &[u8] = include_bytes!("../../tests/data/rounded_free.bdf");
const ORDER2: &[u8] = include_bytes!("../../tests/data/rounded_order2.bdf");

/// A unit cube in small field, a wedge on it in large and free field, with what a file may have. The nodes of the wedge's
/// ridge have their coordinates in a system that stands on its head.
const CUBE: &str = "\
SOL 101
CEND
TITLE = GRID and CHEXA, in words
  DISPLACEMENT(PLOT,REAL)=ALL
BEGIN BULK
$ Elements and Element Properties for region : Rock
PSOLID,3,1
$ Elements and Element Properties for region : Cap
PSOLID         4       1
GRID           1              0.      0.      0.
GRID           2             1.0      0.      0.
GRID,3,,1.0,1.,0.
grid           4                     1.0
GRID*                  5                              0.              0.*A
*A                   1.0
GRID*   6                               10.-1           0.0
*                  1.0E0
GRID\t7\t\t1.0\t1.0\t1.0
GRID,8,0,.0,1.0+0,1.D0,,,,+G8
+G8
CORD2R         7       8      0.      0.      0.      0.      0.      1.+C7
+C7           1.      0.      0.
CORD2R,8,,0.,0.,2.,0.,0.,1.
,1.,0.,2.
GRID           9       7     0.5      0.    -1.0
GRID          10       7     0.5    -1.0    -1.0
CHEXA         11       3       1       2       3       4       5       6+H
+H             7       8
CPENTA*               12               4               5               6*P
*P                     9               8               7              10
CQUAD4        13       5       1       2       3       4
RBE2          14       1     123       2       3
ENDDATA
CHEXA         99       3       1
";

fn with_notes(text: &[u8]) -> Result<(Mesh, Vec<Note>), Fault> {
    parse(&mut Input::new(Cursor::new(text)), Path::new("model.bdf"))
}

fn sizes(mesh: &Mesh) -> Vec<(String, usize, f64)> {
    by_group(mesh).into_iter().map(|(name, s)| (name.to_owned(), s.elements, s.volume)).collect()
}

#[test]
fn small_large_and_free_field_are_read_with_systems_and_names() {
    let (mesh, notes) = with_notes(CUBE.as_bytes()).unwrap_or_else(|fault| panic!("{fault:?}"));
    assert_eq!((mesh.nodes.len(), mesh.element_ids.as_slice()), (10, [11, 12].as_slice()));
    // System 8 stands on its head at z = 2; system 7 is the same as system 8.
    assert_eq!(mesh.nodes[8], [0.5, 0.0, 3.0]);
    let sizes = sizes(&mesh);
    assert_eq!(sizes[1], ("Rock".to_owned(), 1, 1.0));
    // A roof of 2 m height over the cube.
    assert_eq!((sizes[0].0.as_str(), sizes[0].1), ("Cap", 1));
    assert!((sizes[0].2 - 1.0).abs() < 1e-15, "{sizes:?}");
    let skipped = Note::Skipped { kind: "cards of CQUAD4".into(), count: 1 };
    let joint = Note::NotTaken { what: "RBE2".into(), count: 1 };
    assert!(notes.contains(&skipped) && notes.contains(&joint), "{notes:?}");
    assert!(with_notes(CUBE.replace('\n', "\r\n").as_bytes()).unwrap() == (mesh, notes));
}

/// Volumes by pyNastran 1.4.1, which also wrote the file: every third node is in a turned system.
#[test]
fn volumes_are_those_that_pynastran_finds() {
    let (mesh, _) = with_notes(SHAPES).unwrap();
    let found =
        [("bricks", 8, 7.99999999999571), ("roof", 31, 2.66666666663329), ("wedges", 16, 7.999999999915364)];
    for ((name, elements, volume), (wanted, count, theirs)) in sizes(&mesh).into_iter().zip(found) {
        assert_eq!((name.as_str(), elements), (wanted, count));
        // Both sum the same numbers, in another order.
        assert!((volume - theirs).abs() < 1e-12, "{name}: {volume}");
    }
    let sums = [98.99999999998774, 53.999999999826315, 70.800002];
    for (i, sum) in sums.iter().enumerate() {
        assert!((mesh.nodes.iter().map(|x| x[i]).sum::<f64>() - sum).abs() < 1e-12);
    }
}

/// Gmsh wrote both; pyNastran finds 20, 15, 13 and 10 nodes in 8, 16, 4 and 27 elements of the second.
#[test]
fn free_field_and_second_order_of_gmsh_are_read() {
    for (file, reduced) in [(FREE, 0), (ORDER2, 4)] {
        let (mesh, notes) = with_notes(file).unwrap();
        assert_eq!((mesh.nodes.len(), mesh.elements.len()), (54, 55));
        let sizes = sizes(&mesh);
        assert_eq!(sizes.iter().map(|s| s.1).collect::<Vec<_>>(), [8, 16, 31], "{sizes:?}");
        assert!((summary(&mesh).volume - 56.0 / 3.0).abs() < 1e-7);
        let counts = [(20, 8), (15, 16), (13, 4), (10, 27)].iter().filter(|(of, found)| {
            notes
                .iter()
                .any(|n| matches!(n, Note::Reduced { nodes, count, .. } if nodes == of && count == found))
        });
        assert_eq!(counts.count(), reduced, "{notes:?}");
    }
}

#[test]
fn properties_are_named_by_the_comments_of_preprocessors() {
    for comment in [
        "$ Femap with NX Nastran Property 3 : Hard rock",
        "$HMNAME PROP                       3\"Hard rock\" 4",
        "$ANSA_NAME_COMMENT;3;PSOLID;Hard rock;;NO;NO;NO;",
    ] {
        let text = CUBE.replace("$ Elements and Element Properties for region : Rock", comment);
        let (mesh, _) = with_notes(text.as_bytes()).unwrap();
        assert_eq!(mesh.groups.keys().collect::<Vec<_>>(), ["Cap", "Hard rock"], "{comment}");
    }
    let (mesh, _) = with_notes(CUBE.replace("region : ", "").as_bytes()).unwrap();
    assert_eq!(mesh.groups.keys().collect::<Vec<_>>(), ["property 3", "property 4"]);
    let (mesh, _) = with_notes(CUBE.replace("region : Cap", "region : Rock").as_bytes()).unwrap();
    assert_eq!(mesh.groups.keys().collect::<Vec<_>>(), ["Rock", "Rock 4"]);
}

#[test]
fn what_cannot_be_used_is_refused_with_a_way_out() {
    for (from, to, line, words) in [
        ("CQUAD4 ", "CIHEX1 ", Some(31), "solids of the card CIHEX1 are not read; write CHEXA"),
        ("CQUAD4 ", "CHEXCZ ", Some(31), "solids of the card CHEXCZ are not read"),
        (
            "1       2       3       4       5       6+H",
            "1       x       3       4       5       6+H",
            Some(27),
            "`x` stands where the node at a corner should (CHEXA)",
        ),
        (
            "+H             7       8\n",
            "+H             7\n",
            Some(27),
            "`` stands where the node at a corner should",
        ),
        (
            "+H             7       8\n",
            "+X             7       8\n",
            Some(27),
            "a continuation has another mark",
        ),
        ("GRID,3,,1.0,1.,0.", "GRID,3,,1.0,1.,0.,,,,,,,5", Some(12), "more than ten fields"),
        (
            "GRID           9       7",
            "GRID           9       6",
            None,
            "node 9: there is no coordinate system 6",
        ),
        (
            "CORD2R         7       8",
            "CORD2R         7       7",
            None,
            "coordinate system 7 refers to itself",
        ),
        (
            "CORD2R,8,,0.,0.,2.,0.,0.,1.\n,1.,0.,2.",
            "CORD2R,8,,0.,0.,2.,0.,0.,1.\n,0.,0.,5.",
            None,
            "the points of coordinate system 8 lie on a line",
        ),
        ("CORD2R,8", "CORD2C,8", None, "refers to system 8, which is not read"),
        // 7 refers to 8, and 8 to a system that is missing.
        ("CORD2R,8,,", "CORD2R,8,4,", None, "refers to system 8, which is not read"),
        (
            "+H             7       8",
            "+H             7      88",
            None,
            "element 11 uses node 88, which is not there",
        ),
        ("GRID          10 ", "GRID           9 ", None, "there are two nodes 9"),
        ("BEGIN BULK", "BEGIN SUPER=1", Some(5), "superelements are not read"),
        ("CQUAD4        13", "=             13", Some(31), "replicated cards are not read"),
        ("SOL 101", "INCLUDE 'absent.bdf'", Some(1), "absent.bdf cannot be opened"),
    ] {
        assert!(CUBE.contains(from), "{from}");
        let Err(fault) = with_notes(CUBE.replacen(from, to, 1).as_bytes()) else {
            panic!("{to}: it was read")
        };
        assert!(fault.problem.contains(words), "{to}: {fault:?}");
        assert_eq!(fault.line, line, "{fault:?}");
    }
}

#[test]
fn included_files_are_read_where_they_are_named() {
    let folder = std::env::temp_dir().join(format!("tremolite-nastran-{}", std::process::id()));
    std::fs::create_dir_all(folder.join("a long folder")).unwrap();
    let (before, after) = CUBE.split_once("GRID           1").unwrap();
    let (nodes, elements) = after.split_once("CHEXA").unwrap();
    std::fs::write(folder.join("a long folder/nodes.bdf"), format!("GRID           1{nodes}")).unwrap();
    let main = format!("{before}include 'a long folder\\\n  nodes.bdf'\nCHEXA{elements}");
    std::fs::write(folder.join("main.bdf"), main).unwrap();
    let (mesh, _) = crate::read_with_notes(folder.join("main.bdf")).unwrap();
    assert!(mesh == with_notes(CUBE.as_bytes()).unwrap().0);
    std::fs::write(folder.join("a long folder/nodes.bdf"), "GRID,1,,x\n").unwrap();
    let message = crate::read(folder.join("main.bdf")).unwrap_err().to_string();
    assert!(message.contains("nodes.bdf, line 1: `x` stands where a coordinate should"), "{message}");
    std::fs::remove_dir_all(&folder).unwrap();
}

/// Whatever is done to a file, it is read or refused.
#[test]
fn a_damaged_file_never_makes_the_reader_panic() {
    let mut random = Random(9);
    for cut in 0..CUBE.len() {
        let _ = with_notes(&CUBE.as_bytes()[..cut]);
    }
    for _ in 0..3000 {
        let _ = with_notes(&random.damaged(CUBE.as_bytes()));
    }
}
