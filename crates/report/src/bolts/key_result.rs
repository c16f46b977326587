//! The bolt that carries most, as a key result.

use tremolite_results::{BoltSummary, Summary};

use crate::language::say;
use crate::quantities::scale::{count, figures};
use crate::quantities::units::Kind;
use crate::source::Source;

/// The bolt nearest to yield of all groups, or where none yields the one with the largest force: the value and what it is.
pub fn hardest(source: &Source, facts: &Summary) -> Option<(String, String)> {
    let language = source.language;
    let there = facts.parts.bolts.iter().filter(|(_, group)| group.largest.bolt > 0);
    let load = |group: &BoltSummary| (group.force_over_yield, group.largest.force.abs());
    let more = |a: &BoltSummary, b: &BoltSummary| {
        let ((over_a, force_a), (over_b, force_b)) = (load(a), load(b));
        over_a.total_cmp(&over_b).then(force_a.total_cmp(&force_b))
    };
    let (name, group) = there.max_by(|a, b| more(a.1, b.1))?;
    let bolt = group.largest.bolt;
    let which = match group.yield_force.is_finite() {
        // Of reinforcement each row of elements has a chain of bars.
        true if group.bars => say!(
            language,
            "{share} of yield, in the reinforcement {group}, row {row}",
            share = figures(group.force_over_yield, 2),
            group = name,
            row = bolt
        ),
        false if group.bars => say!(language, "reinforcement {group}, row {row}", group = name, row = bolt),
        true => say!(
            language,
            "{share} of yield, in {group}, bolt {bolt}",
            share = figures(group.force_over_yield, 2),
            group = name,
            bolt = bolt
        ),
        false => say!(language, "{group}, bolt {bolt}", group = name, bolt = bolt),
    };
    let yielded: u64 = facts.parts.bolts.values().map(|group| group.yielded).sum();
    let all: u64 = facts.parts.bolts.values().map(|group| group.bolts).sum();
    let note = match yielded {
        0 => which,
        _ => say!(
            language,
            "{which}; {yielded} of {all} bolts yielded",
            which = which,
            yielded = count(yielded),
            all = count(all)
        ),
    };
    Some((source.quantity(Kind::Force, group.largest.force), note))
}
