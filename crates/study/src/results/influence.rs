//! What keys change of the results: tornados of studies that change one at a time, ranks of those that draw all at once.

use std::collections::BTreeMap;

use tremolite_case::study::{Quantity, SampleKind, StudyFile, rounded};
use tremolite_results::study::{Influence, Study, StudyRun, Tornado, TornadoBar};

use crate::matrix;

/// Results of samples that stand beside another, by the keys that differ; one a measure and sample that others stand beside.
pub fn tornados(study: &Study) -> Vec<Tornado> {
    // Of several records and levels the first is shown.
    let first = study.runs.first();
    let shown = |run: &&StudyRun| first.is_some_and(|f| f.record == run.record && f.level == run.level);
    let mut bases: Vec<usize> = study.runs.iter().filter_map(|run| run.beside).collect();
    bases.sort_unstable();
    bases.dedup();
    let several = bases.len() > 1;
    let of = |k: usize, base: usize| -> Option<Tornado> {
        let base = study.runs.iter().filter(shown).find(|run| run.sample == base)?;
        let at_base = base.measures[k]?;
        let mut bars: Vec<TornadoBar> = Vec::new();
        for run in study.runs.iter().filter(shown).filter(|run| run.beside == Some(base.sample)) {
            let Some(result) = run.measures[k] else { continue };
            let (name, value) = named(study, run);
            let there = (value, result);
            match bars.iter_mut().find(|bar| bar.name == name) {
                Some(bar) if result < bar.low.1 => bar.low = there,
                Some(bar) if result > bar.high.1 => bar.high = there,
                Some(_) => {}
                None => {
                    let here = ("as it is".to_owned(), at_base);
                    let (low, high) = if result < at_base { (there, here) } else { (here, there) };
                    bars.push(TornadoBar { name, low, high });
                }
            }
        }
        bars.sort_by(|a, b| (b.high.1 - b.low.1).total_cmp(&(a.high.1 - a.low.1)));
        let measure = study.measures[k].name.clone();
        let beside = if several { base.title.clone() } else { String::new() };
        (!bars.is_empty()).then_some(Tornado { measure, beside, base: at_base, bars })
    };
    (0..study.measures.len())
        .flat_map(|k| bases.iter().filter_map(|base| of(k, *base)).collect::<Vec<_>>())
        .collect()
}

/// The key that a run changes, and its value; the run's own title where it changes several.
fn named(study: &Study, run: &StudyRun) -> (String, String) {
    let mut changed = run.values.iter().enumerate().filter_map(|(k, value)| Some((k, value.as_deref()?)));
    match (changed.next(), changed.next()) {
        (Some((k, value)), None) => {
            let bare = value.trim_matches('"');
            let value = Quantity::parse(bare)
                .map_or(bare.to_owned(), |q| format!("{} {}", rounded(q.number), q.unit));
            (study.parameters[k].name.clone(), value.trim().to_owned())
        }
        _ => (run.title.clone(), String::new()),
    }
}

/// The record and the level of some runs.
type Group<'a> = (&'a Option<String>, &'a Option<String>);

/// Ranks of keys that are drawn at random against results, within each record and level: the mean over these, by their numbers of runs.
pub fn influences(file: &StudyFile, study: &Study) -> Vec<Influence> {
    let random = file.sample.as_ref().is_some_and(|sample| {
        matches!(sample.kind.value, SampleKind::LatinHypercube | SampleKind::Sobol | SampleKind::Table)
    });
    if !random {
        return Vec::new();
    }
    let mut found = Vec::new();
    for (p, parameter) in study.parameters.iter().enumerate() {
        // Numbers in unlike units have no order of their own.
        let quantity = |value: &String| Quantity::parse(value.trim_matches('"'));
        let mut units =
            study.runs.iter().filter_map(|run| run.values[p].as_ref().and_then(quantity)).map(|q| q.unit);
        let first = units.next();
        if units.any(|unit| Some(unit) != first) {
            continue;
        }
        for (m, measure) in study.measures.iter().enumerate() {
            let number = |value: &str| Some(Quantity::parse(value.trim_matches('"'))?.number);
            let mut groups: BTreeMap<Group<'_>, Vec<(f64, f64)>> = BTreeMap::new();
            for run in &study.runs {
                if let (Some(value), Some(result)) =
                    (run.values[p].as_deref().and_then(number), run.measures[m])
                {
                    groups.entry((&run.record, &run.level)).or_default().push((value, result));
                }
            }
            let of_group = |pairs: &Vec<(f64, f64)>| {
                let (values, results): (Vec<f64>, Vec<f64>) = pairs.iter().copied().unzip();
                let rank = matrix::spearman(&values, &results).filter(|_| pairs.len() > 2)?;
                Some((rank, pairs.len()))
            };
            let ranks: Vec<(f64, usize)> = groups.values().filter_map(of_group).collect();
            let runs: usize = ranks.iter().map(|(_, n)| n).sum();
            if runs > 0 {
                let rank = ranks.iter().map(|(rank, n)| rank * *n as f64).sum::<f64>() / runs as f64;
                let (parameter, measure) = (parameter.name.clone(), measure.name.clone());
                found.push(Influence { parameter, measure, rank, runs });
            }
        }
    }
    found
}
