//! `tremolite check`: what will happen, before it happens.

mod bolts;
mod json;
mod stages;
mod text;

use super::defaulted::{Known, defaulted};
use super::near::{check_near, mirrored};
use super::pieces::check_pieces;
use super::{check_bolts, check_length, check_pairs, check_step, check_waves, load, pool, refused};
use crate::exit::{Code, Failure, Outcome};
use crate::machine;
use crate::terminal::print;
use indexmap::IndexMap;
use std::path::PathBuf;
use tremolite::disk::{Disk, disk};
use tremolite::interfaces::{interfaces, monitors};
use tremolite::near_sides::near_sides;
use tremolite::outlook::{Outlook, StressAt, outlook, stress_at_start};
use tremolite::places::element;
use tremolite::plan::Steps;
use tremolite::setup::MotionFacts;
use tremolite::simulation::choose_step;
use tremolite::step_cost::time_step_cost;
use tremolite::support;
use tremolite::survey::{Survey, impacts_in_words, limit_in_words, survey};
use tremolite::{Assembly, Body, Model, Phase, Stage, stable_step};
use tremolite_case::{Case, Problem};
use tremolite_laws::Isa;
use tremolite_results::{BoltPlace, BoltSummary, Defaulted, InterfaceSummary, MaterialFacts, PairPlace};

#[derive(clap::Args)]
pub struct Args {
    /// The case file
    case: PathBuf,
    /// Put another value at a key: material.rock.young="25 GPa", stage[*].release=0.5; as often as wanted
    #[arg(long, value_name = "KEY=VALUE")]
    set: Vec<String>,
    /// Threads to estimate for (all by default)
    #[arg(long)]
    threads: Option<usize>,
    /// Force an instruction set: scalar, avx2 or avx512
    #[arg(long)]
    isa: Option<String>,
    /// Print one JSON object, numbers in SI
    #[arg(long)]
    json: bool,
    /// Write where bolts will be into this folder, a file a group, as a case's `file` reads them
    #[arg(long, value_name = "DIR")]
    bolts: Option<PathBuf>,
    /// End with status 1 where there is a warning
    #[arg(long)]
    strict: bool,
}

/// All that is said of a case.
struct Checked<'a> {
    case: &'a Case,
    /// Number of elements by group.
    groups: Vec<(String, usize)>,
    materials: &'a IndexMap<String, MaterialFacts>,
    survey: Survey,
    /// Nothing without an earthquake.
    motion: Option<&'a MotionFacts>,
    /// The element with fewest elements a wavelength around it.
    coarsest: String,
    interfaces: IndexMap<String, InterfaceSummary>,
    /// Monitors on interfaces.
    pairs: IndexMap<String, PairPlace>,
    bolts: IndexMap<String, BoltSummary>,
    /// Monitors on bolts.
    bolt_monitors: IndexMap<String, BoltPlace>,
    /// Stable step \[s\], what sets it, and the step used \[s\].
    stable: f64,
    set_by: String,
    /// What impacts at interfaces allow.
    impacts: Option<String>,
    dt: f64,
    /// Nothing without stages and initial stress.
    outlook: Option<Outlook>,
    initial: Vec<StressAt>,
    relaxed: Vec<Relaxed>,
    steps: Steps,
    /// Simulated time \[s\].
    duration: f64,
    isa: Isa,
    threads: usize,
    /// Wall time of a step \[s\].
    cost: f64,
    disk: Disk,
    left_out: Vec<Defaulted>,
    warnings: Vec<Problem>,
}

/// The modulus of a material in the stages, where damping over a band makes it another.
struct Relaxed {
    material: String,
    /// Of the given moduli.
    share: f64,
    /// As given and in the stages \[Pa\], of a law with one.
    young: Option<[f64; 2]>,
}

impl Checked<'_> {
    /// Wall time of the run \[s\].
    fn seconds(&self) -> f64 {
        self.stage_seconds() + self.shaking_seconds()
    }

    /// Observers take a twentieth.
    fn shaking_seconds(&self) -> f64 {
        if self.motion.is_some() { 1.05 * self.cost * self.steps.total as f64 } else { 0.0 }
    }

    /// A cycle of relaxation costs what a step does.
    fn stage_seconds(&self) -> f64 {
        self.cost * self.cycles() as f64
    }

    fn cycles(&self) -> u64 {
        self.outlook.as_ref().map_or(0, |outlook| outlook.cycles)
    }

    fn updates_per_second(&self) -> f64 {
        self.survey.active_elements as f64 / self.cost
    }
}

