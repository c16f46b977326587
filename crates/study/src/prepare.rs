//! The case of each run: the study's case with other values at some keys, another record, and a factor.

use std::ops::Range;
use std::path::{Component, Path, PathBuf};

use tremolite_case::study::{RecordEntry, StudyFile};
use tremolite_case::{Case, Change, Diagnostic, Direction, Laws, Records, Report};
use tremolite_motion::TargetSpectrum;

use crate::Plan;

/// Keys of `[motion]` that say where the record comes from.
const SOURCE: [&str; 5] = ["file", "east", "north", "up", "sensitivity"];

/// The study's case, with the keys that are set for all runs.
///
/// # Errors
/// All problems of the case, in its file, or else of what the study sets, in the study's.
pub fn base(study: &StudyFile, laws: Laws<'_>) -> Result<Case, Report> {
    let path = study.directory().join(&study.case.value);
    if !path.is_file() {
        let message = format!("there is no file {}", study.case.value.display());
        let remedy = format!("paths start from the folder of the study; looked for {}", path.display());
        return Err(study.report(vec![Diagnostic::at(&study.case, message, remedy)]));
    }
    let written =
        Case::parse_in(&path, path.parent().unwrap_or(Path::new("")), &Case::text_of(&path)?, &[], laws)?;
    // Records in place of the case's own: those need not be there.
    let own = written.motion.as_ref().filter(|_| !study.records.is_empty());
    let replaced: Vec<PathBuf> = own.into_iter().flat_map(|m| m.files()).map(|f| f.value.clone()).collect();
    let missing = written.missing_files(|file| replaced.iter().any(|own| own == file));
    if !missing.is_empty() {
        return Err(written.report(missing));
    }
    let set: Vec<Placed> =
        study.set.iter().map(|s| placed(&s.path.value, &s.value, s.path.span.clone())).collect();
    changed(study, &written, &set, laws)
}

/// The spectrum that the study names; nothing where it leaves that to the case.
///
/// # Errors
/// What is no spectrum, at its place in the study.
pub fn target(study: &StudyFile) -> Result<Option<TargetSpectrum>, Report> {
    let Some(named) = study.scale.as_ref().and_then(|scale| scale.target.as_ref()) else { return Ok(None) };
    let file = study.directory().join(&named.value);
    let read = if file.is_file() { TargetSpectrum::read(&file) } else { TargetSpectrum::parse(&named.value) };
    read.map(Some).map_err(|e| {
        let (message, remedy) = e.message_and_remedy();
        study.report(vec![Diagnostic::at(named, message, remedy)])
    })
}

/// The case of a sample.
///
/// # Errors
/// All problems of its values, at their places in the study.
pub fn sample(
    study: &StudyFile,
    plan: &Plan,
    base: &Case,
    sample: usize,
    laws: Laws<'_>,
) -> Result<Case, Report> {
    let row = study.rows.get(sample);
    let place = |path: &str| -> Range<usize> {
        let of_row =
            row.and_then(|row| row.set.iter().find(|s| s.path.value == path)).map(|s| s.path.span.clone());
        let varied = || study.vary.iter().find(|v| v.path.value == path).map(|v| v.path.span.clone());
        let file = || study.sample.as_ref().and_then(|s| s.file.as_ref()).map(|f| f.span.clone());
        of_row.or_else(varied).or_else(file).unwrap_or(0..0)
    };
    let values = &plan.samples[sample].values;
    let changes: Vec<Placed> = plan
        .parameters
        .iter()
        .zip(values)
        .filter_map(|(parameter, value)| {
            Some(placed(&parameter.path, value.as_ref()?, place(&parameter.path)))
        })
        .collect();
    changed(study, base, &changes, laws)
}

