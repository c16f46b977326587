//! What a section through the model shows: where it lies, what of it is worth seeing, and the lines on it.

use std::collections::BTreeMap;

use indexmap::IndexMap;
use tremolite_results::{Cut, CutCell};

use crate::drawing::frame::Frame;
use crate::drawing::window::Window;
use crate::language::{Language, say};
use crate::quantities::scale::{figures, trimmed};

/// The positions of named points.
pub type Positions = IndexMap<String, [f64; 3]>;

/// Two ends (x, z).
pub type Edge = [[f64; 2]; 2];

/// The y of the monitors, where they have one in common; else the middle of the model.
pub fn plane(positions: &Positions) -> Option<f64> {
    let first = positions.values().next()?[1];
    positions.values().all(|p| (p[1] - first).abs() < 0.01).then_some(first)
}

/// Names the points that lie on the plane.
pub fn points(frame: &mut Frame, cut: &Cut, positions: &Positions) {
    for (name, [x, y, z]) in positions {
        if (y - cut.y).abs() < 0.01 {
            frame.point(name, [*x, *z]);
        }
    }
}

/// Where the plane lies, in words.
pub fn on_plane(language: Language, y: f64) -> String {
    say!(language, "on the plane y = {y}\u{a0}m", y = trimmed(&format!("{y:.2}").replace('-', "−")))
}

/// The middle of a cell, in words.
pub fn place(language: Language, cell: &CutCell) -> String {
    let [x, z] = middle(&cell.outline);
    say!(language, "x = {x}\u{a0}m, z = {z}\u{a0}m", x = figures(x, 3), z = figures(z, 3))
}

/// The mean of corners.
fn middle(outline: &[[f64; 2]]) -> [f64; 2] {
    [0, 1].map(|i| outline.iter().map(|c| c[i]).sum::<f64>() / outline.len().max(1) as f64)
}

/// What is worth seeing: all groups but the one with the largest share of the section (the rock), or else the
/// openings inside, or else the monitors, or else everything; with a margin. What `also` says of a cell is to be seen in any
/// case.
pub fn window(cut: &Cut, positions: &Positions, margin: f64, also: impl Fn(&CutCell) -> bool) -> Window {
    let rock = ground(&cut.cells);
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

/// The group with the largest share of the section.
fn ground(cells: &[CutCell]) -> Option<i64> {
    let mut areas: BTreeMap<i64, f64> = BTreeMap::new();
    for cell in cells {
        *areas.entry(cell.group).or_default() += area(&cell.outline);
    }
    areas.iter().max_by(|a, b| a.1.total_cmp(b.1)).map(|(group, _)| *group)
}

/// Edges of the section beside nothing, but for those of the model's own rim.
fn openings(cut: &Cut, all: &Window) -> Vec<Edge> {
    let [low, high] = all.corners();
    let on_rim = |edge: &Edge| {
        let along = |i: usize, c: f64| edge.iter().all(|p| (p[i] - c).abs() < 1e-3);
        (0..2).any(|i| along(i, low[i]) || along(i, high[i]))
    };
    let edges = edges(&cut.cells).into_iter();
    edges.filter(|sides| sides.len() == 1).map(|sides| sides[0].edge).filter(|edge| !on_rim(edge)).collect()
}

/// Of a polygon.
pub fn area(outline: &[[f64; 2]]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    0.5 * outline.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>().abs()
}

/// Edges of the section between different groups or beside nothing: the linings and the openings.
pub fn borders(cells: &[CutCell]) -> Vec<Edge> {
    border_sides(cells).into_iter().map(|sides| sides[0].edge).collect()
}

/// The same with the cells beside each edge.
pub fn border_sides(cells: &[CutCell]) -> Vec<Vec<CellSide>> {
    let is_border = |sides: &Vec<CellSide>| {
        let group = |side: &CellSide| cells[side.cell].group;
        sides.len() == 1 || sides.iter().any(|side| group(side) != group(&sides[0]))
    };
    edges(cells).into_iter().filter(is_border).collect()
}

/// An edge of a cell: which of its corners it begins at.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CellSide {
    pub cell: usize,
    pub corner: usize,
    pub edge: Edge,
}

/// Edges of the section, each with the cells beside it.
pub fn edges(cells: &[CutCell]) -> Vec<Vec<CellSide>> {
    let mut edges: BTreeMap<_, Vec<CellSide>> = BTreeMap::new();
    for (cell, own) in cells.iter().enumerate() {
        let next = own.outline.iter().cycle().skip(1);
        for (corner, (a, b)) in own.outline.iter().zip(next).enumerate() {
            let (ka, kb) = (key(a), key(b));
            if ka != kb {
                edges.entry((ka.min(kb), ka.max(kb))).or_default().push(CellSide {
                    cell,
                    corner,
                    edge: [*a, *b],
                });
            }
        }
    }
    edges.into_values().collect()
}

/// By which points are told apart: two cells meet the plane in the same point up to round-off, so to a tenth of a millimetre.
pub fn key(point: &[f64; 2]) -> [i64; 2] {
    point.map(|c| (c * 1e4).round() as i64)
}
