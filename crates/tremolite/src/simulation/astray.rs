//! What ends a run although its energy balances: motion and closure for which neither method nor laws are made.

use crate::places;
use rayon::prelude::*;
use std::ops::Range;
use tremolite_engine::assembly::Assembly;
use tremolite_engine::exchange::To;
use tremolite_engine::model::Model;
use tremolite_engine::phase::Phase;
use tremolite_engine::ranks::Ranks;
use tremolite_engine::state::State;
use tremolite_laws::Row;
use tremolite_results::{Said, said};

/// What is known of it once the earthquake begins.
pub(super) struct Limits {
    /// The longest edge of the box around the model \[m\].
    length: f64,
    /// No node whose displacement is shorter \[m\] has moved by that length since the earthquake began.
    reach: f64,
}

impl Limits {
    pub fn new(model: &Model, ranks: Option<&Ranks>, state: &State) -> Self {
        let (low, high) = model.mesh.bounds();
        let length = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
        let before = |n: usize| state.datum.get(n).map_or(0.0, |row| square(row).sqrt());
        let most = own_blocks(model, ranks).map(|nodes| nodes.map(before).fold(0.0, f64::max));
        Limits { length, reach: (length - most.reduce(|| 0.0, f64::max)).max(0.0) }
    }

    /// Why a simulation whose state is finite cannot go on from it, with the element or pair; none if it can. A node has moved further, since the
    /// earthquake began, than the whole model is long, beside displacements that are to be small; or a joint has closed by more than the largest
    /// closure of its law, where that goes on as a straight line which nobody measured.
    ///
    /// Of several ranks each looks at the nodes that it adds up and at the pairs that it evaluates; where one finds something, all are told the
    /// same. A state of which something moved too far is [made whole](Ranks::whole) by it.
    pub fn astray(
        &self,
        (model, assembly, phase): (&Model, &Assembly, &Phase),
        ranks: Option<&Ranks>,
        state: &mut State,
    ) -> Option<Said> {
        let closed = closed_beyond(model, assembly, state);
        let found = u64::from(self.has_left(model, phase, ranks, state)) | u64::from(closed.is_some()) << 1;
        match ranks.map_or(found, |ranks| ranks.agree(found)) {
            0 => None,
            2 => Some(closure(model, ranks.map_or(closed, |ranks| first_of_all(ranks, closed))?)),
            _ => {
                if let Some(ranks) = ranks {
                    ranks.whole(model, state, To::All);
                }
                Some(self.furthest(model, phase, state))
            }
        }
    }

    /// Whether a node that this process adds up has moved further than the model is long. What does not stand has no motion of its own.
    fn has_left(&self, model: &Model, phase: &Phase, ranks: Option<&Ranks>, state: &State) -> bool {
        let near = self.reach * self.reach;
        let far = |n: usize| square(&state.u[n]) > near && moved(state, n) > self.length;
        own_blocks(model, ranks).any(|mut nodes| nodes.any(|n| far(n) && phase.mass[n] > 0.0))
    }

    /// The node that has moved furthest, of a state that is whole, by the first element that has it; by its own number where none does.
    fn furthest(&self, model: &Model, phase: &Phase, state: &State) -> Said {
        let far = |n: usize| if phase.mass[n] > 0.0 { moved(state, n) } else { 0.0 };
        let (by, node) =
            (0..state.u.len()).map(|n| (far(n), n)).fold((0.0, 0), |a, b| if b.0 > a.0 { b } else { a });
        let has = |&e: &usize| {
            let corners = model.mesh.elements[e].nodes().iter();
            model.stands(e, phase.stage)
                && corners.map(|&c| model.engine_node[c as usize] as usize).any(|n| n == node)
        };
        let (by, most) = (format!("{by:.3e}"), format!("{most:.3e}", most = self.length));
        let element = (0..model.mesh.elements.len()).find(has);
        let place = match element {
            Some(element) => places::element_at(model, element as u32),
            None => said!(
                "node {number}",
                number = model.mesh.node_id(model.mesh_node[node] as usize).to_string()
            ),
        };
        if element.is_some_and(|element| element >= model.user.elements) {
            return said!(
                "{place} has moved by {far} m, further than the model is long, {most} m; it is ground outside the model's sides, so its steps are unstable: run with dynamic.levels = 1",
                place = place,
                far = by,
                most = most,
            );
        }
        said!(
            "{place} has moved by {far} m, further than the model is long, {most} m: it is loose, or the record carries the model off (correct its baseline)",
            place = place,
            far = by,
            most = most,
        )
    }
}

/// The nodes that this process adds up.
fn own_blocks<'a>(
    model: &'a Model,
    ranks: Option<&'a Ranks>,
) -> impl ParallelIterator<Item = Range<usize>> + 'a {
    let own = move |b: usize| ranks.is_none_or(|ranks| ranks.division.of_block[b] == ranks.rank());
    model
        .nodes
        .blocks
        .par_iter()
        .enumerate()
        .filter(move |(b, _)| own(*b))
        .map(|(_, block)| block.nodes.clone())
}

fn square(row: &Row) -> f64 {
    row.xyz().iter().map(|x| x * x).sum()
}

/// How far \[m\] a node has moved since the earthquake began.
fn moved(state: &State, n: usize) -> f64 {
    let from = state.datum.get(n).map_or([0.0; 3], |row| row.xyz());
    let u = state.u[n].xyz();
    (0..3).map(|k| (u[k] - from[k]).powi(2)).sum::<f64>().sqrt()
}

/// A pair that has closed by more than its law knows.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Closed {
    seam: usize,
    pair: usize,
    /// m
    by: f64,
    /// Pa
    pressure: f64,
    /// m
    limit: f64,
}

/// The first that this process has.
fn closed_beyond(model: &Model, assembly: &Assembly, state: &State) -> Option<Closed> {
    model.seams.iter().zip(&assembly.contacts).enumerate().find_map(|(seam, (of, contacts))| {
        let limit = contacts.law.closure_limit()?;
        let (pair, seen) = contacts.first_below(of, &state.history, -limit)?;
        Some(Closed { seam, pair, by: -seen.gap, pressure: seen.pressure, limit })
    })
}

/// The first that any rank has, for all.
fn first_of_all(ranks: &Ranks, own: Option<Closed>) -> Option<Closed> {
    let all = |of: fn(Closed) -> f64| ranks.each(own.map_or(f64::INFINITY, of));
    let (seams, pairs) = (all(|one| one.seam as f64), all(|one| one.pair as f64));
    let (by, pressures, limits) = (all(|one| one.by), all(|one| one.pressure), all(|one| one.limit));
    let found = (0..seams.len()).filter(|&k| seams[k].is_finite());
    let first = found.min_by_key(|&k| (seams[k] as usize, pairs[k] as usize))?;
    let (seam, pair) = (seams[first] as usize, pairs[first] as usize);
    Some(Closed { seam, pair, by: by[first], pressure: pressures[first], limit: limits[first] })
}

fn closure(model: &Model, Closed { seam, pair, by, pressure, limit }: Closed) -> Said {
    said!(
        "{pair} has closed by {closure} m under {pressure} Pa, beyond the largest closure of its law, {limit} m: give a larger max_closure, or a stiffer joint",
        pair = places::pair(&model.mesh, &model.seams[seam], pair),
        closure = format!("{by:.3e}"),
        pressure = format!("{pressure:.3e}"),
        limit = format!("{limit:.3e}"),
    )
}
