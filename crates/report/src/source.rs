//! All that the report knows: what the result files hold, and why a file is of no use where it is not.

mod field_files;
pub mod monitor_pairs;

use std::path::Path;

use tremolite_results::utilisation::{UtilisationRow, read_utilisation};
use tremolite_results::{
    BoltRow, FreeField, ResultFolder, SectionRow, Summary, Table, peaks_by_monitor, read_bolts, read_sections,
};

use crate::language::{Language, say};
use crate::quantities::scale::{Scale, quantity};
use crate::quantities::units::{Kind, Units};
use crate::source::field_files::FieldFiles;

/// The content of a result folder; for each file that could not be read, a sentence that says why.
pub struct Source {
    /// Of the page.
    pub language: Language,
    pub folder: ResultFolder,
    pub summary: Result<Summary, String>,
    pub monitors: Result<Table, String>,
    pub energy: Result<Table, String>,
    /// Nothing where the folder has no such file: nothing could be damaged, or an older version ran.
    pub damage: Option<Result<Table, String>>,
    /// Nothing where the folder has no such file: the run has no interface, or an older version ran.
    pub interfaces: Option<Result<Table, String>>,
    /// Nothing where the folder has no such file: no earthquake came, or an older version ran.
    pub motion: Option<Result<Table, String>>,
    /// Nothing where the folder has no such file: no earthquake came, no column stood beside the model, or an older
    /// version ran.
    pub free_field: Option<Result<FreeField, String>>,
    /// Nothing where the folder has no such file: no motion was deconvolved, or an older version ran.
    pub transfer: Option<Result<Table, String>>,
    /// Nothing where the folder has no such file: no earthquake came, the run goes on, or an older version ran.
    pub spectra: Option<Result<Table, String>>,
    /// Nothing where the folder has no such file: no earthquake came, no column stood beside the model, the run goes on, or an
    /// older version ran.
    pub depth: Option<Result<Table, String>>,
    /// Nothing where the folder has no such file: the run has no stages, or an older version ran.
    pub relaxation: Option<Result<Table, String>>,
    /// Nothing where the folder has no such file: the run has no lining of which section forces were taken.
    pub sections: Option<Result<Vec<SectionRow>, String>>,
    /// Nothing where the folder has no such file: no section is judged.
    pub utilisation: Option<Result<Vec<UtilisationRow>, String>>,
    /// Nothing where the folder has no such file: the run has no bolts, or an older version ran.
    pub bolts: Option<Result<Vec<BoltRow>, String>>,
    /// Field files that figures are cut out of, read when one wants them.
    pub fields: FieldFiles,
    /// The case as it was read; nothing where the folder has no such file.
    pub case: Option<String>,
    /// One unit for one quantity.
    pub units: Units,
}

impl Source {
    /// Reads the folder's files. Without a `language` the page's is that which the case asked for.
    ///
    /// # Errors
    /// If the folder holds no results at all.
    pub fn read(root: &Path, language: Option<Language>) -> Result<Self, tremolite_results::Error> {
        let folder = ResultFolder::open_existing(root)?;
        let summary = folder.summary();
        let summary = summary.exists().then(|| Summary::read(&summary).map_err(|e| e.to_string()));
        let asked = || summary.as_ref()?.as_ref().ok()?.case.report.language.parse().ok();
        let language = language.or_else(asked).unwrap_or_default();
        let mut summary = summary.unwrap_or_else(|| {
            Err(say!(language, "There is no summary.json: the run is still under way, or it was killed."))
        });
        let table = |path: &Path, key: &str| table(path, key, language);
        let monitors = table(&folder.monitors(), "time");
        let energy = table(&folder.energy(), "time");
        if let (Ok(summary), Ok(monitors)) = (&mut summary, &monitors) {
            complete(summary, monitors);
        }
        let damage = folder.damage().exists().then(|| table(&folder.damage(), "time"));
        let interfaces = folder.interfaces().exists().then(|| table(&folder.interfaces(), "time"));
        let motion = folder.motion().exists().then(|| table(&folder.motion(), "time"));
        let free_field = folder.free_field();
        let free_field = free_field.exists().then(|| table(&free_field, "time"));
        let transfer = folder.transfer().exists().then(|| table(&folder.transfer(), "frequency"));
        let spectra = folder.spectra().exists().then(|| table(&folder.spectra(), "period"));
        let depth = folder.depth().exists().then(|| table(&folder.depth(), "depth"));
        let relaxation = folder.relaxation().exists().then(|| table(&folder.relaxation(), "stage"));
        let sections = folder.sections().exists().then(|| sections(&folder.sections(), language));
        let utilisation = folder.utilisation();
        let utilisation =
            utilisation.exists().then(|| read_utilisation(&utilisation).map_err(|e| format!("{e}.")));
        let bolts = folder.bolts().exists().then(|| read_bolts(&folder.bolts()).map_err(|e| format!("{e}.")));
        let case = std::fs::read(root.join("case.toml")).ok();
        let case = case.map(|bytes| String::from_utf8_lossy(&bytes).into_owned());
        let facts = facts(&summary, &monitors);
        let of_ground = [&motion, &free_field, &spectra, &depth].map(|table| table.as_ref()?.as_ref().ok());
        let of_ground = of_ground.into_iter().flatten().chain(energy.as_ref().ok()).flat_map(kinds);
        let of_joints = [&damage, &interfaces].map(|table| table.as_ref()?.as_ref().ok());
        let of_joints = of_joints.into_iter().flatten().flat_map(kinds).map(|(kind, size)| match kind {
            Kind::Displacement => (Kind::Opening, size),
            other => (other, size),
        });
        let of_bolts = bolts.iter().flatten().flatten().map(|row| (Kind::Force, row.max_force));
        let units = Units::of(&facts, of_ground.chain(of_joints).chain(of_bolts));
        Ok(Source {
            language,
            folder,
            summary,
            monitors,
            energy,
            damage,
            interfaces,
            motion,
            free_field: free_field.map(|table| table.map(FreeField::of)),
            transfer,
            spectra,
            depth,
            relaxation,
            sections,
            utilisation,
            bolts,
            fields: FieldFiles::default(),
            case,
            units,
        })
    }

