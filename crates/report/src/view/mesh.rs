//! The mesh of a part of the view: cells that come and go over the files, each held once.

use std::collections::HashMap;

use tremolite_results::FieldCell;

/// By which a cell is known in all files: the element's number, that of the element across (0 for a solid), and which of
/// several of this kind in one file.
type CellKey = (i64, i64, u32);

/// The union of a part's cells over the files. Points have no numbers in the files, and several may lie at one place (at
/// faults), so they are known as corners of cells.
pub struct Mesh {
    /// Corners of a cell: 8 of a solid, 4 of a face.
    pub per: usize,
    pub points: Vec<[f64; 3]>,
    /// Cell after cell.
    pub corners: Vec<u32>,
    /// Number of each cell's element.
    pub elements: Vec<u32>,
    known: HashMap<CellKey, u32>,
}

/// Where cells and points of one file stand in the mesh: pairs of the file's index and the mesh's.
#[derive(Default)]
pub struct Taken {
    pub cells: Vec<(usize, usize)>,
    pub points: Vec<(usize, usize)>,
}

impl Mesh {
    pub fn new(per: usize) -> Self {
        Mesh { per, points: Vec::new(), corners: Vec::new(), elements: Vec::new(), known: HashMap::new() }
    }

    /// The points of a cell.
    pub fn cell(&self, cell: usize) -> &[u32] {
        &self.corners[cell * self.per..(cell + 1) * self.per]
    }

    /// Takes in cells of a file, given with their index there; `places` are the file's points.
    pub fn take(&mut self, places: &[[f64; 3]], cells: &[(usize, &FieldCell)]) -> Taken {
        let mut taken = Taken::default();
        let mut repeats: HashMap<(i64, i64), u32> = HashMap::new();
        let mut key = |cell: &FieldCell| {
            let count = repeats.entry((cell.element, cell.other)).or_insert(0);
            *count += 1;
            (cell.element, cell.other, *count)
        };
        let keys: Vec<CellKey> = cells.iter().map(|(_, cell)| key(cell)).collect();
        let mut own_of = vec![u32::MAX; places.len()];
        // Known cells first: they say which points new ones share with them.
        for ((_, cell), key) in cells.iter().zip(&keys) {
            let Some(&known) = self.known.get(key) else { continue };
            let own = &self.corners[known as usize * self.per..];
            cell.corners.iter().zip(&own[..self.per]).for_each(|(&point, &own)| own_of[point as usize] = own);
        }
        for ((index, cell), key) in cells.iter().zip(keys) {
            let next = self.elements.len() as u32;
            let known = *self.known.entry(key).or_insert(next);
            if known == next {
                self.elements.push(cell.element as u32);
                for &point in &cell.corners[..self.per] {
                    let own = &mut own_of[point as usize];
                    if *own == u32::MAX {
                        *own = self.points.len() as u32;
                        self.points.push(places[point as usize]);
                    }
                    self.corners.push(*own);
                }
            }
            taken.cells.push((*index, known as usize));
        }
        let points = own_of.iter().enumerate().filter(|(_, own)| **own != u32::MAX);
        taken.points = points.map(|(point, &own)| (point, own as usize)).collect();
        taken
    }
}
