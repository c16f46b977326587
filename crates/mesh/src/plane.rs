//! Planes as geologists give them.

use crate::placement::turn;
use crate::topology::{cross, dot, norm};

/// A plane with a side above it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// A point of it \[m\].
    pub through: [f64; 3],
    /// Unit vector across it, towards the side that is above.
    pub normal: [f64; 3],
}

impl Plane {
    /// The plane that falls at `dip` \[rad\] from level, 0 to π/2, towards `direction` \[rad\], clockwise from y seen from above, as a
    /// compass counts from north. Of an upright plane the side above is the one in that direction, as of one that is nearly so.
    pub fn dipping(through: [f64; 3], dip: f64, direction: f64) -> Plane {
        let ((rise, level), (east, north)) = (turn(dip), turn(direction));
        Plane { through, normal: [rise * east, rise * north, level] }
    }

    /// Distance of a point \[m\], positive above.
    pub fn distance(&self, x: [f64; 3]) -> f64 {
        (0..3).map(|i| self.normal[i] * (x[i] - self.through[i])).sum()
    }

    /// Distance of a point of it from `through` \[m\], measured up or down the dip; on a level plane, any way.
    pub fn reach(&self, x: [f64; 3]) -> f64 {
        let way = [0, 1, 2].map(|i| x[i] - self.through[i]);
        let dip = cross(self.normal, cross(self.normal, [0.0, 0.0, 1.0]));
        match norm(dip) {
            size if size > 1e-9 => (dot(way, dip) / size).abs(),
            _ => norm(way),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_plane_falls_where_a_compass_says() {
        let plane = |dip: f64, direction: f64| {
            Plane::dipping([1.0, 2.0, 3.0], dip.to_radians(), direction.to_radians())
        };
        // A metre on towards the dip direction and down by its tangent lies on the plane; north is y, east x.
        for (direction, way) in
            [(0.0, [0.0, 1.0]), (90.0, [1.0, 0.0]), (180.0, [0.0, -1.0]), (270.0, [-1.0, 0.0])]
        {
            for dip in [0.0f64, 20.0, 45.0, 75.0] {
                let plane = plane(dip, direction);
                let on = [1.0 + way[0], 2.0 + way[1], 3.0 - dip.to_radians().tan()];
                assert!(plane.distance(on).abs() < 1e-15, "{dip} {direction}");
                assert!(plane.distance([1.0, 2.0, 4.0]) > 0.0);
                let along = [on[0] + 5.0 * way[1], on[1] - 5.0 * way[0], on[2]];
                let expected = if dip == 0.0 { 26.0f64.sqrt() } else { 1.0 / dip.to_radians().cos() };
                assert!((plane.reach(along) - expected).abs() < 1e-14, "{dip} {direction}");
            }
            assert_eq!(plane(90.0, direction).normal, [way[0], way[1], 0.0]);
        }
    }
}
