//! A round opening that is excavated from Mohr–Coulomb rock under equal pressure from all sides.
//!
//! Salençon's solution, as in [`super::circular_opening`], with the same rock; there the pressure on the wall falls as a load in
//! time, here the core is excavated in a stage: what it did to the wall is held and let go over the ramp, and the model relaxes
//! without time. With a ramp the path is that of a falling pressure, which the closed form follows (let go at once, the wall moves by
//! 0.1 % more: where all is even around, there is little to go astray).
//!
//! **Model.** A quarter out to 5a, its core included; the outer edge has p₀ before and the exact σ_r there after, so only the mesh
//! errs. Rings grow with r; n is the number of elements around the quarter.
//!
//! Without dilation unevenness may grow out of round-off, the more so the finer the mesh ([`super::circular_opening`]).
//! The rock of a common verification of programs for rock has ν = 0.21 and p₀ = 30 MPa, where the stress along the axis yields as well:
//! a ring with flow along its axis moves by 0.84 % (ψ = 0) and 1.65 % (ψ = 30°) more than the closed form. So that is for information.

use super::circular_opening::exact::{Exact, SURROUNDINGS, Surroundings};
use crate::convergence::order;
use crate::models::{QUADRATURES, Solid, material};
use crate::staged::{Rested, Rings, SINCE_CHANGE, UNTIL_CHANGE, growing, release};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::FRAC_PI_2;
use tremolite::hexahedra::centroid;
use tremolite::history::History;
use tremolite::Traction;
use tremolite::{Life, Quadrature};
use tremolite_laws::materials::MohrCoulomb;
use tremolite_laws::{Material, Role, Values};

const NAME: &str = "excavated_opening";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "circular opening excavated from Mohr–Coulomb rock: plastic radius and convergence of the wall",
    source: "`salencon1969`",
    from: Effort::Verify,
    run,
};

/// a, outer radius \[m\]
const WALL: f64 = 1.0;
const OUTER: f64 = 5.0;
/// ψ \[°\]
const DILATIONS: [f64; 3] = [0.0, 10.0, 30.0];
const AROUND: [u32; 2] = [16, 48];

/// G = 2.8 GPa, K = 3.9 GPa.
const ANOTHER: Surroundings = Surroundings {
    solid: Solid { young: 6.777931034482759e9, poisson: 0.2103448275862069, density: 2600.0 },
    far: 30e6,
    inside: 0.0,
    cohesion: 3.45e6,
    friction: 30.0,
};
/// What a ring with flow along its axis moves more than the closed form there, at ψ = 0 and 30°.
const AXIAL: [(f64, f64); 2] = [(0.0, 0.0084), (30.0, 0.0165)];

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for (quadrature, word) in QUADRATURES {
        for dilation in DILATIONS {
            let exact = Exact::new(dilation);
            let [coarse, fine] = AROUND.map(|n| open(quadrature, SURROUNDINGS, dilation, n));
            let (coarse, fine) = (coarse?, fine?);
            let of = |what: &str| format!("{what}, ψ = {dilation}°, n = {}, {word}", AROUND[1]);
            let ring = exact.plastic * FRAC_PI_2 / f64::from(AROUND[1]);
            let note = "an element there: an element yields or not";
            checks.push(Check::new(NAME, of("plastic radius"), fine.plastic, exact.plastic, ring, "m", note));
            let [before, wall] = [&coarse, &fine].map(|opened| opened.wall / exact.inwards(WALL));
            let note = "2 %: of order 2 in the angle of an element, 0.11 % its square, stress growing as r² and flow as r⁻⁴";
            checks.push(Check::new(NAME, of("wall's motion over exact"), wall, 1.0, 0.02, "1", note));
            let p = order((before - 1.0).abs(), (wall - 1.0).abs(), f64::from(AROUND[1] / AROUND[0]));
            let note = "order 2 within 0.4: where the plastic radius falls within a ring changes the errors by a third, ln 1.5/ln 3";
            let quantity = of(&format!("order of the wall's motion from n = {}", AROUND[0]));
            // Where the even motion is not the only one, round-off grows to others, whose mean differs by as much as the error.
            let is_even = coarse.uneven.max(fine.uneven) < 0.1 * (wall - 1.0).abs();
            checks.push(match dilation > 0.0 || is_even {
                true => Check::new(NAME, quantity, p, 2.0, 0.4, "1", note).with_order(p),
                false => {
                    let note = "the wall moves unevenly by more than a tenth of the error: the even motion is not the only one";
                    Check::beside(NAME, quantity, p, 2.0, "1", note)
                }
            });
            let note = "1e-3: round-off does not grow where the even motion is the only one";
            let quantity = of("largest less smallest motion of the wall over the mean");
            checks.push(if dilation > 0.0 {
                Check::new(NAME, quantity, fine.uneven, 0.0, 1e-3, "1", note)
            } else {
                Check::beside(NAME, quantity, fine.uneven, 0.0, "1", "the even motion is not the only one")
            });
        }
        for (dilation, more) in AXIAL {
            let exact = Exact::of(ANOTHER, dilation);
            let n = AROUND[1];
            let opened = open(quadrature, ANOTHER, dilation, n)?;
            let of = |what: &str| format!("{what}, axis yields, ψ = {dilation}°, n = {n}, {word}");
            let wall = opened.wall / exact.inwards(WALL);
            let note = "for information: the closed form leaves out the flow along the axis";
            checks.push(Check::beside(NAME, of("wall's motion over the closed form"), wall, 1.0 + more, "1", note));
            checks.push(Check::beside(NAME, of("plastic radius"), opened.plastic, exact.plastic, "m", note));
        }
    }
    Ok(checks)
}

