//! Files as users have them, each with what it must give.

use std::collections::BTreeMap;
use std::path::PathBuf;

use tremolite_mesh::quality::{by_group, summary};
use tremolite_mesh::read::read_encoded;
use tremolite_mesh::{Mesh, Note, read, read_with_notes};

fn input(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/inputs").join(name)
}

/// Elements and volume of each group.
fn groups(mesh: &Mesh) -> BTreeMap<&str, (usize, f64)> {
    by_group(mesh).into_iter().map(|(name, s)| (name, (s.elements, s.volume))).collect()
}

fn refusal(name: &str) -> String {
    read(input(name)).expect_err(name).to_string()
}

fn one_cube(name: &str, group: &str) -> Vec<Note> {
    let (mesh, notes) = read_with_notes(input(name)).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!((mesh.nodes.len(), mesh.elements.len(), summary(&mesh).volume), (8, 1, 1.0), "{name}");
    assert_eq!(groups(&mesh).get(group), Some(&(1, 1.0)), "{name}: {:?}", mesh.groups);
    notes
}

#[test]
fn a_single_part_without_an_assembly_is_the_model() {
    assert_eq!(one_cube("part_without_instance.inp", "Bench"), []);
}

#[test]
fn a_backslash_in_the_name_of_an_included_file_separates_folders() {
    assert_eq!(one_cube("include_path_with_backslash.inp", "Rock"), []);
}

#[test]
fn a_node_set_with_an_undefined_node_is_noted() {
    let notes = one_cube("unused_node_set_names_a_node_that_is_not_there.inp", "Rock");
    let absent = Note::AbsentNodes { set: "cyclic".into(), count: 1, first: 99 };
    assert!(notes.contains(&absent), "{notes:?}");
}

/// mapdl-archive 0.6.0 reads the tetrahedron with the corners 1, 2, 4, 5.
#[test]
fn midside_nodes_at_the_end_of_an_element_may_be_absent() {
    let (mesh, notes) = read_with_notes(input("cdb_midside_nodes_cut_off.cdb")).unwrap();
    let corners: Vec<u64> = mesh.elements[0].nodes().iter().map(|&n| mesh.node_id(n as usize)).collect();
    assert_eq!((mesh.elements.len(), corners), (1, vec![1, 2, 4, 5]));
    assert!((summary(&mesh).volume - 1.0 / 6.0).abs() < 1e-15);
    assert!(matches!(notes[0], Note::Reduced { nodes: 10, count: 1, .. }), "{notes:?}");
}

#[test]
fn a_compact_element_block_is_read() {
    assert_eq!(one_cube("cdb_compact_eblock.cdb", "material 1"), []);
}

#[test]
fn an_archive_of_parameters_alone_is_named_as_such() {
    let message = refusal("cdb_of_parameters_taken_for_abaqus.cdb");
    assert!(message.contains("ANSYS") && message.contains("parameters"), "{message}");
    assert!(message.contains("CDWRITE") && !message.contains("C3D8"), "{message}");
}

#[test]
fn a_mesh_packed_by_gzip_is_the_mesh() {
    let (mesh, _) = read_with_notes(input("mesh_packed_with_gzip.msh.gz")).unwrap();
    assert_eq!((mesh.nodes.len(), mesh.elements.len()), (64, 27));
    assert!((summary(&mesh).volume - 24.0).abs() < 1e-9);
}

#[test]
fn an_ls_dyna_file_is_not_taken_for_abaqus() {
    assert_eq!(one_cube("ls_dyna_taken_for_abaqus.k", "part 1"), []);
}

#[test]
fn names_in_gbk_are_read_with_a_note() {
    let wanted = Note::Assumed { encoding: "gb18030".into() };
    for (name, groups) in
        [("gbk_group_names.f3grid", &["围岩", "衬砌"][..]), ("gbk_set_names.inp", &["围岩"])]
    {
        let (mesh, notes) = read_with_notes(input(name)).unwrap();
        let mut found: Vec<&str> = mesh.groups.keys().map(String::as_str).collect();
        found.sort_by_key(|name| groups.iter().position(|group| group == name));
        assert_eq!(found, groups, "{name}");
        assert!(notes.contains(&wanted), "{name}: {notes:?}");
    }
}

#[test]
fn a_stated_encoding_is_taken_and_one_that_does_not_fit_refused() {
    let big5 = tremolite_files::text::encoding("big5").ok();
    let (mesh, notes) = read_encoded(input("gbk_set_names.inp"), big5).unwrap();
    assert!(!mesh.groups.contains_key("围岩") && notes.is_empty(), "{notes:?}");
    let utf_8 = tremolite_files::text::encoding("utf-8").ok();
    let message = read_encoded(input("gbk_set_names.inp"), utf_8).unwrap_err().to_string();
    assert!(message.contains("the text is not UTF-8; state another encoding"), "{message}");
}

#[test]
fn a_unv_file_is_named_with_a_command_that_converts_it() {
    let message = refusal("unknown_kind_without_a_way_on.unv");
    assert!(message.contains("UNV") && message.contains("gmsh in.unv -save -o out.msh"), "{message}");
}
