//! Figure of the mesh on the section through the caverns, with the monitors named.

use tremolite_results::{Cut, Pvd};

use crate::chapter::figure::{Figure, Section};
use crate::drawing::frame_row::MapRow;
use crate::language::say;
use crate::quantities::scale::{count, trimmed};
use crate::section_maps::section_view::{area, plane, points, window};
use crate::source::Source;

/// Room around what is to be seen, as a part of its extent.
const MARGIN: f64 = 0.25;
const ROCK: &str = "#efe9df";
const LINING: &str = "#b9c6d3";

/// The section of the page; nothing where no field file tells the bodies apart.
pub fn section(source: &Source) -> Option<Section> {
    let language = source.language;
    let positions = source.facts().monitors.monitor_positions;
    let of_file = |path: &std::path::Path| {
        let pvd = Pvd::read(path).ok()?;
        let last = pvd.snapshots().last()?;
        let file = source.fields.at(&pvd, last).ok()?;
        file.cut(&file.slice(plane(&positions)), &["body"])
    };
    let cut = of_file(&source.folder.pvd()).or_else(|| of_file(&source.folder.stages_pvd()))?;
    let window = window(&cut, &positions, MARGIN, |_| false);
    let shown = || cut.cells.iter().filter(|cell| window.meets(&cell.outline));
    let rock = largest_body(&cut)?;
    let row = MapRow::of(window.clone(), 1);
    let mut frame = row.frame(0.0, 1.0);
    for cell in shown() {
        frame.kind(&cell.outline, "", if cell.group == rock { ROCK } else { LINING });
    }
    let edges = shown().flat_map(|cell| {
        let next = cell.outline.iter().cycle().skip(1);
        cell.outline.iter().zip(next).map(|(a, b)| [*a, *b])
    });
    frame.outlines(&edges.collect::<Vec<_>>());
    points(&mut frame, &cut, &positions);
    let heading = say!(language, "The section and its monitors");
    let caption = say!(
        language,
        "Elements on the plane y = {y}\u{a0}m: {shown} of the {all} that the plane meets are shown. Dark is what is not rock. Places of the \
         monitors are under 'Model'. Are the elements small where stresses change fast, round the openings and at the corners?",
        y = trimmed(&format!("{:.2}", cut.y).replace('-', "−")),
        shown = count(shown().count() as u64),
        all = count(cut.cells.len() as u64)
    );
    let description = say!(language, "the elements of a section");
    let svg = row.draw(&say!(language, "mesh of the section"), &[(String::new(), frame)], &description);
    Some(Section::Drawn(vec![Figure {
        heading,
        file: "section-mesh.svg".into(),
        svg,
        caption,
        curves: None,
        narrow: None,
    }]))
}

/// The number of the body that takes most of the section: the rock.
fn largest_body(cut: &Cut) -> Option<i64> {
    let mut areas: std::collections::BTreeMap<i64, f64> = std::collections::BTreeMap::new();
    for cell in &cut.cells {
        *areas.entry(cell.group).or_default() += area(&cell.outline);
    }
    areas.into_iter().max_by(|a, b| a.1.total_cmp(&b.1)).map(|(group, _)| group)
}
