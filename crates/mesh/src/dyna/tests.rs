use std::io::Cursor;

use super::*;
use crate::Mesh;
use crate::quality::by_group;
use crate::sample::Random;

const SHAPES: &[u8] = include_bytes!("../../tests/data/shapes.k");
const LONG: &[u8] = include_bytes!("../../tests/data/shapes_long.k");

/// A unit cube, and beside it in one layer a wedge, a pyramid and two tetrahedra, in both forms of the card.
const CUBE: &str = "\
$ a comment
*KEYWORD
*TITLE
two parts
*NODE
$#   nid               x               y               z      tc      rc
       1             0.0             0.0             0.0       0       0
       2             1.0             0.0             0.0
       3             1.0             1.0             0.0
4, 0, 1
       5             0.0             0.0             1.0
       6             1.0             0.0             1.0
       7             1.0             1.0            1.+0
       8             0.0             1.0             1.0
*NODE %
         9             0.5             0.5             2.0
        10             2.0             0.0             0.0
        11             2.0             1.0             0.0
*ELEMENT_SOLID
      21       1       1       2       3       4       5       6       7       8
      22       2
       2      10      11       3       6       6       7       7
*ELEMENT_SOLID+
                  23                   2                   5                   6                   7                   8                   9                   9                   9                   9
*ELEMENT_SOLID
24,2,10,6,11,9,9,9,9,9
      25       2
      11       6       7       9       1       1       1       1       1       1
*ELEMENT_SHELL
      31       1       1       2       3       4
*PART
Rock $ 1
         1         1         1

         2         1         1
*PART_INERTIA
Cap
         2         1         1
   1.0   2.0
*SET_SOLID_TITLE
first
         5MECH
        22        21
*SET_SOLID_GENERATE
         6
        22        24
*CONSTRAINED_TIED_NODES_FAILURE
*END
*NODE
nonsense
";

fn with_notes(text: &[u8]) -> Result<(Mesh, Vec<Note>), Fault> {
    parse(&mut Input::new(Cursor::new(text)), Path::new("model.k"))
}

fn sizes(mesh: &Mesh) -> Vec<(String, usize, f64)> {
    by_group(mesh).into_iter().map(|(name, s)| (name.to_owned(), s.elements, s.volume)).collect()
}

#[test]
fn both_forms_of_solids_parts_and_sets_are_read() {
    let (mesh, notes) = with_notes(CUBE.as_bytes()).unwrap_or_else(|fault| panic!("{fault:?}"));
    assert_eq!(mesh.element_ids, [21, 22, 23, 24, 25]);
    let shapes: Vec<Shape> = mesh.elements.iter().map(|e| e.shape).collect();
    assert_eq!(shapes, [Shape::Hex8, Shape::Wedge6, Shape::Pyramid5, Shape::Tet4, Shape::Tet4]);
    let groups: Vec<(&str, &[u32])> = mesh.groups.iter().map(|(n, g)| (n.as_str(), g.as_slice())).collect();
    assert_eq!(
        groups,
        [("Cap", [1, 2, 3, 4].as_slice()), ("Rock $ 1", &[0]), ("first", &[0, 1]), ("set 6", &[1, 2, 3])]
    );
    let volumes = by_group(&mesh);
    assert_eq!(volumes["Rock $ 1"].volume, 1.0);
    assert!((volumes["first"].volume - 1.5).abs() < 1e-15);
    for note in [
        Note::Reduced { nodes: 10, shape: Shape::Tet4, count: 1 },
        Note::Collapsed { shape: Shape::Wedge6, count: 1 },
        Note::Skipped { kind: "cards of *ELEMENT_SHELL".into(), count: 1 },
        Note::NotTaken { what: "*CONSTRAINED_TIED_NODES_FAILURE".into(), count: 1 },
    ] {
        assert!(notes.contains(&note), "{note:?} in {notes:?}");
    }
    assert!(with_notes(CUBE.replace('\n', "\r\n").as_bytes()).unwrap() == (mesh, notes));
}

/// PyDYNA 0.12.1 wrote both: nodes beside the element's number in standard columns, and in the next line in long ones.
#[test]
fn files_of_pydyna_have_the_groups_of_the_mesh_that_it_wrote() {
    for file in [SHAPES, LONG] {
        assert!(is_dyna(file));
        let (mesh, _) = with_notes(file).unwrap();
        assert_eq!((mesh.nodes.len(), mesh.elements.len()), (54, 55));
        let wanted =
            [("bricks", 8, 8.0), ("first four", 4, 4.0), ("roof", 31, 8.0 / 3.0), ("wedges", 16, 8.0)];
        for ((name, elements, volume), (title, count, exact)) in sizes(&mesh).into_iter().zip(wanted) {
            assert_eq!((name.as_str(), elements), (title, count));
            assert!((volume - exact).abs() < 1e-9, "{name}: {volume}");
        }
    }
}

