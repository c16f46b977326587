//! How far the groups of elements are damaged or yielded, as tables.

use serde::Serialize;
use tremolite_results::{Damaged, Summary};

use crate::scale::{figures, moment, trimmed};

/// One measure of damage in all groups whose laws have it.
#[derive(Serialize)]
pub struct DamageTable {
    pub heading: String,
    /// Thresholds, one a column.
    pub thresholds: Vec<String>,
    pub rows: Vec<DamageRow>,
}

/// One group.
#[derive(Serialize)]
pub struct DamageRow {
    pub group: String,
    /// m³
    pub volume: String,
    /// Volume beyond each threshold, m³ and share of the group.
    pub beyond: Vec<String>,
    pub largest: String,
    /// When and where it began; a dash where it did not.
    pub first: String,
}

/// What a measure is called on the page; measures that this version does not know keep their names.
fn heading(measure: &str) -> String {
    match measure {
        "d_tension" => "Damage in tension, D⁺".into(),
        "d_shear" => "Damage in shear, D⁻".into(),
        "d_b_max" => "Mean principal damage, largest over time, D_b".into(),
        "plastic_shear_strain" => "Yielded in shear".into(),
        "plastic_tension_strain" => "Yielded in tension".into(),
        other => other.into(),
    }
}

/// A table for each measure of the summary, in the order in which groups bring them.
pub fn tables(summary: &Summary) -> Vec<DamageTable> {
    let mut names: Vec<&String> = Vec::new();
    for name in summary.damage.values().flat_map(|group| group.measures.keys()) {
        if !names.contains(&name) {
            names.push(name);
        }
    }
    names.into_iter().map(|name| table(summary, name)).collect()
}

fn table(summary: &Summary, measure: &str) -> DamageTable {
    let mut thresholds: Vec<String> = Vec::new();
    let found =
        summary.damage.iter().filter_map(|(name, g)| Some((name, g.volume, g.measures.get(measure)?)));
    for threshold in found.clone().flat_map(|(.., damaged)| damaged.beyond.keys()) {
        if !thresholds.contains(threshold) {
            thresholds.push(threshold.clone());
        }
    }
    let duration = summary.model.duration;
    let rows = found
        .map(|(group, volume, damaged)| DamageRow {
            group: group.clone(),
            volume: trimmed(&figures(volume, 4)),
            beyond: thresholds.iter().map(|t| share(damaged, t, volume)).collect(),
            largest: trimmed(&figures(damaged.largest, 3)),
            first: damaged.first.map_or_else(
                || "–".into(),
                |first| {
                    let [x, y, z] = first.at.map(|x| trimmed(&format!("{x:.1}").replace('-', "−")));
                    let time = moment(first.time, duration);
                    format!("{time}\u{a0}s, element {} at ({x},\u{a0}{y},\u{a0}{z})", first.element)
                },
            ),
        })
        .collect();
    DamageTable { heading: heading(measure), thresholds, rows }
}

fn share(damaged: &Damaged, threshold: &str, volume: f64) -> String {
    match damaged.beyond.get(threshold) {
        Some(0.0) => "0".into(),
        Some(&part) if part.is_finite() && volume > 0.0 => {
            format!("{} ({}\u{a0}%)", trimmed(&figures(part, 3)), trimmed(&figures(100.0 * part / volume, 2)))
        }
        _ => "–".into(),
    }
}
