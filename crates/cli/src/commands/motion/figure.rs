//! A channel before and after its processing, as a figure.

use tremolite_motion::{
    Channel, Error, Matched, Process, TargetSpectrum, cumulative_trapezoid, default_periods,
    pseudo_acceleration,
};
use tremolite_report::processing::{BeforeAfter, Pair};

/// The figure as SVG: histories of acceleration, velocity and displacement, integrated from rest, and response spectra. Of
/// counts the history alone, since nothing more is known of them. `before` is the record less its mean, which the legend says.
///
/// # Errors
/// None for channels that were read.
pub fn draw(before: &Channel, after: &Channel, steps: &[Process]) -> Result<String, Error> {
    let time: Vec<f64> = (0..after.acceleration.len()).map(|i| after.start + i as f64 * after.dt).collect();
    let integrated = |values: &[f64]| cumulative_trapezoid(values, after.dt);
    let (a, b) = (&before.acceleration, &after.acceleration);
    let velocity = [integrated(a), integrated(b)];
    let displacement = velocity.each_ref().map(|v| integrated(v));
    let periods = default_periods();
    let psa = |values: &[f64]| pseudo_acceleration(values, after.dt, &periods, 0.05);
    let spectra = if after.raw { None } else { Some([psa(a)?, psa(b)?]) };
    let mut histories = vec![Pair {
        name: "acceleration",
        unit: if after.raw { "counts" } else { "m/s2" },
        before: a,
        after: b,
    }];
    if !after.raw {
        for (name, unit, [before, after]) in
            [("velocity", "m/s", &velocity), ("displacement", "m", &displacement)]
        {
            histories.push(Pair { name, unit, before, after });
        }
    }
    let words: Vec<String> = steps.iter().map(Process::to_string).collect();
    let spectrum = spectra.as_ref().map(|[before, after]| {
        (&periods[..], Pair { name: "spectral acceleration, 5 % damping", unit: "m/s2", before, after })
    });
    let figure = BeforeAfter {
        title: format!("{}: before and after processing", after.name),
        steps: if words.is_empty() { "no steps".into() } else { words.join(", ") },
        before: "before, less its mean",
        time: &time,
        histories,
        spectrum,
        target: None,
    };
    Ok(figure.draw())
}

/// The figure of a motion that was matched: histories and spectra of the record, multiplied as a whole, and of what came of it,
/// beside the target.
///
/// # Errors
/// None for motions that were matched.
pub fn draw_matched(
    made: &Matched,
    target: &TargetSpectrum,
    title: &str,
    words: String,
) -> Result<String, Error> {
    let Channel { dt, start, .. } = made.channel;
    let (a, b) = (&made.scaled, &made.channel.acceleration);
    let time: Vec<f64> = (0..b.len()).map(|i| start + i as f64 * dt).collect();
    let integrated = |values: &[f64]| cumulative_trapezoid(values, dt);
    let velocity = [integrated(a), integrated(b)];
    let displacement = velocity.each_ref().map(|v| integrated(v));
    let periods = default_periods();
    let spectra = [
        pseudo_acceleration(a, dt, &periods, target.damping)?,
        pseudo_acceleration(b, dt, &periods, target.damping)?,
    ];
    let [from, to] = target.range();
    let wanted: Vec<f64> =
        periods.iter().map(|&t| if (from..=to).contains(&t) { target.at(t) } else { f64::NAN }).collect();
    let spectrum_name = format!("spectral acceleration, {} % damping", 100.0 * target.damping);
    let figure = BeforeAfter {
        title: title.to_owned(),
        steps: words,
        before: "before, multiplied as a whole",
        time: &time,
        histories: vec![
            pair_of("acceleration", "m/s2", [a, b]),
            pair_of("velocity", "m/s", velocity.each_ref()),
            pair_of("displacement", "m", displacement.each_ref()),
        ],
        spectrum: Some((&periods, pair_of(&spectrum_name, "m/s2", spectra.each_ref()))),
        target: Some((&target.name, &wanted)),
    };
    Ok(figure.draw())
}

fn pair_of<'a>(name: &'a str, unit: &'a str, [before, after]: [&'a Vec<f64>; 2]) -> Pair<'a> {
    Pair { name, unit, before, after }
}
