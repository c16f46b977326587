//! What of a station's forces does not go by the stresses, worked out once for many times: with the bits of
//! [`forces`](super::forces), which is made of it.

use super::ordered::{centre, dot, face, minus};
use super::{Station, place};
use tremolite_laws::shapes::hex8::{Points, Quadrature};
use tremolite_mesh::Mesh;

/// Of the elements of a station that take part.
#[derive(Clone, Debug)]
pub struct Levers {
    elements: Vec<Element>,
}

#[derive(Clone, Debug)]
struct Element {
    element: u32,
    quadrature: Quadrature,
    /// Along the normal \[m\].
    height: f64,
    /// Of its points over the mid-surface \[m\].
    levers: Vec<f64>,
}

impl Levers {
    /// Of a station; `places` says where an element's points lie, nothing where it takes no part.
    ///
    /// # Panics
    /// If an element of the station is not in the mesh.
    pub fn of(mesh: &Mesh, station: &Station, places: impl Fn(u32) -> Option<Points>) -> Self {
        let element = |&(element, axis): &(u32, usize)| {
            let places = places(element)?;
            let [near, far] = [0, 1].map(|end| centre(&face(mesh, element, axis, end)));
            let lever = |p: usize| {
                let at = place(mesh, element, places.natural(p));
                dot(minus(at, station.place), station.normal)
            };
            Some(Element {
                element,
                quadrature: places.quadrature,
                height: dot(minus(far, near), station.normal).abs(),
                levers: (0..places.count()).map(lever).collect(),
            })
        };
        Levers { elements: station.stack.iter().filter_map(element).collect() }
    }

    /// N \[N/m\], M \[N m/m\] and Q \[N/m\] of the station, from the stresses \[Pa\] at an element's points.
    pub fn forces<'a>(&self, station: &Station, points: impl Fn(u32) -> Option<&'a [[f64; 6]]>) -> [f64; 3] {
        let mut sums = [0.0; 3];
        for Element { element, quadrature, height, levers } in &self.elements {
            let Some(stresses) = points(*element) else { continue };
            for ((stress, share), lever) in stresses.iter().zip(quadrature.shares()).zip(levers) {
                let traction = traction(stress, station.along);
                let direct = dot(traction, station.along) * share * height;
                sums[0] += direct;
                sums[1] += direct * lever;
                sums[2] += dot(traction, station.normal) * share * height;
            }
        }
        sums
    }
}

/// Stress times a unit vector.
fn traction([xx, yy, zz, xy, yz, zx]: &[f64; 6], t: [f64; 3]) -> [f64; 3] {
    [dot([*xx, *xy, *zx], t), dot([*xy, *yy, *yz], t), dot([*zx, *yz, *zz], t)]
}
