//! From a checked case to a problem and a plan: reads the mesh and the records, and says all that does not fit.

mod bolts;
mod changes;
mod doubts;
mod edges;
pub(crate) mod facts;
mod groups;
mod holes;
mod initial;
mod inputs;
mod interfaces;
mod materials;
mod memory;
mod mesh;
mod monitors;
mod motion;
mod page;
mod places;
mod planes;
mod processing;
mod records;
mod regions;
mod reinforcement;
mod sections;
mod seepage;
mod sides;
mod site;
mod soaked;
mod softening;
mod soil;
mod stages;
mod target;
pub(crate) mod undrained;
pub(crate) mod unlikely;
mod warnings;
mod water;
mod wave_sides;
mod waves;

pub use facts::{CarriedFacts, MotionFacts, Peaks, SiteFacts, SoilFacts, WaveFacts};
pub use inputs::{changed, original_folder};
pub use memory::Inputs;
pub use page::limits;
pub use target::of_case as target_of;
pub use undrained::MEANINGS as MEANINGS_OF_WATER;

use crate::plan::{FIELD_ELEMENTS, Plan};
use crate::quantities::Field;
use indexmap::IndexMap;
use stages::Staged;
use std::path::Path;
use tremolite_case::{self as case, Case, Report};
use tremolite_engine::{Base, Body, Interface, Life, Problem, Rayleigh, TimeStep, Water, column};
use tremolite_kernels::{InterfaceLaw, Law, interface_laws, laws};
use tremolite_laws::Isa;
use tremolite_laws::band::Band;
use tremolite_results::{Input, MaterialFacts};

/// All a run needs, and what of the input is worth reporting.
pub struct Setup {
    pub problem: Problem,
    pub plan: Plan,
    /// Nothing without an earthquake.
    pub motion: Option<MotionFacts>,
    /// Materials by their names in the case.
    pub materials: IndexMap<String, MaterialFacts>,
    /// Frequency at which moduli are meant with damping over a band \[Hz\].
    pub reference: Option<f64>,
    /// The case and the files that it names.
    pub inputs: Vec<Input>,
    /// What is unusual though it can be run, at its place in the case.
    pub warnings: Vec<case::Diagnostic>,
}

/// The mesh of a case, or of a mesh's own description, with what is made of it, in this folder or `held` in memory: in metres, and
/// what is worth knowing of it, at its place in the file. Planes leave linings whole that `interfaces` separate from the rock. Sides that
/// are `free` need not match one another ([`free_sides`] of a case).
///
/// # Errors
/// Why it cannot be generated or read, at its place in the file.
pub fn mesh_of(
    mesh: &case::Mesh,
    ground: &case::Ground,
    interfaces: &[case::Interface],
    free: [bool; 2],
    directory: &Path,
    held: &Inputs,
) -> Result<(tremolite_mesh::Mesh, Vec<case::Diagnostic>), Vec<case::Diagnostic>> {
    let mut problems = Vec::new();
    let built = mesh::build(mesh, ground, interfaces, free, directory, held, &mut problems);
    let Some(mesh::Built { mesh, mut warnings, doubled, .. }) = built else {
        return Err(problems);
    };
    warnings.extend(doubled);
    Ok((mesh, warnings))
}

/// Of the sides normal to x and to y of a case, whether nodes of the two need not match: all but periodic ones.
pub fn free_sides(case: &Case) -> [bool; 2] {
    case.dynamic.sides.each_ref().map(|side| side.value != case::Side::Periodic)
}

/// Makes groups by place in a mesh that is there, then linings of its holes, as a description of where it comes from has them.
///
/// # Errors
/// Why one cannot be made, at its place in the description; those before it are made then.
pub fn add_to_mesh(
    source: &case::Mesh,
    ground: &case::Ground,
    mesh: &mut tremolite_mesh::Mesh,
) -> Result<(), Vec<case::Diagnostic>> {
    let mut problems = Vec::new();
    places::group(source, &ground.groups, &[], mesh, &mut problems);
    holes::line(&ground.linings, mesh, &mut problems);
    if problems.is_empty() { Ok(()) } else { Err(problems) }
}

