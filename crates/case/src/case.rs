//! The case as a whole.

mod reading;
mod rewritten;

use std::path::{Path, PathBuf};

use tremolite_laws::Dimension;

use crate::bolts::{BoltPlace, Bolts};
use crate::change::{Change, Changed};
use crate::check::{Checker, UNITS};
use crate::consistency;
use crate::defaulted::Defaulted;
use crate::dynamic::{DYNAMIC, Dynamic};
use crate::fields::Fields;
use crate::initial::{INITIAL, Initial};
use crate::interface::{INTERFACE, Interface};
use crate::keyed;
use crate::keys::{Key, Kind, Limit, Table};
use crate::laws::Laws;
use crate::material::{MATERIAL, Material};
use crate::mesh::{Ground, MESH, Mesh};
use crate::monitor::{MONITOR, Monitor, RELATIVE, Relative};
use crate::motion::{MOTION, Motion, Target};
use crate::output::{OUTPUT, Output};
use crate::page::{Page, REPORT};
use crate::region::{REGION, Region};
use crate::reinforcement::{REINFORCEMENT, Reinforcement};
use crate::seams;
use crate::section::{SECTION, Section};
use crate::stage::{STAGE, Stage, Written, in_steps};
use crate::water::{WATER, Water};
use crate::{Diagnostic, Report, Spanned, report, syntax};

/// The direction of x. It stands above all tables.
pub(crate) const X_AZIMUTH: Key = Key::default(
    "model_x_azimuth",
    Kind::Number(Dimension::ANGLE, Limit::Any),
    r#""90 deg""#,
    "Direction of the model's x axis, clockwise from north; by default y is north",
);

pub(crate) static CASE: Table = Table {
    path: "",
    doc: "A study: a mesh, its materials, an earthquake, and what is kept of the answer.",
    keys: &[
        Key::required("title", Kind::Text, "what the study is about"),
        UNITS,
        X_AZIMUTH,
        Key::required("mesh", Kind::Table(&MESH), "with [mesh.caverns], [mesh.box] or [mesh.file]"),
        Key::required("material", Kind::Materials(&MATERIAL), "the materials, each with a name"),
        Key::required("region", Kind::Tables(&REGION), "which groups of the mesh are made of what"),
        Key::optional(
            "interface",
            Kind::Interfaces(&INTERFACE),
            "bodies that touch are tied",
            "Where bodies meet: surfaces that may slide and open",
        ),
        Key::default("initial", Kind::Table(&INITIAL), "{}", "What is there before the earthquake"),
        Key::optional(
            "stage",
            Kind::Tables(&STAGE),
            "",
            "What is excavated, installed and changed before the earthquake, in this order",
        ),
        Key::optional(
            "reinforcement",
            Kind::Tables(&REINFORCEMENT),
            "",
            "Bars in linings, which move with the concrete",
        ),
        Key::optional("section", Kind::Tables(&SECTION), "", "By which code sections of linings are judged"),
        Key::optional(
            "motion",
            Kind::Table(&MOTION),
            "no earthquake: the case ends with what comes before it",
            "The earthquake",
        ),
        Key::required_beside(
            "dynamic",
            Kind::Table(&DYNAMIC),
            "motion",
            r#"{ sides = "roller" }"#,
            "the dynamic run",
        ),
        Key::optional("monitor", Kind::Tables(&MONITOR), "no monitors", "Points whose histories are kept"),
        Key::optional(
            "monitor_pair",
            Kind::Tables(&RELATIVE),
            "",
            "Pairs of monitors whose difference is kept",
        ),
        Key::default("output", Kind::Table(&OUTPUT), "{}", "What is written, and when"),
        Key::optional("water", Kind::Table(&WATER), "", "Water in the pores of the ground"),
        Key::default("report", Kind::Table(&REPORT), "{}", "How the page of the run is set"),
    ],
    choice: &[],
};

/// Keys beside those of `[dynamic]` that have no meaning without an earthquake.
const OF_SHAKING: [&str; 2] = ["output.histories", "output.snapshots"];

