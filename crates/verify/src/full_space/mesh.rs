//! The mesh of a cavity in its box: rings, the square, the grid.

use super::Slice;
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;
use tremolite_mesh::{Element, Mesh, Shape};

/// Size of the outermost ring beside the innermost, which is about as long as wide.
const RINGS: f64 = 2.5;
/// Size of an element of the grid beside the one before it, outside of the wave's way.
const GROWTH: f64 = 1.1;
/// The square's sides as they come from x to z: outwards; each goes along the next one's outwards.
const OUT: [[i32; 2]; 4] = [[1, 0], [0, 1], [-1, 0], [0, -1]];

/// The mesh, with the elements of the liner, those of the rock, and those of the rock's first ring.
pub(super) struct Parts {
    pub mesh: Mesh,
    pub liner: Vec<u32>,
    pub rock: Vec<u32>,
    pub wall: Vec<u32>,
}

impl Slice {
    /// Width \[m\] of the square's elements.
    fn size(&self) -> f64 {
        4.0 * self.cavity.radius / f64::from(self.elements)
    }

    /// Distances \[m\] of the grid's lines from the axis, from 0 to the box, with elements up to a size \[m\].
    fn lines(&self, coarsest: f64) -> Vec<f64> {
        let mut size = self.size();
        let end = self.reach * self.cavity.radius;
        let mut lines: Vec<f64> = (0..=self.elements / 2).map(|i| f64::from(i) * size).collect();
        let mut last = 2.0 * self.cavity.radius;
        // The last one is cut to between half and one and a half of its size.
        while end - last > 0.5 * size {
            size = (size * GROWTH).min(coarsest.max(self.size()));
            last = if end - last < 1.5 * size { end } else { last + size };
            lines.push(last);
        }
        lines
    }

    /// The mesh; see the text of the module above.
    pub(super) fn parts(&self) -> Parts {
        let h = self.size();
        let (n, half) = (self.elements, self.elements as i32 / 2);
        let sideways = self.lines(self.coarsest * self.cavity.radius);
        let downwards = self.lines(h);
        let at = |lines: &[f64], i: i32| lines[i.unsigned_abs() as usize] * f64::from(i.signum());
        let (wide, deep) = (sideways.len() as i32 - 1, downwards.len() as i32 - 1);
        let in_square = |i: i32, k: i32| i.abs() < half && k.abs() < half;
        // Nodes in the plane, each to become one before and one behind.
        let mut plane: Vec<[f64; 2]> = Vec::new();
        let mut lattice: BTreeMap<[i32; 2], u32> = BTreeMap::new();
        for k in -deep..=wide {
            for i in (-wide..=wide).filter(|i| !in_square(*i, k)) {
                lattice.insert([i, k], plane.len() as u32);
                plane.push([at(&sideways, i), at(if k < 0 { &downwards } else { &sideways }, k)]);
            }
        }
        // Radii of the liner, then shares of the way from the wall to the square.
        let radius = self.cavity.radius;
        let inner = self.cavity.liner.map_or(radius, |(_, inner)| inner);
        let layers = self.cavity.liner.map_or(0, |_| self.layers);
        let rows = (f64::from(n) / 2.6).round() as u32;
        let share = |row: u32| (RINGS.powf(f64::from(row) / f64::from(rows)) - 1.0) / (RINGS - 1.0);
        let mut rings: Vec<Vec<u32>> = Vec::new();
        for row in 0..=layers + rows {
            let (r, s) = match row.checked_sub(layers) {
                Some(row) => (radius, share(row)),
                None => (inner + (radius - inner) * f64::from(row) / f64::from(layers), 0.0),
            };
            let node = |line: u32| {
                let (side, along) = ((line / n) as usize, (line % n) as i32 - half);
                let place = [0, 1].map(|c| half * OUT[side][c] + along * OUT[(side + 1) % 4][c]);
                if row == layers + rows {
                    return lattice[&place];
                }
                // From x to z, an eighth of a turn before the middle of the side x > 0.
                let angle = FRAC_PI_2 * (f64::from(line) / f64::from(n) - 0.5);
                let (sine, cosine) = angle.sin_cos();
                let mixed = |round: f64, square: i32| r * round * (1.0 - s) + s * h * f64::from(square);
                plane.push([mixed(cosine, place[0]), mixed(sine, place[1])]);
                plane.len() as u32 - 1
            };
            rings.push((0..4 * n).map(node).collect());
        }
        let nodes = plane.iter().flat_map(|[x, z]| [[*x, 0.0, *z], [*x, h, *z]]).collect();
        let mut mesh = Mesh { nodes, ..Mesh::default() };
        let mut add = |[a, b, c, d]: [u32; 4]| {
            // The first natural axis goes from a to b, the second along y, the third from a to c.
            let nodes = [2 * a, 2 * b, 2 * b + 1, 2 * a + 1, 2 * c, 2 * d, 2 * d + 1, 2 * c + 1];
            mesh.elements.push(Element::new(Shape::Hex8, &nodes));
            mesh.elements.len() as u32 - 1
        };
        let (mut liner, mut rock, mut wall) = (Vec::new(), Vec::new(), Vec::new());
        for (row, pair) in (0..).zip(rings.windows(2)) {
            for line in 0..4 * n as usize {
                let next = (line + 1) % (4 * n as usize);
                let element = add([pair[0][line], pair[1][line], pair[0][next], pair[1][next]]);
                if row < layers { &mut liner } else { &mut rock }.push(element);
                if row == layers {
                    wall.push(element);
                }
            }
        }
        let square = -half..half;
        for k in -deep..wide {
            for i in (-wide..wide).filter(|i| !(square.contains(i) && square.contains(&k))) {
                rock.push(add([[i, k], [i + 1, k], [i, k + 1], [i + 1, k + 1]].map(|place| lattice[&place])));
            }
        }
        Parts { mesh, liner, rock, wall }
    }
}
