//! How far linings are damaged: before and after the earthquake, and in which way. On the section, with linings drawn
//! thicker than they are, and developed flat.

use std::rc::Rc;

use tremolite_results::{Fields, Slice};

use crate::chapter::figure::{Figure, Section};
use crate::damage::developed_maps::{self, Sheets};
use crate::damage::thickened::Thick;
use crate::drawing::frame_row::MapRow;
use crate::language::{Language, say};
use crate::quantities::scale::figures;
use crate::section_maps::section_view::{Positions, borders, on_plane, plane, window};
use crate::section_maps::snapshots::Snapshots;
use crate::source::Source;

const ROCK: &str = "#e4e7eb";
/// Room around linings, as a part of their extent: nothing else is of a colour.
const MARGIN: f64 = 0.06;
/// Damage has one scale on every page, so that a colour means the same.
const RANGE: (f64, f64) = (0.0, 1.0);
/// What says of the mean of both damages, in order of preference.
const MEAN: [&str; 3] = ["d_b_max", "d_b", "d_tension"];

/// Damage of elements at one time, by index of their cells.
struct Damage {
    /// What it is, above its map.
    title: String,
    values: Vec<f64>,
}

/// Damage before and after, and its kinds, one section each; or why there are no maps of the section at all.
pub fn sections(source: &Source) -> Vec<Section> {
    let language = source.language;
    let snapshots = match Snapshots::readable(source) {
        Ok(snapshots) => snapshots,
        Err(why) => return vec![Section::left_out(&say!(language, "Section through the caverns"), why)],
    };
    let heading = say!(language, "Damage of the linings, before and after");
    let scene = match Scene::of(source, &snapshots) {
        Ok(scene) => scene,
        Err(why) => return vec![Section::left_out(&heading, why)],
    };
    let kinds = say!(language, "Damage in tension and in shear");
    vec![scene.before_and_after(source, &snapshots, heading), scene.kinds(source, &snapshots, kinds)]
}

/// What is common to all maps.
struct Scene {
    first: Rc<Fields>,
    last: Rc<Fields>,
    /// Of the last file.
    slice: Slice,
    /// Whether each element can be damaged, by index of its cell.
    inside: Vec<bool>,
    sheets: Sheets,
    positions: Positions,
}

impl Scene {
    fn of(source: &Source, snapshots: &Snapshots) -> Result<Self, String> {
        let language = source.language;
        let first = snapshots.read(snapshots.first())?;
        let last = snapshots.read(snapshots.last())?;
        let facts = source.facts();
        let damaged = facts.parts.damage.iter().filter(|(_, group)| {
            group.measures.keys().any(|measure| measure == "d_tension" || measure == "d_b_max")
        });
        let mut inside = last.members(damaged.map(|(name, _)| name.as_str()));
        let Some(values) = MEAN.iter().find_map(|name| last.values(name)) else {
            return Err(say!(
                language,
                "The last field file has no field d_b_max, d_b or d_tension: where something can be damaged, \"damage\" in the case's \
                 output.fields writes them."
            ));
        };
        if !inside.contains(&true) {
            // Without a summary: all of the bodies in which something is damaged.
            let groups = last.group_numbers();
            let hurt: Vec<i64> = groups
                .iter()
                .zip(&values)
                .filter(|(_, value)| **value > 0.0)
                .map(|(group, _)| *group)
                .collect();
            inside = groups.iter().map(|group| hurt.contains(group)).collect();
        }
        if !inside.contains(&true) {
            return Err(say!(language, "Nothing is damaged in the last field file."));
        }
        let slice = last.slice(plane(&facts.monitors.monitor_positions));
        let sheets = Sheets::of(&last, &inside);
        Ok(Scene { first, last, slice, inside, sheets, positions: facts.monitors.monitor_positions })
    }

