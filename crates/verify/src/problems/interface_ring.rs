//! A lining in a hole, pressed outwards, and turned.
//!
//! Two thick cylinders, radii a, b and b, c, in plane strain, touch at b through Bandis' joint; the pressure P acts within. With p
//! at the joint Lamé's displacements are (1 + ν)/E \[(1 − 2ν) A r + B/r\], A = (Pa² − pb²)/(b² − a²) and
//! B = (P − p)a²b²/(b² − a²) of the lining, A = pb²/(c² − b²) and B = pb²c²/(c² − b²) of the rock, and the joint closes by their
//! difference, p/(k_n0 + p/T): one equation for p.
//!
//! Then the lining is turned about its axis without friction, by a tenth of the largest element: as an initial displacement φ×r,
//! small rotations being those of the model. Pressures may not change. The mesh is graded around, so that a node's normal, that
//! of the chord between its neighbours, leans by ¼ of the difference of the two elements' angles, of order 2, and sliding along
//! the circle opens and closes pairs by that much of the slip; the pressure it would make is what is looked for. What goes as
//! the sine of the angle moves the lining as a whole and makes none.

use crate::convergence::order;
use crate::joints::joint;
use crate::models::Solid;
use crate::simulation::Simulation;
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::PI;
use std::sync::Arc;
use tremolite::parts::loads::Load;
use tremolite::{Line, Quadrature, Rayleigh};
use tremolite_mesh::Mesh;
use tremolite_mesh::boxes::{Axis, BoxSpec};
use tremolite_mesh::topology::vector_areas;

const NAME: &str = "interface_ring";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a lining pressed against its hole, in a graded mesh: Lamé's pressure at the joint, even after the lining has turned",
    source: "Lamé's thick cylinders with a joint between them",
    from: Effort::Test,
    run,
};

/// a, b, c \[m\]
const RADII: [f64; 3] = [3.0, 3.5, 7.0];
const LINING: Solid = Solid { young: 25e9, poisson: 0.2, density: 2400.0 };
const ROCK: Solid = Solid { young: 5e9, poisson: 0.25, density: 2600.0 };
/// P \[Pa\]
const PRESSURE: f64 = 2e6;
/// k_n0 \[Pa/m\] and T \[m\]
const STIFFNESS: f64 = 20e9;
const CLOSURE: f64 = 1e-3;
/// The lining is turned by this share of its largest element.
const TURN: f64 = 0.1;
/// Share by which an element's angle is larger or smaller than the mean: the angle is s + `GRADING` sin s, s even.
const GRADING: f64 = 0.3;

/// p \[Pa\]: bisection between 0 and P, as the lining's part falls and the rock's and the joint's rise.
fn exact() -> f64 {
    let [a, b, c] = RADII.map(|r| r * r);
    let displacement = |solid: Solid, slope: f64, bend: f64| {
        let r = RADII[1];
        (1.0 + solid.poisson) / solid.young * ((1.0 - 2.0 * solid.poisson) * slope * r + bend / r)
    };
    let overlap = |p: f64| {
        let lining = displacement(LINING, (PRESSURE * a - p * b) / (b - a), (PRESSURE - p) * a * b / (b - a));
        let rock = displacement(ROCK, p * b / (c - b), p * b * c / (c - b));
        lining - rock - p / (STIFFNESS + p / CLOSURE)
    };
    let (mut low, mut high) = (0.0, PRESSURE);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if overlap(middle) > 0.0 { low = middle } else { high = middle }
    }
    low
}

/// The rings, `around` elements around.
fn rings(around: u32) -> Result<Mesh, VerifyError> {
    let [a, b, c] = RADII;
    let thick = around / 18;
    let mut radii: Vec<f64> = (0..=thick).map(|i| a + (b - a) * f64::from(i) / f64::from(thick)).collect();
    // Rock grows with r.
    let rows = (f64::from(around) / (2.0 * PI) * (c / b).ln()).round() as u32;
    radii.extend((1..=rows).map(|i| b * (c / b).powf(f64::from(i) / f64::from(rows))));
    let columns = radii.len() as u32;
    let mut mesh = BoxSpec {
        x: Axis::Coordinates(radii),
        y: Axis::uniform(0.0, 2.0 * PI, around),
        z: Axis::uniform(0.0, 0.3, 1),
        distortion: None,
    }
    .mesh()?;
    for x in &mut mesh.nodes {
        let (sine, cosine) = (x[1] + GRADING * x[1].sin()).sin_cos();
        *x = [x[0] * cosine, x[0] * sine, x[2]];
    }
    // The last nodes around are the first.
    let layer = columns * (around + 1);
    for element in &mut mesh.elements {
        for node in &mut element.nodes {
            if *node % layer >= columns * around {
                *node -= columns * around;
            }
        }
    }
    Ok(mesh)
}

/// Pressures at the pairs of a ring that was turned by a share of its largest element and has come to rest: the mean over P,
/// and the largest distance from it over it; kinetic over strain energy, and the least slip over the element.
struct Pressed {
    mean: f64,
    scatter: f64,
    kinetic: f64,
    slip: f64,
}

