//! Figure of the energy balance: every line over time, and below it the error.

use tremolite_results::{Table, TrustLine};

use crate::chart::{Chart, Line, Mark, Panel, Stroke};
use crate::curves::Curves;
use crate::figure::{Figure, Section};
use crate::scale::{Scale, figures, quantity};
use crate::source::Source;

const HEADING: &str = "Energy balance";
/// The dark one; the other lines pass it over.
const ERROR_COLOUR: usize = 3;

/// Lines of interfaces, with what they are called on the page.
const OF_INTERFACES: [(&str, &str); 4] = [
    ("interface", "held by interfaces"),
    ("friction", "friction and broken bonds of interfaces"),
    ("created_by_interface", "created by interface laws"),
    ("contact_damping", "contact damping"),
];

/// Lines of bolts, likewise.
const OF_BOLTS: [(&str, &str); 3] = [
    ("bolts", "held by bolts and their bonds"),
    ("bolt_friction", "bonds of bolts that slide"),
    ("bolt_plastic", "bolts that yield and break"),
];

/// Work through sides that follow the free field, positive into the model, and what it is called on the page.
const FREE_FIELD: (&str, &str) = ("free_field", "work through the sides");
/// Dashpots of viscous sides and a viscous top; beside free-field sides, whose dashpots are in [`FREE_FIELD`], what they are
/// called.
const SIDE_DASHPOTS: (&str, &str) = ("side_dashpots", "dashpots of viscous sides and top");
/// Of the check that takes the scheme's own part out of the error.
const ERROR_CHECK: &str = "energy_error";
/// The line behind which it stands: what else waves bring in.
const INPUT: &str = "input";

/// The largest error of the balance, and its ratio to the largest energy held by motion and elements, both over all times.
pub fn worst_error(table: &Table) -> Option<(f64, f64)> {
    let held: Vec<&[f64]> = ["kinetic", "strain", "hourglass", "interface", "bolts"]
        .into_iter()
        .filter_map(|c| table.column(c))
        .collect();
    let error = table.column("error")?.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let most = (0..table.rows())
        .map(|row| held.iter().map(|column| column[row]).sum::<f64>())
        .filter(|x| x.is_finite())
        .fold(0.0_f64, f64::max);
    (most > 0.0).then(|| (error, error / most))
}

fn lines(table: &Table) -> impl Iterator<Item = (&str, &[f64])> {
    let columns = table.columns.iter().zip(&table.values);
    columns
        .map(|(c, values)| (c.name.as_str(), values.as_slice()))
        .filter(|(name, _)| !matches!(*name, "time" | "error"))
}

fn largest(values: &[f64]) -> f64 {
    values.iter().filter(|x| x.is_finite()).fold(0.0, |most, x| f64::max(most, x.abs()))
}

/// What a line of a table is called on the page; its own name where that says it.
fn words(line: &str, table: &Table) -> String {
    let beside = table.column(FREE_FIELD.0).map(|_| &SIDE_DASHPOTS);
    let known = OF_INTERFACES
        .iter()
        .chain(&OF_BOLTS)
        .chain([&FREE_FIELD])
        .chain(beside)
        .find(|(name, _)| *name == line);
    known.map_or_else(|| line.replace('_', " "), |(_, words)| (*words).to_owned())
}

/// All lines but the error, in the order of the table; work through the sides beside the input.
fn in_order(table: &Table) -> Vec<(&str, &[f64])> {
    let mut all: Vec<_> = lines(table).collect();
    if let Some(from) = all.iter().position(|(name, _)| *name == FREE_FIELD.0) {
        let through_sides = all.remove(from);
        let behind = all.iter().position(|(name, _)| *name == INPUT).map_or(from, |k| k + 1);
        all.insert(behind, through_sides);
    }
    all
}

/// What has come in through sides that follow the free field; empty without them.
fn through_sides(table: &Table) -> String {
    let Some(values) = table.column(FREE_FIELD.0) else { return String::new() };
    let finite = || values.iter().copied().filter(|x| x.is_finite());
    let Some(end) = finite().next_back() else { return String::new() };
    format!(
        " Work through the sides is that of the ground outside free-field sides on the model: of its forces, beyond those at \
         the start, and of the dashpots between. It counts into the model: {} at the end, between {} and {} over the run. \
         Level ground without caverns passes on next to nothing of the input; far below zero are scattered waves that leave.",
        quantity("J", end),
        quantity("J", finite().fold(f64::INFINITY, f64::min)),
        quantity("J", finite().fold(f64::NEG_INFINITY, f64::max))
    )
}

/// How the error that is drawn and that of the check differ; empty without the check.
fn beside_check(source: &Source) -> String {
    let facts = source.facts();
    let check = facts.trust.iter().find(|line| line.id == ERROR_CHECK && !line.not_applicable);
    let text = |line: &TrustLine| {
        format!(
            " It holds ⅛Δt²aᵀMa, which belongs to the scheme and shrinks with the step; the check '{}' leaves that out, so its \
             number is another.",
            line.name
        )
    };
    check.map_or(String::new(), text)
}

