//! Meshes of boxes, and how they are bent.

use tremolite_seepage::{Flow, Ground, Holds, Place, SeepageError, steady};

/// A mesh with its nodes moved, all of one conductivity unless changed.
pub struct Made {
    pub nodes: Vec<[f64; 3]>,
    pub elements: Vec<[u32; 8]>,
    pub conductivity: Vec<f64>,
}

/// Conductivity \[m/s\] unless another is given.
pub const K: f64 = 2e-6;

/// A grid by the coordinates of its planes.
pub fn grid(x: &[f64], y: &[f64], z: &[f64]) -> Made {
    let at = |i: usize, j: usize, k: usize| ((k * y.len() + j) * x.len() + i) as u32;
    let mut nodes = Vec::new();
    for &z in z {
        for &y in y {
            nodes.extend(x.iter().map(|&x| [x, y, z]));
        }
    }
    let mut elements = Vec::new();
    for k in 0..z.len() - 1 {
        for j in 0..y.len() - 1 {
            for i in 0..x.len() - 1 {
                let ring = |k| [at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k)];
                let (below, above) = (ring(k), ring(k + 1));
                elements.push(std::array::from_fn(|n| if n < 4 { below[n] } else { above[n - 4] }));
            }
        }
    }
    let conductivity = vec![K; elements.len()];
    Made { nodes, elements, conductivity }
}

pub fn even(low: f64, high: f64, parts: usize) -> Vec<f64> {
    (0..=parts).map(|i| low + (high - low) * i as f64 / parts as f64).collect()
}

impl Made {
    pub fn solve(&self, places: &[Place]) -> Result<Flow, SeepageError> {
        let ground =
            Ground { nodes: &self.nodes, elements: &self.elements, conductivity: &self.conductivity };
        steady(&ground, places)
    }

    /// The outer faces of which all nodes are where `at` says.
    pub fn faces(&self, at: impl Fn([f64; 3]) -> bool) -> Vec<Vec<u32>> {
        const SIDES: [[usize; 4]; 6] =
            [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]];
        let mut found = Vec::new();
        for e in &self.elements {
            for side in SIDES {
                let mut face: Vec<u32> = side.iter().map(|&k| e[k]).collect();
                face.dedup();
                if face.first() == face.last() {
                    face.pop();
                }
                if face.len() > 2 && face.iter().all(|&n| at(self.nodes[n as usize])) {
                    found.push(face);
                }
            }
        }
        found
    }

    pub fn place(&self, name: &str, holds: Holds, at: impl Fn([f64; 3]) -> bool) -> Place {
        Place::of_faces(name, holds, self.faces(at), &self.nodes)
    }
}

/// A number in −1 to 1 by a node and a component.
pub fn noise(n: usize, i: usize) -> f64 {
    let mut s = (3 * n + i) as u64 + 1;
    for _ in 0..3 {
        s = (s ^ (s >> 31)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    }
    (s >> 11) as f64 / (1u64 << 52) as f64 - 1.0
}

/// The middle of an element.
pub fn middle(made: &Made, e: usize) -> [f64; 3] {
    let corners = made.elements[e].map(|n| made.nodes[n as usize]);
    [0, 1, 2].map(|i| corners.iter().map(|x| x[i]).sum::<f64>() / 8.0)
}

/// Largest difference of heads \[m\] from a function of place, over nodes of elements.
pub fn farthest(made: &Made, flow: &Flow, exact: impl Fn([f64; 3]) -> f64) -> f64 {
    let nodes = made.elements.iter().flatten().map(|&n| n as usize);
    nodes.map(|n| (flow.heads[n] - exact(made.nodes[n])).abs()).fold(0.0, f64::max)
}
