//! Which element contains a point, and with what weights its nodes give the point's values.

mod inverse;
mod line;
mod nearest;

pub use line::Stretch;

use crate::isoparametric::{point, weights};
use crate::{Element, Mesh};
use inverse::{clamp, natural_coordinates};
use nearest::nearest_on_surface;

/// How far outside the natural range a point still counts as inside: on a shared face, both are.
const ON_FACE: f64 = 1e-9;

/// Lengths that differ by less than this share of an element's size are the same.
const SAME: f64 = 1e-6;

/// Where a point lies in a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Location {
    /// Index into [`Mesh::elements`].
    pub element: u32,
    /// Natural coordinates: hexahedron [-1, 1]³; wedge r, s ≥ 0, r + s ≤ 1, t in [-1, 1];
    /// tetrahedron r, s, t ≥ 0, r + s + t ≤ 1; pyramid r, s in [-1, 1], t in [0, 1] (the apex).
    pub natural: [f64; 3],
    /// Shape functions of the element's nodes there, 0 for nodes its shape lacks; their sum is 1.
    pub weights: [f64; 8],
    /// Distance \[m\] from the point to the place described; 0 if the element contains the point.
    pub distance: f64,
}

/// A uniform grid of bins over the boxes of elements, to find the element at a point.
///
/// Made once in a time proportional to the number of elements. Bins are cubes of the mean element's
/// size, so a mesh with few fine and many coarse elements is searched more slowly.
#[derive(Clone, Debug)]
pub struct Locator<'a> {
    mesh: &'a Mesh,
    /// Elements that may be found, ascending.
    elements: Vec<u32>,
    /// Lower and upper corners of each element's box, in the order of `elements`.
    boxes: Vec<[[f64; 3]; 2]>,
    low: [f64; 3],
    width: f64,
    bins: [usize; 3],
    /// Where each bin's entries begin in `entries`; one more than there are bins.
    starts: Vec<u32>,
    /// Places in `elements`.
    entries: Vec<u32>,
}

impl<'a> Locator<'a> {
    /// A locator for the given elements (indices into [`Mesh::elements`], for example the lining's
    /// alone), or for all.
    ///
    /// # Panics
    /// If an element is not in the mesh.
    pub fn new(mesh: &'a Mesh, elements: Option<&[u32]>) -> Self {
        let mut elements =
            elements.map_or_else(|| (0..mesh.elements.len() as u32).collect(), <[u32]>::to_vec);
        elements.sort_unstable();
        elements.dedup();
        let boxes: Vec<[[f64; 3]; 2]> = elements.iter().map(|&e| bounds(mesh, e)).collect();

        let mut low = [f64::INFINITY; 3];
        let mut high = [f64::NEG_INFINITY; 3];
        let mut sides = 0.0;
        for [lower, upper] in &boxes {
            for i in 0..3 {
                low[i] = low[i].min(lower[i]);
                high[i] = high[i].max(upper[i]);
                sides += upper[i] - lower[i];
            }
        }
        let extent = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
        // A side of the mean box, but at most 256 bins along the longest side of the mesh.
        let mean = sides / (3.0 * boxes.len().max(1) as f64);
        let width = mean.max(extent / 256.0).max(f64::MIN_POSITIVE);
        let bins = [0, 1, 2].map(|i| ((high[i] - low[i]) / width).max(0.0) as usize + 1);

        let mut locator =
            Locator { mesh, elements, boxes, low, width, bins, starts: vec![], entries: vec![] };
        locator.fill();
        locator
    }

    /// Lists in each bin the elements whose boxes reach into it.
    fn fill(&mut self) {
        let mut counts = vec![0u32; self.bins.iter().product::<usize>() + 1];
        for [low, high] in &self.boxes {
            for bin in self.bins_between(low, high) {
                counts[bin + 1] += 1;
            }
        }
        for bin in 1..counts.len() {
            counts[bin] += counts[bin - 1];
        }
        let mut next = counts.clone();
        let mut entries = vec![0; counts[counts.len() - 1] as usize];
        for (place, [low, high]) in self.boxes.iter().enumerate() {
            for bin in self.bins_between(low, high) {
                entries[next[bin] as usize] = place as u32;
                next[bin] += 1;
            }
        }
        self.starts = counts;
        self.entries = entries;
    }

    /// The bins that a box reaches into.
    fn bins_between(&self, low: &[f64; 3], high: &[f64; 3]) -> impl Iterator<Item = usize> + use<> {
        let bins = self.bins;
        // `as` takes what lies below the grid, and NaN, to its first bin.
        let bin = |x: f64, i: usize| (((x - self.low[i]) / self.width) as usize).min(bins[i] - 1);
        let from = [0, 1, 2].map(|i| bin(low[i], i));
        let to = [0, 1, 2].map(|i| bin(high[i], i));
        (from[2]..=to[2]).flat_map(move |z| {
            (from[1]..=to[1])
                .flat_map(move |y| (from[0]..=to[0]).map(move |x| x + bins[0] * (y + bins[1] * z)))
        })
    }