/// The motion that a case gives to its model, processed and in the model's axes, and what is worth knowing of it, without a look at
/// its mesh; nothing where there is no earthquake.
///
/// # Errors
/// Why its records cannot be read or processed, at their places in the file.
pub fn motion_of(case: &Case) -> Result<Option<(tremolite_motion::Motion, MotionFacts)>, Report> {
    let mut problems = Vec::new();
    let made = motion::build(case, &Inputs::default(), &mut problems);
    if problems.is_empty() { Ok(made) } else { Err(case.report(problems)) }
}

/// What a case makes of a mesh, which need not be its own: a body for each region that is not void. Records may be `held` in
/// memory.
///
/// # Errors
/// Regions that do not fit the mesh or leave elements out, at their places in the case.
pub fn bodies_of(
    case: &Case,
    mesh: &tremolite_mesh::Mesh,
    held: &Inputs,
    laws: &[Law],
) -> Result<Vec<Body>, Report> {
    let mut problems = Vec::new();
    // Only damping over a band asks for the motion.
    let motion = case.dynamic.band.as_ref().and_then(|_| motion::build(case, held, &mut problems));
    let reference = reference(case, motion.as_ref());
    let band = reference.and_then(|reference| band(case, reference, &mut problems));
    let bodies = regions::build(case, mesh, laws, band, &mut problems);
    if problems.is_empty() { Ok(bodies) } else { Err(case.report(problems)) }
}

/// The laws that a case may name: by default those of the house.
#[derive(Clone)]
pub struct Laws {
    pub materials: Vec<Law>,
    pub interfaces: Vec<InterfaceLaw>,
}

impl Default for Laws {
    fn default() -> Self {
        Laws { materials: laws(), interfaces: interface_laws() }
    }
}

/// Builds the problem and the plan of a case, and lists its materials.
///
/// # Errors
/// All problems found in the mesh, the records and what refers to them, at their places in the case.
pub fn setup(case: &Case, laws: &Laws, isa: Isa) -> Result<Setup, Report> {
    setup_of(case, &Inputs::default(), laws, isa)
}

