//! Files of other programs: counts that always hold, and the same from meshio where Python has it.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::process::Command;

use tremolite_mesh::quality::summary;
use tremolite_mesh::{Mesh, Note, Shape, merge, read, read_with_notes, write};

fn data(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)
}

fn counts(mesh: &Mesh) -> [usize; 4] {
    [Shape::Hex8, Shape::Wedge6, Shape::Pyramid5, Shape::Tet4]
        .map(|shape| mesh.elements.iter().filter(|e| e.shape == shape).count())
}

/// What meshio 5.3.5 finds in the files whose names begin so (pyNastran 1.4.1 in `*.bdf`): points, hexahedra, wedges,
/// pyramids, tetrahedra. Of second-order files the points are those at corners.
const FOUND: [(&str, usize, [usize; 4]); 4] = [
    ("rounded", 54, [8, 16, 4, 27]),
    ("tunnel", 288, [160, 0, 0, 0]),
    ("shapes", 54, [8, 16, 4, 27]),
    ("flac3d_mesh_ex", 160, [75, 15, 15, 3]),
];

/// Every mesh file of the folder with what is in it. That every format has one whose name begins with `shapes` is tested
/// beside the list of formats.
fn files() -> Vec<(String, usize, [usize; 4])> {
    let names = std::fs::read_dir(data("")).unwrap().map(|f| f.unwrap().file_name().into_string().unwrap());
    let mut names: Vec<String> =
        names.filter(|name| ![".geo", ".md", ".py"].iter().any(|end| name.ends_with(end))).collect();
    names.sort();
    let with_counts = |name: String| {
        let (_, nodes, elements) = FOUND
            .into_iter()
            .find(|(begin, ..)| name.starts_with(begin))
            .unwrap_or_else(|| panic!("{name}: say in FOUND what is in it"));
        (name, nodes, elements)
    };
    names.into_iter().map(with_counts).collect()
}

#[test]
fn files_have_the_counts_that_meshio_finds() {
    for (name, nodes, elements) in files() {
        let mesh = read(data(&name)).unwrap();
        assert_eq!((mesh.nodes.len(), counts(&mesh)), (nodes, elements), "{name}");
        let all = summary(&mesh);
        assert!(all.min_scaled_jacobian > 0.0, "{name}");
        if name.starts_with("shapes") {
            // Two boxes of 2³ and a pyramid of height 2; the VTU in text has 11 digits.
            assert!((all.volume - (8.0 + 8.0 + 8.0 / 3.0)).abs() < 1e-9, "{name}: {}", all.volume);
        }
    }
}

#[test]
fn a_format_is_known_by_content_whatever_the_name_and_notes_change_nothing() {
    let path = std::env::temp_dir().join(format!("tremolite-nameless-{}", std::process::id()));
    for (name, ..) in files() {
        std::fs::copy(data(&name), &path).unwrap();
        let (mesh, _) = read_with_notes(&path).unwrap();
        assert!(mesh == read(data(&name)).unwrap(), "{name}");
    }
    std::fs::remove_file(&path).unwrap();
}

#[test]
fn the_same_mesh_in_every_format_has_the_same_places_and_faces() {
    let mesh = read(data("shapes.msh")).unwrap();
    for (name, ..) in files().iter().filter(|f| f.0.starts_with("shapes")) {
        let other = read(data(name)).unwrap();
        assert_eq!(other.nodes.len(), mesh.nodes.len(), "{name}");
        for (x, y) in mesh.nodes.iter().flatten().zip(other.nodes.iter().flatten()) {
            assert!((x - y).abs() < 1e-9, "{name}");
        }
        let exterior = |m: &Mesh| tremolite_mesh::topology::exterior_faces(m, None).len();
        assert_eq!(exterior(&mesh), exterior(&other), "{name}");
    }
}

/// Every file, damaged in a few places: it is refused, or what is read is whole.
#[test]
fn damaged_files_are_refused_or_give_a_sound_mesh() {
    const WORDS: [&str; 9] = ["", "-1", "0", "99999999999", "18446744073709551615", "nan", "\n", "\"", "<"];
    let path = std::env::temp_dir().join(format!("tremolite-damaged-{}", std::process::id()));
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    let mut below = |n: usize| {
        // Xorshift.
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state % n.max(1) as u64) as usize
    };
    for (name, ..) in files() {
        let original = std::fs::read(data(&name)).unwrap();
        for _ in 0..40 {
            let mut bytes = original.clone();
            for _ in 0..=below(3) {
                let at = below(bytes.len());
                match below(4) {
                    0 => bytes.truncate(at),
                    1 => bytes.iter_mut().skip(at).take(1 + below(8)).for_each(|b| *b = 0xff),
                    2 => drop(bytes.splice(at..at, WORDS[below(WORDS.len())].bytes())),
                    _ => drop(bytes.drain(at..(at + below(60)).min(bytes.len()))),
                }
            }
            std::fs::write(&path, &bytes).unwrap();
            let Ok(mesh) = read(&path) else { continue };
            let (nodes, elements) = (mesh.nodes.len() as u32, mesh.elements.len() as u32);
            assert!(mesh.nodes.iter().flatten().all(|x| x.is_finite()), "{name}");
            assert!(mesh.elements.iter().flat_map(|e| e.nodes).all(|n| n < nodes), "{name}");
            assert!(mesh.groups.values().flatten().all(|&e| e < elements), "{name}");
            let sides = |f: &tremolite_mesh::Face| mesh.elements[f.element as usize].shape.faces().len();
            assert!(mesh.faces.values().flatten().all(|f| usize::from(f.side) < sides(f)), "{name}");
            assert!(summary(&mesh).min_scaled_jacobian > 0.0, "{name}");
        }
    }
    std::fs::remove_file(&path).unwrap();
}

