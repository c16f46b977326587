//! The transfer function of a damped layer on rock, as the engine has it.
//!
//! A vertical S wave with the velocity spectrum V(ω) enters a slab of rock under a layer of soil. With the wave number
//! k = (ω/c) √(I/M) and the impedance Z = ρc √(I M) of each, M its complex modulus over its own and I = 1 − iω_R/ω, the
//! amplitudes of the waves that go up and down follow from those at the surface, which are equal, by
//! A′, B′ = ½A (1 ± α) e^(ikH) + ½B (1 ∓ α) e^(−ikH), α the ratio of impedances (`kramer1996` (7.28), `roesset1970`), and the
//! dashpot below takes ρc (2v_i − v) = Z (A − B). So follow the surface's velocity over that of the outcrop, twice V, and over
//! that at the layer's base, 1/cos kH whatever lies below. Rayleigh's C = ω_R M + ξK makes M = 1 + iωξ; three Maxwell bodies
//! make it the modulus of `emmerich1987`.
//!
//! The engine gets one smooth pulse that holds all frequencies; sums over its steps are the spectra. The leading error is
//! the phase that the row of lumped masses is late, (kh)²/24 of kH: 0.8 % at 10 Hz with elements of 2 m; resonance multiplies
//! it where damping is small.

use crate::convergence::order;
use crate::models::{SIDES, Solid, column, law};
use crate::simulation::{Simulation, whole_steps};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::TAU;
use tremolite::{Base, Incident, Quadrature, Rayleigh, Side};
use tremolite_laws::band::Band;
use tremolite_laws::materials::Elastic;
use tremolite_laws::{Material, Values};
use tremolite_motion::{Complex64, Motion, Scalar};

const NAME: &str = "layer_transfer";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "damped layer on rock: transfer to 10 Hz with Rayleigh's damping and with a band",
    source: "closed form of a damped layer on an elastic half-space (Kramer 1996, section 7.2; Roesset 1970)",
    from: Effort::Test,
    run,
};

/// Thickness of the layer and of the rock below it in the model \[m\].
const LAYER: f64 = 200.0;
const ROCK: f64 = 40.0;
/// Speeds of S waves \[m/s\], layer and rock.
const SPEEDS: [f64; 2] = [1000.0, 2300.0];
const DENSITY: f64 = 2752.3;
/// The pulse: a bell of velocity with its centre and width \[s\], a seventh of its largest amplitude at 10 Hz.
const CENTRE: f64 = 0.25;
const WIDTH: f64 = 0.031;
/// Echoes fall by 0.39 every 0.4 s, damping apart: to 10⁻⁶ of the first.
const END: f64 = 6.0;
/// Frequencies \[Hz\] that are compared: multiples of this up to 10 Hz, the layer's resonances among them.
const SPACING: f64 = 0.25;
const COUNT: u32 = 40;

/// A kind of damping, of layer and rock alike.
#[derive(Clone, Copy)]
enum Damping {
    Rayleigh(Rayleigh),
    Band(Band),
}

impl Damping {
    /// Wave number times c/ω, and impedance over ρc, at a frequency \[Hz\].
    fn wave(self, hertz: f64) -> [Complex64; 2] {
        let omega = TAU * hertz;
        let (modulus, inertia) = match self {
            Damping::Rayleigh(c) => {
                (Complex64::new(1.0, omega * c.stiffness), Complex64::new(1.0, -c.mass / omega))
            }
            Damping::Band(band) => {
                (band.stiffness(hertz) * Complex64::new(1.0, 2.0 * band.ratio(hertz)), Complex64::from(1.0))
            }
        };
        [(inertia / modulus).sqrt(), (inertia * modulus).sqrt()]
    }
}

