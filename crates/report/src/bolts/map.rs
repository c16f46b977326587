//! Figure of all bolts in the section, in the colours of what they carried.

use tremolite_results::{BoltLine, BoltLines, Cut, Pvd};

use crate::chapter::figure::{Block, Figure};
use crate::drawing::frame_row::MapRow;
use crate::drawing::window::Window;
use crate::language::say;
use crate::quantities::scale::{Scale, figures, trimmed};
use crate::quantities::units::Kind;
use crate::section_maps::section_view::{borders, plane};
use crate::source::Source;

const GROUND: &str = "#c3cad2";
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
    let scale = if share { Scale { factor: 1.0, unit: String::new() } } else { source.scale(Kind::Force) };
    let language = source.language;
    // A share has one scale on every page, so that a colour means the same; what is beyond is as dark as what yields.
    let row = MapRow::of(window, 1);
    let mut frame = row.frame(0.0, if share { 1.0 } else { most * scale.factor });
    let cut = cut(source);
    if let Some(cut) = &cut {
        for cell in &cut.cells {
            frame.kind(&cell.outline, &say!(language, "ground"), GROUND);
        }
        frame.outlines(&borders(&cut.cells));
    }
    for line in finite() {
        frame.stroke(ends(line), WIDTH, value(line) * scale.factor);
    }
    let title = if share {
        say!(language, "largest force over yield force")
    } else {
        say!(language, "largest force")
    };
    let description = say!(language, "bolts on a section, coloured by what they carried");
    let svg = row.draw(&scale.labelled(&title), &[(String::new(), frame)], &description);
    let group = lines.groups.get(worst.group).map_or("", String::as_str);
    let [x, y, z] = [0, 1, 2].map(|i| {
        let c = 0.5 * (worst.ends[0][i] + worst.ends[1][i]);
        trimmed(&format!("{c:.1}").replace('-', "−"))
    });
    let number = match share {
        true => say!(language, "{share} of yield", share = figures(most, 2)),
        false => scale.quantity(most),
    };
    let mut said = vec![match (!staged(source), share) {
        (true, true) => say!(
            language,
            "All bolts, seen along y, the worst on top; each segment by its largest force in any step since the earthquake began over \
             the force at which it yields, from the file {when}. Black violet is yield.",
            when = when
        ),
        (true, false) => say!(
            language,
            "All bolts, seen along y, the worst on top; each segment by its largest force in any step since the earthquake began; no \
             bolt of these yields. From the file {when}. Dark is the largest.",
            when = when
        ),
        (false, true) => say!(
            language,
            "All bolts, seen along y, the worst on top; each segment by its largest force in any step since the stage began over the \
             force at which it yields, from the file {when}. Black violet is yield.",
            when = when
        ),
        (false, false) => say!(
            language,
            "All bolts, seen along y, the worst on top; each segment by its largest force in any step since the stage began; no bolt \
             of these yields. From the file {when}. Dark is the largest.",
            when = when
        ),
    }];
    said.push(say!(
        language,
        "Look for bolts that are dark along a row or on one flank, where the ground pushes in, and for dark stretches in the middle \
         of bolts, where they cross what opens or slides."
    ));
    said.push(say!(
        language,
        "Largest: {number} in {group}, bolt {bolt}, at ({x}, {y}, {z}) m.",
        number = number,
        group = group,
        bolt = worst.bolt,
        x = x,
        y = y,
        z = z
    ));
    let lost = lines.lines.len() - left().count();
    if lost > 0 {
        said.push(say!(language, "Not drawn: {lost} segments that excavations took.", lost = lost));
    }
    said.push(match &cut {
        Some(cut) => {
            let y = trimmed(&format!("{:.2}", cut.y).replace('-', "−"));
            say!(language, "Openings and linings as at y = {y}\u{a0}m.", y = y)
        }
        None => say!(language, "No field file gives the openings."),
    });
    let heading = say!(language, "Where bolts carry most");
    let figure = Figure {
        heading: heading.clone(),
        file: "bolts-map.svg".into(),
        svg,
        caption: language.joined(&said),
        curves: None,
        narrow: None,
    };
    Some(Block { heading, figures: vec![figure], ..Block::default() })
}

/// Whether the last file of bolts is one of the stages.
fn staged(source: &Source) -> bool {
    let pvd = Pvd::read(&source.folder.bolts_pvd()).ok();
    pvd.and_then(|pvd| Some(pvd.snapshots().last()?.file.contains("stage-"))).unwrap_or(false)
}

/// The section through what stands; none where no field file can be read.
fn cut(source: &Source) -> Option<Cut> {
    let [fields, stages] = [source.folder.pvd(), source.folder.stages_pvd()];
    let paths = if source.shakes() { [fields, stages] } else { [stages, fields] };
    let positions = source.facts().monitors.monitor_positions;
    paths.into_iter().filter(|path| path.exists()).find_map(|path| {
        let pvd = Pvd::read(&path).ok()?;
        let file = source.fields.at(&pvd, pvd.snapshots().last()?).ok()?;
        file.cut(&file.slice(plane(&positions)), &["body", "element", "displacement"])
    })
}
