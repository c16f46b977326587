//! Bolts by two points each: from the case or from a file, and whether they lie in what stands.

use super::wall::{Vector, between, minus, norm};
use tremolite_mesh::locate::Locator;

/// A bolt, and how it is called in messages.
#[derive(Clone, Debug, PartialEq)]
pub struct Listed {
    pub name: String,
    /// Head and other end \[m\].
    pub ends: [Vector; 2],
}

/// Names of the columns of a file.
const COLUMNS: [&str; 6] = ["x1", "y1", "z1", "x2", "y2", "z2"];
/// Nearer \[m\] the two points are one place.
const SHORTEST: f64 = 1e-3;
/// An end that is outside by up to this \[m\] is taken to lie on the wall; shorter gaps are no void, as when bolts are cut.
const ON_WALL: f64 = 0.01;

/// The bolts of a file's text, or what is wrong in which line.
pub fn parse(file: &str, text: &str) -> Result<Vec<Listed>, String> {
    let mut bolts = Vec::new();
    let mut first = true;
    for (k, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let (number, line) = (k + 1, line.trim());
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let fields: Vec<&str> = line.split(',').map(str::trim).collect();
        let is_header =
            fields.iter().any(|f| f.parse::<f64>().is_err() && f.starts_with(char::is_alphabetic));
        if std::mem::take(&mut first) && is_header {
            header(&fields).map_err(|e| format!("{file}, line {number}: {e}"))?;
            continue;
        }
        let fault = |what: String| format!("{file}, line {number}: {what}");
        if fields.len() != COLUMNS.len() {
            return Err(fault(format!("{} values, where {} are expected", fields.len(), COLUMNS.join(","))));
        }
        let mut values = [0.0; 6];
        for ((value, field), column) in values.iter_mut().zip(&fields).zip(COLUMNS) {
            let read = field.parse().ok().filter(|x: &f64| x.is_finite());
            *value = read.ok_or_else(|| fault(format!("{column} is '{field}', which is no number")))?;
        }
        let [x1, y1, z1, x2, y2, z2] = values;
        let ends = [[x1, y1, z1], [x2, y2, z2]];
        if norm(minus(ends[1], ends[0])) < SHORTEST {
            return Err(fault("the two points of the bolt are one place".to_owned()));
        }
        bolts.push(Listed { name: format!("the bolt in line {number} of {file}"), ends });
    }
    if bolts.is_empty() { Err(format!("{file} holds no bolts")) } else { Ok(bolts) }
}

/// The bolts of a list in memory, or what is wrong with which; they count from 1.
pub fn of_ends(name: &str, ends: &[[Vector; 2]]) -> Result<Vec<Listed>, String> {
    let one = |(k, ends): (usize, &[Vector; 2])| {
        let fault = |what: &str| Err(format!("{name} in memory, bolt {}: {what}", k + 1));
        if ends.iter().flatten().any(|x| !x.is_finite()) {
            return fault("its points are not finite");
        }
        if norm(minus(ends[1], ends[0])) < SHORTEST {
            return fault("the two points of the bolt are one place");
        }
        Ok(Listed { name: format!("bolt {} of {name}", k + 1), ends: *ends })
    };
    let bolts: Vec<Listed> = ends.iter().enumerate().map(one).collect::<Result<_, _>>()?;
    if bolts.is_empty() { Err(format!("{name} in memory holds no bolts")) } else { Ok(bolts) }
}

/// Refuses names of columns that are not the expected ones, in m, in their order.
fn header(fields: &[&str]) -> Result<(), String> {
    let good = |(field, column): (&&str, &str)| {
        let (name, unit) = field
            .split_once('[')
            .map_or((*field, "m"), |(name, unit)| (name.trim(), unit.trim_end_matches(']').trim()));
        name.eq_ignore_ascii_case(column) && unit == "m"
    };
    if fields.len() == COLUMNS.len() && fields.iter().zip(COLUMNS).all(good) {
        return Ok(());
    }
    Err(format!("the columns are {}, where {} in m are expected", fields.join(","), COLUMNS.join(",")))
}

/// Where a bolt may lie: the elements that stand when it is placed.
pub struct Standing<'a> {
    pub locator: &'a Locator<'a>,
}

/// Why a bolt cannot be placed.
#[derive(Clone, Debug, PartialEq)]
pub enum Outside {
    /// An end is in no element: "its head", "its other end"; and where.
    End(&'static str, Vector),
    /// It leaves what stands: where, and how far from its head \[m\].
    Leaves(Vector, f64),
}

impl Standing<'_> {
    /// The bolt's ends within what stands: what is outside by no more than a slip of the tape is cut off.
    pub fn place(&self, ends: [Vector; 2], free: f64) -> Result<[Vector; 2], Outside> {
        let [head, tail] = ends;
        let length = norm(minus(tail, head));
        let at = |t: f64| between(head, tail, t / length);
        let stretches = self.locator.stretches(head, tail);
        let (from, to) = match (stretches.first(), stretches.last()) {
            (Some(first), Some(last)) if first.from <= ON_WALL => (first.from, last.to),
            _ => return Err(Outside::End("its head", head)),
        };
        if to < length - ON_WALL {
            // Where it leaves tells more than where it ends.
            return Err(if free < to {
                Outside::Leaves(at(to), to)
            } else {
                Outside::End("its other end", tail)
            });
        }
        let mut reach = from;
        for stretch in &stretches {
            if stretch.from - reach > ON_WALL && stretch.from > free {
                let leaves = reach.max(free);
                return Err(Outside::Leaves(at(leaves), leaves));
            }
            reach = reach.max(stretch.to);
        }
        Ok([if from > 0.0 { at(from) } else { head }, if to < length { at(to) } else { tail }])
    }

    /// Mean length \[m\] of the pieces into which elements cut a bolt up to the first void.
    pub fn piece(&self, ends: [Vector; 2]) -> Option<f64> {
        let (mut reach, mut count) = (0.0, 0);
        for stretch in self.locator.stretches(ends[0], ends[1]) {
            if stretch.from - reach > ON_WALL {
                break;
            }
            (reach, count) = (stretch.to, count + 1);
        }
        (count > 0).then(|| reach / f64::from(count))
    }
}