/// A case with another record, and all of its motion times a factor.
///
/// # Errors
/// All problems of the record, at its place in the study.
pub fn with_motion(
    study: &StudyFile,
    case: &Case,
    record: Option<usize>,
    factor: Option<f64>,
    laws: Laws<'_>,
) -> Result<Case, Report> {
    let record = record.map(|record| &study.records[record]);
    let at = match (record, &study.scale) {
        (Some(record), _) => record.name.span.clone(),
        (None, Some(scale)) => scale.measure.span.clone(),
        (None, None) => return Ok(case.clone()),
    };
    if record.is_none() && factor.is_none() {
        return Ok(case.clone());
    }
    let mut motion = case.entries("motion");
    if motion.is_empty() {
        let message = "the case has no [motion], so there is nothing to shake it with";
        let remedy = "add [motion] to the case: its kind, processing and window are those of all records";
        return Err(study.report(vec![Diagnostic::new(at, message, remedy)]));
    }
    if let Some(record) = record {
        let folder = between(case.directory(), study.directory());
        let own =
            record.motion(|file| if file.is_absolute() { file.to_owned() } else { joined(&folder, file) });
        let made = made_of_the_record(case, record, &own).map_err(|problem| study.report(vec![problem]))?;
        motion.retain(|(key, _)| !SOURCE.contains(&key.as_str()) || made.contains(&key.as_str()));
        for (key, value) in own {
            motion.retain(|(other, _)| *other != key);
            motion.push((key, value));
        }
    }
    if let Some(factor) = factor {
        let scale = format!("\"scale {}\"", told(factor));
        let before = motion.iter().position(|(key, _)| key == "processing").map(|k| motion.remove(k).1);
        let steps =
            before.as_deref().and_then(|list| list.strip_prefix('[')?.strip_suffix(']')).unwrap_or_default();
        let steps = if steps.trim().is_empty() { scale } else { format!("{steps}, {scale}") };
        motion.push(("processing".to_owned(), format!("[{steps}]")));
    }
    motion.sort();
    let entries: Vec<String> = motion.iter().map(|(key, value)| format!("{key} = {value}")).collect();
    let change = placed("motion", &format!("{{ {} }}", entries.join(", ")), at);
    let case = changed(study, case, &[change], laws)?;
    let missing = case.missing_files(|_| false);
    if let (Some(first), Some(record)) = (missing.first(), record) {
        return Err(study.report(vec![Diagnostic::at(
            &record.name,
            first.message.clone(),
            first.remedy.clone(),
        )]));
    }
    Ok(case)
}

/// The components of a case by their names; none of a case that reads one file with all of them.
fn components(case: &Case) -> Vec<(&'static str, &tremolite_case::Component)> {
    match case.motion.as_ref().map(|motion| &motion.records) {
        Some(Records::Components(components)) => Direction::WORDS
            .iter()
            .copied()
            .zip(components.iter())
            .filter_map(|(w, c)| Some((w, c.as_ref()?)))
            .collect(),
        _ => Vec::new(),
    }
}

/// Components that the case makes of another one, which the record brings: they are made of the record's.
///
/// # Errors
/// A component whose source the record does not bring.
fn made_of_the_record(
    case: &Case,
    record: &RecordEntry,
    own: &[(String, String)],
) -> Result<Vec<&'static str>, Diagnostic> {
    let brings = |name: &str| own.iter().any(|(key, _)| key == name);
    let mut made = Vec::new();
    // One file brings all components.
    if brings("file") {
        return Ok(made);
    }
    for (name, component) in components(case) {
        let tremolite_case::Component::Scaled { from, .. } = component else { continue };
        let source = from.value.word();
        match (brings(name), brings(source)) {
            (true, _) => {}
            (false, true) => made.push(name),
            (false, false) => {
                return Err(Diagnostic::at(
                    &record.name,
                    format!(
                        "record '{}': the case makes `{name}` of `{source}`, which is not given",
                        record.name.value
                    ),
                    format!("give `{source}` or `{name}` in the record"),
                ));
            }
        }
    }
    Ok(made)
}

/// Values of the study at keys of the case's own record, which each record of the study replaces: they would have no effect.
pub fn replaced(study: &StudyFile, case: &Case) -> Vec<Diagnostic> {
    if study.records.is_empty() {
        return Vec::new();
    }
    let made = components(case).into_iter().filter(|(_, c)| c.record().is_none()).map(|(name, _)| name);
    let made: Vec<&str> = made.collect();
    let of_rows = study.rows.iter().flat_map(|row| row.set.iter().map(|s| &s.path));
    let paths = study.set.iter().map(|s| &s.path).chain(study.vary.iter().map(|v| &v.path)).chain(of_rows);
    let is_replaced = |path: &&tremolite_case::Spanned<String>| {
        let key = path.value.strip_prefix("motion.").and_then(|below| below.split(['.', '[']).next());
        key.is_some_and(|key| SOURCE.contains(&key) && !made.contains(&key))
    };
    let problem = |path: &tremolite_case::Spanned<String>| {
        Diagnostic::at(
            path,
            format!("`{}`: no effect, since each [[record]] brings its own", path.value),
            "give it in the records, or leave them out",
        )
    };
    paths.filter(is_replaced).map(problem).collect()
}

/// What of the case's components the runs of a record do without, to be warned of: recorded ones that it has no other for.
pub fn left_out(study: &StudyFile, case: &Case, record: usize) -> Option<Diagnostic> {
    let record = &study.records[record];
    let own = record.motion(Path::to_owned);
    let brings = |name: &str| own.iter().any(|(key, _)| key == name || key == "file");
    let lacks = components(case).into_iter().filter(|(name, c)| c.record().is_some() && !brings(name));
    let names: Vec<String> = lacks.map(|(name, _)| format!("`{name}`")).collect();
    (!names.is_empty()).then(|| {
        Diagnostic::at(
            &record.name,
            format!(
                "record '{}': it has no {}, which the case has of another record; its runs shake without",
                record.name.value,
                names.join(" and no ")
            ),
            "give them in the record, if they are meant",
        )
    })
}