/// A case, read and checked. All values are in SI; values keep their place in the file, so that problems found
/// later can be shown there (see [`Case::report`]).
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// The file as the user named it.
    pub path: PathBuf,
    /// The folder that relative paths of the case start from.
    pub directory: PathBuf,
    /// Its text, with the changes that it was read with.
    pub source: String,
    /// The same with the file's own text.
    changed: Changed,
    /// What the study is about.
    pub title: Spanned<String>,
    /// Whether numbers without a unit are in SI, as the case says of itself.
    pub bare_si: bool,
    /// Direction of the model's x axis, clockwise from north, rad.
    pub model_x_azimuth: Spanned<f64>,
    /// Where the mesh comes from.
    pub mesh: Mesh,
    /// What is made of it before anything else goes by it.
    pub ground: Ground,
    /// In the order of the file; names unique.
    pub materials: Vec<Material>,
    /// Which groups are made of what.
    pub regions: Vec<Region>,
    /// Where bodies meet; names unique.
    pub interfaces: Vec<Interface>,
    /// What is there before the earthquake, and how equilibrium is sought.
    pub initial: Initial,
    /// Water in the pores of the ground.
    pub water: Option<Water>,
    /// What happens before the earthquake, in this order; names unique.
    pub stages: Vec<Stage>,
    /// Bars in linings.
    pub reinforcement: Vec<Reinforcement>,
    /// By which code sections of linings are judged.
    pub sections: Vec<Section>,
    /// The earthquake; nothing: the case ends with what comes before it.
    pub motion: Option<Motion>,
    /// The dynamic run; where it is left out, without an earthquake, its defaults between rollers.
    pub dynamic: Dynamic,
    /// Points whose histories are kept; names unique.
    pub monitors: Vec<Monitor>,
    /// Pairs of monitors.
    pub relatives: Vec<Relative>,
    /// What is written, and when.
    pub output: Output,
    /// How the page of the run is set.
    pub page: Page,
    /// What is allowed but hardly meant.
    pub warnings: Vec<Diagnostic>,
    /// Keys that were left out, with what is used instead.
    pub defaulted: Vec<Defaulted>,
}

