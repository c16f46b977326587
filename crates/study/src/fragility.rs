//! Fragility curves by maximum likelihood: the probability that a limit is exceeded at an intensity x is Φ(ln(x/θ)/β).
//!
//! Stripes are binomial (`baker2015`), which is a probit regression on ln x; of rising levels that end where the limit is
//! exceeded, or before it is, the likelihood is that of a sample cut off from above (ibid., truncated incremental dynamic analysis). Both are concave in the parameters that they are maximised in, so there is one maximum or none, and none is said.

use crate::normal;

/// Intensities that differ by less, over their size, are one level: factors are told to ten digits.
const SAME: f64 = 1e-6;

/// A β from which on a curve does not rise: between one share of runs in six and five in six, e²⁰ times the intensity (assumption).
const FLAT: f64 = 10.0;

/// One run of a stripe.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen {
    /// Intensity, above 0.
    pub intensity: f64,
    pub exceeded: bool,
    /// What a bootstrap draws together: the number of the record.
    pub cluster: usize,
}

/// One series of rising levels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Risen {
    /// Where the limit was exceeded, or the highest level at which it was not; above 0.
    pub intensity: f64,
    pub exceeded: bool,
    /// What a bootstrap draws together: the number of the record.
    pub cluster: usize,
}

/// A lognormal curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Curve {
    /// Median, in the unit of the intensities.
    pub theta: f64,
    /// Standard deviation of the logarithm.
    pub beta: f64,
    /// Of ln θ and β, from the curvature of the likelihood.
    pub covariance: [[f64; 2]; 2],
    pub log_likelihood: f64,
}

impl Curve {
    /// The probability at an intensity.
    pub fn at(&self, intensity: f64) -> f64 {
        normal::cdf(libm::log(intensity / self.theta) / self.beta)
    }
}

/// Why data have no curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoCurve {
    /// There are none.
    NoData,
    /// The limit is exceeded in no run, up to this intensity.
    Never { highest: f64 },
    /// It is exceeded in every run, from this intensity on.
    Always { lowest: f64 },
    /// It is exceeded in no run up to `below` and in every run from `above` on: θ lies between them, and β cannot be told from 0.
    Separated { below: f64, above: f64 },
    /// It is exceeded at the highest intensity alone, in so many of the runs there.
    HighestAlone { level: f64, exceeded: usize, of: usize },
    /// It is not exceeded more often at higher intensities.
    Falling,
    /// Fewer than two different intensities at which it was exceeded, or so few that nothing follows.
    TooFew,
}

/// The curve of stripes.
///
/// # Errors
/// Why there is none.
pub fn of_stripes(seen: &[Seen]) -> Result<Curve, NoCurve> {
    let ends = |exceeded: bool| {
        let found = seen.iter().filter(|s| s.exceeded == exceeded).map(|s| s.intensity);
        found.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| (low.min(x), high.max(x)))
    };
    let ((lowest, highest), (lowest_left, highest_left)) = (ends(true), ends(false));
    match (lowest.is_finite(), lowest_left.is_finite()) {
        (false, false) => return Err(NoCurve::NoData),
        (false, true) => return Err(NoCurve::Never { highest: highest_left }),
        (true, false) => return Err(NoCurve::Always { lowest }),
        (true, true) => {}
    }
    // Levels that are equal may differ in the digits that factors are told with.
    if highest_left.max(highest) <= lowest * (1.0 + SAME) {
        let there = |s: &&Seen| s.intensity * (1.0 + SAME) >= lowest;
        let of = seen.iter().filter(there).count();
        let exceeded = seen.iter().filter(there).filter(|s| s.exceeded).count();
        return Err(NoCurve::HighestAlone { level: lowest, exceeded, of });
    }
    if highest_left <= lowest * (1.0 + SAME) {
        return Err(NoCurve::Separated { below: highest_left, above: lowest });
    }
    if highest <= lowest_left * (1.0 + SAME) {
        return Err(NoCurve::Falling);
    }
    // About the mean, so that the two parameters are nearly independent.
    let logs: Vec<f64> = seen.iter().map(|s| libm::log(s.intensity)).collect();
    let mean = logs.iter().sum::<f64>() / logs.len() as f64;
    let likelihood = |[a, b]: [f64; 2]| {
        let mut sum = Local::default();
        for (x, s) in logs.iter().zip(seen) {
            let (x, sign) = (x - mean, if s.exceeded { 1.0 } else { -1.0 });
            let eta = sign * (a + b * x);
            let slope = normal::hazard(eta);
            sum.add(normal::log_cdf(eta), sign * slope, -slope * (slope + eta), [1.0, x]);
        }
        sum
    };
    let spread = logs.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / logs.len() as f64;
    let share = seen.iter().filter(|s| s.exceeded).count() as f64 / seen.len() as f64;
    let start = [normal::quantile(share), 1.0 / spread.sqrt().max(0.1)];
    let ([a, b], at) = newton(likelihood, start, |_| true).ok_or(NoCurve::TooFew)?;
    if !(b > 1.0 / FLAT) {
        return Err(NoCurve::Falling);
    }
    // ln θ = mean − a/b, β = 1/b.
    let jacobian = [[-1.0 / b, a / (b * b)], [0.0, -1.0 / (b * b)]];
    let theta = libm::exp(mean - a / b);
    Ok(Curve { theta, beta: 1.0 / b, covariance: at.covariance(jacobian), log_likelihood: at.value })
}

