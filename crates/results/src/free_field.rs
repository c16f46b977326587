//! `free_field.csv`, read: velocities at the top and the base of each column of the free field, and of the model beside them.
//!
//! Names tell which corners of the model a column stands for: [`Station::serves`].

use std::path::Path;

use indexmap::IndexMap;

use crate::{Error, Subject, Table};

/// The axes of the model, in the order of all arrays here.
const AXES: [&str; 3] = ["x", "y", "z"];
/// What stands behind the component of a velocity that theory predicts.
const THEORY: &str = "_theory";
/// And that of the equivalent-linear column.
const EQUIVALENT: &str = "_equivalent";

/// What stands before the component of a velocity at the place of a record.
const RECORD: &str = "record.free_field.v";

/// What stands between a monitor's name and the component of the free field's velocity at its level.
const BESIDE: &str = ".free_field.v";

/// What was recorded of the free field. What the file does not hold is empty, and columns of other names are passed over.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FreeField {
    /// Times of the rows (s).
    pub time: Vec<f64>,
    /// The columns, in the order of the file.
    pub columns: Vec<Station>,
    /// Means of the model's own surface and base over its four vertical edges; no theory.
    pub model: Option<Station>,
    /// The model itself at its vertical edges, named `xmin-ymin` …; no theory. Empty in files of older versions.
    pub corners: Vec<Station>,
    /// Velocity of the free field at the place of a record that was deconvolved (m/s), or at the level of a monitor that is
    /// called `record`, along x, y and z; empty where the file has no such column.
    pub record: [Vec<f64>; 3],
    /// Monitor → velocity of the free field at its level (m/s) along x, y and z.
    pub beside: IndexMap<String, [Vec<f64>; 3]>,
    /// The file ended in the middle of a line: see [`Table::cut`].
    pub cut: bool,
}

/// A column of the free field, or the model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Station {
    /// `reference`, `reference-xmin-ymin+xmin-ymax`, `xmin-ymax` …; `model` of the model's mean, of its corners their own.
    pub name: String,
    /// At the surface.
    pub top: Velocities,
    /// At the base.
    pub base: Velocities,
}

/// Velocities at one place along x, y and z (m/s), a value for each row; empty where the file has no such column.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Velocities {
    /// What the run did.
    pub measured: [Vec<f64>; 3],
    /// What theory of the layered column predicts. Also empty where no value is a number: there is no theory then.
    pub theory: [Vec<f64>; 3],
    /// What the equivalent-linear column has beside ground that yields; along x and y at the surface of one column, or nowhere.
    pub equivalent: [Vec<f64>; 3],
}

/// What a column holds of a velocity.
enum Of {
    Run,
    Theory,
    Equivalent,
}

impl Station {
    /// The surface, then the base.
    pub fn places(&self) -> [&Velocities; 2] {
        [&self.top, &self.base]
    }

    /// Whether a column stands for the ground at a corner of the model (`xmin-ymax`): `reference` for all; `reference-` and
    /// names of corners with `+` between for those; at the end of a slab, `ymax-xmin`, for where the two sides meet.
    pub fn serves(&self, corner: &str) -> bool {
        match self.name.strip_prefix("reference") {
            Some("") => true,
            Some(served) => served.strip_prefix('-').is_some_and(|s| s.split('+').any(|one| one == corner)),
            None => {
                let turned = self.name.split_once('-').map(|(side, end)| format!("{end}-{side}"));
                self.name == corner || turned.as_deref() == Some(corner)
            }
        }
    }
}

impl FreeField {
    /// Reads the file.
    ///
    /// # Errors
    /// Those of [`Table::read`].
    pub fn read(path: &Path) -> Result<Self, Error> {
        Table::read(path).map(Self::of)
    }

