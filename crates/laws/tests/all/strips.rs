//! Strips and rings one element thick, solved directly: deflection over that of theory.

use crate::hex8::{Kind, pass};
use tremolite_laws::Moduli;
use tremolite_laws::shapes::hex8::{Hex8, Layers};

const LAYERED: Kind = Kind::Layered(Layers::Nine);
const YOUNG: f64 = 25e9;

/// A plan of cells one element thick: by its nodes along the first direction, the second and the thickness.
struct Sheet {
    /// Cells along the two directions.
    cells: [usize; 2],
    nodes: Vec<[f64; 3]>,
    elements: Vec<[usize; 8]>,
}

#[derive(Clone, Copy)]
enum Cell {
    Hexahedron,
    /// Two wedges, by diagonals that alternate.
    Wedges,
}

impl Sheet {
    /// `place` maps natural coordinates of the sheet, [0, 1]² and −½ to ½.
    fn new(cells: [usize; 2], cell: Cell, place: impl Fn([usize; 2], f64) -> [f64; 3]) -> Sheet {
        let node = |i: usize, j: usize, k: usize| 2 * (i * (cells[1] + 1) + j) + k;
        let mut sheet = Sheet { cells, nodes: Vec::new(), elements: Vec::new() };
        for (i, j) in (0..=cells[0]).flat_map(|i| (0..=cells[1]).map(move |j| (i, j))) {
            sheet.nodes.extend([-0.5, 0.5].map(|k| place([i, j], k)));
        }
        for (i, j) in (0..cells[0]).flat_map(|i| (0..cells[1]).map(move |j| (i, j))) {
            let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
            let mut add = |places: [usize; 4]| {
                let at = |k: usize| places.map(|p| node(corners[p].0, corners[p].1, k));
                let ([a, b, c, d], [e, f, g, h]) = (at(0), at(1));
                sheet.elements.push([a, b, c, d, e, f, g, h]);
            };
            match cell {
                Cell::Hexahedron => add([0, 1, 2, 3]),
                Cell::Wedges if (i + j) % 2 == 0 => {
                    [[0, 1, 2, 2], [0, 2, 3, 3]].into_iter().for_each(&mut add)
                }
                Cell::Wedges => [[0, 1, 3, 3], [1, 2, 3, 3]].into_iter().for_each(&mut add),
            }
        }
        sheet
    }

    /// Displacements and forces by component, of components held at displacements and of forces on nodes.
    fn solve(
        &self,
        kind: Kind,
        moduli: Moduli,
        held: impl Fn([f64; 3], usize) -> Option<f64>,
        load: impl Fn([f64; 3]) -> [f64; 3],
    ) -> [Vec<f64>; 2] {
        let n = 3 * self.nodes.len();
        let band = 6 * (self.cells[1] + 3);
        // Rows of the lower half, from the diagonal leftwards.
        let mut k = vec![vec![0.0; band]; n];
        for element in &self.elements {
            let hex = Hex8::new(element.map(|n| self.nodes[n])).unwrap();
            for column in 0..24 {
                let mut u = [[0.0; 3]; 8];
                u[column / 3][column % 3] = 1.0;
                let (f, _) = pass(kind, moduli, &hex, u);
                let at = 3 * element[column / 3] + column % 3;
                for (node, f) in element.iter().zip(f) {
                    for (i, f) in f.into_iter().enumerate().filter(|(i, _)| 3 * node + i >= at) {
                        k[3 * node + i][3 * node + i - at] += f;
                    }
                }
            }
        }
        let held: Vec<Option<f64>> = (0..n).map(|i| held(self.nodes[i / 3], i % 3)).collect();
        let mut u: Vec<f64> = self.nodes.iter().flat_map(|&x| load(x)).collect();
        let whole = k.clone();
        let entry = |k: &[Vec<f64>], i: usize, j: usize| {
            let (i, j) = (i.max(j), i.min(j));
            k[i].get(i - j).copied().unwrap_or(0.0)
        };
        let near = |i: usize| i.saturating_sub(band)..(i + band).min(n);
        for i in 0..n {
            u[i] = held[i].unwrap_or_else(|| {
                u[i] - near(i).filter_map(|j| Some(entry(&whole, i, j) * held[j]?)).sum::<f64>()
            });
            for d in 0..band.min(i + 1) {
                if held[i].is_some() || held[i - d].is_some() {
                    k[i][d] = if d == 0 { 1.0 } else { 0.0 };
                }
            }
        }
        // LDLᵀ in the band.
        for i in 0..n {
            for j in i.saturating_sub(band - 1)..=i {
                let from = i.saturating_sub(band - 1).max(j.saturating_sub(band - 1));
                let less: f64 = (from..j).map(|m| k[i][i - m] * k[j][j - m] * k[m][0]).sum();
                k[i][i - j] -= less;
                if j < i {
                    k[i][i - j] /= k[j][0];
                }
            }
        }
        for i in 0..n {
            u[i] -= (i.saturating_sub(band - 1)..i).map(|m| k[i][i - m] * u[m]).sum::<f64>();
        }
        for i in (0..n).rev() {
            u[i] = u[i] / k[i][0] - (i + 1..(i + band).min(n)).map(|m| k[m][m - i] * u[m]).sum::<f64>();
        }
        let force = |i: usize| near(i).map(|j| entry(&whole, i, j) * u[j]).sum::<f64>();
        let forces = (0..n).map(force).collect();
        [u, forces]
    }

