//! Steady seepage in each stage of a case: the ground that conducts, and what its pressure becomes.

mod bounds;
mod drains;
mod names;

pub use names::check_names;

use super::water::{mean_of, pores, shown};
use crate::seepage::StageFlow;
use crate::stages::PlannedStage;
use bounds::{Around, Bounds};
use std::collections::BTreeMap;
use std::time::Instant;
use tremolite_case::{Case, Diagnostic, Pressure};
use tremolite_engine::hexahedra::hex_nodes;
use tremolite_engine::water::Spell;
use tremolite_engine::{Problem, Stage};
use tremolite_mesh::merge::{coincident_nodes, shortest_edge};
use tremolite_results::{Said, said};
use tremolite_seepage::{Flow, Ground, Holds, Place, SeepageError, steady};

/// Conductivity of pores without a permeability over the smallest that is given: heads in them follow those around, and next to nothing
/// flows.
const TIGHT: f64 = 1e-6;
/// Share of the shortest edge within which nodes are at one place, as where a mesh comes parted at an interface.
const DOUBLED: f64 = 1e-3;
/// Change of pressure \[Pa\] that a tied lining misses without much harm.
const LITTLE: f64 = 1e3;

/// What seepage makes of a case's stages.
#[derive(Default)]
pub struct Seeped {
    /// Pressures from stages on, behind those of the initial level.
    pub spells: Vec<Spell>,
    /// By the stages' numbers.
    pub flows: Vec<(usize, StageFlow)>,
    pub warnings: Vec<Diagnostic>,
}

/// Whether pressures of a case come from seepage.
pub fn is_asked(case: &Case) -> bool {
    case.water.as_ref().is_some_and(|water| water.pressure.value == Pressure::Seepage)
}

/// Finds the flow in each stage of a problem whose elements are all there; `materials` are those of its bodies.
///
/// # Errors
/// Why there is none, at its place in the case.
pub fn seep(case: &Case, materials: &[usize], space: &Problem) -> Result<Seeped, Diagnostic> {
    let (true, Some(water)) = (is_asked(case), &case.water) else { return Ok(Seeped::default()) };
    let mesh = &space.mesh;
    let count = mesh.elements.len();
    let mut conductivity: Vec<Option<f64>> = vec![None; count];
    let mut body_of: Vec<Option<usize>> = vec![None; count];
    let given = materials.iter().filter_map(|&m| pores(case, m)?.hydraulic_conductivity.as_ref());
    let tight = TIGHT * given.map(|k| k.value).fold(f64::INFINITY, f64::min);
    for (b, (body, &material)) in space.bodies.iter().zip(materials).enumerate() {
        let k = pores(case, material)
            .map(|pores| pores.hydraulic_conductivity.as_ref().map_or(tight, |k| k.value));
        for &e in &body.elements {
            conductivity[e as usize] = k;
            body_of[e as usize] = Some(b);
        }
    }
    let mut joined: Vec<u32> = (0..mesh.nodes.len() as u32).collect();
    for (node, first) in coincident_nodes(mesh, DOUBLED * shortest_edge(mesh)) {
        joined[node as usize] = first;
    }
    let around = Around::new(space, &joined);
    let mut seeped = Seeped::default();
    let mut last: Option<Asked> = None;
    for k in 1..=case.stages.len() {
        let stage = Stage::Before(k as u16);
        let stands = |e: &u32| {
            let e = *e as usize;
            body_of[e].is_some() && space.lives.get(e).is_none_or(|life| life.holds(stage))
        };
        let standing: Vec<u32> = (0..count as u32).filter(stands).collect();
        let ground: Vec<u32> =
            standing.iter().copied().filter(|&e| conductivity[e as usize].is_some()).collect();
        let bounds = Bounds::of(&around, &standing, &ground);
        let placed = bounds.places(case, k, &around, &ground)?;
        for doubt in placed.warnings {
            // What holds on is told once.
            if !seeped.warnings.iter().any(|told| told.span == doubt.span && told.remedy == doubt.remedy) {
                seeped.warnings.push(doubt);
            }
        }
        let asked = Asked { ground, places: placed.places };
        if last.as_ref() == Some(&asked) {
            continue;
        }
        let start = Instant::now();
        let elements: Vec<[u32; 8]> =
            asked.ground.iter().map(|&e| hex_nodes(mesh, e as usize).map(|n| joined[n as usize])).collect();
        let own: Vec<f64> = asked.ground.iter().map(|&e| conductivity[e as usize].unwrap_or(tight)).collect();
        let ground = Ground { nodes: &mesh.nodes, elements: &elements, conductivity: &own };
        let flow = steady(&ground, &asked.places)
            .map_err(|error| refused(case, k, space, &asked.ground, &body_of, &error))?;
        let spell = spell(water.unit_weight.value, stage, space, &asked.ground, &joined, &flow);
        seeped.warnings.extend(tied(
            case,
            k,
            space,
            &bounds,
            &body_of,
            seeped.spells.last().or(space.water.spells.last()),
            &spell,
        ));
        let mut velocities = vec![[0.0; 3]; count];
        asked.ground.iter().zip(&flow.velocities).for_each(|(&e, q)| velocities[e as usize] = *q);
        let is_head = |place: &&Place| matches!(place.holds, Holds::Head(_));
        let heads = asked.places.iter().position(|place| is_head(&place)).unwrap_or(asked.places.len());
        let flow = StageFlow {
            places: asked.places.iter().map(|p| p.name.clone()).zip(flow.outflows.iter().copied()).collect(),
            heads,
            inflow: flow.inflow,
            mass_error: flow.mass_error,
            left: flow.left,
            iterations: flow.iterations,
            linear_iterations: flow.linear_iterations,
            seconds: start.elapsed().as_secs_f64(),
            velocities,
        };
        seeped.flows.push((k, flow));
        seeped.spells.push(spell);
        last = Some(asked);
    }
    Ok(seeped)
}

