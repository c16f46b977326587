//! What a study does with keys of the case: values set for all runs, and values that differ from run to run.

use std::ops::Range;

use toml::Spanned as Located;
use toml::de::{DeTable, DeValue};

use super::quantity::Quantity;
use crate::{Diagnostic, Spanned, inline, key_path, suggest};

/// A key of the case with its value.
#[derive(Clone, Debug, PartialEq)]
pub struct Setting {
    /// The path of the key.
    pub path: Spanned<String>,
    /// The value as TOML, on one line.
    pub value: String,
}

/// A key of the case whose value differs from run to run.
#[derive(Clone, Debug, PartialEq)]
pub struct Varied {
    /// The path of the key.
    pub path: Spanned<String>,
    pub how: Variation,
}

/// Which values a key takes.
#[derive(Clone, Debug, PartialEq)]
pub enum Variation {
    /// These, as TOML.
    Values(Vec<String>),
    /// Random ones, in the unit that they are written with.
    Distributed(Distribution),
}

/// A distribution of a number; all in `unit`.
#[derive(Clone, Debug, PartialEq)]
pub enum Distribution {
    Uniform {
        low: f64,
        high: f64,
        unit: String,
    },
    /// The logarithm is uniform.
    LogUniform {
        low: f64,
        high: f64,
        unit: String,
    },
    Normal {
        mean: f64,
        sd: f64,
        within: Bounds,
        unit: String,
    },
    /// The logarithm is normal, with the standard deviation `beta`.
    Lognormal {
        median: f64,
        beta: f64,
        within: Bounds,
        unit: String,
    },
}

impl Distribution {
    /// The unit of its numbers.
    pub fn unit(&self) -> &str {
        match self {
            Distribution::Uniform { unit, .. }
            | Distribution::LogUniform { unit, .. }
            | Distribution::Normal { unit, .. }
            | Distribution::Lognormal { unit, .. } => unit,
        }
    }
}

/// Where a distribution is cut off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// −∞ where there is none.
    pub min: f64,
    /// ∞ where there is none.
    pub max: f64,
}

/// The most values of a range.
const MOST_VALUES: f64 = 10_000.0;

/// The keys of a table of settings.
pub(super) fn settings(
    source: &str,
    written: &Located<DeValue<'_>>,
    table: &str,
    problems: &mut Vec<Diagnostic>,
) -> Vec<Setting> {
    let keys = keys(written, table, problems);
    keys.into_iter().map(|(path, value)| Setting { path, value: inline::value(source, value) }).collect()
}

/// The keys of `[vary]`.
pub(super) fn varied(
    source: &str,
    written: &Located<DeValue<'_>>,
    problems: &mut Vec<Diagnostic>,
) -> Vec<Varied> {
    let mut found = Vec::new();
    for (path, value) in keys(written, "vary", problems) {
        let how = match value.get_ref() {
            DeValue::Table(table) => variation(source, &path, table, value.span()),
            _ => Err(Fault {
                at: value.span(),
                message: format!("`{}` has no distribution and no values", path.value),
                remedy: format!("write \"{}\" = {{ {SAMPLES} }}", path.value),
            }),
        };
        match how {
            Ok(how) => found.push(Varied { path, how }),
            Err(fault) => problems.push(Diagnostic::new(fault.at, fault.message, fault.remedy)),
        }
    }
    found
}

const SAMPLES: &str = "uniform = [0.5, 1.2]";

/// The keys of a table whose keys are paths of the case, in the order of the file.
fn keys<'a>(
    written: &'a Located<DeValue<'a>>,
    table: &str,
    problems: &mut Vec<Diagnostic>,
) -> Vec<(Spanned<String>, &'a Located<DeValue<'a>>)> {
    let Some(keys) = written.get_ref().as_table() else {
        let message = format!("`{table}` should be a table");
        problems.push(Diagnostic::new(
            written.span(),
            message,
            "write the paths of keys and their values: \"initial.lateral\" = …",
        ));
        return Vec::new();
    };
    let mut found = Vec::new();
    for (key, value) in keys {
        let path = Spanned::new(key.get_ref().to_string(), key.span());
        if let Err(why) = key_path::parse(&path.value) {
            let message = format!("`{}` is no path of a key: {why}", path.value);
            let remedy = "write the keys with dots, and entries of lists in brackets: \"stage[0].release\"";
            problems.push(Diagnostic::at(&path, message, remedy));
            continue;
        }
        found.push((path, value));
    }
    found.sort_by_key(|(path, _)| path.span.start);
    found
}

