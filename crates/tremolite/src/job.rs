//! A job: a case with all that is made of it, to be checked, run and resumed.
//!
//! Nothing here talks to a terminal. What is unusual are [`Remark`]s, in the order in which they are to be told; what cannot be
//! run is a [`Fault`], which carries those found before.

mod begun;
mod checked;
pub mod defaulted;
mod fault;
mod loaded;
mod oversize;
pub mod warnings;

pub use crate::setup::Inputs;
pub use begun::{Begun, Caller};
pub use checked::{Checked, Relaxed, diagnostics};
use fault::once;
pub use fault::{Fault, Remark, Why};
pub use loaded::{Given, Loaded};
pub use oversize::oversized;

use crate::near_sides::{NearSide, near_sides};
use crate::outlook::{Outlook, outlook};
use crate::plan::{Plan, Steps};
use crate::setup::MotionFacts;
use crate::simulation::{self, choose_step};
use crate::survey::{Survey, step_in_words, survey};
use defaulted::{Known, defaulted};
use indexmap::IndexMap;
use std::path::Path;
use std::sync::Arc;
use tremolite_case::{Case, Diagnostic, Mesh};
use tremolite_engine::{Assembly, Model, Phase, Ranks, StableStep, Stage};
use tremolite_results::{Defaulted, Input, MaterialFacts};

/// Steps beyond which a run is a slip of units: a year on a fast machine.
const MOST_STEPS: u64 = 100_000_000_000;

/// A case that can be run.
///
/// ```
/// use std::{path::Path, sync::atomic::AtomicBool};
/// use tremolite::{job::{Caller, Given, Inputs, Job}, run::Control, simulation::Start};
/// use tremolite_motion::Channel;
/// use tremolite_results::{ResultFolder, Status};
///
/// let case = r#"
/// title = "a column under a pulse"
/// [mesh.box]
/// group = "rock"
/// x = { from = "0 m", to = "2 m", elements = 1 }
/// y = { from = "0 m", to = "2 m", elements = 1 }
/// z = { from = "-20 m", to = "0 m", elements = 10 }
/// [material.rock]
/// law = "elastic"
/// young = "2 GPa"
/// poisson = 0.25
/// density = "2500 kg/m3"
/// [[region]]
/// groups = ["rock"]
/// material = "rock"
/// element = "reduced-integration"
/// [motion]
/// kind = "incident"
/// east = { file = "pulse" }
/// [dynamic]
/// base = "viscous"
/// sides = "periodic"
/// [[monitor]]
/// name = "top"
/// at = ["1 m", "1 m", "-1 m"]
/// "#;
/// // There is no file of the name "pulse": the record is in memory.
/// let pulse = (0..100).map(|k| (-(0.2 * f64::from(k - 40)).powi(2)).exp() * (0.4 * f64::from(k - 40)).sin());
/// let pulse = Channel::new("pulse", 0.01, pulse.collect());
/// let inputs = Inputs { records: [("pulse".to_owned(), vec![pulse])].into(), ..Inputs::default() };
/// let job = Job::of_text(case, Path::new("."), &Given { inputs, ..Given::default() })?;
/// for warning in job.warnings() {
///     println!("{}: {}; {}", warning.key, warning.message, warning.remedy);
/// }
///
/// let parent = tempfile::tempdir()?;
/// let folder = ResultFolder::create(Some(&parent.path().join("column")), "column", false)?;
/// let mut control = Control { stop: &AtomicBool::new(false), progress: &mut |_| {} };
/// let (_, summary) = job.run(&folder, Start::Rest, &Caller::new("example"), &mut control)?;
/// assert_eq!(summary.conclusion.status, Status::Done);
/// assert!(summary.monitors.peaks["top"]["ux"].max > 0.0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub struct Job {
    pub case: Case,
    pub plan: Plan,
    /// Nothing without an earthquake.
    pub motion: Option<MotionFacts>,
    /// Materials by their names in the case.
    pub materials: IndexMap<String, MaterialFacts>,
    /// Number of elements by group, as the mesh has them.
    pub groups: Vec<(String, usize)>,
    /// Frequency at which moduli are meant with damping over a band \[Hz\].
    pub reference: Option<f64>,
    /// The case and what it names.
    pub inputs: Vec<Input>,
    pub model: Arc<Model>,
    pub assembly: Arc<Assembly>,
    /// Of the shaking.
    pub phase: Arc<Phase>,
    pub survey: Survey,
    /// Boundaries beside openings.
    pub near: Vec<NearSide>,
    /// Nothing without stages and initial stress.
    pub outlook: Option<Outlook>,
    pub stable: StableStep,
    /// The step to run with \[s\].
    pub dt: f64,
    pub steps: Steps,
    /// What reading the case and building what it asks for found unusual.
    of_case: Vec<Diagnostic>,
    /// What looks at the model found unusual, look by look.
    of_model: Vec<Vec<Diagnostic>>,
    /// What is not as an earlier run read it, a sentence each.
    changed: Vec<String>,
}

