//! What lies between the tables of a study file.

use super::{Levels, MeasureOf, Sample, SampleKind, StudyFile, Variation};
use crate::Diagnostic;
use std::path::{Component, Path};

impl StudyFile {
    /// What lies between keys.
    pub(super) fn check(&self) -> Vec<Diagnostic> {
        let mut problems = Vec::new();
        if self.vary.is_empty()
            && let Some(sample) = &self.sample
            && sample.kind.value != SampleKind::Table
        {
            let message = "[sample] has nothing to sample: no key is varied";
            problems.push(Diagnostic::at(
                &sample.kind,
                message,
                "add [vary] with the paths of keys, or take [sample] out",
            ));
        }
        if let (Some(first), None) = (self.vary.first(), &self.sample) {
            let remedy =
                "add [sample] with kind = \"one-at-a-time\", \"grid\", \"latin-hypercube\" or \"sobol\"";
            problems.push(Diagnostic::new(
                first.path.span.clone(),
                "keys are varied, but [sample] does not say how",
                remedy,
            ));
        }
        if let (Some(row), Some(_)) = (self.rows.first(), &self.sample) {
            let message = "rows that are written out cannot stand beside [sample]";
            problems.push(Diagnostic::at(
                &row.name,
                message,
                "keep one of the two; two studies may have one case",
            ));
        }
        if let Some(sample) = &self.sample {
            self.check_sample(sample, &mut problems);
        }
        for (k, row) in self.rows.iter().enumerate() {
            if self.rows[..k].iter().any(|other| other.name.value == row.name.value) {
                problems.push(Diagnostic::at(
                    &row.name,
                    "two rows have this name",
                    "give each row a name of its own",
                ));
            }
            if let Some(beside) = &row.beside
                && !self.rows.iter().any(|other| other.name.value == beside.value)
            {
                let remedy = nearest_of(&beside.value, self.rows.iter().map(|r| r.name.value.as_str()));
                problems.push(Diagnostic::at(
                    beside,
                    format!("there is no row \"{}\"", beside.value),
                    remedy,
                ));
            }
        }
        for (k, record) in self.records.iter().enumerate() {
            if self.records[..k].iter().any(|other| other.name.value == record.name.value) {
                problems.push(Diagnostic::at(
                    &record.name,
                    "two records have this name",
                    "give each a name of its own",
                ));
            }
        }
        for correlation in &self.correlations {
            for path in &correlation.between {
                if !self.vary.iter().any(|v| v.path.value == path.value) {
                    let remedy = nearest_of(&path.value, self.vary.iter().map(|v| v.path.value.as_str()));
                    problems.push(Diagnostic::at(path, format!("`{}` is not varied", path.value), remedy));
                }
            }
        }
        self.check_measures(&mut problems);
        problems
    }

    fn check_sample(&self, sample: &Sample, problems: &mut Vec<Diagnostic>) {
        let kind = sample.kind.value;
        let counted = matches!(kind, SampleKind::LatinHypercube | SampleKind::Sobol);
        if counted && sample.count == 0 {
            let message = format!("`count` is missing beside kind = \"{}\"", kind.word());
            problems.push(Diagnostic::at(&sample.kind, message, "add count = 30, the number of samples"));
        }
        if !counted && sample.count > 0 {
            let message = format!("`count` has no meaning for kind = \"{}\"", kind.word());
            problems.push(Diagnostic::at(
                &sample.kind,
                message,
                "leave it out: the values say how many samples there are",
            ));
        }
        for varied in &self.vary {
            let distributed = matches!(varied.how, Variation::Distributed(_));
            if !counted && distributed && sample.quantiles.is_empty() {
                let message = format!(
                    "`{}` has a distribution, of which a {} takes values",
                    varied.path.value,
                    kind.word()
                );
                let remedy = "give `quantiles = [0.1, 0.9]` in [sample], or `values` or `range` here";
                problems.push(Diagnostic::new(varied.path.span.clone(), message, remedy));
            }
        }
        if let (Some(correlation), false) = (self.correlations.first(), kind == SampleKind::LatinHypercube) {
            let message = format!("a correlation has no meaning for kind = \"{}\"", kind.word());
            problems.push(Diagnostic::at(
                &correlation.rank,
                message,
                "take a latin-hypercube, or leave it out",
            ));
        }
        if let (Some(first), SampleKind::Table) = (self.vary.first(), kind) {
            let message = "a table has the values of its keys itself";
            problems.push(Diagnostic::new(
                first.path.span.clone(),
                message,
                "take [vary] out, or use another kind of [sample]",
            ));
        }
    }

    fn check_measures(&self, problems: &mut Vec<Diagnostic>) {
        for measure in &self.measures {
            let MeasureOf::Column { table, .. } = &measure.of else { continue };
            if !Path::new(&table.value).components().all(|part| matches!(part, Component::Normal(_))) {
                let message = format!("the table `{}` does not lie in the results of a run", table.value);
                problems.push(Diagnostic::at(
                    table,
                    message,
                    "write its path in that folder: \"monitors.csv\"",
                ));
            }
        }
        let names = || self.measures.iter().map(|m| m.name.value.as_str());
        let until = self.scale.iter().filter_map(|scale| match &scale.levels {
            Levels::Ida(ida) => Some(&ida.until),
            Levels::Stripes(_) => None,
        });
        for named in self.fragilities.iter().map(|f| &f.measure).chain(until) {
            if !names().any(|name| name == named.value) {
                let message = format!("there is no measure `{}`", named.value);
                problems.push(Diagnostic::at(named, message, nearest_of(&named.value, names())));
            }
        }
        for fragility in &self.fragilities {
            if self.scale.is_none() && fragility.by.is_none() {
                let message = "a fragility without [scale] needs the measure of intensity that it goes by";
                let remedy = "add by = \"Sa(0.5 s)\", or [scale] with levels";
                problems.push(Diagnostic::new(fragility.span.clone(), message, remedy));
            }
            if fragility.above.windows(2).any(|pair| pair[1] <= pair[0]) {
                let message = "limits that do not rise";
                problems.push(Diagnostic::new(
                    fragility.span.clone(),
                    message,
                    "write above = [0.1, 0.25, 0.5], the least first",
                ));
            }
        }
    }
}

fn nearest_of<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> String {
    let known: Vec<&str> = known.collect();
    match crate::nearest(name, known.iter().copied()) {
        Some(meant) => format!("did you mean `{meant}`?"),
        None if known.is_empty() => "there is none yet: add it".to_owned(),
        None => format!("known are: {}", known.join(", ")),
    }
}
