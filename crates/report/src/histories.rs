//! Figures of what the monitors recorded: displacement, differences, stress, velocity, acceleration, and whatever
//! else the table holds.

mod displacement;
pub mod gaps;
mod largest_of_steps;
pub mod legible;
mod stress;

use std::borrow::Cow;

use tremolite_results::{Subject, Table};

use crate::chapter::figure::Section;
use crate::drawing::chart::{Curve, Mark, Panel, Stroke};
use crate::histories::largest_of_steps::with_steps;
use crate::histories::legible::Titles;
use crate::language::{Language, say};
use crate::quantities::units::Kind;
use crate::source::Source;
use crate::source::monitor_pairs::{is_pair, names};

/// Quantities that belong in one figure.
struct Family {
    heading: String,
    file: &'static str,
    caption: String,
    /// Name in the table's header, title of the panel, what is marked.
    panels: Vec<(&'static str, String, Mark)>,
    /// Panels of less than this share of the largest are not drawn.
    negligible: f64,
}

/// Names in the header of the quantities that have families.
const FAMILIES: [&[&str]; 4] =
    [&["ux", "uy", "uz"], &["s1", "s3", "s1_elastic"], &["vx", "vy", "vz"], &["ax", "ay", "az"]];

/// Quantities beyond the families that are known, by figures: components of one tensor share one.
const TOGETHER: [&[&str]; 3] = [&["sxx", "syy", "szz"], &["sxy", "syz", "szx"], &["s2"]];

/// A component this much smaller than the largest one of its figure, loose pieces aside, tells nothing and is not drawn; its
/// size is told.
const SMALL: f64 = 5e-3;

/// What is this much smaller than another is round-off or nearly so.
const ROUND_OFF: f64 = 1e-6;

/// What one line of a figure shows: a monitor or a pair, and its history of one quantity.
type Histories<'a> = Vec<(String, Cow<'a, [f64]>)>;

/// The histories of a run, and whose they are.
pub struct Recorded<'a> {
    source: &'a Source,
    table: &'a Table,
    /// Those on interfaces apart, which have figures of their own.
    monitors: Vec<String>,
    pairs: Vec<String>,
}

/// Whose histories are drawn here one by one.
fn is_monitor(subject: &Subject) -> bool {
    matches!(subject, Subject::Monitor(_) | Subject::Bolt(_))
}

