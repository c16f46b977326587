//! Linings developed flat, coloured by element: maps of one scale beside each other.

use tremolite_results::{ElementGroups, Fields, Skin};

use crate::developed::layout::{Bars, LEFT, Layout};
use crate::developed::unfold::{Sheet, unfold};
use crate::developed::words::{developed, from_left, labels};
use crate::drawing::colours::{self, LEVELS, colour, level};
use crate::drawing::svg::{Anchor, Style, Svg};
use crate::interfaces::map_panel::{BELOW, ROW, TITLE, frame};
use crate::language::{Language, say};

/// Above the first panel: the title.
const HEADER: f64 = 26.0;
const TALLEST_BAR: f64 = 320.0;

/// The outside of linings, developed.
pub struct Sheets {
    skin: Skin,
    sheets: Vec<Sheet>,
    /// Numbers of the elements behind the faces, to name sheets by.
    elements: Vec<i64>,
    groups: ElementGroups,
}

impl Sheets {
    /// Of the elements for which `inside` is true, by index of their cells.
    pub fn of(fields: &Fields, inside: &[bool]) -> Self {
        let skin = fields.skin(inside);
        let mut sheets = unfold(&skin.points, &skin.normals, &skin.faces);
        from_left(&mut sheets, &skin.points);
        let numbers = fields.numbers();
        let number = |cell: usize| numbers.as_ref().map_or(-1, |numbers| numbers[cell]);
        let elements = skin.behind.iter().map(|cells| number(cells[0])).collect();
        Sheets { skin, sheets, elements, groups: fields.groups() }
    }
}

/// The figure of some fields, each with its title and its values by index of cell, and what is to be said of it; nothing where
/// no lining lies on other ground.
pub fn draw(
    language: Language,
    own: &Sheets,
    title: &str,
    maps: &[(String, &[f64])],
    range: (f64, f64),
) -> Option<(String, Vec<String>)> {
    let sheets = &own.sheets;
    if sheets.is_empty() || maps.is_empty() {
        return None;
    }
    let layout = Layout::of(sheets, maps.len(), Bars::One);
    let labels = labels(language, sheets, &own.elements, &own.groups);
    let mut svg = Svg::new(940.0);
    svg.text((LEFT, 16.0), Anchor::Start, 14.0, Style::Bold, title);
    let above = TITLE + ROW + if layout.upright { ROW } else { 0.0 };
    let height = above + layout.size.1 + BELOW;
    let mut at = (0.0, 0.0);
    for (k, (name, values)) in maps.iter().enumerate() {
        let (column, row) = if layout.beside { (k, 0) } else { (0, k) };
        at = (LEFT + column as f64 * layout.panel_width(maps.len()), HEADER + above + row as f64 * height);
        svg.text((at.0, at.1 - above + 16.0), Anchor::Start, 13.0, Style::Plain, name);
        panel(&mut svg, at, &layout, own, values, range);
        frame(&mut svg, language, at, &layout, sheets, &labels);
    }
    let rows = if layout.beside { 1.0 } else { maps.len() as f64 };
    let bottom = HEADER + rows * height;
    let (top, end) = (HEADER + above, at.1 + layout.size.1);
    colours::bar(&mut svg, (at.0 + layout.bar_at(), top), (end - top).min(TALLEST_BAR), range, false);
    let mut said = developed(language, sheets);
    if own.skin.behind.iter().any(|cells| cells.len() > 1) {
        said.push(say!(
            language,
            "Of the elements one behind the other through the thickness the largest is shown."
        ));
    }
    let names: Vec<&str> = maps.iter().map(|(name, _)| name.as_str()).collect();
    Some((svg.finish(bottom, title, &names.join(&say!(language, "; "))), said))
}

/// One map without what stands around it.
fn panel(svg: &mut Svg, at: (f64, f64), layout: &Layout, own: &Sheets, values: &[f64], range: (f64, f64)) {
    let mut levels: Vec<Vec<Vec<(f64, f64)>>> = vec![Vec::new(); LEVELS];
    let (mut outlines, mut creases) = (Vec::new(), Vec::new());
    for (k, sheet) in own.sheets.iter().enumerate() {
        let place = |p: &[f64; 2]| {
            let (x, y) = layout.place(k, *p);
            (at.0 + x, at.1 + y)
        };
        for face in &sheet.faces {
            let behind = own.skin.behind[face.face].iter().map(|&cell| values[cell]);
            let most = behind.filter(|x| x.is_finite()).fold(f64::NEG_INFINITY, f64::max);
            if most.is_finite() {
                levels[level(most, range)].push(face.corners.iter().map(place).collect());
            }
        }
        outlines.extend(sheet.outline.iter().map(|edge| edge.iter().map(place).collect::<Vec<_>>()));
        creases.extend(sheet.creases.iter().map(|edge| edge.iter().map(place).collect::<Vec<_>>()));
    }
    for (level, outlines) in levels.iter().enumerate().filter(|(_, outlines)| !outlines.is_empty()) {
        svg.areas(&colour(level), outlines);
    }
    svg.borders(&outlines);
    svg.borders(&creases);
}
