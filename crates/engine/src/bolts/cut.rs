//! Bars cut where they leave an element.

use super::{Bar, Bolt, BoltPoint, BoltSet, Bolts, Cuts, Segment};
use crate::life::{Life, Stage};
use crate::rims::Rims;
use std::collections::{BTreeMap, HashMap};
use tremolite_mesh::locate::Locator;
use tremolite_mesh::{Mesh, quality};

/// A gap \[m\] in what a bar lies in that is no void: faces of warped elements, a head beside its wall.
const GAP: f64 = 0.01;
/// Weights that differ by less see the same motion.
const SAME: f64 = 1e-8;
/// How far from the element in which a leg of a bar is said to lie an end of it may be, over the leg's length: ten times what
/// [`Locator::stretches`] allows.
const BESIDE: f64 = 1e-6;
/// Share of an element's size that a segment through an interface reaches on either side at least: one that only just reaches it
/// would be so stiff that it bounds the step.
const REACH: f64 = 0.25;

/// Share of an element's size below which a piece is no segment of its own: it would tell the strain of an element that it hardly
/// reaches.
const TIP: f64 = 0.05;

/// What bars lie in.
pub struct Hosts<'a> {
    pub mesh: &'a Mesh,
    /// The body of each of the user's elements.
    pub body_of: &'a [Option<usize>],
    pub lives: &'a [Life],
    /// Elements that take over from others: later → earlier.
    pub successors: &'a HashMap<u32, u32>,
    /// Which copies of nodes move as one.
    pub rims: &'a Rims,
}

impl Hosts<'_> {
    fn standing(&self, stage: Stage) -> Vec<u32> {
        let there = |e: &usize| self.body_of[*e].is_some() && self.lives[*e].holds(stage);
        (0..self.body_of.len()).filter(there).map(|e| e as u32).collect()
    }

    /// m
    fn size(&self, element: u32) -> f64 {
        quality::of(self.mesh, element as usize).size()
    }
}

/// Cuts the bars of each group.
pub fn cut(ground: &Hosts, all: Vec<Bolts>) -> Vec<BoltSet> {
    let takers: HashMap<u32, u32> =
        ground.successors.iter().map(|(&later, &earlier)| (earlier, later)).collect();
    let mut standing: BTreeMap<Stage, Vec<u32>> = BTreeMap::new();
    for kind in &all {
        standing.entry(kind.born).or_insert_with(|| ground.standing(kind.born));
    }
    let locators: BTreeMap<Stage, Locator> = standing
        .iter()
        .map(|(&stage, elements)| (stage, Locator::new(ground.mesh, Some(elements))))
        .collect();
    let of = |mut kind: Bolts| {
        let bars = std::mem::take(&mut kind.bars);
        let mut cuts = Cuts { given: bars.len(), ..Cuts::default() };
        let saw = Saw { ground, takers: &takers, locator: &locators[&kind.born], kind: &kind };
        let bolts = (0u32..).zip(&bars).filter_map(|(b, bar)| saw.bolt(b, bar, &mut cuts)).collect();
        BoltSet { kind, bolts, cuts }
    };
    all.into_iter().map(of).collect()
}

/// Where a bar lies in one element.
struct Lain {
    element: u32,
    leg: usize,
    /// Distances from the head along the bar \[m\].
    from: f64,
    to: f64,
}

/// A piece in one element between two of the bolt's points.
struct Piece {
    points: [u32; 2],
    host: u32,
    /// m, m²
    length: f64,
    area: f64,
    /// Whether it sees another motion where it begins than the piece before where that ends: an interface lies between.
    crosses: bool,
}

struct Saw<'a> {
    ground: &'a Hosts<'a>,
    takers: &'a HashMap<u32, u32>,
    locator: &'a Locator<'a>,
    kind: &'a Bolts,
}

