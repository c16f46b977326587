//! motion.csv: the motion that a case gives, and the wave that comes in by it.

use crate::error::RunError;
use tremolite_engine::Incident;
use tremolite_motion::Motion;
use tremolite_results::{Column, ResultFolder, TableWriter};

/// Writes a row for each sample of the record within the duration \[s\]: acceleration, velocity and displacement of the given
/// motion and of the incident wave, along the model's axes. The wave is a motion times a factor, which is the given one unless
/// another is.
///
/// # Errors
/// If the file cannot be written.
pub fn write(
    folder: &ResultFolder,
    incident: &Incident,
    given: Option<&Motion>,
    duration: f64,
) -> Result<(), RunError> {
    const KINDS: [(&str, &str); 3] = [("a", "m/s2"), ("v", "m/s"), ("u", "m")];
    let mut columns = vec![Column::new("time", "s")];
    for of in ["given", "incident"] {
        for (kind, unit) in KINDS {
            columns.extend(["x", "y", "z"].map(|axis| Column::new(format!("{of}.{kind}{axis}"), unit)));
        }
    }
    let mut table = TableWriter::create(&folder.motion(), &columns)?;
    let Incident { motion, factor } = incident;
    let rows = (duration / motion.dt * (1.0 + 1e-12)).floor() as u64;
    for k in 0..=rows {
        let time = k as f64 * motion.dt;
        let at = |motion: &Motion| {
            let at = motion.at(time);
            [at.a, at.v, at.u].concat()
        };
        let mut row = vec![time];
        row.extend(at(given.unwrap_or(motion)));
        row.extend(at(motion).iter().map(|x| factor * x));
        table.write(&row)?;
    }
    Ok(table.sync()?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tremolite_motion::Sample;
    use tremolite_results::Table;

    #[test]
    fn the_wave_that_comes_in_is_the_given_motion_times_its_factor() {
        let parent = tempfile::tempdir().unwrap();
        let folder = ResultFolder::create(Some(&parent.path().join("out")), "case", false).unwrap();
        let motion = Motion::sampled(0.01, 1.0, |t| Sample {
            a: [2.0, 0.0, -6.0 * t],
            v: [2.0 * t, 0.0, -3.0 * t * t],
            u: [t * t, 0.0, -t.powi(3)],
        })
        .unwrap();
        write(&folder, &Incident { motion, factor: 0.5 }, None, 0.5).unwrap();
        let table = Table::read(&folder.motion()).unwrap();
        assert_eq!((table.rows(), table.columns.len()), (51, 19));
        let last = |name: &str| table.column(name).unwrap()[50];
        assert_eq!(table.unit("incident.az"), Some("m/s2"));
        assert!((last("given.uz") + 0.125).abs() < 1e-6 && (last("incident.vx") - 0.5).abs() < 1e-9);
        assert!((last("time") - 0.5).abs() < 1e-12 && last("given.ax") == 2.0 && last("incident.ax") == 1.0);
    }
}
