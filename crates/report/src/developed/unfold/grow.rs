//! One sheet, grown from the crown.

use std::cmp::Reverse;
use std::collections::{BTreeMap, BinaryHeap};

use super::edges::edges;
use super::folds::Folds;
use super::overlap::Laid;
use super::{Corners, Flat, Sheet, cross, dot, length, less, unit};

/// Weight of a way along the axis beside one around the section: enough to go by where the section says nothing.
const ALONG: f64 = 1e-3;
/// Faces that lean towards the axis by more than this cosine, of 45° with its round-off, are ends.
const END: f64 = std::f64::consts::FRAC_1_SQRT_2 + 1e-6;

/// What lies already: faces with their piece and corners, and the outlines of each piece.
struct Lying {
    placed: BTreeMap<usize, (usize, Corners)>,
    pieces: Vec<Laid>,
}

impl Lying {
    fn add(&mut self, grown: Vec<(usize, Corners)>, piece: usize, side: f64) {
        if piece == self.pieces.len() {
            self.pieces.push(Laid::new(side));
        }
        for (f, corners) in grown {
            self.pieces[piece].add(&corners);
            self.placed.insert(f, (piece, corners));
        }
    }
}

/// Develops the faces `own`, at least one, which hang together.
pub fn sheet(folds: &Folds, own: &[usize]) -> Sheet {
    let axis = folds.axis(own);
    let end = |f: usize| dot(folds.facets[f].normal, axis).abs() > END;
    let growth = Growth { folds, axis, side: 2.0 * size(folds, own) };
    let mut lying = Lying { placed: BTreeMap::new(), pieces: Vec::new() };

    let panels = folds.parts(own, |f, g| end(f) == end(g));
    let height = |f: &usize| folds.facets[*f].centre[2];
    // Ends come first only where there is nothing else.
    let rank = |f: &usize| if end(*f) { (0, height(f)) } else { (1, height(f)) };
    let higher = |f: &&usize, g: &&usize| {
        let (f, g) = (rank(f), rank(g));
        f.0.cmp(&g.0).then(f.1.total_cmp(&g.1))
    };
    let highest = own.iter().max_by(higher);
    if let Some(panel) = panels.iter().find(|panel| highest.is_some_and(|f| panel.contains(f))) {
        let (sources, root, corners) = growth.crown(panel);
        let (grown, _) = growth.panel(panel, &sources, root, corners, &Laid::new(growth.side));
        lying.add(grown, 0, growth.side);
    }
    while let Some((f, k, g, j)) = growth.next(&lying.placed) {
        let (piece, corners) = &lying.placed[&f];
        let corners = growth.place(g, j, corners[(k + 1) % corners.len()], corners[k]);
        let left: Vec<usize> = own.iter().copied().filter(|x| !lying.placed.contains_key(x)).collect();
        let parts = folds.parts(&left, |x, y| end(x) == end(y));
        let Some(panel) = parts.iter().find(|part| part.contains(&g)) else { break };
        let (grown, free) = growth.panel(panel, &[(g, 0.0)], g, corners, &lying.pieces[*piece]);
        lying.add(grown, if free { *piece } else { lying.pieces.len() }, growth.side);
    }
    let Lying { mut placed, pieces } = lying;
    apart(&mut placed, pieces.len());
    let (outline, creases) = edges(folds, own, &placed);
    let mean = folds.mean_normal(own);
    let wraps = own.iter().any(|&f| !end(f) && dot(folds.facets[f].normal, mean) < 0.5);
    let flat = |(f, (piece, corners)): (usize, (usize, Corners))| {
        let facet = &folds.facets[f];
        Flat {
            face: facet.face,
            points: facet.points.clone(),
            corners,
            normal: facet.normal,
            end: end(f),
            piece,
        }
    };
    let faces = placed.into_iter().map(flat).collect();
    Sheet { axis, wraps, faces, outline, creases, pieces: pieces.len() }
}

/// Mean length of the edges.
fn size(folds: &Folds, own: &[usize]) -> f64 {
    let mut sum = 0.0;
    let mut number = 0.0;
    for &f in own {
        for k in 0..folds.facets[f].nodes.len() {
            let [a, b] = folds.edge(f, k);
            sum += length(less(b, a));
            number += 1.0;
        }
    }
    f64::max(sum / number, f64::MIN_POSITIVE)
}

