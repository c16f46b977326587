//! Figures of what the monitors recorded: displacement, differences, stress, velocity, acceleration, and whatever
//! else the table holds.

use std::borrow::Cow;

use tremolite_results::Table;

use crate::chart::{Chart, Line, Mark, Panel, Stroke};
use crate::contact_monitors::is_on_interface;
use crate::curves::Curves;
use crate::figure::{Figure, Section};
use crate::pairs::{difference, is_pair, names};
use crate::scale::{Scale, quantity};
use crate::source::Source;
use crate::svg::LINES;

/// Quantities that belong in one figure: name in the header, title of the panel, what is marked.
struct Family {
    heading: &'static str,
    file: &'static str,
    caption: &'static str,
    panels: &'static [(&'static str, &'static str, Mark)],
}

const DISPLACEMENT: Family = Family {
    heading: "Displacement",
    file: "displacement",
    caption: "Relative to the state before the earthquake.",
    panels: &[("ux", "x", Mark::Largest), ("uy", "y", Mark::Largest), ("uz", "z, up", Mark::Largest)],
};
const VELOCITY: Family = Family {
    heading: "Velocity",
    file: "velocity",
    caption: "",
    panels: &[("vx", "x", Mark::Largest), ("vy", "y", Mark::Largest), ("vz", "z, up", Mark::Largest)],
};
const ACCELERATION: Family = Family {
    heading: "Acceleration",
    file: "acceleration",
    caption: "",
    panels: &[("ax", "x", Mark::Largest), ("ay", "y", Mark::Largest), ("az", "z, up", Mark::Largest)],
};
const STRESS: Family = Family {
    heading: "Principal stress",
    file: "stress",
    caption: "Tension is positive.",
    panels: &[
        ("s1", "s1, the largest principal stress", Mark::Highest),
        ("s3", "s3, the smallest principal stress", Mark::Lowest),
    ],
};

/// Quantities beyond the families that are known, by figures: components of one tensor share one.
const TOGETHER: [&[&str]; 3] = [&["sxx", "syy", "szz"], &["sxy", "syz", "szx"], &["s2"]];

/// A component this much smaller than the largest one of its figure is round-off or nearly so, and not drawn.
const NEGLIGIBLE: f64 = 1e-6;

/// What one line of a figure shows: a monitor or a pair, and its history of one quantity.
type Histories<'a> = Vec<(String, Cow<'a, [f64]>)>;

/// The sections of the page that show histories.
pub fn sections(source: &Source) -> Vec<Section> {
    let table = match &source.monitors {
        Ok(table) => table,
        Err(why) => return vec![Section::left_out("Histories of the monitors", why)],
    };
    let names = names(table);
    let (pairs, monitors): (Vec<String>, Vec<String>) =
        names.iter().cloned().partition(|name| is_pair(name, &names));
    // Those on interfaces have figures of their own.
    let monitors: Vec<String> = monitors.into_iter().filter(|name| !is_on_interface(table, name)).collect();
    let mut all_pairs: Vec<String> = source.facts().relative.keys().cloned().collect();
    all_pairs.extend(pairs.into_iter().filter(|pair| !source.facts().relative.contains_key(pair)));

    let of_monitors = |quantity: &str| -> Histories<'_> {
        let column =
            |name: &String| Some((name.clone(), Cow::from(table.column(&format!("{name}.{quantity}"))?)));
        monitors.iter().filter_map(column).collect()
    };
    let of_pairs = |quantity: &str| -> Histories<'_> {
        let pair = |name: &String| Some((name.clone(), difference(table, &monitors, name, quantity)?));
        all_pairs.iter().filter_map(pair).collect()
    };
    let relative = Family {
        heading: "Relative displacement",
        file: "relative",
        caption: "Of each pair, the displacement of the first monitor less that of the second.",
        panels: DISPLACEMENT.panels,
    };
    let mut sections = vec![family(table, &DISPLACEMENT, of_monitors)];
    sections.push(if all_pairs.is_empty() {
        Section::left_out(relative.heading, "The case names no pairs of monitors ([[relative]]).")
    } else {
        family(table, &relative, of_pairs)
    });
    sections.extend([&STRESS, &VELOCITY, &ACCELERATION].map(|f| family(table, f, of_monitors)));
    sections.extend(others(table, &monitors));
    sections
}

fn largest(histories: &Histories<'_>) -> f64 {
    let finite = histories.iter().flat_map(|(_, values)| values.iter()).filter(|x| x.is_finite());
    finite.fold(0.0, |most, x| f64::max(most, x.abs()))
}

fn unit<'a>(table: &'a Table, quantity: &str) -> &'a str {
    let is = |name: &str| name.rsplit_once('.').is_some_and(|(_, q)| q == quantity);
    table.columns.iter().find(|column| is(&column.name)).map_or("", |column| &column.unit)
}

