//! A size of elements with which a block comes out that was refused with another.

use super::check::check;
use super::{CavernError, CavernSpec, build};

/// Sizes that are tried, over that of the description: the nearest first.
const FACTORS: [f64; 20] = [
    0.95, 1.05, 0.9, 1.1, 0.85, 1.15, 0.8, 1.2, 0.75, 1.25, 0.7, 1.3, 0.65, 1.4, 0.6, 1.5, 0.55, 0.5, 0.45,
    0.4,
];

/// Quadrilaterals within caverns that all trials together may smooth: seconds.
const MOST: f64 = 4000.0;

impl CavernSpec {
    /// The `near` \[m\], of two digits, nearest to the description's with which the section comes out that was refused with it. It is found by trial,
    /// between 0.4 and 1.5 times the description's. None where no size of these does or their trial would take long, and where a fault is not one of
    /// this size.
    pub fn near_that_does(&self, fault: &CavernError) -> Option<f64> {
        if !matches!(fault, CavernError::Poor { .. } | CavernError::GalleryRows { .. }) {
            return None;
        }
        let area: f64 = self.caverns.iter().map(|cavern| cavern.width * cavern.height).sum();
        let mut room = MOST;
        let mut tried = vec![self.near];
        for near in FACTORS.map(|factor| two_digits(factor * self.near)) {
            if near > self.far || tried.contains(&near) {
                continue;
            }
            tried.push(near);
            room -= area / (near * near);
            if room < 0.0 {
                return None;
            }
            let spec = CavernSpec { near, ..self.clone() };
            if check(&spec).is_ok() && build::build(&spec).is_ok() {
                return Some(near);
            }
        }
        None
    }
}

/// A length above 0 to two digits.
fn two_digits(x: f64) -> f64 {
    format!("{x:.1e}").parse().unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes_have_two_digits() {
        assert_eq!([2.8499, 0.0123, 17.0, 9.96].map(two_digits), [2.8, 0.012, 17.0, 10.0]);
    }
}
