//! The runs' numbers in tables: each run's value, and below it the difference from the first run's.

use tremolite_results::{Peaks, Summary, TrustLine};

use super::Run;
use crate::chapter::text_table::{Cell, Head, TextTable};
use crate::facts::ByName;
use crate::language::{Language, say};
use crate::quantities::scale::{Scale, figures, trimmed};
use crate::section_forces::stations::{KILO, linings};
use crate::source::Source;

/// A table under its heading.
pub struct Compared {
    pub heading: String,
    pub table: TextTable,
}

/// One number of all runs.
struct NumberRow {
    label: String,
    values: Vec<Option<f64>>,
}

/// All tables that any run has numbers for.
pub fn tables(runs: &[Run], language: Language) -> Vec<Compared> {
    let facts: Vec<Summary> = runs.iter().map(|run| run.source.facts()).collect();
    let peaks = |quantities: &'static [&'static str], of: fn(&Peaks) -> f64| {
        move |summary: &Summary| of_histories(&summary.monitors.peaks, quantities, of)
    };
    type Numbers<'a> = Box<dyn Fn(&Summary) -> Vec<(String, f64)> + 'a>;
    const U: &[&str] = &["ux", "uy", "uz"];
    let tables: Vec<(String, &str, Numbers)> = vec![
        (say!(language, "Largest displacement of monitors, by component"), "m", Box::new(peaks(U, largest))),
        (say!(language, "Displacement of monitors at the end"), "m", Box::new(peaks(U, |p| p.residual))),
        (
            say!(language, "Largest relative displacement of pairs"),
            "m",
            Box::new(|s| of_histories(&s.monitors.relative, U, largest)),
        ),
        (
            say!(language, "Largest principal stress s1 of monitors, at points"),
            "Pa",
            Box::new(peaks(&["s1"], |p| p.max)),
        ),
        (
            say!(language, "Smallest principal stress s3 of monitors, at points"),
            "Pa",
            Box::new(peaks(&["s3"], |p| p.min)),
        ),
        (
            say!(language, "Extreme principal stress of groups, at the fibre where it is known"),
            "Pa",
            Box::new(of_groups),
        ),
        (say!(language, "Share of a group's volume beyond a threshold"), "%", Box::new(damaged)),
        (say!(language, "Widest crack"), "m", Box::new(opening)),
        (say!(language, "Places cracked through the thickness"), "", Box::new(through)),
        (
            say!(language, "Share of an interface's area that ever slid or opened"),
            "%",
            Box::new(|s| slid(s, language)),
        ),
        (say!(language, "Largest slip and gap of interfaces"), "m", Box::new(|s| slip(s, language))),
        (say!(language, "Largest force of bolts over the force at which they yield"), "", Box::new(bolts)),
        (say!(language, "Motion of walls when the stages are done"), "m", Box::new(walls)),
        (say!(language, "Utilisation of sections"), "", Box::new(|s| used(s, language))),
        (say!(language, "Lines of the energy balance at the end"), "J", Box::new(energy)),
    ];
    let forces = gather(runs.iter().map(|run| section_forces(&run.source, language)));
    let forces = (!forces.is_empty()).then(|| Compared {
        heading: say!(language, "Largest section forces of linings, by size"),
        table: table(runs, &forces, "kN/m, kN"),
    });
    let each = tables.into_iter().filter_map(|(heading, unit, of)| {
        let rows = gather(facts.iter().map(of));
        (!rows.is_empty()).then(|| Compared { heading, table: table(runs, &rows, unit) })
    });
    each.chain(forces).collect()
}

/// The largest N, M and Q of each lining by size, in thousands: of the last stage, and of the shaking.
fn section_forces(source: &Source, language: Language) -> Vec<(String, f64)> {
    let Some(Ok(rows)) = &source.sections else { return Vec::new() };
    let mut numbers = Vec::new();
    for lining in linings(language, rows, &source.facts()) {
        for (i, force) in ["N", "M", "Q"].into_iter().enumerate() {
            let after = lining.stations.iter().map(|s| s.after[i]);
            let shaken =
                lining.stations.iter().flat_map(|s| [s.least, s.most]).flatten().map(|e| e.forces[i]);
            let most = |all: Vec<f64>| {
                let sizes = all.into_iter().map(|x| KILO * x.abs()).filter(|x| x.is_finite());
                sizes.max_by(f64::total_cmp)
            };
            let name = &lining.name;
            for (label, value) in [
                (
                    say!(language, "{lining}: {force}, after the stages", lining = name, force = force),
                    most(after.collect()),
                ),
                (
                    say!(
                        language,
                        "{lining}: {force}, while the ground shakes",
                        lining = name,
                        force = force
                    ),
                    most(shaken.collect()),
                ),
            ] {
                numbers.extend(value.map(|value| (label, value)));
            }
        }
    }
    numbers
}

