//! Interfaces as surfaces: the faces of a file in `interfaces/`, with what their pairs did.

use std::collections::{BTreeMap, HashMap};
use std::path::Path;

use tremolite_mesh::vtu::{Grid, VtuError};

/// One interface at one time. Points are its pairs; at sharp edges several lie at one place.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct PairSurface {
    /// Which interface of the run, from 0.
    pub interface: usize,
    /// Places of the pairs \[m\], and unit normals out of the first side into the second.
    pub points: Vec<[f64; 3]>,
    pub normals: Vec<[f64; 3]>,
    /// Faces by their pairs, three or four each.
    pub faces: Vec<Vec<u32>>,
    /// Number of the element behind each face on its first side.
    pub elements: Vec<i64>,
    /// By pair: largest slip and gap over the run \[m\]; 0 bonded, 1 stuck, 2 sliding, 3 open; whether it slid and opened
    /// in any step.
    pub slip_max: Vec<f64>,
    pub gap_max: Vec<f64>,
    pub state: Vec<u8>,
    pub slid: Vec<bool>,
    pub opened: Vec<bool>,
}

impl PairSurface {
    /// Reads all interfaces of a file, in the order of their numbers.
    ///
    /// # Errors
    /// If the file cannot be read, see [`Grid::read`], or lacks an array.
    pub fn read(path: &Path) -> Result<Vec<PairSurface>, VtuError> {
        let grid = Grid::read(path)?;
        Self::of(&grid).map_err(|reason| VtuError::Format { path: path.to_owned(), reason })
    }

    /// As [`PairSurface::read`] of a grid in memory, which must pass [`Grid::check`].
    ///
    /// # Errors
    /// If it lacks an array, in words.
    pub fn of(grid: &Grid) -> Result<Vec<PairSurface>, String> {
        let of_points = |name: &str, components: usize| {
            let array = grid.point_array(name).filter(|a| a.components == components);
            array.ok_or_else(|| format!("no array {name} with {components} components at its points"))
        };
        let of_cells = |name: &str| {
            let array = grid.cell_array(name).filter(|a| a.components == 1);
            array.ok_or_else(|| format!("no array {name} at its cells"))
        };
        let normal = of_points("normal", 3)?;
        let [slip_max, gap_max, state, slid, opened] = [
            of_points("slip_max", 1)?,
            of_points("gap_max", 1)?,
            of_points("state", 1)?,
            of_points("slid", 1)?,
            of_points("opened", 1)?,
        ];
        let (interface, element) = (of_cells("interface")?, of_cells("element")?);

        let mut surfaces: BTreeMap<usize, (PairSurface, HashMap<u32, u32>)> = BTreeMap::new();
        for cell in 0..grid.types.len() {
            let number = interface.values.get(cell).max(0.0) as usize;
            let (own, known) = surfaces.entry(number).or_default();
            own.interface = number;
            let mut face = Vec::with_capacity(4);
            for &point in grid.cell(cell) {
                let k = point as usize;
                face.push(*known.entry(point).or_insert_with(|| {
                    own.points.push(grid.points[k]);
                    own.normals.push([0, 1, 2].map(|i| normal.values.get(3 * k + i)));
                    own.slip_max.push(slip_max.values.get(k));
                    own.gap_max.push(gap_max.values.get(k));
                    own.state.push(state.values.get(k) as u8);
                    own.slid.push(slid.values.get(k) != 0.0);
                    own.opened.push(opened.values.get(k) != 0.0);
                    own.points.len() as u32 - 1
                }));
            }
            own.faces.push(face);
            own.elements.push(element.values.get(cell) as i64);
        }
        Ok(surfaces.into_values().map(|(own, _)| own).collect())
    }
}

/// Which elements the groups of a field file hold.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ElementGroups {
    /// Index of each element's cell, by its number.
    cells: HashMap<i64, usize>,
    /// Name, whether each cell is inside, and how many are.
    groups: Vec<(String, Vec<bool>, usize)>,
}

impl ElementGroups {
    /// Reads the arrays `element` and `group:NAME` of a file in `fields/`; no groups where it has none.
    ///
    /// # Errors
    /// If the file cannot be read, see [`Grid::read`].
    pub fn read(path: &Path) -> Result<Self, VtuError> {
        Ok(Self::of(&Grid::read(path)?))
    }

    /// As [`ElementGroups::read`] of a grid in memory, which must pass [`Grid::check`].
    pub fn of(grid: &Grid) -> Self {
        let number = |cell: usize| Some((grid.cell_array("element")?.values.get(cell) as i64, cell));
        let cells = (0..grid.types.len()).filter_map(number).collect();
        let group = |array: &tremolite_mesh::vtu::Array| {
            let name = array.name.strip_prefix("group:")?;
            let inside: Vec<bool> =
                (0..grid.types.len()).map(|cell| array.values.get(cell * array.components) != 0.0).collect();
            let number = inside.iter().filter(|x| **x).count();
            Some((name.to_owned(), inside, number))
        };
        ElementGroups { cells, groups: grid.cell_data.iter().filter_map(group).collect() }
    }

    /// The smallest group that holds all of these elements.
    pub fn of_all(&self, elements: &[i64]) -> Option<&str> {
        let cells: Vec<usize> = elements.iter().map(|e| self.cells.get(e).copied()).collect::<Option<_>>()?;
        let holding = self.groups.iter().filter(|(_, inside, _)| cells.iter().all(|&cell| inside[cell]));
        holding.min_by_key(|(_, _, number)| *number).map(|(name, ..)| name.as_str())
    }
}
