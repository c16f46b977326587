//! Steady seepage of stages: what walls and drains take, and the pressure of the water on the section.

use tremolite_results::{CutCell, Fields, Slice, Summary};

use crate::chapter::figure::{Block, Figure};
use crate::chapter::text_table::{Cell, Head, TextTable};
use crate::drawing::window::Window;
use crate::flow::{self, FlowCell, FlowLine};
use crate::language::say;
use crate::quantities::scale::figures;
use crate::section_maps::field_map::Map;
use crate::section_maps::section_view::{Edge, Positions, edges};
use crate::source::Source;
use crate::stages::names::called;

/// Room around caverns, as a part of their extent: the water is drawn down farther than stresses are changed.
const MARGIN: f64 = 1.0;
/// Flow lines on the section, so that each is well seen: how many at most, and how long all are over its diagonal.
const LINES: usize = 120;
const LENGTH: f64 = 12.0;
/// How far a line is drawn from where it is at most, over the diagonal.
const OFF: f64 = 2e-4;

/// The table; nothing without seepage.
pub fn table(source: &Source, facts: &Summary) -> Option<Block> {
    let language = source.language;
    let head = vec![
        Head::words(say!(language, "stage")),
        Head::words(say!(language, "wall or drain")),
        Head::number(say!(language, "inflow (l/s)")),
        Head::number(say!(language, "mass error")),
    ];
    let mut rows = Vec::new();
    for (k, stage) in facts.computed.stages.iter().enumerate() {
        let Some(flow) = &stage.seepage else { continue };
        let name = called(language, k, stage);
        let none = [(say!(language, "none"), 0.0)];
        let taken = flow.taken.iter().map(|(place, q)| (place.clone(), *q));
        let taken: Vec<(String, f64)> = if flow.taken.is_empty() { none.into() } else { taken.collect() };
        for (i, (place, q)) in taken.into_iter().enumerate() {
            let first = |text: String| if i == 0 { text } else { String::new() };
            rows.push(vec![
                Cell::words(first(name.clone())),
                Cell::words(place),
                Cell::number(if q == 0.0 { "0".into() } else { figures(1e3 * q, 3) }),
                Cell::number(first(figures(flow.mass_error, 1))),
            ]);
        }
    }
    if rows.is_empty() {
        return None;
    }
    Some(Block {
        heading: say!(language, "Seepage"),
        text: say!(
            language,
            "Water that walls and drains take in the steady state of each stage, of the whole model. Mass error: what comes in less what \
             leaves, over what comes in."
        ),
        tables: vec![TextTable { head: vec![head], rows }],
        ..Block::default()
    })
}

/// The pressure on the section with the free surface; nothing where the file has none.
pub fn map(
    source: &Source,
    file: &Fields,
    slice: &Slice,
    heading: &str,
    when: &str,
    positions: &Positions,
) -> Option<Figure> {
    let language = source.language;
    let cut = file.cut(slice, &["p"]).filter(|cut| cut.cells.iter().any(|cell| cell.value > 0.0))?;
    let discharge = file.of_elements("seepage");
    let mut look = say!(
        language,
        "Lines separate elements with water under pressure from those without: the free surface. Look for how far the openings drain \
         the rock, and for pressure right behind a lining."
    );
    if discharge.is_some() {
        look = language.joined(&[
            look,
            say!(
                language,
                "Thin lines with arrows are flow lines in the plane of the section, below the free surface alone: the closer they lie, the more water flows. \
                 They end where the water leaves the ground or the section."
            ),
        ]);
    }
    let map = Map {
        source,
        cut: &cut,
        heading,
        when,
        title: &say!(language, "pressure of the water p"),
        look: &look,
        file: "stage-p.svg",
        lowest: false,
        margin: MARGIN,
    };
    let lines =
        |window: &Window| discharge.as_deref().map_or_else(Vec::new, |q| lines(slice, &cut.cells, q, window));
    Some(map.figure_with(positions, &surface(&cut.cells), &lines))
}

/// Flow lines in the plane of the section where the window shows them, by the discharge of each cell (m/s), through what has water under pressure.
fn lines(slice: &Slice, cells: &[CutCell], discharge: &[[f64; 3]], window: &Window) -> Vec<FlowLine<2>> {
    let wet = slice.pieces.iter().zip(cells).filter(|(_, cell)| cell.value > 0.0);
    let flowing = wet.map(|(piece, cell)| {
        let [x, _, z] = discharge[piece.cell];
        FlowCell { corners: cell.outline.clone(), flow: [x, z], wanted: window.meets(&cell.outline) }
    });
    let [width, height] = window.size();
    let diagonal = width.hypot(height);
    let found = flow::lines(&flowing.collect::<Vec<_>>(), LENGTH * diagonal, LINES);
    found.iter().map(|line| flow::thinned(line, OFF * diagonal)).collect()
}

/// Edges between cells with pressure and cells without.
fn surface(cells: &[CutCell]) -> Vec<Edge> {
    let wet = |cell: usize| cells[cell].value > 0.0;
    let parts = edges(cells)
        .into_iter()
        .filter(|sides| sides.iter().any(|side| wet(side.cell) != wet(sides[0].cell)));
    parts.map(|sides| sides[0].edge).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_free_surface_lies_between_cells_with_pressure_and_without() {
        let cell = |low: f64, value| CutCell {
            outline: vec![[0.0, low], [1.0, low], [1.0, low + 1.0], [0.0, low + 1.0]],
            value,
            group: 0,
        };
        let found = surface(&[cell(0.0, 2.0), cell(1.0, 0.5), cell(2.0, 0.0)]);
        assert_eq!(found, [[[1.0, 2.0], [0.0, 2.0]]]);
        assert!(surface(&[cell(0.0, 0.0), cell(1.0, 0.0)]).is_empty());
    }
}
