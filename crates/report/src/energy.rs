//! Figure of the energy balance: every line over time, and below it the error.

use std::borrow::Cow;

use tremolite_results::Table;

use crate::chapter::figure::Section;
use crate::drawing::chart::{Curve, Mark, Panel, Stroke};
use crate::histories::legible::{self, Titles};
use crate::language::{Language, say};
use crate::quantities::scale::figures;
use crate::quantities::units::Kind;
use crate::source::Source;

/// The dark one; the other lines pass it over.
const ERROR_COLOUR: usize = 3;

/// Lines of interfaces.
const OF_INTERFACES: [&str; 4] = ["interface", "friction", "created_by_interface", "contact_damping"];
/// Lines of bolts: what they hold, and what they have taken.
const OF_BOLTS: [&str; 3] = ["bolts", "bolt_friction", "bolt_plastic"];
/// Work through sides that follow the free field, positive into the model.
const FREE_FIELD: &str = "free_field";
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

/// What a line of a table is called on the page; its own name where this version does not know it.
fn words(line: &str, table: &Table, language: Language) -> String {
    match line {
        "kinetic" => say!(language, "kinetic"),
        "strain" => say!(language, "strain"),
        "hourglass" => say!(language, "hourglass"),
        "dissipated" => say!(language, "dissipated"),
        "created_by_law" => say!(language, "created by law"),
        "band_damping" => say!(language, "band damping"),
        "artificial_viscosity" => say!(language, "artificial viscosity"),
        "pore_water" => say!(language, "water that cannot leave its pores"),
        "interface" => say!(language, "held by interfaces"),
        "friction" => say!(language, "friction and broken bonds of interfaces"),
        "created_by_interface" => say!(language, "created by interface laws"),
        "contact_damping" => say!(language, "contact damping"),
        "bolts" => say!(language, "held by bolts and their bonds"),
        "bolt_friction" => say!(language, "bonds of bolts that slide"),
        "bolt_plastic" => say!(language, "bolts that yield and break"),
        "rayleigh_damping" => say!(language, "rayleigh damping"),
        "base_dashpots" => say!(language, "base dashpots"),
        // Beside free-field sides, whose dashpots are in the line of those.
        "side_dashpots" if table.column(FREE_FIELD).is_some() => {
            say!(language, "dashpots of viscous sides and top")
        }
        "side_dashpots" => say!(language, "side dashpots"),
        "levels" => say!(language, "borders of levels of steps"),
        "base_springs" => say!(language, "base springs"),
        FREE_FIELD => say!(language, "work through the sides"),
        "input" => say!(language, "input"),
        "own_forces" => say!(language, "work of a script's own forces"),
        "initial" => say!(language, "initial"),
        "error" => say!(language, "error"),
        other => other.replace('_', " "),
    }
}

/// All lines but the error, in the order of the table; work through the sides beside the input.
fn in_order(table: &Table) -> Vec<(&str, &[f64])> {
    let mut all: Vec<_> = lines(table).collect();
    if let Some(from) = all.iter().position(|(name, _)| *name == FREE_FIELD) {
        let through_sides = all.remove(from);
        let behind = all.iter().position(|(name, _)| *name == INPUT).map_or(from, |k| k + 1);
        all.insert(behind, through_sides);
    }
    all
}

/// What has come in through sides that follow the free field.
fn through_sides(source: &Source, table: &Table) -> Option<String> {
    let values = table.column(FREE_FIELD)?;
    let finite = || values.iter().copied().filter(|x| x.is_finite());
    let energy = |value: f64| source.quantity(Kind::Energy, value);
    Some(say!(
        source.language,
        "Work through the sides is that of the ground outside free-field sides on the model: of its forces, beyond those at \
         the start, and of the dashpots between. It counts into the model: {end} at the end, between {least} and {most} over \
         the run. Level ground without caverns passes on next to nothing of the input; far below zero are scattered waves that \
         leave.",
        end = energy(finite().next_back()?),
        least = energy(finite().fold(f64::INFINITY, f64::min)),
        most = energy(finite().fold(f64::NEG_INFINITY, f64::max))
    ))
}

/// How the error that is drawn and that of the check differ.
fn beside_check(source: &Source) -> Option<String> {
    let facts = source.facts();
    facts.soundness.checks.iter().find(|line| line.id == ERROR_CHECK && !line.not_applicable)?;
    Some(say!(
        source.language,
        "The error drawn includes ⅛Δt²aᵀMa, a part of the scheme that shrinks with the step. The check of the energy balance, below, \
         gives the error without it."
    ))
}