/// The same where some of what the case names is in memory.
///
/// # Errors
/// As [`setup`]; and what in memory cannot be used, at its name in the case.
pub fn setup_of(case: &Case, held: &Inputs, laws: &Laws, isa: Isa) -> Result<Setup, Report> {
    let mut problems = Vec::new();
    let motion = motion::build(case, held, &mut problems);
    let (ground, directory) = (&case.ground, case.directory());
    let mesh =
        mesh::build(&case.mesh, ground, &case.interfaces, free_sides(case), directory, held, &mut problems);
    let fields = fields(case, &mut problems);
    let base = base(case, &mut problems);
    let Some(mesh::Built { mut mesh, mut warnings, doubled, taken }) = mesh else {
        return Err(case.report(problems));
    };
    sides::check_planes(case, &mesh, &mut problems);
    let oblique = case.motion.as_ref().filter(|motion| !motion.waves.is_empty());
    match (oblique, &motion) {
        (Some(oblique), _) => waves::check_sides(case, oblique, &mut problems),
        (None, Some((motion, _))) => sides::check_motion(case, motion, &mut problems),
        (None, None) => {}
    }
    sides::check_springs(case, oblique.is_some(), &mut problems);
    interfaces::tie(case, &mut mesh, &mut problems);
    let reference = reference(case, motion.as_ref());
    if let (Some(band), None, Some(_)) = (&case.dynamic.band, reference, &motion) {
        problems.push(case::Diagnostic::at(
            &band.ratio,
            "the motion is zero, so it has no central frequency at which moduli could be meant",
            "write the frequency in `damping`: reference = \"0 Hz\" for moduli of slow loading",
        ));
    }
    let band = reference.and_then(|reference| band(case, reference, &mut problems));
    let mut bodies = regions::build(case, &mesh, &laws.materials, band, &mut problems);
    let mut staged = Staged::build(case, &mesh, &mut bodies, &laws.materials, band, &mut problems);
    soaked::soak(case, &mesh, &mut bodies, &mut staged, &mut problems);
    let bolts::Placed { bolts, warnings: of_bolts } = bolts::build(case, &mesh, &staged, held, &mut problems);
    stages::check_pressures(case, &mesh, &mut problems);
    seepage::check_names(case, &mesh, &mut problems);
    stages::check_moved(case, &mesh, &staged.solid(), &mut problems);
    let lasting = staged.lasting(&bodies);
    let monitors = monitors::build(case, &mesh, &lasting, &mut problems);
    let interfaces = interfaces::build(case, &mesh, &bodies, &staged.places, &laws.interfaces, &mut problems);
    let pairs = interfaces::monitors(case, &mesh, &mut problems);
    let at_bolts = bolts::monitors(case, &mesh, &mut problems);
    let solid = staged.solid();
    let (bars, bare) = reinforcement::build(case, &mesh, &staged.places, &solid, &mut problems);
    let judged = sections::build(case, &mesh, &staged.places, &solid, &lasting, &mut problems);
    check_springs(case, &mesh, &lasting, &interfaces, staged.lives(), base, &mut problems);
    if !problems.is_empty() {
        return Err(case.report(problems));
    }
    let (motion, mut facts) = motion.unzip();
    let rayleigh =
        Rayleigh { mass: case.dynamic.rayleigh.mass.value, stiffness: case.dynamic.rayleigh.stiffness.value };
    let in_pores = match undrained::is_undrained(case) {
        true => water::of(case, &staged.materials, &mesh, &lasting),
        false => Water::default(),
    };
    let around = || site::Around {
        bodies: &lasting,
        water: &in_pores,
        rayleigh,
        top: sides::top(case.dynamic.top.value),
        grounds: grounds(&mesh, &lasting, &interfaces, staged.lives()),
        overburden: case.initial.overburden.is_some(),
    };
    let mut at_angles = None;
    let entering = match (&case.motion, motion, &mut facts) {
        (Some(written), Some(motion), Some(facts)) if !written.waves.is_empty() => {
            let around = around();
            let (low, high) = mesh.bounds();
            at_angles = waves::enter(case, written, &motion, facts, &around, [low, high], &mut problems);
            if let Some(planned) = &at_angles {
                let driven = wave_sides::Driven {
                    bounds: (low, high),
                    case,
                    mesh: &mesh,
                    bodies: &lasting,
                    water: &in_pores,
                    lives: staged.lives(),
                };
                driven.check(&planned.frame.ground, &interfaces, &mut problems);
                warnings.extend(driven.warnings());
            }
            None
        }
        (Some(written), Some(motion), Some(facts)) => {
            site::enter(written, motion, facts, around, &mut problems)
        }
        _ => None,
    };
    if !problems.is_empty() {
        return Err(case.report(problems));
    }
    let risen = entering.as_ref().map(|entering| &entering.incident.motion);
    let motion = risen.or(at_angles.as_ref().map(|waves| &waves.motion));

    // Where an interface lies, nodes are doubled on purpose.
    warnings.extend(doubled.filter(|_| !interfaces::explain_doubled(&mesh, &interfaces)));
    warnings.extend(unlikely::lengths(case, &mesh));
    warnings.extend(interfaces::warnings(case, &laws.interfaces));
    warnings.extend(warnings::of_laws(case, &bodies, &fields));
    warnings.extend(softening::warnings(case, &mesh, &lasting));
    warnings.extend(sides::warnings(case));
    warnings.extend(warnings::of_thin_bodies(case, &mesh, &lasting));
    warnings.extend(warnings::of_single_layers(case, &mesh, &lasting));
    warnings.extend(edges::warnings(case, &mesh, &lasting));
    warnings.extend(warnings::of_axes(case, &mesh, &lasting));
    warnings.extend(warnings::of_tetrahedra(case, &mesh, &lasting, &in_pores));
    warnings.extend(warnings::of_plateaus(case, &mesh, &lasting));
    warnings.extend(stages::warnings(case));
    warnings.extend(stages::forgotten(case, &mesh));
    warnings.extend(places::warnings(case, &taken));
    warnings.extend(of_bolts);
    warnings.extend(bare);
    warnings.extend(facts.iter().flat_map(|facts| facts.warnings.clone()));
    warnings.extend(motion.iter().flat_map(|motion| warnings::of_motion(case, motion, reference)));
    let late = at_angles.as_ref().map_or(0.0, |waves| waves.field.late());
    warnings.extend(motion.and_then(|motion| doubts::of_duration(case, motion, late)));
    warnings.extend(motion.and_then(|motion| unlikely::duration(case, motion)));
    warnings.extend(motion.and_then(|motion| doubts::of_mass_damping(case, motion)));
    warnings.extend(doubts::of_braked_pieces(case, &bodies));
    warnings.extend(motion.and_then(|motion| doubts::of_rows(case, motion)));
    let more: Vec<_> = staged.saturated.iter().map(|&body| (body, staged.materials[body])).collect();
    let materials = materials::facts(case, &mesh, &laws.materials, &bodies, &more, reference);
    warnings.extend(unlikely::physics(case, &materials));
    let dynamic = &case.dynamic;
    let shaking = |motion: &tremolite_motion::Motion| match &dynamic.duration {
        Some(given) => given.value,
        None => motion.duration(),
    };
    let duration = motion.map_or(0.0, shaking);
    let histories = &case.output.histories;
    if motion.is_some() && histories.value > duration {
        return Err(case.report(vec![case::Diagnostic::at(
            histories,
            format!("rows {} s apart leave none within the run of {duration:.3} s", histories.value),
            "choose an interval well below the duration",
        )]));
    }
    let acting = sides::acting(case, &mesh, &bodies, base);
    let mut problem = Problem::new(mesh, bodies);
    problem.interfaces = interfaces;
    problem.bolts = bolts;
    let reinforcement = bars.len();
    problem.bolts.extend(bars);
    reinforcement::tell_apart(&mut problem.bolts);
    (problem.sides, problem.base) = acting;
    problem.side_springs = sides::has_springs(case);
    problem.top = sides::top(dynamic.top.value);
    let (incident, recorded) = entering.map(|entering| (entering.incident, entering.recorded)).unzip();
    problem.incident = incident;
    problem.free_field = at_angles.as_ref().map(|waves| waves.field.clone() as _);
    problem.rayleigh = rayleigh;
    problem.time_step = TimeStep {
        safety: dynamic.safety.value,
        given: dynamic.time_step.as_ref().map(|t| t.value),
        levels: dynamic.levels.value as u8,
    };
    problem.isa = isa;
    warnings.extend(soaked::warnings(case, &problem, &staged));
    let made_of = staged.materials.clone();
    warnings.extend(staged.fill(case, &mut problem));
    problem.water = water::of(case, &made_of, &problem.mesh, &problem.bodies);
    let seeped = seepage::seep(case, &made_of, &problem).map_err(|refused| case.report(vec![refused]))?;
    problem.water.spells.extend(seeped.spells);
    warnings.extend(seeped.warnings);
    let output = &case.output;
    let plan = Plan {
        title: case.title.value.clone(),
        page: page::wish(&case.page),
        boundaries: boundaries(case),
        target: target::drawn(case),
        stages: seepage::planned(Staged::plan(case), seeped.flows),
        duration,
        recorded: recorded.flatten(),
        waves: at_angles,
        histories: output.histories.value,
        snapshots: output.snapshots.as_ref().map(|s| s.value),
        fields,
        field_elements: FIELD_ELEMENTS,
        checkpoint: output.checkpoint.as_ref().map(|c| c.value),
        monitors,
        pairs,
        bolts: at_bolts,
        bars: reinforcement,
        water: case.water.is_some(),
        sections: judged,
        relatives: case.relatives.iter().map(|r| r.between.map(|m| in_elements(case, m))).collect(),
    };
    let inputs = inputs::inputs(case, held);
    let warnings = case.keyed(warnings);
    Ok(Setup { problem, plan, motion: facts, materials, reference, inputs, warnings })
}

