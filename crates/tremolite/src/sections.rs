//! Forces of a lining's sections: thrust, moment and shear, from the stresses of the elements through its thickness.

mod ends;
mod integration;
mod levers;
mod ordered;
mod steel;
#[cfg(test)]
mod tests;

use crate::stacks::{Stack, stacks};
use ends::intrados_first;
pub use integration::Integration;
pub use levers::Levers;
use ordered::{Ordered, cross, dot, minus, scaled};
use std::ops::Range;
pub use steel::Steel;
use tremolite_engine::Body;
use tremolite_kernels::Quadrature;
use tremolite_laws::shapes::hex8::{Points, shape_values};
use tremolite_mesh::Mesh;

/// Whether what stands from the start and does not crack is a lining: by its layered elements, or by the name that the generator gives
/// (`hall.lining`).
pub fn is_lining(body: &Body, group: &str) -> bool {
    let named = group.split('.').nth(1).is_some_and(|part| matches!(part, "lining" | "shotcrete"));
    named || matches!(body.quadrature, Quadrature::Layered(_))
}

/// A station of a lining: a stack through its thickness with its axes, which are at right angles.
#[derive(Clone, Debug)]
pub struct Station {
    /// The elements from extrados to intrados.
    pub stack: Stack,
    /// Middle of the mid-surface \[m\].
    pub place: [f64; 3],
    /// Across the mid-surface, towards the intrados.
    pub normal: [f64; 3],
    /// The direction of the thrust: in the shell, around the cavern, from x over z where the intrados is inside.
    pub along: [f64; 3],
    /// From extrados to intrados along the normal \[m\].
    pub thickness: f64,
    /// Corners \[m\] of its faces, extrados and intrados, each going round, those of the two opposite each other.
    pub faces: [[[f64; 3]; 4]; 2],
}

impl Station {
    /// Of the mid-surface \[m²\], taken as flat.
    fn area(&self) -> f64 {
        let [extrados, intrados] = &self.faces;
        let [a, b, c, d] = [0, 1, 2, 3].map(|k| [0, 1, 2].map(|i| 0.5 * (extrados[k][i] + intrados[k][i])));
        let normal = cross(minus(c, a), minus(d, b));
        0.5 * dot(normal, normal).sqrt()
    }
}

/// The stations of a lining, by y and then going round: from below, up the wall of greater x, over the crown.
///
/// `elements` are those of one lining's group, `standing` says of each element of the mesh whether it is there. A
/// station is where [`stacks`] finds a thickness, so not where walls meet. Its intrados is the end beyond which nothing
/// stands. That goes by places, since rock on an interface has nodes of its own. Where both ends or neither are free, as
/// before the excavation, it is the one that looks towards the middle of the group's extent, or up in a flat slab.
///
/// Caverns are taken to run along y. Of the two natural directions within the shell the thrust's is the one less
/// aligned with y.
///
/// # Panics
/// If `standing` has not an entry for each element of the mesh, or an element is not in it.
pub fn stations(mesh: &Mesh, elements: &[u32], standing: &[bool]) -> Vec<Station> {
    assert_eq!(standing.len(), mesh.elements.len(), "an entry an element");
    let middle = middle(mesh, elements);
    let ordered = stacks(mesh, elements).iter().filter_map(|stack| Ordered::new(mesh, stack)).collect();
    let ordered = intrados_first(mesh, ordered, standing, middle);
    let mut stations: Vec<(Station, f64)> = ordered.iter().filter_map(station).collect();
    stations.sort_by(|a, b| a.0.place[1].total_cmp(&b.0.place[1]));
    // Round about from −z by +x, z and −x back to −z.
    let angle = |s: &Station| (middle[0] - s.place[0]).atan2(s.place[2] - middle[2]);
    for slice in slices(&stations) {
        stations[slice].sort_by(|a, b| angle(&a.0).total_cmp(&angle(&b.0)));
    }
    stations.into_iter().map(|(station, _)| station).collect()
}

/// Whether a shell bends round x, as a cavern's along x does: its normals lead along y and z, and hardly along x. Where all lead one way, as a
/// plate's, or along x as well, as a dome's and a shaft's, nothing is known.
pub fn runs_along_x(stations: &[Station]) -> bool {
    let [x, y, z] = [0, 1, 2].map(|i| stations.iter().map(|s| s.area() * s.normal[i].powi(2)).sum::<f64>());
    let all = x + y + z;
    y > 3.0 * x && y > 0.02 * all && z > 0.02 * all
}

