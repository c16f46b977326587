//! What figures of all kinds of law share: which lines there are, and over what.

use std::borrow::Cow;
use tremolite_report::loops::{Course, Curve, Quantity, Track};

/// What varies less than this share of the largest of its kind is round-off.
pub const NEGLIGIBLE: f64 = 1e-6;

/// What tracks run over: time, or steps where it stands still.
pub struct Along<'a> {
    time: Cow<'a, [f64]>,
    stands: bool,
}

impl<'a> Along<'a> {
    pub fn of(time: &'a [f64]) -> Self {
        let stands = time.first() == time.last();
        let steps = || (0..time.len()).map(|i| i as f64).collect();
        Along { time: if stands { Cow::Owned(steps()) } else { time.into() }, stands }
    }

    pub fn quantity(&self) -> Quantity {
        if self.stands { Quantity::new("step", "") } else { Quantity::new("time", "s") }
    }

    pub fn values(&self) -> &[f64] {
        &self.time
    }
}

/// A motion and the stress that works on it, row by row.
pub struct Pair<'a> {
    pub name: &'a str,
    pub colour: usize,
    pub across: &'a [f64],
    pub up: &'a [f64],
}

/// Loops of the pairs of which both vary by more than the noise; equal ones are one line.
pub fn curves<'a>(pairs: impl Iterator<Item = Pair<'a>>, noise: (f64, f64)) -> Vec<Curve<'a>> {
    let mut curves: Vec<Curve<'a>> = Vec::new();
    for Pair { name, colour, across, up } in
        pairs.filter(|p| spread(p.across) > noise.0 && spread(p.up) > noise.1)
    {
        let same = |a: &[f64], b: &[f64], noise: f64| a.iter().zip(b).all(|(a, b)| (a - b).abs() <= noise);
        match curves.iter_mut().find(|c| same(&c.across, across, noise.0) && same(&c.up, up, noise.1)) {
            Some(curve) => curve.name += &format!(" = {name}"),
            None => {
                let name = name.to_owned();
                curves.push(Curve { name, colour, across: across.into(), up: up.into(), points: false });
            }
        }
    }
    curves
}

/// The components over time that vary or, unless they must, are not zero; equal ones are one line.
pub fn courses<'a>(
    quantity: Quantity,
    names: &[&str],
    all: &'a [Vec<f64>],
    must_vary: bool,
) -> Option<Track<'a>> {
    let noise = NEGLIGIBLE * largest(all);
    let mut courses: Vec<Course<'a>> = Vec::new();
    for (k, values) in all.iter().enumerate() {
        let size = if must_vary { spread(values) } else { most(values) };
        if size <= noise {
            continue;
        }
        let same = |c: &Course<'_>| c.values.iter().zip(values).all(|(a, b)| (a - b).abs() <= noise);
        match courses.iter_mut().find(|c| same(c)) {
            Some(course) => course.name += &format!(" = {}", names[k]),
            None => courses.push(Course { name: names[k].to_owned(), colour: k, values }),
        }
    }
    (!courses.is_empty()).then_some(Track { quantity, courses })
}

pub fn most(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, x| f64::max(most, x.abs()))
}

pub fn largest(all: &[Vec<f64>]) -> f64 {
    all.iter().map(|values| most(values)).fold(0.0, f64::max)
}

pub fn spread(values: &[f64]) -> f64 {
    let low = values.iter().copied().fold(f64::INFINITY, f64::min);
    let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if low <= high { high - low } else { 0.0 }
}