    fn before_and_after(&self, source: &Source, snapshots: &Snapshots, heading: String) -> Section {
        let language = source.language;
        let Some(field) = MEAN.into_iter().find(|name| self.last.values(name).is_some()) else {
            return Section::left_out(
                &heading,
                say!(language, "The last field file has no field of damage."),
            );
        };
        let Some(values) = self.last.values(field) else { return Section::Drawn(Vec::new()) };
        let after = Damage { title: capital(&snapshots.after()), values };
        let before = self.first.values(field).filter(|values| values.len() == self.inside.len());
        let mut maps: Vec<Damage> = Vec::new();
        let mut said = Vec::new();
        match before {
            Some(values) if snapshots.first() != snapshots.last() => {
                maps.push(Damage { title: capital(&snapshots.before()), values });
            }
            _ => said.push(say!(language, "Before the earthquake is not drawn: there is one field file alone, or the first has other elements.")),
        }
        maps.push(after);
        let what = match field {
            "d_tension" => say!(language, "Damage in tension D⁺ (field d_tension): 0 sound, 1 broken."),
            "d_b" => say!(
                language,
                "D_b, the mean of the damage in the three principal directions (field d_b), as it is at the time: 0 sound, 1 broken."
            ),
            _ => say!(
                language,
                "D_b, the mean of the damage in the three principal directions, at each point the largest so far (field d_b_max): 0 sound, 1 broken."
            ),
        };
        said.insert(0, what);
        said.push(say!(language, "Of each element the mean over its points, so a single point may be damaged more: the table of damage has the worst."));
        if let [before, after] = &maps[..] {
            let look = say!(
                language,
                "Both maps have one scale. Look for what is dark after and was light before: the earthquake did that. Largest mean of \
                 an element before {before}, after {after}.",
                before = self.most(before),
                after = self.most(after)
            );
            said.push(look);
        }
        let title = match field {
            "d_tension" => say!(language, "damage of the linings in tension, D⁺"),
            _ => say!(language, "damage of the linings, D_b"),
        };
        self.drawn(language, &heading, &title, "lining-damage", &maps, said)
    }

    fn kinds(&self, source: &Source, snapshots: &Snapshots, heading: String) -> Section {
        let language = source.language;
        let [tension, shear] = ["d_tension", "d_shear"].map(|name| self.last.values(name));
        let (Some(tension), Some(shear)) = (tension, shear) else {
            return Section::left_out(
                &heading,
                say!(language, "The last field file lacks d_tension or d_shear."),
            );
        };
        let maps = [
            Damage { title: say!(language, "in tension, D⁺"), values: tension },
            Damage { title: say!(language, "in shear or crushing, D⁻"), values: shear },
        ];
        let said = vec![
            say!(
                language,
                "Damage in tension D⁺ and in shear D⁻ ({when}; fields d_tension and d_shear), of each element the mean over its points, \
                 both from 0 sound to 1 broken.",
                when = snapshots.after()
            ),
            say!(
                language,
                "Tension opens cracks, which may close again and then carry pressure; damage in shear lowers the strength in compression. Look for \
                 shear where a lining is thin or bears most, at the crown and the feet: a lining cracked in tension alone can still carry thrust, where \
                 it is sheared or crushed through it has its residual strength alone. Largest mean of an element: D⁺ {tension}, D⁻ {shear}.",
                tension = self.most(&maps[0]),
                shear = self.most(&maps[1])
            ),
        ];
        let title = say!(language, "damage of the linings by kind");
        self.drawn(language, &heading, &title, "lining-damage-kinds", &maps, said)
    }

