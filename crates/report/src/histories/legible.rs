//! Histories in figures whose lines can be told apart: a few share a panel, more stand each alone.

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};

use crate::chapter::figure::Figure;
use crate::drawing::axes::drawable;
use crate::drawing::chart::{Chart, Curve, Panel};
use crate::drawing::plot::NARROW;
use crate::drawing::small_multiples::{Multiples, PanelLine};
use crate::language::{Language, say};
use crate::script::curves::Curves;

/// More lines than this hide one another.
const TOGETHER: usize = 4;
/// Cells abreast: more are too narrow to be read on paper.
const ABREAST: usize = 3;
/// Rows of cells that fit on a page of paper with heading and caption. What is left over is less and shares a page.
const ROWS: usize = 14;
/// Names whose lines are drawn, six pages of paper: of more nobody reads each, and their figures would be larger than all else on the page.
const MOST: usize = 6 * ROWS;

/// What the figures are called.
pub struct Titles<'a> {
    /// On the page.
    pub heading: &'a str,
    /// Name of the file without its ending; further ones have a number behind it.
    pub file: &'a str,
    /// Below them.
    pub caption: &'a str,
}

/// The figures of these panels; where lines of one name stand in several panels, they share a row.
pub fn figures(language: Language, titles: &Titles<'_>, time: &[f64], panels: Vec<Panel<'_>>) -> Vec<Figure> {
    let figure = |number: usize, svg: String, caption: String, chart: &Chart<'_>| Figure {
        heading: titles.heading.into(),
        file: match number {
            0 => format!("{}.svg", titles.file),
            more => format!("{}-{}.svg", titles.file, more + 1),
        },
        svg,
        caption,
        curves: Some(Curves::of_chart(chart, language)),
        narrow: None,
    };
    if panels.iter().all(|panel| panel.lines.len() <= TOGETHER) {
        let chart = Chart { title: titles.heading.into(), time, panels };
        let drawn = figure(0, chart.draw(language), titles.caption.into(), &chart);
        return vec![Figure { narrow: Some(chart.draw_at(language, NARROW)), ..drawn }];
    }
    let all = names(&panels);
    let chosen = largest(&panels, &all);
    let rows = rows(&panels, &chosen);
    let caption = match all.len() - chosen.len() {
        0 => titles.caption.to_owned(),
        left => left_out(language, titles.caption, left, all.len()),
    };
    let sheets = rows.len().div_ceil(ROWS);
    let drawn = rows.chunks(ROWS).enumerate().map(|(number, rows)| {
        let svg = Multiples { title: titles.heading, time, rows: rows.to_vec() }.draw(language);
        // Said once, below the last.
        let caption = if number + 1 == sheets { caption.clone() } else { String::new() };
        // The page's script shows one curve of many when it is asked to, so it gets panels with all of them.
        let chart = Chart { title: titles.heading.into(), time, panels: together(&panels, rows) };
        figure(number, svg, caption, &chart)
    });
    drawn.collect()
}

/// The names of the lines of all panels, in their order.
fn names<'a>(panels: &'a [Panel<'a>]) -> Vec<&'a str> {
    let mut seen = HashSet::new();
    let all = panels.iter().flat_map(|panel| &panel.lines).map(|line| line.name.as_str());
    all.filter(|name| seen.insert(*name)).collect()
}

/// Of more than [`MOST`] names those whose lines come nearest to the largest size of their panel, in whichever panel.
fn largest<'a>(panels: &'a [Panel<'a>], all: &[&'a str]) -> HashSet<&'a str> {
    if all.len() <= MOST {
        return all.iter().copied().collect();
    }
    let mut share: HashMap<&str, f64> = HashMap::new();
    for panel in panels {
        let (low, high) = panel.range();
        let most = low.abs().max(high.abs());
        for line in &panel.lines {
            let sizes = line.values.iter().map(|x| x.abs()).filter(|x| drawable(*x));
            let own = sizes.fold(0.0, f64::max) / if most > 0.0 { most } else { 1.0 };
            let known = share.entry(&line.name).or_default();
            *known = known.max(own);
        }
    }
    let mut order = all.to_vec();
    order.sort_by(|a, b| share[b].total_cmp(&share[a]));
    order.truncate(MOST);
    order.into_iter().collect()
}

fn left_out(language: Language, caption: &str, left: usize, all: usize) -> String {
    let told = say!(
        language,
        "Drawn are the {most} of {all} that reach most; the other {left} are in the tables of the result folder and in the grey range.",
        most = MOST,
        all = all,
        left = left
    );
    match caption.is_empty() {
        true => told,
        false => say!(language, "{first} {second}", first = caption, second = told),
    }
}

/// The panels with those of their lines that stand in these rows.
fn together<'a>(panels: &'a [Panel<'a>], rows: &[Vec<Option<PanelLine<'a>>>]) -> Vec<Panel<'a>> {
    let standing: HashSet<*const Curve<'_>> =
        rows.iter().flatten().flatten().map(|(_, line)| std::ptr::from_ref(*line)).collect();
    let stands = |line: &Curve<'_>| standing.contains(&std::ptr::from_ref(line));
    let of = |panel: &'a Panel<'a>| {
        let lines = panel.lines.iter().filter(|line| stands(line)).map(|line| Curve {
            name: line.name.clone(),
            values: Cow::Borrowed(&line.values[..]),
            colour: line.colour,
            stroke: line.stroke,
        });
        Panel {
            title: panel.title.clone(),
            scale: panel.scale.clone(),
            lines: lines.collect(),
            mark: panel.mark,
        }
    };
    panels.iter().map(of).filter(|panel| !panel.lines.is_empty()).collect()
}

/// A row for each name of those chosen with a cell for each panel, [`ABREAST`] panels at a time; where no name stands in two panels, each
/// panel's lines abreast.
fn rows<'a>(panels: &'a [Panel<'a>], chosen: &HashSet<&str>) -> Vec<Vec<Option<PanelLine<'a>>>> {
    let lines = |panel: &'a Panel<'a>| panel.lines.iter().filter(|line| chosen.contains(line.name.as_str()));
    let by_name = |panel: &'a Panel<'a>| {
        let mut of: HashMap<&str, PanelLine<'a>> = HashMap::new();
        for line in lines(panel) {
            of.entry(&line.name).or_insert((panel, line));
        }
        of
    };
    let of: Vec<HashMap<&str, PanelLine<'a>>> = panels.iter().map(by_name).collect();
    let shared = of
        .iter()
        .enumerate()
        .any(|(k, panel)| panel.keys().any(|name| of[..k].iter().any(|other| other.contains_key(name))));
    if !shared {
        let abreast = |panel: &'a Panel<'a>| {
            let cells: Vec<Option<PanelLine>> = lines(panel).map(|line| Some((panel, line))).collect();
            cells.chunks(ABREAST).map(<[_]>::to_vec).collect::<Vec<_>>()
        };
        return panels.iter().flat_map(abreast).collect();
    }
    let mut rows = Vec::new();
    for (panels, of) in panels.chunks(ABREAST).zip(of.chunks(ABREAST)) {
        let names = names(panels).into_iter().filter(|name| chosen.contains(name));
        rows.extend(names.map(|name| of.iter().map(|panel| panel.get(name).copied()).collect()));
    }
    rows
}