pub fn run(args: &Args) -> Outcome {
    let isa = machine::isa(args.isa.as_deref())?;
    let (case, setup) = load(&args.case, &args.set, isa)?;
    let pool = pool(args.threads)?;
    pool.install(|| {
        let groups = setup.problem.mesh.groups.iter();
        let groups = groups.map(|(name, elements)| (name.clone(), elements.len())).collect();
        let (motion, plan) = (setup.motion, setup.plan);
        let model = Model::new(setup.problem).map_err(|e| refused(&case, &e))?;
        let assembly = Assembly::new(&model).map_err(|e| refused(&case, &e))?;
        let phase = Phase::of(&model, &assembly, Stage::Shaking).map_err(|e| refused(&case, &e))?;
        // Without an earthquake every wave is long.
        let highest = motion.as_ref().map_or(0.0, |motion| motion.highest_frequency);
        if let Some(folder) = &args.bolts {
            bolts::write(folder, &model.bolts).map_err(Failure::failed)?;
        }
        let survey = survey(&model, &assembly, highest).map_err(Failure::input)?;
        let stable = stable_step(&model, &assembly, &phase);
        let mut warnings = [case.warnings.clone(), setup.warnings].concat();
        let outlook = match plan.stages.is_empty() {
            true => None,
            false => Some(outlook(&model, &assembly, &plan).map_err(|e| refused(&case, &e))?),
        };
        warnings.extend(outlook.iter().flat_map(|outlook| check_pieces(&case, outlook)));
        warnings.extend(check_step(&case, &stable));
        warnings.extend(check_waves(&case, &model, &survey));
        warnings.extend(check_near(&case, &near_sides(&model, mirrored(&case))));
        warnings.extend(check_pairs(&case, &model, &plan));
        warnings.extend(check_bolts(&case, &model, &plan));
        let failed = args.strict && !warnings.is_empty();
        let (dt, steps) = choose_step(&model, &plan, &stable);
        check_length(&model, &assembly, &stable, steps)?;
        let left_out = defaulted(&Known {
            case: &case,
            model: &model,
            assembly: &assembly,
            plan: &plan,
            motion: motion.as_ref(),
            materials: &setup.materials,
            reference: setup.reference,
            base_without_springs: setup.base_without_springs.as_deref(),
            dt,
        });
        let checked = Checked {
            case: &case,
            groups,
            materials: &setup.materials,
            motion: motion.as_ref(),
            coarsest: survey
                .coarsest()
                .map_or(String::new(), |b| element(&model, b.coarsest as usize).to_string()),
            survey,
            interfaces: interfaces(&model, &assembly, &assembly.rest().history),
            pairs: monitors(&model, &plan),
            bolts: support::bolts(&model.bolts, &plan, None, &|_, _| Vec::new(), &[]),
            bolt_monitors: support::monitors(&model.bolts, &plan),
            stable: stable.dt,
            set_by: limit_in_words(&model, &assembly, &stable).to_string(),
            impacts: impacts_in_words(&model, &stable).map(|said| said.to_string()),
            dt,
            outlook,
            initial: stress_at_start(&model),
            relaxed: relaxed(&case, &model, &setup.materials),
            steps,
            duration: plan.duration,
            isa,
            threads: rayon::current_num_threads(),
            cost: time_step_cost(&model, &assembly, &phase, dt),
            disk: disk(&model, &assembly, &phase, &plan, steps),
            left_out,
            warnings,
        };
        if args.json {
            print(&serde_json::to_string_pretty(&checked.json()).unwrap_or_default());
        } else {
            checked.print();
        }
        Ok(if failed { Code::Failed } else { Code::Done })
    })
}

/// The moduli of the stages that differ from those given.
fn relaxed(case: &Case, model: &Model, facts: &IndexMap<String, MaterialFacts>) -> Vec<Relaxed> {
    if !case.seeks_equilibrium() {
        return Vec::new();
    }
    let of_material = |(name, facts): (&String, &MaterialFacts)| {
        let made = |body: &&Body| facts.groups.iter().any(|group| group.names == body.name);
        let share = model.user_bodies().iter().find(made)?.material.band()?.relaxed();
        let young = facts.values.iter().find(|v| v.name == "young").map(|v| [v.value, share * v.value]);
        Some(Relaxed { material: name.clone(), share, young })
    };
    facts.iter().filter_map(of_material).collect()
}
