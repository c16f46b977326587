//! A model and its mirror image move as mirror images, whatever base and sides they have.
//!
//! Four kinds of uneven ground: a surface that slopes 20°, a contact between two rocks that dips through base and sides and may
//! slide, a soft half beside a hard one, and two rocks that meet in a vertical edge of the model itself. Each is run as it is and
//! reflected in x, with every base and every kind of sides that the model can have; what cannot be built must be refused in both.

use tremolite::Domain;
use crate::joints::joint;
use crate::models::Solid;
use crate::simulation::{Simulation, whole_steps};
use crate::{Check, Effort, Verification, VerifyError};
use std::collections::BTreeMap;
use tremolite::hexahedra::centroid;
use tremolite::{Base, Incident, Model, Quadrature, Side, Top};
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::{Element, Mesh, Shape};
use tremolite_motion::{Motion, ricker_velocity};

const NAME: &str = "mirror_image";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "uneven ground and its mirror image move alike, with every base and every kind of sides",
    source: "reflection in x",
    from: Effort::Test,
    run,
};

/// m, and elements.
const SIZE: [f64; 3] = [12.0, 8.0, 8.0];
const ELEMENTS: [u32; 3] = [6, 4, 4];
const SOFT: Solid = Solid { young: 0.5e9, poisson: 0.3, density: 2000.0 };
const HARD: Solid = Solid { young: 4e9, poisson: 0.2, density: 2600.0 };
/// Of the pulse: peak frequency \[Hz\], centre and end \[s\], peak \[m/s\], and its direction.
const PULSE: [f64; 4] = [25.0, 0.05, 0.1, 0.05];
const ALONG: [f64; 3] = [0.6, 0.48, 0.64];

#[derive(Clone, Copy, Debug, PartialEq)]
enum Uneven {
    Slope,
    DippingContact,
    Halves,
    SharedEdge,
}

const ALL: [(Uneven, &str); 4] = [
    (Uneven::Slope, "a slope of 20 degrees"),
    (Uneven::DippingContact, "a dipping contact"),
    (Uneven::Halves, "soft and hard halves"),
    (Uneven::SharedEdge, "two rocks at a vertical edge"),
];

const BASES: [(Base, &str); 2] = [
    (Base::Viscous, "viscous base"),
    (Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(8.0) }, "viscous-spring base"),
];

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for (uneven, word) in ALL {
        let (mut worst, mut ran, mut refused, mut unlike) = (0.0_f64, 0, 0, 0);
        let mut where_worst = String::new();
        for (base, base_word) in BASES {
            for side in Side::EXAMPLES {
                let problems = [false, true].map(|mirrored| problem(uneven, base, side, mirrored));
                let [plain, mirrored] = problems;
                let (plain, mirrored) = (plain?, mirrored?);
                let built = [Model::new(plain.clone()), Model::new(mirrored.clone())].map(|m| m.is_ok());
                let built = built.map(|ok| ok && !(side == Side::Periodic && uneven == Uneven::Slope));
                match built {
                    [true, true] => {
                        let apart = apart(plain, mirrored)?;
                        // Of what is no number nothing is less.
                        if apart.is_nan() || apart > worst {
                            worst = apart;
                            where_worst = format!("{base_word}, {side:?} sides");
                        }
                        ran += 1;
                    }
                    [false, false] => refused += 1,
                    _ => unlike += 1,
                }
            }
        }
        let note = format!(
            "1e-10: round-off, with which contacts slide a little earlier or later; the worst with {where_worst}"
        );
        let quantity = format!("difference from the mirror image over the peak, {word}");
        checks.push(Check::new(NAME, quantity, worst, 0.0, 1e-10, "1", note));
        let note = "what is refused must be refused in both; a slope has no periodic sides, and two rocks at an edge have no \
                    reference column for springs";
        let quantity = format!("refused in one of the two alone, {word}");
        checks.push(Check::new(NAME, quantity, f64::from(unlike), 0.0, 0.0, "1", note));
        let quantity = format!("bases and sides that were run, {word}");
        checks.push(Check::new(NAME, quantity, f64::from(ran), 12.0 - f64::from(refused), 0.0, "1", note));
    }
    Ok(checks)
}

