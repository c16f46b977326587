//! When something is there: stages before the earthquake, then the shaking.

use std::ops::Range;
pub use tremolite_kernels::Stage;

/// From which stage on something is there, and from which on it is gone.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Life {
    pub born: Stage,
    /// Never if none.
    pub gone: Option<Stage>,
}

impl Life {
    /// From the first stage to the end.
    pub const ALWAYS: Life = Life { born: Stage::Before(0), gone: None };
    /// In the earthquake alone.
    pub const SHAKING: Life = Life { born: Stage::Shaking, gone: None };

    /// Before the earthquake alone.
    pub const BEFORE: Life = Life { born: Stage::Before(0), gone: Some(Stage::Shaking) };

    /// The time in which both are there.
    pub fn and(&self, other: &Life) -> Life {
        let gone = match (self.gone, other.gone) {
            (Some(a), Some(b)) => Some(a.min(b)),
            (a, b) => a.or(b),
        };
        Life { born: self.born.max(other.born), gone }
    }

    /// As numbers that ascend with the stages: from the first on, and until before the second.
    pub fn times(&self) -> Range<u32> {
        let number = |stage: Stage| match stage {
            Stage::Before(k) => u32::from(k),
            Stage::Shaking => u32::from(u16::MAX) + 1,
        };
        number(self.born)..self.gone.map_or(u32::MAX, number)
    }

    /// Whether it begins after the model does.
    pub fn is_later(&self) -> bool {
        self.born > Stage::Before(0)
    }

    /// Whether it is there in a stage.
    pub fn holds(&self, stage: Stage) -> bool {
        self.born <= stage && self.gone.is_none_or(|gone| stage < gone)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_life_begins_with_its_stage_and_ends_before_the_one_that_takes_it() {
        let bench = Life { born: Stage::Before(0), gone: Some(Stage::Before(2)) };
        let stages = [Stage::Before(0), Stage::Before(1), Stage::Before(2), Stage::Shaking];
        assert_eq!(stages.map(|stage| bench.holds(stage)), [true, true, false, false]);
        assert_eq!(stages.map(|stage| Life::SHAKING.holds(stage)), [false, false, false, true]);
        assert!(stages.iter().all(|&stage| Life::ALWAYS.holds(stage)));
    }
}
