//! A step of stress as a sum of steady waves.

use super::{Cavity, Incoming, Place};
use num_complex::Complex64;
use std::f64::consts::{PI, TAU};

const I: Complex64 = Complex64::I;

impl Cavity {
    /// σ_θ at places and times \[s\] under an incident stress s(t − (x + b)/c_p), whose front is at the near wall at t = 0:
    /// s = t/t_r − sin(2πt/t_r)/(2π) within the rise t_r \[s\] and 1 later.
    ///
    /// The answer to s′ is summed as a series over `period` \[s\], which must leave room for it to die away before the next
    /// one, and integrated term by term. Left out is what lies beyond the frequency 6/t_r: s′ falls there as
    /// 1/(π(ft_r)³), so the sum of all that is 2e-4 at most, over the stress incident.
    pub fn step(&self, rise: f64, period: f64, places: &[Place], times: &[f64]) -> Vec<Vec<f64>> {
        let delay = self.radius / self.rock.speeds().0;
        let lines = (6.0 * period / rise) as usize;
        let fundamental = TAU / period;
        // All but static: (ka)² ln ka off; far below, potentials of P and S in a liner can no more be told from each other.
        let still = self.scatter(Incoming::P, 0.1 * fundamental).hoops(places);
        let mut sums: Vec<Vec<f64>> = vec![vec![0.0; times.len() + 1]; places.len()];
        // The time before anything comes is the last.
        let before = -4.0 * delay;
        let all = || times.iter().copied().chain([before]);
        for k in 1..=lines {
            let omega = fundamental * k as f64;
            let half = 0.5 * omega * rise;
            let square = (half / PI).powi(2);
            // sin x/x/(1 − x²/π²), ½ at π.
            let bell = if (square - 1.0).abs() < 1e-9 { 0.5 } else { half.sin() / half / (1.0 - square) };
            let pulse = Complex64::from_polar(bell, half + omega * delay) * 2.0 / period / (-I * omega);
            let turns: Vec<Complex64> = all().map(|t| Complex64::from_polar(1.0, -omega * t)).collect();
            for (sum, hoop) in sums.iter_mut().zip(self.scatter(Incoming::P, omega).hoops(places)) {
                let line = hoop * pulse;
                sum.iter_mut().zip(&turns).for_each(|(sum, turn)| *sum += (line * turn).re);
            }
        }
        for (sum, still) in sums.iter_mut().zip(still) {
            sum.iter_mut().zip(all()).for_each(|(sum, t)| *sum += still.re * (t / period));
            let start = sum.pop().unwrap_or_default();
            sum.iter_mut().for_each(|sum| *sum -= start);
        }
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::super::tests::{LINER, ROCK, around, bare, near};
    use super::*;

    /// Values of a separate synthesis, which leaves up to 1.7e-4 where nothing has come yet.
    #[test]
    fn a_step_has_the_course_of_a_separate_synthesis() {
        let unit = 8.5 / ROCK.speeds().0;
        let times = [1.0, 2.0, 3.0, 4.0, 5.0, 7.5, 15.0, 20.0].map(|t| t * unit);
        let found = bare().step(unit, 200.0 * unit, &around(8.5), &times);
        for (k, exact) in [
            (0, [0.0, 0.0, 0.072817, 0.436331, 0.108872, -0.055055, -0.031140, 0.000835]),
            (2, [0.0, 0.016280, 0.825909, 1.235151, 1.551367, 1.450924, 1.341004, 1.337414]),
            (4, [0.0, 1.579773, 2.121816, 2.474444, 2.729930, 2.941697, 2.699264, 2.673501]),
            (8, [0.0, 0.068146, 0.161964, 0.188529, 0.161737, 0.005903, -0.024366, 0.000223]),
        ] {
            near(&found[k][1..], &exact[1..], 2e-4);
        }
        // The front is beside the axis.
        assert!(found[..4].iter().all(|place| place[0].abs() < 2e-4));
    }

    #[test]
    fn a_step_hardly_depends_on_the_period_of_the_synthesis() {
        let unit = 8.5 / ROCK.speeds().0;
        let times = [1.0, 3.0, 5.0, 7.5, 10.0, 15.0, 20.0].map(|t| t * unit);
        for (cavity, tolerance) in [(bare(), 1e-4), (Cavity { liner: Some((LINER, 8.0)), ..bare() }, 3e-4)] {
            let places = around(if cavity.liner.is_some() { 8.0 } else { 8.5 });
            let [once, twice] =
                [200.0, 400.0].map(|period| cavity.step(unit, period * unit, &places, &times));
            once.iter().zip(&twice).for_each(|(once, twice)| near(once, twice, tolerance));
        }
    }
}
