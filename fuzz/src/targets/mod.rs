//! What reads input from outside, as functions of bytes that must neither panic nor hand out what is unsound. The fuzzer calls them, and so
//! does a test of `crates/cli` with the inputs in `corpus`.

mod changed;
mod checkpoint;
mod folder;
mod meshes;
mod records;
mod texts;

use std::path::Path;

/// One of them.
pub struct Target {
    /// Also of its folder in `corpus`.
    pub name: &'static str,
    /// Reads the bytes and looks at what came out; false if they are meant for another target.
    pub takes: fn(&[u8]) -> bool,
}

const fn target(name: &'static str, takes: fn(&[u8]) -> bool) -> Target {
    Target { name, takes }
}

/// All of them.
pub const TARGETS: &[Target] = &[
    target("case", texts::case),
    target("case-changed", changed::case),
    target("law", texts::law),
    target("study", texts::study),
    target("study-changed", changed::study),
    target("limits", texts::limits),
    target("mesh-description", texts::mesh_description),
    target("mesh-gmsh", |bytes| meshes::read("Gmsh", bytes)),
    target("mesh-vtu", |bytes| meshes::read("VTU", bytes)),
    target("mesh-vtk", |bytes| meshes::read("VTK", bytes)),
    target("mesh-f3grid", |bytes| meshes::read("FLAC3D", bytes)),
    target("mesh-cdb", |bytes| meshes::read("ANSYS", bytes)),
    target("mesh-abaqus", |bytes| meshes::read("Abaqus", bytes)),
    target("mesh-nastran", |bytes| meshes::read("Nastran", bytes)),
    target("mesh-dyna", |bytes| meshes::read("LS-DYNA", bytes)),
    target("record-geonet", |bytes| records::read("GeoNet V1A, V2A", bytes)),
    target("record-cosmos", |bytes| records::read("COSMOS", bytes)),
    target("record-smc", |bytes| records::read("SMC", bytes)),
    target("record-csmip", |bytes| records::read("CSMIP, CDMG, USC", bytes)),
    target("record-mseed", |bytes| records::read("miniSEED", bytes)),
    target("record-knet", |bytes| records::read("K-NET, KiK-net", bytes)),
    target("record-esm", |bytes| records::read("ESM (DYNA)", bytes)),
    target("record-itaca", |bytes| records::read("ITACA", bytes)),
    target("record-peer", |bytes| records::read("PEER AT2", bytes)),
    target("record-sac", |bytes| records::read("SAC", bytes)),
    target("record-csmnc", |bytes| records::read("CSMNC", bytes)),
    target("record-bhrc", |bytes| records::read("BHRC", bytes)),
    target("record-declared", |bytes| records::read("AFAD, CWB, JMA, ASA", bytes)),
    target("record-stations", records::stations),
    target("record-text", |bytes| records::read("text columns", bytes)),
    target("results", folder::results),
    target("checkpoint", checkpoint::state),
];

/// Sound inputs that a target begins with, beside its own in `corpus`; `root` is the repository.
pub fn seeds(target: &Target, root: &Path) -> Vec<Vec<u8>> {
    let files = SEEDS.iter().filter(|(name, _)| *name == target.name).map(|(_, file)| root.join(file));
    let files = files.map(|file| std::fs::read(&file).unwrap_or_else(|e| panic!("{}: {e}", file.display())));
    match target.name {
        "results" => folder::inputs().collect(),
        "checkpoint" => vec![checkpoint::seed()],
        _ => files.collect(),
    }
}

/// Those that are files of the repository.
const SEEDS: &[(&str, &str)] = &[
    ("case", "crates/case/tests/cases/every-key.toml"),
    ("case", "cases/first-shake/case.toml"),
    ("case", "cases/two-rocks/case.toml"),
    ("case", "cases/aslant/case.toml"),
    ("law", "cases/laws/concrete.toml"),
    ("law", "cases/laws/joint.toml"),
    ("study", "cases/first-shake/fragility.toml"),
    ("mesh-gmsh", "crates/mesh/tests/data/shapes.msh"),
    ("mesh-gmsh", "crates/mesh/tests/data/shapes_binary.msh"),
    ("mesh-gmsh", "crates/mesh/tests/data/shapes_v2.msh"),
    ("mesh-gmsh", "crates/mesh/tests/data/shapes_v2_binary.msh"),
    ("mesh-vtu", "crates/mesh/tests/data/shapes_ascii.vtu"),
    ("mesh-vtu", "crates/mesh/tests/data/shapes_base64.vtu"),
    ("mesh-vtu", "crates/mesh/tests/data/shapes_zlib.vtu"),
    ("mesh-vtk", "crates/mesh/tests/data/shapes_v42.vtk"),
    ("mesh-vtk", "crates/mesh/tests/data/shapes_v51.vtk"),
    ("mesh-f3grid", "crates/mesh/tests/data/shapes_binary.f3grid"),
    ("mesh-f3grid", "crates/mesh/tests/data/flac3d_mesh_ex.f3grid"),
    ("mesh-cdb", "crates/mesh/tests/data/shapes.cdb"),
    ("mesh-abaqus", "crates/mesh/tests/data/shapes.inp"),
    ("record-sac", "crates/motion/tests/data/obspy.sac"),
    ("record-csmnc", "crates/motion/tests/data/china_csmnc_eight_values_a_line.dat"),
    ("record-bhrc", "crates/motion/tests/data/iran_bhrc_three_components.V1"),
    ("record-declared", "crates/motion/tests/data/turkey_afad_three_columns.txt"),
    ("record-declared", "crates/motion/tests/data/taiwan_cwb_four_columns.dat"),
    ("record-declared", "crates/motion/tests/data/japan_jma.csv"),
    ("record-declared", "crates/motion/tests/data/mexico_asa2_three_columns.101"),
    ("record-stations", "crates/motion/tests/data/obspy.xml"),
    ("mesh-nastran", "crates/mesh/tests/data/shapes.bdf"),
    ("mesh-nastran", "crates/mesh/tests/data/rounded_free.bdf"),
    ("mesh-nastran", "crates/mesh/tests/data/rounded_order2.bdf"),
    ("mesh-dyna", "crates/mesh/tests/data/shapes.k"),
    ("mesh-dyna", "crates/mesh/tests/data/shapes_long.k"),
];