    /// The page's unit of a quantity.
    pub fn scale(&self, kind: Kind) -> Scale {
        self.units.scale(kind)
    }

    /// A value with the page's unit of its quantity. Energies span too much for one: what would be written with a power of ten, below
    /// a thousandth of it, has the unit that suits it.
    pub fn quantity(&self, kind: Kind, value: f64) -> String {
        let scale = self.units.scale(kind);
        match kind == Kind::Energy && value != 0.0 && (value * scale.factor).abs() < 1e-3 {
            true => quantity("J", value),
            false => scale.quantity(value),
        }
    }

    /// Whether there is anything to show of the ground's shaking, or should be. Where a run has only come through stages,
    /// what it writes of the shaking is not missing.
    pub fn shakes(&self) -> bool {
        let folder = &self.folder;
        let staged = self.relaxation.is_some()
            || self.summary.as_ref().is_ok_and(|summary| !summary.computed.stages.is_empty())
            || folder.stages().exists();
        let written = [folder.monitors(), folder.energy(), folder.pvd()].iter().any(|path| path.exists());
        !staged || written
    }

    /// What to say in the place of the shaking where there is nothing of it.
    pub fn still(&self) -> Option<String> {
        let asked = match &self.summary {
            Ok(summary) => !summary.computed.motion.kind.is_empty(),
            Err(_) => true,
        };
        (!self.shakes()).then_some(if asked {
            say!(
                self.language,
                "The run has not come to the earthquake: it ended in the stages before it, or is still in them."
            )
        } else {
            say!(
                self.language,
                "None: the case has no [motion]. This is a static study, and the stages are all of it."
            )
        })
    }

    /// A size with the page's unit of its quantity, where less than a thousandth of the unit is as good as nothing.
    pub fn size(&self, kind: Kind, value: f64) -> String {
        let scale = self.scale(kind);
        match value > 0.0 && value * scale.factor < 1e-3 {
            true => format!("<\u{a0}0.001\u{a0}{}", scale.unit),
            false => scale.quantity(value),
        }
    }

    /// The summary, or an empty one.
    pub fn facts(&self) -> Summary {
        facts(&self.summary, &self.monitors)
    }

    /// How long the histories are (s); without them, how long the run was to be.
    pub fn duration(&self) -> f64 {
        let last = self.monitors.as_ref().ok().and_then(|table| table.column("time")?.last().copied());
        last.unwrap_or(self.facts().computed.model.duration)
    }
}

/// The summary, or one with peaks alone.
fn facts(summary: &Result<Summary, String>, monitors: &Result<Table, String>) -> Summary {
    summary.clone().unwrap_or_else(|_| {
        let mut facts = Summary::default();
        if let Ok(monitors) = monitors {
            complete(&mut facts, monitors);
        }
        facts
    })
}

/// What the columns of a table are, each with its largest value by size.
fn kinds(table: &Table) -> impl Iterator<Item = (Kind, f64)> {
    // Levels are no displacements.
    let columns = table
        .columns
        .iter()
        .zip(&table.values)
        .filter(|(column, _)| !["depth", "z"].contains(&column.name.as_str()));
    columns.filter_map(|(column, values)| {
        let finite = values.iter().filter(|x| x.is_finite());
        Some((Kind::of_unit(&column.unit)?, finite.fold(0.0, |most, x| f64::max(most, x.abs()))))
    })
}

/// Fills in peaks that the summary lacks from the histories.
fn complete(summary: &mut Summary, monitors: &Table) {
    if !summary.monitors.peaks.is_empty() {
        return;
    }
    let [single, pairs] = peaks_by_monitor(monitors);
    summary.monitors.peaks = single;
    if summary.monitors.relative.is_empty() {
        summary.monitors.relative = pairs;
    }
}

/// The section forces, if there are any rows.
fn sections(path: &Path, language: Language) -> Result<Vec<SectionRow>, String> {
    let rows = read_sections(path).map_err(|e| format!("{e}."))?;
    if rows.is_empty() {
        Err(say!(language, "{file} has no rows yet.", file = "sections.csv"))
    } else {
        Ok(rows)
    }
}

/// A table that must have the column `key`.
fn table(path: &Path, key: &str, language: Language) -> Result<Table, String> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    if !path.exists() {
        return Err(say!(language, "There is no {file} in the result folder.", file = name));
    }
    let table = Table::read(path).map_err(|e| format!("{e}."))?;
    if table.column(key).is_none() {
        return Err(say!(language, "{file} has no column {key}.", file = name, key = key));
    }
    if table.rows() == 0 {
        return Err(say!(language, "{file} has no rows yet.", file = name));
    }
    Ok(table)
}
