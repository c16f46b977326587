//! Draws the figures of docs/support.md: `cargo run --release -p tremolite-cli --example support_figures`.
//!
//! A round tunnel in weak rock is excavated in ten equal steps of release, with bolts placed in one of them or never: the order of a
//! bolt's work is that of the stages.

use std::path::Path as File;
use tremolite::setup::{Laws, setup};
use tremolite::{Assembly, Engine, Model, Phase, Stage, State};
use tremolite_case::Case;
use tremolite_laws::Isa;
use tremolite_laws::materials::MATERIALS;
use tremolite_report::loops::{Curve, Loops, Named, Plane, Quantity};

/// Steps in which the excavation is let go.
const STEPS: usize = 10;
/// Name of the figure's file.
pub const REACTION: &str = "ground-reaction.svg";

fn main() -> Result<(), String> {
    let folder = File::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/support");
    std::fs::create_dir_all(&folder).map_err(|e| e.to_string())?;
    let curves = [
        ("no bolts", None, FOLLOWING),
        ("bolts from the start", Some(0), FOLLOWING),
        ("bolts at 80 %", Some(8), FOLLOWING),
        ("start, bond slides", Some(0), SLIDING),
    ];
    let mut drawn = Vec::new();
    for (name, placed, bond) in curves {
        let motion = reaction(placed, bond)?;
        println!(
            "| {name} | {} |",
            motion.iter().map(|m| format!("{:.1}", 1e3 * m)).collect::<Vec<_>>().join(" | ")
        );
        drawn.push((name, motion));
    }
    std::fs::write(folder.join(REACTION), draw(&drawn)).map_err(|e| e.to_string())
}

const FOLLOWING: &str = "";
const SLIDING: &str = r#", bond = { stiffness = "1 GPa", strength = "60 kN/m" }"#;

/// Mean motion \[m\] of crown and wall into the opening at the end of each step, from 0 on. Bolts are placed where so many steps are
/// done.
fn reaction(placed: Option<usize>, bond: &str) -> Result<Vec<f64>, String> {
    let source = case(placed, bond);
    let case = Case::parse(File::new("case.toml"), &source, MATERIALS).map_err(|e| e.to_string())?;
    let made = setup(&case, &Laws::default(), Isa::best()).map_err(|e| e.to_string())?;
    let points = [[0.0, 0.0, AXIS + WALL], [-WALL, 0.0, AXIS], [WALL, 0.0, AXIS]];
    let model = Model::new(made.problem).map_err(|e| e.to_string())?;
    let assembly = Assembly::new(&model).map_err(|e| e.to_string())?;
    let mut state = assembly.rest();
    let mut motion = Vec::new();
    for (k, stage) in (0u16..).zip(&made.plan.stages) {
        let phase = Phase::of(&model, &assembly, Stage::Before(k)).map_err(|e| e.to_string())?;
        let mut engine = Engine::new(&model, &assembly, &phase);
        engine.relax(&mut state, &stage.release).map_err(|rest| format!("{rest:?}"))?;
        motion.push(inwards(&model, &state, &points));
    }
    Ok(motion)
}

/// Mean motion of points towards the axis of the tunnel.
fn inwards(model: &Model, state: &State, points: &[[f64; 3]]) -> f64 {
    let toward = [[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]];
    let of = |(point, toward): (&[f64; 3], [f64; 3])| {
        let square = |n: usize| (0..3).map(|i| (model.mesh.nodes[n][i] - point[i]).powi(2)).sum::<f64>();
        let there = (0..model.user.nodes).filter(|&n| model.engine_node[n] != u32::MAX);
        let node = there.min_by(|&a, &b| square(a).total_cmp(&square(b))).unwrap_or(0);
        let u = state.shown(model.engine_node[node] as usize).xyz();
        u[0] * toward[0] + u[2] * toward[2]
    };
    points.iter().zip(toward).map(of).sum::<f64>() / points.len() as f64
}

fn case(placed: Option<usize>, bond: &str) -> String {
    let mut text = r#"title = "ground reaction"
[mesh.caverns]
overburden = "150 m"
below = "40 m"
sides = "40 m"
length = "2 m"
size_near = "0.7 m"
size_far = "12 m"
size_along = "1 m"
[[mesh.caverns.cavern]]
name = "tunnel"
shape = "circle"
width = "8 m"
height = "8 m"
lining = { walls = "0.5 m", crown = "0.5 m", floor = "0.5 m" }
[material.rock]
law = "mohr-coulomb"
young = "2 GPa"
poisson = 0.25
unit_weight = "26 kN/m3"
cohesion = "0.35 MPa"
friction_angle = "32 deg"
tensile_strength = "0.1 MPa"
[[region]]
groups = ["rock", "tunnel.*"]
material = "rock"
element = "reduced-integration"
[initial]
gravity = "9.81 m/s2"
lateral = 1.0
"#
    .to_owned();
    for k in 0..STEPS {
        let share = 1.0 / (STEPS - k) as f64;
        text += &format!("[[stage]]\nname = \"step {}\"\nrelease = {share}\n", k + 1);
        if k == 0 {
            text += "excavate = [\"tunnel.excavation\", \"tunnel.lining\"]\n";
        }
        if placed == Some(k) {
            text += &format!("{}{bond} }}\n", bolts());
        }
    }
    text
}

/// Radial bolts; a pattern bolts what its own stage lays bare, so those that come later are given by their ends.
fn bolts() -> String {
    let each = 25;
    let rows = [0.5, 1.5];
    let ends = rows.iter().flat_map(|y| {
        (0..each).map(move |k| {
            let angle = std::f64::consts::TAU * (f64::from(k) + 0.5) / f64::from(each);
            let at = |r: f64| {
                format!(
                    "[\"{:.6} m\", \"{:.6} m\", \"{:.6} m\"]",
                    r * angle.cos(),
                    y - 1.0,
                    AXIS + r * angle.sin()
                )
            };
            format!("[{}, {}]", at(WALL + 0.05), at(WALL + 4.05))
        })
    });
    let ends: Vec<String> = ends.collect();
    format!("bolts = {{ points = [{}], diameter = \"25 mm\", yield = \"400 MPa\"", ends.join(", "))
}

/// Level of the axis, and radius of the wall of rock \[m\].
const AXIS: f64 = -154.0;
const WALL: f64 = 4.5;

fn draw(all: &[(&str, Vec<f64>)]) -> String {
    let across: Vec<f64> = (0..=STEPS).map(|k| 100.0 * k as f64 / STEPS as f64).collect();
    let curves = all.iter().enumerate().map(|(colour, (name, motion))| Curve {
        name: (*name).into(),
        colour,
        across: across.clone().into(),
        up: motion.iter().map(|m| 1e3 * m).collect::<Vec<_>>().into(),
        points: false,
    });
    Loops {
        title: "Ground reaction of a tunnel of 4.5 m radius: bolts of 4 m, one a square metre".into(),
        along: Quantity::new("", ""),
        time: &[],
        planes: vec![Plane {
            across: Quantity::new("share of the excavation's forces that is let go in %", ""),
            up: Quantity::new("motion into the opening in mm", ""),
            curves: curves.collect(),
            named: Named::Nothing,
        }],
        tracks: vec![],
        states: None,
    }
    .draw()
}
