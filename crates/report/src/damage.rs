//! How far the groups of elements are damaged or yielded, as tables.

pub mod crack_widths;
mod developed_maps;
pub mod growth;
pub mod maps;
pub mod rates;
mod thickened;

use serde::Serialize;
use tremolite_results::{CrackDirection, Cracks, Damaged, GroupDamage, Onset, Opened, Summary};

use crate::language::{Language, say};
use crate::quantities::scale::{figures, moment, trimmed};
use crate::quantities::units::Kind;
use crate::source::Source;

/// Measures with the same thresholds in all groups whose laws have one of them.
#[derive(Serialize)]
pub struct DamageTable {
    pub heading: String,
    /// Thresholds, one a column.
    pub thresholds: Vec<String>,
    pub rows: Vec<DamageRow>,
    /// What was left out of the rows; may be empty.
    pub note: String,
}

/// One measure in one group.
#[derive(Serialize, PartialEq)]
pub struct DamageRow {
    /// Empty where it is that of the row above.
    pub group: String,
    /// m³; empty as well.
    pub volume: String,
    pub measure: String,
    /// Volume beyond each threshold, m³ and share of the group.
    pub beyond: Vec<Share>,
    pub largest: String,
    /// When it began; a dash where it did not.
    pub time: String,
    /// Where it began.
    pub place: String,
}

/// A volume \[m³\] and its share of the group; a dash or zero has none.
#[derive(Serialize, PartialEq)]
pub struct Share {
    pub volume: String,
    pub percent: String,
}

/// The cracks of one group.
#[derive(Serialize)]
pub struct CrackRow {
    pub group: String,
    /// Places at which cracks run through, of how many.
    pub through: String,
    /// One of them.
    pub through_at: String,
    pub opening: String,
    /// Across bars, with which way it runs, and parallel to the wall.
    pub across: String,
    pub runs: String,
    pub parallel: String,
    pub time: String,
    pub place: String,
}

/// What a measure is called on the page; measures that this version does not know keep their names.
pub fn heading(language: Language, measure: &str) -> String {
    match measure {
        "d_tension" => say!(language, "Cracked, D⁺"),
        "d_shear" => say!(language, "Crushed or sheared, D⁻"),
        "d_b_max" => say!(language, "Mean of the principal directions, D_b"),
        "plastic_shear_strain" => say!(language, "Yielded in shear"),
        "plastic_tension_strain" => say!(language, "Yielded in tension"),
        other => other.into(),
    }
}

/// One table for damage and one for yielding, as far as the summary has them.
pub fn tables(language: Language, summary: &Summary) -> Vec<DamageTable> {
    let plastic = |measure: &str| measure.starts_with("plastic_");
    let damage = table(language, summary, say!(language, "Damage of concrete"), |measure| !plastic(measure));
    let yielding = table(language, summary, say!(language, "Yielding of rock: plastic strain"), plastic);
    [damage, yielding].into_iter().flatten().collect()
}

fn table(
    language: Language,
    summary: &Summary,
    heading: String,
    wanted: impl Fn(&str) -> bool,
) -> Option<DamageTable> {
    let measures = |group: &GroupDamage| -> Vec<(String, Damaged)> {
        let own = group.measures.iter().filter(|(name, _)| wanted(name));
        own.map(|(name, damaged)| (name.clone(), damaged.clone())).collect()
    };
    let mut thresholds: Vec<String> = Vec::new();
    for (_, damaged) in summary.parts.damage.values().flat_map(&measures) {
        for threshold in
            damaged.beyond.keys().filter(|t| !thresholds.contains(t)).cloned().collect::<Vec<_>>()
        {
            thresholds.push(threshold);
        }
    }
    let duration = summary.computed.model.duration;
    let mut rows = Vec::new();
    let (mut repeated, mut idled) = (0, 0);
    for (name, group) in &summary.parts.damage {
        let own: Vec<(String, DamageRow)> = measures(group)
            .into_iter()
            .map(|(measure, damaged)| {
                let row = row(language, &measure, &damaged, (group.volume, duration), &thresholds);
                (measure, row)
            })
            .collect();
        let cracked = own.iter().find(|(measure, _)| measure == "d_tension");
        let same = |row: &DamageRow| {
            cracked.is_some_and(|(_, c)| {
                (&row.beyond, &row.largest, &row.place) == (&c.beyond, &c.largest, &c.place)
            })
        };
        let repeats: Vec<bool> = own.iter().map(|(m, row)| m == "d_b_max" && same(row)).collect();
        repeated += repeats.iter().filter(|r| **r).count();
        let idle = |row: &DamageRow| row.largest == "0";
        let all_idle = own.iter().all(|(_, row)| idle(row));
        idled += own.iter().filter(|(_, row)| idle(row) && !all_idle).count();
        let kept = own
            .into_iter()
            .zip(repeats)
            .enumerate()
            .filter(|(k, ((_, row), repeats))| if all_idle { *k == 0 } else { !repeats && !idle(row) });
        let kept = kept.map(|(_, ((_, row), _))| row);
        let first = rows.len();
        rows.extend(kept);
        if let Some(row) = rows.get_mut(first) {
            row.group.clone_from(name);
            row.volume = trimmed(&figures(group.volume, 4));
        }
    }
    let mut notes = Vec::new();
    if repeated > 0 {
        notes.push(say!(
            language,
            "D_b, the mean of the damage in the three principal directions, is not listed where it equals D⁺."
        ));
    }
    if idled > 0 {
        notes.push(say!(language, "Measures that stayed zero are not listed."));
    }
    let note = notes.join(&say!(language, " "));
    (!rows.is_empty()).then_some(DamageTable { heading, thresholds, rows, note })
}

