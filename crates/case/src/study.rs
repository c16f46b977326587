//! The study file: one page of TOML that says which cases are run beside one another, and what is made of their results.
//!
//! Its tables are checked as those of a case are, by tables of keys; keys of the case that it varies are checked by the case itself
//! once a plan is made, since only the case knows their units and limits.

mod quantity;
mod tables;
mod variation;

pub use quantity::{Quantity, rounded};
pub use variation::{Bounds, Distribution, Setting, Variation, Varied};

use std::ops::Range;
use std::path::{Path, PathBuf};

use crate::check::{Checker, UNITS, bare_si};
use crate::fields::{Fields, Item, Node};
use crate::keys::words;
use crate::laws::Laws;
use crate::{Diagnostic, Report, Spanned, inline, key_path, syntax};
use tables::STUDY;

words! {
    /// How samples of the varied keys are chosen.
    SampleKind {
        /// the case as it is, then each key at each of its values with the others as they are.
        OneAtATime = "one-at-a-time",
        /// all values of all keys with one another.
        Grid = "grid",
        /// random, one sample in each of `count` strata of every key (`mckay1979`).
        LatinHypercube = "latin-hypercube",
        /// a Sobol sequence with a random digital shift, for sums over many keys.
        Sobol = "sobol",
        /// the rows of a table of values, a file of comma-separated columns under the paths of the keys.
        Table = "table",
    }
}

words! {
    /// How samples, records and levels go together.
    Design {
        /// each sample with each record at each level.
        Cross = "cross",
        /// sample k with record k modulo the number of records, at each level.
        Paired = "paired",
    }
}

words! {
    /// What a run counts as that the guard stopped in its earthquake.
    FailedRun {
        /// beyond the limit.
        Exceeds = "exceeds",
        /// nothing: it is in no sum, which the page says.
        LeftOut = "left-out",
    }
}

words! {
    /// Which number of a column is taken.
    Take {
        /// the largest absolute value.
        MaxAbs = "max-abs",
        /// the largest.
        Max = "max",
        /// the smallest.
        Min = "min",
        /// the largest less the smallest.
        Range = "range",
        /// that of the first row.
        First = "first",
        /// that of the last row.
        Last = "last",
    }
}

words! {
    /// What stays of a run that is done.
    Keep {
        /// all that it wrote, but for the checkpoint.
        All = "all",
        /// summary, tables and page; fields for ParaView are removed.
        Tables = "tables",
    }
}

/// A study, read and checked as far as its file goes.
#[derive(Clone, Debug, PartialEq)]
pub struct StudyFile {
    /// The file as the user named it.
    pub path: PathBuf,
    /// Its text.
    pub source: String,
    /// What the study is about.
    pub title: Spanned<String>,
    /// The case, as written; relative to the study's folder.
    pub case: Spanned<PathBuf>,
    /// Keys that all runs have other than the case.
    pub set: Vec<Setting>,
    /// Keys that differ from run to run.
    pub vary: Vec<Varied>,
    /// Pairs of varied keys whose ranks go together.
    pub correlations: Vec<Correlation>,
    /// Runs with a name each, written one by one.
    pub rows: Vec<Row>,
    /// How samples are chosen; nothing where nothing is varied.
    pub sample: Option<Sample>,
    /// Records in place of the case's.
    pub records: Vec<RecordEntry>,
    /// How strong they are made.
    pub scale: Option<Scale>,
    /// Columns of the table of results.
    pub measures: Vec<Measure>,
    /// Fragility curves.
    pub fragilities: Vec<Fragility>,
    /// How it is run.
    pub run: RunWish,
}

/// A rank correlation between two varied keys.
#[derive(Clone, Debug, PartialEq)]
pub struct Correlation {
    pub between: [Spanned<String>; 2],
    /// Between −1 and 1.
    pub rank: Spanned<f64>,
}

/// A run that is written out.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    pub name: Spanned<String>,
    /// The row that it is to be set beside.
    pub beside: Option<Spanned<String>>,
    pub set: Vec<Setting>,
}

/// How samples are chosen.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    pub kind: Spanned<SampleKind>,
    /// Number of samples, of latin-hypercube and sobol; 0 of the others.
    pub count: u32,
    /// From 1.
    pub seed: u32,
    /// The table of values.
    pub file: Option<Spanned<PathBuf>>,
    /// Shares of a distribution at which one-at-a-time and grid take its values.
    pub quantiles: Vec<f64>,
}

/// A record in place of the case's.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordEntry {
    pub name: Spanned<String>,
    /// Keys of `[motion]` with their values as TOML.
    entries: Vec<(String, String)>,
    /// Files that it names, as written; relative to the study's folder.
    pub files: Vec<Spanned<PathBuf>>,
    /// Its header.
    pub span: Range<usize>,
}