impl Case {
    /// Checks the text of a case. Touches no files; `path` names the case in messages, and its directory is where
    /// the files of the case are.
    ///
    /// # Errors
    /// All problems of the text at once: of its syntax, or else of its content.
    pub fn parse<'a>(path: &Path, source: &str, laws: impl Into<Laws<'a>>) -> Result<Case, Report> {
        Case::parse_changed(path, source, &[], laws)
    }

    /// The same with other values at some keys, one change after the other.
    ///
    /// # Errors
    /// All problems at once: of the syntax, or else of the changes and of the content.
    pub fn parse_changed<'a>(
        path: &Path,
        source: &str,
        changes: &[Change],
        laws: impl Into<Laws<'a>>,
    ) -> Result<Case, Report> {
        let (changed, mut problems) = Changed::new(source, changes);
        let report = |problems| Report::new(path, source, changed.placed(problems));
        let document = syntax::parse(&changed.text).map_err(report)?;
        let mut checker = Checker::new(&CASE, laws.into(), document.get_ref());
        let written = checker.table(&CASE, Some(&[]), document.get_ref(), document.span(), "");
        let Checker { problems: of_values, mut defaulted, .. } = checker;
        let places: Vec<_> = of_values.iter().map(|problem| problem.span.clone()).collect();
        let refused = keyed::paths(&changed.text, &places);
        problems.extend(of_values);
        let (found, mut warnings) = consistency::check(&written, &Written::of(document.get_ref(), refused));
        problems.extend(found);
        let case = Case::assemble(path, &changed, &written);
        match case {
            Some(mut case) if problems.is_empty() => {
                case.output.show_all(&case.interfaces, &case.materials, &mut defaulted);
                if !case.seeks_equilibrium() {
                    Initial::hide_search(&mut defaulted);
                }
                if case.motion.is_none() {
                    let of_shaking = |key: &str| key.starts_with("dynamic.") || OF_SHAKING.contains(&key);
                    defaulted.retain(|d| !of_shaking(&d.key));
                }
                defaulted.extend(seams::told(&case.ground.planes));
                report::find_keys(&case.source, &mut warnings);
                Ok(Case { warnings, defaulted, ..case })
            }
            None if problems.is_empty() => {
                // Every part that cannot be read has been reported, so this is not reached; but a run must not start.
                let remedy = "compare it with the example cases";
                Err(report(vec![Diagnostic::new(0..0, "the case is not complete", remedy)]))
            }
            _ => Err(report(problems)),
        }
    }

    /// Puts the parts together; nothing where one of them was refused, which has been reported.
    fn assemble(path: &Path, changed: &Changed, case: &Fields) -> Option<Case> {
        let initial = case.table("initial").and_then(Initial::read)?;
        let written = consistency::materials(case);
        let names: Vec<&str> = written.iter().map(|m| m.name.value.as_str()).collect();
        let regions = case.tables("region").map(|r| Region::read(r, &names)).collect::<Option<_>>()?;
        let stages: Vec<Stage> =
            case.tables("stage").map(|s| Stage::read(s, &names)).collect::<Option<_>>()?;
        let stages = in_steps(stages);
        let reinforcement = case.tables("reinforcement").map(Reinforcement::read).collect::<Option<_>>()?;
        let sections = case.tables("section").map(Section::read).collect::<Option<_>>()?;
        let motion = match case.table("motion") {
            Some(motion) => Some(Motion::read(motion, initial.gravity.value, case.number(X_AZIMUTH.name)?)?),
            None => None,
        };
        let water = match case.table("water") {
            Some(water) => Some(Water::read(water)?),
            None => None,
        };
        let model_x_azimuth = case.number(X_AZIMUTH.name)?;
        let ground = case.table("mesh").and_then(|mesh| Ground::read(mesh, model_x_azimuth.value))?;
        let materials: Vec<Material> =
            written.iter().map(|m| Material::read(m, initial.gravity.value)).collect::<Option<_>>()?;
        let mut interfaces: Vec<Interface> =
            case.tables("interface").map(Interface::read).collect::<Option<_>>()?;
        interfaces.extend(seams::interfaces(&ground.planes, &materials));
        let names: Vec<&str> = interfaces.iter().map(|i| i.name.value.as_str()).collect();
        let bolts: Vec<&str> =
            stages.iter().flat_map(|stage| &stage.bolts).map(|b| b.name.value.as_str()).collect();
        let monitors: Vec<Monitor> =
            case.tables("monitor").map(|m| Monitor::read(m, &names, &bolts)).collect::<Option<_>>()?;
        let names: Vec<&str> = monitors.iter().map(|m| m.name.value.as_str()).collect();
        let relatives =
            case.tables("monitor_pair").map(|r| Relative::read(r, &names)).collect::<Option<_>>()?;
        Some(Case {
            path: path.to_owned(),
            directory: path.parent().unwrap_or(Path::new("")).to_owned(),
            source: changed.text.clone(),
            changed: changed.clone(),
            title: case.text("title")?,
            bare_si: case.text(UNITS.name).is_some(),
            mesh: case.table("mesh").and_then(|mesh| Mesh::read(mesh, model_x_azimuth.value))?,
            model_x_azimuth,
            ground,
            materials,
            regions,
            interfaces,
            initial,
            water,
            stages,
            reinforcement,
            sections,
            motion,
            dynamic: case.table("dynamic").and_then(Dynamic::read)?,
            monitors,
            relatives,
            output: case.table("output").and_then(Output::read)?,
            page: case.table("report").and_then(Page::read)?,
            warnings: Vec::new(),
            defaulted: Vec::new(),
        })
    }

    /// Whether equilibrium is sought before the earthquake: there is initial stress, or a stage.
    pub fn seeks_equilibrium(&self) -> bool {
        self.initial.stress.is_some() || !self.stages.is_empty()
    }

    /// All bolts in the order of the file, each with the place of its stage in [`Case::stages`].
    pub fn bolts(&self) -> impl Iterator<Item = (usize, &Bolts)> {
        self.stages.iter().enumerate().flat_map(|(k, stage)| stage.bolts.iter().map(move |bolts| (k, bolts)))
    }

    /// A report of problems found later, to be shown in this case's text.
    pub fn report(&self, problems: Vec<Diagnostic>) -> Report {
        Report::new(&self.path, &self.changed.original, self.changed.placed(problems))
    }

    /// Problems found later in this case's text, with the paths of their keys.
    pub fn keyed(&self, mut problems: Vec<Diagnostic>) -> Vec<Diagnostic> {
        report::find_keys(&self.source, &mut problems);
        problems
    }

    /// The directory that relative paths of the case start from.
    pub fn directory(&self) -> &Path {
        &self.directory
    }

    /// The path of a file that the case names.
    pub fn resolve(&self, file: &Path) -> PathBuf {
        self.directory().join(file)
    }

    /// The files that the case names, as they are written.
    pub fn files(&self) -> Vec<&Spanned<PathBuf>> {
        let mut files = self.motion.as_ref().map_or_else(Vec::new, Motion::files);
        if let Some(Target::File(file)) = self.motion.as_ref().and_then(|motion| motion.target.as_ref()) {
            files.push(file);
        }
        if let Mesh::File(file) = &self.mesh {
            files.push(&file.path);
        }
        files.extend(self.bolts().filter_map(|(_, bolts)| match &bolts.place {
            BoltPlace::File(file) => Some(file),
            _ => None,
        }));
        files
    }
}

#[cfg(test)]
mod tests;
