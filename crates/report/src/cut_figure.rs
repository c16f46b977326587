//! Figure of a section through the caverns, coloured by a field of the last field file.

use std::collections::BTreeMap;

use indexmap::IndexMap;
use tremolite_results::{Cut, CutCell, Pvd};

use crate::figure::{Figure, Section};
use crate::frame::{Frame, Window};
use crate::scale::{Scale, figures, trimmed};
use crate::source::Source;

const HEADING: &str = "Section through the caverns";
/// Room around what is to be seen, as a part of its extent.
const MARGIN: f64 = 0.25;

/// What is drawn where the file has it: names in order of preference, title, file name.
const FIELDS: [(&[&str], &str, &str); 3] = [
    (&["d_tension"], "damage in tension, 0 sound to 1 broken", "section-damage.svg"),
    (&["s1_max", "s1"], "largest principal stress s1", "section-s1.svg"),
    (&["displacement_max"], "largest displacement over the run", "section-displacement.svg"),
];

/// The section of the page.
pub fn section(source: &Source) -> Section {
    let path = source.folder.pvd();
    if !path.exists() {
        return Section::left_out(HEADING, "There is no fields.pvd in the result folder.");
    }
    let pvd = match Pvd::read(&path) {
        Ok(pvd) => pvd,
        Err(e) => return Section::left_out(HEADING, format!("{e}.")),
    };
    let Some(last) = pvd.snapshots().last() else {
        return Section::left_out(HEADING, "fields.pvd lists no field file yet.");
    };
    let positions = source.facts().positions;
    let mut drawn = Vec::new();
    for (names, title, file) in FIELDS {
        match Cut::read(&pvd.locate(last), plane(&positions), names) {
            Err(e) => return Section::left_out(HEADING, format!("{e}.")),
            Ok(Some(cut)) if cut.cells.iter().any(|cell| cell.value.is_finite()) => {
                let when = if cut.field.ends_with("_max") {
                    "largest over the run".into()
                } else {
                    format!("at {} s", last.time)
                };
                drawn.push(
                    Map { cut: &cut, when: &when, title, file, lowest: false, margin: MARGIN }
                        .figure(&positions),
                );
            }
            Ok(_) => {}
        }
    }
    if drawn.is_empty() {
        return Section::left_out(
            HEADING,
            "The last field file has no field d_tension, s1_max, s1 or displacement_max.",
        );
    }
    Section::Drawn(drawn)
}

/// The y of the monitors, where they have one in common; else the middle of the model.
pub fn plane(positions: &IndexMap<String, [f64; 3]>) -> Option<f64> {
    let first = positions.values().next()?[1];
    positions.values().all(|p| (p[1] - first).abs() < 0.01).then_some(first)
}

/// A cut with what is said of it.
pub struct Map<'a> {
    pub cut: &'a Cut,
    /// At which time, or after which stage.
    pub when: &'a str,
    pub title: &'a str,
    pub file: &'a str,
    /// Whether the lowest value is the one to be named, and the darkest.
    pub lowest: bool,
    /// As of [`window`].
    pub margin: f64,
}

impl Map<'_> {
    /// The figure; `positions` are points to be named in it.
    pub fn figure(&self, positions: &IndexMap<String, [f64; 3]>) -> Figure {
        let cut = self.cut;
        let window = window(cut, positions, self.margin, |_| false);
        let cells: Vec<&CutCell> = cut.cells.iter().filter(|cell| window.meets(&cell.outline)).collect();
        let finite = || cells.iter().filter(|cell| cell.value.is_finite());
        let low = finite().map(|cell| cell.value).fold(f64::INFINITY, f64::min);
        let high = finite().map(|cell| cell.value).fold(f64::NEG_INFINITY, f64::max);
        let scale = Scale::suiting(&cut.unit, low.abs().max(high.abs()));
        let mut frame = Frame::new(window, low * scale.factor, high * scale.factor);
        if self.lowest {
            frame.darkest_is_lowest();
        }
        for cell in finite() {
            frame.cell(&cell.outline, cell.value * scale.factor);
        }
        frame.outlines(&borders(&cut.cells));
        points(&mut frame, cut, positions);
        let mut caption = format!("Field {}, {}, {}.", cut.field, self.when, on_plane(cut));
        let rank = |value: f64| if self.lowest { -value } else { value };
        if let Some(peak) = finite().max_by(|a, b| rank(a.value).total_cmp(&rank(b.value))) {
            let word = if self.lowest { "Lowest" } else { "Highest" };
            let (value, place) = (scale.quantity(peak.value), place(peak));
            caption.push_str(&format!(" {word} value shown: {value} in the element at {place}."));
        }
        let svg = frame.draw(&scale.labelled(self.title));
        Figure { heading: HEADING.into(), file: self.file.into(), svg, caption, curves: None }
    }
}

