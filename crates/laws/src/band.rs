//! Damping nearly independent of frequency over a band: three Maxwell bodies beside any law.
//!
//! σ = σ_law(ε) + Σ_j a_j C (ε − e_j), ė_j = (ε − e_j)/τ_j, with the law's relaxed moduli in C (`emmerich1987`).
//! Its complex modulus over the relaxed one is M(ω) = 1 + Σ a_j iωτ_j/(1 + iωτ_j), its damping ratio ½ Im M/Re M. The
//! a_j are fitted to a ratio over a band. The price: moduli grow with frequency (waves disperse), and the unrelaxed
//! one sets the time step. The frequency at which E is meant is a parameter: the law then gets E/Re M there.
//!
//! Kept are the strains e_j. **They are brought on every N steps**, N the largest power of two up to 8 with NΔt ≤ τ_j/8 for all
//! bodies ([`Band::steps`]), by the trapezoidal rule over N steps around the middle of one of them, of which the strain's mean ε̄ is
//! known: with R = NΔt/2τ_j, e_j ← e_j + 2R/(1 + R) (ε̄ − e_j). In between they stay, and the bodies are springs. With N = 1 that is
//! the trapezoidal rule of every step, and it is of second order for any. Stable for every step: what flows is taken, never given.
//! A sinusoid of angular frequency ω sees the damping with an error of (ωNΔt)²/6 at the most, 2·10⁻³ where the band ends. Each step then
//! reads six numbers a point, Σ a_j e_j, where all would be 24 to read and to write: where bytes decide, damping over a band costs a third.
//!
//! **In a material that loses strength** the bodies' stress is w Σ a_j C q_j, q_j = ε − e_j, with one share w that never recovers
//! ([`Material::unbroken`](crate::Material::unbroken)), and they hold w Σ ψ_j, ψ_j = ½ a_j q_j:C:q_j. A share that follows
//! the sign of the stress, as the damage of a crack does, would let the bodies' memory go on while the crack is open, and give
//! out at closing energy that nobody put in. By the trapezoidal rule, which is that of the equations of motion, a step takes
//! exactly w̄ Σ a_j/(2R) Δe_j:C:Δe_j, and (w − w′) Σ (ψ̄_j − ¼ a_j Δq_j:C:Δε)
//! where w falls. Both are booked; the second not below 0, as it would be in a step so long that a stretch changes sign in it.

mod step;

pub use step::BandStep;

use crate::material::Moduli;

/// Maxwell bodies.
pub const BODIES: usize = 3;

/// Octets that a point's bodies keep: Σ a_j e_j, or the strain where it is wanted in the next step, e_j, and what was dissipated
/// \[J/m³\].
pub const MEMORY: usize = 6 + 6 * BODIES + 1;

const BODY: usize = 6;
const DISSIPATED: usize = MEMORY - 1;

/// Three fitted Maxwell bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Band {
    /// a_j
    weights: [f64; BODIES],
    /// τ_j \[s\]
    times: [f64; BODIES],
    /// Frequency at which the moduli are the material's own \[Hz\].
    reference: f64,
}

/// A band that cannot be fitted, and what to do about it.
#[derive(Clone, Debug, PartialEq)]
pub struct BadBand(pub String);

impl std::fmt::Display for BadBand {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(&self.0)
    }
}

impl std::error::Error for BadBand {}

/// Frequencies across the band at which the ratio is fitted.
const SAMPLES: usize = 41;

