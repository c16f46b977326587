//! Check of tests that stages drive: whether nodes were moved slowly enough.

use crate::evidence::Evidence;
use crate::run::damped;
use tremolite_results::{TrustLine, said};

/// Work that the damping takes on the way to rest, over that of what is moved. Largest force of the L-shaped panel, 14 steps to twice the
/// way of its peak: in elements of 25 mm 0.50 (40 cycles of release) is 2.2 % off, 0.045 (200) 0.15 %, beside 0.006; in elements of 10 mm 1.5 is
/// 0.6 % off and 0.42 0.9 %, 0.14 less than 0.1 %, beside 0.05.
const MOST: f64 = 0.2;
const ID: &str = "damped_on_the_way";

pub(super) fn line(evidence: &Evidence) -> TrustLine {
    let name = said!("work that damping took on the way to rest over the work of what stages moved");
    let Some((work, damped)) = damped(&evidence.outcome.state.observers) else {
        return TrustLine::not_applicable(ID, name, said!("no stage moved anything"));
    };
    TrustLine::at_most(ID, name, damped / work, MOST, "").with("work", work).with("damped", damped).with_note(said!(
        "what is moved too fast for a mesh pulls harder than at rest, and cracks beside its crack: more `release_cycles`, of which a \
         step that moves nodes takes five times as many"
    ))
}