/// What interfaces hold and have taken at the end of the table; empty without them.
fn of_interfaces(table: &Table) -> String {
    let last = |line: &str| table.column(line).and_then(|values| values.last()).copied();
    let (Some(held), Some(friction)) = (last("interface"), last("friction")) else { return String::new() };
    let mut text = format!(
        " At the end interfaces hold {}; friction and broken bonds have taken {}",
        quantity("J", held),
        quantity("J", friction)
    );
    if let Some(damping) = last("contact_damping") {
        text.push_str(&format!(", contact damping {}", quantity("J", damping)));
    }
    if let Some(created) = last("created_by_interface") {
        text.push_str(&format!("; their laws have given out {} that nobody put in", quantity("J", created)));
    }
    text.push('.');
    text
}

/// What bolts hold and have taken at the end of the table; empty without them.
fn of_bolts(table: &Table) -> String {
    let last = |line: &str| table.column(line).and_then(|values| values.last()).copied();
    let [Some(held), Some(friction), Some(plastic)] = OF_BOLTS.map(|(line, _)| last(line)) else {
        return String::new();
    };
    let [held, friction, plastic] = [held, friction, plastic].map(|x| quantity("J", x));
    format!(" At the end bolts hold {held}; their bonds have taken {friction}, their yield {plastic}.")
}

/// The section of the page.
pub fn section<'a>(source: &'a Source) -> Section {
    let table = match &source.energy {
        Ok(table) => table,
        Err(why) => return Section::left_out(HEADING, why),
    };
    let most = lines(table).map(|(_, values)| largest(values)).fold(0.0, f64::max);
    if most == 0.0 {
        return Section::left_out(HEADING, "energy.csv holds no line that is not zero.");
    }
    let (drawn, idle): (Vec<_>, Vec<_>) =
        in_order(table).into_iter().partition(|(_, values)| largest(values) > 0.0);
    // Those of interfaces and bolts are small beside what goes through the model, and want scales of their own.
    let is_of = |lines: &[(&str, &str)], name: &str| lines.iter().any(|(line, _)| *line == name);
    let (contact, drawn): (Vec<_>, Vec<_>) =
        drawn.into_iter().partition(|(name, _)| is_of(&OF_INTERFACES, name));
    let (bolts, drawn): (Vec<_>, Vec<_>) = drawn.into_iter().partition(|(name, _)| is_of(&OF_BOLTS, name));
    let mut colours = (0..).filter(|k| *k != ERROR_COLOUR);
    let mut panels = Vec::new();
    for (title, lines) in [("energy", drawn), ("energy of interfaces", contact), ("energy of bolts", bolts)] {
        let most = lines.iter().map(|(_, values)| largest(values)).fold(0.0, f64::max);
        let line = |((name, values), colour): ((&'a str, &'a [f64]), usize)| Line {
            name: words(name, table),
            values: values.into(),
            colour,
            stroke: Stroke::Thin,
        };
        let lines: Vec<Line> = lines.into_iter().zip(colours.by_ref()).map(line).collect();
        if !lines.is_empty() {
            panels.push(Panel {
                title: title.into(),
                scale: Scale::suiting("J", most),
                lines,
                mark: Mark::Largest,
            });
        }
    }
    let mut caption = match (table.column("error"), worst_error(table)) {
        (Some(error), Some((worst, ratio))) => {
            let line = Line {
                name: "error".into(),
                values: error.into(),
                colour: ERROR_COLOUR,
                stroke: Stroke::Thin,
            };
            panels.push(Panel {
                title: "error".into(),
                scale: Scale::suiting("J", worst),
                lines: vec![line],
                mark: Mark::Largest,
            });
            let percent = figures(100.0 * ratio, 2);
            format!(
                "The error is at most {}, {percent}\u{a0}% of the largest energy held.{}",
                quantity("J", worst),
                beside_check(source)
            )
        }
        _ => "energy.csv has no column error.".into(),
    };
    caption.push_str(&through_sides(table));
    caption.push_str(&of_interfaces(table));
    caption.push_str(&of_bolts(table));
    if !idle.is_empty() {
        let names = idle.iter().map(|(name, _)| words(name, table)).collect::<Vec<_>>().join(", ");
        caption.push_str(&format!(" Zero throughout: {names}."));
    }
    let time = table.column("time").unwrap_or(&[]);
    let chart = Chart { title: HEADING.into(), time, panels };
    Section::Drawn(vec![Figure {
        heading: HEADING.into(),
        file: "energy.svg".into(),
        svg: chart.draw(),
        caption,
        curves: Some(Curves::of_chart(&chart)),
    }])
}
