//! Checks of what comes in and how the ground carries it.

use crate::equivalent_linear::MOST_STRAIN;
use crate::evidence::Evidence;
use crate::observers::{ColumnSeen, FreeFieldSeen, NoColumn, YieldingSeen, recorded};
use crate::phrases::clauses;
use crate::places;
use tremolite_engine::Side;
use tremolite_results::{Said, TrustLine, said};

/// Elements a wavelength below which a wave's amplitude and speed suffer (Kuhlemeyer & Lysmer 1973).
pub(crate) const PER_WAVELENGTH: f64 = 8.0;
/// Difference of the column's velocity from theory, over its peak.
const THEORY: f64 = 0.05;
/// Difference of the model's velocity at its corners from the column's, over its peak: what sides and caverns make of the
/// free field there.
const CORNERS: f64 = 0.1;
/// Difference of a deconvolved record from the motion that comes out at its place, over its peak.
const RECORD: f64 = 0.05;
/// Displacement of the input at its end over its peak.
pub(crate) const DRIFT: f64 = 0.1;

/// Id and name of the checks of the free field.
fn free_field_theory() -> (&'static str, Said) {
    ("free_field_theory", said!("free field against one-dimensional theory"))
}

fn model_against_free_field() -> (&'static str, Said) {
    ("free_field_at_model_edges", said!("motion at the model's corners against the free field"))
}

pub(super) fn per_wavelength(evidence: &Evidence) -> TrustLine {
    const ID: &str = "elements_per_wavelength";
    let name = said!("elements per shortest wavelength");
    let Evidence { model, survey, .. } = evidence;
    let (Some(coarsest), Some(motion)) = (survey.coarsest(), evidence.motion) else {
        return TrustLine::not_applicable(ID, name, said!("no wave comes in"));
    };
    TrustLine::at_least(ID, name, coarsest.per_wavelength, PER_WAVELENGTH, "")
        .with("frequency", motion.highest_frequency)
        .with("element", model.mesh.element_id(coarsest.coarsest as usize) as f64)
        .with_note(said!(
            "shear waves of {frequency} Hz (99.9 % of the input's energy lies below) along the longest edge of {element}",
            frequency = format!("{:.1}", motion.highest_frequency),
            element = places::element(model, coarsest.coarsest as usize),
        ))
}

pub(super) fn drift(evidence: &Evidence) -> TrustLine {
    const ID: &str = "input_drift";
    let name = said!("residual displacement of the input over its peak");
    let Some(motion) = evidence.plan.shaken_by(evidence.model) else {
        return TrustLine::not_applicable(ID, name, said!("no wave comes in"));
    };
    TrustLine::at_most(ID, name, motion.drift(), DRIFT, "").with_note(said!(
        "a large value is drift of the record, which the model follows: put \"baseline\" last in motion.processing, behind \
         filter and taper"
    ))
}

/// The reference column against theory, and the model's corners against the column.
pub(super) fn free_field(evidence: &Evidence) -> Vec<TrustLine> {
    let both = |why: Said| {
        let none = |(id, name)| TrustLine::not_applicable(id, name, why.clone());
        vec![none(free_field_theory()), none(model_against_free_field())]
    };
    let Evidence { model, outcome, .. } = evidence;
    if evidence.plan.waves.is_some() {
        let (id, name) = free_field_theory();
        let none = TrustLine::not_applicable(
            id,
            name,
            said!("with waves at angles the free field is the theory itself"),
        );
        let Some(seen) = FreeFieldSeen::at_corners(&outcome.state.observers) else {
            return both(said!("no row was written"));
        };
        return vec![none, against_columns(&seen.columns)];
    }
    if model.boundaries.incident.is_none() {
        return both(said!("no wave comes in"));
    }
    if model.outside.columns.is_empty() {
        // As the engine says it, in English alone.
        let why =
            said!("there is no reference column: {reason}", reason = Said::plain(&model.outside.no_column));
        let mut lines = both(why.clone());
        // Periodic sides leave uniform motion alone. What others make of it cannot be told here, and that is no pass.
        if model.boundaries.sides.iter().any(|side| *side != Side::Periodic) {
            let (id, name) = model_against_free_field();
            lines[1] = TrustLine::at_most(id, name, f64::NAN, CORNERS, "").with_note(said!(
                "cannot be checked, since {why}; and sides that are not periodic may spoil the free field",
                why = why,
            ));
        }
        return lines;
    }
    let Some(seen) = FreeFieldSeen::of(model, &outcome.state.observers) else {
        return both(said!("no row was written"));
    };
    let yielding = YieldingSeen::of(&outcome.state.observers);
    vec![against_theory(&seen.columns, yielding.as_ref()), against_columns(&seen.columns)]
}