fn row(
    language: Language,
    measure: &str,
    damaged: &Damaged,
    (volume, duration): (f64, f64),
    thresholds: &[String],
) -> DamageRow {
    let (time, place) =
        damaged.first.map_or(("–".into(), String::new()), |first| when(language, &first, duration));
    DamageRow {
        group: String::new(),
        volume: String::new(),
        measure: heading(language, measure),
        beyond: thresholds.iter().map(|t| share(damaged, t, volume)).collect(),
        largest: trimmed(&figures(damaged.largest, 3)),
        time,
        place,
    }
}

/// A time, and an element with its place.
fn when(language: Language, onset: &Onset, duration: f64) -> (String, String) {
    // At rest nothing begins at t = 0 but in the stages.
    let time = match onset.time > 0.0 {
        true => format!("{}\u{a0}s", moment(onset.time, duration)),
        false => say!(language, "before the earthquake"),
    };
    (time, place(language, onset.element, onset.at))
}

fn place(language: Language, element: u64, at: [f64; 3]) -> String {
    let [x, y, z] = at.map(|x| trimmed(&format!("{x:.1}").replace('-', "−")));
    say!(language, "element\u{a0}{element} ({x},\u{a0}{y},\u{a0}{z})", element = element, x = x, y = y, z = z)
}

fn share(damaged: &Damaged, threshold: &str, volume: f64) -> Share {
    let (text, percent) = match damaged.beyond.get(threshold) {
        Some(0.0) => ("0".into(), String::new()),
        Some(&part) if part.is_finite() && volume > 0.0 => {
            (trimmed(&figures(part, 3)), format!("{}\u{a0}%", trimmed(&figures(100.0 * part / volume, 2))))
        }
        _ => ("–".into(), String::new()),
    };
    Share { volume: text, percent }
}

/// The widest opening; of loose pieces the limit.
pub fn opening(source: &Source, cracks: &Cracks) -> String {
    told(source, cracks.opening)
}

/// A width \[m\]; of loose pieces the limit.
pub fn told(source: &Source, width: f64) -> String {
    if width > Cracks::LOOSE {
        format!(">\u{a0}{}", trimmed(&source.quantity(Kind::Opening, Cracks::LOOSE)))
    } else {
        source.quantity(Kind::Opening, width)
    }
}

/// Which way a crack runs.
pub fn direction(language: Language, direction: CrackDirection) -> String {
    match direction {
        CrackDirection::Longitudinal => say!(language, "longitudinal"),
        CrackDirection::Ring => say!(language, "round the ring"),
        CrackDirection::Parallel => say!(language, "parallel to the wall"),
        CrackDirection::Unplaced => say!(language, "where walls meet"),
    }
}

/// The widest crack of a direction, or that there is none; a dash where the results do not tell directions.
pub fn of_direction(source: &Source, opened: Option<&Opened>) -> String {
    match opened {
        Some(of) if of.widest.is_some() => told(source, of.opening),
        Some(_) => say!(source.language, "none"),
        None => "–".into(),
    }
}

/// The cracks of each group that has any.
pub fn cracks(source: &Source, summary: &Summary) -> Vec<CrackRow> {
    let language = source.language;
    let duration = summary.computed.model.duration;
    let found = summary.parts.damage.iter().filter_map(|(name, group)| {
        let cracks = group.cracks.as_ref()?;
        let (time, place_of) = when(language, cracks.widest.as_ref()?, duration);
        Some(CrackRow {
            group: name.clone(),
            through: if cracks.stacks > 0 {
                say!(language, "{through} of {all}", through = cracks.through, all = cracks.stacks)
            } else {
                "–".into()
            },
            through_at: cracks.through_at.map_or(String::new(), |p| place(language, p.element, p.at)),
            opening: opening(source, cracks),
            across: of_direction(source, cracks.across()),
            runs: match cracks.across() {
                Some(of) if of.widest.is_some() => direction(language, of.direction),
                _ => String::new(),
            },
            parallel: of_direction(source, cracks.parallel()),
            time,
            place: place_of,
        })
    });
    found.collect()
}
