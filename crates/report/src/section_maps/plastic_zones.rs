//! Where rock has yielded, on the section: by kind, and how far.

use tremolite_results::{Cut, CutCell, Fields, Slice};

use crate::chapter::figure::Figure;
use crate::drawing::frame::Frame;
use crate::drawing::frame_row::MapRow;
use crate::language::{Language, say};
use crate::quantities::scale::{Scale, figures, trimmed};
use crate::section_maps::section_view::{Positions, area, borders, on_plane, place, points, window};

/// Colours of kinds of yielding.
const SHEAR: &str = "#e58a4a";
const TENSION: &str = "#4a90c8";
const BOTH: &str = "#8e4a9e";
const ELASTIC: &str = "#dde1e6";
/// Room around caverns, as a part of their extent: what they disturb reaches about that far.
const MARGIN: f64 = 0.6;
/// Plastic strain below this is round-off.
const YIELDED: f64 = 1e-12;

/// What a file says of yielding.
pub struct Zones {
    /// Of which time or stage.
    when: String,
    state: Option<Cut>,
    strain: Option<Cut>,
    y: f64,
}

/// File names of the two figures.
pub struct Files {
    pub zones: &'static str,
    pub strain: &'static str,
}

impl Zones {
    /// On a plane through a file.
    pub fn of(fields: &Fields, slice: &Slice, when: String) -> Self {
        let cut = |name: &str| {
            let cut = fields.cut(slice, &[name])?;
            cut.cells.iter().any(|cell| cell.value.is_finite()).then_some(cut)
        };
        Zones { when, state: cut("plastic_state"), strain: cut("plastic_shear_strain"), y: slice.y }
    }

    /// Whether anything yielded.
    fn yields(&self) -> bool {
        let flagged = |cut: &Cut| cut.cells.iter().any(|cell| yielded(cell.value));
        self.state.as_ref().is_some_and(flagged) || self.strain.as_ref().is_some_and(strains)
    }

    /// The figures, with zones of an earlier time beside them, and sentences for what is not drawn.
    pub fn figures(
        &self,
        language: Language,
        earlier: Option<&Zones>,
        heading: &str,
        files: Files,
        positions: &Positions,
    ) -> (Vec<Figure>, Vec<String>) {
        let (mut figures, mut notes) = (Vec::new(), Vec::new());
        if self.state.is_none() && self.strain.is_none() {
            notes.push(say!(
                language,
                "No plastic zone: the file has neither plastic_state nor plastic_shear_strain."
            ));
        } else if !self.yields() {
            notes.push(say!(
                language,
                "No plastic zone: nothing has yielded {when} {plane}.",
                when = self.when,
                plane = on_plane(language, self.y)
            ));
        } else {
            if let Some(cut) = self.state.as_ref().filter(|cut| cut.cells.iter().any(|c| yielded(c.value))) {
                let before = earlier.and_then(|zones| Some((zones.state.as_ref()?, zones.when.as_str())));
                let (svg, caption) = self.states(language, cut, before, positions);
                figures.push(Figure {
                    heading: heading.into(),
                    file: files.zones.into(),
                    svg,
                    caption,
                    curves: None,
                    narrow: None,
                });
            }
            if let Some(cut) = self.strain.as_ref().filter(|cut| strains(cut)) {
                let before = earlier.and_then(|zones| Some((zones.strain.as_ref()?, zones.when.as_str())));
                let (svg, caption) = self.strain(language, cut, before, positions);
                figures.push(Figure {
                    heading: heading.into(),
                    file: files.strain.into(),
                    svg,
                    caption,
                    curves: None,
                    narrow: None,
                });
            }
        }
        (figures, notes)
    }

