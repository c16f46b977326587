//! Boxes of hexahedra, graded along each axis, optionally distorted.

use std::fmt;

use crate::mesh::{Element, Face, Mesh, Shape};
use crate::quality;

/// Most elements of a generated mesh.
pub const MOST_ELEMENTS: u64 = 50_000_000;

/// How one axis of a box is divided. Lengths in metres.
#[derive(Clone, Debug, PartialEq)]
pub enum Axis {
    /// The node coordinates themselves, rising.
    Coordinates(Vec<f64>),
    /// `elements` elements from `from` to `to`, each `ratio` times as long as the one before.
    Graded { from: f64, to: f64, elements: u32, ratio: f64 },
}

impl Axis {
    /// Equal elements.
    pub const fn uniform(from: f64, to: f64, elements: u32) -> Self {
        Axis::Graded { from, to, elements, ratio: 1.0 }
    }

    fn elements(&self) -> u64 {
        match self {
            Axis::Coordinates(list) => list.len().saturating_sub(1) as u64,
            Axis::Graded { elements, .. } => u64::from(*elements),
        }
    }

    fn coordinates(&self, axis: char) -> Result<Vec<f64>, BoxError> {
        let list = match self {
            Axis::Coordinates(list) => list.clone(),
            &Axis::Graded { from, to, elements, ratio } => {
                if !(ratio.is_finite() && ratio > 0.0) {
                    return Err(BoxError::Ratio { axis, ratio });
                }
                // Sum of the geometric row up to element i, over the sum of all; the limit of ratio 1 apart.
                let q = ratio.ln();
                let share = |i: u32| match q.abs() < 1e-12 {
                    true => f64::from(i) / f64::from(elements),
                    false => (q * f64::from(i)).exp_m1() / (q * f64::from(elements)).exp_m1(),
                };
                (0..=elements)
                    .map(|i| if i == elements { to } else { from + (to - from) * share(i) })
                    .collect()
            }
        };
        if list.len() < 2 {
            return Err(BoxError::Empty { axis });
        }
        for (i, pair) in list.windows(2).enumerate() {
            if !(pair[0].is_finite() && pair[1].is_finite() && pair[1] > pair[0]) {
                return Err(BoxError::NotRising { axis, index: i + 1, before: pair[0], value: pair[1] });
            }
        }
        Ok(list)
    }
}

/// Pseudo-random shift of the nodes, the same on every machine for the same seed.
///
/// Each coordinate of a node moves by up to `fraction` of the shorter of its two neighbouring spacings along
/// that axis. Nodes on an outer plane stay on it. Below 1/6 no element can be inverted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distortion {
    pub fraction: f64,
    pub seed: u64,
    /// Whether the faces across x, and across y, keep matching node by node.
    pub periodic: [bool; 2],
}

/// A box of hexahedra: its division along x, y and z, and a distortion if wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct BoxSpec {
    pub x: Axis,
    pub y: Axis,
    pub z: Axis,
    pub distortion: Option<Distortion>,
}

/// Why a box could not be made.
#[derive(Clone, Debug, PartialEq)]
pub enum BoxError {
    /// An axis without any element.
    Empty { axis: char },
    /// A coordinate that does not lie beyond the one before (or is not finite); `index` counts from 0.
    NotRising { axis: char, index: usize, before: f64, value: f64 },
    /// A growth ratio that is not a positive number.
    Ratio { axis: char, ratio: f64 },
    /// More elements than [`MOST_ELEMENTS`].
    TooMany { elements: u64 },
    /// A distortion that is negative or not a number, or that inverts elements.
    Distortion { fraction: f64 },
}

impl fmt::Display for BoxError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty { axis } => {
                write!(f, "{axis}: no element along this axis; give two coordinates at least")
            }
            Self::NotRising { axis, index, before, value } => write!(
                f,
                "{axis}: coordinate {index} is {value} m after {before} m; coordinates must rise and be finite"
            ),
            Self::Ratio { axis, ratio } => {
                write!(f, "{axis}: a growth ratio of {ratio}; give a positive number, 1 for equal elements")
            }
            Self::TooMany { elements } => {
                write!(f, "{elements} elements, the limit is {MOST_ELEMENTS}; take fewer along some axis")
            }
            Self::Distortion { fraction } => {
                write!(f, "a distortion of {fraction} inverts elements; take less than 0.16 to be safe")
            }
        }
    }
}

impl std::error::Error for BoxError {}

