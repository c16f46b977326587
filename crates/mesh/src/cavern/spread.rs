//! Elements between stops at unlike distances: small where two stops are close, growing from there.

use super::stretch::GROWTH;

/// Samples of the wanted size within an interval.
const SAMPLES: usize = 32;

/// The size \[m\] that is wanted along a line with nodes at given stops: `most`, but no more than the length of an
/// interval, and beside a short interval no more than growth from it allows.
pub(super) struct Spread<'a> {
    stops: &'a [f64],
    most: f64,
}

impl Spread<'_> {
    /// `stops` rise; there are at least two.
    pub fn new(stops: &[f64], most: f64) -> Spread<'_> {
        Spread { stops, most }
    }

    fn size(&self, at: f64) -> f64 {
        let slope = GROWTH.ln();
        let near = |pair: &[f64]| {
            let away = (pair[0] - at).max(at - pair[1]).max(0.0);
            pair[1] - pair[0] + slope * away
        };
        self.stops.windows(2).map(near).fold(self.most, f64::min)
    }

    /// Elements counted from the start of interval `i` to each of its samples' ends.
    fn counted(&self, i: usize) -> Vec<f64> {
        let step = (self.stops[i + 1] - self.stops[i]) / SAMPLES as f64;
        let mut sum = 0.0;
        (0..SAMPLES)
            .map(|k| {
                sum += step / self.size(self.stops[i] + (k as f64 + 0.5) * step);
                sum
            })
            .collect()
    }

    /// Elements that interval `i` would like to have; not a whole number.
    pub fn wanted(&self, i: usize) -> f64 {
        self.counted(i)[SAMPLES - 1]
    }

    /// Appends the ends of `n` elements in interval `i`, sized in proportion to what is wanted.
    pub fn fill(&self, i: usize, n: usize, line: &mut Vec<f64>) {
        let (counted, from, to) = (self.counted(i), self.stops[i], self.stops[i + 1]);
        let step = (to - from) / SAMPLES as f64;
        for k in 1..n {
            let share = counted[SAMPLES - 1] * k as f64 / n as f64;
            let sample = counted.partition_point(|c| *c < share).min(SAMPLES - 1);
            let before = if sample == 0 { 0.0 } else { counted[sample - 1] };
            let within = (share - before) / (counted[sample] - before);
            line.push(from + step * (sample as f64 + within));
        }
        line.push(to);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_intervals_are_even_and_short_ones_spread_into_their_neighbours() {
        let stops = [0.0, 10.0, 11.0, 31.0];
        let spread = Spread::new(&stops, 4.0);
        assert!((spread.wanted(1) - 1.0).abs() < 1e-12);
        let mut line = vec![11.0];
        spread.fill(2, 8, &mut line);
        let sizes: Vec<f64> = line.windows(2).map(|p| p[1] - p[0]).collect();
        assert_eq!((line.len(), line[8]), (9, 31.0));
        assert!(sizes[0] < 1.5 && sizes.windows(2).all(|s| s[1] >= s[0] * 0.999), "{sizes:?}");
        let even = Spread::new(&[0.0, 8.0, 20.0], 2.0).wanted(1);
        assert!((even - 6.0).abs() < 1e-12);
    }
}
