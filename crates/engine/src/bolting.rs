//! Bolts of a model as members of its assembly, and what they do seen from outside.

use crate::bolts::{self, BoltSet, Bolts, SegmentSeen, SegmentState};
use crate::life::Life;
use crate::member::{Kind, Member};
use crate::model::Model;
use crate::parts::bars::memory::{BROKEN, CUT_OFF, Layout, LinkMemory, PointMemory, WholeMemory, YIELDED};
use crate::parts::bars::{Bar, Bars, Bolt};
use std::collections::HashMap;
use std::sync::Arc;
use tremolite_kernels::Line;
use tremolite_mesh::order::hilbert_order;

/// Points that one thread works on together.
const CHUNK: usize = 256;

/// The bolts of a set, ready to be looked at.
#[derive(Clone, Debug, Default)]
pub struct Bolting {
    /// Of each bolt, which of the set's members it is in, and where its numbers lie in that.
    places: Vec<(u32, usize)>,
    /// Where the numbers of these members begin in the state.
    pub(crate) starts: Vec<usize>,
    shapes: Vec<Shape>,
}

/// What is needed of a bolt to read its numbers.
#[derive(Clone, Debug)]
struct Shape {
    layout: Layout,
    /// Length \[m\], force at yield \[N\], and points of each segment.
    segments: Vec<(f64, f64, [u32; 2])>,
}

impl Bolting {
    /// The segments of a bolt as they were evaluated last, from the numbers of the state.
    pub fn seen(&self, numbers: &[f64], bolt: usize) -> Vec<SegmentSeen> {
        let Shape { segments, .. } = &self.shapes[bolt];
        let (_, links, points) = self.read(numbers, bolt);
        let seen = |(link, &(length, yields_at, ends)): (&LinkMemory, &(f64, f64, [u32; 2]))| {
            let of = |value: fn(&PointMemory) -> f64| {
                let [a, b] = ends.map(|p| points.get(p as usize).map_or(0.0, value));
                if a.abs() > b.abs() { a } else { b }
            };
            let slid = of(|point| point.slid) > 0.0;
            let state = match link.status {
                s if s >= CUT_OFF => SegmentState::CutOff,
                s if s >= BROKEN => SegmentState::Broken,
                s if s >= YIELDED => SegmentState::Yielded,
                _ if slid => SegmentState::Slid,
                _ => SegmentState::Elastic,
            };
            let elastic = |point: &PointMemory| {
                if point.stiffness > 0.0 { point.force / point.stiffness + point.slip } else { 0.0 }
            };
            SegmentSeen {
                force: link.force,
                largest_force: link.largest,
                yields_at,
                plastic_strain: link.plastic / length,
                slip: of(elastic),
                largest_slip: of(|point| point.largest),
                slid,
                state,
            }
        };
        links.iter().zip(segments).map(seen).collect()
    }

    /// Largest force \[N\] along a bolt that no law answers for, as its sliders did not settle within the passes, since it was
    /// placed, and the most passes that they took; nothing without a bond.
    pub fn unsettled(&self, numbers: &[f64], bolt: usize) -> (f64, u32) {
        let (whole, ..) = self.read(numbers, bolt);
        (whole.rest, whole.passes as u32)
    }

    fn read(&self, numbers: &[f64], bolt: usize) -> (WholeMemory, Vec<LinkMemory>, Vec<PointMemory>) {
        let (member, at) = self.places[bolt];
        let Shape { layout, .. } = &self.shapes[bolt];
        let from = self.starts[member as usize] + at;
        layout.seen(&numbers[from..from + layout.numbers()])
    }
}

