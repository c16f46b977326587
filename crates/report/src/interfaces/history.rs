//! Figures of what interfaces did over time.

use std::borrow::Cow;

use tremolite_results::{Subject, Table};

use crate::chapter::figure::{Figure, Section};
use crate::drawing::chart::{Chart, Curve, Mark, Panel, Stroke};
use crate::language::{Language, say};
use crate::quantities::scale::{Scale, quantity};
use crate::quantities::units::Kind;
use crate::script::curves::Curves;
use crate::source::Source;
use crate::source::monitor_pairs;

/// A column, its name, and which colour.
type Wanted = (&'static str, String, usize);

fn areas(language: Language) -> [Wanted; 4] {
    [
        ("ever_slid", say!(language, "slid so far"), 1),
        ("ever_opened", say!(language, "opened so far"), 0),
        ("sliding", say!(language, "sliding now"), 5),
        ("open", say!(language, "open now"), 6),
    ]
}

fn lengths(language: Language) -> [Wanted; 2] {
    [
        ("max_slip", say!(language, "largest slip so far"), 4),
        ("max_gap", say!(language, "largest gap so far"), 2),
    ]
}

/// Names of the interfaces: those of the summary, or of the table's columns.
pub fn names(source: &Source) -> Vec<String> {
    let known: Vec<String> = source.facts().parts.interfaces.keys().cloned().collect();
    if !known.is_empty() {
        return known;
    }
    let tables = source.interfaces.iter().flatten();
    tables
        .flat_map(|table| monitor_pairs::names(table, |subject| matches!(subject, Subject::Interface(_))))
        .collect()
}

/// The section of the page; nothing for a run without interfaces.
pub fn section(source: &Source) -> Option<Section> {
    let language = source.language;
    let heading = say!(language, "Interfaces over time");
    let table = match source.interfaces.as_ref()? {
        Ok(table) => table,
        Err(why) => return Some(Section::left_out(&heading, why)),
    };
    let facts = source.facts();
    let mut figures = Vec::new();
    let mut idle = Vec::new();
    for (k, name) in names(source).iter().enumerate() {
        let area = facts.parts.interfaces.get(name).map_or(f64::NAN, |own| own.area);
        match figure(source, table, name, area) {
            Some(figure) => {
                figures.push(Figure { file: format!("interface-history-{}.svg", k + 1), ..figure })
            }
            None => idle.push(name.clone()),
        }
    }
    if let (Some(last), false) = (figures.last_mut(), idle.is_empty()) {
        last.caption.push_str(&say!(
            language,
            " Nothing slid or opened on {names}.",
            names = idle.join(", ")
        ));
    }
    Some(if figures.is_empty() {
        Section::left_out(&heading, say!(language, "No interface slid or opened."))
    } else {
        Section::Drawn(figures)
    })
}

/// One interface; none where nothing slid or opened.
fn figure(source: &Source, table: &Table, name: &str, area: f64) -> Option<Figure> {
    let language = source.language;
    let column = |quantity: &str| table.column(&format!("{name}.{quantity}"));
    let most = |values: &[f64]| values.iter().copied().filter(|x| x.is_finite()).fold(0.0, f64::max);
    let line = |(quantity, name, colour): Wanted| {
        let values = column(quantity).filter(|values| most(values) > 0.0)?;
        Some(Curve { name, values: Cow::from(values), colour, stroke: Stroke::Thin })
    };
    let areas: Vec<Curve> = areas(language).into_iter().filter_map(line).collect();
    if areas.is_empty() {
        return None;
    }
    let scale = if area > 0.0 {
        Scale { factor: 100.0 / area, unit: say!(language, "% of its area") }
    } else {
        Scale { factor: 1.0, unit: "m²".into() }
    };
    let mut panels = vec![Panel { title: say!(language, "area"), scale, lines: areas, mark: Mark::Highest }];
    let lengths: Vec<Curve> = lengths(language).into_iter().filter_map(line).collect();
    if !lengths.is_empty() {
        let scale = source.scale(Kind::Opening);
        panels.push(Panel { title: say!(language, "slip, gap"), scale, lines: lengths, mark: Mark::Highest });
    }
    let which = if area > 0.0 {
        say!(language, "Interface {name}, {area}", name = name, area = quantity("m2", area))
    } else {
        say!(language, "Interface {name}", name = name)
    };
    let caption = say!(
        language,
        "{which}: its area that slides and is open in each row of interfaces.csv, and that did in any step \
         so far; below, the largest slip and gap so far of pairs whose bond is broken, slip while they are closed. \
         Look whether slip goes on growing to the end: then the interface has not come to rest.",
        which = which
    );
    let time = table.column("time").unwrap_or(&[]);
    let chart = Chart { title: say!(language, "Interfaces over time: {name}", name = name), time, panels };
    Some(Figure {
        heading: say!(language, "Interfaces over time"),
        file: String::new(),
        svg: chart.draw(language),
        caption,
        curves: Some(Curves::of_chart(&chart, language)),
        narrow: None,
    })
}