    fn drawn(
        &self,
        language: Language,
        heading: &str,
        title: &str,
        file: &str,
        maps: &[Damage],
        mut said: Vec<String>,
    ) -> Section {
        let mut figures = Vec::new();
        if let Some(([svg, narrow], more)) = self.on_section(language, title, maps) {
            let mut own = said.clone();
            own.push(more);
            said = vec![say!(language, "The same numbers over the whole lining.")];
            figures.push(Figure {
                heading: heading.into(),
                file: format!("{file}.svg"),
                svg,
                caption: language.joined(&own),
                curves: None,
                narrow: Some(narrow),
            });
        }
        let maps: Vec<(String, &[f64])> =
            maps.iter().map(|map| (map.title.clone(), map.values.as_slice())).collect();
        if let Some((svg, more)) = developed_maps::draw(language, &self.sheets, title, &maps, RANGE) {
            said.extend(more);
            figures.push(Figure {
                heading: heading.into(),
                file: format!("{file}-unrolled.svg"),
                svg,
                caption: language.joined(&said),
                curves: None,
                narrow: None,
            });
        }
        if figures.is_empty() {
            return Section::left_out(
                heading,
                say!(language, "The section meets no lining, and none lies on other ground."),
            );
        }
        Section::Drawn(figures)
    }

    /// The section, and what is to be said of it; nothing where it meets no lining.
    fn on_section(&self, language: Language, title: &str, maps: &[Damage]) -> Option<([String; 2], String)> {
        let cut = self.last.cut(&self.slice, &MEAN)?;
        let inside: Vec<bool> = self.slice.pieces.iter().map(|piece| self.inside[piece.cell]).collect();
        let own: Vec<usize> = (0..cut.cells.len()).filter(|&k| inside[k]).collect();
        if own.is_empty() {
            return None;
        }
        let thick = Thick::of(&cut.cells, &inside);
        let window = window(&cut, &self.positions, MARGIN, |_| false);
        let [wide, narrow] = [MapRow::of(window.clone(), maps.len()), MapRow::narrow(window, maps.len())];
        let mut drawn = cut.cells.clone();
        own.iter().for_each(|&k| drawn[k].outline = thick.outline(&drawn[k].outline));
        let lining: Vec<_> = own.iter().map(|&k| drawn[k].clone()).collect();
        let ground = cut.cells.iter().zip(&inside).filter(|(_, inside)| !**inside);
        let ground: Vec<_> = ground.map(|(cell, _)| cell.clone()).collect();
        let frame = |row: &MapRow, map: &Damage| {
            let mut frame = row.frame(RANGE.0, RANGE.1);
            for cell in &ground {
                frame.kind(&cell.outline, &say!(language, "rock"), ROCK);
            }
            for &k in &own {
                let value = map.values[self.slice.pieces[k].cell];
                if value.is_finite() {
                    frame.cell(&drawn[k].outline, value);
                }
            }
            frame.outlines(&borders(&ground));
            frame.outlines(&borders(&lining));
            for (name, [x, y, z]) in &self.positions {
                if (y - cut.y).abs() < 0.01 {
                    frame.point(name, thick.point([*x, *z]));
                }
            }
            (say!(language, "{title}: up to {most}", title = map.title, most = self.most(map)), frame)
        };
        // A narrow one has its heading beside it.
        let titles = match thick.factor > 1.0 {
            true => [
                say!(language, "{title} (thickness × {factor})", title = title, factor = thick.factor),
                say!(language, "thickness of linings × {factor}", factor = thick.factor),
            ],
            false => [title.to_owned(), String::new()],
        };
        let [svg, narrow] = [(&wide, &titles[0]), (&narrow, &titles[1])].map(|(row, title)| {
            let maps: Vec<_> = maps.iter().map(|map| frame(row, map)).collect();
            row.draw(title, &maps, &say!(language, "a section coloured by element"))
        });
        let plane = on_plane(language, cut.y);
        let more = if thick.factor > 1.0 {
            say!(
                language,
                "Here {plane}, linings drawn {factor} times as thick as they are, inwards, so that they are seen.",
                plane = plane,
                factor = thick.factor
            )
        } else {
            say!(language, "Here {plane}.", plane = plane)
        };
        Some(([svg, narrow], more))
    }

    /// The largest value of an element.
    fn most(&self, map: &Damage) -> String {
        let own = map.values.iter().zip(&self.inside).filter(|(value, inside)| **inside && value.is_finite());
        figures(own.map(|(value, _)| *value).fold(0.0, f64::max), 2)
    }
}

/// With a capital at its beginning, as a title.
fn capital(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}
