//! Whether levels of steps are stable together, tried before a run.
//!
//! Each element's own bound says nothing of a border: what acts there is a product of several steps, and no bound of its is known. So
//! the surroundings of all borders are tried by themselves: the parts that push a drifting node and those beside them, with their elastic
//! stiffness, pairs at their stiffest, and artificial viscosity, without dashpots, and with their own masses alone. Their nodes begin
//! with noise. What is stable keeps the noise where it is or spreads it; what is not gathers it, so energies are watched part by part.

use super::gather::force;
use super::power::noise;
use crate::assembly::Assembly;
use crate::member::Member;
use crate::model::Model;
use crate::parts::Scratch;
use crate::phase::Phase;
use crate::phase::beats::span;
use rayon::prelude::*;
use tremolite_laws::Row;

/// Steps of the coarsest level that are tried, and after how many of them energies are looked at.
pub const TRIED: u32 = 512;
const LOOKS: u64 = 32;
/// Kinetic energy of a part's nodes over the largest of any at the start from which on it counts as grown. What is stable may gather
/// some of its neighbours' at light nodes.
const GROWN: f64 = 30.0;

/// Nodes that a thread works on at a time. Those of a level are numbered together, so most have one.
const CHUNK: usize = 256;

/// How a node moves.
#[derive(Clone, Copy)]
struct Push {
    /// Its level; beyond all others where it does not move.
    level: u8,
    /// The finest of the members that read it: it goes on when they do.
    read: u8,
    /// What a force adds to its increment a finest step.
    of_force: [f64; 3],
}

const STILL: Push = Push { level: u8::MAX, read: u8::MAX, of_force: [0.0; 3] };

/// Members around borders where energy grew, by their numbers; the sooner the earlier.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Proof {
    pub grown: Vec<u32>,
    /// Members that were tried.
    pub tried: usize,
}

impl Proof {
    /// Growth of a motion in a step of the coarsest level that is seen for certain where it begins with a hundredth of a part's energy.
    pub fn smallest_growth() -> f64 {
        (100.0 * GROWN).powf(0.5 / f64::from(TRIED)) - 1.0
    }
}

