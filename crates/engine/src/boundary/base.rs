//! The free field pushes at a boundary, and springs act on what differs from it.
//!
//! Traction on the model = σ_ff·n + C (v_ff − v) − K (u − u_ff), at a base into which a wave rises 2ρc v_i − ρc v − (αG/R)(u − u_ff)
//! (`lysmer1969` for the dashpots, `wang2018` for the springs). The dashpots act on velocity and belong to the step
//! ([`crate::engine`]); this part gives the other terms, of which the [free field](crate::free_field) says what bears its index.

use super::matrix::times;
use crate::free_field::{Asked, End, FreeField, Now, Place, Spot};
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
    /// The points of all faces, each once though up to four nodes share it, and their normals.
    points: Vec<Spot>,
    normals: Vec<[f64; 3]>,
    /// Node after node, which points are its own, with N dA \[m²\], and where those of each end: one piece of memory, which is gone through in
    /// every step.
    shares: Vec<(u32, f64)>,
    share_ends: Vec<usize>,
    /// By node what it takes beside, at edges of the model.
    ends: Vec<Vec<(u32, End)>>,
}

impl BasePart {
    pub fn new(mut pushed: Vec<BaseNode>, free_field: FreeField) -> Self {
        let spot = |at, of| match &free_field {
            FreeField::Given(field) => field.spot(at, of),
            FreeField::Beside(_) => Spot::anywhere(at),
        };
        let (mut points, mut normals, mut known) = (Vec::new(), Vec::new(), BTreeMap::new());
        let mut number = |at: [f64; 3], normal: [f64; 3]| -> u32 {
            // The middle of a triangle's edge is one of its neighbour too, which beyond an edge of the model has another normal.
            let key = (at.map(f64::to_bits), normal.map(|x| (1e3 * x).round() as i64));
            *known.entry(key).or_insert_with(|| {
                points.push(spot(at, Asked::Stress));
                normals.push(normal);
                points.len() as u32 - 1
            })
        };
        let (mut shares, mut share_ends, mut ends) = (Vec::new(), Vec::new(), Vec::new());
        for base in &mut pushed {
            let share = |(at, area): ([f64; 3], [f64; 3])| {
                let size = area.iter().map(|x| x * x).sum::<f64>().sqrt();
                (number(at, area.map(|x| x / size)), size)
            };
            shares.extend(std::mem::take(&mut base.place.shares).into_iter().map(share));
            share_ends.push(shares.len());
            let end = |end: End| (number(end.at, end.normal), end);
            ends.push(std::mem::take(&mut base.place.ends).into_iter().map(end).collect());
        }
        let nodes = pushed.iter().map(|b| b.node).collect();
        let sprung = pushed.iter().filter(|base| base.is_sprung());
        let sprung = sprung.map(|base| spot(base.place.at, Asked::Motion)).collect();
        BasePart { nodes, pushed, free_field, sprung, points, normals, shares, share_ends, ends }
    }

    /// σ_ff \[Pa\] at all points, and σ_ff·n there.
    fn tractions(&self, now: &Now) -> (Vec<[f64; 6]>, Vec<Row>) {
        let stresses = now.stresses(&self.points);
        let of = |(stress, normal): (&[f64; 6], &[f64; 3])| Row::new(times(stress, *normal));
        let tractions = stresses.iter().zip(&self.normals).map(of).collect();
        (stresses, tractions)
    }

    /// By node its points, with N dA \[m²\].
    fn of_nodes(&self) -> impl Iterator<Item = &[(u32, f64)]> {
        let begins = std::iter::once(&0).chain(&self.share_ends);
        begins.zip(&self.share_ends).map(|(&begin, &end)| &self.shares[begin..end])
    }
}

/// Numbers remembered per node: the last u − u_ff, and the last push as it resists.
const REMEMBERED: usize = 6;

impl Part for BasePart {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    fn bytes(&self) -> usize {
        let BasePart { nodes, pushed, sprung, points, normals, shares, share_ends, ends, .. } = self;
        let points = size_of_val(&sprung[..]) + size_of_val(&points[..]) + size_of_val(&normals[..]);
        let shares = size_of_val(&shares[..]) + size_of_val(&share_ends[..]);
        let ends: usize = ends.iter().map(|own| size_of_val(own) + size_of_val(&own[..])).sum();
        size_of_val(&nodes[..]) + size_of_val(&pushed[..]) + points + shares + ends
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
        let (stresses, tractions) = self.tractions(&now);
        let mut given = now.displacements(&self.sprung).into_iter();
        let last = own.numbers.chunks_exact_mut(REMEMBERED);
        let beside = self.of_nodes().zip(&self.ends);
        for (((base, (points, ends)), out), last) in self.pushed.iter().zip(beside).zip(out).zip(last) {
            let du = x.increment(base.node).xyz();
            let scattered = match base.is_sprung() {
                true => base.scattered(&now, given.next().unwrap_or_default(), x.u),
                false => [0.0; 3],
            };
            let spring = times(&base.spring, scattered);
            let before = times(&base.spring, [last[0], last[1], last[2]]);
            let points = points.iter().map(|&(k, area)| (&tractions[k as usize], area));
            let ends = ends.iter().map(|(k, end)| (end, &stresses[*k as usize]));
            let push = now.push(&base.dashpot, points, ends).map(|f| -f);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::free_field::GivenField;
    use std::sync::Arc;

    struct Pressed;

    impl GivenField for Pressed {
        fn displacement(&self, _: [f64; 3], _: f64) -> [f64; 3] {
            [0.0; 3]
        }

        fn stress(&self, _: [f64; 3], _: f64) -> [f64; 6] {
            [2.0, 3.0, 5.0, 0.0, 0.0, 0.0]
        }

        fn peak_velocity(&self) -> f64 {
            0.0
        }
    }

    /// Two triangles share the middle of an edge of the model, each on a side of it.
    #[test]
    fn a_point_on_two_sides_has_the_traction_of_each() {
        let at = [0.5, 0.0, 0.0];
        let shares = vec![(at, [-1.0, 0.0, 0.0]), (at, [0.0, -1.0, 0.0]), (at, [-1.0, 0.0, 0.0])];
        let node = BaseNode {
            node: 0,
            dashpot: [0.0; 6],
            spring: [0.0; 6],
            place: Place { at, shares, ..Place::default() },
            counted: true,
        };
        let part = BasePart::new(vec![node], FreeField::Given(Arc::new(Pressed)));
        assert_eq!(part.points.len(), 2);
        let now = part.free_field.now(0.0);
        let (_, tractions) = part.tractions(&now);
        let tractions = part.shares.iter().map(|&(k, area)| (&tractions[k as usize], area));
        assert_eq!(now.push(&[0.0; 6], tractions, std::iter::empty()), [-4.0, -3.0, 0.0]);
    }
}
