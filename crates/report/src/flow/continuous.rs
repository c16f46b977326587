//! A flux that is continuous, made of one that cells have.

use std::collections::HashMap;

use super::{FlowCell, minus, size};

/// Points nearer than this are one (m).
const ONE: f64 = 1e-4;
/// How far outside a simplex a point may lie and is in it, over its size: round-off of places.
const OUTSIDE: f64 = 1e-6;
/// Faces of a hexahedron in the order of VTK.
const FACES: [[usize; 4]; 6] =
    [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]];

/// Where a point is, and its value there.
type Known<const D: usize> = ([f64; D], [f64; D]);

/// The flux: linear over simplices between the middle of a cell, the middles of its faces in space, and its corners.
pub struct Continuous<const D: usize> {
    pub cells: Vec<FlowCell<D>>,
    pub middles: Vec<[f64; D]>,
    boxes: Vec<[[f64; D]; 2]>,
    /// By cell and corner, what flows there (m/s).
    corners: Vec<Vec<[f64; D]>>,
    /// Cells by the cubes that they reach into, and the side of these (m).
    reached: HashMap<[i64; D], Vec<usize>>,
    side: f64,
}

impl<const D: usize> Continuous<D> {
    pub fn of(cells: Vec<FlowCell<D>>) -> Self {
        let key = |at: &[f64; D]| at.map(|x| (x / ONE).round() as i64);
        let middles: Vec<[f64; D]> = cells.iter().map(|cell| mean(&cell.corners)).collect();
        let mut sums: HashMap<[i64; D], ([f64; D], f64)> = HashMap::new();
        for (cell, middle) in cells.iter().zip(&middles) {
            let mut own: Vec<&[f64; D]> = cell.corners.iter().collect();
            own.sort_by_key(|at| key(at));
            own.dedup_by_key(|at| key(at));
            for at in own {
                let share = 1.0 / size(&minus(at, middle)).max(ONE);
                let (sum, shares) = sums.entry(key(at)).or_insert(([0.0; D], 0.0));
                (0..D).for_each(|i| sum[i] += share * cell.flow[i]);
                *shares += share;
            }
        }
        let at_corner = |at: &[f64; D]| {
            let (sum, shares) = sums[&key(at)];
            sum.map(|x| x / shares)
        };
        let corners = cells.iter().map(|cell| cell.corners.iter().map(at_corner).collect()).collect();
        let boxes: Vec<[[f64; D]; 2]> = cells.iter().map(around).collect();
        let widest = boxes.iter().map(|[low, high]| (0..D).map(|i| high[i] - low[i]).fold(0.0, f64::max));
        let side = (2.0 * widest.sum::<f64>() / boxes.len().max(1) as f64).max(ONE);
        let mut reached: HashMap<[i64; D], Vec<usize>> = HashMap::new();
        for (cell, ends) in boxes.iter().enumerate() {
            let [low, high] = ends.map(|end| end.map(|x| (x / side).floor() as i64));
            let mut cube = low;
            loop {
                reached.entry(cube).or_default().push(cell);
                let Some(next) = (0..D).find(|&i| cube[i] < high[i]) else { break };
                cube[next] += 1;
                cube[..next].copy_from_slice(&low[..next]);
            }
        }
        Continuous { cells, middles, boxes, corners, reached, side }
    }

    /// What flows at a place (m/s), and the cell that it is in; nothing outside. Where the cell before is known, it is looked at first.
    pub fn at(&self, place: &[f64; D], before: Option<usize>) -> Option<([f64; D], usize)> {
        let cube = place.map(|x| (x / self.side).floor() as i64);
        let others = self.reached.get(&cube).into_iter().flatten().copied();
        before.into_iter().chain(others).find_map(|cell| Some((self.inside(cell, place)?, cell)))
    }