/// Middle of the extent of elements.
fn middle(mesh: &Mesh, elements: &[u32]) -> [f64; 3] {
    let nodes = || elements.iter().flat_map(|&e| mesh.elements[e as usize].nodes());
    [0, 1, 2].map(|i| {
        let along = || nodes().map(|&n| mesh.nodes[n as usize][i]);
        0.5 * (along().fold(f64::INFINITY, f64::min) + along().fold(f64::NEG_INFINITY, f64::max))
    })
}

/// The station of a stack, and its length \[m\] along y; none if the mid-surface has no area.
fn station(stack: &Ordered) -> Option<(Station, f64)> {
    let [extrados, intrados] = stack.ends();
    let mid: [[f64; 3]; 4] =
        std::array::from_fn(|k| [0, 1, 2].map(|i| 0.5 * (extrados[k][i] + intrados[k][i])));
    let between = |a: usize, b: usize, c: usize, d: usize| {
        [0, 1, 2].map(|i| 0.5 * (mid[c][i] + mid[d][i] - mid[a][i] - mid[b][i]))
    };
    let ways = [between(0, 3, 1, 2), between(0, 1, 3, 2)];
    let through = minus(ordered::centre(intrados), ordered::centre(extrados));
    let mut normal = unit(cross(ways[0], ways[1]))?;
    if dot(normal, through) < 0.0 {
        normal = scaled(normal, -1.0);
    }
    let aligned = |way: [f64; 3]| way[1].abs() / dot(way, way).sqrt();
    let across = if aligned(ways[0]) <= aligned(ways[1]) { ways[0] } else { ways[1] };
    let along = unit(across)?;
    let round = cross([0.0, 1.0, 0.0], normal);
    // Where the shell lies across y no way leads round: then one sense as good as another, but always the same.
    let sense = [dot(along, round), along[0], along[2], along[1]].into_iter().find(|s| s.abs() > 1e-9)?;
    let station = Station {
        stack: stack.elements.clone(),
        place: ordered::centre(&mid),
        normal,
        along: scaled(along, sense.signum()),
        thickness: dot(through, normal),
        faces: [*extrados, *intrados],
    };
    Some((station, ways[0][1].abs().max(ways[1][1].abs())))
}

fn unit(v: [f64; 3]) -> Option<[f64; 3]> {
    let length = dot(v, v).sqrt();
    (length > 0.0 && length.is_finite()).then(|| scaled(v, 1.0 / length))
}

/// Stations beside one another along y: within half a station's length of the first.
fn slices(stations: &[(Station, f64)]) -> Vec<Range<usize>> {
    let mut slices = Vec::new();
    let mut start = 0;
    for k in 1..=stations.len() {
        let (first, length) = &stations[start];
        if stations.get(k).is_none_or(|next| next.0.place[1] - first.place[1] > 0.5 * length) {
            slices.push(start..k);
            start = k;
        }
    }
    slices
}

/// Thrust N \[N/m\], moment M \[N m/m\] and shear Q \[N/m\] of a station.
///
/// N = ∫ σ_tt dn, tension positive. M = ∫ σ_tt n dn with n from the mid-surface towards the intrados, so positive with
/// tension there. Q = ∫ σ_tn dn, positive where what lies ahead along t pushes what lies behind towards the intrados.
/// Here t is [`Station::along`].
///
/// `points` gives the stresses \[Pa\] of an element, xx yy zz xy yz zx, at its points, or none where the element takes no part.
/// Eight are exact for stresses that are linear through the element, layers for cubics. One point gives an element's mean, so that
/// a single layer of one-point elements has no moment, and n layers 1 − 1/n² of it.
///
/// Per metre of the mid-surface across t. A cut across t runs straight along n, so a shell that curves along t needs no
/// factor; the factor 1 + n/R of one that curves along the cavern is left out. The axes are those of the middle of the
/// mid-surface, which errs with the square of the angle that an element spans.
///
/// # Panics
/// If an element of the station is not in the mesh.
pub fn forces<'a>(
    mesh: &Mesh,
    station: &Station,
    points: impl Fn(u32) -> Option<(Points, &'a [[f64; 6]])>,
) -> [f64; 3] {
    let levers = Levers::of(mesh, station, |element| points(element).map(|(places, _)| places));
    levers.forces(station, |element| points(element).map(|(_, stresses)| stresses))
}

/// Where natural coordinates of a hexahedron are \[m\].
fn place(mesh: &Mesh, element: u32, natural: [f64; 3]) -> [f64; 3] {
    let nodes = mesh.elements[element as usize].nodes;
    let weights = shape_values(natural);
    [0, 1, 2].map(|i| nodes.iter().zip(weights).map(|(&n, w)| w * mesh.nodes[n as usize][i]).sum())
}