fn components(
    language: Language,
    names: &[&'static str; 3],
    mark: Mark,
) -> Vec<(&'static str, String, Mark)> {
    let titles = ["x".to_owned(), "y".to_owned(), say!(language, "z, up")];
    names.iter().zip(titles).map(|(name, title)| (*name, title, mark)).collect()
}

impl<'a> Recorded<'a> {
    /// What `monitors.csv` holds.
    ///
    /// # Errors
    /// The section that says why there is nothing.
    pub fn of(source: &'a Source) -> Result<Self, Section> {
        let table = source
            .monitors
            .as_ref()
            .map_err(|why| Section::left_out(&say!(source.language, "Histories of the monitors"), why))?;
        let pairs = names(table, is_pair);
        let monitors = names(table, is_monitor);
        let known = source.facts().monitors.relative;
        let mut all: Vec<String> = known.keys().cloned().collect();
        all.extend(pairs.into_iter().filter(|pair| !known.contains_key(pair)));
        Ok(Recorded { source, table, monitors, pairs: all })
    }

    fn of_monitors(&self, quantity: &str) -> Histories<'a> {
        let column = |name: &String| {
            Some((name.clone(), Cow::from(self.table.column(&format!("{name}.{quantity}"))?)))
        };
        self.monitors.iter().filter_map(column).collect()
    }

    pub fn velocity(&self) -> Section {
        let language = self.source.language;
        let names = ["vx", "vy", "vz"];
        let caption = with_steps(self.source, String::new(), &names, Kind::Velocity);
        let (heading, panels) = (say!(language, "Velocity"), components(language, &names, Mark::Largest));
        let family = Family { heading, file: "velocity", caption, panels, negligible: SMALL };
        self.family(family, |quantity| self.of_monitors(quantity))
    }

    pub fn acceleration(&self) -> Section {
        let language = self.source.language;
        let caption = say!(
            language,
            "A monitor that alone shows far more than the rock is on a loose piece that rings, or beside a crack that closes."
        );
        let caption = with_steps(self.source, caption, &["ax", "ay", "az"], Kind::Acceleration);
        let (heading, panels) =
            (say!(language, "Acceleration"), components(language, &["ax", "ay", "az"], Mark::Largest));
        self.family(
            Family { heading, file: "acceleration", caption, panels, negligible: SMALL },
            |quantity| self.of_monitors(quantity),
        )
    }

    /// Every quantity of the monitors that no family holds: those of [`TOGETHER`] first, then any other by itself, in
    /// the order of the table. So a quantity that the engine gains has its figure without a word here. What pairs have
    /// beyond displacement, its length, is left to the table.
    pub fn others(&self) -> Vec<Section> {
        let known = |quantity: &str| FAMILIES.iter().any(|names| names.contains(&quantity));
        let mut figures_of: Vec<Vec<(&str, Histories<'_>)>> = vec![Vec::new(); TOGETHER.len()];
        for (column, values) in self.table.columns.iter().zip(&self.table.values) {
            let quantity = column.quantity.as_str();
            let Some(monitor) = column.subject.name().filter(|_| is_monitor(&column.subject)) else {
                continue;
            };
            if known(quantity) {
                continue;
            }
            let history = (monitor, Cow::from(values.as_slice()));
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
            let titles = Titles { heading: &heading, file: &file, caption: "" };
            let panels = panels
                .into_iter()
                .map(|(quantity, histories)| self.panel(quantity, quantity.into(), Mark::Largest, histories));
            sections.push(self.drawn(&titles, panels.collect()));
        }
        sections
    }

    /// The largest value of monitors that did not come loose; of all where none is held.
    fn largest_held(&self, histories: &[(String, Cow<'_, [f64]>)]) -> f64 {
        let loose = self.source.facts().monitors.on_broken_elements;
        let of =
            |(name, values): &(String, Cow<'_, [f64]>)| (!loose.contains(name)).then(|| largest_of(values));
        histories.iter().filter_map(of).reduce(f64::max).unwrap_or_else(|| largest(histories))
    }

    fn unit(&self, quantity: &str) -> &'a str {
        self.table.columns.iter().find(|column| column.quantity == quantity).map_or("", |column| &column.unit)
    }

    fn panel<'h>(&self, quantity: &str, title: String, mark: Mark, histories: Histories<'h>) -> Panel<'h> {
        let scale = self.source.units.suiting(self.unit(quantity), largest(&histories));
        let lines = histories.into_iter().enumerate();
        let line = |(colour, (name, values))| Curve { name, values, colour, stroke: Stroke::Thin };
        Panel { title, scale, lines: lines.map(line).collect(), mark }
    }

    fn drawn(&self, titles: &Titles<'_>, panels: Vec<Panel<'_>>) -> Section {
        let time = self.table.column("time").unwrap_or(&[]);
        Section::Drawn(legible::figures(self.source.language, titles, time, panels))
    }

    fn family<'h>(&self, family: Family, of: impl Fn(&str) -> Histories<'h>) -> Section {
        let language = self.source.language;
        let wanted = family.panels.iter().map(|panel| panel.0).collect::<Vec<_>>().join(", ");
        let found: Vec<_> = family
            .panels
            .into_iter()
            .map(|panel| (of(panel.0), panel))
            .filter(|(histories, _)| !histories.is_empty())
            .collect();
        let most = found.iter().map(|(histories, _)| self.largest_held(histories)).fold(0.0, f64::max);
        if found.is_empty() {
            let why = say!(language, "monitors.csv has no columns of {names}.", names = wanted);
            return Section::left_out(&family.heading, why);
        }
        if most == 0.0 {
            return Section::left_out(&family.heading, say!(language, "All values are zero."));
        }
        let mut caption = family.caption;
        let mut panels = Vec::new();
        for (histories, (name, title, mark)) in found {
            if self.largest_held(&histories) >= family.negligible * most {
                panels.push(self.panel(name, title, mark, histories));
                continue;
            }
            let size = largest(&histories);
            let missing = if size == 0.0 {
                say!(language, "Not drawn: {title}, zero.", title = title)
            } else {
                let size = self.source.units.suiting(self.unit(name), size).quantity(size);
                say!(language, "Not drawn: {title}, nowhere more than {size}.", title = title, size = size)
            };
            caption = match caption.is_empty() {
                true => missing,
                false => say!(language, "{first} {second}", first = caption, second = missing),
            };
        }
        self.drawn(&Titles { heading: &family.heading, file: family.file, caption: &caption }, panels)
    }
}

fn largest(histories: &[(String, Cow<'_, [f64]>)]) -> f64 {
    histories.iter().map(|(_, values)| largest_of(values)).fold(0.0, f64::max)
}

fn largest_of(values: &[f64]) -> f64 {
    values.iter().filter(|x| x.is_finite()).fold(0.0, |most, x| f64::max(most, x.abs()))
}
