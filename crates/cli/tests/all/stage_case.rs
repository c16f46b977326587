//! A hall with stages before an earthquake, for the tests of the commands.

use serde_json::Value;
use std::path::Path;
use std::process::{Command, Output};
use tremolite_mesh::boxes::BoxSpec;

/// Writes the record `ricker2.txt`: a Ricker wavelet of 2 Hz and 2 m/s², at its peak at 1 s and over at 1.6 s.
pub fn write_ricker(folder: &Path) {
    let pulse: String = (0..800)
        .map(|k| {
            let t = 0.005 * f64::from(k);
            let x = (std::f64::consts::PI * 2.0 * (t - 1.0)).powi(2);
            format!("{t} {:.9e}\n", 2.0 * (1.0 - 2.0 * x) * (-x).exp())
        })
        .collect();
    std::fs::write(folder.join("ricker2.txt"), format!("# units = \"m/s2\"\n{pulse}")).unwrap();
}

pub fn tremolite(folder: &Path, args: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_tremolite")).current_dir(folder).args(args).output().unwrap()
}

pub fn code(output: &Output) -> i32 {
    output.status.code().unwrap()
}

pub fn errors(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

pub const SHAKING: &str = r#"[motion]
kind = "incident"
east = { file = "pulse.txt", units = "m/s2", dt = "0.01 s" }
processing = ["baseline"]
[dynamic]
base = "viscous"
sides = "viscous"
duration = "0.1 s"
"#;

pub const STAGES: &str = r#"[[stage]]
name = "bench"
excavate = ["core"]
release = 0.6
[[stage]]
name = "shell"
install = ["shell"]
[[stage]]
name = "water"
pressure = { shell = "20 kPa" }
"#;

pub const JOINT: &str = r#"[[interface]]
name = "joint"
between = ["shell", "rock"]
law = "bandis"
max_closure = "2 mm"
cohesion = "0.5 MPa"
friction_coefficient = 0.7
"#;

pub const LATERAL: &str = "lateral = 0.5\nrelease_cycles = 50\ntolerance = 1e-4\n";

/// Rock of 16 × 4 × 16 m in cubes of 2 m with an opening of 8 × 8 m along y: a core of 4 × 4 m and the shell around it.
pub fn case(folder: &Path, initial: &str, stages: &str, shaking: &str) {
    let mut mesh = BoxSpec::uniform([0.0; 3], [16.0, 4.0, 16.0], [8, 2, 8]).mesh().unwrap();
    let far = |e: u32| {
        let nodes = mesh.elements[e as usize].nodes();
        let middle = |i| nodes.iter().map(|&n| mesh.nodes[n as usize][i]).sum::<f64>() / nodes.len() as f64;
        (middle(0) - 8.0).abs().max((middle(2) - 8.0).abs())
    };
    let within = |low: f64, high: f64| {
        (0..mesh.elements.len() as u32).filter(|&e| (low..high).contains(&far(e))).collect::<Vec<u32>>()
    };
    let groups = [("core", within(0.0, 2.0)), ("shell", within(2.0, 4.0)), ("rock", within(4.0, 9.0))];
    mesh.groups = groups.map(|(name, elements)| (name.to_owned(), elements)).into();
    tremolite_mesh::write(folder.join("hall.msh"), &mesh).unwrap();
    let pulse: String = (0..40)
        .map(|k| {
            let t = (std::f64::consts::PI * 10.0 * (0.01 * f64::from(k) - 0.1)).powi(2);
            format!("{:.6}\n", (1.0 - 2.0 * t) * (-t).exp())
        })
        .collect();
    std::fs::write(folder.join("pulse.txt"), pulse).unwrap();
    let text = format!(
        r#"title = "hall"
[mesh.file]
path = "hall.msh"
[material.rock]
law = "mohr-coulomb"
young = "2 GPa"
poisson = 0.25
density = "2500 kg/m3"
cohesion = "1 MPa"
friction_angle = "40 deg"
tensile_strength = "0.5 MPa"
[material.concrete]
law = "elastic"
young = "20 GPa"
poisson = 0.2
density = "2500 kg/m3"
[[region]]
groups = ["rock", "core"]
material = "rock"
element = "reduced-integration"
viscosity = 0.02
[[region]]
groups = ["shell"]
material = "concrete"
element = "full-integration"
[initial]
{initial}
{stages}
{shaking}
[[monitor]]
name = "roof"
at = ["8 m", "2 m", "12.5 m"]
[[monitor]]
name = "wall"
at = ["12.5 m", "2 m", "8 m"]
[output]
{output}
"#,
        output = if shaking.is_empty() { "" } else { "histories = \"0.01 s\"\nsnapshots = \"0.1 s\"" }
    );
    std::fs::write(folder.join("case.toml"), text).unwrap();
}

pub fn change(folder: &Path, from: &str, to: &str) {
    let path = folder.join("case.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    assert!(text.contains(from), "the case has no '{from}'");
    std::fs::write(path, text.replacen(from, to, 1)).unwrap();
}

pub fn run(folder: &Path, out: &str, more: &[&str]) -> Output {
    tremolite(folder, &[&["run", "case.toml", "--out", out], more].concat())
}

pub fn bytes(folder: &Path, run: &str, file: &str) -> Vec<u8> {
    std::fs::read(folder.join(run).join(file)).unwrap_or_else(|e| panic!("{run}/{file}: {e}"))
}

pub fn same(folder: &Path, first: &str, second: &str, files: &[&str]) {
    for file in files {
        assert!(bytes(folder, first, file) == bytes(folder, second, file), "{file} of {first} and {second}");
    }
}

pub fn check(folder: &Path) -> (Value, String, String) {
    let json = tremolite(folder, &["check", "case.toml", "--json"]);
    assert_eq!(code(&json), 0, "{}", errors(&json));
    let text = tremolite(folder, &["check", "--verbose", "case.toml"]);
    let said = errors(&text);
    (serde_json::from_slice(&json.stdout).unwrap(), String::from_utf8(text.stdout).unwrap(), said)
}
