//! The free field pushes at a boundary, and springs act on what differs from it.
//!
//! Traction on the model = σ_ff·n + C (v_ff − v) − K (u − u_ff), at a base into which a wave rises 2ρc v_i − ρc v − (αG/R)(u − u_ff)
//! (`lysmer1969` for the dashpots; the coefficients α are the user's, `wang2018` prints none). The dashpots act on velocity and belong to the step
//! ([`crate::engine`]); this part gives the other terms, of which the [free field](crate::free_field) says what bears its index.

use super::at_points::AtPoints;
use super::matrix::times;
use crate::free_field::{FreeField, Now, Place, Pushes, Spot};
use crate::parts::{Kept, Motion, Own, Part, Reads, Scratch, StateSizes, Tick};
use crate::soon::soon;
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
}

/// A node that springs hold.
struct Sprung {
    /// Its place among the part's nodes.
    at: usize,
    /// N/m
    matrix: [f64; 6],
    /// Bottoms of columns whose mean is the free field, with their weights.
    bottoms: Vec<(u32, f64)>,
}

/// Push of the free field, and springs.
pub struct BasePart {
    nodes: Vec<u32>,
    free_field: FreeField,
    pushes: Push,
    sprung: Vec<Sprung>,
    /// Where those are.
    spots: Vec<Spot>,
}

/// Where a part has from what its nodes are pushed with.
enum Push {
    /// Matrices of dashpots, which the rate of a wave that rises is put on.
    Dashpots(Vec<[f64; 6]>),
    Field(Box<dyn Pushes>),
}

impl BasePart {
    pub fn new(pushed: Vec<BaseNode>, free_field: FreeField) -> Self {
        let pushes = match &free_field {
            FreeField::Given(field) => {
                let places: Vec<&Place> = pushed.iter().map(|base| &base.place).collect();
                let own = field.pushes(&places);
                Push::Field(own.unwrap_or_else(|| Box::new(AtPoints::new(field.clone(), &places))))
            }
            FreeField::Beside(_) => Push::Dashpots(pushed.iter().map(|base| base.dashpot).collect()),
        };
        let nodes = pushed.iter().map(|base| base.node).collect();
        let spot = |base: &BaseNode| match &free_field {
            FreeField::Given(field) => field.spot(base.place.at),
            FreeField::Beside(_) => Spot::anywhere(base.place.at),
        };
        let spots = pushed.iter().filter(|base| base.is_sprung()).map(spot).collect();
        let sprung = pushed.into_iter().enumerate().filter(|(_, base)| base.is_sprung());
        let sprung = sprung
            .map(|(at, base)| Sprung { at, matrix: base.spring, bottoms: base.place.bottoms })
            .collect();
        BasePart { nodes, free_field, pushes, sprung, spots }
    }

    /// What the free field pushes each node with, beside what its dashpots follow \[N\].
    fn pushed(&self, now: &Now) -> Vec<[f64; 3]> {
        let mut out = vec![[0.0; 3]; self.nodes.len()];
        match (now, &self.pushes) {
            (Now::Given(_, time), Push::Field(pushes)) => pushes.forces(*time, &mut out),
            // 2 C v_i.
            (Now::Rising(velocity), Push::Dashpots(dashpots)) => {
                let twice = velocity.map(|v| 2.0 * v);
                out.iter_mut().zip(dashpots).for_each(|(out, dashpot)| *out = times(dashpot, twice));
            }
            (Now::Given(..), Push::Dashpots(_)) | (Now::Rising(_), Push::Field(_)) => {}
        }
        out
    }
}

/// Numbers of a cache line.
const NUMBERS_AT_ONCE: usize = 8;

/// Numbers remembered: of each node the last push as it resists, and then of each that springs hold the last u − u_ff.
const OF_NODE: usize = 3;
const OF_SPRUNG: usize = 3;