/// What interfaces hold and have taken at the end of the table.
fn of_interfaces(source: &Source, table: &Table) -> Option<String> {
    let language = source.language;
    let last = |line: &str| table.column(line)?.last().map(|value| source.quantity(Kind::Energy, *value));
    let mut text = say!(
        language,
        "At the end interfaces hold {held}; friction and broken bonds have taken {friction}.",
        held = last("interface")?,
        friction = last("friction")?
    );
    if let Some(damping) = last("contact_damping") {
        let more = say!(language, "Contact damping has taken {damping}.", damping = damping);
        text = join(language, &text, &more);
    }
    if let Some(created) = last("created_by_interface") {
        let more = say!(language, "Interface laws have created {created}.", created = created);
        text = join(language, &text, &more);
    }
    Some(text)
}

/// What bolts hold and have taken at the end of the table.
fn of_bolts(source: &Source, table: &Table) -> Option<String> {
    let last = |line: &str| table.column(line)?.last().map(|value| source.quantity(Kind::Energy, *value));
    let [held, friction, plastic] = OF_BOLTS.map(last);
    Some(say!(
        source.language,
        "At the end bolts hold {held}; their bonds have taken {friction}, their yield {plastic}.",
        held = held?,
        friction = friction?,
        plastic = plastic?
    ))
}

fn join(language: Language, first: &str, second: &str) -> String {
    say!(language, "{first} {second}", first = first, second = second)
}

fn panel<'a>(source: &Source, title: String, lines: Vec<Curve<'a>>) -> Panel<'a> {
    Panel { title, scale: source.scale(Kind::Energy), lines, mark: Mark::Largest }
}

/// The section of the page.
pub fn section(source: &Source) -> Section {
    let language = source.language;
    let heading = say!(language, "Energy balance");
    let table = match &source.energy {
        Ok(table) => table,
        Err(why) => return Section::left_out(&heading, why),
    };
    let most = lines(table).map(|(_, values)| largest(values)).fold(0.0, f64::max);
    if most == 0.0 {
        return Section::left_out(&heading, say!(language, "energy.csv holds no line that is not zero."));
    }
    let (drawn, idle): (Vec<_>, Vec<_>) =
        in_order(table).into_iter().partition(|(_, values)| largest(values) > 0.0);
    // Those of interfaces and bolts are small beside what goes through the model, and want axes of their own.
    let (contact, drawn): (Vec<_>, Vec<_>) =
        drawn.into_iter().partition(|(name, _)| OF_INTERFACES.contains(name));
    let (bolts, drawn): (Vec<_>, Vec<_>) = drawn.into_iter().partition(|(name, _)| OF_BOLTS.contains(name));
    let mut colours = (0..).filter(|k| *k != ERROR_COLOUR);
    let line = |name: &str, values, colour| Curve {
        name: words(name, table, language),
        values: Cow::Borrowed(values),
        colour,
        stroke: Stroke::Thin,
    };
    let mut panels = Vec::new();
    for (title, own) in [
        (say!(language, "energy"), drawn),
        (say!(language, "energy of interfaces"), contact),
        (say!(language, "energy of bolts"), bolts),
    ] {
        let own = own.into_iter().zip(colours.by_ref());
        let own: Vec<Curve> = own.map(|((name, values), colour)| line(name, values, colour)).collect();
        if !own.is_empty() {
            panels.push(panel(source, title, own));
        }
    }
    let mut said = Vec::new();
    match (table.column("error"), worst_error(table)) {
        (Some(error), Some((worst, ratio))) => {
            let error = line("error", error, ERROR_COLOUR);
            panels.push(panel(source, say!(language, "error"), vec![error]));
            said.push(beside_check(source).unwrap_or_else(|| {
                say!(
                    language,
                    "The error is at most {worst}, {percent}\u{a0}% of the largest energy held.",
                    worst = source.quantity(Kind::Energy, worst),
                    percent = figures(100.0 * ratio, 2)
                )
            }));
        }
        _ => said.push(say!(language, "{file} has no column {key}.", file = "energy.csv", key = "error")),
    }
    said.extend(through_sides(source, table));
    said.extend(of_interfaces(source, table));
    said.extend(of_bolts(source, table));
    if !idle.is_empty() {
        let names: Vec<String> = idle.iter().map(|(name, _)| words(name, table, language)).collect();
        said.push(say!(language, "Zero throughout: {names}.", names = names.join(&say!(language, ", "))));
    }
    let caption = said.into_iter().reduce(|a, b| join(language, &a, &b)).unwrap_or_default();
    let titles = Titles { heading: &heading, file: "energy", caption: &caption };
    Section::Drawn(legible::figures(language, &titles, table.column("time").unwrap_or(&[]), panels))
}
