//! Figure of a field on the section, as the elements have it.

use tremolite_results::{Cut, CutCell};

use crate::chapter::figure::Figure;
use crate::drawing::frame_row::MapRow;
use crate::drawing::window::Window;
use crate::language::say;
use crate::quantities::scale::Scale;
use crate::section_maps::section_view::{Edge, Positions, borders, on_plane, place, points, window};
use crate::source::Source;

/// A cut with what is said of it.
pub struct Map<'a> {
    pub source: &'a Source,
    pub cut: &'a Cut,
    pub heading: &'a str,
    /// At which time, or after which stage.
    pub when: &'a str,
    pub title: &'a str,
    /// What to look for, a sentence or more.
    pub look: &'a str,
    pub file: &'a str,
    /// Whether the lowest value is the one to be named, and the darkest.
    pub lowest: bool,
    /// As of [`window`].
    pub margin: f64,
}

impl Map<'_> {
    /// The figure; `positions` are points to be named in it.
    pub fn figure(&self, positions: &Positions) -> Figure {
        self.figure_with(positions, &[], &|_| Vec::new())
    }

    /// The same with more lines in it, and with lines that lead somewhere, for what the window shows.
    pub fn figure_with(
        &self,
        positions: &Positions,
        lines: &[Edge],
        leading: &dyn Fn(&Window) -> Vec<Vec<[f64; 2]>>,
    ) -> Figure {
        let (language, cut) = (self.source.language, self.cut);
        let window = window(cut, positions, self.margin, |_| false);
        let leading = leading(&window);
        let seen: Vec<&CutCell> = cut.cells.iter().filter(|cell| window.meets(&cell.outline)).collect();
        let finite = || seen.iter().copied().filter(|cell| cell.value.is_finite());
        let low = finite().map(|cell| cell.value).fold(f64::INFINITY, f64::min);
        let high = finite().map(|cell| cell.value).fold(f64::NEG_INFINITY, f64::max);
        let scale = self.source.units.suiting(&cut.unit, low.abs().max(high.abs()));
        let row = MapRow::of(window, 1);
        let borders = borders(&cut.cells);
        let mut frame = row.frame(low * scale.factor, high * scale.factor);
        if self.lowest {
            frame.darkest_is_lowest();
        }
        frame.outlines(&borders);
        frame.shapes(lines);
        leading.iter().for_each(|line| frame.leading(line));
        points(&mut frame, cut, positions);
        for cell in finite() {
            frame.cell(&cell.outline, cell.value * scale.factor);
        }
        let maps = vec![(String::new(), frame)];
        let svg =
            row.draw(&scale.labelled(self.title), &maps, &say!(language, "a section coloured by element"));
        Figure {
            heading: self.heading.into(),
            file: self.file.into(),
            svg,
            caption: self.caption(finite(), &scale),
            curves: None,
            narrow: None,
        }
    }

    fn caption<'a>(&self, cells: impl Iterator<Item = &'a CutCell>, scale: &Scale) -> String {
        let language = self.source.language;
        let plane = on_plane(language, self.cut.y);
        let mut said = vec![say!(
            language,
            "Field {field}, {when}, {plane}.",
            field = self.cut.field,
            when = self.when,
            plane = plane
        )];
        if !self.look.is_empty() {
            said.push(self.look.into());
        }
        let rank = |value: f64| if self.lowest { -value } else { value };
        if let Some(peak) = cells.max_by(|a, b| rank(a.value).total_cmp(&rank(b.value))) {
            let (value, place) = (scale.quantity(peak.value), place(language, peak));
            said.push(match self.lowest {
                true => say!(
                    language,
                    "Lowest value shown: {value} in the element at {place}.",
                    value = value,
                    place = place
                ),
                false => say!(
                    language,
                    "Highest value shown: {value} in the element at {place}.",
                    value = value,
                    place = place
                ),
            });
        }
        language.joined(&said)
    }
}