/// The problem of uneven ground, or that of its mirror image.
fn problem(uneven: Uneven, base: Base, side: Side, mirrored: bool) -> Result<tremolite::Problem, VerifyError> {
    let mut mesh = BoxSpec::uniform([0.0; 3], SIZE, ELEMENTS).mesh()?;
    if uneven == Uneven::Slope {
        let rise = 20f64.to_radians().tan();
        for node in &mut mesh.nodes {
            node[2] *= 1.0 + rise * (node[0] - 0.5 * SIZE[0]) / SIZE[2];
        }
    }
    if uneven == Uneven::DippingContact {
        // Planes of x = constant lean over; the outer ones stay.
        for node in &mut mesh.nodes {
            let shape = 1.0 - (2.0 * node[0] / SIZE[0] - 1.0).powi(2);
            node[0] += 0.2 * (node[2] - 0.5 * SIZE[2]) * shape;
        }
    }
    if uneven == Uneven::SharedEdge {
        mesh.elements = mesh.elements.iter().flat_map(wedges).collect();
    }
    let soft = |e: u32| match uneven {
        Uneven::Slope => centroid(&mesh, e)[2] > 0.6 * SIZE[2],
        Uneven::DippingContact | Uneven::Halves => {
            // Half of the rows along x, which lean in the one case.
            (e % ELEMENTS[0]) < ELEMENTS[0] / 2
        }
        Uneven::SharedEdge => e.is_multiple_of(2),
    };
    let (own, other): (Vec<u32>, Vec<u32>) = (0..mesh.elements.len() as u32).partition(|&e| soft(e));
    let bodies = vec![
        SOFT.body("soft", own.clone(), Quadrature::OnePoint),
        HARD.body("hard", other.clone(), Quadrature::Full),
    ];
    if mirrored {
        reflect(&mut mesh);
    }
    let mut problem = tremolite::Problem::new(mesh, bodies);
    if uneven == Uneven::DippingContact {
        let numbers = [("normal_stiffness", 2e9), ("max_closure", 1e-3), ("cohesion", 1e3), ("friction_coefficient", 0.4)];
        problem.interfaces = vec![joint([own, other], "bandis", &numbers, &[])?];
    }
    problem.base = base;
    problem.sides = [side; 2];
    problem.top = if side == Side::FreeField && uneven == Uneven::Halves { Top::Viscous } else { Top::Free };
    let [frequency, centre, end, peak] = PULSE;
    let pulse = ricker_velocity(frequency, centre, peak);
    let along = if mirrored { [-ALONG[0], ALONG[1], ALONG[2]] } else { ALONG };
    let motion = Motion::sampled(2e-4, end, |t| pulse(t).along(along))?;
    problem.incident = Some(Incident { motion, factor: 1.0 });
    Ok(problem)
}

/// The two wedges of a brick, cut through the corners 0 and 2.
fn wedges(brick: &Element) -> Vec<Element> {
    let n = brick.nodes();
    let wedge = |k: [usize; 6]| Element::new(Shape::Wedge6, &k.map(|k| n[k]));
    vec![wedge([0, 1, 2, 4, 5, 6]), wedge([0, 2, 3, 4, 6, 7])]
}

fn reflect(mesh: &mut Mesh) {
    for node in &mut mesh.nodes {
        node[0] = SIZE[0] - node[0];
    }
    for element in &mut mesh.elements {
        let n = element.nodes().to_vec();
        // The last corner of a triangle is the one that is doubled in the hexahedron: it stays the last.
        let order: &[usize] = if n.len() == 8 { &[1, 0, 3, 2, 5, 4, 7, 6] } else { &[1, 0, 2, 4, 3, 5] };
        *element = Element::new(element.shape, &order.iter().map(|&k| n[k]).collect::<Vec<_>>());
    }
}

/// Largest difference of displacements from those of the mirror image, over the peak.
fn apart(plain: tremolite::Problem, mirrored: tremolite::Problem) -> Result<f64, VerifyError> {
    let [a, b] = [Simulation::new(plain)?, Simulation::new(mirrored)?];
    let stable = |s: &Simulation| s.bound().to_run(0.9);
    let (steps, dt) = whole_steps(PULSE[2], stable(&a).min(stable(&b)));
    let rows = [shake(&a, dt, steps, 1.0)?, shake(&b, dt, steps, -1.0)?];
    let mut peak = 0.0_f64;
    let mut worst = 0.0_f64;
    for (place, one) in &rows[0] {
        let Some(other) = rows[1].get(place) else { return Ok(f64::NAN) };
        for (x, y) in one.iter().zip(other) {
            peak = peak.max(x.abs());
            let d = (x - y).abs();
            worst = if d <= worst { worst } else { d };
        }
    }
    Ok(worst / peak)
}

/// Displacements over all rows by the node of the mesh, x counted along `sense`.
fn shake(simulation: &Simulation, dt: f64, steps: u64, sense: f64) -> Result<BTreeMap<u32, Vec<f64>>, VerifyError> {
    let mut rows: BTreeMap<u32, Vec<f64>> = BTreeMap::new();
    let model = &simulation.model;
    simulation.run_from_rest(dt, steps, |state| {
        if state.step.is_multiple_of(10) {
            for n in model.nodes.of(Domain::Model) {
                let [x, y, z] = state.u[n].xyz();
                rows.entry(model.mesh_node[n]).or_default().extend([sense * x, y, z]);
            }
        }
    })?;
    Ok(rows)
}
