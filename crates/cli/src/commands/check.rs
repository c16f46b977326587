//! `tremolite check`: what will happen, before it happens.

use super::defaulted::{Known, defaulted, text};
use super::{check_step, load, pool};
use crate::exit::{Code, Failure, Outcome};
use crate::machine;
use crate::terminal::{bytes, duration, print};
use indexmap::IndexMap;
use std::path::PathBuf;
use tremolite::run::{choose_step, time_step_cost};
use tremolite::survey::{Survey, limit_in_words, survey};
use tremolite::{Assembly, Model, Phase, Stage, stable_step};
use tremolite_results::{MaterialFacts, Origin};

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
}

pub fn run(args: &Args) -> Outcome {
    let isa = machine::isa(args.isa.as_deref())?;
    let (case, setup) = load(&args.case, isa)?;
    let pool = pool(args.threads)?;
    pool.install(|| {
        let groups = setup.problem.mesh.groups.clone();
        let (motion, plan) = (setup.motion, setup.plan);
        let model = Model::new(setup.problem).map_err(Failure::input)?;
        let assembly = Assembly::new(&model).map_err(Failure::input)?;
        let phase = Phase::of(&model, &assembly, Stage::Shaking).map_err(Failure::input)?;
        let survey = survey(&model, &assembly, motion.highest_frequency).map_err(Failure::input)?;
        let stable = stable_step(&model, &assembly, &phase);
        check_step(&case, &stable);
        let (dt, steps) = choose_step(&model, &plan, &stable);

        print(&case.title.value);
        print(&format!(
            "\nMesh       {} elements ({} excavated), {} nodes",
            survey.active_elements, survey.void_elements, survey.nodes
        ));
        for (name, elements) in &groups {
            print(&format!("           {:28} {:>8}", name, elements.len()));
        }
        print_materials(&setup.materials, &survey);
        print("\nMotion");
        print(&format!("           {}", motion.source));
        let [from, to] = motion.window;
        print(&format!("           {from:.2} to {to:.2} s of the record are used"));
        print(&format!(
            "           kind = {}: the incident wave is {} times the given motion",
            motion.kind, motion.factor
        ));
        let axis = |i: usize| {
            let m = &motion.intensity[i];
            format!("{:.3} m/s2, {:.3} m/s, {:.3} m", m.pga, m.pgv, m.pgd)
        };
        for (i, name) in ["x", "y", "z"].into_iter().enumerate() {
            print(&format!("           given peaks along {name}: {}", axis(i)));
        }
        if let Some(coarsest) = survey.coarsest() {
            print(&format!(
                "           99.9 % of its energy lies below {:.1} Hz: {:.1} elements a shear wave there (8 or more is good); fewest in {}",
                motion.highest_frequency,
                coarsest.per_wavelength,
                model.element_name(coarsest.coarsest as usize)
            ));
        }
        print("\nTime step");
        print(&format!(
            "           {:.4e} s stable, set by {}",
            stable.dt,
            limit_in_words(&model, &assembly, &stable)
        ));
        print(&format!("           {dt:.4e} s used, {} steps for {:.2} s", steps.total, plan.duration));
        let cost = time_step_cost(&model, &assembly, &phase, dt);
        let threads = rayon::current_num_threads();
        print("\nEstimate");
        print(&format!(
            "           {} with {threads} threads and {} ({:.1} million element updates a second), {} of memory",
            duration(cost * steps.total as f64 * 1.05),
            isa.name(),
            survey.active_elements as f64 / cost / 1e6,
            bytes(survey.bytes)
        ));
        let left_out = defaulted(&Known {
            case: &case,
            assembly: &assembly,
            plan: &plan,
            motion: &motion,
            materials: &setup.materials,
            reference: setup.reference,
            dt,
        });
        if !left_out.is_empty() {
            print("\nLeft out, and taken as");
            left_out.iter().for_each(|d| print(&format!("           {} = {}", d.key, d.value)));
        }
        Ok(Code::Done)
    })
}

fn print_materials(materials: &IndexMap<String, MaterialFacts>, survey: &Survey) {
    print("\nMaterials");
    for (name, facts) in materials {
        print(&format!("           {name}: {}, {}", facts.law, facts.summary));
        for group in &facts.groups {
            let body = survey.bodies.iter().find(|b| b.name == group.names);
            let step = body.map_or(String::new(), |b| format!(", could run at {:.3e} s", b.element_step));
            print(&format!("             {} {} in {}{step}", group.elements, group.element, group.names));
        }
        print(&format!(
            "             {:.0} kg/m3, c_p {:.0} m/s, c_s {:.0} m/s; damping: {}",
            facts.density, facts.wave_speed_p, facts.wave_speed_s, facts.damping
        ));
        for (words, derived) in [("given", false), ("derived", true)] {
            let values = facts.values.iter().filter(|v| (v.origin == Origin::Derived) == derived);
            let values: Vec<String> = values.map(|v| format!("{} {}", v.name, text(v))).collect();
            if !values.is_empty() {
                print(&format!("             {words}: {}", values.join(", ")));
            }
        }
    }
}
