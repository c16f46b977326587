//! A rough strip footing on weightless clay: Prandtl's load.
//!
//! Perfectly plastic ground with cohesion c and no friction fails under a strip of pressure (2 + π)c
//! (`prandtl1920`), a rough footing or a smooth one. Flow without change of volume in a fan at the edge asks of an element
//! that it neither locks nor lets hourglass patterns carry load.
//!
//! **Model.** One half, half-width b = 1 m, ground 5b wide and 3b deep in plane strain, E = 1000 c. The footing is driven
//! down at a constant speed, so slowly that a wave of it carries 2 % of c. Its load is the mean vertical stress of the lowest
//! layer, averaged over a part of the way. Between the last node that is driven and the next one the footing ends at an unknown
//! place: half an element is added to b.
//!
//! Beyond the limit the load stays, however far the footing is driven (small displacements: the ground does not heave around
//! it). So the way goes on to 0.4 b, where an element whose hourglass stiffness does not vanish as it flows would carry more
//! and more.

use crate::models::{QUADRATURES, Solid, material};
use crate::simulation::Simulation;
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::PI;
use std::sync::Arc;
use tremolite::hexahedra::centroid;
use tremolite::parts::loads::Load;
use tremolite::point_stress::mean;
use tremolite::{Line, Quadrature};
use tremolite_laws::materials::MohrCoulomb;
use tremolite_laws::{Material, Values};
use tremolite_mesh::boxes::BoxSpec;

const NAME: &str = "strip_footing";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "rough strip footing on clay: Prandtl's load, neither locked nor carried by hourglass patterns",
    source: "`prandtl1920`",
    from: Effort::Verify,
    run,
};

const COHESION: f64 = 0.1e6;
/// Speed of the footing \[m/s\].
const SPEED: f64 = 0.004;
/// Way \[m\] of the footing.
const WAY: f64 = 0.4;
/// Steps between two readings of the load.
const EVERY: u64 = 50;
const SOIL: Solid = Solid { young: 1e8, poisson: 0.3, density: 2000.0 };

/// Rise of the load from 0.08–0.12 b to the end that counts as none: what 2×2×2 points of the finer mesh still rise by
/// from the third to the last quarter of the short way.
const RISE: f64 = 0.019;

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let exact = 2.0 + PI;
    let mut checks = Vec::new();
    let n = if effort == Effort::Full { 8 } else { 4 };
    for (quadrature, word) in QUADRATURES {
        let of = |what: &str| format!("{what}, {n} elements a half-width, {word}");
        let found = press(quadrature, n)?;
        let last = found.loads[9];
        let note = "5 %: four elements a half-width give the fan at the edge two elements, eight halve what is left";
        checks.push(Check::new(NAME, of("load over c b at 0.4 b"), last, exact, 0.05 * exact, "1", note));
        let note = "1.9 %: what 2×2×2 points still rise by from 0.03 b to 0.04 b; with a twentieth of the elastic hourglass \
                    stiffness left it rose by 8 %";
        let rise = last / found.loads[2] - 1.0;
        checks.push(Check::new(NAME, of("rise of the load from 0.1 b to 0.4 b"), rise, 0.0, RISE, "1", note));
        if quadrature == Quadrature::OnePoint {
            let note = "for information: with elastic stabilisation it held 8.7 % where the ground flows";
            let quantity = of("energy of the stabilisation over what the ground has dissipated");
            checks.push(Check::beside(NAME, quantity, found.hourglass, 0.0, "1", note));
        }
    }
    Ok(checks)
}

/// What the footing met.
struct Pressed {
    /// Load over c b in each tenth of the way.
    loads: [f64; 10],
    /// Energy of the stabilisation over dissipated energy at the end.
    hourglass: f64,
}

/// Presses the footing into ground of `n` elements a half-width.
fn press(quadrature: Quadrature, n: u32) -> Result<Pressed, VerifyError> {
    let h = 1.0 / f64::from(n);
    let mesh = BoxSpec::uniform([0.0; 3], [5.0, h, 3.0], [5 * n, 1, 3 * n]).mesh()?;
    let values = Values::default()
        .with("young", SOIL.young)
        .with("poisson", SOIL.poisson)
        .with("cohesion", COHESION)
        .with("friction_angle", 0.0)
        .with("dilation_angle", 0.0)
        .with("tensile_strength", 1e9);
    let under = |x: &[f64; 3]| x[2] > 3.0 - 1e-9 && x[0] < 1.0 + 1e-9;
    let footing: Vec<u32> =
        (0u32..).zip(&mesh.nodes).filter(|(_, x)| under(x)).map(|(node, _)| node).collect();
    let held = (0u32..).zip(&mesh.nodes).map(|(node, x)| {
        let side = x[0] < 1e-9 || x[0] > 5.0 - 1e-9;
        let base = x[2] < 1e-9;
        (node, [side || base || under(x), true, base || under(x)])
    });
    let held: Vec<(u32, [bool; 3])> = held.collect();
    let mut problem = SOIL.fill(mesh, quadrature);
    problem.bodies[0].material = material(MohrCoulomb::NAME, &values)?;
    problem.held = held;
    // The footing's motion is given; the load on it books the work that moves it.
    let share = -5.14 * COHESION * h / footing.len() as f64;
    problem.loads = vec![Load {
        forces: footing.iter().map(|&n| (n, [0.0, 0.0, share])).collect(),
        factor: Arc::new(|_| 1.0),
    }];
    let simulation = Simulation::on_one_level(problem)?;
    let dt = 0.9 * simulation.stable();
    let steps = (WAY / SPEED / dt) as u64;
    let mut engine = simulation.engine();
    let driven: Vec<bool> =
        (0..simulation.model.mesh_node.len()).map(|n| under(&simulation.position(n))).collect();
    let mut state = simulation
        .start(&mut engine, dt, |n| [[0.0; 3], if driven[n] { [0.0, 0.0, -SPEED] } else { [0.0; 3] }]);
    let elements = 0..simulation.model.mesh.elements.len();
    let lowest: Vec<_> = elements
        .filter(|&e| centroid(&simulation.model.mesh, e as u32)[2] < h)
        .filter_map(|e| simulation.phase.element_slot[e])
        .collect();
    let (mut sums, mut counts) = ([0.0; 10], [0.0; 10]);
    for step in 0..steps {
        if step % EVERY == 0 {
            let snapshot = engine.look(&state).snapshot;
            let stress = lowest.iter().map(|slot| {
                let first = slot.point as usize;
                mean(&slot.places, &snapshot.stress[first..first + slot.points as usize])[2]
            });
            let part = (10 * step / steps) as usize;
            sums[part] -= stress.sum::<f64>() * h / (COHESION * (1.0 + 0.5 * h));
            counts[part] += 1.0;
        }
        engine.step(&mut state);
    }
    let balance = engine.look(&state).snapshot.balance;
    Ok(Pressed {
        loads: std::array::from_fn(|k| sums[k] / counts[k]),
        hourglass: balance[Line::Hourglass] / balance[Line::Dissipated],
    })
}
