//! A block that slides on a plane cut through a mesh of bricks, whatever its strike.
//!
//! A cube of bricks is cut by a plane ([`tremolite_mesh::cut`]): one of any strike, which divides bricks into pyramids, wedges and
//! tetrahedra, and one that strikes along y. What lies below is held, what lies above is elastic and slides under its weight on a joint
//! without cohesion: its centre of mass goes down the dip with g(sin δ − μ cos δ), and not along the strike. So normals and areas of all
//! pairs are tried, of pieces of every kind: were one of ten off by ten degrees, the acceleration would be off by some per cent.
//!
//! **Model.** Weight comes over a tenth of a second and the slope's share of it behind that, both without a kink, since a block that rings slides further:
//! friction follows the pressure, and what swings aside takes a part of it. Put on at once the block slid by 1 to 4 % faster.
//!
//! **Errors.** The acceleration is the slope of a straight line through the velocity of the centre of mass over the last 0.2 s, when all
//! pairs slide; it is off by what rings still.

use crate::joints::{joint, together};
use crate::models::Solid;
use crate::simulation::{Simulation, whole_steps};
use crate::{Check, Effort, Verification, VerifyError};
use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::sync::Arc;
use tremolite::parts::loads::Load;
use tremolite::{Problem, Quadrature};
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::cut::{Bounds, Cut, cut};
use tremolite_mesh::plane::Plane;
use tremolite_mesh::{Element, Mesh};

const NAME: &str = "oblique_joint";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a block slides on a plane cut through bricks: g(sin δ − μ cos δ) down the dip, whatever the strike, mesh and step",
    source: "the rigid block on an inclined plane",
    from: Effort::Test,
    run,
};

const GRAVITY: f64 = 9.81;
const ROCK: Solid = Solid { young: 0.5e9, poisson: 0.2, density: 2500.0 };
const STIFFNESS: f64 = 2e9;
const FRICTION: f64 = 0.3;
/// Half the cube's side \[m\].
const HALF: f64 = 3.0;
/// Times between which the acceleration is taken \[s\].
const FROM: f64 = 0.3;
const END: f64 = 0.5;
/// In which the weight comes across the joint, and as long behind that along it \[s\].
const RISE: f64 = 0.1;
/// Dip and dip direction \[°\].
const PLANES: [[f64; 2]; 3] = [[30.0, 60.0], [25.0, 200.0], [35.0, 90.0]];

/// What is made of some elements of a mesh, with the nodes that they have.
fn part(mesh: &Mesh, elements: &[u32]) -> Mesh {
    let mut number: BTreeMap<u32, u32> = BTreeMap::new();
    let mut made = Mesh::default();
    for &e in elements {
        let element = mesh.elements[e as usize];
        let nodes: Vec<u32> = element
            .nodes()
            .iter()
            .map(|&n| {
                *number.entry(n).or_insert_with(|| {
                    made.nodes.push(mesh.nodes[n as usize]);
                    made.nodes.len() as u32 - 1
                })
            })
            .collect();
        made.elements.push(Element::new(element.shape, &nodes));
    }
    made
}

/// The cube with the plane through its middle, the part above behind the one below; how many elements and nodes lie below.
fn parted(plane: Plane, divide: u32) -> Result<(Mesh, u32, u32), VerifyError> {
    let count = 6 * divide;
    let mut mesh = BoxSpec::uniform([-HALF; 3], [HALF; 3], [count; 3]).mesh()?;
    let bounds = Bounds { free: [true; 2], ..Bounds::default() };
    cut(&mut mesh, &[Cut::through("joint", plane)], &bounds)
        .map_err(|e| VerifyError::Setup(e.to_string()))?;
    let below = part(&mesh, &mesh.groups["joint.below"]);
    let above = part(&mesh, &mesh.groups["joint.above"]);
    Ok((together(&below, &above), below.elements.len() as u32, below.nodes.len() as u32))
}

