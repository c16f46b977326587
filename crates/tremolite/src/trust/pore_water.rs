//! Checks of water that cannot leave its pores: whether it stays in what is modelled of it.

use crate::evidence::Evidence;
use crate::observers::{PoreWaterSeen, undrained};
use tremolite_results::{Fact, Said, TrustLine, said};

/// Share of the volume of wet ground up to which an assumption may fail: a hundredth is next to openings alone.
const SHARE: f64 = 0.01;
const FLOOR: &str = "pore_water_at_the_floor";
const OPEN: &str = "pore_water_above_the_least_pressure";

pub(super) fn lines(evidence: &Evidence) -> Vec<TrustLine> {
    if evidence.plan.water { vec![floor(evidence), open(evidence)] } else { Vec::new() }
}

fn seen(evidence: &Evidence) -> Result<PoreWaterSeen, Said> {
    PoreWaterSeen::recall(&evidence.outcome.state.observers)
        .ok_or_else(|| said!("pressures stay as the stages leave them"))
}

/// Where the pressure came down to that at which water boils.
fn floor(evidence: &Evidence) -> TrustLine {
    let name = said!("wet ground whose water boils");
    match seen(evidence) {
        Err(why) => TrustLine::not_applicable(FLOOR, name, why),
        Ok(PoreWaterSeen { floor, pressures: [least, most], .. }) => {
            TrustLine::at_most(FLOOR, name, floor.share, SHARE, "")
                .with("time", floor.time)
                .with("least", least)
                .with("most", most)
                .with_note(said!(
                    "largest share of the volume of wet ground at −100 kPa, at {time} s; pressures lie between {least} and {most} MPa. What \
                     happens once water has boiled is not modelled",
                    time = format!("{:.3}", floor.time),
                    least = format!("{:.3}", least / 1e6),
                    most = format!("{:.3}", most / 1e6),
                ))
        }
    }
}

/// Where the pressure exceeds the least total pressure.
fn open(evidence: &Evidence) -> TrustLine {
    let name = said!("wet ground in which water exceeds the least pressure");
    match seen(evidence) {
        Err(why) => TrustLine::not_applicable(OPEN, name, why),
        Ok(PoreWaterSeen { open, .. }) => TrustLine::at_most(OPEN, name, open.share, SHARE, "")
            .with("time", open.time)
            .with_note(said!(
                "largest share of the volume of wet ground with an effective principal stress in tension, at {time} s: water would open cracks \
                 there and flow into them, which is not modelled",
                time = format!("{:.3}", open.time),
            )),
    }
}

/// How much of the ground it is.
pub(super) fn fact(evidence: &Evidence) -> Option<Fact> {
    let count = undrained(evidence.model).count();
    (count > 0).then(|| {
        Fact::new(
            "undrained_elements",
            said!("elements whose water cannot leave in the earthquake"),
            count as f64,
            "",
            said!(
                "they had water in their pores when it began; which of drained and undrained moves a lining more depends on the case: run it \
                 with [water] earthquake = \"drained\" as well"
            ),
        )
    })
}
