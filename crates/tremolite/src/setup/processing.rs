//! Steps of processing of a case's motion, in their order.

use super::records::Channels;
use super::target;
use tremolite_case::{self as case, Diagnostic};
use tremolite_motion::{Process, TargetSpectrum};

/// The steps of processing of a motion, and what they need.
pub struct Processing<'a> {
    pub motion: &'a case::Motion,
    pub target: Option<&'a TargetSpectrum>,
    pub steps: &'a [Process],
}

impl Processing<'_> {
    /// Applies the first `count` steps. Problems are added at their steps; a match is left out where there are more than `before`.
    pub fn apply(
        &self,
        channels: &mut Channels,
        count: usize,
        problems: &mut Vec<Diagnostic>,
        before: usize,
    ) {
        for (step, word) in self.steps.iter().zip(&self.motion.processing).take(count) {
            if let Process::Match { .. } = step {
                if problems.len() == before {
                    let done = target::matched(self.motion, self.target, step, word, channels);
                    problems.extend(done.err());
                }
            } else if let Err(e) = step.apply(&mut channels.each()) {
                let (message, remedy) = e.message_and_remedy();
                problems.push(Diagnostic::at(word, message, remedy));
            }
        }
    }

    /// The channels after the first `count` steps; nothing where one of them cannot be applied.
    pub fn applied(&self, mut channels: Channels, count: usize) -> Option<Channels> {
        let mut problems = Vec::new();
        self.apply(&mut channels, count, &mut problems, 0);
        problems.is_empty().then_some(channels)
    }

    /// The number of steps in front of the first match; nothing without one.
    pub fn before_match(&self) -> Option<usize> {
        self.steps.iter().position(|step| matches!(step, Process::Match { .. }))
    }
}

/// The steps of processing; those that cannot be read are among the problems.
pub fn steps(motion: &case::Motion, problems: &mut Vec<Diagnostic>) -> Vec<Process> {
    motion
        .processing
        .iter()
        .filter_map(|word| match Process::parse(word) {
            Ok(step) => Some(step),
            Err(message) => {
                // The reader of steps tells their forms behind what is wrong.
                let (what, remedy) = message.split_once("; ").unwrap_or((&message, "see docs/records.md"));
                problems.push(Diagnostic::at(word, what, remedy));
                None
            }
        })
        .collect()
}
