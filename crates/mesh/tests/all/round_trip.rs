//! What is written is read back exactly, in every format, and may be read by others.

use std::fs;
use std::path::PathBuf;

use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::topology::plane_faces;
use tremolite_mesh::write::{WRITERS, WriteError, write, write_as};
use tremolite_mesh::{Face, Mesh, Note, read, read_with_notes};

fn data(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)
}

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("tremolite-{name}-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// Meshes of all shapes, with overlapping groups, named faces and points, gaps in the numbers, and places
/// that need all digits.
fn meshes() -> Vec<(&'static str, Mesh)> {
    let mut shapes = read(data("shapes.msh")).unwrap();
    shapes.points.insert("at a node".into(), shapes.nodes[7]);
    shapes.points.insert("between nodes".into(), [1.0 / 3.0, -0.0, 1e-300]);
    shapes
        .groups
        .insert("odd ones".into(), (0..shapes.elements.len() as u32).filter(|e| e % 2 == 1).collect());
    shapes.node_ids = (0..shapes.nodes.len() as u64).map(|n| 100_000_000 + 3 * n).rev().collect();
    for node in shapes.nodes.iter_mut().flatten() {
        *node = *node * std::f64::consts::PI + 1e-7;
    }
    let mut brick = BoxSpec::uniform([0.0, -5.0, 2e6], [8.0, -3.0, 2e6 + 3.0], [4, 2, 3]).mesh().unwrap();
    brick.groups.insert("Rock".into(), (0..12).collect());
    brick.groups.insert("rock".into(), (10..24).collect());
    brick.faces = plane_faces(&brick, 1e-9);
    brick.element_ids = (0..24).map(|e| 7 * e + 1).collect();
    vec![("tunnel", read(data("tunnel.msh")).unwrap()), ("shapes", shapes), ("brick", brick)]
}

#[test]
fn every_format_gives_back_what_was_written() {
    let folder = folder("round-trip");
    for (name, mesh) in meshes() {
        for (k, writer) in WRITERS.iter().enumerate() {
            let path = folder.join(format!("{name}-{k}.{}", writer.extension));
            assert_eq!(write_as(&path, &mesh, writer).unwrap(), []);
            let (back, _) = read_with_notes(&path).unwrap();
            assert!(back == mesh, "{name} as {}", writer.name);
        }
    }
    // From format to format, and home again.
    let mesh = meshes().swap_remove(1).1;
    write(folder.join("a.msh"), &mesh).unwrap();
    write(folder.join("b.INP"), &read(folder.join("a.msh")).unwrap()).unwrap();
    write(folder.join("c.vtu"), &read(folder.join("b.INP")).unwrap()).unwrap();
    assert!(read(folder.join("c.vtu")).unwrap() == mesh);
    assert!(fs::read_dir(&folder).unwrap().all(|f| f.unwrap().path().extension().unwrap() != "part"));
    fs::remove_dir_all(&folder).unwrap();
}

/// Names that mean something to one of the formats, or to a careless reader.
#[test]
fn odd_names_come_back_as_they_were() {
    let names = [
        "a;b=c,d",
        "Körper ☃ 岩",
        "it's",
        "x.y",
        "*star",
        "**",
        "$EndNodes",
        "100",
        "-1",
        "a<b>&amp;c",
        "%20",
        "GENERATE",
        "group:x",
        "S1",
        "two  blanks",
        "#",
        "!bang",
        "\\n",
    ];
    let mut mesh = BoxSpec::uniform([0.0; 3], [6.0, 3.0, 1.0], [6, 3, 1]).mesh().unwrap();
    mesh.groups.clear();
    mesh.faces.clear();
    mesh.points.clear();
    for (k, name) in (0..).zip(names) {
        mesh.groups.insert(name.to_owned(), vec![k]);
        mesh.faces.insert(name.to_owned(), vec![Face { element: k, side: 5 }]);
        mesh.points.insert(name.to_owned(), mesh.nodes[k as usize]);
    }
    let folder = folder("odd-names");
    for (k, writer) in WRITERS.iter().enumerate() {
        let path = folder.join(format!("{k}.{}", writer.extension));
        write_as(&path, &mesh, writer).unwrap();
        let back = read(&path).unwrap();
        assert!(back == mesh, "{}: {:?} {:?} {:?}", writer.name, back.groups, back.faces, back.points);
    }
    fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn a_surface_of_one_side_inside_the_mesh_is_kept_or_told() {
    let mut mesh = BoxSpec::uniform([0.0; 3], [2.0, 1.0, 1.0], [2, 1, 1]).mesh().unwrap();
    mesh.groups.insert("all".into(), vec![0, 1]);
    mesh.faces.clear();
    mesh.faces.insert("middle".into(), vec![Face { element: 0, side: 1 }]);
    let folder = folder("one-side");
    for (extension, kept) in [("vtu", true), ("inp", true), ("msh", false)] {
        let path = folder.join(format!("a.{extension}"));
        let notes = write(&path, &mesh).unwrap();
        assert_eq!(read(&path).unwrap() == mesh, kept);
        let told = [Note::BothSides { name: "middle".into(), count: 1 }];
        assert_eq!(notes.as_slice(), if kept { [].as_slice() } else { &told });
    }
    fs::remove_dir_all(&folder).unwrap();
}

#[test]
fn what_a_format_cannot_hold_is_refused_and_leaves_no_file() {
    let folder = folder("refused");
    let mesh = meshes().swap_remove(2).1;
    let refused = |change: fn(&mut Mesh), file: &str, words: &str| {
        let mut mesh = mesh.clone();
        change(&mut mesh);
        let error = write(folder.join(file), &mesh).unwrap_err();
        assert!(matches!(error, WriteError::Mesh { .. }), "{error}");
        assert!(error.to_string().contains(words), "{error}");
    };
    let quote: fn(&mut Mesh) = |m| drop(m.groups.insert("a\"b".into(), vec![0]));
    refused(quote, "a.msh", "MSH cannot hold the name \"a\\\"b\"");
    refused(quote, "a.inp", "Abaqus cannot hold the name");
    refused(|m| drop(m.faces.insert("a\nb".into(), vec![])), "a.vtu", "VTU cannot hold the name");
    refused(|m| m.element_ids[3] = 1_000_000_000, "a.inp", "Abaqus takes numbers up to 999999999");
    refused(|m| m.element_ids[3] = u64::MAX, "a.vtu", "VTU cannot hold the number 18446744073709551615");
    refused(|m| m.element_ids[3] = u64::MAX, "a.msh", "leave no room for those of surfaces");
    let error = write(folder.join("a.stl"), &mesh).unwrap_err().to_string();
    assert!(error.contains("a.stl: the name ends in no known way; known are: .vtu (VTU), .msh"), "{error}");
    let error = write(folder.join("absent/a.msh"), &mesh).unwrap_err();
    assert!(matches!(error, WriteError::Io { .. }), "{error}");
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 0);
    fs::remove_dir_all(&folder).unwrap();
}
