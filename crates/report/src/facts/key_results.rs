//! The few numbers that stand at the top of the page.

use tremolite_results::limits::{PairPeaks, largest_displacement, largest_relative, loose_monitors};
use tremolite_results::{Peaks, Summary};

use crate::bolts::key_result;
use crate::damage::opening;
use crate::energy::worst_error;
use crate::facts::{Fact, card};
use crate::interfaces;
use crate::language::say;
use crate::quantities::scale::{figures, moment};
use crate::quantities::units::Kind;
use crate::source::Source;
use crate::source::monitor_pairs::held;

/// The few numbers that a reader wants first.
pub fn key_results(source: &Source) -> Vec<Fact> {
    let (facts, language) = (source.facts(), source.language);
    let duration = source.duration();
    let at = |time: f64| format!("{}\u{a0}s", moment(time, duration));
    let mut cards = stage_cards(source, &facts);
    let without = |note: String, loose: &[&str]| match loose.is_empty() {
        true => note,
        false => {
            say!(
                language,
                "{first}; not counted, on broken elements: {names}",
                first = note,
                names = loose.join(", ")
            )
        }
    };
    if let Ok(table) = &source.monitors {
        let loose = loose_monitors(&facts);
        if let Some((monitor, time, size)) = largest_displacement(table, &facts) {
            let note = say!(
                language,
                "{monitor} at {time}, its components together in one row of monitors.csv",
                monitor = monitor,
                time = at(time)
            );
            cards.push(card(
                say!(language, "Largest displacement of a monitor"),
                source.quantity(Kind::Displacement, size),
                without(note, &loose),
            ));
        }
    }
    let (_, loose) = held(source, &facts);
    if let Some((pair, peaks)) = largest_relative(source.monitors.as_ref().ok(), &facts) {
        let note = say!(language, "{pair} at {time}, its length", pair = pair, time = at(peaks.t_max));
        let label = say!(language, "Largest relative displacement");
        cards.push(card(label, source.quantity(Kind::Displacement, peaks.max), without(note, &loose)));
    }
    cards.extend(stress_cards(source, &facts, at));
    let cracks = facts.parts.damage.iter().filter_map(|(name, group)| Some((name, group.cracks.as_ref()?)));
    let cracks = cracks.filter_map(|(name, cracks)| Some((name, cracks, cracks.widest?)));
    // Of equal ones the first: the whole stands before its parts.
    let wider = cracks.reduce(|a, b| if b.1.opening > a.1.opening { b } else { a });
    if let Some((group, cracks, widest)) = wider {
        let note = say!(
            language,
            "{place} at {time}; the width of a single crack depends on the mesh",
            place = group,
            time = at(widest.time)
        );
        cards.push(card(say!(language, "Widest crack"), opening(source, cracks), note));
    }
    let extremes = interfaces::extremes(source, &facts).into_iter();
    cards.extend(extremes.map(|(label, value, note)| card(label, value, note)));
    cards.extend(
        key_result::hardest(source, &facts)
            .map(|(value, note)| card(say!(language, "Force of the bolt nearest to yield"), value, note)),
    );
    // The check of the balance says it; only summaries without that leave it to the table.
    let checked = facts.soundness.checks.iter().any(|line| line.id == "energy_error");
    let of_table = || source.energy.as_ref().ok().and_then(worst_error);
    if let Some((error, ratio)) = (!checked).then(of_table).flatten() {
        let energy = source.quantity(Kind::Energy, error);
        let note = say!(
            language,
            "{energy}, of the largest energy held; from energy.csv, with ⅛Δt²aᵀMa, which belongs to the scheme and which the check leaves out",
            energy = energy
        );
        cards.push(card(
            say!(language, "Largest error of the energy balance"),
            format!("{}\u{a0}%", figures(100.0 * ratio, 2)),
            note,
        ));
    }
    cards
}

