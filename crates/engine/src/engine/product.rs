//! Products with the stiffness.

use super::gather::force;
use crate::assembly::Assembly;
use crate::parts::Scratch;
use crate::phase::Phase;
use crate::state::State;
use rayon::prelude::*;
use tremolite_laws::Row;

/// K w of all active parts by engine node, added up in the order of parts; a tied node's share is its master's. Without a
/// state the stiffness is elastic, with one it is what damage has left.
pub fn stiffness_times(
    assembly: &Assembly,
    phase: &Phase,
    state: Option<&State>,
    w: &[Row],
    contributions: &mut [Row],
    out: &mut [Row],
) {
    let mut rest = &mut *contributions;
    let mut jobs: Vec<(u32, &mut [Row])> = Vec::with_capacity(phase.active.len());
    let mut active = phase.active.iter().copied().peekable();
    for (m, member) in (0u32..).zip(&assembly.members) {
        let (own, after) = std::mem::take(&mut rest).split_at_mut(member.part.nodes().len());
        rest = after;
        if active.next_if_eq(&m).is_some() {
            jobs.push((m, own));
        }
    }
    jobs.into_par_iter().for_each_init(Scratch::default, |scratch, (m, own)| {
        let part = &assembly.members[m as usize].part;
        match state {
            Some(state) => {
                let history = &state.history[assembly.slices[m as usize].history.clone()];
                part.damping_times(&state.u, history, w, own, scratch);
            }
            None => part.stiffness_times(w, own, scratch),
        }
    });
    let contributions = &*contributions;
    out.par_iter_mut().enumerate().for_each(|(node, out)| *out = force(phase, contributions, node));
}
