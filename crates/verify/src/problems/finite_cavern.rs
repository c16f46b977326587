//! Caverns of finite length: the longer one is, the more its middle moves as the section does in plane strain.
//!
//! A round cavern of the generator, unlined, is excavated at once from elastic rock under equal pressure from all sides, with
//! lengths of 1, 2, 4 and 8 widths w, and one that goes through the block. What the rock beyond an end keeps back is, seen from far,
//! a line of sources that are missing: the motion at a distance y from one falls as 1/y³ across the line, so what is missing in the
//! middle falls as ∫ dy/y³, with (w/L)², in unbounded rock. At one width the ends are too near for that; at eight widths what is left
//! is no more than what the block's faces do (in a block of 7 w by 7 w by 16 w it was 0.6 % instead of 0.4 %).
//!
//! **Model.** A block of 17 w by 17 w by 32 w, all faces rollers. All caverns have one section, and the difference at y = 0 is taken
//! node by node around the wall, so that the mesh across does not err in it; along y there are two elements a width.

use crate::convergence::order;
use crate::models::Solid;
use crate::staged::{Rested, UNTIL_CHANGE};
use crate::{Check, Effort, Verification, VerifyError};
use std::collections::BTreeMap;
use tremolite::engine::Release;
use tremolite::{Life, Quadrature};
use tremolite_mesh::Mesh;
use tremolite_mesh::cavern::{Cavern, CavernShape, CavernSpec};

const NAME: &str = "finite_cavern";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "an unlined cavern of finite length excavated in elastic rock: its middle tends to plane strain as it grows longer",
    source: "the same section going through; the decay of a missing line of sources",
    from: Effort::Verify,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
/// Pressure \[Pa\], width \[m\].
const PRESSURE: f64 = 5e6;
const WIDTH: f64 = 8.0;
/// Lengths and the block's, in widths.
const LENGTHS: [f64; 4] = [1.0, 2.0, 4.0, 8.0];
const BLOCK: f64 = 32.0;
/// Above, below and beside the cavern, in widths.
const ROCK_AROUND: f64 = 8.0;

/// Motion of the wall at y = 0 by place (bits of x and z): inwards, and along y \[m\].
type Wall = BTreeMap<[u64; 2], [f64; 2]>;

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let through = opened(None)?;
    let mean = through.values().map(|u| u[0]).sum::<f64>() / through.len() as f64;
    let mut checks = Vec::new();
    let mut before = None;
    for length in LENGTHS {
        let wall = opened(Some(length * WIDTH))?;
        if !wall.keys().eq(through.keys()) {
            return Err(VerifyError::Setup("the sections differ".into()));
        }
        let less = wall.iter().map(|(at, u)| (through[at][0] - u[0]).abs() / mean).fold(0.0, f64::max);
        let across = wall.values().map(|u| u[1].abs() / mean).fold(0.0, f64::max);
        let of = |what: &str| format!("{what}, L = {length} w");
        let note = "the wall's largest lag behind plane strain over its mean motion";
        checks.push(Check::beside(NAME, of("lag of the middle"), less, 0.0, "1", note));
        let note = "1e-9: round-off, as y = 0 is a plane of symmetry to the last bit";
        checks.push(Check::new(NAME, of("motion along y in the middle"), across, 0.0, 1e-9, "1", note));
        if let Some(before) = before {
            let ratio: f64 = less / before;
            let note = "a quarter by order 2, and less than a half: order 1 at least";
            checks.push(Check::new(NAME, of("lag over that of half the length"), ratio, 0.25, 0.25, "1", note));
            let quantity = of("order of the lag in 1/L from half the length");
            let order = order(before, less, 2.0);
            checks.push(if length == 4.0 {
                let note = "0.3: a next term of (w/L)² of the first takes log₂(1.25/1.06) = 0.24 from 2 to 4 widths";
                Check::new(NAME, quantity, order, 2.0, 0.3, "1", note).with_order(order)
            } else {
                let note = "near the ends, or where the block's faces do as much";
                Check::beside(NAME, quantity, order, 2.0, "1", note)
            });
        }
        before = Some(less);
    }
    Ok(checks)
}

fn section(length: Option<f64>) -> Result<Mesh, VerifyError> {
    let shape = CavernShape::Circle;
    let cavern =
        Cavern { name: "c".into(), shape, width: WIDTH, height: WIDTH, benches: 1, length, ..Cavern::default() };
    let spec = CavernSpec {
        overburden: ROCK_AROUND * WIDTH,
        below: ROCK_AROUND * WIDTH,
        sides: ROCK_AROUND * WIDTH,
        // One that goes through is alike all along.
        length: if length.is_some() { BLOCK * WIDTH } else { WIDTH },
        near: WIDTH / 4.0,
        far: 2.0 * WIDTH,
        along: Some(WIDTH / 2.0),
        caverns: vec![cavern],
        ..CavernSpec::default()
    };
    spec.mesh().map_err(|e| VerifyError::Setup(e.to_string()))
}

fn opened(length: Option<f64>) -> Result<Wall, VerifyError> {
    let mesh = section(length)?;
    let all = (0..mesh.elements.len() as u32).collect();
    let mut problem = tremolite::Problem::new(mesh, vec![ROCK.body("rock", all, Quadrature::OnePoint)]);
    let mesh = &problem.mesh;
    problem.lives = vec![Life::ALWAYS; mesh.elements.len()];
    for &e in &mesh.groups["c.excavation"] {
        problem.lives[e as usize] = UNTIL_CHANGE;
    }
    problem.initial = vec![[-PRESSURE, -PRESSURE, -PRESSURE, 0.0, 0.0, 0.0]; mesh.elements.len()];
    // The base and the sides are held before the shaking.
    let nodes = (0..).zip(&mesh.nodes);
    problem.held = nodes.filter(|(_, x)| x[2] == 0.0).map(|(n, _)| (n, [false, false, true])).collect();
    let faces = mesh.faces["c.intrados"].clone();
    let release = Release { share: 1.0, tolerance: [1e-6, 1e-5], most: 20_000, ..Release::default() };
    let rested = Rested::new(problem, &[release, release])?;
    let mesh = &rested.model.mesh;
    let middle = [0.0, -(ROCK_AROUND + 0.5) * WIDTH];
    let mut wall = Wall::new();
    for node in faces.iter().flat_map(|&face| mesh.face_nodes(face)) {
        let x = mesh.nodes[node as usize];
        if x[1] == 0.0 {
            let away = [x[0] - middle[0], x[2] - middle[1]];
            let u = rested.shown(node);
            let inwards = -(u[0] * away[0] + u[2] * away[1]) / away[0].hypot(away[1]);
            wall.insert([x[0].to_bits(), x[2].to_bits()], [inwards, u[1]]);
        }
    }
    Ok(wall)
}
