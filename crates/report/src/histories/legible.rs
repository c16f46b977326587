//! Histories in figures whose lines can be told apart: a few share a panel, more stand each alone.

use std::borrow::Cow;

use crate::chapter::figure::Figure;
use crate::drawing::chart::{Chart, Curve, Panel};
use crate::drawing::plot::NARROW;
use crate::drawing::small_multiples::{Multiples, PanelLine};
use crate::language::Language;
use crate::script::curves::Curves;

/// More lines than this hide one another.
const TOGETHER: usize = 4;
/// Cells abreast: more are too narrow to be read on paper.
const ABREAST: usize = 3;
/// Rows of cells that fit on a page of paper with heading and caption. What is left over is less and shares a page.
const ROWS: usize = 14;

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
    let rows = rows(&panels);
    let sheets = rows.len().div_ceil(ROWS);
    let drawn = rows.chunks(ROWS).enumerate().map(|(number, rows)| {
        let svg = Multiples { title: titles.heading, time, rows: rows.to_vec() }.draw(language);
        // Said once, below the last.
        let caption = if number + 1 == sheets { titles.caption.into() } else { String::new() };
        // The page's script shows one curve of many when it is asked to, so it gets panels with all of them.
        let chart = Chart { title: titles.heading.into(), time, panels: together(&panels, rows) };
        figure(number, svg, caption, &chart)
    });
    drawn.collect()
}

/// The panels with those of their lines that stand in these rows.
fn together<'a>(panels: &'a [Panel<'a>], rows: &[Vec<Option<PanelLine<'a>>>]) -> Vec<Panel<'a>> {
    let stands =
        |line: &Curve<'_>| rows.iter().flatten().flatten().any(|(_, other)| std::ptr::eq(*other, line));
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

/// A row for each name with a cell for each panel, [`ABREAST`] panels at a time; where no name stands in two panels, each
/// panel's lines abreast.
fn rows<'a>(panels: &'a [Panel<'a>]) -> Vec<Vec<Option<PanelLine<'a>>>> {
    let of = |panel: &'a Panel<'a>, name: &str| -> Option<PanelLine<'a>> {
        let line: Option<&Curve> = panel.lines.iter().find(|line| line.name == name);
        Some((panel, line?))
    };
    let shared = panels.iter().enumerate().any(|(k, panel)| {
        panel.lines.iter().any(|line| panels[..k].iter().any(|other| of(other, &line.name).is_some()))
    });
    if !shared {
        let abreast = |panel: &'a Panel<'a>| {
            let cells: Vec<Option<PanelLine>> = panel.lines.iter().map(|line| Some((panel, line))).collect();
            cells.chunks(ABREAST).map(<[_]>::to_vec).collect::<Vec<_>>()
        };
        return panels.iter().flat_map(abreast).collect();
    }
    let mut rows = Vec::new();
    for panels in panels.chunks(ABREAST) {
        let mut names: Vec<&str> = Vec::new();
        for line in panels.iter().flat_map(|panel| &panel.lines) {
            if !names.contains(&line.name.as_str()) {
                names.push(&line.name);
            }
        }
        rows.extend(names.iter().map(|name| panels.iter().map(|panel| of(panel, name)).collect()));
    }
    rows
}
