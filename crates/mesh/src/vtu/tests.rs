use std::fs;
use std::io::Cursor;
use std::path::Path;

use super::*;
use crate::sample::{Random, distorted_box, one_of_each};

/// Runs a check with a folder of its own.
fn in_folder(name: &str, check: impl FnOnce(&Path)) {
    let folder = std::env::temp_dir().join(format!("tremolite-vtu-{name}-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    check(&folder);
    fs::remove_dir_all(&folder).unwrap();
}

/// A grid with every type of number and awkward values and names.
fn grid() -> Grid {
    let (mut grid, _) = Grid::from_mesh(&one_of_each(), None);
    let displacement = (0..grid.points.len() * 3).map(|i| (i as f32).sin()).collect();
    grid.point_data.push(Array::new("displacement", "m", 3, Values::Float32(displacement)));
    let stress = (0..4 * 6).map(|i| f64::from(i) * 1e6).collect();
    grid.cell_data.push(Array::new("stress", "Pa", 6, Values::Float64(stress)));
    grid.cell_data.push(Array::new("plastic_state", "", 1, Values::Int32(vec![0, i32::MIN, 3, i32::MAX])));
    grid.cell_data.push(Array::new("\"a\" < b & 岩", "1/s²", 1, Values::UInt8(vec![0, 1, 2, 255])));
    grid.time = Some(19.5);
    grid
}

#[test]
fn a_file_holds_exactly_what_was_written() {
    in_folder("exact", |folder| {
        let mut large = Grid::from_mesh(&distorted_box(24), None).0;
        let values = large.points.iter().flatten().map(|x| x.exp()).collect();
        large.point_data.push(Array::new("velocity", "m/s", 3, Values::Float64(values)));
        // The points of `large` fill more than one block, and `grid` has no whole one.
        for grid in [grid(), large, Grid::default()] {
            let path = folder.join("a.vtu");
            grid.write(&path).unwrap();
            assert_eq!(Grid::read(&path).unwrap(), grid);
            assert_eq!(fs::read_dir(folder).unwrap().count(), 1, "no other file is left");
        }
    });
}

#[test]
fn numbers_that_are_not_finite_survive() {
    in_folder("nan", |folder| {
        let mut grid = grid();
        let odd = vec![f64::NAN, f64::INFINITY, f64::MIN_POSITIVE / 8.0, -0.0];
        grid.cell_data.push(Array::new("odd", "", 1, Values::Float64(odd.clone())));
        let path = folder.join("a.vtu");
        grid.write(&path).unwrap();
        let read = Grid::read(&path).unwrap();
        let Values::Float64(back) = &read.cell_array("odd").unwrap().values else { panic!("another type") };
        assert!(back.iter().zip(&odd).all(|(a, b)| a.to_bits() == b.to_bits()));
    });
}

#[test]
fn a_subset_keeps_its_own_points_only() {
    let mesh = one_of_each();
    let (grid, nodes) = Grid::from_mesh(&mesh, Some(&[3, 1]));
    assert_eq!(nodes, [1, 2, 5, 6, 8, 9, 11, 12, 13, 14]);
    assert_eq!(grid.types, [10, 13]);
    for (cell, element) in [(0, 3), (1, 1)] {
        let of_grid: Vec<u32> = grid.cell(cell).iter().map(|&p| nodes[p as usize]).collect();
        assert_eq!(of_grid, mesh.elements[element].nodes());
    }
    assert_eq!(grid.points[4], mesh.nodes[8]);
}

#[test]
fn a_grid_that_contradicts_itself_is_not_written() {
    in_folder("check", |folder| {
        let faults: [fn(&mut Grid); 6] = [
            |g| g.types.truncate(1),
            |g| g.offsets[0] = 99,
            |g| g.connectivity[3] = 99,
            |g| g.connectivity.push(0),
            |g| g.cell_data[0].components = 5,
            |g| g.point_data[0].values = Values::UInt8(vec![]),
        ];
        for fault in faults {
            let mut grid = grid();
            fault(&mut grid);
            let path = folder.join("a.vtu");
            assert!(matches!(grid.write(&path), Err(VtuError::Grid { .. })));
            assert!(!path.exists());
        }
        let absent = folder.join("absent/a.vtu");
        assert!(matches!(grid().write(&absent), Err(VtuError::Io { .. })));
    });
}

/// Whatever is done to a file, it is read or refused.
#[test]
fn a_damaged_file_never_makes_the_reader_panic() {
    in_folder("damage", |folder| {
        let path = folder.join("a.vtu");
        grid().write(&path).unwrap();
        let original = fs::read(&path).unwrap();
        for cut in 0..original.len() - 40 {
            assert!(read::parse(&mut Cursor::new(&original[..cut]), |_| true).is_err(), "cut at {cut}");
        }
        let mut random = Random(5);
        for _ in 0..5000 {
            let mut bytes = original.clone();
            for _ in 0..=random.below(3) {
                let at = random.below(bytes.len());
                bytes[at] = random.below(256) as u8;
            }
            if let Ok(grid) = read::parse(&mut Cursor::new(&bytes), |_| true) {
                assert_eq!(grid.check(), Ok(()));
            }
        }
    });
}

/// Results of a run beside the mesh cost nothing, and may be of types that cannot be read.
#[test]
fn arrays_that_say_nothing_about_the_mesh_are_passed_over() {
    in_folder("others", |folder| {
        let path = folder.join("a.vtu");
        let mut grid = grid();
        grid.cell_data.push(Array::new("MaterialIds", "", 1, Values::Int32(vec![1, 2, 2, 1])));
        grid.write(&path).unwrap();
        let text = fs::read(&path).unwrap();
        let at = text.windows(7).position(|w| w == b"Float32").unwrap();
        let odd = [&text[..at], b"Bit", &text[at + 7..]].concat();
        assert!(read::parse(&mut Cursor::new(&odd), |_| true).unwrap_err().contains("its type is Bit"));
        let mesh = read::parse(&mut Cursor::new(&odd), means_something).unwrap();
        assert_eq!((mesh.point_data.len(), mesh.cell_data.len()), (0, 1));
        assert_eq!(mesh.connectivity, grid.connectivity);
    });
}

#[test]
fn files_of_another_layout_are_refused_in_words() {
    in_folder("other", |folder| {
        let path = folder.join("a.vtu");
        grid().write(&path).unwrap();
        let original = fs::read(&path).unwrap();
        for (from, to, words) in [
            ("LittleEndian", "MiddleEnd", "byte_order is MiddleEnd, expected LittleEndian or BigEndian"),
            ("UInt64", "UInt16", "header_type is UInt16, expected UInt32 or UInt64"),
            ("vtkZLibDataCompressor", "vtkLZ4DataCompressor", "compressor is vtkLZ4DataCompressor"),
            ("\"UInt8\"", "\"String\"", "its type is String"),
            ("\"UnstructuredGrid\"", "\"PolyData\"", "type is PolyData"),
        ] {
            let at = original.windows(from.len()).position(|w| w == from.as_bytes()).unwrap();
            let bytes = [&original[..at], to.as_bytes(), &original[at + from.len()..]].concat();
            let problem = read::parse(&mut Cursor::new(&bytes), |_| true).unwrap_err();
            assert!(problem.contains(words), "{problem}");
        }
        fs::write(&path, "").unwrap();
        let message = Grid::read(&path).unwrap_err().to_string();
        assert!(message.contains("a.vtu: not a readable VTU file"), "{message}");
    });
}

/// Two halves of a grid, whose common points are one again.
#[test]
fn pieces_are_read_as_the_grid_that_was_cut() {
    in_folder("pieces", |folder| {
        let mesh = distorted_box(3);
        let all: Vec<u32> = (0..mesh.elements.len() as u32).collect();
        let of = |elements: &[u32], piece: bool| {
            let (mut grid, nodes) = Grid::from_mesh(&mesh, Some(elements));
            if piece {
                let numbers = nodes.iter().map(|&n| i64::from(n)).collect();
                grid.point_data.push(Array::new(NODE, "", 1, Values::Int64(numbers)));
            }
            let height = nodes.iter().map(|&n| mesh.nodes[n as usize][2] as f32).collect();
            grid.point_data.push(Array::new("height", "m", 1, Values::Float32(height)));
            let ids = elements.iter().map(|&e| i64::from(e)).collect();
            grid.cell_data.push(Array::new("element", "", 1, Values::Int64(ids)));
            grid.time = Some(2.5);
            grid
        };
        let names = ["a-0.vtu", "a-1.vtu"].map(String::from);
        for (name, lot) in names.iter().zip(all.chunks(all.len().div_ceil(2))) {
            of(lot, true).write(&folder.join(name)).unwrap();
        }
        let list = folder.join("a.pvtu");
        write_list(&list, &of(&all[..1], true), &names).unwrap();
        assert_eq!(Grid::read(&list).unwrap(), of(&all, false));
        // What is no file beside it is not opened, and what is not there is named.
        let text = fs::read_to_string(&list).unwrap();
        for (other, words) in [
            ("../a-1.vtu", "no file beside it"),
            ("/etc/hostname", "no file beside it"),
            ("", "no file beside it"),
            ("b.vtu", "b.vtu"),
            // A list of lists would have no end.
            ("a.pvtu", "expected UnstructuredGrid"),
        ] {
            fs::write(&list, text.replace("a-1.vtu", other)).unwrap();
            let message = Grid::read(&list).unwrap_err().to_string();
            assert!(message.contains(words), "{message}");
        }
        fs::write(&list, "<VTKFile type=\"PUnstructuredGrid\"></VTKFile>").unwrap();
        assert!(Grid::read(&list).unwrap_err().to_string().contains("names no <Piece>"));
    });
}
