//! The outline of a cavern with a flat floor and straight walls: clear (intrados), outside its lining (extrados), and
//! outside its shotcrete.
//!
//! Local coordinates: u across from the centre line, v up from the clear floor.

use std::f64::consts::FRAC_PI_2;

use super::tube::Tube;
use super::{Cavern, CavernShape};

/// What a roof is between its springings.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Bend {
    Circle,
    Ellipse,
    Flat,
}

/// A roof over a horizontal chord, symmetric about u = 0: an arc of a circle, half an ellipse, or the chord
/// itself.
#[derive(Clone, Copy, Debug)]
pub(super) struct Roof {
    /// Half the chord.
    pub half: f64,
    /// Height of the crown over the chord.
    pub rise: f64,
    /// Level of the chord.
    pub springing: f64,
    /// Angle between roof and chord at the springing: π/2 where the wall runs smoothly into the roof, 0 if flat.
    /// Of an arc of a circle this is half the angle that it subtends at its centre.
    pub angle: f64,
    bend: Bend,
}

impl Roof {
    fn arc(half: f64, rise: f64, springing: f64) -> Self {
        Roof { half, rise, springing, angle: 2.0 * rise.atan2(half), bend: Bend::Circle }
    }

    fn ellipse(half: f64, rise: f64, springing: f64) -> Self {
        Roof { half, rise, springing, angle: FRAC_PI_2, bend: Bend::Ellipse }
    }

    fn flat(half: f64, level: f64) -> Self {
        Roof { half, rise: 0.0, springing: level, angle: 0.0, bend: Bend::Flat }
    }

    /// The roof round this one, so much farther out at its walls and its crown.
    fn around(&self, walls: f64, crown: f64) -> Self {
        match self.bend {
            Bend::Ellipse => Roof::ellipse(self.half + walls, self.rise + crown, self.springing),
            Bend::Flat => Roof::flat(self.half + walls, self.springing + crown),
            Bend::Circle => {
                // Where wall and arch meet at an angle, the outside has its corner on the bisector: both parts
                // then have the thickness of the wall there.
                let corner = walls * ((FRAC_PI_2 - self.angle) / 2.0).tan();
                Roof::arc(self.half + walls, self.rise + crown - corner, self.springing + corner)
            }
        }
    }

    fn radius(&self) -> f64 {
        self.half / self.angle.sin()
    }

    /// Length from springing to springing.
    pub fn length(&self) -> f64 {
        match self.bend {
            Bend::Circle => 2.0 * self.angle * self.radius(),
            Bend::Ellipse => {
                // Half of Ramanujan's second formula for the perimeter, good to 1 in 10⁴ and better.
                let (a, b) = (self.half, self.rise);
                let h = ((a - b) / (a + b)).powi(2);
                FRAC_PI_2 * (a + b) * (1.0 + 3.0 * h / (10.0 + (4.0 - 3.0 * h).sqrt()))
            }
            Bend::Flat => 2.0 * self.half,
        }
    }

    /// The point at fraction `s` from the crown: −1 left springing, 0 crown, 1 right. A fraction of the angle at
    /// the centre of a circle, of the eccentric angle of an ellipse (points are then closer where it bends more).
    pub fn point(&self, s: f64) -> [f64; 2] {
        match self.bend {
            Bend::Circle => {
                let (angle, radius) = (s * self.angle, self.radius());
                // 2 sin((a+b)/2) sin((a−b)/2) = cos b − cos a loses no digits on flat arcs.
                let up = 2.0 * ((self.angle + angle) / 2.0).sin() * ((self.angle - angle) / 2.0).sin();
                [radius * angle.sin(), self.springing + radius * up]
            }
            Bend::Ellipse => {
                let (sin, cos) = (s * FRAC_PI_2).sin_cos();
                // At the springing the cosine is not quite zero.
                let up = if s.abs() < 1.0 { self.rise * cos } else { 0.0 };
                [self.half * sin, self.springing + up]
            }
            Bend::Flat => [s * self.half, self.springing],
        }
    }
}

/// Outline of a cavern with a flat floor and straight walls.
#[derive(Clone, Copy, Debug)]
pub(super) struct Profile {
    pub inner: Roof,
    /// Outside of the lining; the same as `inner` if the cavern is unlined.
    pub lined: Roof,
    /// Outside of the shotcrete; the same as `lined` if there is none.
    pub outer: Roof,
    /// Thickness of the floor slab, or of the row of rock in its place; 0 if none.
    pub floor: f64,
}

