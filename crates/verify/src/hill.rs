//! A hill with a slope that falls along x, and a block that lies on it.

use crate::joints::together;
use tremolite_mesh::{Element, Mesh, Shape};

/// Of the slope, to the horizontal \[rad\].
pub const ANGLE: f64 = 20.0 * std::f64::consts::PI / 180.0;
/// Its length, and between its foot and the block \[m\].
const SLOPE: f64 = 18.0;
const FOOT: f64 = 3.0;
/// The block along the slope and out of it \[m\].
const BLOCK: [f64; 2] = [12.0, 3.0];
/// Edge of the coarsest elements \[m\].
const SIZE: f64 = 1.5;
/// Level ground on each side, and below \[m\].
const BESIDE: f64 = 24.0;
const DEPTH: f64 = 18.0;

/// A slice of the hill with `divide` elements along 1.5 m: the ground, then the block, with two nodes at every place where they touch;
/// and how many elements are the ground's.
pub fn hill(divide: u32) -> (Mesh, u32) {
    let h = SIZE / f64::from(divide);
    let (sine, cosine) = ANGLE.sin_cos();
    let count = |length: f64| (length / h).round() as u32;
    let (beside, slope, rows) = (count(BESIDE), count(SLOPE), count(DEPTH));
    // From the left: level, down the slope, level.
    let top = SLOPE * sine;
    let surface = |i: u32| -> [f64; 2] {
        if i < beside {
            [-h * f64::from(beside - i), top]
        } else if i <= beside + slope {
            let s = h * f64::from(i - beside);
            [s * cosine, top - s * sine]
        } else {
            [SLOPE * cosine + h * f64::from(i - beside - slope), 0.0]
        }
    };
    let grid = |columns: u32, rows: u32, at: &dyn Fn(u32, u32) -> [f64; 2]| {
        let mut mesh = Mesh::default();
        for k in 0..=rows {
            for i in 0..=columns {
                let [x, z] = at(i, k);
                mesh.nodes.extend([[x, 0.0, z], [x, h, z]]);
            }
        }
        let node = |i: u32, k: u32, y: u32| 2 * (k * (columns + 1) + i) + y;
        for k in 0..rows {
            for i in 0..columns {
                let face = |k: u32| [node(i, k, 0), node(i + 1, k, 0), node(i + 1, k, 1), node(i, k, 1)];
                mesh.elements.push(Element::new(Shape::Hex8, &[face(k), face(k + 1)].concat()));
            }
        }
        mesh
    };
    let ground = grid(2 * beside + slope, rows, &|i, k| {
        let [x, z] = surface(i);
        [x, -DEPTH + (z + DEPTH) * f64::from(k) / f64::from(rows)]
    });
    let first = beside + slope - count(FOOT) - count(BLOCK[0]);
    let block = grid(count(BLOCK[0]), count(BLOCK[1]), &|i, k| {
        let [x, z] = surface(first + i);
        let n = h * f64::from(k);
        [x + n * sine, z + n * cosine]
    });
    (together(&ground, &block), ground.elements.len() as u32)
}
