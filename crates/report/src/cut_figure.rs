//! Figure of a section through the caverns, coloured by a field of the last field file.

use std::collections::BTreeMap;

use indexmap::IndexMap;
use tremolite_results::{Cut, CutCell, Pvd};

use crate::figure::{Figure, Section};
use crate::frame::{Frame, Window};
use crate::scale::{Scale, figures, trimmed};
use crate::source::Source;

const HEADING: &str = "Section through the caverns";

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
                drawn.push(figure(&cut, last.time, title, file, &positions));
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
fn plane(positions: &IndexMap<String, [f64; 3]>) -> Option<f64> {
    let first = positions.values().next()?[1];
    positions.values().all(|p| (p[1] - first).abs() < 0.01).then_some(first)
}

fn figure(cut: &Cut, time: f64, title: &str, file: &str, positions: &IndexMap<String, [f64; 3]>) -> Figure {
    let window = window(cut, positions);
    let cells: Vec<&CutCell> = cut.cells.iter().filter(|cell| window.meets(&cell.outline)).collect();
    let finite = || cells.iter().filter(|cell| cell.value.is_finite());
    let low = finite().map(|cell| cell.value).fold(f64::INFINITY, f64::min);
    let high = finite().map(|cell| cell.value).fold(f64::NEG_INFINITY, f64::max);
    let scale = Scale::suiting(&cut.unit, low.abs().max(high.abs()));
    let mut frame = Frame::new(window, low * scale.factor, high * scale.factor);
    for cell in finite() {
        frame.cell(&cell.outline, cell.value * scale.factor);
    }
    frame.outlines(&borders(&cut.cells));
    for (name, [x, y, z]) in positions {
        if (y - cut.y).abs() < 0.01 {
            frame.point(name, [*x, *z]);
        }
    }
    let when =
        if cut.field.ends_with("_max") { "largest over the run".into() } else { format!("at {time} s") };
    let unit = if scale.unit.is_empty() { String::new() } else { format!(" ({})", scale.unit) };
    let mut caption = format!(
        "Field {}, {when}, on the plane y = {}\u{a0}m.",
        cut.field,
        trimmed(&format!("{:.2}", cut.y))
    );
    if let Some(peak) = finite().max_by(|a, b| a.value.total_cmp(&b.value)) {
        let [x, z] =
            [0, 1].map(|i| peak.outline.iter().map(|c| c[i]).sum::<f64>() / peak.outline.len() as f64);
        let (value, x, z) = (scale.quantity(peak.value), figures(x, 3), figures(z, 3));
        caption.push_str(&format!(
            " Highest value shown: {value} in the element at x = {x}\u{a0}m, z = {z}\u{a0}m."
        ));
    }
    Figure { heading: HEADING.into(), file: file.into(), svg: frame.draw(&format!("{title}{unit}")), caption }
}

/// What is worth seeing: all groups but the one with the largest share of the section (the rock), or else the
/// monitors, or else everything; with a margin.
fn window(cut: &Cut, positions: &IndexMap<String, [f64; 3]>) -> Window {
    let mut areas: BTreeMap<i64, f64> = BTreeMap::new();
    for cell in &cut.cells {
        *areas.entry(cell.group).or_default() += area(&cell.outline);
    }
    let rock = areas.iter().max_by(|a, b| a.1.total_cmp(b.1)).map(|(group, _)| *group);
    let all = Window::around(cut.cells.iter().flat_map(|cell| cell.outline.iter().copied()));
    let lined = cut.cells.iter().filter(|cell| Some(cell.group) != rock);
    let mut focus = Window::around(lined.flat_map(|cell| cell.outline.iter().copied()));
    if focus.is_empty() && positions.len() > 1 {
        focus = Window::around(positions.values().map(|[x, _, z]| [*x, *z]));
    }
    if focus.is_empty() { all } else { focus.widened(0.25).within(&all) }
}

fn area(outline: &[[f64; 2]]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    0.5 * outline.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>().abs()
}

/// Two ends (x, z).
type Edge = [[f64; 2]; 2];

/// Edges of the section between different groups or beside nothing: the linings and the openings.
fn borders(cells: &[CutCell]) -> Vec<Edge> {
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
    let is_border = |sides: &[i64]| sides.len() == 1 || sides.iter().any(|group| *group != sides[0]);
    edges.values().filter(|(_, sides)| is_border(sides)).map(|(edge, _)| *edge).collect()
}
