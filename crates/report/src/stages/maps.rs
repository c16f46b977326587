//! Figures of the section through the caverns after the last stage: where the rock yielded, and the stresses.

use tremolite_results::{Pvd, Summary};

use crate::chapter::figure::Block;
use crate::language::say;
use crate::section_maps::field_map::Map;
use crate::section_maps::plastic_zones::{Files, Zones};
use crate::section_maps::section_view::plane;
use crate::source::Source;
use crate::stages::names::called;
use crate::stages::seepage;

/// Room around caverns, as a part of their extent: what they disturb reaches about that far.
const MARGIN: f64 = 0.6;

/// The block; nothing where the run wrote no fields of stages and need not have.
pub fn block(source: &Source, facts: &Summary) -> Option<Block> {
    let language = source.language;
    let heading = say!(language, "The section after the last stage");
    let left_out = |why: String| {
        let note = say!(language, "Left out. {why}", why = why);
        Some(Block { heading: heading.clone(), notes: vec![note], ..Block::default() })
    };
    let path = source.folder.stages_pvd();
    if !path.exists() {
        return (!facts.computed.stages.is_empty())
            .then(|| left_out(say!(language, "The run wrote no fields of the stages (stages.pvd).")))?;
    }
    let pvd = match Pvd::read(&path) {
        Ok(pvd) => pvd,
        Err(e) => return left_out(format!("{e}.")),
    };
    let Some(last) = pvd.snapshots().last() else {
        return left_out(say!(language, "stages.pvd lists no file yet."));
    };
    let number = last.time.max(0.0) as usize;
    let stage = match facts.computed.stages.get(number) {
        Some(stage) => called(language, number, stage),
        None => say!(language, "stage {k}", k = number),
    };
    let when = say!(language, "after {stage}", stage = stage);
    let file = match source.fields.at(&pvd, last) {
        Ok(file) => file,
        Err(why) => return left_out(why),
    };
    let positions = &facts.monitors.monitor_positions;
    let slice = file.slice(plane(positions));
    let zones = Zones::of(&file, &slice, when.clone());
    let files = Files { zones: "stage-plastic.svg", strain: "stage-plastic-strain.svg" };
    let (mut figures, mut notes) = zones.figures(language, None, &heading, files, positions);
    let mut missing = false;
    for (field, title, look, file_name, lowest) in [
        (
            "s1",
            say!(language, "largest principal stress s1, tension positive"),
            say!(
                language,
                "Look for tension in the rock at crowns and walls: there it may loosen, and support has to hold it."
            ),
            "stage-s1.svg",
            false,
        ),
        (
            "s3",
            say!(language, "smallest principal stress s3, tension positive"),
            say!(
                language,
                "Look for the darkest places, where compression concentrates, and for how far they reach into pillars."
            ),
            "stage-s3.svg",
            true,
        ),
    ] {
        let cut = file.cut(&slice, &[field]);
        let Some(cut) = cut.filter(|cut| cut.cells.iter().any(|cell| cell.value.is_finite())) else {
            missing = true;
            continue;
        };
        let map = Map {
            source,
            cut: &cut,
            heading: &heading,
            when: &when,
            title: &title,
            look: &look,
            file: file_name,
            lowest,
            margin: MARGIN,
        };
        figures.push(map.figure(positions));
    }
    figures.extend(seepage::map(source, &file, &slice, &heading, &when, positions));
    if missing {
        notes.push(say!(language, "Stresses are not drawn: the last file of the stages lacks s1 or s3."));
    }
    Some(Block { heading, figures, notes, ..Block::default() })
}
