//! Figure of all bolts in the section, in the colours of what they carried.

use indexmap::IndexMap;
use tremolite_results::{BoltLine, BoltLines, Cut, Pvd};

use crate::cut_figure::{borders, plane};
use crate::figure::{Block, Figure};
use crate::frame::{Frame, Window};
use crate::scale::{Scale, figures, trimmed};
use crate::source::Source;

const HEADING: &str = "Where bolts carry most";
const GROUND: (&str, &str) = ("ground", "#c3cad2");
/// Room around what bolts reach, as a part of its extent.
const MARGIN: f64 = 0.12;
/// Width of a bolt in units of the figure.
const WIDTH: f64 = 2.6;
/// State of what an excavation has taken.
const CUT_OFF: u8 = 4;

/// The block; nothing where no segment is left.
pub fn block(source: &Source, lines: &BoltLines, when: &str) -> Option<Block> {
    let left = || lines.lines.iter().filter(|line| line.state != CUT_OFF);
    let ends = |line: &BoltLine| line.ends.map(|[x, _, z]| [x, z]);
    let window = Window::around(left().flat_map(ends)).widened(MARGIN);
    if window.is_empty() {
        return None;
    }
    // As a share of yield where any group yields, else as a force.
    let share = left().any(|line| line.force_over_yield_max > 0.0);
    let value = |line: &BoltLine| if share { line.force_over_yield_max } else { line.force_max.abs() };
    let finite = || left().filter(|line| value(line).is_finite());
    let worst = finite().max_by(|a, b| value(a).total_cmp(&value(b)))?;
    let most = value(worst);
    let scale = if share { Scale { factor: 1.0, unit: String::new() } } else { Scale::suiting("N", most) };
    // A share has one scale on every page, so that a colour means the same; what is beyond is as dark as what yields.
    let mut frame = Frame::new(window, 0.0, if share { 1.0 } else { most * scale.factor });
    let cut = cut(source);
    if let Some(cut) = &cut {
        for cell in &cut.cells {
            frame.kind(&cell.outline, GROUND);
        }
        frame.outlines(&borders(&cut.cells));
    }
    for line in finite() {
        frame.stroke(ends(line), WIDTH, value(line) * scale.factor);
    }
    let title = if share { "largest force over yield force" } else { "largest force" };
    let svg = frame.draw(&scale.labelled(title));
    let group = lines.groups.get(worst.group).map_or("", String::as_str);
    let [x, y, z] = [0, 1, 2].map(|i| {
        let c = 0.5 * (worst.ends[0][i] + worst.ends[1][i]);
        trimmed(&format!("{c:.1}").replace('-', "−"))
    });
    let number = if share { format!("{} of yield", figures(most, 2)) } else { scale.quantity(most) };
    let (unit, colour) = match share {
        true => (" over the force at which it yields", "Black violet is yield"),
        false => ("; no bolt of these yields", "Dark is the largest"),
    };
    let since = if when.contains("stages") { "stage" } else { "earthquake" };
    let mut caption = format!(
        "All bolts, seen along y, the worst on top; each segment by its largest force in any step since the {since} \
         began{unit}, from the file {when}. {colour}: look for bolts that are dark along a row or on one flank, where the ground \
         pushes in, and for dark stretches in the middle of bolts, where they cross what opens or slides. Largest: {number} in \
         {group}, bolt {}, at ({x}, {y}, {z}) m.",
        worst.bolt
    );
    let lost = lines.lines.len() - left().count();
    if lost > 0 {
        caption.push_str(&format!(" Not drawn: {lost} segments that excavations took."));
    }
    match &cut {
        Some(cut) => {
            let y = trimmed(&format!("{:.2}", cut.y).replace('-', "−"));
            caption.push_str(&format!(" Openings and linings as at y = {y}\u{a0}m."));
        }
        None => caption.push_str(" No field file gives the openings."),
    }
    let figure = Figure { heading: HEADING.into(), file: "bolts-map.svg".into(), svg, caption, curves: None };
    Some(Block { heading: HEADING.into(), figures: vec![figure], ..Block::default() })
}

/// The section through what stands; none where no field file can be read.
fn cut(source: &Source) -> Option<Cut> {
    let [fields, stages] = [source.folder.pvd(), source.folder.stages_pvd()];
    let paths = if source.shakes() { [fields, stages] } else { [stages, fields] };
    let positions: IndexMap<String, [f64; 3]> = source.facts().positions;
    paths.into_iter().filter(|path| path.exists()).find_map(|path| {
        let pvd = Pvd::read(&path).ok()?;
        let file = pvd.locate(pvd.snapshots().last()?);
        Cut::read(&file, plane(&positions), &["body", "element", "displacement"]).ok()?
    })
}