impl Band {
    /// Bodies for a damping ratio over a band of frequencies \[Hz\], with the moduli meant at `reference` \[Hz\].
    ///
    /// For given times the weights follow by linear least squares from Im M = 2ξ Re M; the times are spread evenly
    /// in the logarithm, and the spread with the smallest largest deviation is taken.
    ///
    /// # Errors
    /// Ratios outside (0, 0.1], bands that are not two rising frequencies within a factor of 100, or a reference
    /// that is negative; at 0 Hz the moduli are those at rest.
    pub fn fit(ratio: f64, [low, high]: [f64; 2], reference: f64) -> Result<Band, BadBand> {
        if !(ratio > 0.0 && ratio <= 0.1) {
            return Err(BadBand(format!("a damping ratio of {ratio} cannot be fitted; give 0.001 to 0.1")));
        }
        if !(low > 0.0 && low < high && high <= 100.0 * low) {
            return Err(BadBand(format!(
                "three bodies cannot span {low} to {high} Hz; give two rising frequencies within a factor of 100"
            )));
        }
        if !(reference >= 0.0 && reference.is_finite()) {
            return Err(BadBand(format!(
                "the moduli cannot be meant at {reference} Hz; give a frequency of the band, or 0 Hz for those at rest"
            )));
        }
        let centre = 0.5 * (low.ln() + high.ln());
        let half = 0.5 * (high.ln() - low.ln());
        let mut best: Option<(f64, Band)> = None;
        for step in 0..=40 {
            let spread = half * (0.5 + 0.02 * f64::from(step));
            let times = [-1.0, 0.0, 1.0].map(|k| 1.0 / (std::f64::consts::TAU * (centre + k * spread).exp()));
            let Some(weights) = least_squares(ratio, [low, high], times) else { continue };
            let band = Band { weights, times, reference };
            let worst =
                samples([low, high]).map(|f| (band.ratio(f) / ratio - 1.0).abs()).fold(0.0_f64, f64::max);
            if weights.iter().all(|a| *a > 0.0) && best.as_ref().is_none_or(|(least, _)| worst < *least) {
                best = Some((worst, band));
            }
        }
        best.map(|(_, band)| band).ok_or_else(|| BadBand("no bodies fit; give a narrower band".into()))
    }

    /// Real and imaginary part of the modulus over the relaxed one at a frequency \[Hz\].
    fn modulus(&self, frequency: f64) -> (f64, f64) {
        let omega = std::f64::consts::TAU * frequency;
        self.weights.iter().zip(self.times).fold((1.0, 0.0), |(re, im), (a, tau)| {
            let x = omega * tau;
            (re + a * x * x / (1.0 + x * x), im + a * x / (1.0 + x * x))
        })
    }

    /// Damping ratio at a frequency \[Hz\].
    pub fn ratio(&self, frequency: f64) -> f64 {
        let (re, im) = self.modulus(frequency);
        0.5 * im / re
    }

    /// Modulus at a frequency \[Hz\] over the material's own: the square of the wave speed's ratio, to first order.
    pub fn stiffness(&self, frequency: f64) -> f64 {
        self.modulus(frequency).0 / self.modulus(self.reference).0
    }

    /// Real and imaginary part of the modulus over the material's own at a complex frequency s \[1/s\], strain and stress
    /// going as e^(st): exact, and smooth wherever Re s > −1/τ_j. At s = iω its parts are [`Self::stiffness`] and twice
    /// the [`Self::ratio`] of it.
    pub fn complex_modulus(&self, s: [f64; 2]) -> [f64; 2] {
        let mut m = [1.0, 0.0];
        for (a, tau) in self.weights.iter().zip(self.times) {
            // sτ/(1 + sτ) = 1 − 1/(1 + sτ)
            let d = [1.0 + tau * s[0], tau * s[1]];
            let norm = d[0] * d[0] + d[1] * d[1];
            m = [m[0] + a * (1.0 - d[0] / norm), m[1] + a * d[1] / norm];
        }
        m.map(|part| part * self.relaxed())
    }

