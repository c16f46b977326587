//! Levels of steps: who may take longer ones.
//!
//! Nodes of level l make steps of 2^l Δt, and a part is evaluated as often as the finest node that it pushes (the partition of
//! `neal1989`). Coarser nodes that it pushes go on along straight lines between their own times, so every part sees a motion at all
//! its own times, and laws with history see only states that occur.
//!
//! **Who is how coarse.** An element by its own bound 2/ω_e (`irons1971`), with its viscosity, and with the springs at its nodes: of
//! pairs, bolts and the base, twice each, since what holds two nodes together weighs at most so much at either. Steps of coarser levels
//! are at most [`SHARE`] of that. Pairs also by what their impacts allow. A node is as fine as the finest of what is at it; and what
//! moves as one, follows another by a dashpot, touches it, stands outside a side where that is, or lies through the thickness of one
//! thin body with it, has one level. Neighbours differ by one level at most.

use crate::engine::viscous_share;
use crate::free_field::Leader;
use crate::levels::Levels;
use crate::member::Kind;
use crate::model::Model;
use crate::pair_masses::{PairMasses, Phases};
use crate::phase::Phase;
use crate::problem::{MOST_LEVELS, Rayleigh};
use crate::sheet::corners;
use crate::thin::join_across;
use crate::ties::Ties;
use crate::{Assembly, ModelError};
use rayon::prelude::*;

/// Steps of all levels but the finest over what an element's bound allows.
const SHARE: f64 = 0.8;

/// The levels of a model whose finest step is `dt` \[s\], `most` at most.
///
/// # Errors
/// If there is no phase in which pairs of an interface can be judged.
pub fn find_levels(
    model: &Model,
    assembly: &Assembly,
    phase: &Phase,
    dt: f64,
    most: u8,
) -> Result<Levels, ModelError> {
    // Products with K are made of one velocity of all nodes.
    let coarsest = most.min(MOST_LEVELS).saturating_sub(1);
    if coarsest == 0 || model.scheme.rayleigh.stiffness != 0.0 {
        return Ok(Levels::one());
    }
    let level = |allowed: f64| {
        let level = (allowed / dt).log2().floor();
        if level.is_nan() { 0 } else { level.clamp(0.0, f64::from(coarsest)) as u8 }
    };
    let mut node = vec![coarsest; model.mesh.nodes.len()];
    for (e, allowed) in of_elements(model, assembly, phase) {
        for &n in model.mesh.elements[e as usize].nodes() {
            node[n as usize] = node[n as usize].min(level(allowed));
        }
    }
    for ([a, b], allowed) in of_pairs(model, assembly)? {
        for n in [a, b] {
            node[n as usize] = node[n as usize].min(level(allowed));
        }
    }
    // How stiff a program's own part is nobody knows.
    let own = phase.active.iter().map(|&m| &assembly.members[m as usize]);
    for &n in own.filter(|member| member.kind == Kind::Own).flat_map(|member| member.part.nodes()) {
        node[model.mesh_node[n as usize] as usize] = 0;
    }
    Ok(settle_levels(model, phase, node))
}

/// The levels nearest to those wished for, by node of the mesh, that are no coarser and of which there are [`MOST_LEVELS`] at most:
/// what has one level has the finest wished for, and neighbours in the shaking differ by one.
pub fn settle_levels(model: &Model, phase: &Phase, wished: Vec<u8>) -> Levels {
    let class = classes(model, phase);
    let alive: Vec<u32> = model.bodies.iter().flat_map(|body| model.lasting(body)).collect();
    let mut of_class = vec![MOST_LEVELS - 1; wished.len()];
    for (&class, &wished) in class.iter().zip(&wished) {
        of_class[class as usize] = of_class[class as usize].min(wished);
    }
    loop {
        let mut same = true;
        for &e in &alive {
            let nodes = model.mesh.elements[e as usize].nodes();
            let of = |n: &u32| class[*n as usize] as usize;
            let finest = nodes.iter().map(|n| of_class[of(n)]).min().unwrap_or(0);
            for n in nodes {
                if of_class[of(n)] > finest + 1 {
                    of_class[of(n)] = finest + 1;
                    same = false;
                }
            }
        }
        if same {
            break;
        }
    }
    let node = class.iter().map(|&class| of_class[class as usize]).collect();
    Levels::given(&model.mesh, &alive, node)
}

/// The same with finer levels at these members of an assembly that has them: with one more layer of their own level where they push
/// coarser nodes, else with one that is finer.
pub fn finer_levels(model: &Model, assembly: &Assembly, phase: &Phase, members: &[u32]) -> Levels {
    let level = |n: u32| model.nodes.level[n as usize];
    let mut wished: Vec<u8> = vec![0; model.mesh.nodes.len()];
    model.mesh_node.iter().zip(&model.nodes.level).for_each(|(&n, &level)| wished[n as usize] = level);
    for member in members.iter().map(|&m| &assembly.members[m as usize]) {
        let nodes = member.part.nodes();
        let own = match nodes.iter().any(|&n| level(n) > member.level) {
            true => member.level,
            false => member.level.saturating_sub(1),
        };
        for &n in nodes {
            let wished = &mut wished[model.mesh_node[n as usize] as usize];
            *wished = own.min(*wished);
        }
    }
    settle_levels(model, phase, wished)
}

