//! How wide the cracks of a lining were, in a phrase: across bars, by which limits go, and parallel to the wall.

use tremolite_results::{Cracks, Finding, Opened, Summary};

use crate::damage::{direction, told};
use crate::language::say;
use crate::source::Source;

/// The widest cracks of a finding's lining; nothing where it tells no width.
pub fn widest(source: &Source, facts: &Summary, finding: &Finding) -> Option<String> {
    let language = source.language;
    let opening = finding.numbers.get("crack_opening").copied().filter(|x| x.is_finite())?;
    let cracks: Option<&Cracks> =
        facts.parts.damage.get(&finding.group).and_then(|group| group.cracks.as_ref());
    let open = |of: &&Opened| of.widest.is_some();
    let across = cracks.and_then(|cracks| cracks.across()).filter(open);
    let parallel = cracks.and_then(|cracks| cracks.parallel()).filter(open);
    Some(match (across, parallel) {
        // Files of older versions do not tell which way cracks run.
        (None, None) => say!(language, "widest crack {opening}", opening = told(source, opening)),
        (Some(across), None) => say!(
            language,
            "widest crack {opening}, {direction}",
            opening = told(source, across.opening),
            direction = direction(language, across.direction)
        ),
        (None, Some(parallel)) => say!(
            language,
            "widest crack {opening}, parallel to the wall; none across bars",
            opening = told(source, parallel.opening)
        ),
        (Some(across), Some(parallel)) => say!(
            language,
            "widest crack across bars {across} ({direction}), parallel to the wall {parallel}",
            across = told(source, across.opening),
            direction = direction(language, across.direction),
            parallel = told(source, parallel.opening)
        ),
    })
}