/// Accelerations of the block's centre of mass down the dip and along the strike \[m/s²\]; `step` is a share of the step allowed.
fn slide([dip, direction]: [f64; 2], divide: u32, step: f64) -> Result<[f64; 2], VerifyError> {
    let plane = Plane::dipping([0.1, 0.2, -0.1], dip.to_radians(), direction.to_radians());
    let (mesh, elements, nodes) = parted(plane, divide)?;
    let all = mesh.elements.len() as u32;
    let numbers = [("normal_stiffness", STIFFNESS), ("friction_coefficient", FRICTION)];
    let mut problem: Problem = ROCK.fill(mesh, Quadrature::OnePoint);
    problem.interfaces = vec![joint([(0..elements).collect(), (elements..all).collect()], "coulomb", &numbers, &[])?];
    problem.held = (0..nodes).map(|n| (n, [true; 3])).collect();
    let trial = Simulation::new(problem.clone())?;
    let mass = |n: u32| 1.0 / trial.phase.inverse_mass[trial.model.engine_node[n as usize] as usize].0[2];
    let masses: Vec<(u32, f64)> =
        (nodes..problem.mesh.nodes.len() as u32).map(|n| (n, mass(n))).collect();
    let total: f64 = masses.iter().map(|(_, m)| m).sum();
    let most = step * trial.bound().to_run(0.9);
    let (_, dt) = whole_steps(END, most);
    let normal = plane.normal;
    let (sine, cosine) = dip.to_radians().sin_cos();
    let (east, north) = direction.to_radians().sin_cos();
    let [down, strike] = [[east * cosine, north * cosine, -sine], [north, -east, 0.0]];
    let weight = |size: f64, way: [f64; 3]| masses.iter().map(|&(n, m)| (n, way.map(|w| m * size * w))).collect();
    let rise = |t: f64| 0.5 - 0.5 * (PI * (t / RISE).clamp(0.0, 1.0)).cos();
    problem.loads = vec![
        Load { forces: weight(-GRAVITY * cosine, normal), factor: Arc::new(rise) },
        Load { forces: weight(GRAVITY * sine, down), factor: Arc::new(move |t| rise(t - RISE)) },
    ];
    let simulation = Simulation::new(problem)?;
    let mut engine = simulation.engine();
    let mut state = simulation.start(&mut engine, dt, |_| [[0.0; 3]; 2]);
    let speed = |along: [f64; 3], state: &tremolite::State| -> f64 {
        let sum = masses.iter().map(|&(n, m)| {
            let (v, _) = simulation.velocity(state, simulation.model.engine_node[n as usize] as usize);
            m * (0..3).map(|i| v[i] * along[i]).sum::<f64>()
        });
        sum.sum::<f64>() / total
    };
    let mut seen: Vec<(f64, [f64; 2])> = Vec::new();
    while state.time() < END - 0.5 * dt {
        engine.step(&mut state);
        // Velocities are those half a step before.
        let t = state.time() - 0.5 * dt;
        if t > FROM {
            seen.push((t, [down, strike].map(|along| speed(along, &state))));
        }
    }
    // Straight lines by least squares.
    let middle = seen.iter().map(|(t, _)| t).sum::<f64>() / seen.len() as f64;
    let square: f64 = seen.iter().map(|(t, _)| (t - middle).powi(2)).sum();
    Ok([0, 1].map(|i| seen.iter().map(|(t, v)| (t - middle) * v[i]).sum::<f64>() / square))
}

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for (k, plane) in PLANES.into_iter().enumerate() {
        let [dip, direction] = plane;
        let (sine, cosine) = dip.to_radians().sin_cos();
        let exact = GRAVITY * (sine - FRICTION * cosine);
        // The first plane stands for all where the mesh is finer and the step shorter.
        let mut variants = vec![(1, 1.0, "bricks of 1 m")];
        if k == 0 || effort == Effort::Full {
            variants.push((1, 0.5, "bricks of 1 m, half the step"));
        }
        if effort == Effort::Full || k == 0 && effort == Effort::Verify {
            variants.push((2, 1.0, "bricks of 0.5 m"));
        }
        for (divide, step, words) in variants {
            let [down, strike] = slide(plane, divide, step)?;
            let of = format!("dip {dip}°, dip direction {direction}°, {words}");
            let note = "0.5 %: what rings still, a tenth of it here";
            checks.push(Check::new(NAME, format!("acceleration down the dip, {of}"), down, exact, 0.005 * exact, "m/s2", note));
            let note = "as much of the acceleration down the dip";
            checks.push(Check::new(NAME, format!("along the strike, {of}"), strike, 0.0, 0.005 * exact, "m/s2", note));
        }
    }
    Ok(checks)
}
