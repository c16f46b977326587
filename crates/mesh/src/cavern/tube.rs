//! The outline of a cavern that is a closed curve, circle or horseshoe, clear (intrados) and outside its lining
//! (extrados).
//!
//! Four sides meet at four corners: the crown above, a wall on either side, the invert below. Of a circle each is
//! a quarter. A horseshoe's crown and the upper part of its walls are a semicircle as wide as the cavern; below,
//! each wall is an arc round the opposite springing with the width for its radius; the invert is an arc round the
//! crown with the height for its radius. With height equal to width this is the standard horseshoe.
//!
//! Local coordinates: u across from the centre line, v up from the lowest clear point.

use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4};

use super::{Cavern, CavernShape, Lining};

/// Height of a horseshoe over its width, from and to: lower it has no walls, higher its invert gets narrow.
pub(super) const HORSESHOE: [f64; 2] = [0.75, 1.1];

/// A point of an outline: on the intrados, outside the lining, outside the shotcrete.
pub(super) type Across = [[f64; 2]; 3];

/// Outline of a cavern.
#[derive(Clone, Debug)]
pub(super) struct Tube {
    /// Half the width, the radius of the crown.
    radius: f64,
    pub height: f64,
    /// Level of the crown's centre.
    centre: f64,
    /// Right end of the invert.
    foot: [f64; 2],
    horseshoe: bool,
    lining: Lining,
    /// Thickness of the shotcrete.
    shotcrete: f64,
}

impl Tube {
    pub fn new(cavern: &Cavern) -> Self {
        let radius = cavern.width / 2.0;
        let horseshoe = cavern.shape == CavernShape::Horseshoe;
        let (height, foot) = if horseshoe {
            let foot = foot(radius, cavern.height);
            (cavern.height, foot)
        } else {
            (2.0 * radius, [radius * FRAC_1_SQRT_2, radius * (1.0 - FRAC_1_SQRT_2)])
        };
        let (centre, lining) = (height - radius, cavern.lining.clone());
        Tube { radius, height, centre, foot, horseshoe, lining, shotcrete: cavern.shotcrete.thickness }
    }

    /// Lowest and highest level of the walls.
    pub fn wall(&self) -> [f64; 2] {
        [self.foot[1], self.centre + self.radius * FRAC_1_SQRT_2]
    }

    /// Length of the crown between its corners.
    pub fn crown_length(&self) -> f64 {
        2.0 * FRAC_PI_4 * self.radius
    }

    /// Length of a wall, near enough to count elements.
    pub fn wall_length(&self) -> f64 {
        let [low, high] = self.wall();
        let n = 32;
        let point = |i: usize| self.wall_point(low + (high - low) * i as f64 / n as f64)[0];
        (0..n).map(|i| (point(i + 1)[0] - point(i)[0]).hypot(point(i + 1)[1] - point(i)[1])).sum()
    }

    /// Half the clear width at a level.
    pub fn half_width(&self, v: f64) -> f64 {
        let up = v - self.centre;
        if up < 0.0 && self.horseshoe {
            ((2.0 * self.radius).powi(2) - up * up).sqrt() - self.radius
        } else {
            (self.radius * self.radius - up * up).sqrt()
        }
    }

    /// The outline on the right wall, by the level of the intrados.
    pub fn wall_point(&self, v: f64) -> Across {
        let inner = [self.half_width(v), v];
        let up = v - self.centre;
        if !self.horseshoe || up >= 0.0 {
            return self.round(inner);
        }
        let width = 2.0 * self.radius;
        let normal = [(inner[0] + self.radius) / width, up / width];
        if v <= self.foot[1] {
            // On the bisector both parts have the thickness of the walls.
            let down = self.invert_normal(1.0);
            let share = 1.0 / (1.0 + normal[0] * down[0] + normal[1] * down[1]);
            let bisector = [0, 1].map(|c| share * (normal[c] + down[c]));
            return self.out(inner, bisector, self.lining.walls);
        }
        self.out(inner, normal, self.lining.walls)
    }

    /// The outline on the crown, −1 left corner, 1 right.
    pub fn crown_point(&self, s: f64) -> Across {
        let (sin, cos) = (s * FRAC_PI_4).sin_cos();
        self.round([self.radius * sin, self.centre + self.radius * cos])
    }

    /// The outline on the invert, −1 left corner, 1 right.
    pub fn invert_point(&self, s: f64) -> Across {
        if !self.horseshoe {
            let (sin, cos) = (s * FRAC_PI_4).sin_cos();
            return self.round([self.radius * sin, self.centre - self.radius * cos]);
        }
        let n = self.invert_normal(s);
        let inner = [self.height * n[0], self.height * (1.0 + n[1])];
        if s.abs() >= 1.0 {
            let [_, lined, outer] = self.wall_point(self.foot[1]);
            let here = |p: [f64; 2]| [s.signum() * p[0], p[1]];
            return [inner, here(lined), here(outer)];
        }
        let t = self.lining.floor + (self.lining.walls - self.lining.floor) * s * s;
        self.out(inner, n, t)
    }

