//! What a motion that can be read and processed is warned of: numbers that are not what they seem.

use super::facts::{SiteFacts, largest};
use super::processing::Processing;
use super::records::Channels;
use crate::trust::{MOST_MASS_DAMPING, MOST_MISSED, NOT_RUN, left_after, mass_damping};
use std::f64::consts::PI;
use tremolite_case::{self as case, Diagnostic, Site, Window};
use tremolite_engine::Body;
use tremolite_motion::{Channel, MATCHED, Motion, Process, TargetSpectrum, misfit, scale_to};

/// A window's displacement over that of the whole record from which on it is doubted.
const MADE_BY_THE_WINDOW: f64 = 1.5;
/// Share of a window that may lie outside its record: records begin and end at samples.
const BEYOND: f64 = 0.01;
/// Misfit to the target that steps behind a match may leave: twice that of the match.
const OFF_TARGET: f64 = 2.0 * MATCHED;
/// Part of a peak that was asked for by which later steps may change it.
const PEAK_KEPT: f64 = 0.05;
/// Loss of amplitude by straight lines between samples that is worth a word.
const LOST_BETWEEN: f64 = 0.1;
/// Share of a record's energy that may be left out above its band.
const LEFT_OUT: f64 = 0.01;
/// Shear strain at which soil is no longer linear: stiffness has fallen by a tenth or more in most (`kramer1996`, chapter 6).
const LINEAR: f64 = 5e-4;

/// The largest displacement of channels \[m\], each from rest.
fn displacement(channels: &Channels) -> f64 {
    let of = |channel: &Channel| {
        let still = vec![0.0; channel.acceleration.len()];
        let along = [channel.acceleration.clone(), still.clone(), still];
        Motion::from_acceleration(channel.dt, along).map_or(0.0, |motion| largest(&motion.displacement[0]))
    };
    channels.all().into_iter().map(of).fold(0.0, f64::max)
}

/// A window that reaches beyond its record by more than a hundredth of its length. `whole` is the record before the window.
pub fn of_reach(motion: &case::Motion, whole: &Channels) -> Option<Diagnostic> {
    let window = motion.window.as_ref()?;
    let first = whole.all().into_iter().next()?;
    let [start, end] = [first.start, first.end()];
    let (wanted, length, lacking) = match window.value {
        Window::Between(from, to) => {
            (format!("{from} s to {to} s"), to - from, (start - from).max(0.0) + (to - end).max(0.0))
        }
        Window::Strongest(length) => {
            (format!("the strongest {length} s"), length, (length - (end - start)).max(0.0))
        }
    };
    (lacking > BEYOND * length + first.dt).then(|| {
        Diagnostic::at(
            window,
            format!(
                "window: {wanted} ({lacking:.2} s of it lie outside the record, {start:.2} s to {end:.2} s)"
            ),
            "give a window inside the record, or leave `window` out",
        )
    })
}

/// A window that is cut in the middle of the motion knows neither the velocity nor the displacement at its beginning, and what brings
/// it to rest makes up others. `whole` is the record before the window, `cut` that within it, `processed` this after all steps. Where the
/// whole record cannot be matched to the target both are compared in front of the match.
pub fn of_window(
    processing: &Processing,
    whole: Channels,
    cut: Channels,
    processed: &Channels,
) -> Option<Diagnostic> {
    let window = processing.motion.window.as_ref()?;
    let count = processing.steps.len();
    let (all, part, before) = match processing.applied(whole.clone(), count) {
        Some(whole) => (displacement(&whole), displacement(processed), ""),
        None => {
            let count = processing.before_match()?;
            let [whole, cut] = [whole, cut].map(|channels| processing.applied(channels, count));
            (displacement(&whole?), displacement(&cut?), " in front of \"match\"")
        }
    };
    (part > MADE_BY_THE_WINDOW * all).then(|| {
        Diagnostic::at(
            window,
            format!(
                "the window, processed, is displaced by up to {part:.3} m, the whole record, processed alike, by {all:.3} m{before}: a window \
                 cut out of its motion lacks the velocity and displacement at the cut, and the processing puts in others"
            ),
            "begin and end the window where the ground hardly moves, use the whole record, or put a high-pass whose period is well \
             below the window's length after the taper",
        )
    })
}

