//! The plan: all runs of a study with their values, a function of its file and seed.

mod samples;

use std::collections::BTreeSet;

use tremolite_case::Diagnostic;
use tremolite_case::study::{Design, Levels, Quantity, StudyFile, rounded};
use tremolite_case::{Spanned, units};
use tremolite_laws::parameter::Dimension;

use crate::intensity::{FORMS, Measure};

pub use samples::Sample;

/// Runs at most: more is a slip of digits.
const MOST_RUNS: usize = 20_000;

/// A key of the case that differs from run to run.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameter {
    /// The path of the key.
    pub path: String,
    /// The unit of all its values; nothing where they are no numbers, or in several units.
    pub unit: Option<String>,
}

/// A level of intensity.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// As it is written: "0.4 g".
    pub text: String,
    /// In SI.
    pub value: f64,
}

/// A run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Run {
    /// By which its folder is called: letters, digits, `.`, `_`, `=` and `-`.
    pub name: String,
    /// Its number in [`Plan::samples`].
    pub sample: usize,
    /// Its number among the study's records; nothing for that of the case.
    pub record: Option<usize>,
    /// Its number in [`Plan::levels`]; nothing for a motion as it is.
    pub level: Option<usize>,
    /// Runs of one sample and record have one number.
    pub chain: usize,
}

/// All runs of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    pub parameters: Vec<Parameter>,
    pub samples: Vec<Sample>,
    /// Rising; empty where motions are taken as they are.
    pub levels: Vec<Level>,
    /// What levels are of.
    pub scaled_by: Option<Measure>,
    /// Every measure of intensity that the study tells, that of the levels first.
    pub intensities: Vec<Measure>,
    /// Whether the levels of a chain end where a limit is exceeded.
    pub rises: bool,
    pub runs: Vec<Run>,
}

impl Plan {
    /// The plan of a study; `table` is the text of the file that its samples stand in.
    ///
    /// # Errors
    /// All that is wrong, each at its place in the study.
    pub fn of(study: &StudyFile, table: Option<&str>) -> Result<Plan, Vec<Diagnostic>> {
        let mut problems = Vec::new();
        let (parameters, samples) = match samples::of(study, table) {
            Ok(found) => found,
            Err(found) => {
                problems.extend(found);
                (Vec::new(), Vec::new())
            }
        };
        let mut measure = |text: &Spanned<String>| {
            Measure::parse(&text.value)
                .map_err(|why| problems.push(Diagnostic::at(text, why, format!("write {FORMS}"))))
                .ok()
        };
        let scaled_by = study.scale.as_ref().and_then(|scale| measure(&scale.measure));
        let mut intensities: Vec<Measure> = scaled_by.into_iter().collect();
        intensities.extend(study.fragilities.iter().filter_map(|f| measure(f.by.as_ref()?)));
        intensities.extend(["PGA", "PGV"].into_iter().filter_map(|usual| Measure::parse(usual).ok()));
        let mut told: Vec<Measure> = Vec::new();
        intensities.retain(|m| {
            !told.contains(m) && {
                told.push(*m);
                true
            }
        });
        let levels = match (&study.scale, scaled_by) {
            (Some(scale), Some(measure)) => levels(&scale.levels, measure, &mut problems),
            _ => Vec::new(),
        };
        if !problems.is_empty() {
            return Err(problems);
        }
        let rises = matches!(study.scale.as_ref().map(|s| &s.levels), Some(Levels::Ida(_)));
        let plan = Plan { parameters, samples, levels, scaled_by, intensities, rises, runs: Vec::new() };
        let runs = plan.cross(study);
        if runs.len() > MOST_RUNS {
            let message = format!("the study has {} runs", runs.len());
            let remedy = format!("take fewer values, samples, records or levels: {MOST_RUNS} runs at most");
            return Err(vec![Diagnostic::at(&study.title, message, remedy)]);
        }
        let mut names = BTreeSet::new();
        if let Some(twice) = runs.iter().find(|run| !names.insert(&run.name)) {
            let message = format!("two runs would be called {}", twice.name);
            let remedy = "give rows, records and levels names that differ in letters and digits";
            return Err(vec![Diagnostic::at(&study.title, message, remedy)]);
        }
        Ok(Plan { runs, ..plan })
    }

    /// Samples, records and levels together.
    fn cross(&self, study: &StudyFile) -> Vec<Run> {
        let records: Vec<Option<usize>> = match study.records.len() {
            0 => vec![None],
            many => (0..many).map(Some).collect(),
        };
        let levels: Vec<Option<usize>> = match self.levels.len() {
            0 => vec![None],
            many => (0..many).map(Some).collect(),
        };
        let paired = study.scale.as_ref().is_some_and(|scale| scale.design == Design::Paired);
        let mut runs = Vec::new();
        let mut chain = 0;
        for (sample, Sample { name, .. }) in self.samples.iter().enumerate() {
            for (k, record) in records.iter().enumerate() {
                if paired && k != sample % records.len() {
                    continue;
                }
                for level in &levels {
                    let record_name = record.map(|r| slug(&study.records[r].name.value));
                    let level_name = level.map(|l| slug(&self.levels[l].text));
                    let sample_name = Some(name.clone()).filter(|name| !name.is_empty());
                    let parts: Vec<String> =
                        [sample_name, record_name, level_name].into_iter().flatten().collect();
                    let name = if parts.is_empty() { "case".to_owned() } else { parts.join("_") };
                    runs.push(Run { name, sample, record: *record, level: *level, chain });
                    if runs.len() > MOST_RUNS {
                        return runs;
                    }
                }
                chain += 1;
            }
        }
        runs
    }

