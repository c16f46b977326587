//! `tremolite check`: what will happen, before it happens.

mod json;
mod text;

use super::defaulted::{Known, defaulted};
use super::{check_length, check_pairs, check_step, check_waves, load, pool, refused};
use crate::exit::{Code, Failure, Outcome};
use crate::machine;
use crate::terminal::print;
use indexmap::IndexMap;
use std::path::PathBuf;
use tremolite::disk::{Disk, disk};
use tremolite::interfaces::{interfaces, monitors};
use tremolite::plan::Steps;
use tremolite::run::{choose_step, time_step_cost};
use tremolite::setup::MotionFacts;
use tremolite::survey::{Survey, impacts_in_words, limit_in_words, survey};
use tremolite::{Assembly, Model, Phase, Stage, stable_step};
use tremolite_case::{Case, Problem};
use tremolite_laws::Isa;
use tremolite_results::{Defaulted, InterfaceSummary, MaterialFacts, PairPlace};

#[derive(clap::Args)]
pub struct Args {
    /// The case file
    case: PathBuf,
    /// Threads to estimate for (all by default)
    #[arg(long)]
    threads: Option<usize>,
    /// Force an instruction set: scalar, avx2 or avx512
    #[arg(long)]
    isa: Option<String>,
    /// Print one JSON object, numbers in SI
    #[arg(long)]
    json: bool,
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
    /// Stable step \[s\], what sets it, and the step used \[s\].
    stable: f64,
    set_by: String,
    /// What impacts at interfaces allow.
    impacts: Option<String>,
    dt: f64,
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

impl Checked<'_> {
    /// Wall time of the run \[s\]; observers take a twentieth.
    fn seconds(&self) -> f64 {
        1.05 * self.cost * self.steps.total as f64
    }

    fn updates_per_second(&self) -> f64 {
        self.survey.active_elements as f64 / self.cost
    }
}

pub fn run(args: &Args) -> Outcome {
    let isa = machine::isa(args.isa.as_deref())?;
    let (case, setup) = load(&args.case, isa)?;
    let pool = pool(args.threads)?;
    pool.install(|| {
        let groups = setup.problem.mesh.groups.iter();
        let groups = groups.map(|(name, elements)| (name.clone(), elements.len())).collect();
        let (motion, plan) = (setup.motion, setup.plan);
        let model = Model::new(setup.problem).map_err(|e| refused(&case, &e))?;
        let assembly = Assembly::new(&model).map_err(|e| refused(&case, &e))?;
        let phase = Phase::of(&model, &assembly, Stage::Shaking).map_err(Failure::input)?;
        // Without an earthquake every wave is long.
        let highest = motion.as_ref().map_or(0.0, |motion| motion.highest_frequency);
        let survey = survey(&model, &assembly, highest).map_err(Failure::input)?;
        let stable = stable_step(&model, &assembly, &phase);
        let mut warnings = [case.warnings.clone(), setup.warnings].concat();
        warnings.extend(check_step(&case, &stable));
        warnings.extend(check_waves(&case, &model, &survey));
        warnings.extend(check_pairs(&case, &model, &plan));
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
            coarsest: survey.coarsest().map_or(String::new(), |b| model.element_name(b.coarsest as usize)),
            survey,
            interfaces: interfaces(&model, &assembly, &assembly.rest().history),
            pairs: monitors(&model, &plan),
            stable: stable.dt,
            set_by: limit_in_words(&model, &assembly, &stable),
            impacts: impacts_in_words(&model, &stable),
            dt,
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
