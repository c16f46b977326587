//! Figures of the section through the caverns after the last stage: where the rock yielded, and the stresses.

use indexmap::IndexMap;
use tremolite_results::{Cut, CutCell, Pvd, Summary};

use crate::cut_figure::{Map, area, borders, on_plane, place, plane, points, window};
use crate::figure::{Block, Figure};
use crate::frame::Frame;
use crate::scale::{Scale, figures, trimmed};
use crate::source::Source;
use crate::stage_name::called;

const HEADING: &str = "The section after the last stage";
const SHEAR: (&str, &str) = ("shear", "#e58a4a");
const TENSION: (&str, &str) = ("tension", "#4a90c8");
const BOTH: (&str, &str) = ("both", "#8e4a9e");
const ELASTIC: (&str, &str) = ("elastic", "#dde1e6");
const NO_STRAIN: (&str, &str) = ("none", "#dde1e6");
/// Room around caverns, as a part of their extent: what they disturb reaches about that far.
const MARGIN: f64 = 0.6;
/// Plastic strain below this is round-off.
const YIELDED: f64 = 1e-12;

/// The positions of named points.
type Positions = IndexMap<String, [f64; 3]>;

/// The block; nothing where the run wrote no fields of stages and need not have.
pub fn block(source: &Source, facts: &Summary) -> Option<Block> {
    let left_out = |why: String| {
        Some(Block { heading: HEADING.into(), notes: vec![format!("Left out. {why}")], ..Block::default() })
    };
    let path = source.folder.stages_pvd();
    if !path.exists() {
        return (!facts.stages.is_empty())
            .then(|| left_out("The run wrote no fields of the stages (stages.pvd).".into()))?;
    }
    let pvd = match Pvd::read(&path) {
        Ok(pvd) => pvd,
        Err(e) => return left_out(format!("{e}.")),
    };
    let Some(last) = pvd.snapshots().last() else {
        return left_out("stages.pvd lists no file yet.".into());
    };
    let number = last.time.max(0.0) as usize;
    let when = facts
        .stages
        .get(number)
        .map_or(format!("stage {number}"), |stage| called(source.language, number, stage));
    let when = format!("after {when}");
    let file = pvd.locate(last);
    let y = plane(&facts.positions);
    let mut cuts = Vec::new();
    for field in ["plastic_state", "plastic_shear_strain", "s1", "s3"] {
        match Cut::read(&file, y, &[field]) {
            Ok(cut) => cuts.push(cut.filter(some_value)),
            Err(e) => return left_out(format!("{e}.")),
        }
    }
    let [state, strain, s1, s3] = &cuts[..] else { return None };
    let mut block = Block { heading: HEADING.into(), ..Block::default() };
    plastic(&mut block, (state.as_ref(), strain.as_ref()), &when, &facts.positions);
    for (cut, title, file, lowest) in [
        (s1, "largest principal stress s1, tension positive", "stage-s1.svg", false),
        (s3, "smallest principal stress s3, tension positive", "stage-s3.svg", true),
    ] {
        if let Some(cut) = cut {
            block
                .figures
                .push(Map { cut, when: &when, title, file, lowest, margin: MARGIN }.figure(&facts.positions));
        }
    }
    if s1.is_none() || s3.is_none() {
        block.notes.push("Stresses are not drawn: the last file of the stages lacks s1 or s3.".into());
    }
    Some(block)
}

fn some_value(cut: &Cut) -> bool {
    cut.cells.iter().any(|cell| cell.value.is_finite())
}

/// Where the rock has yielded, and how far.
fn plastic(
    block: &mut Block,
    (state, strain): (Option<&Cut>, Option<&Cut>),
    when: &str,
    positions: &Positions,
) {
    if state.is_none() && strain.is_none() {
        let note = "No plastic zone: the last file of the stages has neither plastic_state nor plastic_shear_strain.";
        block.notes.push(note.into());
        return;
    }
    let kind = |cell: &CutCell| kind(cell.value);
    let yields = |cut: &Cut| cut.cells.iter().any(|cell| kind(cell) != Some(ELASTIC) && kind(cell).is_some());
    let strains = |cut: &Cut| cut.cells.iter().any(|cell| cell.value > YIELDED);
    if !state.is_some_and(yields) && !strain.is_some_and(strains) {
        let cut = state.or(strain);
        let plane = cut.map_or(String::new(), |cut| format!(" {}", on_plane(cut)));
        block.notes.push(format!("No plastic zone: nothing has yielded {when}{plane}."));
        return;
    }
    if let Some(cut) = state.filter(|cut| yields(cut)) {
        block.figures.push(states(cut, when, positions));
    }
    if let Some(cut) = strain.filter(|cut| strains(cut)) {
        block.figures.push(strain_map(cut, when, positions));
    }
}