/// Names the points that lie on the plane.
pub fn points(frame: &mut Frame, cut: &Cut, positions: &IndexMap<String, [f64; 3]>) {
    for (name, [x, y, z]) in positions {
        if (y - cut.y).abs() < 0.01 {
            frame.point(name, [*x, *z]);
        }
    }
}

/// Where the plane lies, in words.
pub fn on_plane(cut: &Cut) -> String {
    format!("on the plane y = {}\u{a0}m", trimmed(&format!("{:.2}", cut.y).replace('-', "−")))
}

/// The middle of a cell, in words.
pub fn place(cell: &CutCell) -> String {
    let [x, z] = [0, 1].map(|i| cell.outline.iter().map(|c| c[i]).sum::<f64>() / cell.outline.len() as f64);
    format!("x = {}\u{a0}m, z = {}\u{a0}m", figures(x, 3), figures(z, 3))
}

/// What is worth seeing: all groups but the one with the largest share of the section (the rock), or else the
/// openings inside, or else the monitors, or else everything; with a margin. What `also` says of a cell is to be seen in any
/// case.
pub fn window(
    cut: &Cut,
    positions: &IndexMap<String, [f64; 3]>,
    margin: f64,
    also: impl Fn(&CutCell) -> bool,
) -> Window {
    let mut areas: BTreeMap<i64, f64> = BTreeMap::new();
    for cell in &cut.cells {
        *areas.entry(cell.group).or_default() += area(&cell.outline);
    }
    let rock = areas.iter().max_by(|a, b| a.1.total_cmp(b.1)).map(|(group, _)| *group);
    let all = Window::around(cut.cells.iter().flat_map(|cell| cell.outline.iter().copied()));
    let lined = cut.cells.iter().filter(|cell| Some(cell.group) != rock);
    let mut focus = Window::around(lined.flat_map(|cell| cell.outline.iter().copied()));
    if focus.is_empty() {
        focus = Window::around(openings(cut, &all).into_iter().flatten());
    }
    if focus.is_empty() && positions.len() > 1 {
        focus = Window::around(positions.values().map(|[x, _, z]| [*x, *z]));
    }
    if focus.is_empty() {
        return all;
    }
    let wanted = cut.cells.iter().filter(|cell| also(cell)).flat_map(|cell| cell.outline.iter().copied());
    let wanted = Window::around(focus.widened(margin).corners().into_iter().chain(wanted));
    wanted.within(&all)
}

/// Edges of the section beside nothing, but for those of the model's own rim.
fn openings(cut: &Cut, all: &Window) -> Vec<Edge> {
    let [low, high] = all.corners();
    let on_rim = |edge: &Edge| {
        let along = |i: usize, c: f64| edge.iter().all(|p| (p[i] - c).abs() < 1e-3);
        (0..2).any(|i| along(i, low[i]) || along(i, high[i]))
    };
    edges(&cut.cells)
        .filter(|(edge, sides)| sides.len() == 1 && !on_rim(edge))
        .map(|(edge, _)| edge)
        .collect()
}

/// Of a polygon.
pub fn area(outline: &[[f64; 2]]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    0.5 * outline.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>().abs()
}

/// Two ends (x, z).
pub type Edge = [[f64; 2]; 2];

/// Edges of the section between different groups or beside nothing: the linings and the openings.
pub fn borders(cells: &[CutCell]) -> Vec<Edge> {
    let is_border = |sides: &[i64]| sides.len() == 1 || sides.iter().any(|group| *group != sides[0]);
    edges(cells).filter(|(_, sides)| is_border(sides)).map(|(edge, _)| edge).collect()
}

/// Edges of the section, each with the groups beside it.
fn edges(cells: &[CutCell]) -> impl Iterator<Item = (Edge, Vec<i64>)> {
    // Two cells meet the plane in the same edge up to round-off: compare to a tenth of a millimetre.
    let key = |p: &[f64; 2]| p.map(|c| (c * 1e4).round() as i64);
    let mut edges: BTreeMap<_, (Edge, Vec<i64>)> = BTreeMap::new();
    for cell in cells {
        let next = cell.outline.iter().cycle().skip(1);
        for (a, b) in cell.outline.iter().zip(next) {
            let (ka, kb) = (key(a), key(b));
            if ka != kb {
                let (_, sides) = edges.entry((ka.min(kb), ka.max(kb))).or_insert(([*a, *b], Vec::new()));
                sides.push(cell.group);
            }
        }
    }
    edges.into_values()
}