impl Profile {
    /// Of shapes that are closed curves it is not the outline; see `tube`.
    pub fn new(cavern: &Cavern) -> Self {
        let (half, rise) = (cavern.width / 2.0, cavern.arch_rise);
        let lining = &cavern.lining;
        let inner = match cavern.shape {
            CavernShape::Ellipse => Roof::ellipse(half, rise, cavern.height - rise),
            CavernShape::Rectangle => Roof::flat(half, cavern.height),
            _ => Roof::arc(half, rise, cavern.height - rise),
        };
        let lined = if lining.is_none() { inner } else { inner.around(lining.walls, lining.crown) };
        let sprayed = cavern.shotcrete.thickness;
        let outer = if cavern.shotcrete.is_none() { lined } else { lined.around(sprayed, sprayed) };
        Profile { inner, lined, outer, floor: lining.floor }
    }

    /// Lowest and highest coordinates of the outside: \[u, v\] each.
    pub fn bounds(&self) -> ([f64; 2], [f64; 2]) {
        // An arc of more than a semicircle is a little wider than its chord.
        let half = if self.outer.angle > FRAC_PI_2 { self.outer.radius() } else { self.outer.half };
        ([-half, -self.floor], [half, self.outer.springing + self.outer.rise])
    }
}

/// Either kind of outline.
#[derive(Clone, Debug)]
pub(super) enum Outline {
    Walls(Profile),
    Closed(Tube),
}

impl Outline {
    pub fn new(cavern: &Cavern) -> Self {
        if cavern.shape.is_closed() {
            Outline::Closed(Tube::new(cavern))
        } else {
            Outline::Walls(Profile::new(cavern))
        }
    }

    /// Lowest and highest coordinates of the outside: \[u, v\] each.
    pub fn bounds(&self) -> ([f64; 2], [f64; 2]) {
        match self {
            Outline::Walls(profile) => profile.bounds(),
            Outline::Closed(tube) => tube.bounds(),
        }
    }

    /// Length of the roof and height of the walls, clear, for counting elements.
    pub fn lengths(&self) -> [f64; 2] {
        match self {
            Outline::Walls(profile) => [profile.inner.length(), profile.inner.springing],
            Outline::Closed(tube) => [tube.crown_length(), tube.wall_length()],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arc_meets_its_springings_its_crown_and_its_circle() {
        for (half, rise) in [(8.5, 4.5), (3.6, 2.2), (5.0, 5.0), (5.0, 0.1)] {
            let arc = Roof::arc(half, rise, 30.0);
            let radius = (half * half + rise * rise) / (2.0 * rise);
            assert!((arc.radius() / radius - 1.0).abs() < 1e-12);
            for (s, exact) in [(-1.0, [-half, 30.0]), (0.0, [0.0, 30.0 + rise]), (1.0, [half, 30.0])] {
                let p = arc.point(s);
                assert!(
                    (p[0] - exact[0]).abs() < 1e-12 && (p[1] - exact[1]).abs() < 1e-12,
                    "{p:?} {exact:?}"
                );
            }
            let p = arc.point(0.37);
            let centre = 30.0 + rise - radius;
            assert!(((p[0].hypot(p[1] - centre)) / radius - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn an_ellipse_has_its_length_and_meets_its_springings_level_with_them() {
        for (half, rise) in [(8.5, 4.5), (3.0, 5.0), (5.0, 5.0)] {
            let roof = Roof::ellipse(half, rise, 30.0);
            assert_eq!(roof.point(-1.0), [-half, 30.0]);
            assert_eq!(roof.point(0.0), [0.0, 30.0 + rise]);
            let points: Vec<[f64; 2]> = (0..=4000).map(|i| roof.point(i as f64 / 2000.0 - 1.0)).collect();
            let length: f64 = points.windows(2).map(|p| (p[1][0] - p[0][0]).hypot(p[1][1] - p[0][1])).sum();
            // A polygon of n chords is short by about the square of its step.
            assert!((roof.length() / length - 1.0).abs() < 1e-6, "{} {length}", roof.length());
            let p = roof.point(0.37);
            assert!(((p[0] / half).powi(2) + ((p[1] - 30.0) / rise).powi(2) - 1.0).abs() < 1e-12);
        }
    }
}
