//! What bolts do, bolt by bolt, and what is told of their groups.

mod groups;

pub use groups::{bolts, findings, monitors, together, warnings};

use crate::quantities::over_yield;
use tremolite_engine::bolts::{Bolt, BoltSet, SegmentSeen, SegmentState};
use tremolite_engine::{Assembly, Stage};

/// Looks at the segments of a bolt: of a set of the model by its number, of a bolt by its number in the set.
pub type Look<'a> = dyn Fn(usize, usize) -> Vec<SegmentSeen> + 'a;

/// Looks at the bolts of an assembly in the numbers of a state.
pub fn look<'a>(
    assembly: &'a Assembly,
    numbers: &'a [f64],
) -> impl Fn(usize, usize) -> Vec<SegmentSeen> + 'a {
    |set, bolt| assembly.bolts[set].seen(numbers, bolt)
}

/// What a state is called in tables.
pub const fn word(state: SegmentState) -> &'static str {
    match state {
        SegmentState::Elastic => "elastic",
        SegmentState::Slid => "slid",
        SegmentState::Yielded => "yielded",
        SegmentState::Broken => "broken",
        SegmentState::CutOff => "cut-off",
    }
}

/// A bolt at one time. What an excavation has cut off it counts nowhere but in `cut_off` and `state`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BoltSeen {
    /// The force of largest size along it \[N\], tension positive, and where \[m\].
    pub force: f64,
    pub place: [f64; 3],
    /// Size of the force over what it yields at, at most along the bolt; 0 where it never yields.
    pub over_yield: f64,
    /// The same of any step since the stage, or the shaking, began.
    pub largest_force: f64,
    pub largest_place: [f64; 3],
    pub largest_over_yield: f64,
    /// Largest size of the slip in any step since it was placed \[m\].
    pub slip: f64,
    /// The worst state of what is left; cut off where nothing is.
    pub state: SegmentState,
    /// Whether any segment that is left slid, yielded or broke.
    pub slid: bool,
    pub yielded: bool,
    pub broken: bool,
    /// m
    pub cut_off: f64,
}

impl BoltSeen {
    /// Of what its segments do.
    pub fn of(bolt: &Bolt, segments: &[SegmentSeen]) -> Self {
        let mut all = BoltSeen::default();
        let mut left = false;
        // Beyond the size that was largest so far. What is not a number is larger than all, so that it shows.
        let more = |now: f64, so_far: f64| now > so_far || (now.is_nan() && !so_far.is_nan());
        for (k, seen) in segments.iter().enumerate() {
            if seen.state == SegmentState::CutOff {
                all.cut_off += bolt.segments[k].length;
                continue;
            }
            if !left || more(seen.force.abs(), all.force.abs()) {
                (all.force, all.place) = (seen.force, bolt.middle(k));
            }
            if !left || more(seen.largest_force.abs(), all.largest_force.abs()) {
                (all.largest_force, all.largest_place) = (seen.largest_force, bolt.middle(k));
            }
            all.over_yield = all.over_yield.max(over_yield(seen.force, seen));
            all.largest_over_yield = all.largest_over_yield.max(over_yield(seen.largest_force, seen));
            all.slip = all.slip.max(seen.largest_slip);
            all.state = all.state.max(seen.state);
            all.slid |= seen.slid;
            all.yielded |= seen.state == SegmentState::Yielded || seen.plastic_strain != 0.0;
            all.broken |= seen.state == SegmentState::Broken;
            left = true;
        }
        if !left && all.cut_off > 0.0 {
            all.state = SegmentState::CutOff;
        }
        all
    }
}

/// Every bolt of every set; of sets that are not placed yet in a stage, none.
pub fn seen(sets: &[BoltSet], stage: Stage, look: &Look) -> Vec<Vec<BoltSeen>> {
    let of_set = |(s, set): (usize, &BoltSet)| {
        let all = if set.kind.born <= stage { &set.bolts[..] } else { &[] };
        all.iter().enumerate().map(|(b, bolt)| BoltSeen::of(bolt, &look(s, b))).collect()
    };
    sets.iter().enumerate().map(of_set).collect()
}

#[cfg(test)]
pub(crate) mod tests;
