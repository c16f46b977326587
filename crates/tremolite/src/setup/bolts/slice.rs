//! Where a plane cuts faces: lines around a cavern, and places along them.

use super::wall::{Vector, Wall, between, dot, minus, norm};
use std::collections::BTreeMap;

/// Share of the walls' extent within which a node lies on a plane, so that round-off does not decide on which side.
const ON_PLANE: f64 = 1e-9;
/// Share of a piece within which a place is at its end, where the next piece has a say in what is normal.
const AT_JOINT: f64 = 1e-6;
/// cos 40°: faces that meet at less are one vault in flat pieces, others make a corner (an assumption).
const BENDS: f64 = 0.766;

/// Pieces of faces, end to end.
#[derive(Clone, Debug)]
pub struct Polyline {
    /// The face of each piece, by its place among the walls, and the piece's ends.
    pieces: Vec<(usize, [Vector; 2])>,
    closed: bool,
}

/// The edge of a face by its nodes, the lower first.
type Edge = [u32; 2];

/// Lines in which the plane of points x with axis·x = `level` cuts some of the walls. `extent` \[m\] is theirs.
pub fn cut(walls: &[Wall], of: &[usize], axis: Vector, level: f64, extent: f64) -> Vec<Polyline> {
    let mut pieces: Vec<Piece> = Vec::new();
    for &w in of {
        let wall = &walls[w];
        let count = wall.corners.len();
        let beyond: Vec<f64> = wall.corners.iter().map(|&x| dot(x, axis) - level).collect();
        // A node on the plane counts to one side: then edges are cut alike in both their faces.
        let above = |i: usize| beyond[i] >= -ON_PLANE * extent;
        let cuts: Vec<(Edge, Vector)> = (0..count)
            .map(|i| (i, (i + 1) % count))
            .filter(|&(i, j)| above(i) != above(j))
            .map(|(i, j)| {
                let (a, b) = if wall.nodes[i] < wall.nodes[j] { (i, j) } else { (j, i) };
                let t = (beyond[a] / (beyond[a] - beyond[b])).clamp(0.0, 1.0);
                ([wall.nodes[a], wall.nodes[b]], between(wall.corners[a], wall.corners[b], t))
            })
            .collect();
        pieces.extend(cuts.chunks_exact(2).map(|pair| (w, [pair[0], pair[1]])));
    }
    stitch(&pieces)
}

/// A piece of a face, its ends on two of the face's edges.
type Piece = (usize, [(Edge, Vector); 2]);

/// Joins pieces at the edges that they share: lines with two ends first, then rings.
fn stitch(pieces: &[Piece]) -> Vec<Polyline> {
    let mut at: BTreeMap<Edge, Vec<usize>> = BTreeMap::new();
    for (p, (_, ends)) in pieces.iter().enumerate() {
        ends.iter().for_each(|(edge, _)| at.entry(*edge).or_default().push(p));
    }
    let mut used = vec![false; pieces.len()];
    let mut lines = Vec::new();
    for rings in [false, true] {
        for (p, (_, ends)) in pieces.iter().enumerate() {
            // Where more than two pieces meet, lines end.
            let start = ends.iter().map(|(edge, _)| *edge).find(|edge| rings || at[edge].len() != 2);
            if let (Some(start), false) = (start, used[p]) {
                lines.push(walk(pieces, &at, &mut used, p, start));
            }
        }
    }
    lines
}

/// The line that begins with a piece, at one of its edges.
fn walk(
    pieces: &[Piece],
    at: &BTreeMap<Edge, Vec<usize>>,
    used: &mut [bool],
    first: usize,
    from: Edge,
) -> Polyline {
    let (mut piece, mut edge) = (first, from);
    let mut line = Polyline { pieces: Vec::new(), closed: false };
    loop {
        used[piece] = true;
        let (wall, [a, b]) = pieces[piece];
        let (start, end) = if a.0 == edge { (a, b) } else { (b, a) };
        line.pieces.push((wall, [start.1, end.1]));
        edge = end.0;
        match at[&edge][..] {
            [p, q] if !(used[p] && used[q]) => piece = if used[p] { q } else { p },
            _ => break,
        }
    }
    line.closed = edge == from && line.pieces.len() > 2;
    line
}