    /// From a point of the intrados along a way of which one metre is a metre of thickness: the lining, then the shotcrete.
    fn out(&self, inner: [f64; 2], way: [f64; 2], lining: f64) -> Across {
        let at = |t: f64| [inner[0] + t * way[0], inner[1] + t * way[1]];
        [inner, at(lining), at(lining + self.shotcrete)]
    }

    /// Outward normal of a horseshoe's invert.
    fn invert_normal(&self, s: f64) -> [f64; 2] {
        let half = (self.foot[0] / self.height).asin();
        let (sin, cos) = (s * half).sin_cos();
        [sin, -cos]
    }

    /// The outline over a point of the circle: the lining's thickness goes from that of the walls at mid-height to that
    /// of crown and floor with the square of the sine of the angle.
    fn round(&self, inner: [f64; 2]) -> Across {
        let normal = [inner[0] / self.radius, (inner[1] - self.centre) / self.radius];
        let end = if normal[1] >= 0.0 { self.lining.crown } else { self.lining.floor };
        let t = self.lining.walls + (end - self.lining.walls) * normal[1] * normal[1];
        self.out(inner, normal, t)
    }

    /// Lowest and highest coordinates of the outside: \[u, v\] each.
    pub fn bounds(&self) -> ([f64; 2], [f64; 2]) {
        let l = &self.lining;
        let half = self.radius + l.walls + self.shotcrete;
        ([-half, -l.floor - self.shotcrete], [half, self.height + l.crown + self.shotcrete])
    }
}

/// The right end of a horseshoe's invert: where the circle round the crown meets the wall.
fn foot(radius: f64, height: f64) -> [f64; 2] {
    let half = |depth: f64| ((2.0 * radius).powi(2) - depth * depth).sqrt() - radius;
    let (mut low, mut high) = (0.0, height - radius);
    for _ in 0..200 {
        let depth = 0.5 * (low + high);
        if half(depth).hypot(depth + radius) < height {
            low = depth;
        } else {
            high = depth;
        }
    }
    let depth = 0.5 * (low + high);
    [half(depth), height - radius - depth]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cavern::Shotcrete;

    fn cavern(shape: CavernShape, height: f64) -> Cavern {
        let lining = Lining { walls: 0.4, crown: 0.6, floor: 0.5, layers: 1 };
        let shotcrete = Shotcrete { thickness: 0.15, layers: 1 };
        Cavern { width: 10.0, height, shape, lining, shotcrete, ..Cavern::default() }
    }

    #[test]
    fn the_standard_horseshoe_has_its_known_proportions() {
        let tube = Tube::new(&cavern(CavernShape::Horseshoe, 10.0));
        // The invert's corner of the 2r horseshoe: half width and depth below the springing are both
        // r (√7 − 1)/2, from (√(4r² − d²) − r)² + (d + r)² = 4r².
        let exact = 5.0 * (7.0_f64.sqrt() - 1.0) / 2.0;
        assert!((tube.foot[0] - exact).abs() < 1e-12 && (tube.foot[1] - (5.0 - exact)).abs() < 1e-12);
        assert_eq!(tube.invert_point(0.0)[0], [0.0, 0.0]);
        let [corner, ..] = tube.invert_point(1.0);
        assert!((corner[0] - tube.foot[0]).abs() < 1e-12 && (corner[1] - tube.foot[1]).abs() < 1e-12);
    }

    #[test]
    fn sides_meet_at_the_corners_and_linings_have_their_thickness() {
        for (shape, height) in
            [(CavernShape::Circle, 10.0), (CavernShape::Horseshoe, 8.0), (CavernShape::Horseshoe, 10.8)]
        {
            let tube = Tube::new(&cavern(shape, height));
            let far = |p: [f64; 2], q: [f64; 2]| (p[0] - q[0]).hypot(p[1] - q[1]);
            let near = |a: Across, b: Across| {
                assert!((0..3).all(|i| far(a[i], b[i]) < 1e-9), "{shape:?} {a:?} {b:?}");
            };
            near(tube.wall_point(tube.wall()[1]), tube.crown_point(1.0));
            near(tube.wall_point(tube.wall()[0]), tube.invert_point(1.0));
            assert!((tube.crown_point(0.0)[1][1] - height - 0.6).abs() < 1e-12);
            assert!((tube.invert_point(0.0)[1][1] + 0.5).abs() < 1e-12);
            let [inner, lined, outer] = tube.wall_point(tube.centre).map(|p| p[0]);
            assert!(
                (inner - 5.0).abs() < 1e-12 && (lined - 5.4).abs() < 1e-12 && (outer - 5.55).abs() < 1e-12
            );
            for v in [0.3, 0.6, 0.9] {
                let [low, high] = tube.wall();
                let [_, lined, outer] = tube.wall_point(low + v * (high - low));
                assert!((far(lined, outer) - 0.15).abs() < 1e-12, "{shape:?} {v}");
            }
        }
    }
}
