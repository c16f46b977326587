//! A record on or within layered ground, deconvolved and sent through the model, comes out where it was taken.
//!
//! The record is a Ricker pulse with all frequencies to 10 Hz, along x and z. From the surface of a layer of soil on rock, or from a
//! depth within the soil, it is turned into the wave at the model's base ([`tremolite::deconvolution`]), S and P each by its own
//! transfer. The engine knows nothing of that: what moves the place of the record is compared with the record, frequency by
//! frequency, amplitude and phase. The leading error is the phase that rows of lumped masses are late, (kh)²/24 of what the wave
//! passes through (0.1 % at 10 Hz in elements of 1 m), times what the layer amplifies.

use crate::convergence::order;
use crate::models::{Solid, column, law};
use crate::simulation::{Simulation, whole_steps};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::TAU;
use tremolite::deconvolution::Place;
use tremolite::layered_column::{Layer, LayeredColumn};
use tremolite::{Base, Incident, Quadrature, Rayleigh, Side, Top};
use tremolite_laws::band::Band;
use tremolite_laws::materials::Elastic;
use tremolite_laws::{Material, Values};
use tremolite_motion::{Complex64, Motion, ricker_velocity};

const NAME: &str = "recorded_motion";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a record of the surface, and one of a depth, come out where they were taken, to 10 Hz",
    source: "the record itself; transfer functions of damped layers (Kramer 1996, section 7.2)",
    from: Effort::Test,
    run,
};

/// Thickness of the layer and of the rock below it in the model \[m\], and speeds of their S waves \[m/s\].
const LAYER: f64 = 40.0;
const ROCK: f64 = 60.0;
const SPEEDS: [f64; 2] = [400.0, 2000.0];
const DENSITIES: [f64; 2] = [2000.0, 2700.0];
/// A layer of ν = 0 has P waves only √2 faster than S: the errors of both count.
const POISSON: f64 = 0.0;
/// The first notch of this depth lies at c/4h = 12.5 Hz.
const DEPTH: f64 = 8.0;
/// Peak frequency of the pulse \[Hz\], its centre \[s\]; at 10 Hz it has 0.6 % of its largest amplitude, at 12.5 Hz 10⁻⁴.
const FREQUENCY: f64 = 3.5;
const CENTRE: f64 = 0.5;
/// Sampling of the record \[s\], and its length.
const DT: f64 = 0.005;
const SAMPLES: u32 = 801;
/// Up to here the record is wanted \[Hz\].
const BAND: f64 = 10.0;
/// Frequencies that are compared \[Hz\]: multiples of this.
const SPACING: f64 = 0.25;
const COUNT: u32 = 40;
/// What of the record is along x and z.
const ALONG: [f64; 3] = [1.0, 0.0, 0.5];

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let fine = if effort == Effort::Full { 0.5 } else { 1.0 };
    let mut checks = Vec::new();
    for (depth, word) in [(0.0, "surface"), (DEPTH, "within, 8 m deep")] {
        let [coarse, fine] = [errors(2.0 * fine, depth)?, errors(fine, depth)?];
        for (k, wave) in ["S", "P"].into_iter().enumerate() {
            let p = order(coarse[k], fine[k], 2.0);
            let quantity = format!("largest error of the record at its place to 10 Hz, {word}, {wave} wave");
            let note = "1 % of the record at each frequency, in amplitude and phase";
            checks.push(Check::new(NAME, quantity, fine[k], 0.0, 0.01, "1", note).with_order(p));
            let quantity = format!("order in h of the record at its place, {word}, {wave} wave");
            let note = "order 2 in h, Δt ∝ h; the next term is of order (kh)², 0.1 for the coarser mesh";
            checks.push(Check::new(NAME, quantity, p, 2.0, 0.1, "1", note));
        }
    }
    Ok(checks)
}