impl Saw<'_> {
    /// The stage that takes the place of an element.
    fn gone(&self, mut element: u32) -> Option<Stage> {
        loop {
            let gone = self.ground.lives[element as usize].gone;
            let taker = self.takers.get(&element);
            match taker.filter(|&&taker| gone == Some(self.ground.lives[taker as usize].born)) {
                Some(&taker) => element = taker,
                None => return gone,
            }
        }
    }

    fn bolt(&self, number: u32, bar: &Bar, cuts: &mut Cuts) -> Option<Bolt> {
        let (lain, ended) = self.lain(bar);
        let mut bolt = Bolt { bar: number, points: Vec::new(), segments: Vec::new() };
        let pieces = self.pieces(bar, &lain, &mut bolt.points);
        self.free(bar, &lain, &pieces, &mut bolt);
        let crossings = pieces.iter().filter(|piece| piece.crosses).count();
        for cluster in self.clusters(&pieces) {
            bolt.segments.push(self.segment(&bolt.points, cluster));
        }
        if bolt.segments.is_empty() {
            cuts.left_out += 1;
            return None;
        }
        cuts.crossings += crossings;
        cuts.shortened += usize::from(ended);
        Some(bolt)
    }

    /// Where a bar lies, up to the first void behind its free length, and whether that or the end of the model cuts it short.
    /// Nothing where its head lies in no element.
    fn lain(&self, bar: &Bar) -> (Vec<Lain>, bool) {
        let mut lain: Vec<Lain> = Vec::new();
        let (mut reach, mut start) = (0.0, 0.0);
        for (leg, ends) in bar.points.windows(2).enumerate() {
            for stretch in self.locator.stretches(ends[0], ends[1]) {
                let [from, to] = [stretch.from, stretch.to].map(|s| start + s);
                let in_free_length = !lain.is_empty() && from <= self.kind.free_length;
                if from - reach > GAP && !in_free_length {
                    return (lain, true);
                }
                lain.push(Lain { element: stretch.element, leg, from, to });
                reach = to;
            }
            start += distance(ends[0], ends[1]);
        }
        (lain, start - reach > GAP)
    }

    /// The pieces behind the free length, with their points.
    fn pieces(&self, bar: &Bar, lain: &[Lain], points: &mut Vec<BoltPoint>) -> Vec<Piece> {
        let mut pieces: Vec<Piece> = Vec::new();
        for lain in lain {
            let from = lain.from.max(self.kind.free_length);
            let length = lain.to - from;
            if length <= 1e-3 * (lain.to - lain.from) {
                continue;
            }
            let parts = self.kind.bond.map_or(1.0, |bond| (length / bond.segment - 1e-9).ceil().max(1.0));
            for part in 0..parts as u32 {
                let [a, b] = [part, part + 1].map(|k| from + length * f64::from(k) / parts);
                let Some(first) = self.point(bar, lain, a) else { continue };
                let Some(second) = self.point(bar, lain, b) else { continue };
                let shared = pieces.last().map(|last| last.points[1]);
                let same = shared.filter(|&p| self.see_the_same(&points[p as usize], &first));
                let crosses = shared.is_some() && same.is_none();
                if let Some(shared) = same {
                    let shared = &mut points[shared as usize];
                    shared.beside = lain.element;
                    // By the nodes of what is there for longer.
                    if earlier(self.gone(shared.host), self.gone(lain.element)) != self.gone(lain.element) {
                        shared.weights.clone_from(&first.weights);
                    }
                }
                let first = same.unwrap_or_else(|| push(points, first));
                let second = push(points, second);
                let area = bar.areas[lain.leg];
                let piece =
                    Piece { points: [first, second], host: lain.element, length: b - a, area, crosses };
                pieces.push(piece);
            }
        }
        pieces
    }

    /// The free length between the plate at the head and the first piece, or the plate at the other end.
    fn free(&self, bar: &Bar, lain: &[Lain], pieces: &[Piece], bolt: &mut Bolt) {
        let (Some(first), Some(last)) = (lain.first(), lain.last()) else { return };
        let (true, [true, tail]) = (self.kind.free_length > 0.0, self.kind.plates) else { return };
        let points = &mut bolt.points;
        let Some(head) = self.point(bar, first, first.from) else { return };
        let (end, host) = match pieces.first() {
            Some(piece) => (piece.points[0], piece.host),
            None if tail => {
                let Some(end) = self.point(bar, last, last.to) else { return };
                (push(points, end), last.element)
            }
            None => return,
        };
        let head = push(points, head);
        let piece = Piece { points: [head, end], host, length: 0.0, area: bar.areas[0], crosses: false };
        let mut segment = self.segment(points, std::slice::from_ref(&piece));
        segment.free = true;
        segment.gone = earlier(segment.gone, self.gone(first.element));
        bolt.segments.push(segment);
    }

    /// Pieces that make one segment: each by itself, but for those that an interface parts where nothing slides along the bar, and
    /// for the tip of a bar in the next element.
    fn clusters<'p>(&self, pieces: &'p [Piece]) -> Vec<&'p [Piece]> {
        let mut joined = vec![false; pieces.len()];
        let at = |k: usize| &pieces[k];
        let crossings = (0..pieces.len()).filter(|&k| at(k).crosses && self.kind.bond.is_none());
        for k in crossings {
            joined[k] = true;
            let enough = |host: u32| REACH * self.ground.size(host);
            let (mut reached, mut left) = (at(k - 1).length, k - 1);
            while reached < enough(at(k - 1).host) && left > 0 {
                joined[left] = true;
                left -= 1;
                reached += at(left).length;
            }
            let (mut reached, mut right) = (at(k).length, k);
            while reached < enough(at(k).host) && right + 1 < pieces.len() {
                right += 1;
                joined[right] = true;
                reached += at(right).length;
            }
        }
        if self.kind.bond.is_none() {
            for k in (0..pieces.len()).filter(|&k| at(k).length < TIP * self.ground.size(at(k).host)) {
                if let Some(joined) = joined.get_mut(k.max(1)) {
                    *joined = true;
                }
            }
        }
        let mut clusters = Vec::new();
        let mut start = 0;
        for k in 1..=pieces.len() {
            if k == pieces.len() || !joined[k] {
                clusters.push(&pieces[start..k]);
                start = k;
            }
        }
        clusters.retain(|cluster| !cluster.is_empty());
        clusters
    }

    fn segment(&self, points: &[BoltPoint], pieces: &[Piece]) -> Segment {
        let ends = [pieces[0].points[0], pieces[pieces.len() - 1].points[1]];
        let [a, b] = ends.map(|p| points[p as usize].place);
        let length = distance(a, b);
        let whole: f64 = pieces.iter().map(|piece| piece.length).sum();
        let area = match whole > 0.0 {
            true => pieces.iter().map(|piece| piece.area * piece.length).sum::<f64>() / whole,
            false => pieces[0].area,
        };
        Segment {
            points: ends,
            along: [0, 1, 2].map(|i| (b[i] - a[i]) / length),
            length,
            area,
            free: false,
            gone: pieces.iter().fold(None, |gone, piece| earlier(gone, self.gone(piece.host))),
        }
    }

    /// Whether two points at one place have their motion from the same nodes, or from such that move as one as long as what they
    /// lie in stands.
    fn see_the_same(&self, a: &BoltPoint, b: &BoltPoint) -> bool {
        let life = Life { born: self.kind.born, gone: earlier(self.gone(a.host), self.gone(b.host)) };
        let same = |n: u32, m: u32| n == m || self.ground.rims.always_held(life, [n, m]);
        let of = |point: &BoltPoint, node: u32| -> f64 {
            point.weights.iter().filter(|(n, _)| same(*n, node)).map(|(_, weight)| *weight).sum()
        };
        let nodes = a.weights.iter().chain(&b.weights);
        nodes.into_iter().all(|&(node, _)| (of(a, node) - of(b, node)).abs() < SAME)
    }

    /// The point at a distance \[m\] from the head, in the element in which the bar lies there.
    fn point(&self, bar: &Bar, lain: &Lain, at: f64) -> Option<BoltPoint> {
        let before: f64 = bar.points.windows(2).take(lain.leg).map(|ends| distance(ends[0], ends[1])).sum();
        let (from, to) = (bar.points[lain.leg], bar.points[lain.leg + 1]);
        let leg = distance(from, to);
        let share = (at - before) / leg;
        let place = [0, 1, 2].map(|i| from[i] + share * (to[i] - from[i]));
        let (shapes, place) = self.locator.weights_in(lain.element, place, BESIDE * leg)?;
        let mut weights: Vec<(u32, f64)> = Vec::new();
        let nodes = self.ground.mesh.elements[lain.element as usize].nodes();
        for (&node, weight) in nodes.iter().zip(shapes).filter(|(_, weight)| *weight != 0.0) {
            weights.push((node, weight));
        }
        Some(BoltPoint { at, place, weights, host: lain.element, beside: lain.element })
    }
}

fn push(points: &mut Vec<BoltPoint>, point: BoltPoint) -> u32 {
    points.push(point);
    points.len() as u32 - 1
}

fn earlier(a: Option<Stage>, b: Option<Stage>) -> Option<Stage> {
    match (a, b) {
        (Some(a), Some(b)) => Some(a.min(b)),
        (a, b) => a.or(b),
    }
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (b[i] - a[i]).powi(2)).sum::<f64>().sqrt()
}
