//! Samples: the values of varied keys, one set of them after the other.

use tremolite_case::Diagnostic;
use tremolite_case::study::{Distribution, Quantity, SampleKind, StudyFile, Variation, rounded};

use super::{Parameter, slug};
use crate::latin_hypercube::latin_hypercube;
use crate::matrix::Matrix;
use crate::{distribution, sobol, table};

/// Samples of a grid at most.
const MOST_SAMPLES: usize = 20_000;

/// One set of values.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// By which its runs are called; empty for the case as it is where nothing else is.
    pub name: String,
    /// As it was given, of rows that are written out; else as `name`.
    pub title: String,
    /// The value of each parameter as TOML; nothing where the case's stays.
    pub values: Vec<Option<String>>,
    /// The sample that it is to be set beside.
    pub beside: Option<usize>,
}

/// The parameters of a study and its samples.
///
/// # Errors
/// What is wrong, at its place in the study.
pub fn of(study: &StudyFile, text: Option<&str>) -> Result<(Vec<Parameter>, Vec<Sample>), Vec<Diagnostic>> {
    let (paths, samples) = match &study.sample {
        None if study.rows.is_empty() => {
            let as_it_is =
                Sample { name: String::new(), title: String::new(), values: Vec::new(), beside: None };
            (Vec::new(), vec![as_it_is])
        }
        None => rows(study),
        Some(sample) if sample.kind.value == SampleKind::Table => {
            let Some(file) = &sample.file else { return Ok((Vec::new(), Vec::new())) };
            let found = table::samples(text.unwrap_or_default()).map_err(|(message, remedy)| {
                let name = file.value.display();
                vec![Diagnostic::at(file, format!("{name}: {message}"), remedy)]
            });
            let (paths, rows) = found?;
            let width = rows.len().to_string().len();
            let sample = |(k, (name, values)): (usize, table::Row)| {
                let title = if name.is_empty() { format!("s{:0width$}", k + 1) } else { name };
                Sample { name: slug(&title), title, values, beside: None }
            };
            (paths, rows.into_iter().enumerate().map(sample).collect())
        }
        Some(_) => sampled(study)?,
    };
    let unit = |k: usize| {
        let values = || samples.iter().filter_map(|s| s.values.get(k)?.as_deref());
        let quantity = |value: &str| Quantity::parse(value.trim_matches('"'));
        let first = quantity(values().next()?)?.unit;
        let all =
            values().all(|v| quantity(v).is_some_and(|q| q.unit == first) && !v.starts_with(['[', '{']));
        all.then_some(first)
    };
    let parameters =
        paths.iter().enumerate().map(|(k, path)| Parameter { path: path.clone(), unit: unit(k) });
    Ok((parameters.collect(), samples))
}

/// Paths and samples of rows that are written out.
fn rows(study: &StudyFile) -> (Vec<String>, Vec<Sample>) {
    let mut paths: Vec<String> = Vec::new();
    for setting in study.rows.iter().flat_map(|row| &row.set) {
        if !paths.contains(&setting.path.value) {
            paths.push(setting.path.value.clone());
        }
    }
    let sample = |row: &tremolite_case::study::Row| {
        let value = |path: &String| row.set.iter().rfind(|s| s.path.value == *path).map(|s| s.value.clone());
        let beside = row.beside.as_ref();
        Sample {
            name: slug(&row.name.value),
            title: row.name.value.clone(),
            values: paths.iter().map(value).collect(),
            beside: beside.and_then(|name| study.rows.iter().position(|r| r.name.value == name.value)),
        }
    };
    (paths.clone(), study.rows.iter().map(sample).collect())
}

/// Paths and samples of what is varied.
fn sampled(study: &StudyFile) -> Result<(Vec<String>, Vec<Sample>), Vec<Diagnostic>> {
    let Some(sample) = &study.sample else { return Ok((Vec::new(), Vec::new())) };
    let paths: Vec<String> = study.vary.iter().map(|v| v.path.value.clone()).collect();
    let mut problems = Vec::new();
    for varied in &study.vary {
        if let Variation::Distributed(of) = &varied.how
            && distribution::is_empty(of)
        {
            let message = format!(
                "nearly nothing of the distribution of `{}` lies between its bounds",
                varied.path.value
            );
            let remedy = "widen `min` and `max`, or look at the units of the mean";
            problems.push(Diagnostic::new(varied.path.span.clone(), message, remedy));
        }
    }
    let values: Vec<Vec<String>> = study.vary.iter().map(|v| values_of(&v.how, &sample.quantiles)).collect();
    let size = values.iter().map(Vec::len).try_fold(1_usize, usize::checked_mul);
    let grid = sample.kind.value == SampleKind::Grid;
    if grid && size.is_none_or(|size| size > MOST_SAMPLES) {
        let message = "the grid has more samples than can be run";
        problems.push(Diagnostic::at(&sample.kind, message, "give fewer values, or take a latin-hypercube"));
    }
    if sample.kind.value == SampleKind::Sobol && paths.len() > sobol::MOST {
        let message = format!("a Sobol sequence is known here for {} keys", sobol::MOST);
        problems.push(Diagnostic::at(&sample.kind, message, "vary fewer keys, or take a latin-hypercube"));
    }
    if !problems.is_empty() {
        return Err(problems);
    }
    let samples = match sample.kind.value {
        SampleKind::OneAtATime => one_at_a_time(&paths, &values),
        SampleKind::Grid => numbered(crossed(&values)),
        SampleKind::Sobol => {
            numbered(drawn(study, &sobol::sobol(sample.count as usize, paths.len(), sample.seed)))
        }
        _ => {
            if let Some(asked) =
                study.correlations.first().filter(|_| sample.count as usize <= study.vary.len())
            {
                let message = "as few samples as keys cannot be given correlations";
                let remedy =
                    format!("write count = {} or more, or leave [[correlation]] out", study.vary.len() + 1);
                problems.push(Diagnostic::at(&asked.rank, message, remedy));
                return Err(problems);
            }
            let shares = latin_hypercube(sample.count as usize, sample.seed, &ranks(study)?);
            let shares = shares.map_err(|_| {
                let at = study.correlations.first().map_or(sample.kind.span.clone(), |c| c.rank.span.clone());
                let message = "no numbers can have these correlations: their matrix is not positive definite";
                vec![Diagnostic::new(
                    at,
                    message,
                    "weaken them: a and b near 1, b and c near 1 leave a and c near 1",
                )]
            })?;
            numbered(drawn(study, &shares))
        }
    };
    Ok((paths, samples))
}