/// How strong motions are made.
#[derive(Clone, Debug, PartialEq)]
pub struct Scale {
    /// The intensity measure, as written.
    pub measure: Spanned<String>,
    pub levels: Levels,
    pub design: Design,
}

/// Which levels of intensity.
#[derive(Clone, Debug, PartialEq)]
pub enum Levels {
    /// The same for all records, as written.
    Stripes(Vec<Spanned<String>>),
    /// Rising for each record until it is beyond a limit.
    Ida(Ida),
}

/// Incremental dynamic analysis.
#[derive(Clone, Debug, PartialEq)]
pub struct Ida {
    pub first: Spanned<String>,
    pub step: Spanned<String>,
    /// Number of levels at most.
    pub most: u32,
    /// The measure that ends it.
    pub until: Spanned<String>,
    /// Its value beyond which it ends.
    pub above: f64,
}

/// A column of the table of results.
#[derive(Clone, Debug, PartialEq)]
pub struct Measure {
    pub name: Spanned<String>,
    pub of: MeasureOf,
    /// The SI unit of a number of summary.json, where the study says it.
    pub unit: Option<String>,
    /// Taken where the files hold no such number.
    pub otherwise: Option<f64>,
}

/// Where a measure is found.
#[derive(Clone, Debug, PartialEq)]
pub enum MeasureOf {
    /// In summary.json, by its path, over another number there.
    Summary { path: Spanned<String>, over: Option<Spanned<String>> },
    /// In a column of a table.
    Column { table: Spanned<String>, column: Spanned<String>, take: Take },
}

/// A fragility curve for each of several limits.
#[derive(Clone, Debug, PartialEq)]
pub struct Fragility {
    pub measure: Spanned<String>,
    /// Rising.
    pub above: Vec<f64>,
    /// The intensity measure, as written; nothing: that of `[scale]`.
    pub by: Option<Spanned<String>>,
    pub failed: FailedRun,
    /// Number of samples of the bootstrap over records.
    pub bootstrap: u32,
    pub span: Range<usize>,
}

/// How a study is run, which changes no result.
#[derive(Clone, Debug, PartialEq)]
pub struct RunWish {
    pub at_once: Option<u32>,
    pub threads: Option<u32>,
    pub keep: Keep,
    /// Whether runs that are equal before the earthquake share what comes before it.
    pub share: bool,
}

impl RecordEntry {
    /// The keys of `[motion]` that it brings, with their values as TOML; `place` says how a file is to be named.
    pub fn motion(&self, place: impl Fn(&Path) -> PathBuf) -> Vec<(String, String)> {
        let placed = |file: &Path| key_path::quoted(&place(file).to_string_lossy().replace('\\', "/"));
        let named = |file: &Path| key_path::quoted(&file.to_string_lossy());
        let value = |(key, value): &(String, String)| {
            let file = self.files.iter().find(|file| match key.as_str() {
                "file" => true,
                // A component names its file on one line, as it is written here.
                _ => value.contains(&format!("file = {}", named(&file.value))),
            });
            let value = file
                .map_or_else(|| value.clone(), |f| value.replacen(&named(&f.value), &placed(&f.value), 1));
            (key.clone(), value)
        };
        self.entries.iter().map(value).collect()
    }
}

impl StudyFile {
    /// Reads and checks a study file.
    ///
    /// # Errors
    /// All problems of the file at once.
    pub fn read(path: &Path) -> Result<StudyFile, Report> {
        StudyFile::parse(path, &syntax::read(path, "study file")?)
    }

