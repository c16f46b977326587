//! Where a number of the page comes from: what follows it through all copies of the folder.

use std::collections::HashMap;
use std::fs;
use std::path::Path;

use tremolite_report::{Language, write_in};

use super::known::{Kind, Known};
use super::scaled::scaled;
use super::tokens::{Token, places, tokens};

/// Pages that say the same of numbers that are other ones in each.
pub struct Pages {
    /// Of the folder as it is.
    pub tokens: Vec<Token>,
    /// Of each of these what stands at its place in the pages, the first of them its own; nothing where that page says
    /// something else there, as that another monitor moves most.
    shown: Vec<Vec<Option<(f64, f64)>>>,
    /// What the first folder holds and, of each number there, its values in all.
    known: Vec<Known>,
    values: Vec<Vec<f64>>,
    /// Numbers of `known` by the digits of their first value.
    digits: Vec<(f64, usize)>,
    /// By their first value's size.
    sizes: Vec<(f64, usize)>,
    /// Factors of places in field files.
    places: Vec<f64>,
}

/// What a number of the page is.
#[derive(Clone, Debug)]
pub enum Source {
    /// Nothing.
    Zero,
    /// The same whatever the files hold.
    Constant,
    /// It stands in a file.
    In(Kind, String),
    /// It grows with the places in field files.
    Place(&'static str),
    /// It follows from two numbers that do.
    Of(String),
    Unknown,
    /// Too few of the pages say the same around it.
    Unsettled,
}

impl Source {
    /// In words that begin with what kind it is.
    pub fn told(&self) -> String {
        match self {
            Source::Zero => "nothing".into(),
            Source::Constant => "constant".into(),
            Source::In(Kind::Over, name) => format!("over: {name}"),
            Source::In(Kind::Row, name) => format!("row: {name}"),
            Source::In(_, name) => format!("stands: {name}"),
            Source::Place(what) => (*what).into(),
            Source::Of(what) => what.clone(),
            Source::Unknown => "unknown".into(),
            Source::Unsettled => "unsettled".into(),
        }
    }

    /// Whether a file holds the number itself.
    pub fn stands(&self) -> bool {
        matches!(self, Source::Zero | Source::In(Kind::Leaf | Kind::Extreme | Kind::Field, _))
    }
}

impl Pages {
    /// The pages of a folder and `copies` copies of it.
    pub fn of(root: &Path, copies: u64, language: Language) -> Pages {
        let mut all = Vec::new();
        let mut factors = Vec::new();
        let mut tokens_here = Vec::new();
        let mut shown: Vec<Vec<Option<(f64, f64)>>> = Vec::new();
        for copy in 0..=copies {
            let at = tempfile::tempdir().unwrap();
            let content = scaled(root, at.path(), copy);
            let page = fs::read_to_string(write_in(at.path(), language).unwrap()).unwrap();
            let list = tokens(&page, &content.names);
            if copy == 0 {
                tokens_here = list.clone();
                shown = vec![Vec::new(); list.len()];
            }
            let found: HashMap<_, _> = places(&list).into_iter().zip(&list).collect();
            for (place, shown) in places(&tokens_here).iter().zip(&mut shown) {
                shown.push(found.get(place).map(|token| (token.value, token.half)));
            }
            factors.push(content.places);
            all.push(content.known);
        }
        let known = all[0].clone();
        let values: Vec<Vec<f64>> =
            (0..known.len()).map(|k| all.iter().map(|own| own[k].value).collect()).collect();
        let usable = (0..known.len()).filter(|&k| known[k].value.is_finite() && known[k].value != 0.0);
        let mut digits: Vec<(f64, usize)> = usable.clone().map(|k| (mantissa(known[k].value), k)).collect();
        digits.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut sizes: Vec<(f64, usize)> = usable
            .filter(|&k| known[k].kind < Kind::Field && !known[k].name.contains(" where "))
            .map(|k| (known[k].value.abs(), k))
            .collect();
        sizes.sort_by(|a, b| a.0.total_cmp(&b.0));
        sizes.dedup_by(|a, b| a.0 == b.0 && values[a.1] == values[b.1]);
        Pages { tokens: tokens_here, shown, known, values, digits, sizes, places: factors }
    }