struct Growth<'a> {
    folds: &'a Folds,
    axis: [f64; 3],
    side: f64,
}

impl Growth<'_> {
    /// Where a panel begins: its highest faces with their distances around the section from the middle of them all; the
    /// nearest of them, and where it lies. u is the coordinate along the axis, v is 0 in that middle.
    fn crown(&self, panel: &[usize]) -> (Vec<(usize, f64)>, usize, Corners) {
        let facets = &self.folds.facets;
        let top = panel.iter().map(|&f| facets[f].centre[2]).fold(f64::NEG_INFINITY, f64::max);
        let is_top = |f: &&usize| facets[**f].centre[2] >= top - 1e-3 * self.side;
        let along = |f: usize| dot(facets[f].centre, self.axis);
        let across = |p: [f64; 3]| [0, 1, 2].map(|i| p[i] - dot(p, self.axis) * self.axis[i]);
        let mut low = [f64::INFINITY; 4];
        let mut high = [f64::NEG_INFINITY; 4];
        for &f in panel.iter().filter(is_top) {
            let [x, y, z] = across(facets[f].centre);
            for (i, c) in [x, y, z, along(f)].into_iter().enumerate() {
                (low[i], high[i]) = (low[i].min(c), high[i].max(c));
            }
        }
        let middle = [0, 1, 2].map(|i| 0.5 * (low[i] + high[i]));
        let sources: Vec<(usize, f64)> = panel
            .iter()
            .filter(is_top)
            .map(|&f| (f, length(less(across(facets[f].centre), middle))))
            .collect();
        let rank = |&(f, far): &(usize, f64)| far + ALONG * (along(f) - 0.5 * (low[3] + high[3])).abs();
        let root = sources.iter().min_by(|a, b| rank(a).total_cmp(&rank(b))).map_or(panel[0], |s| s.0);

        let normal = facets[root].normal;
        let lean = dot(normal, self.axis);
        let right = unit([0, 1, 2].map(|i| self.axis[i] - lean * normal[i])).unwrap_or_else(|| {
            unit(less(self.folds.edge(root, 0)[1], self.folds.edge(root, 0)[0])).unwrap_or(self.axis)
        });
        let up = cross(normal, right);
        let [a, b] = self.folds.edge(root, 0);
        let start = [dot(a, self.axis), dot(less(a, middle), up)];
        let way = less(b, a);
        let turn = [dot(way, right), dot(way, up)];
        let stretch = length(way) / turn[0].hypot(turn[1]);
        let stop = [start[0] + stretch * turn[0], start[1] + stretch * turn[1]];
        (sources, root, self.place(root, 0, start, stop))
    }

    /// A face whose edge from corner k to k + 1 lies from a to b. A warped one is bent along the diagonal from its first
    /// corner, so all four edges keep their lengths.
    fn place(&self, f: usize, k: usize, a: [f64; 2], b: [f64; 2]) -> Corners {
        let nodes = &self.folds.facets[f].nodes;
        let n = nodes.len();
        let place = |i: usize| self.folds.places[nodes[i]];
        let mut at: Vec<Option<[f64; 2]>> = vec![None; n];
        at[k] = Some(a);
        at[(k + 1) % n] = Some(b);
        // The fan of triangles, as often as it takes to come from the one that is known to all others.
        for _ in 0..n {
            for i in 1..n - 1 {
                for [p, q, r] in [[0, i, i + 1], [i, i + 1, 0], [i + 1, 0, i]] {
                    if let (Some(from), Some(to), None) = (at[p], at[q], at[r]) {
                        at[r] = Some(apex([place(p), place(q), place(r)], from, to));
                    }
                }
            }
        }
        at.into_iter().flatten().collect()
    }

    /// Lays a panel from a face whose corners are known; also whether it is free of what lies already. Faces that would
    /// lie on others of their own panel are left for later.
    fn panel(
        &self,
        panel: &[usize],
        sources: &[(usize, f64)],
        root: usize,
        corners: Corners,
        others: &Laid,
    ) -> (Vec<(usize, Corners)>, bool) {
        let far = self.distances(panel, sources);
        let mut own = Laid::new(self.side);
        let mut grown: BTreeMap<usize, Corners> = BTreeMap::new();
        let mut free = true;
        let mut ways = vec![(root, corners)];
        let mut heap = BinaryHeap::from([Reverse((0, 0))]);
        while let Some(Reverse((_, way))) = heap.pop() {
            let (f, corners) = std::mem::take(&mut ways[way]);
            if grown.contains_key(&f) || own.is_under(&corners) {
                continue;
            }
            own.add(&corners);
            free &= !others.is_under(&corners);
            for (k, beside) in self.folds.facets[f].beside.iter().enumerate() {
                let Some((g, j)) = *beside else { continue };
                if let (Some(distance), false) = (far.get(&g), grown.contains_key(&g)) {
                    heap.push(Reverse((distance.to_bits(), ways.len())));
                    ways.push((g, self.place(g, j, corners[(k + 1) % corners.len()], corners[k])));
                }
            }
            grown.insert(f, corners);
        }
        (grown.into_iter().collect(), free)
    }

    /// Distances around the section, over the faces of a panel, from some of them.
    fn distances(&self, panel: &[usize], sources: &[(usize, f64)]) -> BTreeMap<usize, f64> {
        let mut far: BTreeMap<usize, f64> = panel.iter().map(|&f| (f, f64::INFINITY)).collect();
        // Distances are not negative, so their bits are in their order.
        let mut heap: BinaryHeap<Reverse<(u64, usize)>> =
            sources.iter().map(|&(f, d)| Reverse((d.to_bits(), f))).collect();
        while let Some(Reverse((bits, f))) = heap.pop() {
            let distance = f64::from_bits(bits);
            if far.get(&f).is_none_or(|known| *known <= distance) {
                continue;
            }
            far.insert(f, distance);
            for (k, beside) in self.folds.facets[f].beside.iter().enumerate() {
                if let Some((g, _)) = *beside
                    && far.contains_key(&g)
                {
                    let [a, b] = self.folds.edge(f, k);
                    let middle = [0, 1, 2].map(|i| 0.5 * (a[i] + b[i]));
                    let ways = [f, g].map(|x| self.way(less(middle, self.folds.facets[x].centre)));
                    heap.push(Reverse(((distance + ways[0] + ways[1]).to_bits(), g)));
                }
            }
        }
        far
    }

    fn way(&self, by: [f64; 3]) -> f64 {
        let along = dot(by, self.axis);
        let across = length([0, 1, 2].map(|i| by[i] - along * self.axis[i]));
        across + ALONG * along.abs()
    }

    /// The highest edge between a face that lies and one that does not: both, each with its edge.
    fn next(&self, placed: &BTreeMap<usize, (usize, Corners)>) -> Option<(usize, usize, usize, usize)> {
        let mut best: Option<(f64, (usize, usize, usize, usize))> = None;
        for &f in placed.keys() {
            for (k, beside) in self.folds.facets[f].beside.iter().enumerate() {
                let Some((g, j)) = *beside else { continue };
                let [a, b] = self.folds.edge(f, k);
                let height = a[2] + b[2];
                if !placed.contains_key(&g) && best.is_none_or(|(most, _)| height > most) {
                    best = Some((height, (f, k, g, j)));
                }
            }
        }
        best.map(|(_, found)| found)
    }
}