/// A step \[s\] that a model is stable with, by each of its elements alone (`irons1971`); none where parts of a program's own may ask for a shorter one.
/// The stable step is no shorter, as a rule a little longer.
pub fn sure_step(model: &Model, assembly: &Assembly, phase: &Phase) -> Option<f64> {
    if assembly.members.iter().any(|member| member.kind == Kind::Own) {
        return None;
    }
    let least =
        of_elements(model, assembly, phase).into_iter().map(|(_, dt)| dt).fold(f64::INFINITY, f64::min);
    let undamped = least / SHARE * SURE;
    // ω + ξ λmax, as the stable step has it.
    let Rayleigh { mass, stiffness } = model.scheme.rayleigh;
    Some(undamped.min(2.0 / (mass + stiffness * (2.0 / undamped).powi(2))))
}

/// Share of an element's longest step that is surely one: its frequency is found from below, within about a per cent.
const SURE: f64 = 0.95;

/// The longest step \[s\] of each element that is there in the shaking.
fn of_elements(model: &Model, assembly: &Assembly, phase: &Phase) -> Vec<(u32, f64)> {
    let mut stiffness = vec![0.0_f64; model.mesh_node.len()];
    let master = |n: u32| phase.master[n as usize] as usize;
    for &m in &phase.active {
        for &(n, k) in &assembly.members[m as usize].springs {
            stiffness[master(n)] += 2.0 * k;
        }
    }
    for base in &assembly.base {
        stiffness[master(base.node)] += base.spring[..3].iter().sum::<f64>();
    }
    let square = |n: u32| {
        let n = master(model.engine_node[n as usize]);
        if stiffness[n] > 0.0 && phase.mass[n] > 0.0 { stiffness[n] / phase.mass[n] } else { 0.0 }
    };
    let damping = 2.0 / model.scheme.rayleigh.mass;
    let of_body = |body: &crate::Body| -> Vec<(u32, f64)> {
        let alive: Vec<u32> = model.lasting(body);
        let omegas = model.frequencies(body, &alive);
        let one = |(e, omega): (u32, f64)| {
            let nodes = model.mesh.elements[e as usize].nodes();
            let springs = nodes.iter().map(|&n| square(n)).fold(0.0, f64::max);
            let stable = 2.0 / (omega * omega + springs).sqrt();
            let viscous = viscous_share(model.elements.viscosity[e as usize]);
            (e, SHARE * (viscous * stable).min(damping))
        };
        alive.into_iter().zip(omegas).map(one).collect()
    };
    model.bodies.par_iter().flat_map_iter(of_body).collect()
}

/// The longest step \[s\] of each pair that is there in the shaking, with its nodes.
fn of_pairs(model: &Model, assembly: &Assembly) -> Result<Vec<([u32; 2], f64)>, ModelError> {
    if model.seams.is_empty() {
        return Ok(Vec::new());
    }
    let masses = PairMasses::of(model, &Phases::of(model, assembly)?);
    let stiffest: Vec<f64> = assembly.contacts.iter().map(|contacts| contacts.law.stiffest()[0]).collect();
    let of = |(s, seam): (usize, &crate::Seam)| {
        let squares = masses.squares(s, |other| stiffest[other]);
        let one = |k: usize| (seam.pairs[k].nodes, seam.limit / squares[k].sqrt());
        seam.lasting().map(one).collect::<Vec<_>>()
    };
    Ok(model.seams.iter().enumerate().flat_map(of).collect())
}

/// Node of the mesh → the first of those that have one level with it.
fn classes(model: &Model, phase: &Phase) -> Vec<u32> {
    let mut classes = Ties::new(model.mesh.nodes.len());
    let mesh = |n: u32| model.mesh_node[n as usize];
    for &(node, master) in &phase.tied {
        classes.join(mesh(node), mesh(master));
    }
    for (node, dashpot) in &phase.dashpots {
        for follow in &dashpot.follows {
            if let Leader::Node(leader) = follow.leader {
                classes.join(mesh(*node), mesh(leader));
            }
        }
    }
    for [a, b] in model.seams.iter().flat_map(|seam| &seam.pairs).map(|pair| pair.nodes) {
        classes.join(a, b);
    }
    for &twin in model.outside.sheets().flat_map(|sheet| &sheet.twins) {
        for corner in corners(&model.mesh, twin) {
            classes.join(corner.source, corner.front);
            classes.join(corner.source, corner.back);
        }
    }
    join_across(model, &mut classes);
    classes.roots()
}