/// The refusal of a record of one file without a vertical component, where the case makes one of another; `vertical` says whether
/// the motion of the record has one.
///
/// # Errors
/// That the component would be lost.
pub fn vertical_of_file(
    study: &StudyFile,
    case: &Case,
    record: usize,
    vertical: bool,
) -> Result<(), Diagnostic> {
    let record = &study.records[record];
    let is_file = record.motion(Path::to_owned).iter().any(|(key, _)| key == "file");
    let made =
        components(case).into_iter().find(|(name, c)| *name == Direction::Up.word() && c.record().is_none());
    let (Some(_), true, false) = (made, is_file, vertical) else { return Ok(()) };
    Err(Diagnostic::at(
        &record.name,
        format!(
            "record '{}': its file has no vertical component, and the case makes `up` of another",
            record.name.value
        ),
        "give the components by name, with `up`: east = { file = \"…\", channel = \"…\" }, up = { from = \"east\", factor = 0.667 }",
    ))
}

/// A factor to ten digits, as it stands in the case; what is measured goes by the same.
pub fn told(factor: f64) -> String {
    let rounded: f64 = format!("{factor:.9e}").parse().unwrap_or(factor);
    rounded.to_string()
}

/// A change and where the study asks for it.
struct Placed {
    change: Change,
    at: Range<usize>,
}

/// Characters of a value that a message shows.
const SHOWN: usize = 60;

fn placed(path: &str, value: &str, at: Range<usize>) -> Placed {
    let value_shown: String = value.chars().take(SHOWN).collect();
    let given = format!("{path} = {value_shown}").split_whitespace().collect::<Vec<_>>().join(" ");
    Placed { change: Change { given, ..Change::new(path, value) }, at }
}

/// A case with changes; problems of these are shown in the study.
fn changed(study: &StudyFile, case: &Case, changes: &[Placed], laws: Laws<'_>) -> Result<Case, Report> {
    if changes.is_empty() {
        return Ok(case.clone());
    }
    let only: Vec<Change> = changes.iter().map(|c| c.change.clone()).collect();
    case.parse_with(&only, laws).map_err(|report| {
        let place = |p: &Diagnostic| {
            let set = p.set.as_deref()?;
            changes.iter().find(|c| set.starts_with(&c.change.given)).map(|c| (set.to_owned(), c.at.clone()))
        };
        let problems = report.problems.iter().map(|p| match place(p) {
            Some((set, at)) => Diagnostic::new(at, format!("{}, of `{set}`", p.message), p.remedy.clone()),
            // What the file says can be wrong because of a change elsewhere: the first without which it is not.
            None => {
                let wrong_without = |k: usize| {
                    let mut others = only.clone();
                    others.remove(k);
                    let left = case.parse_with(&others, laws).err();
                    left.is_some_and(|left| left.problems.iter().any(|other| other.message == p.message))
                };
                let change =
                    (0..changes.len()).find(|&k| !wrong_without(k)).map_or(&changes[0], |k| &changes[k]);
                let (line, given) = (report.position(p).0, &change.change.given);
                let message =
                    format!("{}, in line {line} of {}, with `{given}`", p.message, report.file.display());
                Diagnostic::new(change.at.clone(), message, p.remedy.clone())
            }
        });
        study.report(problems.collect())
    })
}

/// A file below a folder, without going down where the file's way goes up again.
fn joined(folder: &Path, file: &Path) -> PathBuf {
    let mut way: Vec<Component<'_>> = folder.components().collect();
    for part in file.components() {
        match (part, way.last()) {
            (Component::CurDir, _) => {}
            (Component::ParentDir, Some(Component::Normal(_))) => {
                way.pop();
            }
            _ => way.push(part),
        }
    }
    way.into_iter().collect()
}

/// The way from one folder to another, as short as it is where both are there.
fn between(from: &Path, to: &Path) -> PathBuf {
    let whole = |path: &Path| {
        let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
        path.canonicalize().or_else(|_| std::path::absolute(path)).unwrap_or_else(|_| path.to_owned())
    };
    let (from, to) = (whole(from), whole(to));
    let (from, to): (Vec<Component<'_>>, Vec<Component<'_>>) =
        (from.components().collect(), to.components().collect());
    let shared = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    if shared == 0 {
        return to.iter().collect();
    }
    let up = from[shared..].iter().map(|_| Component::ParentDir);
    up.chain(to[shared..].iter().copied()).collect()
}

#[cfg(test)]
mod tests;