    /// The element that contains `at` \[m\], or else the nearest one within `tolerance` \[m\].
    ///
    /// Of several that contain it (a point on a face, an edge or a corner), or are equally near, the one whose middle is
    /// nearest, so the smallest; of equal ones the one that lies first along x, then y, then z. That goes by places alone: a mesh
    /// whose elements and nodes are numbered otherwise gives the same element. Only of elements in one place the lowest index
    /// is taken. Outside, the location is the nearest point of the element's surface (of a warped face, a point close to
    /// that, with its true distance).
    pub fn locate(&self, at: [f64; 3], tolerance: f64) -> Option<Location> {
        let tolerance = tolerance.max(0.0);
        let mut near: Vec<u32> = self
            .bins_between(&at.map(|x| x - tolerance), &at.map(|x| x + tolerance))
            .flat_map(|bin| &self.entries[self.starts[bin] as usize..self.starts[bin + 1] as usize])
            .copied()
            .filter(|&place| {
                let [low, high] = &self.boxes[place as usize];
                // The slack lets a point on a face through in spite of round-off.
                let slack = (0..3).map(|i| high[i] - low[i]).fold(tolerance, f64::max) * ON_FACE + tolerance;
                (0..3).all(|i| low[i] - slack <= at[i] && at[i] <= high[i] + slack)
            })
            .collect();
        near.sort_unstable();
        near.dedup();
        let containing = near.iter().filter_map(|&place| self.inside(place, at));
        self.first_by_place(containing.collect(), at).or_else(|| {
            let mut found = self.nearest(&near, at);
            let least = found.iter().map(|location| location.distance).fold(f64::INFINITY, f64::min);
            found.retain(|location| location.distance <= least + SAME * self.size(location));
            self.first_by_place(found, at).filter(|location| location.distance <= tolerance)
        })
    }

    /// The longest side \[m\] of the box of a location's element.
    fn size(&self, location: &Location) -> f64 {
        let [low, high] = bounds(self.mesh, location.element);
        (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max)
    }

    /// The location that comes first by where its element is; of elements in one place the one of lowest index.
    fn first_by_place(&self, found: Vec<Location>, at: [f64; 3]) -> Option<Location> {
        let mut found = found.into_iter();
        let mut first = found.next()?;
        let mut middle = self.middle(&first);
        let distance = |x: [f64; 3]| (0..3).map(|i| (x[i] - at[i]).powi(2)).sum::<f64>().sqrt();
        for other in found {
            let its = self.middle(&other);
            // Round-off of the middles does not tell elements apart.
            let same = SAME * self.size(&first).min(self.size(&other));
            let [x, y, z] = [0, 1, 2].map(|i| its[i] - middle[i]);
            let apart = [distance(its) - distance(middle), x, y, z].into_iter().find(|d| d.abs() > same);
            if apart.is_some_and(|d| d < 0.0) {
                (first, middle) = (other, its);
            }
        }
        Some(first)
    }

    /// The mean of the nodes of a location's element.
    fn middle(&self, location: &Location) -> [f64; 3] {
        let nodes = self.mesh.elements[location.element as usize].nodes();
        let sum = |i: usize| nodes.iter().map(|&n| self.mesh.nodes[n as usize][i]).sum::<f64>();
        [0, 1, 2].map(|i| sum(i) / nodes.len() as f64)
    }

    /// The point's location in an element that contains it.
    fn inside(&self, place: u32, at: [f64; 3]) -> Option<Location> {
        let index = self.elements[place as usize];
        let element = &self.mesh.elements[index as usize];
        let natural = natural_coordinates(element.shape, &self.corners(element), at)?;
        let clamped = clamp(element.shape, natural);
        let within = (0..3).all(|i| (natural[i] - clamped[i]).abs() <= ON_FACE);
        within.then(|| Location {
            element: index,
            natural: clamped,
            weights: weights(element.shape, clamped),
            distance: 0.0,
        })
    }

    /// The nearest places on the surfaces of some elements, each.
    fn nearest(&self, places: &[u32], at: [f64; 3]) -> Vec<Location> {
        let of_element = |&place: &u32| {
            let index = self.elements[place as usize];
            let element = &self.mesh.elements[index as usize];
            let nodes = self.corners(element);
            let foot = nearest_on_surface(element.shape, &nodes, at);
            let natural = clamp(element.shape, natural_coordinates(element.shape, &nodes, foot)?);
            let weights = weights(element.shape, natural);
            let x = point(&nodes[..element.shape.nodes()], &weights);
            let distance = (0..3).map(|i| (x[i] - at[i]).powi(2)).sum::<f64>().sqrt();
            Some(Location { element: index, natural, weights, distance })
        };
        places.iter().filter_map(of_element).collect()
    }

    /// Coordinates of an element's nodes; the unused tail repeats the last.
    fn corners(&self, element: &Element) -> [[f64; 3]; 8] {
        element.nodes.map(|n| self.mesh.nodes[n as usize])
    }
}

/// The box around an element.
fn bounds(mesh: &Mesh, element: u32) -> [[f64; 3]; 2] {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for &node in mesh.elements[element as usize].nodes() {
        let x = mesh.nodes[node as usize];
        for i in 0..3 {
            low[i] = low[i].min(x[i]);
            high[i] = high[i].max(x[i]);
        }
    }
    [low, high]
}

#[cfg(test)]
mod tests;