/// What an excavation came to.
struct Opened {
    /// Mean motion of the wall inwards \[m\].
    wall: f64,
    /// Difference of its largest and smallest over it.
    uneven: f64,
    /// Outer radius of the elements that yielded \[m\].
    plastic: f64,
}

fn open(
    quadrature: Quadrature,
    surroundings: Surroundings,
    dilation: f64,
    around: u32,
) -> Result<Opened, VerifyError> {
    let exact = Exact::of(surroundings, dilation);
    let mut radii: Vec<f64> = (0..=4).map(|i| WALL * f64::from(i) / 4.0).collect();
    let grown = growing(WALL, OUTER, FRAC_PI_2 / f64::from(around));
    let half = (OUTER / WALL).powf(0.5 / grown.len() as f64);
    radii.extend(grown);
    let rings = Rings::new(radii, around, false);
    let (core, rock) = (rings.between(0.0, WALL), rings.between(WALL, OUTER));

    let values = Values::default()
        .with("young", surroundings.solid.young)
        .with("poisson", surroundings.solid.poisson)
        .with("cohesion", surroundings.cohesion)
        .with("friction_angle", surroundings.friction.to_radians())
        .with("dilation_angle", dilation.to_radians())
        .with("tensile_strength", surroundings.cohesion / surroundings.friction.to_radians().tan());
    let pressure = |p: f64| [-p, -p, -p, 0.0, 0.0, 0.0];
    let brick = rings.brick();
    let mut body = surroundings.solid.body("rock", core.iter().chain(&rock).copied().collect(), quadrature);
    body.material = material(MohrCoulomb::NAME, &values)?;
    let mut problem = tremolite::Problem::new(rings.mesh.clone(), vec![body, brick]);
    problem.lives = vec![Life::ALWAYS; problem.mesh.elements.len()];
    core.iter().for_each(|&e| problem.lives[e as usize] = UNTIL_CHANGE);
    problem.initial = vec![pressure(surroundings.far); problem.mesh.elements.len()];
    problem.initial[problem.bodies[1].elements[0] as usize] = [0.0; 6];
    problem.held = rings.symmetry();
    let [outside, _] = exact.stress(OUTER);
    problem.tractions = vec![
        Traction {
            name: "before".into(),
            faces: rings.edge(|_| pressure(surroundings.far)),
            life: UNTIL_CHANGE,
        },
        Traction { name: "after".into(), faces: rings.edge(|_| pressure(outside)), life: SINCE_CHANGE },
    ];
    let opened = Rested::new(problem, &[release(1.0), release(1.0)])?;

    let [mean, most, least] = rings.inwards(&opened, WALL);
    let history = History::new(&opened.assembly, &opened.state.history);
    let mut plastic = 0.0_f64;
    for &element in &rock {
        let Some(slot) = opened.phase.element_slot[element as usize] else { continue };
        let column = history.with_role(&slot, Role::PlasticShear);
        let strain = column.map_or(0.0, |column| history.values(&slot, column).fold(0.0, f64::max));
        if strain > 0.0 {
            // To the outer edge of its ring.
            let x = centroid(&opened.model.mesh, element);
            plastic = plastic.max(x[0].hypot(x[2]) * half);
        }
    }
    Ok(Opened { wall: mean, uneven: (most - least) / mean, plastic })
}
