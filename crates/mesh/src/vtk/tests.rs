use std::io::Cursor;

use super::*;
use crate::note::Note;
use crate::sample::Random;
use crate::{Mesh, Shape};

const V42: &[u8] = include_bytes!("../../tests/data/shapes_v42.vtk");
const V51: &[u8] = include_bytes!("../../tests/data/shapes_v51.vtk");

/// Two cubes as voxels with a line between them, and what other programs add.
const VOXELS: &str = "\
# vtk DataFile Version 3.0

ASCII
DATASET UNSTRUCTURED_GRID
FIELD FieldData 2
TIME 1 1 double
0.5
point:crown 3 1 double
1 2 3
POINTS 12 float
0 0 0 1 0 0 0 1 0 1 1 0
0 0 1 1 0 1 0 1 1 1 1 1
0 0 2 1 0 2 0 1 2 1 1 2
METADATA
COMPONENT_NAMES
POINTS
INFORMATION 1
NAME UNITS_LABEL LOCATION vtkDataArray
DATA 1 m

CELLS 3 21
8 0 1 2 3 4 5 6 7
2 0 1
8 4 5 6 7 8 9 10 11
CELL_TYPES 3
11 3 11
CELL_DATA 3
SCALARS MaterialIds int 1
LOOKUP_TABLE default
7 1 9
FIELD FieldData 4
labels 1 3 string
a%20b

7
bits 1 3 bit
1 0 1
group:my%20rock 1 3 unsigned_char
1 0 0
pressure 1 3 double
1.5 nan 2
COLOR_SCALARS shade 2
0.5 0.25 1 1 0 0
LOOKUP_TABLE mine 1
1 0 0 1
POINT_DATA 12
TEXTURE_COORDINATES uv 2 float
0 0 0 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 0 0 0 0 0 0
VECTORS displacement float
0 0 0 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 0 0 0 0 0 0
0 0 0 0 0 0 0 0 0 0 0 0
";

fn with_notes(bytes: &[u8]) -> Result<(Mesh, Vec<Note>), Fault> {
    parse(&mut Input::new(Cursor::new(bytes)), Path::new(""))
}

/// Counts by meshio 5.3.5.
#[test]
fn both_layouts_of_cells_hold_the_same_mesh() {
    let (mesh, notes) = with_notes(V42).unwrap();
    // Meshio writes wedges as VTK before 9.7 took them: opposite triangle first.
    let turned = Note::Turned { count: 16, first: 9 };
    assert_eq!((mesh.nodes.len(), mesh.elements.len(), notes), (54, 55, vec![turned]));
    let (binary, _) = with_notes(V51).unwrap();
    assert!(mesh == binary);
    let all = crate::quality::summary(&mesh);
    assert!((all.volume - (8.0 + 8.0 + 8.0 / 3.0)).abs() < 1e-10, "{all:?}");
}

/// Bytes stand right after the line that announces them, and may look like a line's end.
#[test]
fn binary_cells_of_the_older_layout_are_read() {
    let mut file =
        b"# vtk DataFile Version 4.2\ntet\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n".to_vec();
    let places = [[0.0; 3], [10.0, 0.0, 0.0], [0.0, 10.0, 0.0], [0.0, 0.0, 10.0]];
    file.extend(places.concat().into_iter().flat_map(f64::to_be_bytes));
    file.extend(b"\nMETADATA\nINFORMATION 0\n\nCELLS 1 5\n");
    file.extend([4, 0, 1, 2, 3].into_iter().flat_map(i32::to_be_bytes));
    file.extend(b"\nCELL_TYPES 1\n");
    file.extend(10_i32.to_be_bytes());
    file.extend(b"\n");
    let (mesh, notes) = with_notes(&file).unwrap();
    assert_eq!((mesh.nodes[3], mesh.elements.len(), notes), ([0.0, 0.0, 10.0], 1, vec![]));
}

