//! The waves of a field, and what is at hand of them for the places of a model.

use super::heading::Heading;
use super::heights::Heights;
use super::pushed::Known;
use super::rows::{Term, rows};
use super::series::Series;
use super::stacks::{Stack, Stacking};
use std::cmp::Reverse;
use std::collections::HashMap;
use std::sync::Arc;
use tremolite_engine::courses::{self, Courses};
use tremolite_engine::free_field::Place;

/// One wave.
pub struct OneWave {
    pub heading: Heading,
    /// p h \[s/m\]
    pub slowness: [f64; 2],
    /// Where in plan it is not later \[m\].
    pub at: [f64; 2],
    /// Of the ground, and its height \[m\].
    pub base: f64,
    pub height: f64,
    pub series: Arc<Series>,
}

impl OneWave {
    /// Displacement \[m\] at a height \[m\] above the base, so many samples after the first.
    pub fn displacement(&self, height: f64, place: f64) -> [f64; 4] {
        let found = self.series.displacement_of(height, place);
        let mut u = [0.0; 4];
        for (of, x) in self.heading.motion().iter().zip(found) {
            (0..4).for_each(|i| u[i] += x * of[i]);
        }
        u
    }

    /// With what stacks are found.
    pub fn stacking(&self) -> Stacking {
        Stacking {
            stress: self.heading.stress(),
            slowness: self.slowness.map(|p| p / self.series.dt()),
            at: self.at,
            base: self.base,
            height: self.height,
        }
    }
}

/// Memory for what is at hand of a wave: so many times that of its series, or so many bytes where that is little. What is needed most often
/// comes first, and the rest is found from the series.
const MOST: usize = 2;
const SMALL: usize = 64 << 20;

/// What is at hand.
pub struct Prepared {
    /// Above the base, where motion is asked for.
    heights: Heights,
    /// Of each wave displacements there, and what pushes places.
    motion: Vec<Courses>,
    pushes: Vec<Arc<Known>>,
}

impl Prepared {
    /// For the places of a model.
    pub fn of(waves: &[OneWave], places: &[&Place]) -> Prepared {
        let room = |wave: &OneWave| (MOST * wave.series.bytes()).max(SMALL);
        let sums = |bytes: usize, wave: &OneWave| bytes / courses::bytes(1, wave.series.samples());
        // One list of heights for all waves, as long as the least of their memory allows.
        let most = waves.iter().map(|wave| sums(room(wave) / 2, wave)).min().unwrap_or(0);
        let heights = waves.first().map_or_else(Vec::new, |wave| {
            let above: Vec<f64> = places.iter().map(|place| place.at[2] - wave.base).collect();
            frequent(&above, wave.height, most)
        });
        let heights = Heights::new(heights, waves.first().map_or(0.0, |wave| wave.height));
        let (mut motion, mut pushes) = (Vec::new(), Vec::new());
        for wave in waves {
            let of = wave.heading.motion();
            let term = |&height: &f64| [Term { behind: 0.0, height, of }];
            let terms: Vec<[Term; 1]> = heights.all().iter().map(term).collect();
            let own = rows(&wave.series, false, &terms.iter().map(|term| &term[..]).collect::<Vec<_>>());
            let left = sums(room(wave) - own.bytes(), wave);
            motion.push(own);
            pushes.push(Arc::new(known(wave, places, left)));
        }
        Prepared { heights, motion, pushes }
    }

    /// Which of the heights at hand, above the base, one is.
    pub fn height(&self, height: f64) -> Option<u32> {
        self.heights.find(height).map(|number| number as u32)
    }

    /// Displacements of a wave at the heights.
    pub fn motion(&self, wave: usize) -> &Courses {
        &self.motion[wave]
    }

    /// Wave by wave.
    pub fn pushes(&self) -> &[Arc<Known>] {
        &self.pushes
    }

    /// What it takes of memory.
    pub fn bytes(&self) -> usize {
        let motion: usize = self.motion.iter().map(Courses::bytes).sum();
        motion + self.pushes.iter().map(|known| known.rows.bytes()).sum::<usize>()
    }
}

/// The most frequent of some heights, so many at most.
fn frequent(heights: &[f64], size: f64, most: usize) -> Vec<f64> {
    let all = Heights::new(heights.to_vec(), size);
    let mut counts: Vec<(usize, f64)> = all.all().iter().map(|&height| (0, height)).collect();
    heights.iter().filter_map(|&height| all.find(height)).for_each(|k| counts[k].0 += 1);
    counts.sort_by_key(|(count, _)| Reverse(*count));
    counts.truncate(most);
    counts.into_iter().map(|(_, height)| height).collect()
}

/// Places that are pushed alike from which on one course for all that pushes them goes before courses that others share: a place asks for four
/// of those on a side, and for up to sixteen at the base.
const ALIKE: usize = 4;

/// Stacks that are alike, and how many points and places they stand for.
struct Alike {
    stack: Stack,
    points: usize,
    places: usize,
}

/// Those of some stacks that are not known, each once, those first that stand for most points: in an order of the whole model, so that ranks
/// which have parts of it keep the same.
fn alike(stacks: impl Iterator<Item = Stack>, known: &HashMap<Vec<i64>, u32>) -> Vec<Alike> {
    let mut numbers: HashMap<Vec<i64>, usize> = HashMap::new();
    let mut found: Vec<Alike> = Vec::new();
    for stack in stacks.filter(|stack| !known.contains_key(&stack.key)) {
        let points = stack.terms.len();
        match numbers.get(&stack.key) {
            Some(&k) => {
                found[k].points += points;
                found[k].places += 1;
            }
            None => {
                numbers.insert(stack.key.clone(), found.len());
                found.push(Alike { stack, points, places: 1 });
            }
        }
    }
    found.sort_by_key(|alike| Reverse(alike.points));
    found
}

/// The stacks of places of which courses are kept, so many at most: all that pushes a place, where there is room for that or many places are
/// pushed alike, and for the others what is pushed together.
pub fn known(wave: &OneWave, places: &[&Place], most: usize) -> Known {
    let stacking = wave.stacking();
    let mut numbers: HashMap<Vec<i64>, u32> = HashMap::new();
    let mut kept: Vec<Stack> = Vec::new();
    let mut keep = |all: Vec<Alike>, numbers: &mut HashMap<Vec<i64>, u32>| {
        for Alike { stack, .. } in all.into_iter().take(most - kept.len()) {
            numbers.insert(stack.key.clone(), kept.len() as u32);
            kept.push(stack);
        }
    };
    let whole = |place: &&Place| stacking.whole(place);
    let mut wholes = alike(places.iter().filter_map(whole), &numbers);
    if wholes.len() > most {
        wholes.retain(|alike| alike.places >= ALIKE);
    }
    keep(wholes, &mut numbers);
    let rest = places.iter().filter(|place| whole(place).is_some_and(|own| !numbers.contains_key(&own.key)));
    let rest = alike(rest.flat_map(|place| stacking.of(place)), &numbers);
    keep(rest, &mut numbers);
    let terms: Vec<&[Term]> = kept.iter().map(|stack| &stack.terms[..]).collect();
    let rows = rows(&wave.series, true, &terms);
    Known { numbers, rows }
}
