//! One file a command.

pub mod bench;
pub mod check;
mod defaulted;
pub mod law;
pub mod list;
pub mod mesh;
pub mod motion;
mod near;
pub mod new;
mod pieces;
pub mod report;
pub mod run;
pub mod verify;

use crate::exit::Failure;
use std::path::Path;
use tremolite::places::element;
use tremolite::plan::{Plan, Steps};
use tremolite::setup::{Laws, Setup, changed, original_folder, setup};
use tremolite::support;
use tremolite::survey::{Survey, step_in_words};
use tremolite::{Assembly, Model, ModelError, StableStep, Stage, laws};
use tremolite_case::{Case, Change, Fill, Problem, Side, units};
use tremolite_laws::{Dimension, Isa, LawInfo};
use tremolite_results::BoltPlace;

/// Reads a case, with the values of `set` (KEY=VALUE) at their keys, and builds what it asks for; warnings go to the
/// terminal.
pub fn load(path: &Path, set: &[String], isa: Isa) -> Result<(Case, Setup), Failure> {
    let laws = Laws::default();
    let change = |text: &String| Change::of_option("--set", text);
    let changes: Vec<Change> = set.iter().map(change).collect::<Result<_, _>>().map_err(Failure::input)?;
    let original = original_folder(path);
    let directory = original.as_deref().or(path.parent()).unwrap_or(Path::new(""));
    let case = Case::read_changed(path, directory, &changes, &infos()).map_err(|r| Failure::case(&r))?;
    if !case.warnings.is_empty() {
        let report = case.report(case.warnings.clone()).as_warnings();
        crate::terminal::say(&report.render(crate::terminal::colour()));
    }
    let setup = setup(&case, &laws, isa).map_err(|r| Failure::case(&r))?;
    if !setup.warnings.is_empty() {
        let report = case.report(setup.warnings.clone()).as_warnings();
        crate::terminal::say(&report.render(crate::terminal::colour()));
    }
    if let Some(original) = original {
        crate::terminal::say(&format!("the files of this case are looked for from {}", original.display()));
        for what in changed(path, &setup.inputs) {
            crate::terminal::say(&format!("warning: {what}"));
        }
    }
    Ok((case, setup))
}

/// Why a case is no model, at its interface or boundary where it is about one.
pub fn refused(case: &Case, error: &ModelError) -> Failure {
    let sides = &case.dynamic.sides;
    let named = |name: &str| case.interfaces.iter().find(|interface| interface.name.value == name);
    let (span, otherwise) = match error {
        ModelError::Periodic { low, .. } => {
            (sides[usize::from(low.starts_with('y'))].span.clone(), "choose another kind of sides")
        }
        ModelError::FreeField(_) => {
            let free = sides.iter().find(|side| side.value == Side::FreeField).unwrap_or(&sides[0]);
            (free.span.clone(), "choose another kind of sides")
        }
        ModelError::Top { .. } => (case.dynamic.top.span.clone(), "write top = \"free\""),
        _ => match error.interface().and_then(named) {
            Some(interface) => (interface.span.clone(), "see `tremolite list interfaces`"),
            None => return Failure::input(error),
        },
    };
    let text = error.to_string();
    let (message, remedy) = text.split_once("; ").unwrap_or((&text, otherwise));
    Failure::case(&case.report(vec![Problem::new(span, message, remedy)]))
}

/// Steps beyond which a run is a slip of units: a year on a fast machine.
const MOST_STEPS: u64 = 100_000_000_000;

/// Refuses a run that would never end.
pub fn check_length(
    model: &Model,
    assembly: &Assembly,
    stable: &StableStep,
    steps: Steps,
) -> Result<(), Failure> {
    if steps.total < MOST_STEPS {
        return Ok(());
    }
    Err(Failure::input(format!(
        "the run would take {:.1e} steps: the stable step is {:.1e} s, set by {}; look at the units of stiffness, density and size \
         there",
        steps.total as f64,
        stable.dt,
        step_in_words(model, assembly, stable)
    )))
}

/// Warns of monitors on interfaces that lie far from them. Returns what it said.
pub fn check_pairs(case: &Case, model: &Model, plan: &Plan) -> Vec<Problem> {
    let written = case.monitors.iter().filter(|monitor| monitor.interface.is_some());
    let problems: Vec<Problem> = written
        .zip(&plan.pairs)
        .filter_map(|(written, monitor)| {
            let seam = &model.seams[monitor.interface];
            let at = seam.place(&model.mesh, seam.nearest(&model.mesh, monitor.point));
            let away = (0..3).map(|i| (at[i] - monitor.point[i]).powi(2)).sum::<f64>().sqrt();
            let [x, y, z] = at;
            (away > FAR).then(|| {
                let name = &monitor.name;
                Problem::at(
                    &written.at,
                    format!("monitor {name} is {away:.1} m from '{}': it takes the pair at ({x:.1}, {y:.1}, {z:.1}) m", seam.name),
                    "give a point on the interface, if another is meant",
                )
            })
        })
        .collect();
    if !problems.is_empty() {
        let report = case.report(problems.clone()).as_warnings();
        crate::terminal::say(&report.render(crate::terminal::colour()));
    }
    problems
}