/// The boundaries while the ground shakes, by their words.
fn boundaries(case: &Case) -> IndexMap<String, String> {
    let dynamic = &case.dynamic;
    let [x, y] = dynamic.sides.each_ref().map(|side| side.value.word());
    let all = [("base", dynamic.base.value.word()), ("x", x), ("y", y), ("top", dynamic.top.value.word())];
    let all = all.into_iter().filter(|_| case.motion.is_some());
    all.map(|(place, word)| (place.to_owned(), word.to_owned())).collect()
}

/// The place of one of the case's monitors among those in elements.
fn in_elements(case: &Case, monitor: usize) -> usize {
    case.monitors[..monitor].iter().filter(|m| m.is_in_element()).count()
}

/// The frequency \[Hz\] at which moduli are meant with damping over a band: the motion's central one unless the case
/// says which; none without such damping.
fn reference(case: &Case, motion: Option<&(tremolite_motion::Motion, MotionFacts)>) -> Option<f64> {
    match &case.dynamic.band.as_ref()?.reference {
        Some(reference) => Some(reference.value),
        None => tremolite_motion::highest_frequency(&motion?.0, 0.5),
    }
}

/// Damping over a band with moduli meant at `reference` \[Hz\].
fn band(case: &Case, reference: f64, problems: &mut Vec<case::Diagnostic>) -> Option<Band> {
    let given = case.dynamic.band.as_ref()?;
    match Band::fit(given.ratio.value, given.band.value, reference) {
        Ok(band) => Some(band),
        Err(e) => {
            let remedy = "for rock, a ratio of 0.01 to 0.05 over 0.5 Hz to 20 Hz is usual";
            problems.push(case::Diagnostic::at(&given.ratio, e.to_string(), remedy));
            None
        }
    }
}