    fn states(
        &self,
        language: Language,
        cut: &Cut,
        before: Option<(&Cut, &str)>,
        positions: &Positions,
    ) -> (String, String) {
        let window = window(cut, positions, MARGIN, |cell| yielded(cell.value));
        let row = MapRow::of(window, if before.is_some() { 2 } else { 1 });
        let frame = |cut: &Cut| {
            let mut frame = row.frame(0.0, 1.0);
            // In this order beside the map.
            for (wanted, name, colour) in [
                (ZoneKind::Shear, say!(language, "in shear"), SHEAR),
                (ZoneKind::Tension, say!(language, "in tension"), TENSION),
                (ZoneKind::Both, say!(language, "in both"), BOTH),
                (ZoneKind::Elastic, say!(language, "elastic"), ELASTIC),
            ] {
                for cell in cut.cells.iter().filter(|cell| kind(cell.value) == Some(wanted)) {
                    frame.kind(&cell.outline, &name, colour);
                }
            }
            finished(frame, cut, positions)
        };
        let mut maps = vec![(self.when.clone(), frame(cut))];
        let shared = |cut: &Cut, flags: i64| {
            let cells = cut.cells.iter().filter(|c| c.value.is_finite() && c.value as i64 & flags != 0);
            trimmed(&figures(cells.map(|cell| area(&cell.outline)).sum::<f64>(), 3))
        };
        let mut said = vec![say!(
            language,
            "Elements in which any point has yielded up to now, in shear, in tension or both ({when}, {plane}): {shear}\u{a0}m² of the \
             section in shear, {tension}\u{a0}m² in tension.",
            when = self.when,
            plane = on_plane(language, cut.y),
            shear = shared(cut, 5),
            tension = shared(cut, 10)
        )];
        if let Some((cut, when)) = before {
            maps.insert(0, (when.to_owned(), frame(cut)));
            said.push(say!(
                language,
                "For comparison, {when}: {shear}\u{a0}m² in shear, {tension}\u{a0}m² in tension. What is coloured on the right alone yielded in \
                 the earthquake.",
                when = when,
                shear = shared(cut, 5),
                tension = shared(cut, 10)
            ));
        }
        said.push(say!(
            language,
            "A zone one element deep may be an effect of the mesh. Look for zones that join between caverns or reach deep into a pillar."
        ));
        if before.is_none() {
            maps[0].0.clear();
        }
        let title = say!(language, "plastic zones");
        let svg = row.draw(&title, &maps, &say!(language, "a section coloured by element"));
        (svg, language.joined(&said))
    }

    fn strain(
        &self,
        language: Language,
        cut: &Cut,
        before: Option<(&Cut, &str)>,
        positions: &Positions,
    ) -> (String, String) {
        let window = window(cut, positions, MARGIN, |cell| cell.value > YIELDED);
        let most = cut.cells.iter().map(|cell| cell.value).filter(|x| x.is_finite()).fold(0.0, f64::max);
        // Strains of rock are thousandths.
        let scale = Scale { factor: 1e3, unit: "10⁻³".into() };
        let row = MapRow::of(window, if before.is_some() { 2 } else { 1 });
        let frame = |cut: &Cut| {
            let mut frame = row.frame(0.0, most * scale.factor);
            let none = say!(language, "none");
            for cell in cut.cells.iter().filter(|cell| cell.value.is_finite()) {
                if cell.value > YIELDED {
                    frame.cell(&cell.outline, cell.value * scale.factor);
                } else {
                    frame.kind(&cell.outline, &none, ELASTIC);
                }
            }
            finished(frame, cut, positions)
        };
        let mut maps = vec![(if before.is_some() { self.when.clone() } else { String::new() }, frame(cut))];
        if let Some((cut, when)) = before {
            maps.insert(0, (when.to_owned(), frame(cut)));
        }
        let mut said = vec![say!(
            language,
            "Field {field}, {when}, {plane}: of each element the mean over its points.",
            field = cut.field,
            when = self.when,
            plane = on_plane(language, cut.y)
        )];
        if before.is_some() {
            said.push(say!(
                language,
                "Both maps have one scale: look for where the earthquake has added to what the excavation left."
            ));
        }
        let finite = cut.cells.iter().filter(|cell| cell.value.is_finite());
        if let Some(peak) = finite.max_by(|a, b| a.value.total_cmp(&b.value)) {
            let (value, place) = (figures(peak.value, 3), place(language, peak));
            said.push(say!(
                language,
                "Highest value: {value} in the element at {place}.",
                value = value,
                place = place
            ));
        }
        let title = scale.labelled(&say!(language, "plastic shear strain Γ"));
        (row.draw(&title, &maps, &say!(language, "a section coloured by element")), language.joined(&said))
    }
}

fn finished(mut frame: Frame, cut: &Cut, positions: &Positions) -> Frame {
    frame.outlines(&borders(&cut.cells));
    points(&mut frame, cut, positions);
    frame
}

fn strains(cut: &Cut) -> bool {
    cut.cells.iter().any(|cell: &CutCell| cell.value > YIELDED)
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum ZoneKind {
    Shear,
    Tension,
    Both,
    Elastic,
}

fn yielded(value: f64) -> bool {
    kind(value).is_some_and(|kind| kind != ZoneKind::Elastic)
}

/// What flags of the state say: 1 and 4 shear, 2 and 8 tension, now and earlier.
fn kind(value: f64) -> Option<ZoneKind> {
    let flags = if value.is_finite() { value as i64 } else { return None };
    Some(match (flags & 5 != 0, flags & 10 != 0) {
        (true, true) => ZoneKind::Both,
        (true, false) => ZoneKind::Shear,
        (false, true) => ZoneKind::Tension,
        (false, false) => ZoneKind::Elastic,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn flags_of_now_and_earlier_count_alike() {
        use ZoneKind::{Both, Elastic, Shear, Tension};
        let kinds = [0.0, 1.0, 4.0, 2.0, 8.0, 6.0, 9.0].map(kind);
        assert_eq!(kinds, [Elastic, Shear, Shear, Tension, Tension, Both, Both].map(Some));
        assert_eq!(kind(f64::NAN), None);
    }
}