/// Steps that later steps undo: a factor in front of a step that scales the motion itself, and a match in front of steps that
/// change its spectrum.
pub fn of_steps(processing: &Processing, processed: &Channels) -> Vec<Diagnostic> {
    let Processing { motion, target, steps } = processing;
    let sets_size = |step: &Process| matches!(step, Process::PeakAcceleration { .. } | Process::Match { .. });
    let mut doubts = Vec::new();
    for (k, (step, word)) in steps.iter().zip(&motion.processing).enumerate() {
        let idle = match step {
            // A negative number turns the motion round, which stays.
            Process::Scale(number) => *number > 0.0 && *number != 1.0,
            Process::PeakAcceleration { .. } => true,
            _ => false,
        };
        let Some(later) = steps[k + 1..].iter().position(sets_size).filter(|_| idle) else { continue };
        let later = &motion.processing[k + 1 + later].value;
        doubts.push(Diagnostic::at(
            word,
            format!("\"{}\": no effect, since \"{later}\" behind it scales the motion anew", word.value),
            format!("leave it out, or put it behind \"{later}\""),
        ));
    }
    doubts.extend(target.and_then(|target| of_match(motion, target, steps, processed)));
    doubts
}

/// A spectrum that steps behind the last match have changed beyond its tolerance, whatever factor they have put on it.
fn of_match(
    motion: &case::Motion,
    target: &TargetSpectrum,
    steps: &[Process],
    processed: &Channels,
) -> Option<Diagnostic> {
    let last = steps.iter().rposition(|step| matches!(step, Process::Match { .. }))?;
    let keeps = |step: &Process| {
        matches!(step, Process::Scale(_) | Process::PeakAcceleration { .. } | Process::Resample { .. })
    };
    let changed = steps[last + 1..].iter().position(|step| !keeps(step))?;
    let Process::Match { band } = steps[last] else { return None };
    let band = target.band(band).ok()?;
    let off = |channel: &Channel| {
        let factor = scale_to(&channel.acceleration, channel.dt, target, band).ok()?;
        let scaled: Vec<f64> = channel.acceleration.iter().map(|a| factor * a).collect();
        Some(misfit(&scaled, channel.dt, target, band).ok()?.largest)
    };
    let largest = processed.horizontal().into_iter().filter_map(off).fold(0.0, f64::max);
    let (word, changing) = (&motion.processing[last], &motion.processing[last + 1 + changed].value);
    (largest > OFF_TARGET).then(|| {
        Diagnostic::at(
            word,
            format!(
                "misfit to the target: {:.0} % (limit {:.0} %) after \"{changing}\", which stands behind \"{}\"",
                100.0 * largest,
                100.0 * OFF_TARGET,
                word.value
            ),
            format!("put \"{}\" behind the steps that change the spectrum", word.value),
        )
    })
}

/// A peak that steps behind it change.
pub fn of_peak(motion: &case::Motion, channels: &mut Channels, steps: &[Process]) -> Option<Diagnostic> {
    let (step, word) = steps.iter().zip(&motion.processing).rev().find_map(|(step, word)| match step {
        Process::PeakAcceleration { value, units } => Some((value * units.factor()?, word)),
        _ => None,
    })?;
    // A match behind it is told of by itself.
    if steps
        .iter()
        .rev()
        .find(|s| matches!(s, Process::PeakAcceleration { .. } | Process::Match { .. }))
        .is_some_and(|last| matches!(last, Process::Match { .. }))
    {
        return None;
    }
    let found = channels.each().iter().map(|channel| largest(&channel.acceleration)).fold(0.0, f64::max);
    ((found / step - 1.0).abs() > PEAK_KEPT).then(|| {
        Diagnostic::at(
            word,
            format!(
                "the peak of {step:.3} m/s2 that is asked for becomes {found:.3} m/s2 by the steps behind it"
            ),
            "put it behind the filters",
        )
    })
}

