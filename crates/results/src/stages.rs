//! Stages before the earthquake: what changed in each, and how the model came to rest.

use crate::{Column, Error, Said, Subject, columns, number, replace_file};
use indexmap::IndexMap;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// A stage that came to rest. The first of all is the equilibrium of what is there at the start.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct StageSummary {
    pub name: String,
    /// Groups that are gone from here on, and groups that begin.
    pub excavated: Vec<String>,
    pub installed: Vec<String>,
    /// What else changes, a phrase each: materials, pressures.
    pub changed: Vec<String>,
    /// The same as patterns; none in files of other versions.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub changed_message: Vec<Said>,
    /// Share of what was out of balance that was let go.
    #[serde(with = "number", default = "number::absent")]
    pub release: f64,
    /// What may be out of balance over all contributions at rest.
    #[serde(with = "number", default = "number::absent")]
    pub tolerance: f64,
    /// Cycles of relaxation.
    pub cycles: u64,
    /// Out of balance at the end over all contributions.
    #[serde(with = "number", default = "number::absent")]
    pub ratio: f64,
    /// Motion that was left (m), an estimate.
    #[serde(with = "number", default = "number::absent")]
    pub motion_left: f64,
    /// Largest motion of a node in the stage (m).
    #[serde(with = "number", default = "number::absent")]
    pub largest_motion: f64,
    /// ∫Γ dV over what stands at the end (m³), Γ the accumulated plastic shear strain.
    #[serde(with = "number", default = "number::absent")]
    pub plastic_volume: f64,
    /// What is still held at the end, over all contributions: not let go yet.
    #[serde(with = "number", default = "number::absent")]
    pub held: f64,
    /// Monitor → quantity → value at the end, as in monitors.csv; not a number where it is in nothing that stands.
    pub monitors: IndexMap<String, IndexMap<String, Option<f64>>>,
    /// What stages move, by name: `ux` … of its nodes (m) and `reaction_x` … (N), the force with which it pushes on the model, along
    /// what is not free.
    #[serde(skip_serializing_if = "IndexMap::is_empty")]
    pub moved: IndexMap<String, IndexMap<String, f64>>,
    /// Named point of the mesh → displacement since the initial equilibrium (m) of the nearest node of what stands throughout.
    pub walls: IndexMap<String, [f64; 3]>,
    /// Steady seepage that begins with the stage.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seepage: Option<StageSeepage>,
}

/// Steady seepage.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct StageSeepage {
    /// Wall or drain → what it takes (m³/s).
    pub taken: IndexMap<String, f64>,
    /// Head by its name → what comes in there (m³/s).
    pub comes: IndexMap<String, f64>,
    /// All that comes into the ground (m³/s).
    pub inflow: f64,
    /// What comes in less what leaves, over what comes in.
    pub mass_error: f64,
    /// Iterations for the free surface.
    pub iterations: usize,
}

/// Columns of stages.csv before the monitors'.
const OWN: [(&str, &str); 7] = [
    ("stage", ""),
    ("name", ""),
    ("cycles", ""),
    ("ratio", ""),
    ("motion_left", "m"),
    ("largest_motion", "m"),
    ("plastic_volume", "m3"),
];

/// Writes stages.csv whole: a row a stage, its own columns, those of the monitors, then `NAME.QUANTITY` of what is moved; and
/// beside it whose they are ([`columns`]).
///
/// # Errors
/// [`Error::Io`].
pub fn write_stages(path: &Path, monitors: &[Column], stages: &[StageSummary]) -> Result<(), Error> {
    let mut out = csv::Writer::from_writer(Vec::new());
    let moved = stages.first().map(|first| &first.moved).into_iter().flatten();
    let unit = |quantity: &str| if quantity.starts_with('u') { "m" } else { "N" };
    let moved = moved.flat_map(|(name, of)| {
        of.keys().map(|quantity| Column::of(Subject::Moved(name.clone()), quantity, unit(quantity)))
    });
    let moved: Vec<Column> = moved.collect();
    let own = OWN.map(|(name, unit)| Column::new(name, unit));
    let all = [&own[..], monitors, &moved].concat();
    let mut rows = vec![all.iter().map(Column::header).collect::<Vec<String>>()];
    for (k, stage) in stages.iter().enumerate() {
        let mut row = vec![k.to_string(), stage.name.clone(), stage.cycles.to_string()];
        let mut push = |x: f64| {
            let mut text = String::new();
            number::push(&mut text, x);
            row.push(text);
        };
        [stage.ratio, stage.motion_left, stage.largest_motion, stage.plastic_volume]
            .into_iter()
            .for_each(&mut push);
        for column in monitors {
            let of = column.subject.name().and_then(|name| stage.monitors.get(&name));
            let value = of.and_then(|of| of.get(&column.quantity).copied().flatten());
            push(value.unwrap_or(f64::NAN));
        }
        for column in &moved {
            let of = column.subject.name().and_then(|name| stage.moved.get(&name));
            push(of.and_then(|of| of.get(&column.quantity).copied()).unwrap_or(f64::NAN));
        }
        rows.push(row);
    }
    write_rows(&mut out, rows);
    columns::write(path, &all)?;
    replace_file(path, &out.into_inner().unwrap_or_default())
}

/// Rows into memory, which cannot fail.
pub(crate) fn write_rows(out: &mut csv::Writer<Vec<u8>>, rows: impl IntoIterator<Item = Vec<String>>) {
    for row in rows {
        let written = out.write_record(row);
        debug_assert!(written.is_ok());
    }
}