#[test]
fn columns_are_ten_wide_where_the_keyword_line_says_so() {
    let text = "*KEYWORD I10 = Y\n*NODE\n         1             1.0             2.0             3.0\n\
                \x20        2             2.0             2.0             3.0\n         3             1.0             3.0             3.0\n\
                \x20        4             1.0             2.0             4.0\n*ELEMENT_SOLID\n\
                \x20        7         1         1         2         3         4\n*END\n";
    let (mesh, _) = with_notes(text.as_bytes()).unwrap();
    assert_eq!((mesh.nodes[0], mesh.element_ids.as_slice()), ([1.0, 2.0, 3.0], [7].as_slice()));
    assert_eq!(mesh.groups.keys().collect::<Vec<_>>(), ["part 1"]);
}

#[test]
fn what_cannot_be_used_is_refused_with_a_way_out() {
    for (from, to, line, words) in [
        (
            "*ELEMENT_SHELL",
            "*ELEMENT_SOLID_H20",
            Some(29),
            "elements of *ELEMENT_SOLID_H20 are not read; write *ELEMENT_SOLID",
        ),
        ("*ELEMENT_SHELL", "*ELEMENT_SOLID_ORTHO", Some(29), "elements of *ELEMENT_SOLID_ORTHO are not read"),
        ("*ELEMENT_SHELL", "*ELEMENT_TSHELL", Some(29), "elements of *ELEMENT_TSHELL are not read"),
        ("*ELEMENT_SHELL", "*ELEMENT_SOMETHING", Some(29), "elements of *ELEMENT_SOMETHING are not read"),
        ("*ELEMENT_SHELL", "*NODE_TRANSFORM", Some(29), "*NODE_TRANSFORM is not read"),
        ("*ELEMENT_SHELL", "*INCLUDE_TRANSFORM", Some(29), "*INCLUDE_TRANSFORM is not read"),
        ("4, 0, 1", "4, 0, z", Some(10), "`z` stands where a coordinate should"),
        ("      22       2\n", "      22       x\n", Some(21), "`x` stands where a whole number should"),
        (
            "       6       6       7       7",
            "       6       6       7",
            Some(22),
            "element 22 has 7 nodes, expected 8",
        ),
        (
            "       2      10      11       3       6       6       7       7\n",
            "",
            Some(22),
            "element 22 before this line has no nodes",
        ),
        ("24,2,10,6,", "24,2,77,6,", None, "element 24 uses node 77"),
        (
            "        22        21",
            "        22        77",
            Some(42),
            "set 5 holds element 77, which is not there",
        ),
        (
            "        22        24",
            "        24        22",
            Some(46),
            "stands where pairs of a first and a last element should",
        ),
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
fn included_files_are_read_and_the_lines_behind_them_name_others() {
    let folder = std::env::temp_dir().join(format!("tremolite-dyna-{}", std::process::id()));
    std::fs::create_dir_all(folder.join("sub")).unwrap();
    let (nodes, elements) = CUBE.split_once("*ELEMENT_SOLID\n").unwrap();
    std::fs::write(folder.join("sub/nodes.k"), format!("{nodes}*END\n")).unwrap();
    std::fs::write(folder.join("elements.k"), format!("*ELEMENT_SOLID\n{elements}")).unwrap();
    std::fs::write(folder.join("main.k"), "*KEYWORD\n*INCLUDE\nsub\\ +\nnodes.k\nelements.k\n*END\n")
        .unwrap();
    let (mesh, _) = crate::read_with_notes(folder.join("main.k")).unwrap();
    assert!(mesh == with_notes(CUBE.as_bytes()).unwrap().0);
    std::fs::write(folder.join("elements.k"), "*ELEMENT_SOLID\n1,1,x\n").unwrap();
    let message = crate::read(folder.join("main.k")).unwrap_err().to_string();
    assert!(message.contains("elements.k, line 2: `x` stands where a whole number should"), "{message}");
    std::fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn keyword_files_are_told_from_those_of_abaqus() {
    for text in [
        CUBE,
        "*KEYWORD\n*NODE\n",
        "*NODE\n       1             0.0\n",
        "$ x\n*PART\n$ y\n",
        "*PART\n*SECTION_SOLID\n",
    ] {
        assert!(is_dyna(text.as_bytes()), "{text}");
    }
    for text in [
        "*NODE\n1, 0, 0\n",
        "*HEADING\nA_B\n*PART, NAME=A_B\n",
        "** A_B\n*NODE\n** *A_B\n",
        "",
        "$ x\n",
        "1\n*KEYWORD\n",
    ] {
        assert!(!is_dyna(text.as_bytes()), "{text}");
    }
}

/// Whatever is done to a file, it is read or refused.
#[test]
fn a_damaged_file_never_makes_the_reader_panic() {
    let mut random = Random(11);
    for cut in 0..CUBE.len() {
        let _ = with_notes(&CUBE.as_bytes()[..cut]);
    }
    for _ in 0..3000 {
        let _ = with_notes(&random.damaged(CUBE.as_bytes()));
    }
}