/// Samples that lie so far apart that straight lines between them lose of what moves fastest: sinc² of frequency times interval.
pub fn of_sampling(motion: &case::Motion, dt: f64, highest: f64) -> Option<Diagnostic> {
    // What does not move loses nothing.
    let x = PI * highest * dt;
    let lost = 1.0 - (x.sin() / x).powi(2);
    (lost > LOST_BETWEEN).then(|| {
        Diagnostic::new(
            motion.span.clone(),
            format!(
                "between samples {dt} s apart the acceleration is taken as linear, which leaves {:.0} % of the amplitude at \
                 {highest:.1} Hz, below which 99.9 % of the motion's energy lies",
                100.0 * (1.0 - lost)
            ),
            format!("put \"resample {} s\" last in motion.processing: a band-limited course between the samples", fine(highest)),
        )
    })
}

/// A usual interval \[s\] that carries a frequency to about 1 %.
fn fine(hertz: f64) -> f64 {
    let most = (0.03_f64).sqrt() / (PI * hertz);
    [0.01, 0.005, 0.002, 0.001].into_iter().find(|dt| *dt <= most).unwrap_or(0.001)
}

/// What a deconvolution leaves out, and soil that is strained beyond what linear layers are for.
pub fn of_site(motion: &case::Motion, site: &SiteFacts, given: &Motion) -> Vec<Diagnostic> {
    let mut doubts = Vec::new();
    if site.left_out > LEFT_OUT {
        doubts.push(Diagnostic::new(
            motion.span.clone(),
            format!(
                "{:.1} % of the processed record's energy (∫a² dt) lies above {:.2} Hz and does not come in: further up too little of the \
                 wave moves the place where it was taken",
                100.0 * site.left_out,
                site.reach
            ),
            format!(
                "put a low-pass well below {:.2} Hz into motion.processing, or do without: what comes out there lacks it",
                site.reach
            ),
        ));
    }
    if let Some(Site::Layers(layers)) = &motion.site {
        let fastest = given.velocity[..2].iter().map(|v| largest(v)).fold(0.0, f64::max);
        let strain = |layer: &case::SiteLayer| fastest / layer.shear_wave_velocity.value;
        // What softens has the moduli of its strain, and is refused beyond what that is good for.
        let linear = layers.iter().filter(|layer| layer.softening.is_none());
        let softest = linear.max_by(|a, b| strain(a).total_cmp(&strain(b)));
        if let Some(layer) = softest.filter(|layer| strain(layer) > LINEAR) {
            doubts.push(Diagnostic::at(
                &layer.shear_wave_velocity,
                format!(
                    "the record moves by up to {fastest:.3} m/s, which strains this layer by about {:.2} %: the layers are linear, and \
                     soil is not at that",
                    100.0 * strain(layer)
                ),
                "give curves of how it softens, `darendeli`, `vucetic_dobry` or `curves`, in place of `damping`; or a velocity and a damping \
                 ratio that go with the strain",
            ));
        }
        for layer in layers {
            if !(1000.0..=3500.0).contains(&layer.density.value) {
                doubts.push(Diagnostic::at(
                    &layer.density,
                    format!("{:.0} kg/m3 is no density of ground", layer.density.value),
                    "soil has 1400 to 2200 kg/m3, rock up to 3000",
                ));
            }
            if !(40.0..=4500.0).contains(&layer.shear_wave_velocity.value) {
                doubts.push(Diagnostic::at(
                    &layer.shear_wave_velocity,
                    format!(
                        "{} m/s is no velocity of shear waves in ground",
                        layer.shear_wave_velocity.value
                    ),
                    "soft clay has 80 m/s and more, rock up to 3500 m/s",
                ));
            }
        }
    }
    doubts
}

/// A run that ends before its motion, which comes to the last corner of the model by `late` \[s\] later.
pub fn of_duration(case: &case::Case, wave: &Motion, late: f64) -> Option<Diagnostic> {
    let duration = case.dynamic.duration.as_ref()?;
    let share = left_after(wave, duration.value - late);
    (share > NOT_RUN).then(|| {
        Diagnostic::at(
            duration,
            format!(
                "the motion lasts {:.2} s, and {:.0} % of its energy (∫a² dt) comes after this",
                wave.duration(),
                100.0 * share
            ),
            "leave `duration` out, or cut the motion by `window`: peaks are reported for the whole motion, the part that is not run included",
        )
    })
}