/// What the stages before the shaking left: the most that a wall moved, what has yielded, and how far from rest it is.
fn stage_cards(source: &Source, facts: &Summary) -> Vec<Fact> {
    let language = source.language;
    let mut cards = Vec::new();
    let Some(last) = facts.computed.stages.last().filter(|_| facts.computed.stages.len() > 1) else {
        return cards;
    };
    let size = |u: &[f64; 3]| u.iter().map(|x| x * x).sum::<f64>().sqrt();
    let moved = last.walls.iter().map(|(name, u)| (name, size(u))).filter(|(_, size)| size.is_finite());
    if let Some((name, size)) = moved.max_by(|a, b| a.1.total_cmp(&b.1)) {
        let note = say!(language, "{wall}, after the last stage, since the initial equilibrium", wall = name);
        cards.push(card(
            say!(language, "Largest motion of a wall in the stages"),
            source.quantity(Kind::Displacement, size),
            note,
        ));
    }
    if last.plastic_volume > 0.0 {
        let value = format!("{}\u{a0}m³", figures(last.plastic_volume, 3));
        let label = say!(language, "Plastic shear strain × volume, ∫Γ dV");
        cards.push(card(label, value, say!(language, "after the last stage")));
    }
    cards
}

/// The largest stresses of all groups; of the monitors in summaries that know of none.
fn stress_cards(source: &Source, facts: &Summary, at: impl Fn(f64) -> String) -> Vec<Fact> {
    let language = source.language;
    let mut cards = Vec::new();
    let (largest, smallest) =
        (|| say!(language, "Largest principal stress s1"), || say!(language, "Smallest principal stress s3"));
    let groups = || facts.parts.stress.iter().filter(|(_, stress)| stress.whole);
    let most = groups().max_by(|a, b| a.1.s1.value.total_cmp(&b.1.s1.value)).map(|(name, s)| (name, &s.s1));
    let least = groups().min_by(|a, b| a.1.s3.value.total_cmp(&b.1.s3.value)).map(|(name, s)| (name, &s.s3));
    for (label, found) in [(largest(), most), (smallest(), least)] {
        if let Some((group, peak)) = found {
            let note = say!(
                language,
                "{group} at {time}; at the fibre of intact elements with several points, otherwise at points",
                group = group,
                time = at(peak.time)
            );
            cards.push(card(label, source.quantity(Kind::Stress, peak.value), note));
        }
    }
    if !cards.is_empty() {
        return cards;
    }
    let monitors = || facts.monitors.peaks.iter().map(|(name, peaks)| (name.as_str(), peaks));
    let of_monitor = |monitor: &str, time: f64| {
        say!(language, "monitor {monitor} at {time}", monitor = monitor, time = at(time))
    };
    if let Some((monitor, _, peaks)) = extreme(monitors(), |name| name == "s1", |p| p.max) {
        let note = of_monitor(monitor, peaks.t_max);
        cards.push(card(largest(), source.quantity(Kind::Stress, peaks.max), note));
    }
    if let Some((monitor, _, peaks)) = extreme(monitors(), |name| name == "s3", |p| -p.min) {
        let note = of_monitor(monitor, peaks.t_min);
        cards.push(card(smallest(), source.quantity(Kind::Stress, peaks.min), note));
    }
    cards
}

fn extreme<'a>(
    all: impl IntoIterator<Item = PairPeaks<'a>>,
    wanted: impl Fn(&str) -> bool,
    rank: impl Fn(&Peaks) -> f64,
) -> Option<(&'a str, &'a str, Peaks)> {
    let each = all
        .into_iter()
        .flat_map(|(name, by_quantity)| by_quantity.iter().map(move |(q, peaks)| (name, q, peaks)));
    each.filter(|(_, q, peaks)| wanted(q) && rank(peaks).is_finite())
        .max_by(|a, b| rank(a.2).total_cmp(&rank(b.2)))
        .map(|(name, q, peaks)| (name, q.as_str(), *peaks))
}
