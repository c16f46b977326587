//! Tables of a study file as they are read.

use std::path::PathBuf;

use super::{
    Checks, Correlation, Design, FailedRun, Fragility, Ida, Levels, Measure, MeasureOf, RecordEntry, Row,
    Sample, SampleKind, Scale, Take, variation,
};
use crate::fields::{Fields, Item, Node};
use crate::{Diagnostic, Spanned, inline};

pub(super) fn rows(
    source: &str,
    written: &toml::Spanned<toml::de::DeValue<'_>>,
    problems: &mut Vec<Diagnostic>,
) -> Vec<Row> {
    let Some(list) = written.get_ref().as_array().filter(|l| l.iter().all(|v| v.get_ref().is_table())) else {
        let message = "`row` should be a list of tables";
        problems.push(Diagnostic::new(written.span(), message, "write [[row]] with `name` and `set`"));
        return Vec::new();
    };
    let mut found = Vec::new();
    for row in list {
        let Some(table) = row.get_ref().as_table() else { continue };
        for (key, _) in
            table.iter().filter(|(key, _)| !["name", "beside", "set"].contains(&key.get_ref().as_ref()))
        {
            let message = format!("`{}` is no key of `row`", key.get_ref());
            problems.push(Diagnostic::new(key.span(), message, "keys here: name, beside, set"));
        }
        let text = |key: &str| {
            let value = table.get(key)?;
            let text = value.get_ref().as_str().filter(|t| !t.trim().is_empty())?;
            Some(Spanned::new(text.to_owned(), value.span()))
        };
        let Some(name) = text("name") else {
            problems.push(Diagnostic::new(
                row.span(),
                "`name` is missing in `row`",
                "add name = \"…\", by which its folder is called",
            ));
            continue;
        };
        let beside = text("beside");
        if let (Some(value), None) = (table.get("beside"), &beside) {
            problems.push(Diagnostic::new(value.span(), "`beside` should be a text", "name another row"));
        }
        let set =
            table.get("set").map_or_else(Vec::new, |v| variation::settings(source, v, "row.set", problems));
        found.push(Row { name, beside, set });
    }
    found
}

pub(super) fn correlation(f: &Fields) -> Option<Correlation> {
    let [a, b] = f.texts("between").try_into().ok()?;
    Some(Correlation { between: [a, b], rank: f.number("rank")? })
}

pub(super) fn sample(f: &Fields) -> Option<Sample> {
    let quantiles = f.list("quantiles").iter().filter_map(|n| Some(n.number()?.value)).collect();
    Some(Sample {
        kind: f.word("kind", SampleKind::from_word)?,
        count: f.count("count").map_or(0, |n| n.value),
        seed: f.count("seed")?.value,
        file: f.text("file").map(|t| Spanned::new(t.value.into(), t.span)),
        quantiles,
    })
}

/// The keys of `[motion]` that a record brings; its files are asked for by the study's folder.
pub(super) fn record(source: &str, document: &toml::de::DeTable<'_>, f: &Fields) -> Option<RecordEntry> {
    let written = document.get("record")?.get_ref().as_array()?;
    let own = written.iter().find(|v| v.span() == f.span)?.get_ref().as_table()?;
    let of = |table: &Fields| table.text("file").map(|t| Spanned::new(PathBuf::from(t.value), t.span));
    let mut files: Vec<Spanned<PathBuf>> = of(f).into_iter().collect();
    files.extend(["east", "north", "up"].into_iter().filter_map(|key| of(f.table(key)?)));
    let entries = inline::entries(source, own).into_iter().filter(|(key, _)| key != "name").collect();
    Some(RecordEntry { name: f.text("name")?, entries, files, span: f.span.clone() })
}

pub(super) fn scale(f: &Fields) -> Option<Scale> {
    let levels = match f.table("ida") {
        Some(ida) => Levels::Ida(Ida {
            first: ida.text("first")?,
            step: ida.text("step")?,
            most: ida.count("most")?.value,
            until: ida.text("until")?,
            above: ida.number("above")?.value,
        }),
        None => Levels::Stripes(f.texts("levels")),
    };
    Some(Scale {
        measure: f.text("measure")?,
        target: f.text("target"),
        levels,
        design: f.word("design", Design::from_word)?.value,
    })
}

pub(super) fn measure((name, node): &(Spanned<String>, Node)) -> Option<Measure> {
    let Item::Table(f) = &node.item else { return None };
    let of = match (f.text("summary"), f.word("checks", Checks::from_word)) {
        (Some(path), _) => MeasureOf::Summary { path, over: f.text("over") },
        (None, Some(checks)) => MeasureOf::Checks(checks.value),
        (None, None) => MeasureOf::Column {
            table: f.text("table")?,
            column: f.text("column")?,
            take: f.word("take", Take::from_word)?.value,
        },
    };
    let unit = f.text("unit").map(|t| t.value);
    let names = f.texts("names").into_iter().map(|name| name.value).collect();
    Some(Measure {
        name: name.clone(),
        of,
        unit,
        otherwise: f.number("otherwise").map(|n| n.value),
        unless: f.text("unless").map(|path| (path, names)),
    })
}

pub(super) fn fragility(f: &Fields) -> Option<Fragility> {
    let above = f.get("above")?;
    let above = match above.number() {
        Some(one) => vec![one.value],
        None => above.list().iter().filter_map(|n| Some(n.number()?.value)).collect(),
    };
    Some(Fragility {
        measure: f.text("measure")?,
        above,
        by: f.text("by"),
        failed: f.word("failed", FailedRun::from_word)?.value,
        bootstrap: f.count("bootstrap")?.value,
        span: f.span.clone(),
    })
}
