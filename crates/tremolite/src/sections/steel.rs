//! What bars in a lining add to the forces of its sections.

use super::Station;
use super::ordered::{dot, minus};

/// A bar's segment in a station.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steel {
    /// Set of bolts, bolt in it, segment of that.
    pub segment: [usize; 3],
    /// N, M and Q of the station \[1/m, 1, 1/m\] for a unit of tension in the segment.
    pub shares: [f64; 3],
}

impl Steel {
    /// What a straight segment between two places \[m\] within a station adds to N, M and Q as
    /// [`forces`](super::forces) defines them, for a unit of tension: its share in the way through the station along t, over the
    /// station's width across t; for M with the lever of its middle over the mid-surface. A bar that goes right through counts
    /// once, however it is cut, and one across t not at all.
    pub fn shares(station: &Station, [from, to]: [[f64; 3]; 2]) -> [f64; 3] {
        let way = minus(to, from);
        let [along, out] = [station.along, station.normal].map(|axis| dot(way, axis));
        let length = dot(way, way).sqrt();
        let lever = dot([0, 1, 2].map(|i| 0.5 * (from[i] + to[i]) - station.place[i]), station.normal);
        // How far the station reaches along t at that depth, between that at its faces.
        let [extrados, intrados] = station.faces.each_ref().map(|face| reach(face, station.along));
        let middle = 0.5 * (extrados + intrados);
        let span = middle + lever / station.thickness * (intrados - extrados);
        let width = station.area() / middle;
        let share = along.abs() / span / width / length;
        [share * along.abs(), share * along.abs() * lever, share * along.signum() * out]
    }
}

/// How far a face reaches along a direction: that of the sides that lead that way, in the mean.
fn reach(face: &[[f64; 3]; 4], along: [f64; 3]) -> f64 {
    let side = |a: usize, b: usize, c: usize, d: usize| {
        let way = [0, 1, 2].map(|i| 0.5 * (face[c][i] + face[d][i] - face[a][i] - face[b][i]));
        dot(way, along).abs()
    };
    side(0, 3, 1, 2).max(side(0, 1, 3, 2))
}
