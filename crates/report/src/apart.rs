//! Histories in figures whose lines can be told apart: a few share a panel, more stand each alone.

use crate::chart::{Chart, Line, Panel};
use crate::figure::Figure;
use crate::language::{Language, say};
use crate::multiples::{Cell, Multiples};

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
    let figure = |number: usize, svg: String, caption: String| Figure {
        heading: titles.heading.into(),
        file: match number {
            0 => format!("{}.svg", titles.file),
            more => format!("{}-{}.svg", titles.file, more + 1),
        },
        svg,
        caption,
    };
    if panels.iter().all(|panel| panel.lines.len() <= TOGETHER) {
        let svg = Chart { title: titles.heading.into(), time, panels }.draw(language);
        return vec![figure(0, svg, titles.caption.into())];
    }
    let rows = rows(&panels);
    let sheets = rows.len().div_ceil(ROWS);
    let alone = say!(language, "Each line stands alone; grey is the range of all of them.");
    let caption = match titles.caption {
        "" => alone,
        caption => say!(language, "{first} {second}", first = caption, second = alone),
    };
    let drawn = rows.chunks(ROWS).enumerate().map(|(number, rows)| {
        let svg = Multiples { title: titles.heading, time, rows: rows.to_vec() }.draw(language);
        // Said once, below the last.
        let caption = if number + 1 == sheets { caption.clone() } else { String::new() };
        figure(number, svg, caption)
    });
    drawn.collect()
}

/// A row for each name with a cell for each panel, [`ABREAST`] panels at a time; where no name stands in two panels, each
/// panel's lines abreast.
fn rows<'a>(panels: &'a [Panel<'a>]) -> Vec<Vec<Option<Cell<'a>>>> {
    let of = |panel: &'a Panel<'a>, name: &str| -> Option<Cell<'a>> {
        let line: Option<&Line> = panel.lines.iter().find(|line| line.name == name);
        Some((panel, line?))
    };
    let shared = panels.iter().enumerate().any(|(k, panel)| {
        panel.lines.iter().any(|line| panels[..k].iter().any(|other| of(other, &line.name).is_some()))
    });
    if !shared {
        let abreast = |panel: &'a Panel<'a>| {
            let cells: Vec<Option<Cell>> = panel.lines.iter().map(|line| Some((panel, line))).collect();
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