impl BoxSpec {
    /// A box of equal elements from `from` to `to`.
    pub const fn uniform(from: [f64; 3], to: [f64; 3], elements: [u32; 3]) -> Self {
        BoxSpec {
            x: Axis::uniform(from[0], to[0], elements[0]),
            y: Axis::uniform(from[1], to[1], elements[1]),
            z: Axis::uniform(from[2], to[2], elements[2]),
            distortion: None,
        }
    }

    /// The mesh: nodes and elements x fastest, z slowest; face sets `xmin`, `xmax`, `ymin`, `ymax`, `base`
    /// (lowest z) and `top`; no groups of elements.
    ///
    /// # Errors
    /// See [`BoxError`].
    pub fn mesh(&self) -> Result<Mesh, BoxError> {
        // Counted before any list is made: a slip in a count must not exhaust the memory.
        let counts = [self.x.elements(), self.y.elements(), self.z.elements()];
        let elements = counts.iter().fold(1u64, |product, &n| product.saturating_mul(n.max(1)));
        if elements > MOST_ELEMENTS {
            return Err(BoxError::TooMany { elements });
        }
        let lines = [self.x.coordinates('x')?, self.y.coordinates('y')?, self.z.coordinates('z')?];
        let [nx, ny, nz] = [lines[0].len() - 1, lines[1].len() - 1, lines[2].len() - 1];

        let mut mesh = Mesh::default();
        mesh.nodes.reserve(lines.iter().map(Vec::len).product());
        for &z in &lines[2] {
            for &y in &lines[1] {
                mesh.nodes.extend(lines[0].iter().map(|&x| [x, y, z]));
            }
        }
        if let Some(distortion) = self.distortion {
            distort(&mut mesh.nodes, &lines, distortion)?;
        }

        let (row, layer) = ((nx + 1) as u32, ((nx + 1) * (ny + 1)) as u32);
        let mut sets: [Vec<Face>; 6] = Default::default();
        for k in 0..nz {
            for j in 0..ny {
                for i in 0..nx {
                    let element = mesh.elements.len() as u32;
                    let n = i as u32 + j as u32 * row + k as u32 * layer;
                    let m = n + layer;
                    let nodes = [n, n + 1, n + 1 + row, n + row, m, m + 1, m + 1 + row, m + row];
                    mesh.elements.push(Element { shape: Shape::Hex8, nodes });
                    let outer = [i == 0, i + 1 == nx, j == 0, j + 1 == ny, k == 0, k + 1 == nz];
                    for (side, set) in sets.iter_mut().enumerate() {
                        if outer[side] {
                            set.push(Face { element, side: side as u8 });
                        }
                    }
                }
            }
        }
        for (name, set) in ["xmin", "xmax", "ymin", "ymax", "base", "top"].into_iter().zip(sets) {
            mesh.faces.insert(name.to_owned(), set);
        }
        if let Some(Distortion { fraction, .. }) = self.distortion
            && quality::summary(&mesh).min_scaled_jacobian <= 0.0
        {
            return Err(BoxError::Distortion { fraction });
        }
        Ok(mesh)
    }
}

fn distort(nodes: &mut [[f64; 3]], lines: &[Vec<f64>; 3], with: Distortion) -> Result<(), BoxError> {
    if !(with.fraction.is_finite() && with.fraction >= 0.0) {
        return Err(BoxError::Distortion { fraction: with.fraction });
    }
    let last = [lines[0].len() - 1, lines[1].len() - 1, lines[2].len() - 1];
    for (n, node) in nodes.iter_mut().enumerate() {
        let at = [n % (last[0] + 1), n / (last[0] + 1) % (last[1] + 1), n / ((last[0] + 1) * (last[1] + 1))];
        let mut key = at;
        for axis in 0..2 {
            if with.periodic[axis] && at[axis] == last[axis] {
                key[axis] = 0;
            }
        }
        for axis in 0..3 {
            let (i, line) = (at[axis], &lines[axis]);
            if i == 0 || i == last[axis] {
                continue;
            }
            let spacing = (line[i] - line[i - 1]).min(line[i + 1] - line[i]);
            let number = key.iter().fold(with.seed ^ axis as u64, |h, &k| splitmix(h ^ k as u64));
            // The top 53 bits, as a number in [−1, 1).
            let random = (number >> 11) as f64 / (1u64 << 52) as f64 - 1.0;
            node[axis] += with.fraction * spacing * random;
        }
    }
    Ok(())
}

/// The mixing step of the SplitMix64 generator (Steele, Lea and Flood 2014).
fn splitmix(seed: u64) -> u64 {
    let mut z = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests;