/// Whether a record that was deconvolved comes out where it was taken.
pub(super) fn record(evidence: &Evidence) -> Option<TrustLine> {
    let (id, name) =
        ("record_at_its_place", said!("computed motion at the record's place against the record"));
    let none = |why: Said| Some(TrustLine::not_applicable(id, name.clone(), why));
    if evidence.plan.recorded.as_ref()?.corner.is_none() {
        return none(said!("it was recorded on the layers of motion.site, not on the model's ground"));
    }
    if recorded::place(evidence.model, evidence.plan).is_none() {
        return none(said!(
            "there is no reference column: {reason}",
            reason = Said::plain(&evidence.model.outside.no_column)
        ));
    }
    let Some(error) = recorded::error(&evidence.outcome.state.observers) else {
        return none(said!("the rows of the histories are too few to show the wave"));
    };
    Some(TrustLine::at_most(id, name, error, RECORD, "").with_note(said!(
        "velocity of the free field where the record was taken against the motion given, over its peak in the rows: what differs is \
         the mesh's, or of rock that yields, or of what was left out above the record's band"
    )))
}

/// The columns against theory, the worst of those that have some.
fn against_theory(columns: &[ColumnSeen], yielding: Option<&YieldingSeen>) -> TrustLine {
    let (id, name) = free_field_theory();
    let none = |why: Said| TrustLine::not_applicable(id, name.clone(), why);
    let known: Vec<_> = columns.iter().filter_map(|column| Some((column, column.theory?))).collect();
    if known.is_empty() {
        return none(said!(
            "theory is of ground that hangs together, and an interface runs through every column"
        ));
    }
    let elastic: Vec<_> = known.iter().filter(|(column, _)| !column.damaged).collect();
    if elastic.is_empty() {
        let why = said!("the rock of every column can yield or crack, and the theory is elastic");
        let Some(seen) = yielding else { return none(why) };
        let line = none(clauses([why, beside_yielding(seen, columns)]));
        return match seen.found {
            Ok(strain) => {
                line.with("surface", seen.peaks[0]).with("equivalent", seen.peaks[1]).with("strain", strain)
            }
            Err(_) => line,
        };
    }
    let shown = elastic.iter().filter(|(_, theory)| theory.seen >= 0.5 * theory.peak);
    // What is no number is the worst.
    let worst = shown.clone().max_by(|(_, a), (_, b)| a.error().total_cmp(&b.error()));
    let Some((column, theory)) = worst else {
        return none(said!("the rows of the histories are too few to show the wave"));
    };
    let [top, base] = theory.difference;
    let (shown, all) = (shown.count(), columns.len());
    let end = match base > top || base.is_nan() {
        true => said!(
            "velocity at the base of column '{column}' against one-dimensional theory of its layers, damping included",
            column = &column.name,
        ),
        false => said!(
            "velocity at the top of column '{column}' against one-dimensional theory of its layers, damping included",
            column = &column.name,
        ),
    };
    let (worst_of, of) = (shown.to_string(), all.to_string());
    let note = match (all > 1, shown < all) {
        (false, _) => end,
        (true, false) => {
            said!("{end}; the worst of all {all} columns", end = end, all = of)
        }
        (true, true) => said!(
            "{end}; the worst of {shown} columns of {all}, since the others yield, crack, are cut by an interface, or show no wave \
             in the rows",
            end = end,
            shown = worst_of,
            all = of,
        ),
    };
    TrustLine::at_most(id, name, theory.error(), THEORY, "")
        .with("difference", theory.error() * theory.peak)
        .with("peak", theory.peak)
        .with("shown", shown as f64)
        .with("columns", all as f64)
        .with_note(note)
}

