//! Figure of a record that was deconvolved beside what the run made of it at its place.

use crate::chapter::figure::Figure;
use crate::drawing::chart::{Chart, Curve, Mark, Panel, Stroke};
use crate::free_field::numbers::{AXES, interpolated, percent};
use crate::language::say;
use crate::quantities::units::Kind;
use crate::script::curves::Curves;
use crate::source::Source;

/// Of a monitor with this name, the free field at its own level stands where that at the place of the record would.
const RECORD: &str = "record";

/// The figure; nothing where no record was deconvolved through the model's own ground. `given` are the velocities of the record
/// that are more than round-off, by axis, at the times of motion.csv.
pub fn figure(source: &Source, given: &[(usize, &[f64])]) -> Option<Figure> {
    let language = source.language;
    let (Some(Ok(motion)), Some(Ok(found))) = (&source.motion, &source.free_field) else { return None };
    let facts = source.facts();
    facts
        .computed
        .motion
        .deconvolved
        .as_ref()
        .filter(|_| !facts.monitors.monitor_positions.contains_key(RECORD))?;
    let time = motion.column("time")?;
    let panel = |&(axis, values): &(usize, &[f64])| {
        let own = &found.record[axis];
        own.iter().any(|x| x.is_finite()).then(|| Panel {
            title: say!(language, "velocity along {axis}", axis = AXES[axis]),
            scale: source.scale(Kind::Velocity),
            lines: vec![
                Curve {
                    name: say!(language, "record"),
                    values: interpolated(time, values, &found.time).into(),
                    colour: 5,
                    stroke: Stroke::Broad,
                },
                Curve {
                    name: say!(language, "free field where it was taken"),
                    values: own.into(),
                    colour: 0,
                    stroke: Stroke::Thin,
                },
            ],
            // Between samples the record holds no number.
            mark: Mark::Nothing,
        })
    };
    let panels: Vec<Panel> = given.iter().filter_map(panel).collect();
    if panels.is_empty() {
        return None;
    }
    let heading = say!(language, "The record, and the computed motion where it was taken");
    let mut caption = say!(
        language,
        "Broad is the record on the time of the run, thin how the free field moved at its place: the layered ground beside the model, \
         into which the wave went. The thin line should lie on the broad one."
    );
    let check =
        facts.soundness.checks.iter().find(|line| line.id == "record_at_its_place" && !line.not_applicable);
    if let Some(check) = check {
        caption.push_str(&say!(
            language,
            " They differ by at most {share} of the record's peak (check 'computed motion at the record's place against the record').",
            share = percent(check.value)
        ));
    }
    caption.push_str(&say!(
        language,
        " Differences come from the mesh, from rock that yields, or from what was left out above the record's band."
    ));
    let chart = Chart { title: heading.clone(), time: &found.time, panels };
    let (svg, curves) = (chart.draw(language), Some(Curves::of_chart(&chart, language)));
    Some(Figure { heading, file: "record.svg".into(), svg, caption, curves, narrow: None })
}
