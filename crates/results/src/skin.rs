//! The outside of a lining: its faces that lie on other elements, and what is behind them.

use std::collections::HashMap;

use tremolite_mesh::vtu::Grid;

/// Faces of some elements that lie on elements which are not among these, whether they share nodes with them or not.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Skin {
    /// Corners of the faces, three or four a face, and the face's unit normal at each, outwards.
    pub points: Vec<[f64; 3]>,
    pub normals: Vec<[f64; 3]>,
    pub faces: Vec<Vec<u32>>,
    /// For each face the elements from it through to the open, by index of their cells, outermost first; its own alone where
    /// that way does not come into the open, as below a wall's foot.
    pub behind: Vec<Vec<usize>>,
}

/// A face of a cell: which cell, and which of its faces.
type Side = (usize, usize);

impl Skin {
    /// Of the cells for which `inside` is true. The grid must pass [`Grid::check`].
    ///
    /// # Panics
    /// If `inside` is shorter than there are cells.
    pub fn of(grid: &Grid, inside: &[bool]) -> Skin {
        let places = places(grid);
        let key = |cell: usize, face: &[usize]| {
            let nodes = grid.cell(cell);
            let mut key: Vec<u32> = face.iter().map(|&k| places[nodes[k] as usize]).collect();
            key.sort_unstable();
            key
        };
        let mut sides: HashMap<Vec<u32>, Vec<Side>> = HashMap::new();
        let cells = 0..grid.types.len();
        for cell in cells.clone().filter(|&cell| inside[cell]) {
            for (k, face) in faces(grid.types[cell]).iter().enumerate() {
                sides.entry(key(cell, face)).or_default().push((cell, k));
            }
        }
        let mut touched: HashMap<Side, bool> = HashMap::new();
        for cell in cells.filter(|&cell| !inside[cell]) {
            for face in faces(grid.types[cell]) {
                if let Some([side]) = sides.get(&key(cell, face)).map(Vec::as_slice) {
                    touched.insert(*side, true);
                }
            }
        }
        let mut own: Vec<Side> = touched.keys().copied().collect();
        own.sort_unstable();
        let mut skin = Skin::default();
        for side in own {
            let through = through(
                side,
                |(cell, face)| {
                    let all =
                        sides.get(&key(cell, faces(grid.types[cell])[face])).map_or(&[][..], Vec::as_slice);
                    match all.iter().find(|(other, _)| *other != cell) {
                        Some(next) => Beyond::Inside(*next),
                        None if touched.contains_key(&(cell, face)) => Beyond::Others,
                        None => Beyond::Open,
                    }
                },
                |cell, face| opposite(grid.types[cell], face),
            );
            skin.add(grid, side, through.unwrap_or_else(|| vec![side.0]));
        }
        skin
    }

    fn add(&mut self, grid: &Grid, (cell, face): Side, behind: Vec<usize>) {
        let nodes = grid.cell(cell);
        let corners: Vec<[f64; 3]> =
            faces(grid.types[cell])[face].iter().map(|&k| grid.points[nodes[k] as usize]).collect();
        let less = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| a[i] - b[i]);
        let mean = |points: &mut dyn Iterator<Item = [f64; 3]>| {
            let (sum, n) =
                points.fold(([0.0; 3], 0.0), |(s, n), p| ([0, 1, 2].map(|i| s[i] + p[i]), n + 1.0));
            sum.map(|c| c / n)
        };
        let [a, b] = if corners.len() == 4 {
            [less(corners[2], corners[0]), less(corners[3], corners[1])]
        } else {
            [less(corners[1], corners[0]), less(corners[2], corners[0])]
        };
        let normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
        let size = normal.iter().map(|c| c * c).sum::<f64>().sqrt();
        let outwards = less(
            mean(&mut corners.iter().copied()),
            mean(&mut nodes.iter().map(|&node| grid.points[node as usize])),
        );
        let sense = (0..3).map(|i| normal[i] * outwards[i]).sum::<f64>().signum();
        let first = self.points.len() as u32;
        self.faces.push((first..first + corners.len() as u32).collect());
        self.normals.extend(corners.iter().map(|_| normal.map(|c| sense * c / size.max(f64::MIN_POSITIVE))));
        self.points.extend(corners);
        self.behind.push(behind);
    }
}

/// What lies across a face.
enum Beyond {
    Inside(Side),
    Others,
    Open,
}

/// The cells from a face through to the open; none where it is not reached.
fn through(
    side: Side,
    beyond: impl Fn(Side) -> Beyond,
    opposite: impl Fn(usize, usize) -> Option<usize>,
) -> Option<Vec<usize>> {
    /// No lining has so many elements through its thickness.
    const DEEPEST: usize = 64;
    let (mut cell, mut face) = side;
    let mut cells = vec![cell];
    while cells.len() <= DEEPEST {
        match beyond((cell, opposite(cell, face)?)) {
            Beyond::Open => return Some(cells),
            Beyond::Others => return None,
            Beyond::Inside((next, across)) => {
                (cell, face) = (next, across);
                cells.push(cell);
            }
        }
    }
    None
}

/// Which of the different places each point has. Interfaces split nodes without moving them, so places agree to the bit.
fn places(grid: &Grid) -> Vec<u32> {
    let mut known: HashMap<[u64; 3], u32> = HashMap::with_capacity(grid.points.len());
    let place = |point: &[f64; 3]| {
        let next = known.len() as u32;
        // Zero has two signs.
        *known.entry(point.map(|c| (c + 0.0).to_bits())).or_insert(next)
    };
    grid.points.iter().map(place).collect()
}

/// Faces of a VTK cell by its local nodes, against the clock or with it; none for cells that are not solid and linear.
fn faces(kind: u8) -> &'static [&'static [usize]] {
    match kind {
        10 => &[&[0, 1, 2], &[0, 1, 3], &[1, 2, 3], &[2, 0, 3]],
        12 => &[&[0, 1, 2, 3], &[4, 5, 6, 7], &[0, 1, 5, 4], &[3, 2, 6, 7], &[1, 2, 6, 5], &[0, 3, 7, 4]],
        13 => &[&[0, 1, 2], &[3, 4, 5], &[0, 1, 4, 3], &[1, 2, 5, 4], &[2, 0, 3, 5]],
        14 => &[&[0, 1, 2, 3], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]],
        _ => &[],
    }
}

/// The face across a cell from another, where there is one.
fn opposite(kind: u8, face: usize) -> Option<usize> {
    match (kind, face) {
        (12, face) => Some(face ^ 1),
        (13, 0) => Some(1),
        (13, 1) => Some(0),
        _ => None,
    }
}