fn used(summary: &Summary, language: Language) -> Vec<(String, f64)> {
    let both = |(name, of): (&String, &tremolite_results::SectionStrength)| {
        // An infinite one is no number in the file.
        let size = |x: f64| if x.is_nan() { f64::INFINITY } else { x };
        let value =
            |used: &Option<tremolite_results::Used>| used.as_ref().map_or(f64::NAN, |used| size(used.value));
        [
            (say!(language, "{lining}: thrust and moment", lining = name), value(&of.bending)),
            (say!(language, "{lining}: shear", lining = name), value(&of.shear)),
        ]
    };
    summary.parts.sections.iter().flat_map(both).collect()
}

/// The checks of all runs.
pub fn checks(runs: &[Run], language: Language) -> TextTable {
    let facts: Vec<Summary> = runs.iter().map(|run| run.source.facts()).collect();
    let mut ids: Vec<(&str, String)> = Vec::new();
    for line in facts.iter().flat_map(|s| &s.soundness.checks) {
        if !ids.iter().any(|(id, _)| *id == line.id) {
            ids.push((&line.id, language.tell_or(&line.name_message, &line.name)));
        }
    }
    let entry = |line: Option<&TrustLine>| match line {
        None => Cell::number("–"),
        Some(line) if line.not_applicable => Cell::number(say!(language, "not applicable")),
        Some(line) => {
            let value = Scale::suiting(&line.unit, line.value).quantity(line.value);
            Cell::number(value).with(if line.pass { say!(language, "pass") } else { say!(language, "warn") })
        }
    };
    let rows = ids.into_iter().map(|(id, name)| {
        let found = facts.iter().map(|s| entry(s.soundness.checks.iter().find(|line| line.id == id)));
        std::iter::once(Cell::words(name)).chain(found).collect()
    });
    TextTable { head: vec![head(runs)], rows: rows.collect() }
}

/// The runs' names over their columns.
pub fn head(runs: &[Run]) -> Vec<Head> {
    std::iter::once(Head::words("")).chain(runs.iter().map(|run| Head::number(&run.name))).collect()
}

/// Rows by label, in the order in which the runs first name them.
fn gather(all: impl Iterator<Item = Vec<(String, f64)>>) -> Vec<NumberRow> {
    let all: Vec<Vec<(String, f64)>> = all.collect();
    let mut rows: Vec<NumberRow> = Vec::new();
    for (run, numbers) in all.iter().enumerate() {
        for (label, value) in numbers.iter().filter(|(_, value)| !value.is_nan()) {
            let at = rows.iter().position(|row| row.label == *label).unwrap_or_else(|| {
                rows.push(NumberRow { label: label.clone(), values: vec![None; all.len()] });
                rows.len() - 1
            });
            rows[at].values[run] = Some(*value);
        }
    }
    // What is nothing in all runs says nothing.
    rows.retain(|row| row.values.iter().flatten().any(|value| *value != 0.0));
    rows
}

/// One unit for the whole table.
fn table(runs: &[Run], rows: &[NumberRow], unit: &str) -> TextTable {
    let all = rows.iter().flat_map(|row| row.values.iter().flatten()).filter(|x| x.is_finite());
    let largest = all.fold(0.0_f64, |most, x| most.max(x.abs()));
    let scale = match unit {
        "%" => Scale { factor: 100.0, unit: "%".into() },
        // In thousands already.
        "kN/m, kN" => Scale { factor: 1.0, unit: unit.into() },
        unit => Scale::suiting(unit, largest),
    };
    let mut head = head(runs);
    head[0].text = if scale.unit.is_empty() { String::new() } else { format!("({})", scale.unit) };
    // Beside the largest of the table the rest may be round-off.
    let negligible = 1e-9 * largest;
    // And less than a thousandth of it is nothing to take a share of.
    let small = 1e-3 * largest;
    let row = |row: &NumberRow| {
        let first = row.values[0];
        let cell = |(run, value): (usize, &Option<f64>)| {
            let Some(value) = value else { return Cell::number("–") };
            if value.is_infinite() {
                return Cell::number("∞");
            }
            let shown = if value.abs() <= negligible { "0".into() } else { scale.number(*value) };
            let cell = Cell::number(shown);
            match first.filter(|_| run > 0) {
                Some(first) => cell.with(difference(first, *value, small)),
                None => cell,
            }
        };
        let values = row.values.iter().enumerate().map(cell);
        std::iter::once(Cell::words(&row.label)).chain(values).collect()
    };
    TextTable { head: vec![head], rows: rows.iter().map(row).collect() }
}