    /// Checks the text of a study file. Touches no files; `path` names it in messages.
    ///
    /// # Errors
    /// All problems of the text at once: of its syntax, or else of its content.
    pub fn parse(path: &Path, source: &str) -> Result<StudyFile, Report> {
        let report = |problems| Report::new(path, source, problems);
        let document = syntax::parse(source).map_err(report)?;
        let written = document.get_ref();
        let mut problems = Vec::new();
        // Bare numbers of the study become those of its cases, which then are in SI as well.
        let units = written.get(UNITS.name).filter(|_| bare_si(written));
        let units = units.map(|at| Setting {
            path: Spanned::new(UNITS.name.to_owned(), at.span()),
            value: "\"SI\"".to_owned(),
        });
        let set = written
            .get("set")
            .map_or_else(Vec::new, |v| variation::settings(source, v, "set", &mut problems));
        let set = units.into_iter().chain(set).collect();
        let vary = written.get("vary").map_or_else(Vec::new, |v| variation::varied(source, v, &mut problems));
        let rows = written.get("row").map_or_else(Vec::new, |v| rows(source, v, &mut problems));
        let mut rest = written.clone();
        for by_hand in ["set", "vary", "row"] {
            rest.remove(by_hand);
        }
        let mut checker = Checker::new(&STUDY, Laws { materials: &[], interfaces: &[] }, written);
        let fields = checker.table(&STUDY, Some(&[]), &rest, document.span(), "");
        problems.extend(checker.problems);
        let records = fields.tables("record").filter_map(|f| record(source, written, f)).collect();
        let study = StudyFile::assemble(path, source, &fields, (set, vary, rows, records));
        match study {
            Some(study) if problems.is_empty() => {
                let problems = study.check();
                if problems.is_empty() { Ok(study) } else { Err(report(problems)) }
            }
            None if problems.is_empty() => {
                let remedy = "compare it with cases/first-shake/fragility.toml";
                Err(report(vec![Diagnostic::new(0..0, "the study is not complete", remedy)]))
            }
            _ => Err(report(problems)),
        }
    }

    /// A report of problems found later, to be shown in this file's text.
    pub fn report(&self, problems: Vec<Diagnostic>) -> Report {
        Report::new(&self.path, &self.source, problems)
    }

    /// The folder that paths of the study start from.
    pub fn directory(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new(""))
    }

    fn assemble(
        path: &Path,
        source: &str,
        f: &Fields,
        (set, vary, rows, records): (Vec<Setting>, Vec<Varied>, Vec<Row>, Vec<RecordEntry>),
    ) -> Option<StudyFile> {
        let case = f.text("case")?;
        let run = f.table("run")?;
        Some(StudyFile {
            path: path.to_owned(),
            source: source.to_owned(),
            title: f.text("title")?,
            case: Spanned::new(case.value.into(), case.span),
            set,
            vary,
            rows,
            records,
            correlations: f.tables("correlation").map(correlation).collect::<Option<_>>()?,
            sample: match f.table("sample") {
                Some(sample) => Some(read_sample(sample)?),
                None => None,
            },
            scale: match f.table("scale") {
                Some(scale) => Some(read_scale(scale)?),
                None => None,
            },
            measures: f.entries("measure").iter().map(measure).collect::<Option<_>>()?,
            fragilities: f.tables("fragility").map(fragility).collect::<Option<_>>()?,
            run: RunWish {
                at_once: run.count("at_once").map(|n| n.value),
                threads: run.count("threads").map(|n| n.value),
                keep: run.word("keep", Keep::from_word)?.value,
                share: run.flag("share")?,
            },
        })
    }

    /// What lies between keys.
    fn check(&self) -> Vec<Diagnostic> {
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

fn rows(
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

fn correlation(f: &Fields) -> Option<Correlation> {
    let [a, b] = f.texts("between").try_into().ok()?;
    Some(Correlation { between: [a, b], rank: f.number("rank")? })
}

fn read_sample(f: &Fields) -> Option<Sample> {
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
fn record(source: &str, document: &toml::de::DeTable<'_>, f: &Fields) -> Option<RecordEntry> {
    let written = document.get("record")?.get_ref().as_array()?;
    let own = written.iter().find(|v| v.span() == f.span)?.get_ref().as_table()?;
    let of = |table: &Fields| table.text("file").map(|t| Spanned::new(PathBuf::from(t.value), t.span));
    let mut files: Vec<Spanned<PathBuf>> = of(f).into_iter().collect();
    files.extend(["east", "north", "up"].into_iter().filter_map(|key| of(f.table(key)?)));
    let entries = inline::entries(source, own).into_iter().filter(|(key, _)| key != "name").collect();
    Some(RecordEntry { name: f.text("name")?, entries, files, span: f.span.clone() })
}

fn read_scale(f: &Fields) -> Option<Scale> {
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
    Some(Scale { measure: f.text("measure")?, levels, design: f.word("design", Design::from_word)?.value })
}

fn measure((name, node): &(Spanned<String>, Node)) -> Option<Measure> {
    let Item::Table(f) = &node.item else { return None };
    let of = match f.text("summary") {
        Some(path) => MeasureOf::Summary { path, over: f.text("over") },
        None => MeasureOf::Column {
            table: f.text("table")?,
            column: f.text("column")?,
            take: f.word("take", Take::from_word)?.value,
        },
    };
    let unit = f.text("unit").map(|t| t.value);
    Some(Measure { name: name.clone(), of, unit, otherwise: f.number("otherwise").map(|n| n.value) })
}

fn fragility(f: &Fields) -> Option<Fragility> {
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

#[cfg(test)]
mod tests;
