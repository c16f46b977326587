//! Which faces hang together, and how they are folded.

use std::collections::{BTreeMap, HashMap};

use super::{cross, dot, length, less, unit};

/// A face and one of its edges, that from its corner k to k + 1.
pub type FaceSide = (usize, usize);

/// A face with its neighbours.
pub struct Facet {
    /// Which of the faces given, and its points, against the clock when its normal points at the reader.
    pub face: usize,
    pub points: Vec<u32>,
    /// The same as places.
    pub nodes: Vec<usize>,
    pub normal: [f64; 3],
    pub centre: [f64; 3],
    /// For each edge, from corner k to k + 1: the face beside it and which of its edges that is.
    pub beside: Vec<Option<FaceSide>>,
}

/// The faces of a surface.
pub struct Folds {
    pub places: Vec<[f64; 3]>,
    pub facets: Vec<Facet>,
}

impl Folds {
    pub fn of(points: &[[f64; 3]], normals: &[[f64; 3]], faces: &[Vec<u32>]) -> Self {
        let (places, place_of) = places(points);
        let facet = |(face, own): (usize, &Vec<u32>)| facet(&places, &place_of, normals, face, own);
        let facets: Vec<Facet> = faces.iter().enumerate().filter_map(facet).collect();
        let mut folds = Folds { places, facets };
        folds.join();
        folds
    }

    /// Joins faces that run along an edge in opposite senses; of more than two at an edge first those that go on
    /// straightest.
    fn join(&mut self) {
        // By ends of the edge: faces with their edges that run along it there and back.
        let mut at: BTreeMap<(usize, usize), [Vec<FaceSide>; 2]> = BTreeMap::new();
        for (f, facet) in self.facets.iter().enumerate() {
            let n = facet.nodes.len();
            for k in 0..n {
                let (a, b) = (facet.nodes[k], facet.nodes[(k + 1) % n]);
                at.entry((a.min(b), a.max(b))).or_default()[usize::from(a > b)].push((f, k));
            }
        }
        for [there, back] in at.values() {
            let mut all: Vec<_> = there.iter().flat_map(|&x| back.iter().map(move |&y| (x, y))).collect();
            all.sort_by(|(x, y), (s, t)| self.angle(x.0, y.0).total_cmp(&self.angle(s.0, t.0)));
            for ((f, k), (g, j)) in all {
                if f != g && self.facets[f].beside[k].is_none() && self.facets[g].beside[j].is_none() {
                    self.facets[f].beside[k] = Some((g, j));
                    self.facets[g].beside[j] = Some((f, k));
                }
            }
        }
    }

    /// Angle between the normals of two faces.
    pub fn angle(&self, f: usize, g: usize) -> f64 {
        dot(self.facets[f].normal, self.facets[g].normal).clamp(-1.0, 1.0).acos()
    }

    /// Ends of an edge of a face.
    pub fn edge(&self, f: usize, k: usize) -> [[f64; 3]; 2] {
        let nodes = &self.facets[f].nodes;
        [self.places[nodes[k]], self.places[nodes[(k + 1) % nodes.len()]]]
    }

    /// Faces that hang together, in their order.
    pub fn components(&self) -> Vec<Vec<usize>> {
        self.parts(&(0..self.facets.len()).collect::<Vec<_>>(), |_, _| true)
    }

    /// The parts into which faces fall if only some neighbours count.
    pub fn parts(&self, own: &[usize], joined: impl Fn(usize, usize) -> bool) -> Vec<Vec<usize>> {
        let mut left = vec![false; self.facets.len()];
        own.iter().for_each(|&f| left[f] = true);
        let mut parts = Vec::new();
        for &first in own {
            if !std::mem::take(&mut left[first]) {
                continue;
            }
            let mut part = vec![first];
            let mut k = 0;
            while let Some(&f) = part.get(k) {
                k += 1;
                for &(g, _) in self.facets[f].beside.iter().flatten() {
                    if left[g] && joined(f, g) {
                        left[g] = false;
                        part.push(g);
                    }
                }
            }
            part.sort_unstable();
            parts.push(part);
        }
        parts
    }

