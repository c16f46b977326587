//! The interfaces of an assembly: their laws, and what their pairs remember.

use crate::interface::Seam;
use crate::life::Stage;
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Arc;
use tremolite_kernels::AnyInterface;
use tremolite_kernels::contact::PairSeen;
use tremolite_laws::Octet;

/// Pairs that a thread takes at once, a few microseconds of work.
const PIECE: usize = 1024;

/// An interface with its law, ready to be looked at.
#[derive(Clone)]
pub struct Contacts {
    pub law: Arc<dyn AnyInterface>,
    /// Whether the law's stiffness was chosen.
    pub chosen: bool,
    /// Of each pair of [`Seam::pairs`], which of the interface's members it is in, and its place there.
    pub(crate) places: Vec<(u32, u32)>,
    /// Where the histories of these members lie, and which of the assembly they are.
    pub(crate) histories: Vec<Range<usize>>,
    /// The same in what this process holds; none of members of other ranks.
    pub(crate) held: Vec<Option<Range<usize>>>,
    pub(crate) members: Vec<u32>,
    /// Pairs that begin under load: pair, m, pressure and shear t \[Pa\].
    pub(crate) loaded: Vec<LoadedPair>,
    /// Largest ω_c of its pairs \[rad/s\], and that pair.
    pub frequency: f64,
    pub stiffest_pair: usize,
}

/// A pair that begins under load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LoadedPair {
    pub pair: u32,
    pub normal: [f64; 3],
    /// Pressure, and shear t on the second side along the tangents \[Pa\].
    pub traction: [f64; 3],
}

impl Contacts {
    /// The number of the member that a pair is in.
    pub(crate) fn member_of(&self, pair: usize) -> usize {
        self.members[self.places[pair].0 as usize] as usize
    }

    /// Gives pairs that begin under load their first memory.
    pub(crate) fn begin(&self, history: &mut [Octet]) {
        self.loaded.iter().for_each(|loaded| self.load(history, loaded, [0.0; 3]));
    }

    /// Gives a pair its first memory, of the load that it begins with where its relative displacement is `d` \[m\], if this process has it.
    pub(crate) fn load(&self, history: &mut [Octet], loaded: &LoadedPair, d: [f64; 3]) {
        let &LoadedPair { pair, normal, traction: [pressure, t1, t2] } = loaded;
        let (chunk, at) = self.places[pair as usize];
        if let Some(held) = &self.held[chunk as usize] {
            self.law.load(&mut history[held.clone()], at as usize, d, normal, pressure, [t1, t2]);
        }
    }

    /// A pair as it was when it was evaluated last, from the histories of all members.
    pub fn seen(&self, history: &[Octet], pair: usize) -> PairSeen {
        let (chunk, at) = self.places[pair];
        self.law.seen(&history[self.histories[chunk as usize].clone()], at as usize)
    }

    /// The first of the pairs that last whose gap \[m\] is below `gap` and that this process has, from its own histories: its number, and how it is.
    pub fn first_below(&self, seam: &Seam, history: &[Octet], gap: f64) -> Option<(usize, PairSeen)> {
        let held = |pair: usize| {
            let (chunk, at) = self.places[pair];
            Some((&history[self.held[chunk as usize].clone()?], at as usize))
        };
        let is_below = |&pair: &usize| {
            seam.lives[pair].holds(Stage::Shaking)
                && held(pair).is_some_and(|(history, at)| self.law.gap(history, at) < gap)
        };
        let pair = (0..self.places.len()).into_par_iter().with_min_len(PIECE).find_first(is_below)?;
        let (history, at) = held(pair)?;
        Some((pair, self.law.seen(history, at)))
    }

    /// Area-weighted sums over the pairs that are there in the shaking.
    pub fn totals(&self, seam: &Seam, history: &[Octet]) -> ContactTotals {
        let mut totals = ContactTotals::default();
        for k in seam.lasting() {
            let (pair, seen) = (&seam.pairs[k], self.seen(history, k));
            let add = |to: &mut f64, counts: bool| *to += if counts { pair.area } else { 0.0 };
            add(&mut totals.sliding, seen.slides);
            add(&mut totals.open, seen.is_open);
            add(&mut totals.ever_slid, seen.has_slid);
            add(&mut totals.ever_opened, seen.has_opened);
            totals.largest_gap = totals.largest_gap.max(seen.largest_gap);
            totals.largest_slip = totals.largest_slip.max(seen.largest_slip);
            totals.largest_pressure = totals.largest_pressure.max(seen.largest_pressure);
            totals.impact_gain += pair.normal_area * seen.impact_gain;
            let straight = self.law.straight_from().unwrap_or(f64::INFINITY);
            totals.beyond += usize::from(seen.largest_pressure > straight);
        }
        totals
    }
}

/// What an interface does as a whole.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactTotals {
    /// Areas \[m²\] that slide and are open now.
    pub sliding: f64,
    pub open: f64,
    /// Areas \[m²\] that ever slid, that ever opened.
    pub ever_slid: f64,
    pub ever_opened: f64,
    /// Over all steps: gap \[m\], slip \[m\] of closed pairs whose bond is broken, pressure \[Pa\].
    pub largest_gap: f64,
    pub largest_slip: f64,
    pub largest_pressure: f64,
    /// Pairs whose pressure went beyond that from which on the law is straight.
    pub beyond: usize,
    /// Energy \[J\] that the trapezoidal rule found or lost at impacts.
    pub impact_gain: f64,
}
