//! Checks of the energy balance.

use crate::evidence::Evidence;
use crate::observers::ENERGY_MEMORY;
use crate::phrases::listed;
use tremolite_engine::Quadrature;
use tremolite_engine::engine::BodyBooks;
use tremolite_kernels::{Booked, Line};
use tremolite_laws::Role;
use tremolite_laws::parameter::position;
use tremolite_results::{Said, TrustLine, said, snake};

/// Energy that may be lost or found, over the largest that motion and elements held, beyond the scheme's own ⅛Δt²aᵀMa and what
/// damage leaves that jumps within a step: an elastic model closes to round-off.
const ERROR: f64 = 5e-4;
/// Work on the elements of a body that is in none of its lines, over what it dissipated: damage that jumps within a step.
const OF_JUMPS: f64 = 0.25;
/// Energy over the largest held that is round-off of a hundred thousand steps.
const NOTHING: f64 = 1e-10;
/// Energy that material laws may create, over what they dissipated.
const CREATED: f64 = 0.05;
/// Energy of the hourglass stabilisation over the strain energy at the same time.
const HOURGLASS: f64 = 0.1;
/// Energy over what was stored when the shaking began that is round-off of many sums.
const ROUND_OFF: f64 = 1e-12;
/// Strain energy over its largest value below which a model counts as still.
const STILL: f64 = 0.01;

pub(super) fn lines(evidence: &Evidence) -> Vec<TrustLine> {
    let mut lines = vec![error(evidence)];
    lines.extend(bodies(evidence));
    lines.extend([created(evidence), hourglass(evidence)]);
    lines
}

/// A column of energy.csv \[J\].
fn column<'e>(evidence: &Evidence<'e>, line: Line) -> &'e [f64] {
    evidence.energy.column(line.name()).unwrap_or(&[])
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, |most, x| if x.is_nan() || most.is_nan() { f64::NAN } else { most.max(x) })
}

/// Energy \[J\] that is round-off beside what was stored when the shaking began; 0 where it began without stress.
fn noise(evidence: &Evidence) -> f64 {
    let state = &evidence.outcome.state;
    if state.carried.is_empty() {
        return 0.0;
    }
    let stored = Line::ALL.iter().filter(|line| line.booked() == Booked::Stored);
    ROUND_OFF * stored.map(|&line| state.ledger.lines[line].abs()).sum::<f64>()
}

/// The largest |error| of all rows over the largest energy that was held in one.
fn error(evidence: &Evidence) -> TrustLine {
    const ID: &str = "energy_error";
    let name = said!("energy error over the largest energy in the model");
    let bodies = evidence.model.user_bodies().iter();
    let unbooked = bodies.filter(|body| {
        let columns = body.material.info().history;
        !columns.is_empty() && position(columns, Role::Dissipated).is_none()
    });
    let unbooked =
        unbooked.map(|body| said!("{law} of {body}", law = body.material.info().name, body = &body.name));
    if !evidence.phase.keeps_books {
        let why = said!("laws that do not record their dissipation: {bodies}", bodies = listed(unbooked));
        return TrustLine::not_applicable(ID, name, why);
    }
    let held = held(evidence);
    // What goes beyond the share of what a body dissipated that jumps may leave is left to the balance.
    let (parted, beyond): (Vec<f64>, Vec<f64>) = evidence
        .outcome
        .bodies
        .iter()
        .zip(errors_of_bodies(evidence))
        .enumerate()
        .map(|(account, (books, error))| {
            // Nothing jumps where nothing cracks.
            let cracks =
                evidence.model.user_bodies().get(account).is_some_and(|body| body.material.info().damages);
            let most = if cracks { OF_JUMPS * books.held[Line::Dissipated].abs() } else { 0.0 };
            let parted = error.min(most);
            (parted, error - parted)
        })
        .unzip();
    let rest = evidence.outcome.state.observers.get(ENERGY_MEMORY).map_or(f64::NAN, |kept| kept[0]);
    let (error, jumps) = (rest + beyond.iter().sum::<f64>(), parted.iter().sum::<f64>());
    if held <= noise(evidence) {
        let why = said!("the motion is within the round-off of the energy stored before");
        return TrustLine::not_applicable(ID, name, why);
    }
    TrustLine::at_most(ID, name, error / held, ERROR, "")
        .with("error", error)
        .with("held", held)
        .with("jumps", jumps)
        .with_note(said!(
            "largest difference of all rows between the energy found and the energy put in, every line booked by itself, but \
             for ⅛Δt²aᵀMa, which belongs to the scheme, and for what jumps of damage within a step leave, {jumps} J at most, which the \
             bodies' own checks judge",
            jumps = format!("{jumps:.1e}"),
        ))
}

/// By body of the user, the largest of all rows of the work on it that is in none of its lines \[J\].
fn errors_of_bodies<'e>(evidence: &Evidence<'e>) -> &'e [f64] {
    let kept = evidence.outcome.state.observers.get(ENERGY_MEMORY);
    kept.and_then(|kept| kept.get(1..)).unwrap_or(&[])
}

/// The largest energy \[J\] of all rows that motion, elements and interfaces hold.
fn held(evidence: &Evidence) -> f64 {
    let held =
        [Line::Kinetic, Line::Strain, Line::Hourglass, Line::Interface].map(|line| column(evidence, line));
    let at = |row: usize| held.iter().filter_map(|column| column.get(row)).sum();
    largest((0..held[0].len()).map(at))
}