/// Largest error over the record's amplitude, of S and P waves, with elements of height `h` \[m\] in the layer.
fn errors(h: f64, depth: f64) -> Result<[f64; 2], VerifyError> {
    let setup = |e: String| VerifyError::Setup(e);
    let band = Band::fit(0.03, [0.5, 20.0], 3.0).map_err(|e| setup(e.to_string()))?;
    let solids = [0, 1].map(|k| Solid::from_shear_speed(SPEEDS[k], POISSON, DENSITIES[k]));
    let own = |k: usize, axis: usize| Layer {
        thickness: [LAYER, ROCK][k],
        density: DENSITIES[k],
        speed: if axis == 2 { SPEEDS[k] * 2.0_f64.sqrt() } else { SPEEDS[k] },
        band: Some(band),
        rayleigh: Rayleigh::default(),
        damping: 0.0,
            water: None,
    };
    let layered = |axis: usize| {
        LayeredColumn::new([own(1, axis), own(0, axis)], Top::Free)
            .ok_or_else(|| setup("the column has no layers".into()))
    };
    let place = Place { columns: [layered(0)?, layered(1)?, layered(2)?], height: LAYER + ROCK - depth };

    let pulse = ricker_velocity(FREQUENCY, CENTRE, 0.1);
    let record = Motion::from_acceleration(
        DT,
        ALONG.map(|along| (0..SAMPLES).map(|k| along * pulse(f64::from(k) * DT).a).collect()),
    )?;
    let found = place.deconvolved(&record.acceleration, DT, BAND);
    let found = found.map_err(|(_, notch)| setup(format!("the record is refused by its notch, {notch:?}")))?;
    let late = found.lead as f64 * DT;
    let motion = Motion::from_acceleration(DT, found.incident)?;

    // Rock carries waves five times as long, with elements three times as high.
    let below = (ROCK / (3.0 * h)).round() as u32;
    let layers = below + (LAYER / h).round() as u32;
    let mut mesh = column(h, layers, 1)?;
    let lifted = h * f64::from(below);
    mesh.nodes.iter_mut().for_each(|x| x[2] += 2.0 * x[2].min(lifted));
    let (rock, soil): (Vec<u32>, Vec<u32>) =
        (0..layers).partition(|&e| tremolite::hexahedra::centroid(&mesh, e)[2] < ROCK);
    let mut bodies = vec![
        solids[1].body("rock", rock, Quadrature::OnePoint),
        solids[0].body("layer", soil, Quadrature::OnePoint),
    ];
    for (body, solid) in bodies.iter_mut().zip([solids[1], solids[0]]) {
        let values = Values::default().with("young", solid.young).with("poisson", solid.poisson);
        body.material = (law(Elastic::NAME)?.build_banded)(&values, band)
            .map_err(|_| setup("the elastic law refuses its values".into()))?;
    }
    let mut problem = tremolite::Problem::new(mesh, bodies);
    problem.sides = [Side::Periodic; 2];
    problem.base = Base::Viscous;
    let end = motion.duration();
    problem.incident = Some(Incident { motion, factor: 1.0 });
    let simulation = Simulation::new(problem)?;
    let node = simulation.node([0.0, 0.0, LAYER + ROCK - depth])?;
    // In proportion to h.
    let (steps, dt) = whole_steps(end, 0.9 * simulation.stable());

    let frequencies: Vec<f64> = (1..=COUNT).map(|k| SPACING * f64::from(k)).collect();
    let mut sums = vec![[[Complex64::default(); 2]; 2]; frequencies.len()];
    simulation.run_from_rest(dt, steps, |state| {
        let (velocity, time) = simulation.velocity(state, node);
        let given = record.at(time - late);
        for (sums, hertz) in sums.iter_mut().zip(&frequencies) {
            let turn = Complex64::from_polar(1.0, -TAU * hertz * time);
            for (k, axis) in [0, 2].into_iter().enumerate() {
                let exact = if time < late { 0.0 } else { given.v[axis] };
                sums[k][0] += turn * velocity[axis];
                sums[k][1] += turn * exact;
            }
        }
    })?;
    let error = |k: usize| {
        sums.iter().map(|sums| (sums[k][0] - sums[k][1]).norm() / sums[k][1].norm()).fold(0.0, f64::max)
    };
    Ok([error(0), error(1)])
}