fn fields(case: &Case, problems: &mut Vec<case::Diagnostic>) -> Vec<Field> {
    let known: Vec<&str> = Field::ALL.iter().map(|f| f.description().0).collect();
    case.output
        .fields
        .iter()
        .filter_map(|word| {
            let field = Field::from_word(word);
            if field.is_none() {
                let message = format!("there is no field '{}'", word.value);
                problems.push(case::Diagnostic::at(word, message, format!("known are {}", known.join(", "))));
            }
            field
        })
        .collect()
}

fn base(case: &Case, problems: &mut Vec<case::Diagnostic>) -> Base {
    let base = &case.dynamic.base;
    match &base.value {
        case::Base::ViscousSpring { normal, tangential, distance, .. } => Base::ViscousSpring {
            normal: normal.value,
            tangential: tangential.value,
            distance: distance.as_ref().map(|d| d.value),
        },
        case::Base::Viscous => Base::Viscous,
        case::Base::Fixed if case.motion.is_none() => Base::Fixed,
        case::Base::Free if case.motion.is_none() => Base::Free,
        case::Base::Fixed | case::Base::Free => {
            problems.push(case::Diagnostic::at(
                base,
                "the motion cannot enter through this base, so the run would do nothing",
                "use base = \"viscous\" or \"viscous-spring\"",
            ));
            Base::Free
        }
    }
}

/// The ground at the model's corners.
///
/// # Errors
/// Why there is none, in words that may stand behind 'but'.
fn grounds(
    mesh: &tremolite_mesh::Mesh,
    bodies: &[Body],
    interfaces: &[Interface],
    lives: &[Life],
) -> Result<[column::Ground; 4], String> {
    let mut body_of = vec![None; mesh.elements.len()];
    for (b, body) in bodies.iter().enumerate() {
        body.elements.iter().for_each(|&e| body_of[e as usize] = Some(b));
    }
    column::grounds(mesh, bodies, &body_of, interfaces, lives)
}

/// Refuses springs of the base where there is no column of ground along the model's vertical edges: they act on what differs from its
/// motion.
fn check_springs(
    case: &Case,
    mesh: &tremolite_mesh::Mesh,
    bodies: &[Body],
    interfaces: &[Interface],
    lives: &[Life],
    base: Base,
    problems: &mut Vec<case::Diagnostic>,
) {
    // What else is wrong comes first: elements without a material are no ground.
    if !base.has_springs() || !problems.is_empty() || case.motion.is_none() {
        return;
    }
    // The slabs have columns of their own.
    if case.dynamic.sides.iter().all(|side| side.value == case::Side::FreeField) {
        return;
    }
    if let Err(reason) = grounds(mesh, bodies, interfaces, lives) {
        problems.push(case::Diagnostic::at(
            &case.dynamic.base,
            format!("the springs of the base act on what differs from columns of the ground at the model's corners, but {reason}"),
            "write base = \"viscous\", or let the ground along the model's vertical edges be whole and stay in all stages",
        ));
    }
}
