//! Initial stress that the ground can hardly have.

use super::pressure;
use crate::outlook::{AtRest, Outlook};
use tremolite_case::{Case, Diagnostic};

/// Share of the volume that may be in tension, or beyond yield, before anything moves.
const SHARE: f64 = 0.01;
/// Vertical forces out of balance over the weight (an assumption). Level ground and slopes under the weight above have none; an opening that is
/// there from the start adds twice its share of a section.
const IMBALANCE: f64 = 0.25;

/// Of tension and yield under the initial stress, and of walls that it loads beyond their strength.
pub fn of_ground(case: &Case, outlook: &Outlook) -> Vec<Diagnostic> {
    let (Some(given), Some(found)) = (&case.initial.stress, &outlook.at_rest) else { return Vec::new() };
    let AtRest { volume, tension, beyond, largest, wall, imbalance } = found;
    let place = |[x, y, z]: [f64; 3]| format!("({x:.1}, {y:.1}, {z:.1}) m");
    let mut all = Vec::new();
    if let Some((most, at)) = largest.filter(|_| *tension > SHARE * volume) {
        all.push(Diagnostic::new(
            given.span(),
            format!(
                "the initial stress pulls at {:.0} % of the ground, by up to {} at {}",
                100.0 * tension / volume,
                pressure(-most),
                place(at)
            ),
            "stresses are positive in tension: compression is written with a minus, zz = \"-6 MPa\"",
        ));
    }
    if let Some(imbalance) = imbalance.filter(|imbalance| *imbalance > IMBALANCE) {
        all.push(Diagnostic::new(
            given.span(),
            format!(
                "vertical forces out of balance under the initial stress: {:.0} % of the weight (limit {:.0} %). The initial equilibrium \
                 changes the stress as much",
                100.0 * imbalance,
                100.0 * IMBALANCE
            ),
            "let the vertical stress be the weight above: `lateral` in place of `stress`, or `gradient` beside it with the unit weight \
             along zz",
        ));
    }
    if *beyond > SHARE * volume {
        all.push(Diagnostic::new(
            given.span(),
            format!("{:.0} % of the ground lies beyond yield under the initial stress alone", 100.0 * beyond / volume),
            "look at the ratio of horizontal to vertical stress, and at cohesion and friction, which are the rock mass's",
        ));
    }
    if let Some(wall) = wall.as_ref().filter(|wall| wall.load > wall.strength) {
        all.push(Diagnostic::new(
            given.span(),
            format!(
                "the rock round the opening at {} would have to carry {} ({}), {:.1} times its compressive strength of {}: it will yield",
                place(wall.at),
                pressure(-wall.load),
                match wall.extents {
                    Some([width, height]) => format!("elastic, an ellipse of {width:.0} m × {height:.0} m"),
                    None => "elastic, a circle: 3σ1 − σ3".to_owned(),
                },
                wall.load / wall.strength,
                pressure(-wall.strength)
            ),
            "if no yielding is expected, check cohesion and friction; otherwise use elements there that are small enough for a plastic zone",
        ));
    }
    all
}
