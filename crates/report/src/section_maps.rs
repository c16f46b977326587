//! The section maps of the page behind those of damage, in the order in which a reader asks: what stresses linings, how they
//! deform, and where rock yielded. Where linings came off the rock is in [`interfaces::map`](crate::interfaces::map).

mod deformed;
pub mod field_map;
pub mod mesh;
pub mod plastic_zones;
mod relative_motion;
pub mod section_view;
pub mod snapshots;

use crate::chapter::figure::Section;
use crate::language::say;
use crate::section_maps::field_map::Map;
use crate::section_maps::plastic_zones::{Files, Zones};
use crate::section_maps::section_view::plane;
use crate::section_maps::snapshots::Snapshots;
use crate::source::Source;

/// Room around linings, as a part of their extent.
const MARGIN: f64 = 0.25;

/// Stress, deformed shape and plastic zones; nothing where there is no map, which the maps of damage say.
pub fn sections(source: &Source) -> Vec<Section> {
    let Ok(snapshots) = Snapshots::readable(source) else { return Vec::new() };
    vec![stress(source, &snapshots), deformed::section(source, &snapshots), yielding(source, &snapshots)]
}

/// The largest principal stress over the run.
fn stress(source: &Source, snapshots: &Snapshots) -> Section {
    let language = source.language;
    let heading = say!(language, "Largest principal stress on the section");
    let fields = match snapshots.read(snapshots.last()) {
        Ok(fields) => fields,
        Err(why) => return Section::left_out(&heading, why),
    };
    let positions = source.facts().monitors.monitor_positions;
    let slice = fields.slice(plane(&positions));
    let cut = fields.cut(&slice, &["s1_max", "s1"]);
    let Some(cut) = cut.filter(|cut| cut.cells.iter().any(|cell| cell.value.is_finite())) else {
        return Section::left_out(&heading, say!(language, "The last field file has no field s1_max or s1."));
    };
    let when = match cut.field.as_str() {
        "s1_max" => {
            say!(
                language,
                "of each element the largest over the run, of intact elements of several points at the fibre"
            )
        }
        _ => snapshots.at(snapshots.last().time),
    };
    let map = Map {
        source,
        cut: &cut,
        heading: &heading,
        when: &when,
        title: &say!(language, "largest principal stress s1, tension positive"),
        look: &say!(
            language,
            "Tension is positive. Look for where a lining came near its tensile strength, and whether the rock behind it is drawn apart as \
             well."
        ),
        file: "section-s1.svg",
        lowest: false,
        margin: MARGIN,
    };
    Section::Drawn(vec![map.figure(&positions)])
}

/// Where rock had yielded before the shaking and has after it.
fn yielding(source: &Source, snapshots: &Snapshots) -> Section {
    let language = source.language;
    let heading = say!(language, "Plastic zones before and after the earthquake");
    let (first, last) = match (snapshots.read(snapshots.first()), snapshots.read(snapshots.last())) {
        (Ok(first), Ok(last)) => (first, last),
        (Err(why), _) | (_, Err(why)) => return Section::left_out(&heading, why),
    };
    let positions = source.facts().monitors.monitor_positions;
    let y = plane(&positions);
    let before = Zones::of(&first, &first.slice(y), snapshots.before());
    let after = Zones::of(&last, &last.slice(y), snapshots.after());
    let earlier = (snapshots.first() != snapshots.last()).then_some(&before);
    let files = Files { zones: "section-plastic.svg", strain: "section-plastic-strain.svg" };
    let (figures, notes) = after.figures(language, earlier, &heading, files, &positions);
    if figures.is_empty() { Section::left_out(&heading, notes.join(" ")) } else { Section::Drawn(figures) }
}
