//! Products with the stiffness.

use super::gather::force;
use crate::assembly::Assembly;
use crate::parts::{Kept, Scratch};
use crate::phase::Phase;
use crate::ranks::Ranks;
use rayon::prelude::*;
use tremolite_laws::Row;

/// What is multiplied with a motion.
#[derive(Clone, Copy)]
pub enum Product<'s> {
    /// The elastic stiffness K.
    Stiffness,
    /// K + s C, with C the artificial viscosity of undamaged elements and s \[1/s\].
    Viscous(f64),
    /// The stiffness of elements that damage has left at displacements \[m\] and with what parts remember, for ξK.
    Damping(&'s [Row], Kept<'s>),
}

/// The product by engine node of all active parts, added up in the order of parts; a tied node's share is its master's. On a rank, of
/// the nodes that it moves.
pub fn times(
    assembly: &Assembly,
    phase: &Phase,
    product: Product,
    w: &[Row],
    contributions: &mut [Row],
    out: &mut [Row],
    ranks: Option<&Ranks>,
) {
    let mut rest = &mut *contributions;
    let mut jobs: Vec<(u32, &mut [Row])> = Vec::with_capacity(phase.active.len());
    let mut active = phase.members().iter().copied().peekable();
    for (m, member) in (0u32..).zip(&assembly.members) {
        let held = if assembly.has(m as usize) { member.part.nodes().len() } else { 0 };
        let (own, after) = std::mem::take(&mut rest).split_at_mut(held);
        rest = after;
        if active.next_if_eq(&m).is_some() {
            jobs.push((m, own));
        }
    }
    jobs.into_par_iter().for_each_init(Scratch::default, |scratch, (m, own)| {
        let part = &assembly.members[m as usize].part;
        match product {
            Product::Stiffness => part.stiffness_times(w, own, scratch),
            Product::Viscous(share) => {
                let mut viscous = vec![Row::ZERO; own.len()];
                part.stiffness_times(w, own, scratch);
                if part.viscosity_times(w, &mut viscous, scratch) {
                    for (own, more) in own.iter_mut().zip(&viscous) {
                        for i in 0..3 {
                            own.0[i] += share * more.0[i];
                        }
                    }
                }
            }
            Product::Damping(u, kept) => {
                part.damping_times(u, assembly.held[m as usize].kept(&kept), w, own, scratch);
            }
        }
    });
    // With ξ, which alone asks for this on several ranks, all have one level.
    if let Some((ranks, ours)) = ranks.zip(phase.ours.as_ref()) {
        for slots in &ours.halos {
            ranks.start(slots, contributions);
            ranks.finish(slots, contributions);
        }
    }
    let contributions = &*contributions;
    out.par_iter_mut().enumerate().for_each(|(node, out)| {
        if phase.holds(node as u32) {
            *out = force(phase, contributions, node);
        }
    });
}
