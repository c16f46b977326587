//! What is said of developed sheets: their order, their names, and how they lie.

use tremolite_results::ElementGroups;

use crate::developed::layout::end_walls;
use crate::developed::unfold::Sheet;
use crate::language::{Language, say};
use crate::quantities::scale::trimmed;

/// Puts sheets from left to right as they stand in the ground.
pub fn from_left(sheets: &mut [Sheet], points: &[[f64; 3]]) {
    let middle = |sheet: &Sheet| {
        let [x, y, _] = sheet.axis;
        let points = sheet.faces.iter().flat_map(|face| &face.points).map(|p| points[*p as usize]);
        let (sum, number) = points.fold((0.0, 0.0), |(s, n), p| (s + p[0] * y - p[1] * x, n + 1.0));
        sum / number
    };
    sheets.sort_by(|a, b| middle(a).total_cmp(&middle(b)));
}

/// A name for each sheet: the smallest group of elements that holds its first side, where that tells sheets apart.
/// `elements` are numbers of the elements behind the faces.
pub fn labels(language: Language, sheets: &[Sheet], elements: &[i64], groups: &ElementGroups) -> Vec<String> {
    let group = |sheet: &Sheet| {
        let own: Vec<i64> = sheet.faces.iter().map(|face| elements[face.face]).collect();
        groups.of_all(&own).map(str::to_owned)
    };
    let names: Vec<Option<String>> = sheets.iter().map(group).collect();
    let label = |(k, name): (usize, &Option<String>)| match name {
        Some(name) if names.iter().filter(|other| *other == &Some(name.clone())).count() == 1 => name.clone(),
        Some(name) => format!("{name}, {}", k + 1),
        None if sheets.len() > 1 => say!(language, "part {number}", number = k + 1),
        None => String::new(),
    };
    names.iter().enumerate().map(label).collect()
}

/// How they lie, in sentences.
pub fn developed(language: Language, sheets: &[Sheet]) -> Vec<String> {
    let mut said = Vec::new();
    said.push(if sheets.iter().any(|sheet| sheet.wraps) {
        say!(language, "Unrolled at true lengths and opened at the bottom, seen from the rock.")
    } else {
        say!(language, "At true lengths, seen from the second side.")
    });
    if let Some(sheet) = sheets.iter().find(|sheet| sheet.wraps && sheet.axis[2].abs() <= 0.5) {
        let axis = direction(sheet.axis);
        said.push(say!(language, "Left and right are as seen along +{axis}.", axis = axis));
    }
    if sheets.iter().any(|sheet| !end_walls(sheet).is_empty()) {
        said.push(say!(
            language,
            "Strips that lean out beyond the ends are the faces of the lining's ends, folded into the plane."
        ));
    }
    if sheets.iter().any(|sheet| sheet.pieces > 1) {
        said.push(say!(language, "Parts that would lie on others are moved apart."));
    }
    said
}

/// An axis in words.
pub fn direction(axis: [f64; 3]) -> String {
    match (0..3).find(|&i| axis[i] > 1.0 - 1e-9) {
        Some(i) => ["x", "y", "z"][i].into(),
        None => {
            let parts = axis.map(|c| trimmed(&format!("{c:.2}")).replace('-', "−"));
            format!("({})", parts.join(", "))
        }
    }
}
