//! The base: a wave comes in, springs act on the scattered field.
//!
//! Traction on the model = 2ρc v_i − ρc v − (αG/R)(u − u_ff), with the incident velocity v_i and the free field u_ff
//! (`lysmer1969` for the dashpots, `wang2018` for the springs). The dashpots act on velocity and belong to the step
//! ([`crate::engine`]); this part gives the other two terms. Vertical incidence in homogeneous ground below the base.

use crate::parts::{Kept, Motion, Own, Part, Reads, Scratch, StateSizes, Tick};
use std::sync::Arc;
use tremolite_kernels::{Line, Lines};
use tremolite_laws::Row;
use tremolite_motion::Motion as Record;

/// What one node of the base carries.
#[derive(Clone, Debug)]
pub struct BaseNode {
    pub node: u32,
    /// Dashpot matrix Σ ρ A (c_s I + (c_p − c_s) n⊗n) \[N s/m\]: xx, yy, zz, xy, yz, zx.
    pub dashpot: [f64; 6],
    /// Spring matrix of the same form from α G A / R \[N/m\]; zero without springs.
    pub spring: [f64; 6],
    /// Bottoms of columns with their weights in the free field at this place; none where no springs act.
    pub free_field: Vec<(u32, f64)>,
    /// Whether it is the user's and not a slab's or column's, whose work is in no balance.
    pub counted: bool,
}

impl BaseNode {
    /// u − u_ff \[m\].
    fn scattered(&self, u: &[Row]) -> [f64; 3] {
        let mut scattered = u[self.node as usize].xyz();
        for &(node, weight) in &self.free_field {
            let free = u[node as usize].xyz();
            (0..3).for_each(|i| scattered[i] -= weight * free[i]);
        }
        scattered
    }
}

/// Product of a symmetric 3×3 matrix (xx, yy, zz, xy, yz, zx) and a vector.
pub fn times(m: &[f64; 6], v: [f64; 3]) -> [f64; 3] {
    [
        m[0] * v[0] + m[3] * v[1] + m[5] * v[2],
        m[3] * v[0] + m[1] * v[1] + m[4] * v[2],
        m[5] * v[0] + m[4] * v[1] + m[2] * v[2],
    ]
}

/// Adds one such matrix to another.
pub fn add(to: &mut [f64; 6], more: &[f64; 6]) {
    for (a, b) in to.iter_mut().zip(more) {
        *a += b;
    }
}

/// Incident wave and springs of the base.
pub struct BasePart {
    nodes: Vec<u32>,
    pushed: Vec<BaseNode>,
    /// Velocity of the up-going wave, already factored for the kind of motion; none for a base at rest.
    incident: Option<(Arc<Record>, f64)>,
}

impl BasePart {
    /// The part; `incident` is a record and the factor from its kind of motion to the up-going wave.
    pub fn new(pushed: Vec<BaseNode>, incident: Option<(Arc<Record>, f64)>) -> Self {
        BasePart { nodes: pushed.iter().map(|b| b.node).collect(), pushed, incident }
    }
}

/// Numbers remembered per node: the last spring force and the last incident force.
const REMEMBERED: usize = 6;

impl Part for BasePart {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    /// The bottoms of the columns whose motion is the free field.
    fn reads(&self) -> Reads {
        let mut nodes: Vec<u32> =
            self.pushed.iter().flat_map(|base| &base.free_field).map(|(node, _)| *node).collect();
        nodes.sort_unstable();
        nodes.dedup();
        Reads { nodes, ..Reads::default() }
    }

    fn state_sizes(&self) -> StateSizes {
        StateSizes { numbers: REMEMBERED * self.pushed.len(), ..StateSizes::default() }
    }

    fn forces(&self, tick: &Tick, x: &Motion, own: Own, out: &mut [Row], _: &mut Scratch) -> Lines {
        let velocity = match &self.incident {
            Some((record, factor)) => record.at(tick.time).v.map(|v| v * factor),
            None => [0.0; 3],
        };
        let mut work = Lines::default();
        let last = own.numbers.chunks_exact_mut(REMEMBERED);
        for ((base, out), last) in self.pushed.iter().zip(out).zip(last) {
            let du = x.du[base.node as usize].xyz();
            let spring = times(&base.spring, base.scattered(x.u));
            let incident = times(&base.dashpot, velocity.map(|v| -2.0 * v));
            for i in 0..3 {
                work[Line::Springs] += 0.5 * (spring[i] + last[i]) * du[i];
                work[Line::Input] += 0.5 * (incident[i] + last[3 + i]) * du[i];
                last[i] = spring[i];
                last[3 + i] = incident[i];
                out.0[i] = spring[i] + incident[i];
            }
        }
        work
    }

    /// ½(u − u_ff)·K(u − u_ff).
    fn energy(&self, x: &Motion, _: Kept) -> Lines {
        let mut held = Lines::default();
        for base in &self.pushed {
            let d = base.scattered(x.u);
            let force = times(&base.spring, d);
            held[Line::Springs] += 0.5 * (force[0] * d[0] + force[1] * d[1] + force[2] * d[2]);
        }
        held
    }

    fn stiffness_times(&self, w: &[Row], out: &mut [Row], _: &mut Scratch) {
        for (base, out) in self.pushed.iter().zip(out) {
            *out = Row::new(times(&base.spring, w[base.node as usize].xyz()));
        }
    }
}
