//! The outline of one cavern, clear (intrados) and outside its lining (extrados).
//!
//! Local coordinates: u across from the centre line, v up from the clear floor.

use std::f64::consts::FRAC_PI_2;

use super::Cavern;

/// An arc of a circle over a horizontal chord, symmetric about u = 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arc {
    /// Half the chord.
    pub half: f64,
    /// Height of the crown over the chord.
    pub rise: f64,
    /// Level of the chord.
    pub springing: f64,
    /// Half the angle that the arc subtends at its centre.
    pub angle: f64,
}

impl Arc {
    fn new(half: f64, rise: f64, springing: f64) -> Self {
        Arc { half, rise, springing, angle: 2.0 * rise.atan2(half) }
    }

    fn radius(&self) -> f64 {
        self.half / self.angle.sin()
    }

    /// Length of the arc.
    pub fn length(&self) -> f64 {
        2.0 * self.angle * self.radius()
    }

    /// The point at fraction `s` of the half angle from the crown: −1 left springing, 0 crown, 1 right.
    pub fn point(&self, s: f64) -> [f64; 2] {
        let (angle, radius) = (s * self.angle, self.radius());
        // 2 sin((a+b)/2) sin((a−b)/2) = cos b − cos a loses no digits on flat arcs.
        let up = 2.0 * ((self.angle + angle) / 2.0).sin() * ((self.angle - angle) / 2.0).sin();
        [radius * angle.sin(), self.springing + radius * up]
    }
}

/// Outline of a cavern.
#[derive(Clone, Copy, Debug)]
pub(super) struct Profile {
    pub inner: Arc,
    /// The same arc as `inner` if the cavern is unlined.
    pub outer: Arc,
    /// Thickness of the floor slab, 0 if none.
    pub floor: f64,
}

impl Profile {
    pub fn new(cavern: &Cavern) -> Self {
        let (half, rise) = (cavern.width / 2.0, cavern.arch_rise);
        let inner = Arc::new(half, rise, cavern.height - rise);
        let lining = &cavern.lining;
        if lining.is_none() {
            return Profile { inner, outer: inner, floor: 0.0 };
        }
        // Where wall and arch meet at an angle, the extrados has its corner on the bisector: both parts then
        // have the thickness of the wall there.
        let corner = lining.walls * ((FRAC_PI_2 - inner.angle) / 2.0).tan();
        let outer = Arc::new(half + lining.walls, rise + lining.crown - corner, inner.springing + corner);
        Profile { inner, outer, floor: lining.floor }
    }

    /// Lowest and highest coordinates of the extrados: \[u, v\] each.
    pub fn bounds(&self) -> ([f64; 2], [f64; 2]) {
        // An arc of more than a semicircle is a little wider than its chord.
        let half = if self.outer.angle > FRAC_PI_2 { self.outer.radius() } else { self.outer.half };
        ([-half, -self.floor], [half, self.outer.springing + self.outer.rise])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_arc_meets_its_springings_its_crown_and_its_circle() {
        for (half, rise) in [(8.5, 4.5), (3.6, 2.2), (5.0, 5.0), (5.0, 0.1)] {
            let arc = Arc::new(half, rise, 30.0);
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
}