    /// The common direction of the folds: that of the largest moment of edges, each weighted by its angle. A surface that
    /// is flat to 20° has none: its strike, or y where it lies level.
    pub fn axis(&self, own: &[usize]) -> [f64; 3] {
        let mut moment = [[0.0; 3]; 3];
        for &f in own {
            for (k, beside) in self.facets[f].beside.iter().enumerate() {
                let Some((g, _)) = *beside else { continue };
                let [a, b] = self.edge(f, k);
                if let (true, Some(e)) = (g > f, unit(less(b, a))) {
                    let weight = length(less(b, a)) * self.angle(f, g);
                    for i in 0..3 {
                        for j in 0..3 {
                            moment[i][j] += weight * e[i] * e[j];
                        }
                    }
                }
            }
        }
        let mean = self.mean_normal(own);
        let flat = own.iter().all(|&f| dot(self.facets[f].normal, mean) > 10_f64.to_radians().cos());
        let strike = unit([-mean[1], mean[0], 0.0]).filter(|_| mean[0].hypot(mean[1]) > 1e-6);
        let found = if flat { strike } else { principal(moment) };
        let mut axis = found.unwrap_or([0.0, 1.0, 0.0]);
        let large = (0..3).max_by(|&i, &j| axis[i].abs().total_cmp(&axis[j].abs())).unwrap_or(1);
        // A plane is drawn with its dip upwards, anything else with its axis forwards.
        let back = if flat { dot(cross(mean, axis), [0.0, 0.0, 1.0]) < -1e-9 } else { axis[large] < 0.0 };
        if back {
            axis = axis.map(|c| -c);
        }
        axis
    }

    pub fn mean_normal(&self, own: &[usize]) -> [f64; 3] {
        let sum = own.iter().fold([0.0; 3], |sum, &f| [0, 1, 2].map(|i| sum[i] + self.facets[f].normal[i]));
        unit(sum).unwrap_or([0.0, 0.0, 1.0])
    }
}

/// The different places of points, and which each point has. Points closer than 10⁻⁷ of the whole are at one place, as
/// round-off leaves them.
fn places(points: &[[f64; 3]]) -> (Vec<[f64; 3]>, Vec<usize>) {
    let mut low = [f64::INFINITY; 3];
    let mut high = [f64::NEG_INFINITY; 3];
    for p in points {
        for i in 0..3 {
            (low[i], high[i]) = (low[i].min(p[i]), high[i].max(p[i]));
        }
    }
    let grain = (1e-7 * length(less(high, low))).max(f64::MIN_POSITIVE);
    let cell = |p: &[f64; 3]| [0, 1, 2].map(|i| ((p[i] - low[i]) / grain).round() as i64);
    let mut known: HashMap<[i64; 3], usize> = HashMap::new();
    let mut places = Vec::new();
    let mut place_of = Vec::with_capacity(points.len());
    for p in points {
        let at = cell(p);
        // A point beside the border of two cells may be in the other one.
        let near = (0..27).map(|k| [at[0] + k % 3 - 1, at[1] + k / 3 % 3 - 1, at[2] + k / 9 - 1]);
        let place = near.filter_map(|key| known.get(&key).copied()).next().unwrap_or_else(|| {
            known.insert(at, places.len());
            places.push(*p);
            places.len() - 1
        });
        place_of.push(place);
    }
    (places, place_of)
}

fn facet(
    places: &[[f64; 3]],
    place_of: &[usize],
    normals: &[[f64; 3]],
    face: usize,
    own: &[u32],
) -> Option<Facet> {
    let mut points: Vec<u32> = own.to_vec();
    points.dedup_by_key(|p| place_of[*p as usize]);
    if points.len() > 1 && place_of[points[0] as usize] == place_of[points[points.len() - 1] as usize] {
        points.pop();
    }
    if points.len() < 3 {
        return None;
    }
    let place = |p: &u32| places[place_of[*p as usize]];
    let first = place(&points[0]);
    let mut area = [0.0; 3];
    for pair in points[1..].windows(2) {
        let part = cross(less(place(&pair[0]), first), less(place(&pair[1]), first));
        area = [0, 1, 2].map(|i| area[i] + part[i]);
    }
    let mut normal = unit(area)?;
    let out = points.iter().fold([0.0; 3], |s, &p| [0, 1, 2].map(|i| s[i] + normals[p as usize][i]));
    if dot(normal, out) < 0.0 {
        points.reverse();
        normal = normal.map(|c| -c);
    }
    let number = points.len() as f64;
    let centre = [0, 1, 2].map(|i| points.iter().map(|p| place(p)[i]).sum::<f64>() / number);
    let nodes: Vec<usize> = points.iter().map(|p| place_of[*p as usize]).collect();
    let beside = vec![None; points.len()];
    Some(Facet { face, points, nodes, normal, centre, beside })
}

/// Direction of the largest moment of a symmetric matrix; y, or else x, where several are equal.
fn principal(mut m: [[f64; 3]; 3]) -> Option<[f64; 3]> {
    // Squaring leaves the largest alone: 2³⁰ products.
    for _ in 0..30 {
        let trace = m[0][0] + m[1][1] + m[2][2];
        if trace.is_nan() || trace <= 0.0 {
            return None;
        }
        let a = m.map(|row| row.map(|x| x / trace));
        m = [0, 1, 2].map(|i| [0, 1, 2].map(|j| (0..3).map(|k| a[i][k] * a[k][j]).sum()));
    }
    let mut best = [0.0; 3];
    for column in [m[1], m[0], m[2]] {
        if length(column) > (1.0 + 1e-6) * length(best) {
            best = column;
        }
    }
    unit(best)
}