    /// Where the token of this number comes from.
    pub fn source(&self, token: usize) -> Source {
        let shown: &[Option<(f64, f64)>] = &self.shown[token];
        let given = || shown.iter().flatten();
        if given().all(|(value, _)| *value == 0.0) {
            return Source::Zero;
        }
        if given().count() < 5 {
            return Source::Unsettled;
        }
        let factors = match self.tokens[token].factor {
            Some(factor) => vec![factor, 1.0],
            None => vec![1.0, 1e2, 1e3, 1e6, 1e9, 1e-3, 1e-6, 1e-9],
        };
        let fits = |k: usize, factor: f64| {
            let near = |(shown, own): (&Option<(f64, f64)>, &f64)| {
                shown.is_none_or(|(value, half)| {
                    (value.abs() - (factor * own).abs()).abs() <= 1.000_001 * half
                })
            };
            shown.iter().zip(&self.values[k]).all(near)
        };
        let mut best: Option<(Kind, usize)> = None;
        let Token { value, half, .. } = self.tokens[token];
        for factor in &factors {
            let (from, to) = ((value.abs() - half) / factor, (value.abs() + half) / factor);
            let candidates: Vec<usize> = self.between(from, to);
            for k in candidates {
                if best.is_none_or(|(kind, _)| self.known[k].kind < kind) && fits(k, *factor) {
                    best = Some((self.known[k].kind, k));
                }
            }
        }
        if given().all(|(own, _)| *own == value) && best.is_none_or(|(kind, _)| kind != Kind::Leaf) {
            return Source::Constant;
        }
        let single = best.map(|(kind, k)| Source::In(kind, self.known[k].name.clone()));
        // Where something lies in a field file, and areas and volumes there.
        // Zeros behind the point may be left out, so that the finest tells how fine they are.
        let fine = given().map(|(_, half)| *half).fold(f64::INFINITY, f64::min);
        let grows = |power: i32| {
            shown.iter().zip(&self.places).all(|(shown, by)| {
                shown.is_none_or(|(own, _)| (own - value * by.powi(power)).abs() <= 2.1 * fine)
            })
        };
        match best {
            Some((kind, _)) if kind < Kind::Row => single.unwrap_or(Source::Unknown),
            _ if grows(1) => Source::Place("place"),
            _ if grows(2) => Source::Place("area"),
            // Many rows of histories are near a number of few digits.
            _ => self.of_two(token, shown).map(Source::Of).or(single).unwrap_or(Source::Unknown),
        }
    }

    /// A ratio or a difference of two numbers that follows the token.
    fn of_two(&self, token: usize, shown: &[Option<(f64, f64)>]) -> Option<String> {
        let (value, half) = shown[0].map(|(value, half)| (value.abs(), half))?;
        type Of = fn(f64, f64) -> f64;
        let forms: [(&str, Of, Of); 5] = [
            ("ratio", |a, b| a / b, |t, b| t * b),
            ("difference", |a, b| a - b, |t, b| b + t),
            ("sum", |a, b| a + b, |t, b| t - b),
            ("relative difference", |a, b| 1.0 - a / b, |t, b| (1.0 - t) * b),
            ("relative difference", |a, b| a / b - 1.0, |t, b| (1.0 + t) * b),
        ];
        let leaves: Vec<(f64, usize)> =
            self.sizes.iter().copied().filter(|(_, k)| self.known[*k].kind == Kind::Leaf).collect();
        for ((what, of, solved), sizes) in
            [&leaves, &self.sizes].into_iter().flat_map(|sizes| forms.map(|form| (form, sizes)))
        {
            let factors = match self.tokens[token].factor {
                Some(factor) => vec![factor, 1.0],
                None => vec![1.0, 1e2, 1e3, 1e-6, 1e-3],
            };
            for factor in factors {
                for (_, b) in sizes {
                    let own = &self.values[*b];
                    let (x, y) = (
                        solved((value - half) / factor, own[0].abs()),
                        solved((value + half) / factor, own[0].abs()),
                    );
                    let (x, y) = (x.min(y), x.max(y));
                    let from = sizes.partition_point(|(size, _)| *size < x * (1.0 - 1e-9));
                    for (size, a) in &sizes[from..] {
                        if *size > y * (1.0 + 1e-9) {
                            break;
                        }
                        let fits =
                            shown.iter().zip(self.values[*a].iter().zip(own)).all(|(shown, (a, b))| {
                                shown.is_none_or(|(value, half)| {
                                    (value.abs() - factor * of(a.abs(), b.abs()).abs()).abs()
                                        <= 1.000_001 * half
                                })
                            });
                        if fits && a != b {
                            return Some(format!(
                                "{what} of {} and {}",
                                self.known[*a].name, self.known[*b].name
                            ));
                        }
                    }
                }
            }
        }
        None
    }

    /// Numbers whose first value is between these, by size.
    fn between(&self, from: f64, to: f64) -> Vec<usize> {
        let (low, high) = (mantissa(from.max(f64::MIN_POSITIVE)), mantissa(to));
        let part = |low: f64, high: f64| {
            let begin = self.digits.partition_point(|(m, _)| *m < low - 1e-12);
            let end = self.digits.partition_point(|(m, _)| *m <= high + 1e-12);
            self.digits[begin.min(end)..end].iter().map(|(_, k)| *k).collect::<Vec<_>>()
        };
        if from <= 0.0 {
            part(0.0, 1.0)
        } else if low <= high {
            part(low, high)
        } else {
            [part(low, 1.0), part(0.0, high)].concat()
        }
    }
}

/// Where a number's digits begin, from 0 to 1: the same for 12.3 and 0.00123.
fn mantissa(value: f64) -> f64 {
    let power = value.abs().log10();
    power - power.floor()
}