    /// Σ over the nodes at a place.
    fn sum(&self, values: &[f64], component: usize, at: impl Fn([f64; 3]) -> bool) -> f64 {
        let there = (0..self.nodes.len()).filter(|&n| at(self.nodes[n]));
        there.map(|n| values[3 * n + component]).sum()
    }
}

/// A cantilever of ν = 0 whose tip moves by 1 mm: its deflection over Timoshenko's, with a shear factor of 5/6.
fn strip(kind: Kind, sides: [f64; 3], cells: [usize; 2], cell: Cell, zigzag: f64) -> f64 {
    let [length, width, thickness] = sides;
    let sheet = Sheet::new(cells, cell, |[i, j], k| {
        let step = length / cells[0] as f64;
        let inner = if i == 0 || i == cells[0] { 0.0 } else { 0.5 * zigzag * step };
        let x = step * i as f64 + if j % 2 == 0 { -inner } else { inner };
        [x, width * j as f64 / cells[1] as f64, thickness * k]
    });
    let tip = |[x, ..]: [f64; 3]| x > length - 1e-9;
    let held = |x: [f64; 3], i: usize| match () {
        () if x[0] < 1e-9 => Some(0.0),
        () if tip(x) && i == 2 => Some(1e-3),
        () => None,
    };
    let [_, forces] = sheet.solve(kind, Moduli::from_young_poisson(YOUNG, 0.0), held, |_| [0.0; 3]);
    let force = sheet.sum(&forces, 2, tip);
    let second = width * thickness.powi(3) / 12.0;
    let shear = 5.0 / 6.0 * 0.5 * YOUNG * width * thickness;
    1e-3 / (force * (length.powi(3) / (3.0 * YOUNG * second) + length / shear))
}

/// A quarter of a ring of radius 5 m under two forces across it, plane strain: its deflection over that of 48 hexahedra a quarter.
fn ring(kind: Kind, thickness: f64, cells: [usize; 2], cell: Cell) -> f64 {
    const NU: f64 = 0.2;
    let force = |cells: [usize; 2], cell: Cell| {
        let step = 0.5 * std::f64::consts::PI / cells[0] as f64;
        let sheet = Sheet::new(cells, cell, |[i, j], k| {
            let (sin, cos) = (step * i as f64).sin_cos();
            let radius = 5.0 + thickness * k;
            [radius * sin, 5.0 * step * j as f64, radius * cos]
        });
        let width = 5.0 * step * cells[1] as f64;
        let held = |[x, y, z]: [f64; 3], i: usize| match i {
            0 if x < 1e-9 => Some(0.0),
            1 if y < 1e-9 || y > width - 1e-9 => Some(0.0),
            2 if z < 1e-9 => Some(0.0),
            2 if x < 1e-9 => Some(-1e-4),
            _ => None,
        };
        let [_, forces] = sheet.solve(kind, Moduli::from_young_poisson(YOUNG, NU), held, |_| [0.0; 3]);
        sheet.sum(&forces, 2, |[x, ..]| x < 1e-9) / width
    };
    force([48, 1], Cell::Hexahedron) / force(cells, cell)
}

/// A rhombic plate of 100 × 100 at 30°, 1 thick, held along its edges, under a uniform load: the deflection of its middle over the 4.08·10⁻⁴ qa⁴/D of
/// `morley1963`.
fn skew_plate(cells: usize, cell: Cell) -> f64 {
    let (young, nu, side) = (1e7, 0.3, 100.0);
    let (sin, cos) = (std::f64::consts::PI / 6.0).sin_cos();
    let sheet = Sheet::new([cells; 2], cell, |[i, j], k| {
        let [a, b] = [i, j].map(|i| side * i as f64 / cells as f64);
        [a + cos * b, sin * b, k]
    });
    // Places along the sides, from −½ to ½.
    let place = |[x, y, _]: [f64; 3]| [(x - y * cos / sin) / side - 0.5, y / sin / side - 0.5];
    let ends = |x: [f64; 3]| place(x).map(|a| if a.abs() > 0.5 - 1e-9 { a.signum() } else { 0.0 });
    let held = |x: [f64; 3], i: usize| {
        let [a, b] = ends(x);
        let holds = match i {
            0 => [a, b] == [-1.0, -1.0] && x[2] < 0.0,
            1 => a * b != 0.0 && b < 0.0 && x[2] < 0.0,
            _ => (a != 0.0 || b != 0.0) && x[2] < 0.0,
        };
        holds.then_some(0.0)
    };
    let load = |x: [f64; 3]| {
        let share: f64 = ends(x).map(|a| if a == 0.0 { 1.0 } else { 0.5 }).into_iter().product();
        [0.0, 0.0, -0.5 * share * side * side * sin / (cells * cells) as f64]
    };
    let [u, _] = sheet.solve(LAYERED, Moduli::from_young_poisson(young, nu), held, load);
    let middle = |x: [f64; 3]| place(x).iter().all(|a| a.abs() < 1e-9);
    let deflection = -0.5 * sheet.sum(&u, 2, middle);
    deflection * young / (12.0 * (1.0 - nu * nu)) / (4.08e-4 * side.powi(4))
}