/// What the equivalent-linear column says of ground that yields: nothing to judge by.
fn beside_yielding(seen: &YieldingSeen, columns: &[ColumnSeen]) -> Said {
    let percent = |strain: f64| format!("{:.3} %", 100.0 * strain);
    let speed = |v: f64| format!("{v:.3} m/s");
    match seen.found {
        Ok(strain) => said!(
            "an equivalent-linear column of the same laws has at most {theory} at its surface, column '{column}' {run} in the rows; its layers \
             shear by up to {strain}",
            theory = speed(seen.peaks[1]),
            column = columns.get(seen.column).map_or("", |column| &column.name),
            run = speed(seen.peaks[0]),
            strain = percent(strain),
        ),
        Err(NoColumn::Strained(strain)) => said!(
            "nor is there an equivalent-linear column, since a layer of it would shear by {strain}, beyond {most}",
            strain = percent(strain),
            most = percent(MOST_STRAIN),
        ),
        Err(NoColumn::Restless) => {
            said!(
                "nor is there an equivalent-linear column, since no moduli fit the strain that they lead to"
            )
        }
        Err(NoColumn::Law) => said!(
            "nor is there an equivalent-linear column, since a law of this ground has no curves of modulus and damping against strain"
        ),
    }
}

/// The model's own corners against the columns that stand for them, the worst of all.
fn against_columns(columns: &[ColumnSeen]) -> TrustLine {
    let (id, name) = model_against_free_field();
    let error = |column: &&ColumnSeen| {
        let [surface, base] = column.corners;
        if surface.is_nan() || base.is_nan() { f64::NAN } else { surface.max(base) / column.peak }
    };
    let moved = columns.iter().filter(|column| column.peak > 0.0);
    let Some(worst) = moved.max_by(|a, b| error(a).total_cmp(&error(b))) else {
        return TrustLine::not_applicable(id, name, said!("no wave has reached a column of the ground"));
    };
    let [surface, base] = worst.corners;
    TrustLine::at_most(id, name, error(&worst), CORNERS, "")
        .with("surface", surface)
        .with("base", base)
        .with("peak", worst.peak)
        .with_note(said!(
            "velocity of the model's own surface and base at its vertical edges against that of column '{column}', over that one's \
             peak: sides that hold or drain the free field, caverns too near to them (make `sides` wider), or ground that dips, \
             slopes or changes from side to side, which goes on level outside",
            column = &worst.name,
        ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observers::Theory;

    /// A column with a peak of 2 m/s and these differences \[m/s\] from theory, at its top and base.
    fn column(name: &str, difference: [f64; 2]) -> ColumnSeen {
        let theory = Theory { difference, seen: 2.0, peak: 2.0 };
        ColumnSeen { name: name.into(), theory: Some(theory), peak: 2.0, ..ColumnSeen::default() }
    }

    #[test]
    fn the_worst_column_and_end_are_named_and_fail_for_all() {
        let good = [column("xmin-ymin", [0.02, 0.01]), column("xmin-ymax", [0.01, 0.03])];
        let line = against_theory(&good, None);
        assert!(line.pass && (line.value - 0.015).abs() < 1e-15, "{line:?}");
        assert!(line.note.contains("the base of column 'xmin-ymax'"), "{}", line.note);
        for bad in [[0.2, 0.01], [f64::NAN, 0.01]] {
            let mut columns = good.to_vec();
            columns.insert(1, column("ymin-xmax", bad));
            let line = against_theory(&columns, None);
            assert!(!line.pass && line.note.contains("the top of column 'ymin-xmax'"), "{line:?}");
            // Elastic theory is not for ground that yields.
            columns[1].damaged = true;
            let line = against_theory(&columns, None);
            assert!(line.pass && line.note.contains("the worst of 2 columns of 3"), "{line:?}");
        }
    }

    #[test]
    fn theory_that_is_not_there_is_no_pass_without_a_reason() {
        let mut lone = column("reference", [0.02, 0.01]);
        lone.damaged = true;
        assert!(against_theory(&[lone.clone()], None).note.contains("can yield or crack"));
        lone.theory = None;
        assert!(against_theory(&[lone], None).note.contains("an interface runs through"));
        let mut few = column("reference", [0.02, 0.01]);
        few.theory.as_mut().unwrap().seen = 0.1;
        let line = against_theory(&[few], None);
        assert!(line.not_applicable && line.note.contains("too few"), "{line:?}");
    }

    #[test]
    fn a_model_that_leaves_one_of_its_columns_fails_and_the_column_is_named() {
        let mut columns = [column("xmin-ymin", [0.0; 2]), column("xmin-ymax", [0.0; 2])];
        columns[0].corners = [0.1, 0.05];
        assert!(against_columns(&columns).pass);
        for corners in [[0.01, 0.5], [f64::NAN, 0.0]] {
            columns[1].corners = corners;
            let line = against_columns(&columns);
            assert!(!line.pass && line.note.contains("'xmin-ymax'"), "{line:?}");
        }
    }
}