#[test]
fn voxels_labels_and_metadata_are_understood() {
    let (mesh, notes) = with_notes(VOXELS.as_bytes()).unwrap();
    assert_eq!(notes, [Note::Skipped { kind: "lines".into(), count: 1 }]);
    assert!(mesh.elements.iter().all(|e| e.shape == Shape::Hex8));
    let groups: Vec<(&str, &[u32])> = mesh.groups.iter().map(|(n, g)| (n.as_str(), g.as_slice())).collect();
    assert_eq!(groups, [("MaterialIds 7", [0].as_slice()), ("MaterialIds 9", &[1]), ("my rock", &[0])]);
    assert_eq!(mesh.element_ids, [1, 3]);
    assert_eq!(mesh.points["crown"], [1.0, 2.0, 3.0]);
    assert_eq!(crate::quality::summary(&mesh).volume, 2.0);
    let windows = VOXELS.replace('\n', "\r\n");
    assert!(with_notes(windows.as_bytes()).unwrap().0 == mesh);
}

/// A cell that two pieces of a distributed grid have is one element.
#[test]
fn ghost_cells_are_not_read_twice() {
    let ghosts = VOXELS.replacen("bits 1 3 bit\n1 0 1", "vtkGhostType 1 3 unsigned_char\n0 0 1", 1);
    let (mesh, notes) = with_notes(ghosts.as_bytes()).unwrap();
    assert_eq!(mesh.element_ids, []);
    assert_eq!((mesh.elements.len(), mesh.nodes.len()), (1, 8));
    let ghost = |n: &Note| matches!(n, Note::NotTaken { what, count: 1 } if what.starts_with("ghost cells"));
    assert!(notes.iter().any(ghost), "{notes:?}");
}

#[test]
fn files_of_another_kind_are_refused_with_a_way_out() {
    for (from, to, line, words) in [
        ("UNSTRUCTURED_GRID", "STRUCTURED_POINTS", Some(4), "the data set is STRUCTURED_POINTS, expected"),
        ("CELLS 3 21", "CELLS 4 21", Some(24), "the list of cells is shorter than its cells"),
        ("CELLS 3 21", "POLYS 3 21", Some(21), "`POLYS` is no section that can be read; open it in ParaView"),
        ("MaterialIds int", "MaterialIds bat", Some(28), "arrays of type `bat` cannot be read"),
        ("LOOKUP_TABLE", "7 1 9", Some(29), "expected LOOKUP_TABLE here"),
        ("8 4 5 6 7", "8 4 5 6 x", Some(24), "in the cells: `x` is no such number"),
        ("11 3 11", "11 3 42", None, "cell 2 has VTK's type 42, which is not supported"),
        ("11 3 11", "11 3 13", None, "cell 2 of VTK's type 13 has 8 points, expected 6"),
        ("8 4 5 6 7", "8 4 5 6 99", None, "a cell uses point 99, there are 12"),
        ("11 3 11", "3 3 3", None, "there are no solid elements; save the volume cells"),
        ("ASCII", "TEXT", Some(4), "stands where ASCII or BINARY should"),
        ("0 0 1 1 0 1", "0 nan 1 1 0 1", None, "is no finite number"),
    ] {
        let fault = with_notes(VOXELS.replacen(from, to, 1).as_bytes()).unwrap_err();
        assert_eq!(fault.line, line, "{fault:?}");
        assert!(fault.problem.contains(words), "{fault:?}");
    }
}

/// Whatever is done to a file, it is read or refused.
#[test]
fn a_damaged_file_never_makes_the_reader_panic() {
    let mut random = Random(91);
    for original in [VOXELS.as_bytes(), V42, V51] {
        for cut in (0..original.len()).step_by(7) {
            let _ = with_notes(&original[..cut]);
        }
        for _ in 0..1500 {
            let _ = with_notes(&random.damaged(original));
        }
    }
}