/// The twisted beam of `macneal1985`: the motion of its tip over the published one, along the load, across its width and its thickness.
fn twisted_beam(cells: [usize; 2], cell: Cell) -> [f64; 2] {
    let [length, width, thickness] = [12.0, 1.1, 0.32];
    let sheet = Sheet::new(cells, cell, |[i, j], k| {
        let along = i as f64 / cells[0] as f64;
        let (sin, cos) = (0.5 * std::f64::consts::PI * along).sin_cos();
        let [y, z] = [width * (j as f64 / cells[1] as f64 - 0.5), thickness * k];
        [length * along, cos * y - sin * z, sin * y + cos * z]
    });
    let tip = |[x, ..]: [f64; 3]| x > length - 1e-9;
    let count = 2.0 * (cells[1] + 1) as f64;
    [(2, 5.424e-3), (1, 1.754e-3)].map(|(i, published)| {
        let load = |x: [f64; 3]| [0, 1, 2].map(|c| if tip(x) && c == i { 1.0 / count } else { 0.0 });
        let held = |x: [f64; 3], _: usize| (x[0] < 1e-9).then_some(0.0);
        let [u, _] = sheet.solve(LAYERED, Moduli::from_young_poisson(29e6, 0.22), held, load);
        sheet.sum(&u, i, tip) / count / published
    })
}

/// A side has 8 elements. Triangles of constant membrane strain and MITC3's shear are stiffer than hexahedra.
#[test]
fn a_skew_plate_and_a_twisted_beam_move_as_published() {
    for (cell, least) in [(Cell::Hexahedron, 0.93), (Cell::Wedges, 0.65)] {
        let found = skew_plate(8, cell);
        assert!((least..1.01).contains(&found), "skew plate: {found}");
    }
    for (cell, least) in [(Cell::Hexahedron, 0.99), (Cell::Wedges, 0.92)] {
        let found = twisted_beam([24, 4], cell);
        assert!(found.iter().all(|found| (least..1.005).contains(found)), "twisted beam: {found:?}");
    }
}

/// The last of hexahedra is that of the same division, 0.9945: wedges are as good.
#[test]
fn wedges_in_a_strip_bend_as_beams_do() {
    for kind in [LAYERED, Kind::Full] {
        // Of the plan alone, which is that of hexahedra with the shear of a corner's column: 1/(1 + 0.5 h²/t²) of what bends.
        for (sides, cells, least) in [
            ([3.0, 0.6, 0.5], [30, 6], 0.97),
            ([12.0, 1.2, 0.25], [10, 1], 0.95),
            ([3.0, 0.6, 0.05], [20, 4], 0.95),
        ] {
            let found = strip(kind, sides, cells, Cell::Wedges, 0.0);
            assert!((least..1.005).contains(&found), "{kind:?}, {cells:?}: {found}");
        }
    }
    let found = strip(Kind::OnePoint, [3.0, 0.6, 0.5], [30, 6], Cell::Wedges, 0.0);
    assert!((0.97..1.005).contains(&found), "one point: {found}");
}

/// R/t of 10 and 20, linings' range, with 16 a quarter.
#[test]
fn wedges_in_a_pinched_ring_bend_as_hexahedra_do() {
    for kind in [LAYERED, Kind::Full] {
        for thickness in [0.5, 0.25] {
            let found = ring(kind, thickness, [16, 2], Cell::Wedges);
            let hexahedra = ring(kind, thickness, [16, 2], Cell::Hexahedron);
            assert!(
                found > 0.98 && (found / hexahedra - 1.0).abs() < 0.01,
                "{kind:?}: {found} and {hexahedra}"
            );
        }
    }
}

/// Columns of nodes that zigzag by 0.3 of an element make trapezoids of the plan.
#[test]
fn hexahedra_whose_plan_zigzags_bend_as_beams_do() {
    for kind in [LAYERED, Kind::Full, Kind::OnePoint] {
        let found = strip(kind, [3.0, 0.6, 0.5], [30, 6], Cell::Hexahedron, 0.6);
        assert!((found - 1.0).abs() < 0.01, "{kind:?}: {found}");
    }
}
