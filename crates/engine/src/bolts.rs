//! Bolts, anchors and reinforcing bars: bars that lie in elements and share their motion, or slide along them.

mod cut;

pub use cut::{Hosts, cut};

use crate::life::Stage;

/// A bar, head first.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    /// Ends of its straight legs \[m\], two or more; one leg alone where there is a [`Bond`].
    pub points: Vec<[f64; 3]>,
    /// Cross-section \[m²\] of each leg.
    pub areas: Vec<f64>,
}

/// How a bar is joined to what it lies in, where it does not simply move with it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bond {
    /// Force per length and slip \[N/m²\].
    pub stiffness: f64,
    /// Force per length at which it slides \[N/m\], without confinement.
    pub strength: f64,
    /// Tangent of the angle of friction, and the perimeter \[m\] on which the confining stress acts.
    pub friction: f64,
    pub perimeter: f64,
    /// Longest segment of the bar \[m\], beyond that it is cut where it leaves an element; infinite for no more cuts.
    pub segment: f64,
}

/// Bars of one kind as a problem states them.
#[derive(Clone, Debug, PartialEq)]
pub struct Bolts {
    /// For messages and reports.
    pub name: String,
    pub bars: Vec<Bar>,
    /// Young's modulus \[Pa\].
    pub young: f64,
    /// Stress \[Pa\] at which they yield in tension and in compression; infinite for never.
    pub yields: f64,
    /// Extension beyond which they break, plastic strain included; infinite for never.
    pub breaks: f64,
    /// None: they move with what they lie in.
    pub bond: Option<Bond>,
    /// Tension \[N\] that is kept through the stage they are placed in, of the free length if there is one; their length is
    /// kept from then on.
    pub pretension: f64,
    /// Length \[m\] from the head on which they touch nothing.
    pub free_length: f64,
    /// Whether a plate holds the head, and the other end.
    pub plates: [bool; 2],
    /// The stage that they are placed in.
    pub born: Stage,
}

/// What became of the bars that were given.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cuts {
    pub given: usize,
    /// Left shorter, since they ran into a void or out of the model.
    pub shortened: usize,
    /// Left out, since their head lies in no element that is there.
    pub left_out: usize,
    /// Places where a bar crosses an interface.
    pub crossings: usize,
}

/// A point of a bolt: where it is, and whose motion it sees there.
#[derive(Clone, Debug, PartialEq)]
pub struct BoltPoint {
    /// Distance from the head along the bolt \[m\].
    pub at: f64,
    pub place: [f64; 3],
    /// Nodes of the mesh with their shape functions, whose sum is 1.
    pub weights: Vec<(u32, f64)>,
    /// The element it lies in, and that beside it where the bolt goes on there: the same at an end.
    pub host: u32,
    pub beside: u32,
}

/// A segment between two points of a bolt.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Segment {
    /// Its points, by their places in [`Bolt::points`].
    pub points: [u32; 2],
    /// Unit vector from the first to the second.
    pub along: [f64; 3],
    /// m
    pub length: f64,
    /// m²
    pub area: f64,
    /// Whether it touches nothing between its points.
    pub free: bool,
    /// The stage that takes what it lies in.
    pub gone: Option<Stage>,
}

/// A bolt cut into segments.
#[derive(Clone, Debug, PartialEq)]
pub struct Bolt {
    /// Which of the bars that were given.
    pub bar: u32,
    pub points: Vec<BoltPoint>,
    /// Head first. Those of a bar with a bond follow one another; across an interface the two points at one place are apart.
    pub segments: Vec<Segment>,
}

impl Bolt {
    /// m
    pub fn length(&self) -> f64 {
        self.segments.iter().map(|segment| segment.length).sum()
    }

    /// Distance \[m\] of a point from a segment.
    fn away(&self, segment: usize, point: [f64; 3]) -> f64 {
        let Segment { points: [first, _], along, length, .. } = self.segments[segment];
        let from = [0, 1, 2].map(|i| point[i] - self.points[first as usize].place[i]);
        let at = (from[0] * along[0] + from[1] * along[1] + from[2] * along[2]).clamp(0.0, length);
        (0..3).map(|i| (from[i] - at * along[i]).powi(2)).sum::<f64>().sqrt()
    }

    /// Middle of a segment \[m\].
    pub fn middle(&self, segment: usize) -> [f64; 3] {
        let [a, b] = self.segments[segment].points.map(|p| self.points[p as usize].place);
        [0, 1, 2].map(|i| 0.5 * (a[i] + b[i]))
    }
}

/// Bolts of one kind, cut where they leave an element.
#[derive(Clone, Debug, PartialEq)]
pub struct BoltSet {
    /// As given, without the bars.
    pub kind: Bolts,
    pub bolts: Vec<Bolt>,
    pub cuts: Cuts,
}

impl BoltSet {
    /// The segment nearest to a point, as (bolt, segment); none without bolts.
    pub fn nearest(&self, point: [f64; 3]) -> Option<(usize, usize)> {
        let all = self.bolts.iter().enumerate();
        all.flat_map(|(b, bolt)| (0..bolt.segments.len()).map(move |s| (b, s)))
            .min_by(|a, b| self.bolts[a.0].away(a.1, point).total_cmp(&self.bolts[b.0].away(b.1, point)))
    }

    /// Distance \[m\] of a point from the nearest bolt; infinite without bolts.
    pub fn distance(&self, point: [f64; 3]) -> f64 {
        self.nearest(point).map_or(f64::INFINITY, |(b, s)| self.bolts[b].away(s, point))
    }
}

/// What a segment does.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SegmentSeen {
    /// Tension \[N\].
    pub force: f64,
    /// That of largest size \[N\] in any step since the stage, or the shaking, began.
    pub largest_force: f64,
    /// Force at which it yields \[N\]; infinite for never.
    pub yields_at: f64,
    /// Plastic strain.
    pub plastic_strain: f64,
    /// Slip \[m\] of the bond beside it, the larger of its ends', bar less ground along the bolt, elastic part included.
    pub slip: f64,
    /// Largest size of its slip \[m\] since the bolt was placed.
    pub largest_slip: f64,
    /// Whether its bond ever slid, whatever else became of it.
    pub slid: bool,
    pub state: SegmentState,
}

/// How a segment stands. Ordered by how much is lost.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
#[repr(u8)]
pub enum SegmentState {
    #[default]
    Elastic = 0,
    /// Its bond slides now or has slid.
    Slid = 1,
    /// It has yielded.
    Yielded = 2,
    Broken = 3,
    /// What it lay in was excavated.
    CutOff = 4,
}
