//! A size with which a block comes out that was refused with another.

use super::check::check;
use super::error::LEAST_JACOBIAN;
use super::{CavernError, CavernSpec, build};

/// Sizes of elements that are tried, over that of the description: the nearest first.
const FACTORS: [f64; 20] = [
    0.95, 1.05, 0.9, 1.1, 0.85, 1.15, 0.8, 1.2, 0.75, 1.25, 0.7, 1.3, 0.65, 1.4, 0.6, 1.5, 0.55, 0.5, 0.45,
    0.4,
];

/// Steps in which the thickness of a crown or floor is brought to that of the walls.
const STEPS: u32 = 10;

/// Quadrilaterals within caverns that all trials together may smooth: seconds.
const MOST: f64 = 4000.0;

impl CavernSpec {
    /// The name of a value, as in [`CavernError`], and the length \[m\] nearest to the description's with which the section comes out that was
    /// refused; found by trial. It is the size `near`, of two digits, between 0.4 and 1.5 times the description's, or the thickness of a lining's crown or
    /// floor, which is brought to that of its walls, tried first where it is a lining that is badly shaped. None where no such length does or their
    /// trial would take long, and where a fault is not one of shape.
    pub fn size_that_does(&self, fault: &CavernError) -> Option<(String, f64)> {
        let (named, thickness_first) = match fault {
            CavernError::Poor { cavern, limit, .. } => (Some(cavern), *limit == LEAST_JACOBIAN[1]),
            CavernError::GalleryRows { .. } => (None, false),
            _ => return None,
        };
        let mut thinner = named.map_or(Vec::new(), |name| self.thinner(name));
        let mut trials = self.elements();
        if thickness_first {
            std::mem::swap(&mut trials, &mut thinner);
        }
        trials.extend(thinner);
        let area: f64 = self.caverns.iter().map(|cavern| cavern.width * cavern.height).sum();
        let mut room = MOST;
        for (key, size, spec) in trials {
            room -= area / (spec.near * spec.near);
            if room < 0.0 {
                return None;
            }
            if check(&spec).is_ok() && build::build(&spec).is_ok() {
                return Some((key, size));
            }
        }
        None
    }

    /// The description with other sizes of elements.
    fn elements(&self) -> Vec<(String, f64, CavernSpec)> {
        let mut tried = vec![self.near];
        let mut all = Vec::new();
        for near in FACTORS.map(|factor| two_digits(factor * self.near)) {
            if near <= self.far && !tried.contains(&near) {
                tried.push(near);
                all.push(("size_near".to_owned(), near, CavernSpec { near, ..self.clone() }));
            }
        }
        all
    }

    /// The description with a crown or a floor of a lining nearer to the thickness of its walls.
    fn thinner(&self, cavern: &str) -> Vec<(String, f64, CavernSpec)> {
        let Some(k) = self.caverns.iter().position(|own| own.name == cavern) else { return Vec::new() };
        let lining = &self.caverns[k].lining;
        let mut all = Vec::new();
        for step in (0..STEPS).rev() {
            for (key, thickness) in [("crown", lining.crown), ("floor", lining.floor)] {
                let part = f64::from(step) / f64::from(STEPS);
                // To the centimetre.
                let size = (100.0 * (lining.walls + part * (thickness - lining.walls))).round() / 100.0;
                if thickness == 0.0 || size == thickness || size <= 0.0 {
                    continue;
                }
                let mut spec = self.clone();
                match key {
                    "crown" => spec.caverns[k].lining.crown = size,
                    _ => spec.caverns[k].lining.floor = size,
                }
                all.push((format!("{cavern}.lining.{key}"), size, spec));
            }
        }
        all
    }
}

/// A length above 0 to two digits.
fn two_digits(x: f64) -> f64 {
    format!("{x:.1e}").parse().unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cavern::{Cavern, CavernShape, Lining};

    #[test]
    fn sizes_have_two_digits() {
        assert_eq!([2.8499, 0.0123, 17.0, 9.96].map(two_digits), [2.8, 0.012, 17.0, 10.0]);
    }

    /// A hall with a flat roof that is lined much thicker there than on its walls: the corners lean too much, whatever the elements' size is.
    #[test]
    fn what_is_named_is_taken() {
        let spec = |near: f64, crown: f64| CavernSpec {
            overburden: 60.0,
            below: 40.0,
            sides: 40.0,
            length: 30.0,
            near,
            far: 8.0,
            caverns: vec![Cavern {
                name: "hall".to_owned(),
                shape: CavernShape::Rectangle,
                width: 12.0,
                height: 18.0,
                benches: 3,
                lining: Lining { walls: 0.5, crown, floor: 0.0, layers: 1 },
                ..Cavern::default()
            }],
            ..CavernSpec::default()
        };
        let refused = spec(2.0, 0.9);
        let fault = refused.mesh().unwrap_err();
        assert_eq!(fault.subject(), "hall.lining", "{fault}");
        let (key, crown) = refused.size_that_does(&fault).unwrap();
        assert_eq!(key, "hall.lining.crown");
        assert!(crown > 0.5 && crown < 0.9, "{crown}");
        assert!(spec(2.0, crown).mesh().is_ok());
        // The next thicker one that was tried is not taken.
        assert!(spec(2.0, crown + 0.04).mesh().is_err());
        // What is not of a shape is not tried.
        let fault = CavernSpec { sides: 1.0, ..refused.clone() }.mesh().unwrap_err();
        assert!(refused.size_that_does(&fault).is_none(), "{fault}");
    }
}
