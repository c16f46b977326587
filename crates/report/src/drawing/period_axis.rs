//! An axis of periods, by their logarithm.

use crate::drawing::ticks::Ticks;

/// Periods that are named (s).
const NAMED: [(f64, &str); 10] = [
    (0.01, "0.01"),
    (0.02, "0.02"),
    (0.05, "0.05"),
    (0.1, "0.1"),
    (0.2, "0.2"),
    (0.5, "0.5"),
    (1.0, "1"),
    (2.0, "2"),
    (5.0, "5"),
    (10.0, "10"),
];

/// Where a period (s) stands: the decimal logarithm of its milliseconds, none of which is zero, where axes draw a strong line.
pub fn place(period: f64) -> f64 {
    (1e3 * period).log10()
}

/// The axis from one period to another (s).
pub fn axis(low: f64, high: f64) -> Ticks {
    let range = (place(low), place(high));
    let inside = |period: &f64| (low * (1.0 - 1e-9)..=high * (1.0 + 1e-9)).contains(period);
    let named = NAMED.iter().filter(|(period, _)| inside(period));
    Ticks { range, marks: named.map(|(period, name)| (place(*period), (*name).to_owned())).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_ratios_are_equally_far_apart() {
        let axis = axis(0.02, 10.0);
        let names: Vec<&str> = axis.marks.iter().map(|(_, name)| name.as_str()).collect();
        assert_eq!(names, ["0.02", "0.05", "0.1", "0.2", "0.5", "1", "2", "5", "10"]);
        let at = |period: f64| axis.fraction(place(period));
        assert!(at(0.02).abs() < 1e-12 && (at(10.0) - 1.0).abs() < 1e-12);
        assert!((at(0.2) - at(0.02) - (at(10.0) - at(1.0))).abs() < 1e-12);
        assert!(axis.marks.iter().all(|(place, _)| *place != 0.0));
    }
}
