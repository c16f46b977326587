//! From a checked case to a problem and a plan: reads the mesh and the records, and says all that does not fit.

mod mesh;
mod monitors;
mod motion;
mod regions;

pub use motion::MotionFacts;

use crate::material::Law;
use crate::plan::Plan;
use crate::problem::{Base, Incident, Problem, Rayleigh, Side, TimeStep};
use crate::quantities::Field;
use tremolite_case::{self as case, Case, Report};
use tremolite_laws::Isa;

/// All a run needs, and what of the input is worth reporting.
pub struct Setup {
    pub problem: Problem,
    pub plan: Plan,
    pub motion: MotionFacts,
}

/// Builds the problem and the plan of a case. `laws` are those the case may name.
///
/// # Errors
/// All problems found in the mesh, the records and what refers to them, at their places in the case.
pub fn setup(case: &Case, laws: &[Law], isa: Isa) -> Result<Setup, Report> {
    let mut problems = Vec::new();
    let motion = motion::build(case, &mut problems);
    let mesh = mesh::build(case, &mut problems);
    let fields = fields(case, &mut problems);
    let base = base(case, &mut problems);
    let Some(mesh) = mesh else { return Err(case.report(problems)) };
    let bodies = regions::build(case, &mesh, laws, &mut problems);
    let monitors = monitors::build(case, &mesh, &bodies, &mut problems);
    let (Some((motion, facts)), true) = (motion, problems.is_empty()) else {
        return Err(case.report(problems));
    };

    let dynamic = &case.dynamic;
    let duration = dynamic.duration.as_ref().map_or(motion.duration(), |d| d.value);
    let mut problem = Problem::new(mesh, bodies);
    problem.base = base;
    problem.sides = dynamic.sides.each_ref().map(|s| side(s.value));
    problem.incident = Some(Incident { motion, factor: facts.factor });
    problem.rayleigh =
        Rayleigh { mass: dynamic.rayleigh.mass.value, stiffness: dynamic.rayleigh.stiffness.value };
    problem.time_step =
        TimeStep { safety: dynamic.safety.value, given: dynamic.time_step.as_ref().map(|t| t.value) };
    problem.isa = isa;
    let output = &case.output;
    let plan = Plan {
        title: case.title.value.clone(),
        duration,
        histories: output.histories.value,
        snapshots: output.snapshots.as_ref().map(|s| s.value),
        fields,
        checkpoint: output.checkpoint.as_ref().map(|c| c.value),
        monitors,
        relatives: case.relatives.iter().map(|r| r.between).collect(),
    };
    Ok(Setup { problem, plan, motion: facts })
}

fn fields(case: &Case, problems: &mut Vec<case::Problem>) -> Vec<Field> {
    let known: Vec<&str> = Field::ALL.iter().map(|f| f.description().0).collect();
    case.output
        .fields
        .iter()
        .filter_map(|word| {
            let field = Field::from_word(word);
            if field.is_none() {
                let message = format!("there is no field '{}'", word.value);
                problems.push(case::Problem::at(word, message, format!("known are {}", known.join(", "))));
            }
            field
        })
        .collect()
}

fn base(case: &Case, problems: &mut Vec<case::Problem>) -> Base {
    let base = &case.dynamic.base;
    match &base.value {
        case::Base::ViscousSpring { normal, tangential, distance } => Base::ViscousSpring {
            normal: normal.value,
            tangential: tangential.value,
            distance: distance.as_ref().map(|d| d.value),
        },
        case::Base::Viscous => Base::Viscous,
        case::Base::Fixed | case::Base::Free => {
            problems.push(case::Problem::at(
                base,
                "the motion cannot enter through this base, so the run would do nothing",
                "use base = \"viscous-spring\" or \"viscous\"",
            ));
            Base::Free
        }
    }
}

fn side(side: case::Side) -> Side {
    match side {
        case::Side::Fixed => Side::Fixed,
        case::Side::Roller => Side::Roller,
        case::Side::Free => Side::Free,
        case::Side::Viscous => Side::Viscous,
        case::Side::Periodic => Side::Periodic,
    }
}