/// Damping in proportion to the mass that takes more of the motion than rock does.
pub fn of_mass_damping(case: &case::Case, wave: &Motion) -> Option<Diagnostic> {
    let mass = &case.dynamic.rayleigh.mass;
    // A motion with an offset has half of its energy at rest: that it needs a baseline is said elsewhere.
    let frequency = tremolite_motion::highest_frequency(wave, 0.5).filter(|hertz| *hertz > 0.0)?;
    let ratio = mass_damping(mass.value, frequency);
    (ratio > MOST_MASS_DAMPING).then(|| {
        Diagnostic::at(
            mass,
            format!(
                "this damping is {:.0} % of critical at {frequency:.2} Hz, below which half of the motion's energy lies; rock and concrete \
                 have 1 to 5 %",
                100.0 * ratio
            ),
            "give less, or damping over a band: damping = { ratio = 0.03, band = [\"0.5 Hz\", \"20 Hz\"], reference = \"0 Hz\" }",
        )
    })
}

/// Damping over a band in place of damping in proportion to the mass.
const BAND: &str = "damping = { ratio = 0.02, band = [\"0.5 Hz\", \"20 Hz\"], reference = \"0 Hz\" }";

/// Damping in proportion to the mass where pieces slide on an interface or concrete may come loose: it acts on the velocity against the
/// model's frame, so it brakes a piece that slides as a drag does. A block slid 3 % less at 0.3 1/s and 29 % less at 3 1/s (the verification
/// problem `block_on_slope` has the second).
pub fn of_braked_pieces(case: &case::Case, bodies: &[Body]) -> Option<Diagnostic> {
    let mass = &case.dynamic.rayleigh.mass;
    if case.motion.is_none() || mass.value <= 0.0 {
        return None;
    }
    let slides = case.interfaces.iter().filter(|interface| interface.contact.is_some());
    let slides = slides.map(|interface| format!("the interface '{}' may slide", interface.name.value));
    let loose = bodies.iter().filter(|body| body.material.info().damages);
    let loose = loose.map(|body| format!("'{}' may come loose", body.name));
    let mut pieces: Vec<String> = slides.chain(loose).collect();
    let more = pieces.len().saturating_sub(PIECES);
    pieces.truncate(PIECES);
    if more > 0 {
        pieces.push(format!("{more} more"));
    }
    (!pieces.is_empty()).then(|| {
        Diagnostic::at(
            mass,
            format!(
                "rayleigh.mass: {} 1/s (limit 0) where {}. It reduces the slip of such pieces: by 3 % at 0.3 1/s, by 29 % at 3 1/s",
                mass.value,
                pieces.join(", ")
            ),
            format!("take damping over a band: {BAND}"),
        )
    })
}

/// Pieces that are named.
const PIECES: usize = 3;

/// Rows of the histories that lie too far apart for the motion: half an interval beside its peak a wave of its central frequency has lost
/// 1 − cos πfΔ. In a hall under a pulse of 4 Hz rows 0.02 s apart missed 4.9 % and 0.03 s apart 6 %, where this is 3 and 7 %.
pub fn of_rows(case: &case::Case, wave: &Motion) -> Option<Diagnostic> {
    let histories = &case.output.histories;
    let frequency = tremolite_motion::highest_frequency(wave, 0.5)?;
    let missed = 1.0 - (PI * (frequency * histories.value).min(0.5)).cos();
    (missed > MOST_MISSED).then(|| {
        Diagnostic::at(
            histories,
            format!(
                "rows {} s apart are {:.1} in a period of {frequency:.2} Hz, below which half of the motion's energy lies: peaks between \
                 them may be higher by {:.0} % and more",
                histories.value,
                1.0 / (frequency * histories.value),
                100.0 * missed
            ),
            "give a shorter interval: largest stresses, section forces and widths of cracks are taken from rows",
        )
    })
}
