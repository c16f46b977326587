//! Arrays of a field file, by what they are for.

use tremolite_mesh::vtu::{Array, Grid};

/// Names under which a file may keep the number of each element's group.
const GROUPS: [&str; 4] = ["body", "group", "region", "material"];

/// The number of each element's group, where the file has it.
pub fn groups(grid: &Grid) -> Option<&Array> {
    GROUPS.iter().find_map(|name| grid.cell_array(name)).filter(|array| array.components == 1)
}

/// A scalar, or the length of a vector.
pub fn scalar(array: &Array, tuple: usize) -> f64 {
    let component = |i: usize| array.values.get(tuple * array.components + i);
    match array.components {
        1 => component(0),
        n => (0..n).map(|i| component(i) * component(i)).sum::<f64>().sqrt(),
    }
}