/// Velocity of the surface over that of the outcrop at the base of the rock, and over that at the layer's base, for `rock` \[m\]
/// of rock.
fn exact(hertz: f64, layer: Damping, below: Damping, rock: f64) -> [Complex64; 2] {
    let i = Complex64::i();
    let [[number, own], [number_below, own_below]] = [layer, below].map(|damping| damping.wave(hertz));
    let phase = |number: Complex64, h: f64, c: f64| i * number * (TAU * hertz * h / c);
    let up = phase(number, LAYER, SPEEDS[0]).exp();
    let alpha = own * SPEEDS[0] / (own_below * SPEEDS[1]);
    // Of a surface that moves by 1.
    let (a, b) = (0.5 * up, 0.5 / up);
    let through = phase(number_below, rock, SPEEDS[1]).exp();
    let a_rock = 0.5 * (a * (1.0 + alpha) + b * (1.0 - alpha)) * through;
    let b_rock = 0.5 * (a * (1.0 - alpha) + b * (1.0 + alpha)) / through;
    // 2v_i, the outcrop's, is v + Z/(ρc) (A − B).
    [(a_rock + b_rock + own_below * (a_rock - b_rock)).inv(), (a + b).inv()]
}

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let fine = if effort == Effort::Full { 1.25 } else { 5.0 / 3.0 };
    // 2 % at 1 Hz and 5 % at 10 Hz.
    let rayleigh = Rayleigh { mass: 0.05 * std::f64::consts::PI, stiffness: 0.005 / std::f64::consts::PI };
    let band = Band::fit(0.05, [0.5, 20.0], 3.0).map_err(|e| VerifyError::Setup(e.to_string()))?;
    let mut checks = Vec::new();
    // Slabs and columns of a model one element wide are twelve times its elements.
    let taken = SIDES.iter().filter(|(side, _)| effort == Effort::Full || *side == Side::Periodic);
    for &(sides, with) in taken {
        for (damping, word) in [(Damping::Rayleigh(rayleigh), "Rayleigh"), (Damping::Band(band), "band")] {
            let [coarse, fine] = [layered(2.0 * fine, damping, sides)?, layered(fine, damping, sides)?];
            // In proportion to h: with ξ the stable step falls faster, and the scheme's own error with it.
            let most = 0.9 * fine.stable();
            let [coarse, fine] = [errors(&coarse, damping, 2.0 * most)?, errors(&fine, damping, most)?];
            for (k, over) in ["outcrop", "the layer's base"].into_iter().enumerate() {
                let p = order(coarse[k], fine[k], 2.0);
                let quantity = format!("largest error of surface over {over} to 10 Hz, {word}{with}");
                let note = "1 % of the transfer at each frequency, in amplitude and phase; (kh)²/24 of kH is 0.6 % at 10 Hz, and resonance multiplies it";
                checks.push(Check::new(NAME, quantity, fine[k], 0.0, 0.01, "1", note).with_order(p));
                let quantity = format!("order in h of surface over {over}, {word}{with}");
                let note = "order 2 in h, Δt ∝ h; the next term is of order (kh)², 0.04 for the coarser mesh";
                checks.push(Check::new(NAME, quantity, p, 2.0, 0.1, "1", note));
            }
        }
    }
    Ok(checks)
}

/// The incident wave.
fn pulse(t: f64) -> Scalar {
    let s = (t - CENTRE) / WIDTH;
    let v = (-0.5 * s * s).exp();
    // The displacement drives nothing: the base goes by velocity.
    Scalar { a: -s / WIDTH * v, v, u: 0.0 }
}