/// For each body whose law dissipates: is its work in its lines?
fn bodies(evidence: &Evidence) -> Vec<TrustLine> {
    let mut lines = Vec::new();
    let round_off = NOTHING * held(evidence) + noise(evidence);
    let errors = errors_of_bodies(evidence);
    for (b, (body, books)) in evidence.model.user_bodies().iter().zip(&evidence.outcome.bodies).enumerate() {
        if position(body.material.info().history, Role::Dissipated).is_none() {
            continue;
        }
        let id = format!("body_energy_error_{}", snake(&body.name));
        let name = said!("unaccounted work over dissipated energy, {body}", body = &body.name);
        let error = errors.get(b).copied().unwrap_or(f64::NAN);
        lines.push(of_body(id, name, books, error, round_off));
    }
    if lines.is_empty() {
        let name = said!("unaccounted work over dissipated energy");
        lines.push(TrustLine::not_applicable("body_energy_error", name, said!("no law dissipates")));
    }
    lines
}

/// Is a body's work in its lines, of which `error` \[J\] was in none, at most of all rows? What is below `round_off` \[J\] is nothing.
fn of_body(id: String, name: Said, books: &BodyBooks, error: f64, round_off: f64) -> TrustLine {
    let dissipated = books.held[Line::Dissipated];
    // A law that books nothing of what it takes does not come away with that.
    let found = round_off.max(ERROR * books.work.abs());
    if dissipated <= round_off && error <= found {
        return TrustLine::not_applicable(id, name, said!("nothing was damaged and nothing flowed"));
    }
    TrustLine::at_most(id, name, error / dissipated, OF_JUMPS, "")
        .with("work", books.work)
        .with("error", error)
        .with("dissipated", dissipated)
        .with_note(said!(
            "largest of all rows, over all that was dissipated in the end: work on the body's elements less what they hold, have dissipated \
             and created; damage that jumps within a step leaves some, which shrinks with the step"
        ))
}

fn created(evidence: &Evidence) -> TrustLine {
    const ID: &str = "energy_created_by_laws";
    let name = said!("energy created by material laws over energy dissipated");
    // Its largest rise: what loops took before does not pay for what they give out later.
    let mut least = 0.0_f64;
    let created = largest(column(evidence, Line::Created).iter().map(|&now| {
        least = least.min(now);
        now - least
    }));
    let dissipated = largest(column(evidence, Line::Dissipated).iter().copied());
    if dissipated == 0.0 && created == 0.0 {
        return TrustLine::not_applicable(ID, name, said!("nothing was damaged and nothing flowed"));
    }
    TrustLine::at_most(ID, name, created / dissipated, CREATED, "")
        .with("created", created)
        .with("dissipated", dissipated)
        .with_note(said!(
            "largest rise of what closed strain loops of cracked concrete gave out; split = \"compliance\" cannot"
        ))
}

/// The largest ratio of hourglass to strain energy, row by row.
fn hourglass(evidence: &Evidence) -> TrustLine {
    const ID: &str = "hourglass_energy";
    let name = said!("hourglass energy over strain energy");
    if evidence.model.user_bodies().iter().all(|body| body.quadrature != Quadrature::OnePoint) {
        return TrustLine::not_applicable(ID, name, said!("no one-point elements"));
    }
    let [hourglass, strain] = [Line::Hourglass, Line::Strain].map(|line| column(evidence, line));
    let most = largest(strain.iter().copied());
    // Before the wave comes and when it has passed, both are noise.
    let ratio = |row: usize| hourglass[row] / strain[row].max(STILL * most);
    let worst = (0..strain.len()).max_by(|a, b| ratio(*a).total_cmp(&ratio(*b)));
    let Some(row) = worst.filter(|_| most > noise(evidence)) else {
        return TrustLine::not_applicable(ID, name, said!("nothing is strained"));
    };
    let time = evidence.energy.column("time").map_or(f64::NAN, |time| time[row]);
    TrustLine::at_most(ID, name, ratio(row), HOURGLASS, "").with("time", time).with_note(said!(
        "largest ratio of all rows, at {time} s: energy of the one-point elements' stabilisation, bending that their one point \
         misses",
        time = format!("{time:.2}"),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(work: f64, strain: f64, dissipated: f64) -> TrustLine {
        let mut books = BodyBooks { work, ..BodyBooks::default() };
        books.held[Line::Strain] = strain;
        books.held[Line::Dissipated] = dissipated;
        of_body(
            "id".into(),
            said!("unaccounted work over dissipated energy"),
            &books,
            books.error().abs(),
            1e-10 * 3.0,
        )
    }

    #[test]
    fn round_off_of_a_body_that_dissipates_nothing_is_no_error_and_work_that_goes_nowhere_is() {
        // A wave of 3 J has passed.
        assert!(of(8e-12, 0.0, 0.0).not_applicable);
        assert!(of(8e-12, 0.0, 1e-20).not_applicable);
        let lost = of(0.1, 0.0, 0.0);
        assert!(!lost.pass && lost.value.is_infinite(), "{lost:?}");
        assert!(of(1.1, 0.0, 1.0).pass && !of(1.5, 0.0, 1.0).pass);
    }
}
