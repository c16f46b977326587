//! Ticks of an axis at round numbers.

/// A linear axis with ticks at multiples of 1, 2 or 5 times a power of ten.
#[derive(Clone, Debug, PartialEq)]
pub struct Ticks {
    /// Where the axis begins and ends.
    pub range: (f64, f64),
    /// Position and label of each tick, ascending.
    pub marks: Vec<(f64, String)>,
}

impl Ticks {
    /// An axis with a little room around `low` to `high`; about `wanted` ticks.
    pub fn around(low: f64, high: f64, wanted: usize) -> Ticks {
        let (low, high) = opened(low, high);
        let room = 0.06 * (high - low);
        Ticks::within(low - room, high + room, wanted)
    }

    /// An axis from exactly `low` to `high` with ticks inside.
    pub fn within(low: f64, high: f64, wanted: usize) -> Ticks {
        let (low, high) = opened(low, high);
        let step = step(low, high, wanted);
        Ticks {
            range: (low, high),
            marks: marks((low / step - 1e-9).ceil(), (high / step + 1e-9).floor(), step),
        }
    }

    /// Where a value lies between the ends: 0 to 1, beyond that outside.
    pub fn fraction(&self, value: f64) -> f64 {
        (value - self.range.0) / (self.range.1 - self.range.0)
    }
}

/// A range with some extent, whatever is given.
fn opened(low: f64, high: f64) -> (f64, f64) {
    if !low.is_finite() || !high.is_finite() || high < low {
        return (-1.0, 1.0);
    }
    let size = low.abs().max(high.abs());
    if high - low > 1e-9 * size {
        (low, high)
    } else if size == 0.0 {
        (-1.0, 1.0)
    } else {
        (low - 0.5 * size, high + 0.5 * size)
    }
}

fn step(low: f64, high: f64, wanted: usize) -> f64 {
    let rough = (high - low) / wanted.max(1) as f64;
    let power = 10_f64.powf(rough.log10().floor());
    // The smallest of 1, 2, 5, 10 that gives at most a third more intervals than wanted: a tick too many reads
    // better than half as many as there is room for.
    let factor = [1.0, 2.0, 5.0].into_iter().find(|f| f * power >= 0.75 * rough).unwrap_or(10.0);
    factor * power
}

fn marks(first: f64, last: f64, step: f64) -> Vec<(f64, String)> {
    let decimals = (-(step.log10() + 1e-9).floor()).clamp(0.0, 12.0) as usize;
    let label = |value: f64| {
        let text = format!("{:.decimals$}", value.abs());
        if value < 0.0 && text.contains(|c: char| c.is_ascii_digit() && c != '0') {
            format!("−{text}")
        } else {
            text
        }
    };
    // An axis has few ticks; the bound only guards against a step lost in round-off.
    let number = (last - first).clamp(0.0, 100.0) as i64;
    (0..=number).map(|i| (first + i as f64) * step).map(|value| (value, label(value))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(ticks: &Ticks) -> String {
        ticks.marks.iter().map(|(_, label)| label.as_str()).collect::<Vec<_>>().join(" ")
    }

    #[test]
    fn ticks_are_round_and_inside_the_axis() {
        let ticks = Ticks::around(-47.9, 31.0, 5);
        assert_eq!(labels(&ticks), "−40 −20 0 20");
        assert!(ticks.range.0 < -47.9 && ticks.range.1 > 31.0);
        assert_eq!(labels(&Ticks::around(0.45, 1.64, 4)), "0.5 1.0 1.5");
        assert_eq!(labels(&Ticks::within(0.0, 19.5, 5)), "0 5 10 15");
        assert_eq!(labels(&Ticks::within(0.0, 0.3, 3)), "0.0 0.1 0.2 0.3");
        assert_eq!(labels(&Ticks::within(-0.1, 0.1, 4)), "−0.10 −0.05 0.00 0.05 0.10");
    }

    #[test]
    fn data_without_extent_still_get_an_axis() {
        for (low, high) in [
            (0.0, 0.0),
            (3.0, 3.0),
            (f64::NAN, 1.0),
            (f64::INFINITY, f64::NEG_INFINITY),
            (1e300, 1e300 * (1.0 + 1e-15)),
            (1.0, 1.0 + 1e-15),
            (-1e-320, 1e-320),
        ] {
            let ticks = Ticks::around(low, high, 5);
            assert!(ticks.range.0 < ticks.range.1, "{low} {high} {ticks:?}");
            assert!(ticks.marks.len() < 30);
        }
    }
}
