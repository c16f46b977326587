//! Bessel functions of integer order and real argument.

use std::f64::consts::FRAC_2_PI;

/// Euler's constant γ.
const EULER: f64 = 0.577_215_664_901_532_9;
/// Where a recurrence is brought down to, before it overflows.
const LARGE: f64 = 1e200;

/// J_n(x) and Y_n(x) for n = 0, 1, …, to about 1e-14 of their amplitude √(J² + Y²).
#[derive(Clone, Debug)]
pub struct Bessel {
    pub j: Vec<f64>,
    pub y: Vec<f64>,
}

impl Bessel {
    /// All orders up to `most` at x > 0. Y overflows where its order is far beyond x.
    ///
    /// J comes from the recurrence downwards, in which it is the solution that grows, begun well beyond order and argument
    /// and scaled by 1 = J₀ + 2ΣJ₂ₖ (Miller); Y₀ from Neumann's series in these J, Y₁ = −Y₀′, and all others upwards, where Y
    /// grows (`abramowitz1964`, 9.1.27, 9.1.46, 9.1.89 and 9.12).
    pub fn new(most: usize, x: f64) -> Self {
        let order = (most as f64).max(x);
        let start = 2 * ((order + 20.0 + (60.0 * order).sqrt()) / 2.0).ceil() as usize;
        let mut j = vec![0.0; start + 2];
        j[start] = 1.0;
        for n in (1..=start).rev() {
            j[n - 1] = 2.0 * n as f64 / x * j[n] - j[n + 1];
            if j[n - 1].abs() > LARGE {
                j[n - 1..].iter_mut().for_each(|j| *j /= LARGE);
            }
        }
        let sum = j[0] + 2.0 * j[2..].iter().step_by(2).sum::<f64>();
        j.iter_mut().for_each(|j| *j /= sum);

        let log = (0.5 * x).ln() + EULER;
        let (mut zeroth, mut first) = (FRAC_2_PI * log * j[0], FRAC_2_PI * (log * j[1] - j[0] / x));
        for k in 1..start / 2 {
            let share = if k % 2 == 0 { FRAC_2_PI } else { -FRAC_2_PI } / k as f64;
            zeroth -= 2.0 * share * j[2 * k];
            first += share * (j[2 * k - 1] - j[2 * k + 1]);
        }
        let mut y = vec![zeroth, first];
        for n in 1..most {
            y.push(2.0 * n as f64 / x * y[n] - y[n - 1]);
        }
        j.truncate(most + 1);
        y.truncate(most + 1);
        Bessel { j, y }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Tables of `abramowitz1964`, 9.1, 9.2 and 9.4.
    #[test]
    fn functions_have_their_tabulated_values() {
        for (n, x, j, y) in [
            (0, 1.0, 0.765_197_686_557_966_6, 0.088_256_964_215_676_96),
            (1, 1.0, 0.440_050_585_744_933_5, -0.781_212_821_300_288_7),
            (0, 10.0, -0.245_935_764_451_348_3, 0.055_671_167_283_599_39),
            (1, 10.0, 0.043_472_746_168_861_44, 0.249_015_424_206_953_9),
            (10, 1.0, 2.630_615_123_687_453e-10, -1.216_180_142_786_892e8),
            (5, 2.0, 7.039_629_755_871_684e-3, -9.935_989_128_481_974),
        ] {
            let found = Bessel::new(12, x);
            for (found, exact) in [(found.j[n], j), (found.y[n], y)] {
                assert!(
                    (found - exact).abs() < 1e-13 * exact.abs().max(1.0).min(exact.abs() * 1e2),
                    "{n} {x}: {found} {exact}"
                );
            }
        }
    }

    /// J_{n+1} Y_n − J_n Y_{n+1} = 2/(πx) joins what comes downwards, from series, and upwards.
    #[test]
    fn both_kinds_have_their_wronskian_at_all_orders_and_arguments() {
        for x in [1e-3, 0.05, 0.7, 2.404_825_557_695_773, 3.831_705_970_207_512, 17.0, 60.0, 150.0] {
            let most = if x < 0.1 { 8 } else { 40 };
            let Bessel { j, y } = Bessel::new(most, x);
            for n in 0..most {
                let found = (j[n + 1] * y[n] - j[n] * y[n + 1]) / FRAC_2_PI * x;
                assert!((found - 1.0).abs() < 1e-12, "{n} {x}: {found}");
            }
        }
    }
}
