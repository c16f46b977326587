//! The cases of all runs, checked before the first of them is run.

use crate::commands::infos;
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;
use tremolite::setup::{motion_of, target_of};
use tremolite_case::study::StudyFile;
use tremolite_case::{Case, Diagnostic, Language, Laws, Report};
use tremolite_motion::TargetSpectrum;
use tremolite_results::checksums::hash;
use tremolite_study::plan::Plan;
use tremolite_study::results::Prepared;
use tremolite_study::{measure_paths, prepare};

/// Tables of a case that change nothing before the earthquake.
const OF_SHAKING: [&str; 3] = ["motion", "title", "report"];

/// A run whose case is checked.
pub struct Planned {
    pub prepared: Prepared,
    /// The text of its case, with files by absolute paths.
    pub case: String,
    /// Runs with one number are equal before the earthquake; nothing where nothing happens before it.
    pub before: Option<usize>,
}

/// What was made of a plan.
pub struct Found {
    pub planned: Vec<Planned>,
    /// In which the case's pages are.
    pub language: Language,
    /// What is to be warned of in the motions, at the records in the study.
    pub warnings: Vec<Diagnostic>,
}

/// All runs of a plan.
///
/// # Errors
/// Everything that one of their cases is refused for, at its place in the study.
pub fn of(study: &StudyFile, plan: &Plan) -> Result<Found, Report> {
    let materials = infos();
    let laws = Laws::from(&materials);
    let base = prepare::base(study, laws)?;
    let target = prepare::target(study)?;
    let mut maker = Maker {
        study,
        plan,
        laws,
        target,
        problems: [measure_paths::check(study, &base), prepare::replaced(study, &base)].concat(),
        warnings: Vec::new(),
        motions: BTreeMap::new(),
        befores: BTreeMap::new(),
        hashes: BTreeMap::new(),
    };
    let mut planned = Vec::new();
    let mut sample: Option<(usize, Option<Case>)> = None;
    let mut chain: Option<(usize, Option<Chain>)> = None;
    for (number, run) in plan.runs.iter().enumerate() {
        if sample.as_ref().is_none_or(|(of, _)| *of != run.sample) {
            let case = prepare::sample(study, plan, &base, run.sample, laws);
            sample = Some((run.sample, maker.kept(case)));
        }
        let Some((_, Some(of_sample))) = &sample else { continue };
        if chain.as_ref().is_none_or(|(of, _)| *of != run.chain) {
            chain = Some((run.chain, maker.chain(of_sample, run.record)));
        }
        let Some((_, Some(of_chain))) = &chain else { continue };
        let highest = plan.runs.get(number + 1).is_none_or(|next| next.chain != run.chain);
        planned.extend(maker.run(of_chain, of_sample, run, highest));
    }
    let once = |problems: &mut Vec<Diagnostic>| {
        let mut told = BTreeSet::new();
        problems.retain(|p| told.insert((p.span.start, p.message.clone())));
    };
    once(&mut maker.problems);
    once(&mut maker.warnings);
    if maker.problems.is_empty() {
        return Ok(Found { planned, language: base.page.language, warnings: maker.warnings });
    }
    Err(study.report(maker.problems))
}

/// A case with its record at its own strength, and each measure of intensity of it.
struct Chain {
    case: Case,
    intensities: Vec<Option<f64>>,
}

struct Maker<'a> {
    study: &'a StudyFile,
    plan: &'a Plan,
    laws: Laws<'a>,
    /// The spectrum that the study names.
    target: Option<TargetSpectrum>,
    problems: Vec<Diagnostic>,
    warnings: Vec<Diagnostic>,
    /// Measures of intensity by what the motion is made of.
    motions: BTreeMap<String, Vec<Option<f64>>>,
    befores: BTreeMap<String, usize>,
    /// Hashes of files that cases read.
    hashes: BTreeMap<PathBuf, String>,
}