/// The curve of rising levels.
///
/// # Errors
/// Why there is none.
pub fn of_risen(risen: &[Risen]) -> Result<Curve, NoCurve> {
    let exceeded: Vec<f64> = risen.iter().filter(|r| r.exceeded).map(|r| libm::log(r.intensity)).collect();
    let highest = risen.iter().map(|r| r.intensity).fold(f64::NEG_INFINITY, f64::max);
    if risen.is_empty() {
        return Err(NoCurve::NoData);
    }
    if exceeded.is_empty() {
        return Err(NoCurve::Never { highest });
    }
    let n = exceeded.len() as f64;
    let mean = exceeded.iter().sum::<f64>() / n;
    let spread = exceeded.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / n;
    if spread < 1e-18 {
        return Err(NoCurve::TooFew);
    }
    // In 1/β and (ln θ − mean)/β (`olsen1978`).
    let likelihood = |[p, q]: [f64; 2]| {
        let mut sum = Local::default();
        for r in risen {
            let x = libm::log(r.intensity) - mean;
            let z = p * x - q;
            if r.exceeded {
                sum.add(
                    -0.5 * z * z - 0.5 * libm::log(2.0 * std::f64::consts::PI) + libm::log(p),
                    -z,
                    -1.0,
                    [x, -1.0],
                );
                sum.gradient[0] += 1.0 / p;
                sum.curvature[0][0] -= 1.0 / (p * p);
            } else {
                let slope = normal::hazard(-z);
                sum.add(normal::log_cdf(-z), -slope, -slope * (slope - z), [x, -1.0]);
            }
        }
        sum
    };
    let ([p, q], at) =
        newton(likelihood, [1.0 / spread.sqrt(), 0.0], |[p, _]| p > 0.0).ok_or(NoCurve::TooFew)?;
    if !(p > 1.0 / FLAT) {
        return Err(NoCurve::TooFew);
    }
    let jacobian = [[-q / (p * p), 1.0 / p], [-1.0 / (p * p), 0.0]];
    let theta = libm::exp(mean + q / p);
    Ok(Curve { theta, beta: 1.0 / p, covariance: at.covariance(jacobian), log_likelihood: at.value })
}

/// A likelihood with its first and second derivatives at one place.
#[derive(Clone, Copy, Debug, Default)]
struct Local {
    value: f64,
    gradient: [f64; 2],
    curvature: [[f64; 2]; 2],
}

impl Local {
    /// A term that goes by η = w·x alone, with its first and second derivative by η.
    fn add(&mut self, value: f64, slope: f64, curvature: f64, x: [f64; 2]) {
        self.value += value;
        for i in 0..2 {
            self.gradient[i] += slope * x[i];
            for j in 0..2 {
                self.curvature[i][j] += curvature * x[i] * x[j];
            }
        }
    }

    /// The inverse of minus the curvature.
    fn inverse(&self) -> Option<[[f64; 2]; 2]> {
        let [[a, b], [_, c]] = self.curvature;
        let determinant = a * c - b * b;
        (determinant > 0.0 && a < 0.0)
            .then(|| [[-c / determinant, b / determinant], [b / determinant, -a / determinant]])
    }

    /// Of other parameters, with the derivatives `jacobian` of these by the ones it was maximised in.
    fn covariance(&self, jacobian: [[f64; 2]; 2]) -> [[f64; 2]; 2] {
        let Some(inverse) = self.inverse() else { return [[f64::NAN; 2]; 2] };
        let mut out = [[0.0; 2]; 2];
        for (i, j, k, l) in quadruples() {
            out[i][j] += jacobian[i][k] * inverse[k][l] * jacobian[j][l];
        }
        // To the last bit.
        out[1][0] = out[0][1];
        out
    }
}

fn quadruples() -> impl Iterator<Item = (usize, usize, usize, usize)> {
    (0..16).map(|n| (n & 1, n >> 1 & 1, n >> 2 & 1, n >> 3 & 1))
}

/// The maximum of a concave likelihood, and what it is like there; nothing where it has none.
fn newton(
    likelihood: impl Fn([f64; 2]) -> Local,
    start: [f64; 2],
    allowed: impl Fn([f64; 2]) -> bool,
) -> Option<([f64; 2], Local)> {
    let mut place = start;
    let mut here = likelihood(place);
    for _ in 0..200 {
        let inverse = here.inverse()?;
        let step = [0, 1].map(|i| inverse[i][0] * here.gradient[0] + inverse[i][1] * here.gradient[1]);
        // Twice what the step gains of the likelihood, to second order.
        let gain = step[0] * here.gradient[0] + step[1] * here.gradient[1];
        // Newton's method doubles the digits with a step: the last one goes to round-off.
        if gain < 1e-14 {
            let last = [0, 1].map(|i| place[i] + step[i]);
            return Some((last, likelihood(last)));
        }
        let mut length = 1.0;
        let next = loop {
            let next = [0, 1].map(|i| place[i] + length * step[i]);
            let there = if allowed(next) { Some(likelihood(next)) } else { None };
            match there {
                // To the last digit a step that gains nothing is the end of the way.
                Some(there) if there.value >= here.value => break Some((next, there)),
                _ if length < 1e-9 => break None,
                _ => length *= 0.5,
            }
        };
        let Some((next, there)) = next else { return Some((place, here)) };
        (place, here) = (next, there);
    }
    None
}

#[cfg(test)]
mod tests;