fn family<'a>(table: &'a Table, family: &Family, of: impl Fn(&str) -> Histories<'a>) -> Section {
    let found: Vec<_> =
        family.panels.iter().map(|panel| (panel, of(panel.0))).filter(|(_, h)| !h.is_empty()).collect();
    let most = found.iter().map(|(_, histories)| largest(histories)).fold(0.0, f64::max);
    if found.is_empty() {
        let wanted = family.panels.iter().map(|panel| panel.0).collect::<Vec<_>>().join(", ");
        return Section::left_out(family.heading, format!("monitors.csv has no columns of {wanted}."));
    }
    if most == 0.0 {
        return Section::left_out(family.heading, "All values are zero.");
    }
    let mut caption = family.caption.to_owned();
    let mut panels = Vec::new();
    for (&(quantity_name, title, mark), histories) in found {
        let size = largest(&histories);
        let unit = unit(table, quantity_name);
        if size < NEGLIGIBLE * most {
            let text = if size == 0.0 {
                "zero".into()
            } else {
                format!("nowhere more than {}", quantity(unit, size))
            };
            caption.push_str(&format!(" Not drawn: {title}, {text}."));
        } else {
            panels.push(Wanted { title: title.into(), scale: Scale::suiting(unit, size), mark, histories });
        }
    }
    Section::Drawn(figures(table, family.heading, family.file, caption.trim(), panels))
}

/// A panel before the lines are dealt out to figures.
struct Wanted<'a> {
    title: String,
    scale: Scale,
    mark: Mark,
    histories: Histories<'a>,
}

impl Wanted<'_> {
    /// The panel with the lines of these names alone.
    fn with(&self, names: &[&str]) -> Panel<'_> {
        let mut lines = Vec::new();
        for (name, values) in &self.histories {
            if let Some(colour) = names.iter().position(|n| n == name) {
                lines.push(Line {
                    name: name.clone(),
                    values: Cow::Borrowed(values),
                    colour,
                    stroke: Stroke::Thin,
                });
            }
        }
        Panel { title: self.title.clone(), scale: self.scale.clone(), lines, mark: self.mark }
    }
}

/// One figure for every seven names: as many as there are colours.
fn figures(table: &Table, heading: &str, file: &str, caption: &str, panels: Vec<Wanted<'_>>) -> Vec<Figure> {
    let mut names: Vec<&str> = Vec::new();
    for (name, _) in panels.iter().flat_map(|panel| &panel.histories) {
        if !names.contains(&name.as_str()) {
            names.push(name);
        }
    }
    let batches = names.chunks(LINES.len()).enumerate();
    let figures = batches.map(|(number, names)| {
        let panels =
            panels.iter().map(|panel| panel.with(names)).filter(|panel| !panel.lines.is_empty()).collect();
        let time = table.column("time").unwrap_or(&[]);
        let suffix = if number == 0 { String::new() } else { format!("-{}", number + 1) };
        let chart = Chart { title: heading.into(), time, panels };
        Figure {
            heading: if number == 0 { heading.into() } else { format!("{heading}, continued") },
            file: format!("{file}{suffix}.svg"),
            svg: chart.draw(),
            caption: caption.into(),
            curves: Some(Curves::of_chart(&chart)),
        }
    });
    figures.collect()
}

/// Every quantity of the monitors that no family holds: those of [`TOGETHER`] first, then any other by itself, in the
/// order of the table. So a quantity that the engine gains has its figure without a word here. What pairs have beyond
/// displacement, its length, is left to the table.
fn others(table: &Table, monitors: &[String]) -> Vec<Section> {
    let families = [&DISPLACEMENT, &STRESS, &VELOCITY, &ACCELERATION];
    let known =
        |quantity: &str| families.iter().any(|family| family.panels.iter().any(|panel| panel.0 == quantity));
    let mut figures_of: Vec<Vec<(&str, Histories<'_>)>> = vec![Vec::new(); TOGETHER.len()];
    for (column, values) in table.columns.iter().zip(&table.values) {
        let Some((monitor, quantity)) = column.name.rsplit_once('.') else { continue };
        if known(quantity) || !monitors.iter().any(|name| name == monitor) {
            continue;
        }
        let history = (monitor.to_owned(), Cow::from(values.as_slice()));
        match figures_of.iter_mut().flatten().find(|(name, _)| *name == quantity) {
            Some((_, histories)) => histories.push(history),
            None => {
                let panel = (quantity, vec![history]);
                match TOGETHER.iter().position(|names| names.contains(&quantity)) {
                    Some(figure) => figures_of[figure].push(panel),
                    None => figures_of.push(vec![panel]),
                }
            }
        }
    }
    let mut sections = Vec::new();
    for panels in figures_of.into_iter().filter(|panels| !panels.is_empty()) {
        let heading = panels.iter().map(|panel| panel.0).collect::<Vec<_>>().join(", ");
        let file = format!("further-{}", sections.len() + 1);
        let wanted = panels.into_iter().map(|(quantity, histories)| Wanted {
            title: quantity.into(),
            scale: Scale::suiting(unit(table, quantity), largest(&histories)),
            mark: Mark::Largest,
            histories,
        });
        sections.push(Section::Drawn(figures(table, &heading, &file, "", wanted.collect())));
    }
    sections
}