impl Job {
    /// Lets go of parts that other ranks evaluate: what is left of them is where they push.
    pub fn share(&mut self, ranks: &Ranks) {
        self.assembly = Arc::new(self.assembly.of_rank(&ranks.division, ranks.rank()));
    }

    /// The job of a case file.
    ///
    /// # Errors
    /// If the case cannot be read, built or run.
    pub fn read(path: &Path, given: &Given) -> Result<Job, Fault> {
        Job::of_loaded(Loaded::read(path, given)?)
    }

    /// The job of a case's text. Relative paths start from `directory`; messages call the case as if it were `case.toml` there.
    ///
    /// # Errors
    /// As [`Job::read`].
    pub fn of_text(text: &str, directory: &Path, given: &Given) -> Result<Job, Fault> {
        Job::of_loaded(Loaded::of_text(text, &directory.join("case.toml"), directory, given)?)
    }

    /// The job of a case.
    ///
    /// # Errors
    /// As [`Job::read`].
    pub fn of(case: &Case, given: &Given) -> Result<Job, Fault> {
        Job::of_loaded(Loaded::of(case, given)?)
    }

    /// The job of a case whose files have been read.
    ///
    /// # Errors
    /// If what it asks for is no model, or would never come to its end.
    pub fn of_loaded(loaded: Loaded) -> Result<Job, Fault> {
        let remarks = loaded.remarks();
        let Loaded { case, setup, changed, .. } = loaded;
        let groups = setup.problem.mesh.groups.iter();
        let groups = groups.map(|(name, elements)| (name.clone(), elements.len())).collect();
        let built = Built::of(&case, setup.problem, &setup.plan, setup.motion.as_ref());
        let Built { model, assembly, phase, stable, survey, outlook, near } = match built {
            Ok(built) => built,
            Err(why) => return Err(Fault { remarks, why }),
        };
        let plan = setup.plan;
        let mut motion = setup.motion;
        if let (Some(facts), Some(waves)) = (&mut motion, &plan.waves) {
            // With what the field keeps for the heights of the model.
            facts.series = waves.field.bytes();
        }
        let (dt, steps) = choose_step(&model, &plan, &stable);
        let of_model = vec![
            outlook.iter().flat_map(|outlook| warnings::of_pieces(&case, outlook)).collect(),
            outlook.iter().flat_map(|outlook| warnings::of_ground(&case, outlook)).collect(),
            warnings::of_step(&case, &stable).into_iter().collect(),
            warnings::of_rows(&case, dt).into_iter().collect(),
            warnings::of_waves(&case, &model, &survey),
            warnings::of_near(&case, &near),
            warnings::of_stairs(&case, &model),
            warnings::of_pairs(&case, &model, &plan),
            warnings::of_bolts(&case, &model, &plan),
        ];
        let of_case = once([case.warnings.clone(), setup.warnings].concat());
        let job = Job {
            case,
            plan,
            motion,
            materials: setup.materials,
            groups,
            reference: setup.reference,
            inputs: setup.inputs,
            model,
            assembly,
            phase,
            survey,
            near,
            outlook,
            stable,
            dt,
            steps,
            of_case,
            of_model,
            changed,
        };
        if steps.total < MOST_STEPS {
            return Ok(job);
        }
        let why = Why::Endless {
            steps: steps.total as f64,
            stable: job.stable.dt,
            set_by: step_in_words(&job.model, &job.assembly, &job.stable).to_string(),
        };
        Err(Fault { remarks: [remarks, job.remarks()].concat(), why })
    }

