//! Values of a distribution at shares of it.

use tremolite_case::study::{Bounds, Distribution};

use crate::normal;

/// The value that a share `p` of the distribution lies below, 0 < p < 1, in its unit. One that is cut off is scaled to what is left,
/// so every share has a value within the bounds.
pub fn value_at(distribution: &Distribution, p: f64) -> f64 {
    match distribution {
        Distribution::Uniform { low, high, .. } => low + p * (high - low),
        Distribution::LogUniform { low, high, .. } => {
            libm::exp(libm::log(*low) + p * (libm::log(*high) - libm::log(*low)))
        }
        Distribution::Normal { mean, sd, within, .. } => cut(*mean, *sd, *within, p),
        Distribution::Lognormal { median, beta, within, .. } => {
            let log = |x: f64| if x > 0.0 { libm::log(x) } else { f64::NEG_INFINITY };
            let logs = Bounds { min: log(within.min), max: log(within.max) };
            let x = libm::exp(cut(libm::log(*median), *beta, logs, p));
            x.clamp(within.min, within.max)
        }
    }
}

/// Of a normal distribution that is cut off.
fn cut(mean: f64, sd: f64, within: Bounds, p: f64) -> f64 {
    let share = |x: f64| normal::cdf((x - mean) / sd);
    let (low, high) = (share(within.min), share(within.max));
    let p = (low + p * (high - low)).clamp(f64::MIN_POSITIVE, 1.0 - f64::EPSILON);
    (mean + sd * normal::quantile(p)).clamp(within.min, within.max)
}

/// Whether nearly nothing of the distribution is left between its bounds, so that all samples would lie on one of them.
pub fn is_empty(distribution: &Distribution) -> bool {
    match distribution {
        Distribution::Normal { .. } | Distribution::Lognormal { .. } => {
            let [low, high] = [0.25, 0.75].map(|p| value_at(distribution, p));
            !(high > low)
        }
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn normal(min: f64, max: f64) -> Distribution {
        Distribution::Normal { mean: 0.6, sd: 0.1, within: Bounds { min, max }, unit: String::new() }
    }

    #[test]
    fn medians_and_quantiles_are_those_of_the_distributions() {
        let unit = String::new;
        let whole = Bounds { min: f64::NEG_INFINITY, max: f64::INFINITY };
        for (distribution, p, value) in [
            (Distribution::Uniform { low: 0.5, high: 1.2, unit: unit() }, 0.5, 0.85),
            (Distribution::LogUniform { low: 1.0, high: 100.0, unit: unit() }, 0.5, 10.0),
            (normal(f64::NEG_INFINITY, f64::INFINITY), 0.975, 0.6 + 0.1 * 1.959_963_984_540_054),
            (
                Distribution::Lognormal { median: 1.2, beta: 0.25, within: whole, unit: unit() },
                0.975,
                1.2 * (0.25 * 1.959_963_984_540_054_f64).exp(),
            ),
        ] {
            let found = value_at(&distribution, p);
            assert!((found / value - 1.0).abs() < 1e-14, "{distribution:?}: {found}");
        }
    }

    #[test]
    fn what_is_cut_off_is_shared_out_over_the_rest() {
        let cut = normal(0.6, 1.0);
        // Of the upper half the median is the upper quartile of all, up to what lies above 1.0 (4 sd).
        assert!((value_at(&cut, 0.5) - (0.6 + 0.1 * 0.674_489_750_196_081_7)).abs() < 1e-5);
        assert!((0..=100).all(|k| (0.6..=1.0).contains(&value_at(&cut, f64::from(k) / 100.0))));
        assert!(!is_empty(&cut) && is_empty(&normal(5.0, 6.0)));
    }
}
