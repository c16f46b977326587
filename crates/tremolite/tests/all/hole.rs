//! A lining cast against the wall of a hole is that of the mesh which had it as elements: the same case built two ways.

use std::f64::consts::PI;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use tremolite::job::{Caller, Given, Inputs, Job};
use tremolite::run::Control;
use tremolite::simulation::Start;
use tremolite_mesh::{Element, Mesh, Shape, quality};
use tremolite_motion::Channel;
use tremolite_results::{ResultFolder, Status};

const AROUND: usize = 16;
/// Along y, each 2 m long.
const SLICES: usize = 2;
/// Circumradius of the wall \[m\], and the thickness at right angles to it.
const WALL: f64 = 3.0;
const THICKNESS: f64 = 0.4;

const CASE: &str = r#"title = "lined tunnel"
[mesh.file]
path = "tunnel.msh"
LINING
[material.rock]
law = "mohr-coulomb"
young = "5 GPa"
poisson = 0.25
density = "2500 kg/m3"
cohesion = "1 MPa"
friction_angle = "40 deg"
tensile_strength = "0.5 MPa"
[material.concrete]
law = "elastic"
young = "25 GPa"
poisson = 0.2
density = "2500 kg/m3"
[[region]]
groups = ["rock"]
material = "rock"
element = "reduced-integration"
[[region]]
groups = ["lining"]
material = "concrete"
element = "layered"
[[interface]]
name = "joint"
between = ["lining", "rock"]
law = "coulomb"
cohesion = "0.1 MPa"
friction_coefficient = 0.6
normal_stiffness = "20 GPa/m"
[initial]
lateral = 0.5
tolerance = 1e-5
[[stage]]
name = "lining"
install = ["lining"]
[motion]
kind = "incident"
east = { file = "pulse.txt", units = "m/s2", dt = "0.01 s" }
processing = ["baseline"]
[dynamic]
base = "viscous"
sides = "viscous"
duration = "0.3 s"
[[monitor]]
name = "wall"
at = ["2.9 m", "2 m", 0]
[[monitor]]
name = "inside"
at = [0, "2 m", "-2.6 m"]
[output]
histories = "0.01 s"
"#;

/// A block of 20 × 4 × 20 m with a hole of many sides along y, with or without its lining as elements.
fn tunnel(lined: bool) -> Mesh {
    let inner = WALL - THICKNESS / (PI / AROUND as f64).cos();
    let radii = if lined { vec![inner, WALL, 5.0] } else { vec![WALL, 5.0] };
    let rings = radii.len() + 1;
    let mut mesh = Mesh::default();
    for slice in 0..=SLICES {
        for i in 0..AROUND {
            let a = 2.0 * PI * i as f64 / AROUND as f64;
            let side = 10.0 / a.sin().abs().max(a.cos().abs());
            for r in radii.iter().copied().chain([side]) {
                mesh.nodes.push([r * a.cos(), 2.0 * slice as f64, r * a.sin()]);
            }
        }
    }
    for slice in 0..SLICES {
        for i in 0..AROUND {
            for r in 0..rings - 1 {
                let node = |s: usize, i: usize, r: usize| (rings * (s * AROUND + i % AROUND) + r) as u32;
                let ring =
                    |s: usize| [node(s, i, r), node(s, i, r + 1), node(s, i + 1, r + 1), node(s, i + 1, r)];
                let shape = Element::new(Shape::Hex8, &[ring(slice + 1), ring(slice)].concat());
                let name = if lined && r == 0 { "lining" } else { "rock" };
                mesh.groups.entry(name.into()).or_default().push(mesh.elements.len() as u32);
                mesh.elements.push(shape);
            }
        }
    }
    assert!(quality::summary(&mesh).min_scaled_jacobian > 0.3);
    mesh
}

/// The histories of the monitors, in rows, with the unit of each column.
fn run(lined: bool, keys: &str, folder: &Path) -> (Vec<String>, Vec<Vec<f64>>) {
    let samples = (0..30).map(|k| (0.4 * f64::from(k)).sin() * 2.0).collect();
    let inputs = Inputs {
        meshes: [("tunnel.msh".to_owned(), tunnel(lined))].into(),
        records: [("pulse.txt".to_owned(), vec![Channel::new("pulse", 0.01, samples)])].into(),
        ..Inputs::default()
    };
    let given = Given { inputs, ..Given::default() };
    let job = Job::of_text(&CASE.replace("LINING", keys), folder, &given).unwrap_or_else(|f| panic!("{f}"));
    let results = ResultFolder::create(Some(&folder.join(format!("out-{lined}"))), "out", false).unwrap();
    let mut control = Control { stop: &AtomicBool::new(false), progress: &mut |_| {} };
    let (_, summary) = job.run(&results, Start::Rest, &Caller::new("test"), &mut control).unwrap();
    assert_eq!(summary.conclusion.status, Status::Done, "{}", summary.conclusion.verdict);
    let text = std::fs::read_to_string(results.root().join("monitors.csv")).unwrap();
    let mut lines = text.lines();
    let header = lines.find(|line| line.starts_with("time")).unwrap_or_default();
    let units = header.split(',').map(|name| name.rsplit_once('[').unwrap().1.to_owned()).collect();
    (units, lines.map(|line| line.split(',').map(|x| x.parse().unwrap()).collect()).collect())
}

#[test]
fn a_lining_cast_in_a_hole_gives_the_histories_of_one_that_the_mesh_has() {
    let folder = tempfile::tempdir().unwrap();
    let (units, meshed) = run(true, "", folder.path());
    let keys = format!("[[mesh.lining]]\nname = \"lining\"\nthickness = \"{THICKNESS} m\"");
    let (_, cast) = run(false, &keys, folder.path());
    assert!(meshed.len() > 20 && meshed.len() == cast.len());
    let peak = |c: usize| meshed.iter().map(|row| row[c].abs()).fold(0.0, f64::max);
    for (c, unit) in units.iter().enumerate() {
        // Of all columns in the unit: what should be zero is so but for round-off.
        let peak = (0..units.len()).filter(|&k| units[k] == *unit).map(peak).fold(0.0, f64::max);
        let off = meshed.iter().zip(&cast).map(|(a, b)| (a[c] - b[c]).abs()).fold(0.0, f64::max);
        // Elements and nodes are numbered otherwise, so sums round otherwise.
        assert!(peak > 0.0 && off <= 1e-9 * peak, "column {c}: {off} of {peak}");
    }
}