impl Part for BasePart {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    fn bytes(&self) -> usize {
        let BasePart { nodes, pushes, sprung, spots, .. } = self;
        let pushes = match pushes {
            Push::Dashpots(dashpots) => size_of_val(&dashpots[..]),
            Push::Field(pushes) => pushes.bytes(),
        };
        size_of_val(&nodes[..]) + size_of_val(&sprung[..]) + size_of_val(&spots[..]) + pushes
    }

    /// The bottoms of the columns whose motion is the free field, from which springs count.
    fn reads(&self) -> Reads {
        let bottoms = self.sprung.iter().flat_map(|sprung| &sprung.bottoms);
        let mut nodes: Vec<u32> = bottoms.map(|(node, _)| *node).collect();
        nodes.sort_unstable();
        nodes.dedup();
        Reads { nodes, ..Reads::default() }
    }

    fn state_sizes(&self) -> StateSizes {
        let numbers = OF_NODE * self.nodes.len() + OF_SPRUNG * self.sprung.len();
        StateSizes { numbers, ..StateSizes::default() }
    }

    fn forces(&self, tick: &Tick, x: &Motion, own: Own, out: &mut [Row], _: &mut Scratch) -> Lines {
        let now = self.free_field.now(tick.time);
        let pushes = self.free_field.line();
        let mut work = Lines::default();
        let (last_pushes, last_scattered) = own.numbers.split_at_mut(OF_NODE * self.nodes.len());
        // They come while the field is asked.
        self.nodes.iter().for_each(|&node| soon(x.du, node as usize));
        (0..last_pushes.len()).step_by(NUMBERS_AT_ONCE).for_each(|k| soon(last_pushes, k));
        self.sprung.iter().for_each(|sprung| soon(x.u, self.nodes[sprung.at] as usize));
        let pushed = self.pushed(&now);
        // By component: sums of their own need not wait for one another.
        let mut sums = [0.0; 3];
        let remembered = last_pushes.as_chunks_mut::<OF_NODE>().0;
        for (((&node, push), out), last) in self.nodes.iter().zip(pushed).zip(out.iter_mut()).zip(remembered)
        {
            let du = x.increment(node);
            for i in 0..3 {
                let push = -push[i];
                sums[i] += 0.5 * (push + last[i]) * du.0[i];
                last[i] = push;
                out.0[i] = push;
            }
        }
        work[pushes] += sums[0] + sums[1] + sums[2];
        let mut sums = [0.0; 3];
        let given = now.displacements(&self.spots);
        let remembered = last_scattered.as_chunks_mut::<OF_SPRUNG>().0;
        for ((sprung, given), last) in self.sprung.iter().zip(given).zip(remembered) {
            let node = self.nodes[sprung.at];
            let du = x.increment(node);
            let scattered = now.scattered(&sprung.bottoms, x.u[node as usize].xyz(), given, x.u);
            let spring = times(&sprung.matrix, scattered);
            let before = times(&sprung.matrix, *last);
            for i in 0..3 {
                sums[i] += 0.5 * (spring[i] + before[i]) * du.0[i];
                out[sprung.at].0[i] += spring[i];
            }
            *last = scattered;
        }
        work[Line::Springs] += sums[0] + sums[1] + sums[2];
        work
    }

    /// ½(u − u_ff)·K(u − u_ff).
    fn energy(&self, _: &Motion, kept: Kept) -> Lines {
        let mut held = Lines::default();
        let scattered = kept.numbers[OF_NODE * self.nodes.len()..].as_chunks::<OF_SPRUNG>().0;
        for (sprung, &d) in self.sprung.iter().zip(scattered) {
            let force = times(&sprung.matrix, d);
            held[Line::Springs] += 0.5 * (force[0] * d[0] + force[1] * d[1] + force[2] * d[2]);
        }
        held
    }

    fn stiffness_times(&self, w: &[Row], out: &mut [Row], _: &mut Scratch) {
        out.fill(Row::ZERO);
        for Sprung { at, matrix, .. } in &self.sprung {
            out[*at] = Row::new(times(matrix, w[self.nodes[*at] as usize].xyz()));
        }
    }
}
