//! Contributions of parts to the force of a node.

use crate::phase::Phase;
use crate::soon::soon;
use tremolite_laws::Row;

/// Sum of a node's contributions, in the order of parts.
#[inline(always)]
pub(super) fn force(phase: &Phase, contributions: &[Row], node: usize) -> Row {
    let mut sum = Row::ZERO;
    for &slot in &phase.slot[phase.start[node] as usize..phase.start[node + 1] as usize] {
        let row = &contributions[slot as usize];
        for i in 0..4 {
            sum.0[i] += row.0[i];
        }
    }
    sum
}

/// So many nodes before they are summed contributions are asked for: by then they have come from the third cache level, and so few nodes'
/// contributions fit the first.
const AHEAD: usize = 8;

/// Asks for the contributions of a node some nodes on, which lie wherever their parts have left them. It changes no number.
#[inline(always)]
pub(super) fn expect(phase: &Phase, contributions: &[Row], node: usize) {
    if let Some(&[start, end]) = phase.start.get(node + AHEAD..node + AHEAD + 2) {
        phase.slot[start as usize..end as usize].iter().for_each(|&slot| soon(contributions, slot as usize));
    }
}

/// What is left of a node's force where some of it is held.
#[inline(always)]
pub(super) fn net(held: &[Row], node: usize, force: Row) -> Row {
    let Some(held) = held.get(node) else { return force };
    Row([0, 1, 2, 3].map(|i| force.0[i] - held.0[i]))
}

/// a·b of two rows.
#[inline(always)]
pub(super) fn dot(a: Row, b: Row) -> f64 {
    a.0[0] * b.0[0] + a.0[1] * b.0[1] + a.0[2] * b.0[2]
}