fn press(around: u32, turn: f64) -> Result<Pressed, VerifyError> {
    let mesh = rings(around)?;
    let radius = |e: u32| {
        let x = tremolite::hexahedra::centroid(&mesh, e);
        x[0].hypot(x[1])
    };
    let (lining, rock): (Vec<u32>, Vec<u32>) =
        (0..mesh.elements.len() as u32).partition(|&e| radius(e) < RADII[1]);
    let mut used = vec![false; mesh.nodes.len()];
    mesh.elements.iter().flat_map(|e| e.nodes).for_each(|n| used[n as usize] = true);
    // About that at which the rock breathes.
    let frequency = 1.5 * ROCK.speeds().0 / RADII[2];
    let (grow, end) = (10.0 / frequency, 20.0 / frequency);
    let areas = vector_areas(&mesh, &mesh.faces["xmin"]);
    let forces = areas.iter().map(|(&n, a)| (n, a.map(|a| -PRESSURE * a))).collect();
    let interface = joint(
        [lining.clone(), rock.clone()],
        "bandis",
        &[("normal_stiffness", STIFFNESS), ("max_closure", CLOSURE), ("friction_coefficient", 0.0)],
        &[],
    )?;
    let mut problem = tremolite::Problem::new(
        mesh,
        vec![
            LINING.body("lining", lining.clone(), Quadrature::Full),
            ROCK.body("rock", rock, Quadrature::OnePoint),
        ],
    );
    problem.interfaces = vec![interface];
    problem.held = (0..).zip(used).filter(|(_, used)| *used).map(|(n, _)| (n, [false, false, true])).collect();
    problem.rayleigh = Rayleigh { mass: 2.0 * frequency, stiffness: 0.0 };
    let factor = move |t: f64| 0.5 - 0.5 * (PI * (t / grow).min(1.0)).cos();
    problem.loads = vec![Load { forces, factor: Arc::new(factor) }];
    let simulation = Simulation::new(problem)?;
    let model = &simulation.model;
    let mut own = vec![false; model.mesh_node.len()];
    for &e in &lining {
        for &n in model.mesh.elements[e as usize].nodes() {
            own[model.engine_node[n as usize] as usize] = true;
        }
    }
    let largest = 2.0 * PI / f64::from(around) * (1.0 + GRADING);
    let angle = turn * largest;
    let dt = simulation.bound().to_run(0.9);
    let mut engine = simulation.engine();
    let mut state = simulation.start(&mut engine, dt, |n| {
        let x = simulation.position(n);
        [if own[n] { [-angle * x[1], angle * x[0], 0.0] } else { [0.0; 3] }, [0.0; 3]]
    });
    while state.time() < end {
        engine.step(&mut state);
    }
    let snapshot = engine.finish(&mut state);
    let (seam, contacts) = (&model.seams[0], &simulation.assembly.contacts[0]);
    let (mut force, mut slip) = (0.0, f64::INFINITY);
    let seen: Vec<_> =
        (0..seam.pairs.len()).map(|k| contacts.seen(&state.history, k)).collect();
    for (pair, seen) in seam.pairs.iter().zip(&seen) {
        force += pair.normal_area * seen.pressure;
        slip = f64::min(slip, seen.slip[0].hypot(seen.slip[1]) / (largest * RADII[1]));
    }
    let mean = force / seam.pairs.iter().map(|pair| pair.normal_area).sum::<f64>();
    let scatter = seen.iter().map(|seen| (seen.pressure / mean - 1.0).abs()).fold(0.0, f64::max);
    let kinetic = snapshot.balance[Line::Kinetic] / snapshot.balance[Line::Strain];
    Ok(Pressed { mean, scatter, kinetic, slip })
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let exact = exact();
    let [coarse, fine] = [36, 72].map(|around| press(around, 0.0));
    let [coarse_turned, turned] = [36, 72].map(|around| press(around, TURN));
    let (coarse, fine, coarse_turned, turned) = (coarse?, fine?, coarse_turned?, turned?);
    let mut checks = Vec::new();
    let near = (2.0 * PI / 72.0_f64).powi(2) / 4.0;
    let p = order(coarse.mean - exact, fine.mean - exact, 2.0);
    let note = "(h/r)²/4, 0.2 %: the polygon's area is short by (h/r)²/6, strains of its elements err by a (h/r)²/12";
    checks.push(
        Check::new(NAME, "mean pressure at the joint", fine.mean, exact, near * exact, "Pa", note).with_order(p),
    );
    let note = "order 2 of displacements";
    checks.push(Check::new(NAME, "order in h of the mean pressure", p, 2.0, 0.2, "1", note).with_order(p));
    let note = "1e-4: even but for the growth of elements";
    checks.push(Check::new(NAME, "scatter of pressure over the mean", fine.scatter, 0.0, 1e-4, "1", note));
    let note = "2 % at a tenth of an element, and falling: normals lean by order 2, over slips of order 1";
    let quantity = "scatter of pressure over the mean, turned by a tenth of the largest element";
    let p = order(coarse_turned.scatter, turned.scatter, 2.0);
    checks.push(Check::new(NAME, quantity, turned.scatter, 0.0, 0.02, "1", note).with_order(p));
    let note = "3: lean times slip";
    checks.push(Check::new(NAME, "order in h of that scatter", p, 3.0, 0.3, "1", note).with_order(p));
    let quantity = "change of the mean pressure by the turn over it";
    let note = "the scatter: the mean changes by less than its parts";
    checks.push(Check::new(NAME, quantity, turned.mean / fine.mean - 1.0, 0.0, turned.scatter, "1", note));
    let quantity = "least slip over the largest element";
    let note = "1 %: what relaxing moves, and what the leaning normals leave of it";
    checks.push(Check::new(NAME, quantity, turned.slip, TURN, 0.01 * TURN, "1", note));
    let quantity = "kinetic over strain energy at the end";
    let note = "1e-7: pressures swing by less than its root, 3e-4";
    checks.push(Check::new(NAME, quantity, fine.kinetic.max(turned.kinetic), 0.0, 1e-7, "1", note));
    Ok(checks)
}