struct Fault {
    at: Range<usize>,
    message: String,
    remedy: String,
}

const KINDS: [&str; 6] = ["values", "range", "uniform", "log_uniform", "normal", "lognormal"];

fn variation(
    source: &str,
    path: &Spanned<String>,
    table: &DeTable<'_>,
    at: Range<usize>,
) -> Result<Variation, Fault> {
    let mut entries = table.iter();
    let (Some((key, value)), None) = (entries.next(), entries.next()) else {
        return Err(Fault {
            at,
            message: format!("`{}` needs exactly one of `{}`", path.value, KINDS.join("`, `")),
            remedy: format!("write \"{}\" = {{ {SAMPLES} }}", path.value),
        });
    };
    let kind = key.get_ref().as_ref();
    let inside = Inside { at: value.span(), kind };
    match (kind, value.get_ref()) {
        ("values", DeValue::Array(values)) if !values.is_empty() => {
            Ok(Variation::Values(values.iter().map(|v| inline::value(source, v)).collect()))
        }
        ("range", DeValue::Table(range)) => inside.range(range),
        ("uniform" | "log_uniform", DeValue::Array(ends)) if ends.len() == 2 => {
            let [low, high] = inside.same_unit([inside.quantity(&ends[0])?, inside.quantity(&ends[1])?])?;
            let unit = low.unit;
            let (low, high) = (low.number, high.number);
            if high <= low {
                return inside.fault("its end is not above its beginning", "write [least, largest]");
            }
            if kind == "uniform" {
                return Ok(Variation::Distributed(Distribution::Uniform { low, high, unit }));
            }
            if low <= 0.0 {
                return inside.fault("a logarithm needs numbers above 0", "use `uniform`, or begin above 0");
            }
            Ok(Variation::Distributed(Distribution::LogUniform { low, high, unit }))
        }
        ("normal", DeValue::Table(normal)) => inside.normal(normal),
        ("lognormal", DeValue::Table(lognormal)) => inside.lognormal(lognormal),
        (kind, _) if KINDS.contains(&kind) => {
            let form = match kind {
                "values" => "values = [0.5, 0.8, 1.2]",
                "range" => "range = { from = \"1 MPa\", to = \"3 MPa\", count = 5 }",
                "normal" => "normal = { mean = 0.6, sd = 0.1, min = 0.2, max = 1.0 }",
                "lognormal" => "lognormal = { median = \"1.2 MPa\", beta = 0.25 }",
                "uniform" => SAMPLES,
                _ => "log_uniform = [\"1 MPa\", \"10 MPa\"]",
            };
            inside.fault("it is not written as it should be", &format!("write {form}"))
        }
        (other, _) => {
            let remedy = match suggest::nearest(other, KINDS.into_iter()) {
                Some(meant) => format!("did you mean `{meant}`?"),
                None => format!("write one of `{}`", KINDS.join("`, `")),
            };
            Err(Fault { at: key.span(), message: format!("`{other}` is no way to vary a key"), remedy })
        }
    }
}

/// A distribution or range, of which values are asked for.
struct Inside<'a> {
    at: Range<usize>,
    kind: &'a str,
}