/// Warns of groups of bolts that are not whole, and of monitors that lie far from their bolt. Returns what it said.
pub fn check_bolts(case: &Case, model: &Model, plan: &Plan) -> Vec<Problem> {
    // A group is placed by a stage; the first of the model's is the initial equilibrium.
    let stage = |name: &str| {
        let set = model.bolts.iter().find(|set| set.kind.name == name)?;
        match set.kind.born {
            Stage::Before(k) => {
                case.stages.get(usize::from(k).checked_sub(1)?).map(|stage| stage.span.clone())
            }
            Stage::Shaking => None,
        }
    };
    let span = |name: &str| stage(name).unwrap_or_else(|| case.title.span.clone());
    let groups = support::bolts(&model.bolts, plan, None, &|_, _| Vec::new(), &[]);
    let warnings = support::warnings(&groups).into_iter();
    let mut problems: Vec<Problem> =
        warnings.map(|(name, message, remedy)| Problem::new(span(&name), message, remedy)).collect();
    let places = support::monitors(&model.bolts, plan);
    for monitor in &plan.bolts {
        let Some(written) = case.monitors.iter().find(|written| written.name.value == monitor.name) else {
            continue;
        };
        let (message, remedy) = match places.get(&monitor.name) {
            None => (
                format!(
                    "monitor {} has no bolt: there is none in '{}'",
                    monitor.name, model.bolts[monitor.set].kind.name
                ),
                "leave it out, or see why there is none",
            ),
            Some(BoltPlace { bolt, group, at: [x, y, z], .. }) => {
                let away = model.bolts[monitor.set].distance(monitor.point);
                if away <= FAR {
                    continue;
                }
                (
                    format!(
                        "monitor {} is {away:.1} m from '{group}': it takes bolt {bolt} at ({x:.1}, {y:.1}, {z:.1}) m",
                        monitor.name
                    ),
                    "give a point on the bolt, if another is meant",
                )
            }
        };
        problems.push(Problem::at(&written.at, message, remedy));
    }
    if !problems.is_empty() {
        let report = case.report(problems.clone()).as_warnings();
        crate::terminal::say(&report.render(crate::terminal::colour()));
    }
    problems
}

/// Distance \[m\] of a monitor from its pair or its segment that goes without saying: less than a lining's thickness or an element.
const FAR: f64 = 1.0;

/// Warns of a given time step above the stable one: the run will be stopped as soon as energy appears. Returns what it
/// said.
pub fn check_step(case: &Case, stable: &StableStep) -> Option<Problem> {
    case.motion.as_ref()?;
    let impacts = stable.contact.map_or(f64::INFINITY, |contact| contact.dt);
    if let Some(given) = &case.dynamic.time_step
        && given.value <= stable.dt
        && given.value > impacts
    {
        return warn(
            case,
            Problem::at(
                given,
                format!(
                    "{} is longer than impacts at interfaces allow, {}: they may gain energy",
                    units::format(given.value, Dimension::TIME),
                    units::format(impacts, Dimension::TIME)
                ),
                "give a shorter one, a softer `normal_stiffness`, or a larger `contact_limit` if that is meant",
            ),
        );
    }
    let given = case.dynamic.time_step.as_ref().filter(|given| given.value > stable.dt)?;
    let step = |t: f64| units::format(t, Dimension::TIME);
    let problem = Problem::at(
        given,
        format!(
            "{} is above the stable step of {}: the run will become unstable and be stopped",
            step(given.value),
            step(stable.dt)
        ),
        format!("give {} or less, or leave time_step out", step(0.9 * stable.dt)),
    );
    warn(case, problem)
}

/// Says a warning, and returns it.
fn warn(case: &Case, problem: Problem) -> Option<Problem> {
    let report = case.report(vec![problem.clone()]).as_warnings();
    crate::terminal::say(&report.render(crate::terminal::colour()));
    Some(problem)
}

/// Elements a wavelength below which waves are not carried but distorted.
const FEWEST: f64 = 5.0;

/// Warns of regions too coarse for the motion's waves. Returns what it said.
pub fn check_waves(case: &Case, model: &Model, survey: &Survey) -> Vec<Problem> {
    let solid = case.regions.iter().filter(|region| matches!(region.fill, Fill::Solid { .. }));
    let problems: Vec<Problem> = solid
        .zip(&survey.bodies)
        .filter(|(_, body)| body.per_wavelength < FEWEST)
        .map(|(region, body)| {
            Problem::new(
                region.span.clone(),
                format!(
                    "a shear wave of the motion's highest frequency has {:.1} elements in {}: it will not arrive as it was",
                    body.per_wavelength,
                    element(model, body.coarsest as usize)
                ),
                "make elements smaller, or take the highest frequencies out with \"lowpass\"; 8 elements and more are good",
            )
        })
        .collect();
    if !problems.is_empty() {
        let report = case.report(problems.clone()).as_warnings();
        crate::terminal::say(&report.render(crate::terminal::colour()));
    }
    problems
}

/// Descriptions of all laws a case may name.
pub fn infos() -> Vec<LawInfo> {
    laws().iter().map(|l| l.info).collect()
}

/// A pool of `threads` threads, or of all.
pub fn pool(threads: Option<usize>) -> Result<rayon::ThreadPool, Failure> {
    let threads = threads.unwrap_or_else(crate::machine::threads);
    if !(1..=4096).contains(&threads) {
        return Err(Failure::input("--threads is between 1 and 4096"));
    }
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().map_err(Failure::failed)
}