/// Where the third corner of a triangle lies, on the left of the way from the first to the second.
fn apex([p, q, r]: [[f64; 3]; 3], from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    let base = less(q, p);
    let side = less(r, p);
    let span = dot(base, base);
    let along = dot(side, base) / span;
    let height = length(cross(base, side)) / span;
    let way = [to[0] - from[0], to[1] - from[1]];
    [from[0] + along * way[0] - height * way[1], from[1] + along * way[1] + height * way[0]]
}

/// Moves every piece but the first below those before it.
fn apart(placed: &mut BTreeMap<usize, (usize, Corners)>, pieces: usize) {
    let mut lowest = f64::INFINITY;
    for piece in 0..pieces {
        let own = || placed.values().filter(|(p, _)| *p == piece).flat_map(|(_, corners)| corners);
        let low = own().map(|c| c[1]).fold(f64::INFINITY, f64::min);
        let high = own().map(|c| c[1]).fold(f64::NEG_INFINITY, f64::max);
        let by = if piece == 0 { 0.0 } else { lowest - 0.1 * (high - low) - high };
        for (_, corners) in placed.values_mut().filter(|(p, _)| *p == piece) {
            corners.iter_mut().for_each(|c| c[1] += by);
        }
        lowest = lowest.min(low + by);
    }
}