impl Inside<'_> {
    fn fault<T>(&self, message: &str, remedy: &str) -> Result<T, Fault> {
        Err(Fault {
            at: self.at.clone(),
            message: format!("`{}`: {message}", self.kind),
            remedy: remedy.to_owned(),
        })
    }

    fn quantity(&self, value: &Located<DeValue<'_>>) -> Result<Quantity, Fault> {
        Quantity::of(value.get_ref()).ok_or_else(|| Fault {
            at: value.span(),
            message: format!("`{}` needs numbers with their units", self.kind),
            remedy: "write 0.6 or \"1.2 MPa\"".to_owned(),
        })
    }

    /// All in the unit of the first.
    fn same_unit<const N: usize>(&self, all: [Quantity; N]) -> Result<[Quantity; N], Fault> {
        match all.iter().find(|q| q.unit != all[0].unit) {
            Some(other) => self.fault(
                &format!("`{}` and `{}` are in different units", all[0].shown(), other.shown()),
                "write all of its numbers in one unit",
            ),
            None => Ok(all),
        }
    }

    /// The values of a table with these keys; the last two may be left out.
    fn table<const N: usize>(
        &self,
        table: &DeTable<'_>,
        names: [&str; N],
        needed: usize,
    ) -> Result<[Option<Quantity>; N], Fault> {
        if let Some((key, _)) = table.iter().find(|(key, _)| !names.contains(&key.get_ref().as_ref())) {
            return Err(Fault {
                at: key.span(),
                message: format!("`{}` is no key of `{}`", key.get_ref(), self.kind),
                remedy: format!("keys here: {}", names.join(", ")),
            });
        }
        let mut found = [const { None }; N];
        for (k, name) in names.into_iter().enumerate() {
            match table.get(name) {
                Some(value) => found[k] = Some(self.quantity(value)?),
                None if k < needed => {
                    return self.fault(&format!("`{name}` is missing"), &format!("add {name} = …"));
                }
                None => {}
            }
        }
        Ok(found)
    }

    fn range(&self, table: &DeTable<'_>) -> Result<Variation, Fault> {
        let [from, to, count] = self.table(table, ["from", "to", "count"], 3)?;
        let (Some(from), Some(to), Some(count)) = (from, to, count) else {
            return self.fault("a key is missing", "write { from = 0.5, to = 1.2, count = 5 }");
        };
        let [from, to] = self.same_unit([from, to])?;
        let whole = count.unit.is_empty() && count.number.fract() == 0.0;
        if !whole || !(2.0..=MOST_VALUES).contains(&count.number) {
            return self.fault("`count` is a whole number from 2", "write count = 5");
        }
        let last = count.number - 1.0;
        let value = |k: f64| Quantity {
            number: from.number + (to.number - from.number) * k / last,
            unit: from.unit.clone(),
        };
        Ok(Variation::Values((0..count.number as u32).map(|k| value(f64::from(k)).toml()).collect()))
    }

    /// `min` and `max` in a unit.
    fn bounds(&self, unit: &str, min: Option<Quantity>, max: Option<Quantity>) -> Result<Bounds, Fault> {
        let number = |bound: Option<Quantity>, without: f64| match bound {
            None => Ok(without),
            Some(bound) if bound.unit == unit => Ok(bound.number),
            Some(bound) => self.fault(
                &format!("the bound `{}` is in another unit", bound.shown()),
                "write all of its numbers in one unit",
            ),
        };
        let bounds = Bounds { min: number(min, f64::NEG_INFINITY)?, max: number(max, f64::INFINITY)? };
        if bounds.max <= bounds.min {
            return self.fault("`max` is not above `min`", "write the lower one as min");
        }
        Ok(bounds)
    }

    fn normal(&self, table: &DeTable<'_>) -> Result<Variation, Fault> {
        let [mean, sd, min, max] = self.table(table, ["mean", "sd", "min", "max"], 2)?;
        let (Some(mean), Some(sd)) = (mean, sd) else {
            return self.fault("`mean` or `sd` is missing", "write { mean = 0.6, sd = 0.1 }");
        };
        let [mean, sd] = self.same_unit([mean, sd])?;
        if sd.number <= 0.0 {
            return self.fault("`sd` must be above 0", "leave the key out of [vary] where it does not vary");
        }
        let within = self.bounds(&mean.unit, min, max)?;
        Ok(Variation::Distributed(Distribution::Normal {
            mean: mean.number,
            sd: sd.number,
            within,
            unit: mean.unit,
        }))
    }

    fn lognormal(&self, table: &DeTable<'_>) -> Result<Variation, Fault> {
        let [median, beta, min, max] = self.table(table, ["median", "beta", "min", "max"], 2)?;
        let (Some(median), Some(beta)) = (median, beta) else {
            return self
                .fault("`median` or `beta` is missing", "write { median = \"1.2 MPa\", beta = 0.25 }");
        };
        if median.number <= 0.0 || beta.number <= 0.0 || !beta.unit.is_empty() {
            return self.fault(
                "`median` and `beta` must be above 0, and `beta` has no unit",
                "write { median = \"1.2 MPa\", beta = 0.25 }",
            );
        }
        let within = self.bounds(&median.unit, min, max)?;
        let (median, unit) = (median.number, median.unit);
        Ok(Variation::Distributed(Distribution::Lognormal { median, beta: beta.number, within, unit }))
    }
}