impl Polyline {
    /// m
    pub fn length(&self) -> f64 {
        self.pieces.iter().map(|(_, [a, b])| norm(minus(*b, *a))).sum()
    }

    /// Places as far apart along the line as asked, as many as fit best, the first and the last as far from its ends: on a
    /// whole multiple of the spacing half of it. Around a ring the spacing is stretched until it closes. Each with the unit
    /// vector into the rock there.
    pub fn places(&self, walls: &[Wall], spacing: f64) -> Vec<(Vector, Vector)> {
        let length = self.length();
        let at: Vec<f64> = if self.closed {
            let count = fitting(length, spacing);
            (0..count).map(|i| (i as f64 + 0.5) * length / count as f64).collect()
        } else {
            spread(0.0, length, spacing)
        };
        let mut places = Vec::with_capacity(at.len());
        let (mut p, mut begin) = (0, 0.0);
        for at in at {
            let size = |p: usize| norm(minus(self.pieces[p].1[1], self.pieces[p].1[0]));
            while p + 1 < self.pieces.len() && at > begin + size(p) {
                begin += size(p);
                p += 1;
            }
            let (wall, [a, b]) = self.pieces[p];
            let share = if size(p) > 0.0 { ((at - begin) / size(p)).clamp(0.0, 1.0) } else { 0.0 };
            let normal = self.normal(walls, p, share);
            places.push((walls[wall].onto(between(a, b, share)), normal));
        }
        places
    }
}

impl Polyline {
    /// The piece before one, or behind it.
    fn beside(&self, piece: usize, behind: bool) -> Option<usize> {
        let count = self.pieces.len();
        match (behind, self.closed) {
            (true, false) => Some(piece + 1).filter(|&next| next < count),
            (false, false) => piece.checked_sub(1),
            (true, true) => Some((piece + 1) % count),
            (false, true) => Some((piece + count - 1) % count),
        }
    }

    /// Unit vector into the rock on a piece: its own in the middle, towards its ends more and more the mean with its neighbour's,
    /// so that bolts of a vault in few flat faces fan out evenly. Corners stay sharp, but for what is right in one.
    fn normal(&self, walls: &[Wall], piece: usize, share: f64) -> Vector {
        let own = walls[self.pieces[piece].0].normal;
        let (behind, to_end) = (share > 0.5, share.min(1.0 - share));
        let Some(other) = self.beside(piece, behind).map(|q| walls[self.pieces[q].0].normal) else {
            return own;
        };
        if dot(own, other) < BENDS && to_end > AT_JOINT {
            return own;
        }
        let mean = unit([0, 1, 2].map(|i| own[i] + other[i]), own);
        unit(between(mean, own, 2.0 * to_end), own)
    }
}

/// A vector of length 1; the other one for one without length.
fn unit(v: Vector, otherwise: Vector) -> Vector {
    let size = norm(v);
    if size > 0.0 { v.map(|x| x / size) } else { otherwise }
}

/// How many times a spacing fits a length best; halves go up, whatever the round-off. One at least from a quarter on: stages may
/// advance in short steps, and what comes too near to earlier bolts is left out anyway.
fn fitting(length: f64, spacing: f64) -> usize {
    let least = if length >= 0.25 * spacing { 1.0 } else { 0.0 };
    (length / spacing + 0.5 + 1e-6).floor().max(least) as usize
}

/// Numbers between two others, as far apart as asked, as many as fit best, in the middle.
pub fn spread(from: f64, to: f64, spacing: f64) -> Vec<f64> {
    let count = fitting(to - from, spacing);
    let first = 0.5 * (from + to) - 0.5 * spacing * (count as f64 - 1.0);
    (0..count).map(|i| first + i as f64 * spacing).collect()
}
