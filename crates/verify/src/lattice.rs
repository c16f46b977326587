//! A vertical shear wave in a column of elements: a chain of masses and springs on a dashpot, which is what such elements are to it.
//!
//! Elements whose strain is that of their middle and whose mass is lumped make of a plane wave along an axis a chain of masses ρh and
//! springs G/h, half a mass at each end. A wave of wave number k has there the impedance ρc cos(kh/2), while a dashpot has ρc, so the base
//! lets in 1 + (kh)²/16 of a wave; and the chain delays it by (kh)²/24 of its way. The chain is advanced by itself, without any of the
//! engine, and so shows what of a model's error is this and what is not.

use tremolite_motion::Motion;

/// A chain that rises from its base.
pub struct Lattice {
    /// kg/m² of a mass between two springs, Pa/m of a spring, Pa s/m of the dashpot.
    pub mass: f64,
    pub spring: f64,
    pub dashpot: f64,
    /// Springs.
    pub cells: usize,
}

impl Lattice {
    /// Displacements \[m\] of all masses, from the base up, behind each of so many steps of `dt` \[s\], under a wave that rises with the
    /// first component of a motion.
    pub fn shaken(&self, wave: &Motion, dt: f64, steps: u64) -> Vec<Vec<f64>> {
        let mass = |k: usize| if k == 0 || k == self.cells { 0.5 * self.mass } else { self.mass };
        let (mut u, mut v) = (vec![0.0; self.cells + 1], vec![0.0; self.cells + 1]);
        let mut all = Vec::new();
        for step in 0..steps {
            let pull: Vec<f64> = u.windows(2).map(|pair| self.spring * (pair[1] - pair[0])).collect();
            for k in 0..=self.cells {
                let above = pull.get(k).copied().unwrap_or(0.0);
                let below =
                    if k == 0 { 2.0 * self.dashpot * wave.at(step as f64 * dt).v[0] } else { -pull[k - 1] };
                let force = above + below;
                // The dashpot acts on the mean of the velocities before and behind.
                let damped = if k == 0 { 0.5 * dt * self.dashpot / mass(0) } else { 0.0 };
                v[k] = (v[k] * (1.0 - damped) + dt * force / mass(k)) / (1.0 + damped);
            }
            u.iter_mut().zip(&v).for_each(|(u, v)| *u += dt * v);
            all.push(u.clone());
        }
        all
    }
}
