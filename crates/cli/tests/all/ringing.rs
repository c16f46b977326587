//! The check of ringing beside an interface: a block on a slope that chatters fails it, and with the default's viscosity passes.

use std::path::Path;
use std::process::Command;
use tremolite_results::{Summary, TrustLine};
use tremolite_verify::hill::hill;

/// The block of `crates/verify/src/problems/block_on_slope.rs` as a case; the check, and the block's largest slip \[m\].
fn shaken(folder: &Path, joint: &str) -> (TrustLine, f64) {
    let (mut mesh, first) = hill(1);
    let all = mesh.elements.len() as u32;
    mesh.groups = [("ground".into(), (0..first).collect()), ("block".into(), (first..all).collect())].into();
    tremolite_mesh::write(folder.join("hill.msh"), &mesh).unwrap();
    let pulse: String = (0..400)
        .map(|k| {
            let tau = (std::f64::consts::PI * 2.0 * (0.005 * f64::from(k) - 0.75)).powi(2);
            format!("{:.6}\n", -2.0 * (1.0 - 2.0 * tau) * (-tau).exp())
        })
        .collect();
    std::fs::write(folder.join("ricker.txt"), pulse).unwrap();
    let case = format!(
        r#"title = "block on a slope"
[mesh.file]
path = "hill.msh"
[material.rock]
law = "elastic"
young = "20 GPa"
poisson = 0.2
unit_weight = "25 kN/m3"
[[region]]
groups = ["ground", "block"]
material = "rock"
element = "reduced-integration"
[[interface]]
name = "joint"
between = ["block", "ground"]
law = "coulomb"
normal_stiffness = "10 GPa/m"
friction_coefficient = 0.5
cohesion = "0 Pa"
{joint}
[initial]
gravity = "9.81 m/s2"
lateral = {{ x = 0.25, y = 0.25 }}
[motion]
kind = "incident"
east = {{ file = "ricker.txt", units = "m/s2", dt = "0.005 s" }}
processing = []
[dynamic]
sides = {{ x = "free-field", y = "periodic" }}
base = {{ kind = "viscous" }}
[output]
histories = "0.005 s"
"#
    );
    std::fs::write(folder.join("case.toml"), case).unwrap();
    let run = Command::new(env!("CARGO_BIN_EXE_tremolite"))
        .current_dir(folder)
        .args(["run", "case.toml", "--out", "results", "--overwrite"])
        .output()
        .unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    let summary = Summary::read(&folder.join("results/summary.json")).unwrap();
    let line = |id: &str| summary.soundness.checks.iter().find(|line| line.id == id).unwrap().clone();
    (line("interface_ringing_joint"), line("interface_slip_joint").numbers["slip"])
}

#[test]
fn a_block_that_chatters_on_a_slope_fails_the_check_of_ringing_and_one_with_viscosity_passes() {
    let folder = tempfile::tempdir().unwrap();
    let (good, slip) = shaken(folder.path(), "");
    assert!(good.pass && !good.not_applicable, "{good:?}");
    let (bad, further) = shaken(folder.path(), "viscosity = 0");
    assert!(!bad.pass, "{bad:?}");
    // Newmark's rigid block slides by 62.9 mm (`block_on_slope`).
    assert!((slip - 0.0629).abs() < 0.02 * 0.0629 && further > 1.01 * slip, "{slip} m, {further} m");
}
