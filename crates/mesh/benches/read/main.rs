//! Seconds and peak memory of reading a large mesh in every format.
//!
//! `cargo bench -p tremolite-mesh --bench read [-- ELEMENTS_AN_EDGE]`; one million hexahedra by default. Each file is
//! read in a process of its own, and the memory is that process's largest resident set less what it had before, over
//! the bytes of the mesh that it then holds (nodes 24, elements 36, members of groups 4, faces 8, numbers other than
//! 1, 2, 3 … 8 each). The memory is known on Linux only. The seconds are the better of two, the file in the page cache.

mod files;

use std::path::Path;
use std::process::Command;
use std::time::Instant;
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::topology::plane_faces;
use tremolite_mesh::{Element, Face, Mesh, read};

/// The word by which a child process knows that it is one.
const CHILD: &str = "read-this";

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|a| a != "--bench").collect();
    match arguments.as_slice() {
        [word, path] if word == CHILD => child(Path::new(path)),
        [] => parent(100),
        [edge] => parent(edge.parse().expect("the number of elements along an edge")),
        _ => panic!("at most one number is taken: the elements along an edge"),
    }
}

/// Reads one file and prints seconds, peak bytes and bytes of the mesh.
fn child(path: &Path) {
    let before = peak();
    let start = Instant::now();
    let mesh = read(path).unwrap();
    let seconds = start.elapsed().as_secs_f64();
    println!("{seconds} {} {} {}", peak().saturating_sub(before), bytes(&mesh), mesh.elements.len());
}

/// Largest resident set of this process so far in bytes; 0 where it is not known.
fn peak() -> usize {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|l| l.strip_prefix("VmHWM:"));
    line.and_then(|l| l.trim().strip_suffix("kB")?.trim().parse::<usize>().ok()).unwrap_or(0) * 1024
}

fn bytes(mesh: &Mesh) -> usize {
    let members: usize = mesh.groups.values().map(Vec::len).sum();
    let faces: usize = mesh.faces.values().map(Vec::len).sum();
    24 * mesh.nodes.len()
        + size_of::<Element>() * mesh.elements.len()
        + 4 * members
        + size_of::<Face>() * faces
        + 8 * (mesh.node_ids.len() + mesh.element_ids.len())
}

fn parent(edge: u32) {
    let size = f64::from(edge);
    let mut mesh = BoxSpec::uniform([0.0; 3], [size; 3], [edge; 3]).mesh().unwrap();
    // Coordinates with all their digits, as meshes have them.
    for (n, x) in mesh.nodes.iter_mut().enumerate() {
        for (i, x) in x.iter_mut().enumerate() {
            *x += 0.1 * ((3 * n + i) as f64).sin();
        }
    }
    let count = mesh.elements.len() as u32;
    mesh.groups = [("rock", (0..count).collect()), ("lining", (0..count).step_by(10).collect())]
        .map(|(name, list)| (name.to_owned(), list))
        .into();
    let plain = BoxSpec::uniform([0.0; 3], [size; 3], [edge; 3]).mesh().unwrap();
    mesh.faces = plane_faces(&plain, 1e-9);
    drop(plain);
    let folder = std::env::temp_dir().join(format!("tremolite-read-bench-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    println!("{count} hexahedra, {:.0} MB as a mesh", bytes(&mesh) as f64 / 1e6);
    println!("{:28} {:>9} {:>9} {:>11}", "format", "file [MB]", "time [s]", "peak / mesh");
    for (name, write) in files::FILES {
        let path = folder.join("mesh");
        write(&path, &mesh);
        let length = std::fs::metadata(&path).unwrap().len();
        let runs: Vec<Vec<f64>> = (0..2)
            .map(|_| {
                let own = std::env::current_exe().unwrap();
                let out = Command::new(own).arg(CHILD).arg(&path).output().unwrap();
                assert!(out.status.success(), "{name}: {}", String::from_utf8_lossy(&out.stderr));
                let text = String::from_utf8(out.stdout).unwrap();
                text.split_whitespace().map(|w| w.parse().unwrap()).collect()
            })
            .collect();
        assert_eq!(runs[0][3], f64::from(count), "{name}");
        let best = runs[0][0].min(runs[1][0]);
        println!("{name:28} {:>9.0} {best:>9.2} {:>11.2}", length as f64 / 1e6, runs[0][1] / runs[0][2]);
    }
    std::fs::remove_dir_all(&folder).unwrap();
}