#[test]
fn parts_that_touch_without_common_nodes_are_told_and_can_be_merged() {
    let mut mesh = read(data("shapes.msh")).unwrap();
    let whole = mesh.nodes.len();
    // The wedges get nodes of their own.
    let mut own = BTreeMap::new();
    for e in mesh.groups["wedges"].clone() {
        for node in &mut mesh.elements[e as usize].nodes {
            *node = *own.entry(*node).or_insert_with(|| {
                mesh.nodes.push(mesh.nodes[*node as usize]);
                mesh.nodes.len() as u32 - 1
            });
        }
    }
    mesh.faces.clear();
    let path = std::env::temp_dir().join(format!("tremolite-parts-{}.msh", std::process::id()));
    write(&path, &mesh).unwrap();
    let (mut apart, notes) = read_with_notes(&path).unwrap();
    std::fs::remove_file(&path).unwrap();
    let Some(Note::Coincident { count, tolerance, .. }) = notes.last() else { panic!("{notes:?}") };
    // Two by two faces between bricks and wedges: nine nodes.
    assert_eq!((*count, apart.nodes.len()), (9, whole + 9));
    assert_eq!(merge::merge_nodes(&mut apart, *tolerance), Ok(9));
    assert_eq!((apart.nodes.len(), tremolite_mesh::topology::components(&apart, None).len()), (whole, 1));
}

const SCRIPT: &str = r"
import sys, meshio
for path in sys.argv[1:]:
    mesh = meshio.read(path)
    of = dict(hexahedron=0, hexahedron27=0, wedge=1, wedge18=1, pyramid=2, pyramid14=2, tetra=3, tetra10=3)
    corners = [8, 6, 5, 4]
    counts, used = [0] * 4, set()
    for block in mesh.cells:
        if block.type in of:
            shape = of[block.type]
            counts[shape] += len(block.data)
            used.update(block.data[:, :corners[shape]].ravel().tolist())
    sums = mesh.points[sorted(used)].sum(axis=0)
    print('MESH', path, len(used), *counts, *map(repr, map(float, sums)), sep='\t')
    for name, blocks in mesh.cell_sets.items():
        cells = zip(mesh.cells, blocks)
        members = sum(len(some) for block, some in cells if block.type in of and some is not None)
        if members:
            print('GROUP', path, name, members, sep='\t')
";

/// Meshio reads the same files, and the ones written here, and finds the same numbers of nodes and elements, the same
/// places, and as many members of each group of the same name.
#[test]
fn meshio_agrees_where_python_has_it() {
    let python = std::env::var("TREMOLITE_PYTHON").unwrap_or_else(|_| "python3".to_owned());
    let has = Command::new(&python).args(["-c", "import meshio"]).output();
    if !has.is_ok_and(|out| out.status.success()) {
        eprintln!(
            "passed over: {python} has no meshio (pip install meshio; TREMOLITE_PYTHON names another Python)"
        );
        return;
    }
    let folder = std::env::temp_dir().join(format!("tremolite-meshio-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let mut wanted: BTreeMap<PathBuf, Mesh> = BTreeMap::new();
    for (name, _, elements) in files() {
        // Meshio knows neither ANSYS's archives, LS-DYNA, Nastran's coordinate systems nor Abaqus's pyramids.
        let readable = |path: &PathBuf| match path.extension().and_then(|e| e.to_str()) {
            Some("cdb" | "k" | "bdf") => false,
            Some("inp") => elements[2] == 0,
            _ => true,
        };
        let mesh = read(data(&name)).unwrap();
        if readable(&data(&name)) {
            wanted.insert(data(&name), mesh.clone());
        }
        for (k, writer) in write::WRITERS.iter().enumerate() {
            let path = folder.join(format!("{name}-{k}.{}", writer.extension));
            write::write_as(&path, &mesh, writer).unwrap();
            if readable(&path) {
                wanted.insert(path, mesh.clone());
            }
        }
    }
    let out = Command::new(&python).arg("-c").arg(SCRIPT).args(wanted.keys()).output().unwrap();
    let text = String::from_utf8_lossy(&out.stdout);
    assert!(out.status.success(), "{text}{}", String::from_utf8_lossy(&out.stderr));
    let (mut found, mut groups) = (0, 0);
    for line in text.lines() {
        let fields: Vec<&str> = line.split('\t').collect();
        let number = |k: usize| fields[k].parse::<usize>().unwrap();
        match fields[0] {
            "MESH" => {
                let mesh = &wanted[&PathBuf::from(fields[1])];
                assert_eq!((number(2), [3, 4, 5, 6].map(number)), (mesh.nodes.len(), counts(mesh)), "{line}");
                for i in 0..3 {
                    let ours: f64 = mesh.nodes.iter().map(|x| x[i]).sum();
                    let size: f64 = mesh.nodes.iter().map(|x| x[i].abs()).sum();
                    // Both sum the same numbers, in another order.
                    let theirs: f64 = fields[7 + i].parse().unwrap();
                    assert!((ours - theirs).abs() <= 1e-13 * size, "{line}: {ours}");
                }
                found += 1;
            }
            "GROUP" => {
                if let Some(ours) = wanted[&PathBuf::from(fields[1])].groups.get(fields[2]) {
                    assert_eq!(number(3), ours.len(), "{line}");
                    groups += 1;
                }
            }
            _ => {}
        }
    }
    assert_eq!(found, wanted.len());
    assert!(groups > 50, "{groups} groups were compared");
    std::fs::remove_dir_all(&folder).unwrap();
}
