//! A round hole, excavated from an elastic block under two different principal stresses.
//!
//! Kirsch's solution (`michell`) with compressions of 4.32 and 5.4 MPa, in plane strain: at the wall σ_θ = 11.88 MPa
//! beside and 7.56 MPa above, and it moves in by 2.36 and 3.71 mm.
//!
//! **Model.** A quarter of the block out to 5a, its core included, begins with the stress from far away, held by the same tractions
//! on its outer edge; so nothing moves. Then the core is excavated, and the edge gets the tractions of the exact solution there: only
//! the mesh errs. Rings grow with r. Stress at the wall is that of the first three rings' centres, extrapolated by a
//! parabola in r.

use crate::convergence::order;
use crate::michell::Opening;
use crate::models::{QUADRATURES, Solid};
use crate::staged::{Rested, Rings, SINCE_CHANGE, UNTIL_CHANGE, growing, release};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::FRAC_PI_2;
use tremolite::hexahedra::centroid;
use tremolite::Traction;
use tremolite::{Life, Quadrature};

const NAME: &str = "kirsch_hole";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a round hole excavated from an elastic block: motion of its wall and stress there",
    source: "`kirsch1898`",
    from: Effort::Test,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
/// a, outer radius \[m\]
const WALL: f64 = 5.0;
const OUTER: f64 = 25.0;
/// Stress \[Pa\] along x and z.
const FAR: [f64; 2] = [-4.32e6, -5.4e6];
/// Elements around the quarter, coarse and fine.
const AROUND: [u32; 2] = [16, 32];

/// Errors of a mesh.
struct Errors {
    /// Largest of the wall's radial motion over the mean motion.
    motion: f64,
    /// Largest of the hoop stress at the wall over the exact.
    hoop: f64,
    /// Largest motion before the excavation over that after it.
    before: f64,
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for (quadrature, word) in QUADRATURES {
        let [coarse, fine] = [excavate(quadrature, AROUND[0])?, excavate(quadrature, AROUND[1])?];
        let mut check = |what: &str, values: [f64; 2], tolerance: f64, note: &str, orders: [f64; 2], why: &str| {
            let p = order(values[0], values[1], 2.0);
            let quantity = format!("largest error of {what}, {} elements in the quarter, {word}", AROUND[1]);
            checks.push(Check::new(NAME, quantity, values[1], 0.0, tolerance, "1", note).with_order(p));
            let quantity = format!("order in h of {what}, {word}");
            checks.push(Check::new(NAME, quantity, p, orders[0], orders[1], "1", why).with_order(p));
        };
        let note = "1 %: (h/r)² is 0.24 %, and the solution goes with r⁻³ and 2θ";
        check("the wall's motion over its mean", [coarse.motion, fine.motion], 0.01, note, [2.0, 0.2], "2 of displacements");
        let note = "2 %: (h/r)² is 0.24 %, and stress goes with r⁻⁴: a parabola misses 20 (1.5 h/r)³";
        let why = "between 2 of stresses at centres and 3 of the parabola";
        check("hoop stress at the wall over the exact", [coarse.hoop, fine.hoop], 0.02, note, [2.5, 0.6], why);
        let note = "1e-10: uniform stress leaves round-off of the forces at nodes";
        let quantity = format!("motion before the excavation over that after it, {word}");
        checks.push(Check::new(NAME, quantity, fine.before, 0.0, 1e-10, "1", note));
    }
    Ok(checks)
}

fn excavate(quadrature: Quadrature, around: u32) -> Result<Errors, VerifyError> {
    let exact = Opening { rock: ROCK, radius: WALL, far: FAR, lining: None }.solve();
    let mut radii: Vec<f64> = (0..=4).map(|i| WALL * f64::from(i) / 4.0).collect();
    radii.extend(growing(WALL, OUTER, FRAC_PI_2 / f64::from(around)));
    let rings = Rings::new(radii, around, false);
    let (core, rock) = (rings.between(0.0, WALL), rings.between(WALL, OUTER));

    let mesh = rings.mesh.clone();
    let mut initial = vec![[FAR[0], ROCK.poisson * (FAR[0] + FAR[1]), FAR[1], 0.0, 0.0, 0.0]; mesh.elements.len()];
    let solid = ROCK.body("rock", core.iter().chain(&rock).copied().collect(), quadrature);
    let brick = rings.brick();
    initial[brick.elements[0] as usize] = [0.0; 6];
    let mut problem = tremolite::Problem::new(mesh, vec![solid, brick]);
    problem.lives = vec![Life::ALWAYS; problem.mesh.elements.len()];
    core.iter().for_each(|&e| problem.lives[e as usize] = UNTIL_CHANGE);
    let far = initial[0];
    problem.initial = initial;
    problem.held = rings.symmetry();
    problem.tractions = vec![
        Traction { name: "far".into(), faces: rings.edge(|_| far), life: Life::BEFORE },
        Traction {
            name: "change".into(),
            faces: rings.edge(|angle| exact.change(OUTER, angle)),
            life: SINCE_CHANGE,
        },
    ];
    let before = Rested::new(problem.clone(), &[release(1.0)])?;
    let opened = Rested::new(problem, &[release(1.0), release(1.0)])?;

    let wall = rings.nearest(WALL);
    let mean = 0.5 * (exact.at(WALL, 0.0).motion[0] + exact.at(WALL, FRAC_PI_2).motion[0]);
    let motion = (0..=around).map(|line| {
        let angle = rings.angle(f64::from(line));
        let u = opened.shown(rings.node(wall, line, 0));
        let (sine, cosine) = angle.sin_cos();
        ((u[0] * cosine + u[2] * sine - exact.at(WALL, angle).motion[0]) / mean).abs()
    });
    let hoop = (0..around).map(|sector| {
        let angle = rings.angle(f64::from(sector) + 0.5);
        let rows = [0, 1, 2].map(|ring| {
            let element = rock[(ring * around + sector) as usize];
            let x = centroid(&opened.model.mesh, element);
            (x[0].hypot(x[2]), opened.polar(element)[1])
        });
        (parabola(rows, WALL) / exact.at(WALL, angle).stress[1] - 1.0).abs()
    });
    let most = |rested: &Rested| {
        rested.state.u.iter().flat_map(|u| u.xyz()).fold(0.0, |most: f64, x| most.max(x.abs()))
    };
    Ok(Errors {
        motion: motion.fold(0.0, f64::max),
        hoop: hoop.fold(0.0, f64::max),
        before: most(&before) / most(&opened),
    })
}

/// The parabola through three points, at x.
fn parabola(points: [(f64, f64); 3], x: f64) -> f64 {
    (0..3)
        .map(|i| {
            let others = (0..3).filter(|&j| j != i);
            points[i].1 * others.map(|j| (x - points[j].0) / (points[i].0 - points[j].0)).product::<f64>()
        })
        .sum()
}