/// Tries the surroundings of all borders of a phase with steps of `dt` \[s\] on the finest level.
pub fn prove(model: &Model, assembly: &Assembly, phase: &Phase, dt: f64) -> Proof {
    let tried = surroundings(assembly, phase);
    if tried.is_empty() {
        return Proof::default();
    }
    let master = |n: u32| phase.master[n as usize] as usize;
    let mut mass = vec![0.0; model.mesh_node.len()];
    for Member { part, masses, .. } in tried.iter().map(|&m| &assembly.members[m as usize]) {
        part.nodes().iter().zip(masses).for_each(|(&n, m)| mass[master(n)] += m);
    }
    let moves: Vec<usize> = (0..mass.len()).filter(|&n| mass[n] > 0.0).collect();
    let mut u = vec![Row::ZERO; mass.len()];
    let mut du = vec![Row::ZERO; mass.len()];
    // As much in each node's own velocity as its mass leaves of one energy.
    for &n in &moves {
        let random = noise(model.mesh_node[n], &phase.inverse_mass[n]);
        du[n] = Row(random.0.map(|x| x * dt / mass[n].sqrt()));
    }
    // What is tied to nodes that do not move stays with them: of a long periodic side nearly all.
    let tied: Vec<(u32, u32)> =
        phase.tied.iter().copied().filter(|(_, of)| mass[master(*of)] > 0.0).collect();
    let follow = |rows: &mut [Row]| {
        tied.iter().for_each(|&(node, of)| rows[node as usize] = rows[of as usize]);
    };
    follow(&mut du);
    let energy = |du: &[Row], m: u32| -> f64 {
        let nodes = assembly.members[m as usize].part.nodes();
        let square = |n: usize| du[n].0.iter().map(|d| d * d).sum::<f64>();
        let all: f64 = nodes.iter().map(|&n| mass[master(n)] * square(master(n))).sum();
        all / nodes.len() as f64
    };
    let solid: Vec<u32> =
        tried.iter().copied().filter(|&m| assembly.members[m as usize].part.elements().0 > 0).collect();
    let most = solid.iter().map(|&m| energy(&du, m)).fold(0.0, f64::max);
    let mut contributions = vec![Row::ZERO; assembly.totals().contributions.end];
    let (coarsest, inverse_dt) = (phase.beats.len() as u8 - 1, 1.0 / dt);
    // Members that have their own times where levels up to each have.
    let due = (0..=coarsest).map(|beat| {
        let members = tried.iter().copied();
        members.filter(|&m| assembly.members[m as usize].level <= beat).collect()
    });
    let due: Vec<Vec<u32>> = due.collect();
    let mut push = vec![STILL; mass.len()];
    for &n in &moves {
        let level = model.nodes.level[n];
        let of_force = [0, 1, 2].map(|i| match phase.inverse_mass[n].0[i] == 0.0 {
            true => 0.0,
            false => span(level) as f64 * dt * dt / mass[n],
        });
        push[n] = Push { level, read: level, of_force };
    }
    for Member { part, level, reads, .. } in tried.iter().map(|&m| &assembly.members[m as usize]) {
        let nodes = part.nodes().iter().chain(&reads.nodes);
        nodes.for_each(|&n| push[master(n)].read = push[master(n)].read.min(*level));
    }
    let finest: Vec<u8> =
        push.chunks(CHUNK).map(|all| all.iter().map(|push| push.read).min().unwrap_or(u8::MAX)).collect();
    // Viscosity acts at v⁻, which is the same in all steps of the finest level that are in one of a node's own.
    let mut w: Vec<Row> = du.iter().map(|du| Row(du.0.map(|d| d * inverse_dt))).collect();
    let mut grown = Vec::new();
    for step in 0..u64::from(TRIED) << coarsest {
        let beat = step.trailing_zeros().min(u32::from(coarsest)) as u8;
        let members = &due[usize::from(beat)];
        let mut rest = &mut contributions[..];
        let mut at = 0;
        let mut jobs = Vec::with_capacity(members.len());
        for &m in members {
            let range = assembly.slices[m as usize].contributions.clone();
            let (before, after) = std::mem::take(&mut rest).split_at_mut(range.end - at);
            jobs.push((m, &mut before[range.start - at..]));
            (rest, at) = (after, range.end);
        }
        jobs.into_par_iter().for_each_init(
            || (Scratch::default(), Vec::new()),
            |(scratch, viscous), (m, own)| {
                let part = &assembly.members[m as usize].part;
                part.stiffness_times(&u, own, scratch);
                viscous.clear();
                viscous.resize(own.len(), Row::ZERO);
                if part.viscosity_times(&w, viscous, scratch) {
                    for (own, more) in own.iter_mut().zip(viscous.iter()) {
                        (0..3).for_each(|i| own.0[i] += more.0[i]);
                    }
                }
            },
        );
        let rows = u.par_chunks_mut(CHUNK).zip(du.par_chunks_mut(CHUNK)).zip(w.par_chunks_mut(CHUNK));
        let rows = rows.zip(push.par_chunks(CHUNK)).zip(&finest).enumerate();
        rows.filter(|(_, (_, finest))| **finest <= beat).for_each(|(chunk, ((((u, du), w), push), _))| {
            for (k, (((u, du), w), push)) in u.iter_mut().zip(du).zip(w).zip(push).enumerate() {
                if push.read > beat {
                    continue;
                }
                if push.level <= beat {
                    let force = force(phase, &contributions, chunk * CHUNK + k);
                    (0..3).for_each(|i| du.0[i] -= push.of_force[i] * force.0[i]);
                    *w = Row(du.0.map(|d| d * inverse_dt));
                }
                let steps = span(push.read) as f64;
                (0..3).for_each(|i| u.0[i] += steps * du.0[i]);
            }
        });
        follow(&mut u);
        follow(&mut du);
        follow(&mut w);
        if (step + 1).is_multiple_of(LOOKS << coarsest) {
            // What is not a number has grown as well.
            let kept = |m: &u32| energy(&du, *m) <= GROWN * most;
            grown = solid.iter().copied().filter(|m| !kept(m)).collect();
            if !grown.is_empty() {
                break;
            }
        }
    }
    Proof { grown, tried: tried.len() }
}

/// Members that push a drifting node, and those that share a node with them, ascending.
fn surroundings(assembly: &Assembly, phase: &Phase) -> Vec<u32> {
    let mut near = vec![false; phase.master.len()];
    phase.borders.iter().for_each(|border| near[phase.master[border.node as usize] as usize] = true);
    let mut all = Vec::new();
    for _ in 0..2 {
        let touches = |m: &u32| {
            let nodes = assembly.members[*m as usize].part.nodes();
            nodes.iter().any(|&n| near[phase.master[n as usize] as usize])
        };
        all = phase.active.iter().copied().filter(touches).collect();
        for &m in &all {
            let nodes = assembly.members[m as usize].part.nodes();
            nodes.iter().for_each(|&n| near[phase.master[n as usize] as usize] = true);
        }
    }
    all
}