    /// What a table holds of the free field: `top.vx`, `top.vx_theory`, `top.vx_equivalent`, `base.vx` … of columns, `surface.vx`, `base.vx` … of the
    /// model and its edges, and `record.free_field.vx` ….
    pub fn of(table: Table) -> Self {
        let mut found = FreeField { cut: table.cut, ..FreeField::default() };
        let mut model = Vec::new();
        for (column, values) in table.columns.iter().zip(table.values) {
            if column.name == "time" {
                found.time = values;
                continue;
            }
            if let Some(axis) = AXES.iter().position(|axis| column.name == format!("{RECORD}{axis}")) {
                found.record[axis] = values;
                continue;
            }
            let of_monitor = column.name.split_once(BESIDE);
            let of_monitor = of_monitor
                .and_then(|(name, axis)| Some((name, AXES.iter().position(|known| *known == axis)?)));
            if let Some((monitor, axis)) = of_monitor {
                found.beside.entry(monitor.to_owned()).or_default()[axis] = values;
                continue;
            }
            let (stations, name) = match &column.subject {
                Subject::Column(name) => (&mut found.columns, name.as_str()),
                Subject::Edge(name) => (&mut found.corners, name.as_str()),
                Subject::Model => (&mut model, "model"),
                _ => continue,
            };
            let Some((at_top, axis, of)) = place(&column.quantity) else { continue };
            let known = stations.iter().position(|station| station.name == name).unwrap_or(stations.len());
            if known == stations.len() {
                stations.push(Station { name: name.into(), ..Station::default() });
            }
            let station = &mut stations[known];
            let velocities = if at_top { &mut station.top } else { &mut station.base };
            match of {
                Of::Run => velocities.measured[axis] = values,
                Of::Theory if values.iter().any(|v| v.is_finite()) => velocities.theory[axis] = values,
                Of::Theory => {}
                Of::Equivalent => velocities.equivalent[axis] = values,
            }
        }
        found.model = model.pop();
        found
    }
}