    /// Frequency \[Hz\] and damping ratio of a free oscillation that the material's own modulus alone would give this
    /// frequency \[Hz\]: the root s of s² + ω² M(s)/Re M(ω_ref) = 0 that oscillates, ratio −Re s/|s|.
    pub fn oscillation(&self, undamped: f64) -> [f64; 2] {
        let omega = std::f64::consts::TAU * undamped;
        let mut s = [0.0, omega];
        // s ← √(−ω² M(s)) contracts, since M changes slowly.
        for _ in 0..100 {
            let minus = self.complex_modulus(s).map(|part| -omega * omega * part);
            let size = minus[0].hypot(minus[1]);
            // The root in the upper half plane; −M has a negative imaginary part, so its real part is negative.
            s = [-(0.5 * (size + minus[0])).max(0.0).sqrt(), (0.5 * (size - minus[0])).sqrt()];
        }
        [s[1] / std::f64::consts::TAU, -s[0] / s[0].hypot(s[1])]
    }

    /// The relaxed modulus, with which the law works, over the material's own.
    pub fn relaxed(&self) -> f64 {
        1.0 / self.modulus(self.reference).0
    }

    /// The unrelaxed modulus, which sets the time step, over the material's own.
    pub fn unrelaxed(&self) -> f64 {
        self.relaxed() * (1.0 + self.weights.iter().sum::<f64>())
    }

    /// Steps of `dt` \[s\] after which the bodies' memory is brought on, at once for all of them; a power of two.
    pub fn steps(&self, dt: f64) -> u64 {
        let shortest = self.times.into_iter().fold(f64::INFINITY, f64::min);
        let mut steps = 1;
        while steps < MOST_STEPS && dt > 0.0 && 2.0 * steps as f64 * dt <= SHARE * shortest {
            steps *= 2;
        }
        steps
    }

    /// Constants of step number `step` of Δt \[s\] for a law with these relaxed moduli. While time stands still (Δt = 0) the bodies
    /// are relaxed; number 0 is the first in which it goes on.
    pub fn step(&self, dt: f64, relaxed: Moduli, step: u64) -> BandStep {
        self.step_of(dt, relaxed, step, self.steps(dt))
    }

    /// The same where the memory is brought on every `every` steps.
    fn step_of(&self, dt: f64, relaxed: Moduli, step: u64, every: u64) -> BandStep {
        BandStep {
            weights: self.weights,
            halves: self.times.map(|tau| 0.5 * every as f64 * dt / tau),
            moduli: relaxed,
            relaxed: dt == 0.0,
            begins: step == 0,
            brings: step > 0 && step.is_multiple_of(every),
            keeps: (step + 1).is_multiple_of(every),
        }
    }
}

/// Most steps between two at which the memory is brought on: beyond, little is left to save.
const MOST_STEPS: u64 = 8;

/// The time between two such steps over the shortest τ_j, at most.
const SHARE: f64 = 0.125;

fn samples([low, high]: [f64; 2]) -> impl Iterator<Item = f64> {
    (0..SAMPLES).map(move |i| low * (high / low).powf(i as f64 / (SAMPLES - 1) as f64))
}

/// Weights with Σ a_j [x_j/(1 + x_j²) − 2ξ x_j²/(1 + x_j²)] = 2ξ in the least-squares sense, x_j = ωτ_j.
fn least_squares(ratio: f64, band: [f64; 2], times: [f64; BODIES]) -> Option<[f64; BODIES]> {
    let mut m = [[0.0; BODIES]; BODIES];
    let mut b = [0.0; BODIES];
    for f in samples(band) {
        let row = times.map(|tau| {
            let x = std::f64::consts::TAU * f * tau;
            (x - 2.0 * ratio * x * x) / (1.0 + x * x)
        });
        for i in 0..BODIES {
            for j in 0..BODIES {
                m[i][j] += row[i] * row[j];
            }
            b[i] += row[i] * 2.0 * ratio;
        }
    }
    // Cramer's rule; the bodies are well apart.
    let det = |m: &[[f64; 3]; 3]| {
        m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
            + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
    };
    let whole = det(&m);
    if whole.abs() < 1e-12 {
        return None;
    }
    Some([0, 1, 2].map(|k| {
        let mut replaced = m;
        for i in 0..3 {
            replaced[i][k] = b[i];
        }
        det(&replaced) / whole
    }))
}

#[cfg(test)]
mod tests;
