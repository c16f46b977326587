//! The free field pushes at a boundary, and springs act on what differs from it.
//!
//! Traction on the model = σ_ff·n + C (v_ff − v) − K (u − u_ff), at a base into which a wave rises 2ρc v_i − ρc v − (αG/R)(u − u_ff)
//! (`lysmer1969` for the dashpots, `wang2018` for the springs). The dashpots act on velocity and belong to the step
//! ([`crate::engine`]); this part gives the other terms, of which the [free field](crate::free_field) says what bears its index.

use super::matrix::times;
use crate::free_field::{FreeField, Now, Place};
use crate::parts::{Kept, Motion, Own, Part, Reads, Scratch, StateSizes, Tick};
use std::collections::BTreeMap;
use tremolite_kernels::{Line, Lines};
use tremolite_laws::Row;

/// What one node of the base carries; where the free field is [given](FreeField::Given), of free-field sides and a viscous top too.
#[derive(Clone, Debug)]
pub struct BaseNode {
    pub node: u32,
    /// Dashpot matrix Σ ρ A (c_s I + (c_p − c_s) n⊗n) \[N s/m\]: xx, yy, zz, xy, yz, zx.
    pub dashpot: [f64; 6],
    /// Spring matrix of the same form from α G A / R \[N/m\]; zero without springs.
    pub spring: [f64; 6],
    /// Where it asks for the free field.
    pub place: Place,
    /// Whether it is the user's and not a slab's or column's, whose work is in no balance.
    pub counted: bool,
}

impl BaseNode {
    /// Whether springs hold it: nothing else asks where it is beside the free field.
    fn is_sprung(&self) -> bool {
        self.spring != [0.0; 6]
    }

    /// u − u_ff \[m\].
    fn scattered(&self, now: &Now, u: &[Row]) -> [f64; 3] {
        now.scattered(&self.place, u[self.node as usize].xyz(), u)
    }
}

/// Push of the free field, and springs.
pub struct BasePart {
    nodes: Vec<u32>,
    pushed: Vec<BaseNode>,
    free_field: FreeField,
    /// The points of all faces with their normals, each once though up to four nodes share it, and by node which are its own, with N dA
    /// \[m²\].
    points: Vec<[[f64; 3]; 2]>,
    of_node: Vec<Vec<(u32, f64)>>,
}

impl BasePart {
    pub fn new(pushed: Vec<BaseNode>, free_field: FreeField) -> Self {
        let (mut points, mut known) = (Vec::new(), BTreeMap::new());
        let mut share = |&(at, area): &([f64; 3], [f64; 3])| -> (u32, f64) {
            let size = area.iter().map(|x| x * x).sum::<f64>().sqrt();
            // A point lies inside one face.
            let number = *known.entry(at.map(f64::to_bits)).or_insert_with(|| {
                points.push([at, area.map(|x| x / size)]);
                points.len() as u32 - 1
            });
            (number, size)
        };
        let of_node = pushed.iter().map(|base| base.place.shares.iter().map(&mut share).collect()).collect();
        let nodes = pushed.iter().map(|b| b.node).collect();
        BasePart { nodes, pushed, free_field, points, of_node }
    }
}

/// Numbers remembered per node: the last u − u_ff, and the last push as it resists.
const REMEMBERED: usize = 6;

impl Part for BasePart {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    fn bytes(&self) -> usize {
        let BasePart { nodes, pushed, points, of_node, .. } = self;
        let shares: usize = of_node.iter().map(|own| size_of_val(&own[..])).sum();
        size_of_val(&nodes[..]) + size_of_val(&pushed[..]) + size_of_val(&points[..]) + shares
    }

    /// The bottoms of the columns whose motion is the free field, from which springs count.
    fn reads(&self) -> Reads {
        let sprung = self.pushed.iter().filter(|base| base.is_sprung());
        let mut nodes: Vec<u32> =
            sprung.flat_map(|base| &base.place.bottoms).map(|(node, _)| *node).collect();
        nodes.sort_unstable();
        nodes.dedup();
        Reads { nodes, ..Reads::default() }
    }

    fn state_sizes(&self) -> StateSizes {
        StateSizes { numbers: REMEMBERED * self.pushed.len(), ..StateSizes::default() }
    }

    fn forces(&self, tick: &Tick, x: &Motion, own: Own, out: &mut [Row], _: &mut Scratch) -> Lines {
        let now = self.free_field.now(tick.time);
        let pushes = self.free_field.line();
        let mut work = Lines::default();
        let tractions = now.tractions(&self.points);
        let last = own.numbers.chunks_exact_mut(REMEMBERED);
        for (((base, points), out), last) in self.pushed.iter().zip(&self.of_node).zip(out).zip(last) {
            let du = x.increment(base.node).xyz();
            let scattered = if base.is_sprung() { base.scattered(&now, x.u) } else { [0.0; 3] };
            let spring = times(&base.spring, scattered);
            let before = times(&base.spring, [last[0], last[1], last[2]]);
            let push = now
                .push(&base.dashpot, points.iter().map(|&(k, area)| (tractions[k as usize], area)))
                .map(|f| -f);
            for i in 0..3 {
                work[Line::Springs] += 0.5 * (spring[i] + before[i]) * du[i];
                work[pushes] += 0.5 * (push[i] + last[3 + i]) * du[i];
                last[i] = scattered[i];
                last[3 + i] = push[i];
                out.0[i] = spring[i] + push[i];
            }
        }
        work
    }

    /// ½(u − u_ff)·K(u − u_ff).
    fn energy(&self, _: &Motion, kept: Kept) -> Lines {
        let mut held = Lines::default();
        for (base, last) in self.pushed.iter().zip(kept.numbers.chunks_exact(REMEMBERED)) {
            let d = [last[0], last[1], last[2]];
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
