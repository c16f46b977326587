//! `[motion.target]`: the spectrum that the design calls for, and the step that fits the motion to it.

use super::records::Channels;
use tremolite_case::{self as case, Case, Component, Diagnostic, Records, Spanned, Target};
use tremolite_motion::{Error, Process, TargetSpectrum};

/// Periods at which a spectrum is drawn that is not given by points.
const DRAWN: usize = 200;

/// The spectrum that a case calls for; nothing where it has none.
///
/// # Errors
/// What is no spectrum, at its place in the case.
pub fn of_case(case: &Case) -> Result<Option<TargetSpectrum>, Diagnostic> {
    let Some(target) = case.motion.as_ref().and_then(|motion| motion.target.as_ref()) else {
        return Ok(None);
    };
    let read = match target {
        Target::Code(words) => TargetSpectrum::parse_code(&words.value),
        Target::File(file) => TargetSpectrum::read(&case.resolve(&file.value)),
        Target::Table(table) => {
            let points: Vec<[f64; 2]> =
                table.value.period.iter().zip(&table.value.sa).map(|(&t, &a)| [t, a]).collect();
            TargetSpectrum::of_table("the case's target", 0.05, &points)
        }
    };
    read.map(Some).map_err(|e| {
        let (message, remedy) = e.message_and_remedy();
        Diagnostic::new(place(target), message, remedy)
    })
}

fn place(target: &Target) -> std::ops::Range<usize> {
    match target {
        Target::Code(words) => words.span.clone(),
        Target::File(file) => file.span.clone(),
        Target::Table(table) => table.span.clone(),
    }
}

/// As the page draws it; nothing where there is none or it cannot be read, which is refused where the motion is made.
pub fn drawn(case: &Case) -> Option<tremolite_results::TargetSpectrum> {
    let mut own = Vec::new();
    if let Some(Target::Table(table)) = case.motion.as_ref()?.target.as_ref() {
        let case::TargetSpectrum { period, sa } = table.value.clone();
        // Points as they are given where one of them is 0, which has no logarithm.
        if period.iter().chain(&sa).any(|x| *x <= 0.0) {
            return Some(tremolite_results::TargetSpectrum { period, sa });
        }
        own = period;
    }
    let target = of_case(case).ok()??;
    let [from, to] = target.range();
    let part = (to / from).ln() / (DRAWN - 1) as f64;
    // Corners where they are, and between them what the spectrum is there.
    let mut period: Vec<f64> = (1..DRAWN - 1).map(|k| from * (k as f64 * part).exp()).chain(own).collect();
    period.extend([from, to]);
    period.sort_by(f64::total_cmp);
    period.dedup_by(|a, b| (*a / *b - 1.0).abs() < 1e-9);
    Some(tremolite_results::TargetSpectrum { sa: period.iter().map(|&t| target.at(t)).collect(), period })
}

/// Matches the horizontal channels to the target of the case; a vertical one that is made of another follows it.
///
/// # Errors
/// Where there is no target, a vertical record of its own, or a record comes no nearer, at their places in the case.
pub fn matched(
    motion: &case::Motion,
    target: Option<&TargetSpectrum>,
    step: &Process,
    word: &Spanned<String>,
    channels: &mut Channels,
) -> Result<(), Diagnostic> {
    let refuse = |e: Error| {
        let (message, remedy) = e.message_and_remedy();
        Diagnostic::at(word, message, remedy)
    };
    if let Records::Components(components) = &motion.records
        && let Some(Component::Record(record)) = &components[2]
    {
        return Err(Diagnostic::at(
            &record.file,
            "`target` is a spectrum of horizontal motion, and \"match\" has none for a vertical record",
            "leave the vertical component out, make it of a horizontal one, up = { from = \"east\", factor = 0.667 }, or match horizontal \
             records alone, each in a case of its own",
        ));
    }
    let Channels::Named(named) = channels else {
        let mut all = channels.each();
        return step.apply_towards(&mut all, target).map_err(refuse);
    };
    // What is made of another component is that component times its factor, of the motion that was matched as of the record.
    let Records::Components(components) = &motion.records else { return Ok(()) };
    let made = |axis: usize| match &components[axis] {
        Some(Component::Scaled { from, factor }) => Some((from.value as usize, factor.value)),
        _ => None,
    };
    let mut own: Vec<_> = named
        .iter_mut()
        .enumerate()
        .filter(|(axis, _)| made(*axis).is_none())
        .filter_map(|(_, c)| c.as_mut())
        .collect();
    step.apply_towards(&mut own, target).map_err(refuse)?;
    for axis in 0..3 {
        let Some((from, factor)) = made(axis) else { continue };
        let Some(source) = named[from].clone() else { continue };
        if let Some(channel) = &mut named[axis] {
            channel.dt = source.dt;
            channel.start = source.start;
            channel.acceleration = source.acceleration.iter().map(|a| factor * a).collect();
        }
    }
    Ok(())
}