    /// What is unusual of the model, in the order in which it is to be told behind that of [`Loaded::remarks`].
    pub fn remarks(&self) -> Vec<Remark> {
        Remark::of(&self.case, &self.of_model.concat()).into_iter().collect()
    }

    /// All that is unusual, each at its place in the case.
    pub fn warnings(&self) -> impl Iterator<Item = &Diagnostic> {
        self.of_case.iter().chain(self.of_model.iter().flatten())
    }

    /// What was said of the case before the run, a sentence each: what is unusual, and what has changed since a run whose result
    /// folder holds the case.
    pub fn said(&self) -> Vec<String> {
        let sentence = |p: &Diagnostic| format!("{}; {}", p.message, p.remedy);
        self.warnings().map(sentence).chain(self.changed.iter().cloned()).collect()
    }

    /// Every key that was left out, with its value.
    pub fn defaulted(&self) -> Vec<Defaulted> {
        defaulted(&Known {
            case: &self.case,
            model: &self.model,
            assembly: &self.assembly,
            plan: &self.plan,
            motion: self.motion.as_ref(),
            materials: &self.materials,
            reference: self.reference,
            dt: self.dt,
        })
    }

    /// All that is to be said of it before it runs, estimated for the pool of threads that this is called from.
    pub fn check(&self) -> Checked<'_> {
        Checked::of(self)
    }

    /// The name of the case, by which its results are called: its folder's if the file is called case.toml, else the file's.
    pub fn name(&self) -> String {
        let path = &self.case.path;
        let stem = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
        let whole = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        let folder = whole.parent().and_then(Path::file_name).map(|s| s.to_string_lossy().into_owned());
        if stem == "case" { folder.unwrap_or(stem) } else { stem }
    }
}

/// What the engine makes of a case, and a look at it.
struct Built {
    model: Arc<Model>,
    assembly: Arc<Assembly>,
    phase: Arc<Phase>,
    stable: StableStep,
    survey: Survey,
    outlook: Option<Outlook>,
    near: Vec<NearSide>,
}

impl Built {
    fn of(
        case: &Case,
        problem: tremolite_engine::Problem,
        plan: &Plan,
        motion: Option<&MotionFacts>,
    ) -> Result<Built, Why> {
        let refused = |e| Why::refused(case, e);
        let model = Model::new(problem).map_err(refused)?;
        let assembly = Assembly::new(&model).map_err(refused)?;
        let phase = Phase::of(&model, &assembly, Stage::Shaking).map_err(refused)?;
        let built = simulation::Built::of(&model, &assembly, &phase);
        drop((model, assembly, phase));
        let simulation::Built { model, assembly, phase, stable } = built.levelled(plan).map_err(refused)?;
        // Without an earthquake every wave is long.
        let highest = motion.map_or(0.0, |motion| motion.highest_frequency);
        let foreseen = || match plan.stages.is_empty() {
            true => Ok(None),
            false => outlook(&model, &assembly, plan, matches!(case.mesh, Mesh::Caverns(_))).map(Some),
        };
        let looked = || (survey(&model, &assembly, highest), near_sides(&model, warnings::mirrored(case)));
        let (outlook, (survey, near)) = rayon::join(foreseen, looked);
        let mut survey = survey.map_err(Why::Model)?;
        survey.bytes += plan.waves.as_ref().map_or(0, |waves| waves.field.bytes());
        let outlook = outlook.map_err(refused)?;
        Ok(Built { model, assembly, phase, stable, survey, outlook, near })
    }
}
