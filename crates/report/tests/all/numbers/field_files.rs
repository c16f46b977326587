//! The numbers of field files.

use std::fs;
use std::path::Path;

use tremolite_mesh::vtu::{Array, Grid, Values};

use super::known::{Content, Kind, Known, factor};

/// The field files of a folder with other numbers; their places have one factor in all files.
pub fn fields(from: &Path, to: &Path, folder: &str, copy: u64, content: &mut Content) {
    fs::create_dir_all(to).unwrap();
    let mut files: Vec<_> = fs::read_dir(from).unwrap().map(|entry| entry.unwrap().path()).collect();
    files.sort();
    for path in files.iter().filter(|path| path.extension().is_some_and(|ending| ending == "vtu")) {
        let file = path.file_name().unwrap().to_str().unwrap();
        let mut grid = Grid::read(path).unwrap();
        let places = factor(copy, "places");
        let mut known =
            |name: String, value: f64| content.known.push(Known { kind: Kind::Field, name, value });
        for i in 0..3 {
            let all = || grid.points.iter().map(|p| p[i] * places);
            known(format!("{folder}/{file}: largest place {i}"), all().fold(f64::MIN, f64::max));
            known(format!("{folder}/{file}: smallest place {i}"), all().fold(f64::MAX, f64::min));
        }
        for point in &mut grid.points {
            *point = point.map(|x| x * places);
        }
        for array in grid.point_data.iter_mut().chain(&mut grid.cell_data) {
            // Directions, and states, which some files hold as floating-point numbers.
            if array.name == "normal" || array.name.contains("state") {
                continue;
            }
            let by = factor(copy, &format!("{folder}/{file}: {}", array.name));
            scale(array, by);
            let finite = || (0..array.values.len()).map(|k| array.values.get(k)).filter(|x| x.is_finite());
            known(format!("{folder}/{file}: largest {}", array.name), finite().fold(f64::MIN, f64::max));
            known(format!("{folder}/{file}: smallest {}", array.name), finite().fold(f64::MAX, f64::min));
        }
        grid.write(&to.join(file)).unwrap();
    }
}

fn scale(array: &mut Array, by: f64) {
    match &mut array.values {
        Values::Float32(values) => values.iter_mut().for_each(|x| *x = (f64::from(*x) * by) as f32),
        Values::Float64(values) => values.iter_mut().for_each(|x| *x *= by),
        _ => {}
    }
}
