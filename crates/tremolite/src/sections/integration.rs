//! The forces of a station as sums over points: what [`forces`](super::forces) integrates, worked out once for many times.

use super::ordered::{centre, dot, face, minus};
use super::{Station, place};
use tremolite_laws::shapes::hex8::Points;
use tremolite_mesh::Mesh;

/// A point of a station: its index among all points, its share of the thickness \[m\], and its lever over the mid-surface \[m\].
#[derive(Clone, Copy, Debug)]
struct Share {
    point: u32,
    height: f64,
    lever: f64,
}

/// How stresses make the forces of a station.
#[derive(Clone, Debug)]
pub struct Integration {
    shares: Vec<Share>,
    /// σ_tt and σ_tn in the six components of the stress.
    direct: [f64; 6],
    across: [f64; 6],
}

impl Integration {
    /// Of a station; `slot` gives an element's first point and where its points lie. Nothing where an element takes no part.
    ///
    /// # Panics
    /// If an element of the station is not in the mesh.
    pub fn of(
        mesh: &Mesh,
        station: &Station,
        slot: impl Fn(u32) -> Option<(u32, Points)>,
    ) -> Option<Integration> {
        let mut shares = Vec::new();
        for &(element, axis) in &station.stack {
            let (first, places) = slot(element)?;
            let [near, far] = [0, 1].map(|end| centre(&face(mesh, element, axis, end)));
            let height = dot(minus(far, near), station.normal).abs();
            for (p, share) in places.quadrature.shares().iter().enumerate() {
                let at = place(mesh, element, places.natural(p));
                let lever = dot(minus(at, station.place), station.normal);
                shares.push(Share { point: first + p as u32, height: share * height, lever });
            }
        }
        let (t, n) = (station.along, station.normal);
        // xx yy zz xy yz zx: tᵀσt, and tᵀσn.
        let both = |a: [f64; 3], b: [f64; 3]| {
            let mixed = |i: usize, k: usize| a[i] * b[k] + a[k] * b[i];
            [a[0] * b[0], a[1] * b[1], a[2] * b[2], mixed(0, 1), mixed(1, 2), mixed(2, 0)]
        };
        Some(Integration { shares, direct: both(t, t), across: both(t, n) })
    }

    /// N \[N/m\], M \[N m/m\] and Q \[N/m\] for stresses \[Pa\] by point.
    pub fn forces(&self, stress: &[[f64; 6]]) -> [f64; 3] {
        let mut sums = [0.0; 3];
        for share in &self.shares {
            let stress = &stress[share.point as usize];
            let along = |by: &[f64; 6]| stress.iter().zip(by).map(|(s, b)| s * b).sum::<f64>();
            let direct = along(&self.direct) * share.height;
            sums[0] += direct;
            sums[1] += direct * share.lever;
            sums[2] += along(&self.across) * share.height;
        }
        sums
    }
}