impl Maker<'_> {
    /// What was made, or nothing and its problems.
    fn kept<T>(&mut self, made: Result<T, Report>) -> Option<T> {
        made.map_err(|report| self.problems.extend(report.problems)).ok()
    }

    fn chain(&mut self, of_sample: &Case, record: Option<usize>) -> Option<Chain> {
        let case = prepare::with_motion(self.study, of_sample, record, None, self.laws);
        let case = self.kept(case)?;
        self.warnings.extend(record.and_then(|record| prepare::left_out(self.study, of_sample, record)));
        let key = format!("{:?} {:?}", case.directory(), case.entries("motion"));
        let intensities = match self.motions.get(&key) {
            Some(known) => known.clone(),
            None => {
                let found = self.intensities(&case, of_sample, record)?;
                self.motions.insert(key, found.clone());
                found
            }
        };
        Some(Chain { case, intensities })
    }

    /// The measures of the motion of a case; problems of it are told at its record.
    fn intensities(
        &mut self,
        case: &Case,
        of_sample: &Case,
        record: Option<usize>,
    ) -> Option<Vec<Option<f64>>> {
        let motion = match motion_of(case) {
            Ok(None) => return Some(vec![None; self.plan.intensities.len()]),
            Ok(Some((motion, facts))) => {
                // Sizes are those of the levels, where there are some.
                if self.plan.scaled_by.is_none() {
                    self.warn(record, &facts.warnings);
                }
                motion
            }
            Err(report) => {
                let at = self.place(record);
                self.problems.extend(
                    report.problems.into_iter().map(|p| Diagnostic::new(at.clone(), p.message, p.remedy)),
                );
                return None;
            }
        };
        if let Some(record) = record {
            let vertical = motion.acceleration[2].iter().any(|a| *a != 0.0);
            if let Err(problem) = prepare::vertical_of_file(self.study, of_sample, record, vertical) {
                self.problems.push(problem);
                return None;
            }
        }
        let target = match self.target.clone() {
            Some(target) => Some(target),
            None => match target_of(case) {
                Ok(target) => target,
                Err(problem) => {
                    let message = format!("[motion.target] of the case: {}", problem.message);
                    self.problems.push(Diagnostic::new(self.place(record), message, problem.remedy));
                    return None;
                }
            },
        };
        let mut found = Vec::new();
        for measure in &self.plan.intensities {
            match measure.of(&motion, target.as_ref()) {
                Ok(x) => found.push(Some(x)),
                Err(e) => {
                    let (message, remedy) = e.message_and_remedy();
                    let message = format!("{measure}: {message}");
                    self.problems.push(Diagnostic::new(self.place(record), message, remedy));
                    return None;
                }
            }
        }
        Some(found)
    }

    /// Keeps what a motion is warned of, at its record.
    fn warn(&mut self, record: Option<usize>, warnings: &[Diagnostic]) {
        let at = self.place(record);
        let name = record.map(|record| format!("record '{}': ", self.study.records[record].name.value));
        let name = name.unwrap_or_default();
        let placed =
            |p: &Diagnostic| Diagnostic::new(at.clone(), format!("{name}{}", p.message), p.remedy.clone());
        self.warnings.extend(warnings.iter().map(placed));
    }

    /// By what a run is known again: its case on one line, and the contents of the files that it reads.
    fn known_by(&mut self, case: &Case) -> String {
        let mut known = case.bare(&[]);
        for file in case.files() {
            let path = case.resolve(&file.value);
            // One that cannot be read is refused where the run reads it.
            let hash = self.hashes.entry(path).or_insert_with_key(|path| hash(path).unwrap_or_default());
            known += &format!(" # {hash}");
        }
        known
    }

    /// Where a record stands in the study.
    fn place(&self, record: Option<usize>) -> std::ops::Range<usize> {
        match (record, &self.study.scale) {
            (Some(record), _) => self.study.records[record].name.span.clone(),
            (None, Some(scale)) => scale.measure.span.clone(),
            (None, None) => self.study.case.span.clone(),
        }
    }

    fn run(
        &mut self,
        chain: &Chain,
        of_sample: &Case,
        run: &tremolite_study::plan::Run,
        highest: bool,
    ) -> Option<Planned> {
        let factor = match (run.level, self.plan.scaled_by) {
            (Some(level), Some(measure)) => {
                let now = chain.intensities.first().copied().flatten().filter(|now| *now > 0.0);
                let Some(now) = now else {
                    let message = format!("{measure} of this motion is 0, so no factor brings it to a level");
                    let remedy =
                        "scale by a measure of a component that shakes, such as \"z PGA\", or give [motion]";
                    self.problems.push(Diagnostic::new(self.place(run.record), message, remedy));
                    return None;
                };
                let factor = measure.factor(now, self.plan.levels[level].value);
                prepare::told(factor).parse::<f64>().ok()
            }
            _ => None,
        };
        let case = match factor {
            Some(_) => {
                let case = prepare::with_motion(self.study, of_sample, run.record, factor, self.laws);
                self.kept(case)?
            }
            None => chain.case.clone(),
        };
        // The highest level is the first that is more than any earthquake.
        let of_highest = (factor.is_some() && highest).then(|| motion_of(&case));
        if let Some(Ok(Some((_, facts)))) = &of_highest {
            self.warn(run.record, &facts.warnings);
        }
        if let Some(Err(report)) = of_highest {
            let at = self.study.scale.as_ref().map_or(0..0, |scale| scale.measure.span.clone());
            let told =
                |p: Diagnostic| Diagnostic::new(at.clone(), format!("{}: {}", run.name, p.message), p.remedy);
            self.problems.extend(report.problems.into_iter().map(told));
            return None;
        }
        let scaled = chain.intensities.iter().zip(&self.plan.intensities);
        let mut intensities: Vec<Option<f64>> =
            scaled.map(|(x, m)| x.map(|x| factor.map_or(x, |f| m.scaled(x, f)))).collect();
        // The level itself, which the factor meets to its ten digits.
        if let (Some(level), Some(of_level)) = (run.level, intensities.first_mut()) {
            *of_level = Some(self.plan.levels[level].value);
        }
        let before = case.seeks_equilibrium().then(|| {
            let next = self.befores.len();
            *self.befores.entry(case.bare(&OF_SHAKING)).or_insert(next)
        });
        let prepared = Prepared { bare: self.known_by(&case), factor, intensities };
        Some(Planned { prepared, case: case.placed(), before })
    }
}