/// Layer and rock, with elements of height `h` \[m\] in the layer.
fn layered(h: f64, damping: Damping, sides: Side) -> Result<Simulation, VerifyError> {
    // Rock carries waves more than twice as long with elements twice as high, which leaves the step to the soil.
    let below = (ROCK / (2.0 * h)).round() as u32;
    let layers = below + (LAYER / h).round() as u32;
    let mut mesh = column(h, layers, 1)?;
    let lifted = h * f64::from(below);
    mesh.nodes.iter_mut().for_each(|x| x[2] += x[2].min(lifted));
    let (rock, soil): (Vec<u32>, Vec<u32>) =
        (0..layers).partition(|&e| tremolite::hexahedra::centroid(&mesh, e)[2] < ROCK);
    // Without Poisson's ratio the P waves that bound the step are slowest.
    let solids = SPEEDS.map(|speed| Solid::from_shear_speed(speed, 0.0, DENSITY));
    let mut bodies = vec![
        solids[1].body("rock", rock, Quadrature::OnePoint),
        solids[0].body("layer", soil, Quadrature::OnePoint),
    ];
    if let Damping::Band(band) = damping {
        for (body, solid) in bodies.iter_mut().zip([solids[1], solids[0]]) {
            let values = Values::default().with("young", solid.young).with("poisson", solid.poisson);
            body.material = (law(Elastic::NAME)?.build_banded)(&values, band)
                .map_err(|_| VerifyError::Setup("the elastic law refuses its values".into()))?;
        }
    }
    let mut problem = tremolite::Problem::new(mesh, bodies);
    problem.sides = [sides; 2];
    problem.base = Base::Viscous;
    if let Damping::Rayleigh(rayleigh) = damping {
        problem.rayleigh = rayleigh;
    }
    let motion = Motion::sampled(1e-3, END, |t| pulse(t).along([1.0, 0.0, 0.0]))?;
    problem.incident = Some(Incident { motion, factor: 1.0 });
    Simulation::new(problem)
}

/// Largest error over the frequencies of [`exact`]'s two, over their size, with steps of at most `most` \[s\].
fn errors(simulation: &Simulation, damping: Damping, most: f64) -> Result<[f64; 2], VerifyError> {
    let nodes = [simulation.node([0.0, 0.0, LAYER + ROCK])?, simulation.node([0.0, 0.0, ROCK])?];
    let (steps, dt) = whole_steps(END, most);
    let frequencies: Vec<f64> = (1..=COUNT).map(|k| SPACING * f64::from(k)).collect();
    let mut spectra = vec![[Complex64::default(); 2]; frequencies.len()];
    simulation.run_from_rest(dt, steps, |state| {
        for (k, node) in nodes.into_iter().enumerate() {
            let ([v, ..], time) = simulation.velocity(state, node);
            let first = Complex64::from_polar(1.0, -TAU * SPACING * time);
            let mut turn = Complex64::from(dt * v);
            for sums in &mut spectra {
                turn *= first;
                sums[k] += turn;
            }
        }
    })?;
    let mut worst = [0.0f64; 2];
    for (&hertz, [surface, base]) in frequencies.iter().zip(spectra) {
        let omega = TAU * hertz;
        let size = WIDTH * TAU.sqrt() * (-0.5 * (omega * WIDTH).powi(2)).exp();
        let incident = Complex64::from_polar(size, -omega * CENTRE);
        let found = [surface / (2.0 * incident), surface / base];
        for ((worst, found), exact) in worst.iter_mut().zip(found).zip(exact(hertz, damping, damping, ROCK)) {
            *worst = worst.max((found / exact - 1.0).norm());
        }
    }
    Ok(worst)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Of the same layer, damped by Rayleigh alone, on undamped rock, from an independent computation: frequency \[Hz\], surface
    /// over outcrop, surface over the layer's base.
    const TABLE: [(f64, [f64; 2], [f64; 2]); 4] = [
        (0.5, [1.102631819778164, -0.35698677536915385], [1.2358244948375658, -0.015513503987650567]),
        (1.25, [0.008222221925838805, -2.171485298332652], [0.17142593376687892, -39.17493388265786]),
        (8.75, [-0.0223838538250041, 0.9953858676655402], [-0.13553036322018738, 1.9339103987641137]),
        (15.0, [0.3296372719056749, 0.043058752004164966], [0.4575980571188867, 0.0645505949215922]),
    ];

    #[test]
    fn the_closed_form_has_its_tabulated_values() {
        let of = |mass, stiffness| Damping::Rayleigh(Rayleigh { mass, stiffness });
        for (hertz, outcrop, base) in TABLE {
            let found = exact(hertz, of(0.15707963267948966, 0.0015915494309189536), of(0.0, 0.0), 0.0);
            for (found, [re, im]) in found.into_iter().zip([outcrop, base]) {
                let exact = Complex64::new(re, im);
                assert!((found - exact).norm() < 1e-10 * exact.norm(), "{hertz} Hz: {found} {exact}");
            }
        }
    }
}
