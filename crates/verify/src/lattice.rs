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

    /// By how much the displacements \[m\] of all masses, from the base up, are less than a field's at each of so many steps of `dt` \[s\] from 0
    /// on, in a chain that goes on below without end and into which the field came without error: `field` has displacement \[m\] by the number
    /// of a mass, or of one below, and time \[s\], and obeys the equation of motion of what the chain is made for.
    ///
    /// What is wrong of the field in the chain, above the base, is put to it as forces; these make waves that go away below: the
    /// error of the mesh itself, of which no boundary has a part.
    pub fn lag(&self, field: impl Fn(i64, f64) -> f64, dt: f64, steps: u64) -> Vec<Vec<f64>> {
        // In a step a wave goes no farther than a mass.
        let (below, top) = (steps as usize, self.cells as i64);
        let count = below + self.cells + 1;
        let (mut e, mut du) = (vec![0.0; count], vec![0.0; count]);
        let mut all = vec![vec![0.0; self.cells + 1]];
        let gain = |last: bool| dt * dt * self.spring / if last { 0.5 * self.mass } else { self.mass };
        for step in 0..steps {
            let time = step as f64 * dt;
            let pull: Vec<f64> = e.windows(2).map(|pair| pair[1] - pair[0]).collect();
            for k in 0..count {
                let above = pull.get(k).copied().unwrap_or(0.0);
                let under = if k == 0 { 0.0 } else { pull[k - 1] };
                du[k] += gain(k + 1 == count) * (above - under);
            }
            for k in 0..=top {
                let [before, now, after] = [-dt, 0.0, dt].map(|d| field(k, time + d));
                let above = if k == top { 0.0 } else { field(k + 1, time) - now };
                let under = now - field(k - 1, time);
                let wrong = after - 2.0 * now + before - gain(k == top) * (above - under);
                du[below + k as usize] += if k == 0 { 0.5 * wrong } else { wrong };
            }
            e.iter_mut().zip(&du).for_each(|(e, du)| *e += du);
            all.push(e[below..].to_vec());
        }
        all
    }
}