/// The matrix of rank correlations between the varied keys.
fn ranks(study: &StudyFile) -> Result<Matrix, Vec<Diagnostic>> {
    let n = study.vary.len();
    let mut ranks: Matrix = (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    let mut problems = Vec::new();
    for correlation in &study.correlations {
        let place = |k: usize| study.vary.iter().position(|v| v.path.value == correlation.between[k].value);
        let (Some(i), Some(j)) = (place(0), place(1)) else { continue };
        let rank = correlation.rank.value;
        if i == j || !(-1.0 < rank && rank < 1.0) {
            let message = "a rank correlation lies between −1 and 1, and between two keys";
            problems.push(Diagnostic::at(&correlation.rank, message, "write rank = 0.3, say"));
            continue;
        }
        (ranks[i][j], ranks[j][i]) = (rank, rank);
    }
    if problems.is_empty() { Ok(ranks) } else { Err(problems) }
}

/// The values of a key in their order: those that are written, or those of a distribution at these shares.
fn values_of(how: &Variation, quantiles: &[f64]) -> Vec<String> {
    match how {
        Variation::Values(values) => values.clone(),
        Variation::Distributed(of) => quantiles.iter().map(|p| value(of, *p)).collect(),
    }
}

/// The value of a distribution at a share, as TOML.
fn value(of: &Distribution, share: f64) -> String {
    let share = share.clamp(1e-12, 1.0 - 1e-12);
    Quantity { number: distribution::value_at(of, share), unit: of.unit().to_owned() }.toml()
}

/// Values by shares, `shares[key][sample]`: of written values each has an equal part of the shares.
fn drawn(study: &StudyFile, shares: &[Vec<f64>]) -> Vec<Vec<String>> {
    let of = |key: usize, share: f64| match &study.vary[key].how {
        Variation::Values(values) => {
            values[((share * values.len() as f64) as usize).min(values.len() - 1)].clone()
        }
        Variation::Distributed(of) => value(of, share),
    };
    let count = shares.first().map_or(0, Vec::len);
    (0..count).map(|sample| (0..shares.len()).map(|key| of(key, shares[key][sample])).collect()).collect()
}

/// All combinations; the last key runs fastest.
fn crossed(values: &[Vec<String>]) -> Vec<Vec<String>> {
    values.iter().fold(vec![Vec::new()], |rows, values| {
        let with = |row: &Vec<String>| -> Vec<Vec<String>> {
            values.iter().map(|v| row.iter().cloned().chain([v.clone()]).collect()).collect()
        };
        rows.iter().flat_map(with).collect()
    })
}

fn numbered(rows: Vec<Vec<String>>) -> Vec<Sample> {
    let width = rows.len().to_string().len();
    let sample = |(k, values): (usize, Vec<String>)| {
        let name = format!("s{:0width$}", k + 1);
        Sample { title: name.clone(), name, values: values.into_iter().map(Some).collect(), beside: None }
    };
    rows.into_iter().enumerate().map(sample).collect()
}

fn one_at_a_time(paths: &[String], values: &[Vec<String>]) -> Vec<Sample> {
    let as_it_is = vec![None; paths.len()];
    let mut samples = vec![Sample {
        name: "as-it-is".into(),
        title: "as it is".into(),
        values: as_it_is.clone(),
        beside: None,
    }];
    for (k, path) in paths.iter().enumerate() {
        for value in &values[k] {
            let mut all = as_it_is.clone();
            all[k] = Some(value.clone());
            let shown = Quantity::parse(value.trim_matches('"')).map_or_else(
                || value.trim_matches('"').to_owned(),
                |q| format!("{} {}", rounded(q.number), q.unit).trim().to_owned(),
            );
            let title = format!("{path} = {shown}");
            samples.push(Sample {
                name: slug(&format!("{path}={shown}")),
                title,
                values: all,
                beside: Some(0),
            });
        }
    }
    samples
}