/// What flags of the state say: 1 and 4 shear, 2 and 8 tension, now and earlier.
fn kind(value: f64) -> Option<(&'static str, &'static str)> {
    let flags = if value.is_finite() { value as i64 } else { return None };
    Some(match (flags & 5 != 0, flags & 10 != 0) {
        (true, true) => BOTH,
        (true, false) => SHEAR,
        (false, true) => TENSION,
        (false, false) => ELASTIC,
    })
}

fn states(cut: &Cut, when: &str, positions: &Positions) -> Figure {
    let yields = |cell: &CutCell| kind(cell.value).is_some_and(|kind| kind != ELASTIC);
    let window = window(cut, positions, MARGIN, yields);
    let mut frame = Frame::new(window, 0.0, 1.0);
    // In this order beside the map.
    for wanted in [SHEAR, TENSION, BOTH, ELASTIC] {
        for cell in cut.cells.iter().filter(|cell| kind(cell.value) == Some(wanted)) {
            frame.kind(&cell.outline, wanted);
        }
    }
    frame.outlines(&borders(&cut.cells));
    points(&mut frame, cut, positions);
    let section = |wanted: fn(i64) -> bool| {
        let cells = cut.cells.iter().filter(|cell| cell.value.is_finite() && wanted(cell.value as i64));
        format!("{}\u{a0}m²", trimmed(&figures(cells.map(|cell| area(&cell.outline)).sum::<f64>(), 3)))
    };
    let caption = format!(
        "Elements in which any point has yielded up to now, in shear, in tension or both, {when}, {}: {} of the section in shear, \
         {} in tension. A zone of one element's depth is no more than the mesh can say; zones that join between caverns, or \
         reach deep into a pillar, are what to look for.",
        on_plane(cut),
        section(|flags| flags & 5 != 0),
        section(|flags| flags & 10 != 0)
    );
    let svg = frame.draw("plastic zones");
    Figure { heading: HEADING.into(), file: "stage-plastic.svg".into(), svg, caption }
}

fn strain_map(cut: &Cut, when: &str, positions: &Positions) -> Figure {
    let yielded = |cell: &CutCell| cell.value > YIELDED;
    let window = window(cut, positions, MARGIN, yielded);
    let most = cut.cells.iter().map(|cell| cell.value).filter(|x| x.is_finite()).fold(0.0, f64::max);
    // Strains of rock are thousandths.
    let scale = Scale { factor: 1e3, unit: "10⁻³".into() };
    let mut frame = Frame::new(window, 0.0, most * scale.factor);
    for cell in cut.cells.iter().filter(|cell| cell.value.is_finite()) {
        if yielded(cell) {
            frame.cell(&cell.outline, cell.value * scale.factor);
        } else {
            frame.kind(&cell.outline, NO_STRAIN);
        }
    }
    frame.outlines(&borders(&cut.cells));
    points(&mut frame, cut, positions);
    let mut caption = format!("Field {}, {when}, {}.", cut.field, on_plane(cut));
    if let Some(peak) =
        cut.cells.iter().filter(|c| c.value.is_finite()).max_by(|a, b| a.value.total_cmp(&b.value))
    {
        let value = figures(peak.value, 3);
        caption.push_str(&format!(" Highest value: {value} in the element at {}.", place(peak)));
    }
    let svg = frame.draw(&scale.labelled("plastic shear strain Γ"));
    Figure { heading: HEADING.into(), file: "stage-plastic-strain.svg".into(), svg, caption }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flags_of_now_and_earlier_count_alike() {
        let kinds = [0.0, 1.0, 4.0, 2.0, 8.0, 6.0, 9.0, f64::NAN].map(|x| kind(x).map(|kind| kind.0));
        let expected = ["elastic", "shear", "shear", "tension", "tension", "both", "both"];
        assert_eq!(kinds[..7], expected.map(Some));
        assert_eq!(kinds[7], None);
    }
}
