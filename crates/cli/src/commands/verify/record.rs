//! Figures of verification as a file: what was run last of each problem.

use crate::exit::Failure;
use serde::{Deserialize, Serialize};
use std::path::Path;
use tremolite_results::replace_file;
use tremolite_verify::{Check, Verified};

/// What is known of the problems, in no order that matters: of each at most one plain run and one full run.
#[derive(Debug, Default, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Record {
    pub problems: Vec<Problem>,
}

/// The last run of one kind of one problem.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Problem {
    pub name: String,
    /// Whether finer meshes, series and long runs were taken in.
    pub full: bool,
    /// Wall time \[s\].
    pub seconds: f64,
    pub figures: Vec<Figure>,
}

/// One figure beside its reference, as in [`Check`].
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Figure {
    pub quantity: String,
    /// None where it is not a number.
    pub value: Option<f64>,
    pub reference: f64,
    pub tolerance: Option<f64>,
    pub pass: bool,
    pub order: Option<f64>,
    pub levels: Vec<[f64; 2]>,
    pub unit: String,
    pub note: String,
}

impl From<&Check> for Figure {
    fn from(check: &Check) -> Figure {
        Figure {
            quantity: check.quantity.clone(),
            value: Some(check.value).filter(|value| value.is_finite()),
            reference: check.reference,
            tolerance: check.tolerance,
            pass: check.pass,
            order: check.order.filter(|order| order.is_finite()),
            levels: check
                .levels
                .iter()
                .copied()
                .filter(|level| level.iter().all(|x| x.is_finite()))
                .collect(),
            unit: check.unit.to_owned(),
            note: check.note.clone(),
        }
    }
}

impl Figure {
    /// How far the value is from the reference, over the tolerance; none for a figure without one.
    pub fn share(&self) -> Option<f64> {
        let off = (self.value.unwrap_or(f64::INFINITY) - self.reference).abs();
        self.tolerance.map(|tolerance| if off == 0.0 { 0.0 } else { off / tolerance })
    }
}

/// By how much an order may be below the one that is on record and count as kept: what fewer digits of a machine's libraries leave of an order.
const KEPT: f64 = 0.05;

impl Record {
    /// The record in a file; an empty one where there is no file.
    ///
    /// # Errors
    /// If the file is none that [`Record::write`] wrote.
    pub fn read(path: &Path) -> Result<Record, Failure> {
        match std::fs::read_to_string(path) {
            Ok(text) => serde_json::from_str(&text).map_err(|error| {
                Failure::input(format!(
                    "{}: {error}\n  what to do: take the file back from the repository, or remove it and run `tremolite verify --full --write` anew",
                    path.display()
                ))
            }),
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(Record::default()),
            Err(error) => Err(Failure::input(format!("{}: {error}", path.display()))),
        }
    }

    /// Writes the record, a line for each figure.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), Failure> {
        let mut text = String::from("{\"problems\": [");
        for (k, problem) in self.problems.iter().enumerate() {
            let (name, full, seconds) = (line(&problem.name)?, problem.full, problem.seconds);
            text.push_str(if k == 0 { "\n" } else { ",\n" });
            text.push_str(&format!(
                "{{\"name\": {name}, \"full\": {full}, \"seconds\": {seconds:.2}, \"figures\": [\n"
            ));
            let figures: Result<Vec<String>, Failure> = problem.figures.iter().map(line).collect();
            text.push_str(&figures?.join(",\n"));
            text.push_str("\n]}");
        }
        text.push_str("\n]}\n");
        replace_file(path, text.as_bytes()).map_err(Failure::failed)
    }

    /// Takes in what a problem came to, in the place of what was known of it by a run of the same kind.
    pub fn take(&mut self, name: &str, full: bool, verified: &Verified) {
        let figures = verified.checks.iter().map(Figure::from).collect();
        let problem = Problem { name: name.to_owned(), full, seconds: verified.seconds, figures };
        match self.problems.iter_mut().find(|known| known.name == name && known.full == full) {
            Some(known) => *known = problem,
            None => self.problems.push(problem),
        }
    }

    /// The run of a problem that says most of it: the full one where there is one.
    pub fn problem(&self, name: &str) -> Option<&Problem> {
        self.of_kind(name, true).or_else(|| self.of_kind(name, false))
    }

    fn of_kind(&self, name: &str, full: bool) -> Option<&Problem> {
        self.problems.iter().find(|problem| problem.name == name && problem.full == full)
    }

    /// How many orders of a problem could be set beside those on record of a run of the same kind, and what is said of each that was lost. Full
    /// runs have finer meshes, so orders of the same names are other ones.
    pub fn orders(&self, name: &str, full: bool, verified: &Verified) -> (usize, Vec<String>) {
        let known = self.of_kind(name, full).map_or(&[][..], |problem| &problem.figures);
        let mut lost = Vec::new();
        let mut count = 0;
        for check in &verified.checks {
            let same = known.iter().find(|figure| figure.quantity == check.quantity);
            if let Some((was, now)) = same.and_then(|figure| figure.order).zip(check.order) {
                count += 1;
                // Written so that what is not a number is lost too.
                let kept = now >= was - KEPT;
                if !kept {
                    lost.push(format!(
                        "{name}: {}: order {now:.2}, {was:.2} on record: an order is lost",
                        check.quantity
                    ));
                }
            }
        }
        (count, lost)
    }
}