/// Whether a velocity is that at the surface, along which axis, and by what.
fn place(quantity: &str) -> Option<(bool, usize, Of)> {
    let (place, component) = quantity.split_once('.')?;
    let at_top = match place {
        "top" | "surface" => true,
        "base" => false,
        _ => return None,
    };
    let behind = [(THEORY, Of::Theory), (EQUIVALENT, Of::Equivalent)];
    let of = behind.into_iter().find_map(|(word, of)| Some((component.strip_suffix(word)?, of)));
    let (component, of) = of.unwrap_or((component, Of::Run));
    let axis = component.strip_prefix('v')?;
    let axis = AXES.iter().position(|known| *known == axis)?;
    Some((at_top, axis, of))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Column, by_name};

    /// Of columns as old files have them.
    fn of(columns: &[(&str, &[f64])]) -> FreeField {
        let values = columns.iter().map(|(_, values)| values.to_vec()).collect();
        let mut columns: Vec<Column> = columns.iter().map(|(name, _)| Column::new(*name, "m/s")).collect();
        by_name::complete("free_field", &mut columns);
        FreeField::of(Table::new(columns, values))
    }

    #[test]
    fn columns_keep_their_order_and_the_model_stands_apart() {
        let found = of(&[
            ("time", &[0.0, 0.1]),
            ("model.surface.vx", &[7.0, 8.0]),
            ("xmin-ymin.top.vx", &[1.0, 2.0]),
            ("xmin-ymin.top.vx_theory", &[1.5, 2.5]),
            ("xmin-ymin.top.vy_equivalent", &[1.6, 2.6]),
            ("ymin-xmax.base.vz", &[3.0, 4.0]),
            ("xmin-ymin.base.vx", &[5.0, 6.0]),
            ("crown.free_field.vy", &[9.0, 9.5]),
        ]);
        assert_eq!(found.beside["crown"], [vec![], vec![9.0, 9.5], vec![]]);
        let names: Vec<&str> = found.columns.iter().map(|station| station.name.as_str()).collect();
        assert_eq!(names, ["xmin-ymin", "ymin-xmax"]);
        assert_eq!(found.time, [0.0, 0.1]);
        let [first, second] = &found.columns[..] else { panic!() };
        assert_eq!((&first.top.measured[0], &first.top.theory[0]), (&vec![1.0, 2.0], &vec![1.5, 2.5]));
        assert_eq!(first.top.equivalent, [vec![], vec![1.6, 2.6], vec![]]);
        assert_eq!((&first.base.measured[0], &second.base.measured[2]), (&vec![5.0, 6.0], &vec![3.0, 4.0]));
        assert!(
            first.base.theory[0].is_empty()
                && first.places() == [&first.top, &first.base]
                && second.top.measured.iter().all(Vec::is_empty)
        );
        assert_eq!(found.model.unwrap().top.measured[0], [7.0, 8.0]);
    }

    #[test]
    fn the_place_of_a_record_is_no_column() {
        let found = of(&[
            ("record.free_field.vx", &[1.0]),
            ("record.free_field.vz", &[2.0]),
            ("A.free_field.vx", &[3.0]),
            ("record.top.vx", &[4.0]),
        ]);
        assert_eq!(found.record, [vec![1.0], vec![], vec![2.0]]);
        let names: Vec<&str> = found.columns.iter().map(|station| station.name.as_str()).collect();
        assert_eq!(names, ["record"], "a column of that name is one");
    }

    #[test]
    fn corners_of_the_model_are_no_columns_and_names_tell_what_stands_for_them() {
        let found = of(&[
            ("reference-xmin-ymin+xmax-ymax.top.vx", &[1.0]),
            ("model.surface.vx", &[2.0]),
            ("model.xmin-ymin.surface.vx", &[3.0]),
            ("model.xmax-ymin.base.vy", &[4.0]),
            ("model.xmin-ymin.base.vz", &[5.0]),
        ]);
        let names = |of: &[Station]| of.iter().map(|station| station.name.clone()).collect::<Vec<_>>();
        assert_eq!(names(&found.columns), ["reference-xmin-ymin+xmax-ymax"]);
        assert_eq!(names(&found.corners), ["xmin-ymin", "xmax-ymin"]);
        assert_eq!(found.model.unwrap().top.measured[0], [2.0]);
        assert_eq!(
            (&found.corners[0].top.measured[0], &found.corners[0].base.measured[2]),
            (&vec![3.0], &vec![5.0])
        );
        assert_eq!(found.corners[1].base.measured[1], [4.0]);

        let corners = ["xmin-ymin", "xmax-ymin", "xmin-ymax", "xmax-ymax"];
        for (name, served) in [
            ("reference", &[0, 1, 2, 3][..]),
            ("reference-xmin-ymin+xmax-ymax", &[0, 3]),
            ("reference-xmax-ymin", &[1]),
            ("xmin-ymax", &[2]),
            ("ymax-xmin", &[2]),
            ("referencexmin-ymin", &[]),
            ("xmin", &[]),
        ] {
            let station = Station { name: name.into(), ..Station::default() };
            let found: Vec<usize> = (0..4).filter(|&k| station.serves(corners[k])).collect();
            assert_eq!(found, served, "{name}");
        }
    }

    #[test]
    fn what_is_not_of_the_free_field_is_passed_over() {
        let found = of(&[
            ("time", &[0.0]),
            ("reference.top.ax", &[1.0]),
            ("reference.middle.vx", &[1.0]),
            ("reference.top.vr", &[1.0]),
            ("reference.top.v", &[1.0]),
            ("top.vx", &[1.0]),
            ("vx", &[1.0]),
            ("", &[1.0]),
        ]);
        assert_eq!(found, FreeField { time: vec![0.0], ..FreeField::default() });
    }

    #[test]
    fn theory_without_a_number_is_no_theory() {
        let gap = [f64::NAN, f64::NAN];
        let found = of(&[
            ("a.b.top.vx", &[1.0, 2.0]),
            ("a.b.top.vx_theory", &gap),
            ("a.b.top.vy_theory", &[f64::NAN, 1.0]),
        ]);
        assert_eq!(found.columns[0].name, "a.b");
        assert!(found.columns[0].top.theory[0].is_empty() && !found.columns[0].top.theory[1].is_empty());
    }
}