    /// The runs of a share of K of N, in their order: chains are dealt out one by one, so that a chain stays together.
    pub fn shard(&self, k: usize, of: usize) -> Vec<usize> {
        (0..self.runs.len()).filter(|run| self.runs[*run].chain % of == k).collect()
    }

    /// The unit that a measure of intensity is told in, and its SI value: the one in which the levels are written, where it fits.
    pub fn told_in(&self, measure: &Measure) -> (String, f64) {
        let of_levels = || {
            let dimension = self.scaled_by.map(|by| by.dimension()).filter(|d| *d == measure.dimension())?;
            let unit = Quantity::parse(&self.levels.first()?.text)?.unit;
            let value = units::parse(&format!("1 {unit}"), dimension).ok()?;
            (!unit.is_empty() && dimension != Dimension::NONE).then_some((unit, value))
        };
        let (usual, value) = measure.unit();
        of_levels().unwrap_or((usual.to_owned(), value))
    }

    /// The number of chains.
    pub fn chains(&self) -> usize {
        self.runs.last().map_or(0, |run| run.chain + 1)
    }
}

fn levels(written: &Levels, measure: Measure, problems: &mut Vec<Diagnostic>) -> Vec<Level> {
    let dimension = measure.dimension();
    let mut read = |text: &Spanned<String>| match units::parse(&text.value, dimension) {
        Ok(value) if value > 0.0 => Some(Level { text: text.value.trim().to_owned(), value }),
        Ok(_) => {
            problems.push(Diagnostic::at(
                text,
                "a level must be above 0",
                "give a value above 0, such as \"0.2 g\"",
            ));
            None
        }
        Err(e) => {
            problems.push(Diagnostic::at(
                text,
                format!("a level of {measure} {}", e.message("level")),
                e.remedy("level"),
            ));
            None
        }
    };
    match written {
        Levels::Stripes(texts) => {
            let mut found: Vec<Level> = texts.iter().filter_map(read).collect();
            found.sort_by(|a, b| a.value.total_cmp(&b.value));
            if let Some(pair) = found.windows(2).find(|pair| pair[0].value == pair[1].value) {
                let at = texts.iter().rfind(|t| t.value.trim() == pair[1].text);
                problems
                    .extend(at.map(|at| Diagnostic::at(at, "two levels are equal", "keep one of the two")));
            }
            found
        }
        Levels::Ida(ida) => {
            let (Some(first), Some(step)) = (read(&ida.first), read(&ida.step)) else { return Vec::new() };
            let (Some(from), Some(by)) = (Quantity::parse(&first.text), Quantity::parse(&step.text)) else {
                return Vec::new();
            };
            if from.unit != by.unit {
                let message = format!("`first` is in {}, `step` in {}", from.unit, by.unit);
                problems.push(Diagnostic::at(&ida.step, message, "write both in one unit"));
                return Vec::new();
            }
            let level = |k: u32| {
                let text = format!("{} {}", rounded(from.number + f64::from(k) * by.number), from.unit);
                let value = units::parse(&text, dimension).unwrap_or(f64::NAN);
                Level { text, value }
            };
            (0..ida.most).map(level).collect()
        }
    }
}

/// A text as the name of a folder on any system.
pub fn slug(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        let spelt = match c {
            'α' => "alpha",
            'β' => "beta",
            'μ' | 'µ' => "mu",
            '%' => "percent",
            c if c.is_ascii_alphanumeric() || "._=".contains(c) || c.is_alphabetic() => {
                out.extend(c.to_lowercase());
                continue;
            }
            _ => {
                if !out.is_empty() && !out.ends_with('-') {
                    out.push('-');
                }
                continue;
            }
        };
        if out.ends_with(|c: char| c.is_alphanumeric()) {
            out.push('-');
        }
        out += spelt;
    }
    let out = out.trim_matches(['-', '.']);
    match out.char_indices().nth(LONGEST) {
        None => out.to_owned(),
        // Told apart by the whole text (FNV-1a).
        Some((end, _)) => {
            let hash = text
                .bytes()
                .fold(0x811c_9dc5_u32, |hash, byte| (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193));
            format!("{}-{hash:08x}", &out[..end])
        }
    }
}

/// Characters of a folder's name at most: file systems allow 255 bytes, and letters may take four.
const LONGEST: usize = 50;

#[cfg(test)]
mod tests;