fn line(value: &impl Serialize) -> Result<String, Failure> {
    serde_json::to_string(value).map_err(Failure::failed)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn verified(value: f64, order: f64) -> Verified {
        let mut check = Check::new("x", "error", value, 0.0, 0.01, "1", "why");
        (check.order, check.levels) = (Some(order), vec![[2.0, 4.0 * value], [1.0, value]]);
        Verified { checks: vec![check], seconds: 1.25 }
    }

    #[test]
    fn what_is_written_is_read_and_a_second_run_takes_the_place_of_the_first_of_its_kind() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("figures.json");
        let mut record = Record::read(&path).unwrap();
        assert_eq!(record, Record::default());
        record.take("x", false, &verified(f64::NAN, 2.0));
        record.take("y", false, &verified(1e-3, 2.0));
        assert!(!record.problem("x").unwrap().full);
        record.take("x", true, &verified(0.5, 2.0));
        record.take("x", true, &verified(1.0 / 3.0, 2.0));
        record.write(&path).unwrap();
        let read = Record::read(&path).unwrap();
        assert_eq!(read, record);
        assert!(read.problems.len() == 3 && read.problem("x").unwrap().full);
        assert_eq!(read.problem("x").unwrap().figures[0].share(), Some(1.0 / 3.0 / 0.01));
        std::fs::write(&path, "{").unwrap();
        let refused = Record::read(&path).unwrap_err().message;
        assert!(refused.contains("figures.json") && refused.contains("what to do"), "{refused}");
    }

    #[test]
    fn an_order_that_falls_is_lost_and_one_that_nobody_knows_is_not_counted() {
        let mut record = Record::default();
        record.take("x", true, &verified(1e-3, 2.0));
        assert_eq!(record.orders("x", true, &verified(1e-3, 1.96)), (1, vec![]));
        let (count, lost) = record.orders("x", true, &verified(1e-3, 1.7));
        assert!(count == 1 && lost[0].contains("order 1.70, 2.00 on record"), "{lost:?}");
        assert_eq!(record.orders("x", true, &verified(1e-3, f64::NAN)).1.len(), 1);
        // A plain run is set beside a plain one alone.
        assert_eq!(record.orders("x", false, &verified(1e-3, 1.7)), (0, vec![]));
        record.take("x", false, &verified(1e-3, 1.8));
        assert_eq!(record.orders("x", false, &verified(1e-3, 1.77)), (1, vec![]));
        assert_eq!(record.orders("x", false, &verified(1e-3, 1.7)).1.len(), 1);
        record.take("z", false, &verified(1e-3, 2.0));
        assert_eq!(record.orders("z", true, &verified(1e-3, 0.0)), (0, vec![]));
        assert_eq!(record.orders("y", true, &verified(1e-3, 0.0)), (0, vec![]));
    }
}
