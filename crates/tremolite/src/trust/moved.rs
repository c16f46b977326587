//! Check of tests that stages drive: whether nodes were moved slowly enough.

use crate::evidence::Evidence;
use crate::moved::{damped, first_step, let_go};
use crate::plan::Plan;
use tremolite_engine::state::Memory;
use tremolite_results::{TrustLine, said};

/// Work that the damping takes on the way to rest, over that of what is moved. Largest force of the L-shaped panel, 14 steps to twice the
/// way of its peak: in elements of 25 mm 0.50 (40 cycles of release) is 2.2 % off, 0.045 (200) 0.15 %, beside 0.006; in elements of 10 mm 1.5 is
/// 0.6 % off and 0.42 0.9 %, 0.14 less than 0.1 %, beside 0.05.
const MOST: f64 = 0.2;
const ID: &str = "relaxation_damping_share";

/// Share of the energy held that a step lets go at once. Bars of 0.65 and 0.87 times the length that may be let go 4·10⁻⁵ and 2·10⁻⁴, one of 1.5
/// times it 0.04.
const MOST_LET_GO: f64 = 0.02;
const LET_GO_ID: &str = "energy_drop_in_step";
/// Share of the first step's work that cracks take: what is measured against that step would hide in it.
const MOST_FIRST: f64 = 0.01;
const FIRST_ID: &str = "first_step_dissipation";

pub(super) fn lines(evidence: &Evidence) -> Vec<TrustLine> {
    of_stages(evidence.plan, &evidence.outcome.state.observers)
}

/// The same of what is remembered of stages.
pub(super) fn of_stages(plan: &Plan, memory: &Memory) -> Vec<TrustLine> {
    vec![slow(memory), first(memory), snap(plan, memory)]
}

fn first(memory: &Memory) -> TrustLine {
    let name = said!("share of the first loading step's work that was dissipated");
    match first_step(memory) {
        None => TrustLine::not_applicable(FIRST_ID, name, said!("no stage moved anything")),
        Some(share) => TrustLine::at_most(FIRST_ID, name, share, MOST_FIRST, "").with_note(said!(
            "the first step should be elastic: what later steps lose is counted beyond what it did, and a peak within a step is cut; take more `steps`"
        )),
    }
}

fn snap(plan: &Plan, memory: &Memory) -> TrustLine {
    let name = said!("largest share of the stored energy released in one step");
    match let_go(memory) {
        None => TrustLine::not_applicable(LET_GO_ID, name, said!("no stage moved anything twice")),
        Some((share, stage)) => {
            let line =
                TrustLine::at_most(LET_GO_ID, name, share, MOST_LET_GO, "").with("stage", stage as f64);
            let told = &plan.stages[stage].name;
            if line.pass {
                return line;
            }
            line.with_note(said!(
                "in the stage '{stage}': the specimen snapped back there, and the force fell along no states at rest",
                stage = told,
            ))
        }
    }
}

fn slow(memory: &Memory) -> TrustLine {
    let name = said!("work dissipated by relaxation damping over work of the prescribed displacements");
    let Some((work, damped)) = damped(memory) else {
        return TrustLine::not_applicable(ID, name, said!("no stage moved anything"));
    };
    let line = TrustLine::share_at_most(ID, name, [damped, work], MOST, said!("no stage moved anything"));
    if line.not_applicable {
        return line;
    }
    line.with("work", work).with("damped", damped).with_note(said!(
        "what is moved too fast for a mesh pulls harder than at rest, and cracks beside its crack: more `release_cycles`, of which a \
         step that moves nodes takes five times as many"
    ))
}