/// By how much the size differs from the first value's, in percent; a dash where that is nothing to compare with, and arrows
/// where the sign is another.
fn difference(first: f64, value: f64, small: f64) -> String {
    // Of an infinite one there is no share.
    if first.is_infinite() {
        return "–".into();
    }
    // The same to what sums in another order leave.
    if (value - first).abs() <= 1e-12 * first.abs() {
        return "=".into();
    }
    if first.abs() <= small || first == 0.0 {
        return "–".into();
    }
    let percent = 100.0 * (value.abs() - first.abs()) / first.abs();
    let sign = if percent > 0.0 { "+" } else { "" };
    let turned = if value * first < 0.0 { "⇄\u{a0}" } else { "" };
    format!("{turned}{sign}{}\u{a0}%", trimmed(&figures(percent, 2)))
}

/// A number of each history of monitors or pairs.
fn of_histories(all: &ByName, quantities: &[&str], of: fn(&Peaks) -> f64) -> Vec<(String, f64)> {
    let mut numbers = Vec::new();
    for (name, histories) in all {
        for quantity in quantities {
            numbers.extend(histories.get(*quantity).map(|p| (format!("{name} {quantity}"), of(p))));
        }
    }
    numbers
}

/// With its sign.
fn largest(peaks: &Peaks) -> f64 {
    peaks.largest().1
}

fn of_groups(summary: &Summary) -> Vec<(String, f64)> {
    let groups = summary.parts.stress.iter().filter(|(_, stress)| stress.whole);
    let both = |(name, stress): (&String, &tremolite_results::GroupStress)| {
        [(format!("{name} s1"), stress.s1.value), (format!("{name} s3"), stress.s3.value)]
    };
    groups.flat_map(both).collect()
}

fn damaged(summary: &Summary) -> Vec<(String, f64)> {
    let mut numbers = Vec::new();
    for (name, group) in &summary.parts.damage {
        for (measure, damaged) in &group.measures {
            let shares = damaged.beyond.iter();
            numbers
                .extend(shares.map(|(t, volume)| (format!("{name} {measure} > {t}"), volume / group.volume)));
        }
    }
    numbers
}

fn opening(summary: &Summary) -> Vec<(String, f64)> {
    let cracked =
        summary.parts.damage.iter().filter_map(|(name, group)| Some((name, group.cracks.as_ref()?)));
    cracked.map(|(name, cracks)| (name.clone(), cracks.opening)).collect()
}

fn through(summary: &Summary) -> Vec<(String, f64)> {
    let cracked =
        summary.parts.damage.iter().filter_map(|(name, group)| Some((name, group.cracks.as_ref()?)));
    let stacked = cracked.filter(|(_, cracks)| cracks.stacks > 0);
    stacked.map(|(name, cracks)| (name.clone(), cracks.through as f64)).collect()
}

fn slid(summary: &Summary, language: Language) -> Vec<(String, f64)> {
    let both = |(name, i): (&String, &tremolite_results::InterfaceSummary)| {
        [
            (say!(language, "{interface}: slid", interface = name), i.ever_slid / i.area),
            (say!(language, "{interface}: opened", interface = name), i.ever_opened / i.area),
        ]
    };
    summary.parts.interfaces.iter().flat_map(both).collect()
}

fn slip(summary: &Summary, language: Language) -> Vec<(String, f64)> {
    let both = |(name, i): (&String, &tremolite_results::InterfaceSummary)| {
        [
            (say!(language, "{interface}: slip", interface = name), i.max_slip.value),
            (say!(language, "{interface}: gap", interface = name), i.max_gap.value),
        ]
    };
    summary.parts.interfaces.iter().flat_map(both).collect()
}

fn bolts(summary: &Summary) -> Vec<(String, f64)> {
    summary.parts.bolts.iter().map(|(name, group)| (name.clone(), group.force_over_yield)).collect()
}

fn walls(summary: &Summary) -> Vec<(String, f64)> {
    let Some(last) = summary.computed.stages.last() else { return Vec::new() };
    let size = |u: &[f64; 3]| u.iter().map(|x| x * x).sum::<f64>().sqrt();
    last.walls.iter().map(|(name, u)| (name.clone(), size(u))).collect()
}

fn energy(summary: &Summary) -> Vec<(String, f64)> {
    summary.soundness.energy.iter().map(|(line, value)| (line.replace('_', " "), *value)).collect()
}