/// What a stage changes of where water comes from and goes to, a phrase each.
pub fn changes(stage: &tremolite_case::Stage) -> Vec<Said> {
    let heads = stage.water.heads.iter().map(|(place, head)| {
        said!("head of {head} at {place}", head = shown(head.value), place = &place.value)
    });
    let drained = stage.water.drained.iter().map(|names| match names.is_empty() {
        true => said!("no wall drained"),
        false => {
            let names: Vec<&str> = names.iter().map(|name| name.value.as_str()).collect();
            said!("walls drained: {groups}", groups = names.join(", "))
        }
    });
    let drains =
        stage.water.drains.iter().map(|drains| said!("drains: {count}", count = drains.len().to_string()));
    heads.chain(drained).chain(drains).collect()
}

/// Stages with what flows in them.
pub fn planned(mut stages: Vec<PlannedStage>, flows: Vec<(usize, StageFlow)>) -> Vec<PlannedStage> {
    for (k, flow) in flows {
        if let Some(stage) = stages.get_mut(k) {
            stage.flow = Some(flow);
        }
    }
    stages
}

/// What the flow goes by; one stage's may be that of the stage before.
#[derive(PartialEq)]
struct Asked {
    ground: Vec<u32>,
    places: Vec<Place>,
}

/// Pressures of a flow: none above the free surface.
fn spell(weight: f64, stage: Stage, space: &Problem, ground: &[u32], joined: &[u32], flow: &Flow) -> Spell {
    let mesh = &space.mesh;
    let head = |n: u32| {
        let n = joined[n as usize] as usize;
        weight * (flow.heads[n] - mesh.nodes[n][2])
    };
    let mut elements = vec![0.0; mesh.elements.len()];
    for &e in ground {
        let corners = hex_nodes(mesh, e as usize).map(head);
        let at = |shares: [f64; 8]| shares.iter().zip(corners).map(|(n, p)| n * p).sum::<f64>().max(0.0);
        elements[e as usize] = mean_of(mesh, e as usize, at);
    }
    let mut nodes = vec![0.0; mesh.nodes.len()];
    let mut wet = vec![false; mesh.nodes.len()];
    let corners = ground.iter().flat_map(|&e| mesh.elements[e as usize].nodes());
    corners.for_each(|&n| wet[joined[n as usize] as usize] = true);
    for n in (0..mesh.nodes.len() as u32).filter(|&n| wet[joined[n as usize] as usize]) {
        nodes[n as usize] = head(n).max(0.0);
    }
    Spell { from: stage, elements, nodes }
}

/// Why a stage has no flow, for people.
fn refused(
    case: &Case,
    stage: usize,
    space: &Problem,
    ground: &[u32],
    body_of: &[Option<usize>],
    error: &SeepageError,
) -> Diagnostic {
    let name = &case.stages[stage - 1].name;
    let element = |place: usize| {
        let e = ground[place] as usize;
        let body = body_of[e].map_or("the ground", |b| space.bodies[b].name.as_str());
        format!("element {} of '{body}'", space.mesh.element_id(e))
    };
    let (message, remedy) = match error {
        SeepageError::Apart(place) => (
            format!(
                "no water can come to or leave the ground around {} in this stage, so that its pressure is not determined",
                element(*place)
            ),
            "give `heads` at one of its sides, drain a wall of it (`drained`), or write water = \"none\" of its material",
        ),
        SeepageError::Shape(place) => {
            (format!("{} has no volume, or is turned inside out", element(*place)), "mend the mesh")
        }
        other => (
            format!("the seepage of this stage was not found: {other}"),
            "look for very thin elements or permeabilities that are far apart; a finer mesh around the free surface helps, or use \
             pressure = \"level\"",
        ),
    };
    Diagnostic::at(name, message, remedy)
}

/// Tight bodies that share faces with ground whose pressure changes after both stand: no water comes between them.
fn tied(
    case: &Case,
    stage: usize,
    space: &Problem,
    bounds: &Bounds,
    body_of: &[Option<usize>],
    before: Option<&Spell>,
    now: &Spell,
) -> Vec<Diagnostic> {
    let earlier = Stage::Before(stage as u16 - 1);
    let stood = |e: u32| space.lives.get(e as usize).is_none_or(|life| life.holds(earlier));
    let Some(before) = before else { return Vec::new() };
    let mut told: BTreeMap<[usize; 2], Diagnostic> = BTreeMap::new();
    for contact in bounds.contacts.iter().filter(|contact| contact.across.is_none()) {
        let [tight, rock] = [contact.tight, contact.face.element];
        let (Some(own), Some(beside)) = (body_of[tight as usize], body_of[rock as usize]) else { continue };
        let change = (now.elements[rock as usize] - before.elements[rock as usize]).abs();
        if change < LITTLE || !stood(tight) || !stood(rock) {
            continue;
        }
        told.entry([own, beside]).or_insert_with(|| {
            let [tight, rock] = [own, beside].map(|body| &space.bodies[body].name);
            Diagnostic::at(
                &case.stages[stage - 1].name,
                format!(
                    "'{tight}' is watertight and bonded to '{rock}': it does not feel the water behind it"
                ),
                "if it drains, name it in `drained`; if it holds water, give it an unbonded [[interface]]",
            )
        });
    }
    told.into_values().collect()
}
