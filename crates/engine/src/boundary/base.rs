//! The free field pushes at a boundary, and springs act on what differs from it.
//!
//! Traction on the model = σ_ff·n + C (v_ff − v) − K (u − u_ff), at a base into which a wave rises 2ρc v_i − ρc v − (αG/R)(u − u_ff)
//! (`lysmer1969` for the dashpots, `wang2018` for the springs). The dashpots act on velocity and belong to the step
//! ([`crate::engine`]); this part gives the other terms, of which the [free field](crate::free_field) says what bears its index.

use super::at_points::AtPoints;
use super::matrix::times;
use crate::free_field::{FreeField, Now, Place, Pushes, Spot};
use crate::parts::{Kept, Motion, Own, Part, Reads, Scratch, StateSizes, Tick};
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

    /// u − u_ff \[m\]; `given` is u_ff of a given field here.
    fn scattered(&self, now: &Now, given: [f64; 3], u: &[Row]) -> [f64; 3] {
        now.scattered(&self.place, u[self.node as usize].xyz(), given, u)
    }
}

/// Push of the free field, and springs.
pub struct BasePart {
    nodes: Vec<u32>,
    pushed: Vec<BaseNode>,
    free_field: FreeField,
    /// Where springs are, in the order of their nodes.
    sprung: Vec<Spot>,
    /// Of a given free field.
    pushes: Option<Box<dyn Pushes>>,
}

impl BasePart {
    pub fn new(mut pushed: Vec<BaseNode>, free_field: FreeField) -> Self {
        let spot = |at| match &free_field {
            FreeField::Given(field) => field.spot(at),
            FreeField::Beside(_) => Spot::anywhere(at),
        };
        let pushes = match &free_field {
            FreeField::Given(field) => {
                let places: Vec<&Place> = pushed.iter().map(|base| &base.place).collect();
                let own = field.pushes(&places);
                Some(own.unwrap_or_else(|| Box::new(AtPoints::new(field.clone(), &places))))
            }
            FreeField::Beside(_) => None,
        };
        let sprung = pushed.iter().filter(|base| base.is_sprung()).map(|base| spot(base.place.at)).collect();
        for base in &mut pushed {
            (base.place.shares, base.place.ends) = (Vec::new(), Vec::new());
        }
        let nodes = pushed.iter().map(|b| b.node).collect();
        BasePart { nodes, pushed, free_field, sprung, pushes }
    }

    /// What the free field pushes each node with, beside what its dashpots follow \[N\].
    fn pushed(&self, now: &Now) -> Vec<[f64; 3]> {
        let mut out = vec![[0.0; 3]; self.pushed.len()];
        match (now, &self.pushes) {
            (Now::Given(_, time), Some(pushes)) => pushes.forces(*time, &mut out),
            (Now::Given(..), None) => {}
            // 2 C v_i.
            (Now::Rising(velocity), _) => {
                let twice = velocity.map(|v| 2.0 * v);
                let pairs = out.iter_mut().zip(&self.pushed);
                pairs.for_each(|(out, base)| *out = times(&base.dashpot, twice));
            }
        }
        out
    }
}

/// Numbers remembered per node: the last u − u_ff, and the last push as it resists.
const REMEMBERED: usize = 6;

impl Part for BasePart {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    fn bytes(&self) -> usize {
        let BasePart { nodes, pushed, sprung, pushes, .. } = self;
        let pushes = pushes.as_ref().map_or(0, |pushes| pushes.bytes());
        size_of_val(&nodes[..]) + size_of_val(&pushed[..]) + size_of_val(&sprung[..]) + pushes
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
        let pushed = self.pushed(&now);
        let mut given = now.displacements(&self.sprung).into_iter();
        let last = own.numbers.chunks_exact_mut(REMEMBERED);
        for (((base, push), out), last) in self.pushed.iter().zip(pushed).zip(out).zip(last) {
            let du = x.increment(base.node).xyz();
            let push = push.map(|f| -f);
            let mut spring = [0.0; 3];
            if base.is_sprung() {
                let scattered = base.scattered(&now, given.next().unwrap_or_default(), x.u);
                spring = times(&base.spring, scattered);
                let before = times(&base.spring, [last[0], last[1], last[2]]);
                for i in 0..3 {
                    work[Line::Springs] += 0.5 * (spring[i] + before[i]) * du[i];
                    last[i] = scattered[i];
                }
            }
            for i in 0..3 {
                work[pushes] += 0.5 * (push[i] + last[3 + i]) * du[i];
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
