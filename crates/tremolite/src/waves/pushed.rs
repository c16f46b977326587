//! What the waves of a field push a piece of a boundary with.

use super::rows::Term;
use super::series::Series;
use super::stacks::{Stack, Stacking};
use std::collections::HashMap;
use std::sync::Arc;
use tremolite_engine::courses::{Asked, Courses};
use tremolite_engine::free_field::{Place, Pushes};

/// Stacks of which series are kept, of one wave.
pub struct Known {
    pub numbers: HashMap<Vec<i64>, u32>,
    pub rows: Courses,
}

/// One wave of a field, as a piece of a boundary asks for it.
pub struct Source {
    pub series: Arc<Series>,
    pub known: Arc<Known>,
    pub stacking: Stacking,
    /// When the series begin, on the time of the model \[s\], where the wave is not later.
    pub start: f64,
}

/// A point of which no series is kept.
struct Alone {
    late: f64,
    term: Term,
}

/// What a piece reads of one wave.
struct Read {
    series: Arc<Series>,
    known: Arc<Known>,
    start: f64,
    sums: Vec<Asked>,
    alone: Vec<Alone>,
}

/// All forces of a piece.
pub struct Pushed {
    reads: Vec<Read>,
    /// Place after place, which of what is read, all waves' one after another, and how much of it.
    shares: Vec<(u32, f64)>,
    ends: Vec<u32>,
}

/// Where what is read is kept while the piece is made.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Sum(u32),
    Alone,
}

impl Pushed {
    pub fn new(sources: Vec<Source>, places: &[&Place]) -> Pushed {
        let mut of_places: Vec<Vec<(u32, f64)>> = vec![Vec::new(); places.len()];
        let mut reads = Vec::with_capacity(sources.len());
        let mut first = 0;
        for source in sources {
            let mut found: Vec<(Kind, i64, Stack)> = Vec::new();
            let mut numbers: HashMap<(Vec<i64>, i64), usize> = HashMap::new();
            let mut shares: Vec<(usize, usize, f64)> = Vec::new();
            let mut read = |place: usize, kind: Kind, stack: Stack| {
                let (late, size) = (stack.late_key(), stack.size);
                let number = *numbers.entry((stack.key.clone(), late)).or_insert_with(|| {
                    found.push((kind, late, stack));
                    found.len() - 1
                });
                shares.push((place, number, size));
            };
            for (k, place) in places.iter().enumerate() {
                let known = |stack: &Stack| source.known.numbers.get(&stack.key).copied();
                let Some(whole) = source.stacking.whole(place) else { continue };
                if let Some(number) = known(&whole) {
                    read(k, Kind::Sum(number), whole);
                    continue;
                }
                for stack in source.stacking.of(place) {
                    match known(&stack) {
                        Some(number) => read(k, Kind::Sum(number), stack),
                        None => stack.points().into_iter().for_each(|point| read(k, Kind::Alone, point)),
                    }
                }
            }
            // One series after another, and each as time goes.
            let mut order: Vec<usize> = (0..found.len()).collect();
            order.sort_by_key(|&k| (found[k].0, found[k].1));
            let mut place = vec![0; found.len()];
            order.iter().enumerate().for_each(|(to, &from)| place[from] = first + to as u32);
            shares.iter().for_each(|&(k, number, size)| of_places[k].push((place[number], size)));
            first += found.len() as u32;
            let (mut sums, mut alone) = (Vec::new(), Vec::new());
            for &k in &order {
                let (kind, _, stack) = &found[k];
                match kind {
                    Kind::Sum(number) => sums.push(Asked { number: *number, late: stack.late }),
                    Kind::Alone => alone.push(Alone { late: stack.late, term: stack.terms[0].clone() }),
                }
            }
            let Source { series, known, start, .. } = source;
            reads.push(Read { series, known, start, sums, alone });
        }
        let mut all = Pushed { reads, shares: Vec::new(), ends: Vec::new() };
        for of_place in of_places {
            all.shares.extend(of_place);
            all.ends.push(all.shares.len() as u32);
        }
        all
    }
}

impl Pushes for Pushed {
    fn forces(&self, time: f64, out: &mut [[f64; 3]]) {
        let count = self.reads.iter().map(|read| read.sums.len() + read.alone.len()).sum();
        let mut rows = vec![[0.0; 4]; count];
        let mut rest = &mut rows[..];
        for Read { series, known, start, sums, alone } in &self.reads {
            let place = (time - start) / series.dt();
            let (of_sums, others) = std::mem::take(&mut rest).split_at_mut(sums.len());
            known.rows.read(sums, place, of_sums);
            let (of_alone, others) = others.split_at_mut(alone.len());
            for (force, Alone { late, term }) in of_alone.iter_mut().zip(alone) {
                let stress = series.stress_of(term.height, place - late);
                for (of, s) in term.of.iter().zip(stress) {
                    (0..4).for_each(|i| force[i] += s * of[i]);
                }
            }
            rest = others;
        }
        let mut begin = 0;
        for (out, &end) in out.iter_mut().zip(&self.ends) {
            let mut sum = [0.0; 4];
            for &(k, size) in &self.shares[begin..end as usize] {
                let row = &rows[k as usize];
                (0..4).for_each(|i| sum[i] += size * row[i]);
            }
            *out = [sum[0], sum[1], sum[2]];
            begin = end as usize;
        }
    }

    fn bytes(&self) -> usize {
        let of = |read: &Read| size_of_val(&read.sums[..]) + size_of_val(&read.alone[..]);
        let reads: usize = self.reads.iter().map(of).sum();
        reads + size_of_val(&self.shares[..]) + size_of_val(&self.ends[..])
    }
}