    /// What flows at a place of a cell.
    fn inside(&self, cell: usize, place: &[f64; D]) -> Option<[f64; D]> {
        let [low, high] = self.boxes[cell];
        if (0..D).any(|i| place[i] < low[i] - ONE || place[i] > high[i] + ONE) {
            return None;
        }
        self.simplices(cell).find_map(|points| {
            let shares = shares(&points[..=D], place)?;
            Some(std::array::from_fn(|i| {
                shares.iter().zip(&points).map(|(share, (_, flow))| share * flow[i]).sum()
            }))
        })
    }

    /// The simplices of a cell, of D + 1 points each.
    fn simplices(&self, cell: usize) -> impl Iterator<Item = [Known<D>; 4]> {
        let FlowCell { corners, flow, .. } = &self.cells[cell];
        let known = move |k: usize| (corners[k], self.corners[cell][k]);
        let middle = (self.middles[cell], *flow);
        let number = if D == 2 { corners.len() } else { 24 };
        (0..number).map(move |k| {
            if D == 2 {
                return [middle, known(k), known((k + 1) % corners.len()), middle];
            }
            let face = FACES[k / 4];
            let [places, flows] = [face.map(|c| known(c).0), face.map(|c| known(c).1)].map(|of| mean(&of));
            [middle, (places, flows), known(face[k % 4]), known(face[(k + 1) % 4])]
        })
    }

    /// Area of a polygon (m²), volume of a hexahedron (m³).
    pub fn volume(&self, cell: usize) -> f64 {
        let of = |points: [Known<D>; 4]| {
            let edges: [[f64; D]; D] = std::array::from_fn(|i| minus(&points[i + 1].0, &points[0].0));
            determinant(edges).abs() / if D == 2 { 2.0 } else { 6.0 }
        };
        self.simplices(cell).map(of).sum()
    }

    /// How wide a cell is (m): the geometric mean along the axes.
    pub fn width(&self, cell: usize) -> f64 {
        let [low, high] = self.boxes[cell];
        (0..D).map(|i| high[i] - low[i]).product::<f64>().powf(1.0 / D as f64)
    }
}

fn mean<const D: usize>(points: &[[f64; D]]) -> [f64; D] {
    std::array::from_fn(|i| points.iter().map(|point| point[i]).sum::<f64>() / points.len().max(1) as f64)
}

fn around<const D: usize>(cell: &FlowCell<D>) -> [[f64; D]; 2] {
    let end = |of: fn(f64, f64) -> f64, from: f64| {
        std::array::from_fn(|i| cell.corners.iter().map(|corner| corner[i]).fold(from, of))
    };
    [end(f64::min, f64::INFINITY), end(f64::max, f64::NEG_INFINITY)]
}

/// The shares of a simplex's corners in a place within it.
fn shares<const D: usize>(points: &[Known<D>], place: &[f64; D]) -> Option<[f64; 4]> {
    let edges: [[f64; D]; D] = std::array::from_fn(|i| minus(&points[i + 1].0, &points[0].0));
    let whole = determinant(edges);
    let longest = edges.iter().map(size).fold(0.0, f64::max);
    // What is flat holds nothing.
    if whole.abs() <= f64::EPSILON * longest.powi(D as i32) {
        return None;
    }
    let from = minus(place, &points[0].0);
    let mut found = [0.0; 4];
    for k in 0..D {
        let mut other = edges;
        other[k] = from;
        found[k + 1] = determinant(other) / whole;
    }
    found[0] = 1.0 - found[1..=D].iter().sum::<f64>();
    found[..=D].iter().all(|share| *share >= -OUTSIDE).then_some(found)
}

fn determinant<const D: usize>(rows: [[f64; D]; D]) -> f64 {
    let minor = |a: usize, b: usize, i: usize, j: usize| rows[a][i] * rows[b][j] - rows[a][j] * rows[b][i];
    if D == 2 {
        return minor(0, 1, 0, 1);
    }
    rows[0][0] * minor(1, 2, 1, 2) - rows[0][1] * minor(1, 2, 0, 2) + rows[0][2] * minor(1, 2, 0, 1)
}