/// The members of the set of this number, and how to look at its bolts.
pub fn members(model: &Model, set: &BoltSet, number: u32) -> (Vec<Member>, Bolting) {
    let kind = Arc::new(set.kind.clone());
    let life = Life { born: set.kind.born, gone: None };
    let heads: Vec<[f64; 3]> = set.bolts.iter().map(|bolt| bolt.points[0].place).collect();
    let mut bolting = Bolting { places: vec![(0, 0); set.bolts.len()], ..Bolting::default() };
    bolting.shapes = set.bolts.iter().map(|bolt| shape(set, bolt)).collect();
    let mut members = Vec::new();
    let level = |bolt: u32| {
        let points = set.bolts[bolt as usize].points.iter().flat_map(|point| &point.weights);
        let levels = points.map(|&(n, _)| model.nodes.level[model.engine_node[n as usize] as usize]);
        levels.min().unwrap_or(0)
    };
    let mut order = hilbert_order(&heads);
    order.sort_by_key(|&bolt| level(bolt));
    let mut order = order.into_iter().peekable();
    while let Some(&first) = order.peek() {
        let mut maker = Maker::new(kind.clone());
        let fits = |bolt: u32, maker: &Maker| maker.bars.hosts.len() < CHUNK && level(bolt) == level(first);
        while let Some(bolt) = order.next_if(|&bolt| fits(bolt, &maker)) {
            bolting.places[bolt as usize] = (members.len() as u32, maker.bars.numbers);
            maker.add(model, &set.bolts[bolt as usize]);
        }
        let Maker { bars, springs, .. } = maker;
        members.push(Member {
            springs,
            life,
            line: Some(Line::Bolts),
            ..Member::of(Kind::Bolts(number), set.kind.name.clone(), Box::new(bars))
        });
    }
    (members, bolting)
}

fn shape(set: &BoltSet, bolt: &bolts::Bolt) -> Shape {
    let segments = bolt.segments.iter().map(|s| (s.length, s.area * set.kind.yields, s.points)).collect();
    Shape { layout: Layout::of(set.kind.bond.is_some(), bolt.segments.len(), bolt.points.len()), segments }
}

/// A part in the making.
struct Maker {
    bars: Bars,
    places: HashMap<u32, u32>,
    springs: Vec<(u32, f64)>,
}

impl Maker {
    fn new(kind: Arc<Bolts>) -> Self {
        let bars = Bars {
            kind,
            nodes: Vec::new(),
            start: vec![0],
            place: Vec::new(),
            weight: Vec::new(),
            hosts: Vec::new(),
            bars: Vec::new(),
            bolts: Vec::new(),
            numbers: 0,
        };
        Maker { bars, places: HashMap::new(), springs: Vec::new() }
    }

    fn add(&mut self, model: &Model, bolt: &bolts::Bolt) {
        let Maker { bars, places, springs } = self;
        let first = bars.hosts.len();
        for point in &bolt.points {
            for &(node, weight) in &point.weights {
                let node = model.engine_node[node as usize];
                let place = *places.entry(node).or_insert_with(|| {
                    bars.nodes.push(node);
                    bars.nodes.len() as u32 - 1
                });
                bars.place.push(place);
                bars.weight.push(weight);
            }
            bars.start.push(bars.place.len() as u32);
            bars.hosts.push([point.host, point.beside]);
        }
        let of = bars.bars.len();
        for segment in &bolt.segments {
            let stiffness = bars.kind.young * segment.area / segment.length;
            bars.bars.push(Bar {
                points: segment.points.map(|p| p + first as u32),
                along: segment.along,
                length: segment.length,
                stiffness,
                yields: bars.kind.yields * segment.area,
                free: segment.free,
                gone: segment.gone,
            });
            springs.extend(
                bounds(bolt, segment.points, stiffness)
                    .into_iter()
                    .map(|(node, spring)| (model.engine_node[node as usize], spring)),
            );
        }
        let layout = Layout::of(bars.kind.bond.is_some(), bolt.segments.len(), bolt.points.len());
        bars.bolts.push(Bolt {
            points: first..bars.hosts.len(),
            bars: of..bars.bars.len(),
            at: bars.numbers,
        });
        bars.numbers += layout.numbers();
    }
}

/// Springs at the nodes of a segment that together are no softer than it: of k(Σ δ_j u_j·t)² ≤ k Σ|δ| Σ|δ_j||u_j|², δ the
/// differences of the shape functions at its ends, each node has a share. A spring counts twice
/// ([`Member::springs`](crate::member::Member)).
fn bounds(bolt: &bolts::Bolt, ends: [u32; 2], stiffness: f64) -> Vec<(u32, f64)> {
    let mut differences: Vec<(u32, f64)> = Vec::new();
    for (p, sign) in ends.into_iter().zip([-1.0, 1.0]) {
        for &(node, weight) in &bolt.points[p as usize].weights {
            match differences.iter_mut().find(|(n, _)| *n == node) {
                Some((_, sum)) => *sum += sign * weight,
                None => differences.push((node, sign * weight)),
            }
        }
    }
    let sum: f64 = differences.iter().map(|(_, d)| d.abs()).sum();
    differences.into_iter().map(|(node, d)| (node, 0.5 * stiffness * sum * d.abs())).collect()
}
