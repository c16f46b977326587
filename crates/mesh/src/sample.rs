//! Small meshes for the tests.

use crate::boxes::BoxSpec;
use crate::{Element, Mesh, Shape};

/// Numbers in [0, 1), by Park and Miller's generator.
pub(crate) struct Random(pub u64);

impl Random {
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0 * 48_271 % 2_147_483_647;
        self.0 as f64 / 2_147_483_647.0
    }

    pub(crate) fn below(&mut self, n: usize) -> usize {
        (self.next() * n as f64) as usize
    }

    /// A file with a few bytes changed, lost or added.
    pub(crate) fn damaged(&mut self, original: &[u8]) -> Vec<u8> {
        const WORDS: [&str; 11] =
            ["-1", "0", "1e999", "18446744073709551615", "nan", "\n", " ", ",", "*", "\u{fffd}", "999999999"];
        let mut bytes = original.to_vec();
        for _ in 0..=self.below(3) {
            let at = self.below(bytes.len());
            match self.below(4) {
                0 => bytes[at] = self.below(256) as u8,
                1 => drop(bytes.drain(at..(at + self.below(40)).min(bytes.len()))),
                2 => drop(bytes.splice(at..at, WORDS[self.below(WORDS.len())].bytes())),
                _ => bytes[at] = b'0' + self.below(10) as u8,
            }
        }
        bytes
    }
}

/// The box [0, n]³ of n³ hexahedra, x fastest, inner nodes displaced at random by up to 0.2 an axis.
pub(crate) fn distorted_box(n: u32) -> Mesh {
    let mut random = Random(42);
    let mut mesh = Mesh::default();
    let node = |i, j, k| i + (n + 1) * (j + (n + 1) * k);
    for k in 0..=n {
        for j in 0..=n {
            for i in 0..=n {
                let inner = [i, j, k].iter().all(|&c| c > 0 && c < n);
                mesh.nodes.push([i, j, k].map(|c| {
                    let off = 0.4 * random.next() - 0.2;
                    f64::from(c) + if inner { off } else { 0.0 }
                }));
            }
        }
    }
    for k in 0..n {
        for j in 0..n {
            for i in 0..n {
                let ring = |k| [node(i, j, k), node(i + 1, j, k), node(i + 1, j + 1, k), node(i, j + 1, k)];
                mesh.elements.push(Element::new(Shape::Hex8, &[ring(k), ring(k + 1)].concat()));
            }
        }
    }
    mesh
}

/// A skewed hexahedron with a wedge on its +x face, a pyramid on its top and, apart, a tetrahedron.
pub(crate) fn one_of_each() -> Mesh {
    let nodes = vec![
        [0.0, 0.0, 0.0],
        [1.0, 0.1, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.2, 0.0],
        [0.1, 0.0, 1.0],
        [1.0, 0.0, 1.0],
        [1.0, 0.9, 1.1],
        [0.0, 1.0, 1.0],
        [2.0, 0.5, 0.1],
        [2.1, 0.4, 1.2],
        [0.5, 0.4, 2.0],
        [3.0, 0.0, 0.0],
        [4.0, 0.2, 0.0],
        [3.0, 1.0, 0.3],
        [3.2, 0.1, 1.0],
    ];
    let elements = vec![
        Element::new(Shape::Hex8, &[0, 1, 2, 3, 4, 5, 6, 7]),
        Element::new(Shape::Wedge6, &[1, 8, 2, 5, 9, 6]),
        Element::new(Shape::Pyramid5, &[4, 5, 6, 7, 10]),
        Element::new(Shape::Tet4, &[11, 12, 13, 14]),
    ];
    Mesh { nodes, elements, ..Mesh::default() }
}

/// A box of unit cubes from the origin, x fastest.
pub(crate) fn grid(cells: [u32; 3]) -> Mesh {
    let mesh = BoxSpec::uniform([0.0; 3], cells.map(f64::from), cells).mesh().expect("a legal box");
    Mesh { nodes: mesh.nodes, elements: mesh.elements, ..Mesh::default() }
}

/// Rings of hexahedra around the y axis, `facets` each, between the given radii, in layers of 1 m.
pub(crate) fn tube(facets: u32, radii: &[f64], layers: u32) -> Mesh {
    let mut mesh = Mesh::default();
    let rings = radii.len() as u32;
    for l in 0..=layers {
        for radius in radii {
            for i in 0..facets {
                let (sin, cos) = (std::f64::consts::TAU * f64::from(i) / f64::from(facets)).sin_cos();
                mesh.nodes.push([radius * cos, f64::from(l), radius * sin]);
            }
        }
    }
    let node = |i, j, l| i % facets + facets * (j + rings * l);
    for l in 0..layers {
        for j in 0..rings - 1 {
            for i in 0..facets {
                let ring = |l| [node(i, j, l), node(i, j + 1, l), node(i + 1, j + 1, l), node(i + 1, j, l)];
                mesh.elements.push(Element::new(Shape::Hex8, &[ring(l + 1), ring(l)].concat()));
            }
        }
    }
    mesh
}

/// Elements with their centre where `inside` says.
pub(crate) fn elements_where(mesh: &Mesh, inside: impl Fn([f64; 3]) -> bool) -> Vec<u32> {
    let centre = |e: &Element| {
        let nodes = e.nodes();
        let sum = |i: usize| nodes.iter().map(|&n| mesh.nodes[n as usize][i]).sum::<f64>();
        [0, 1, 2].map(|i| sum(i) / nodes.len() as f64)
    };
    (0..).zip(&mesh.elements).filter(|(_, e)| inside(centre(e))).map(|(k, _)| k).collect()
}
