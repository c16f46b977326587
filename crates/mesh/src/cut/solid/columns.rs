//! Nodes through the thickness of thin elements, which a plane in space takes together.
//!
//! Linings, and the slices of rock in their continuation, are much thinner than long. Nodes of their one face that move by half an element, while
//! those of the other stay, would fold them. So the plane takes or leaves the nodes through a thickness together, by the side of one of them.

use std::collections::{BTreeMap, HashMap};

use crate::topology::{minus, norm};
use crate::{Mesh, Shape};

/// A lining is thin if its thickness is less than this share of its other edges.
const THIN: f64 = 0.5;
/// Any element is, along an edge that is less than this share of its longest.
const SLICE: f64 = 0.15;

/// For each node of thin elements the one that stands for it: of linings and shotcrete, which are `flagged`, at their outer face. None of itself.
pub(super) fn leads(mesh: &Mesh, flagged: &[bool]) -> HashMap<u32, u32> {
    let mut across = Sets::default();
    let mut bodies = Sets::default();
    for (element, flagged) in mesh.elements.iter().zip(flagged) {
        let nodes = element.nodes();
        if *flagged {
            nodes.iter().for_each(|n| bodies.join(nodes[0], *n));
        }
        let families: &[&[[usize; 2]]] = match element.shape {
            Shape::Hex8 => &[
                &[[0, 1], [3, 2], [4, 5], [7, 6]],
                &[[1, 2], [0, 3], [5, 6], [4, 7]],
                &[[0, 4], [1, 5], [2, 6], [3, 7]],
            ],
            Shape::Wedge6 => &[&[[0, 3], [1, 4], [2, 5]], &[[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3]]],
            Shape::Pyramid5 | Shape::Tet4 => continue,
        };
        let length =
            |[a, b]: &[usize; 2]| norm(minus(mesh.nodes[nodes[*a] as usize], mesh.nodes[nodes[*b] as usize]));
        let mean = |family: &&[[usize; 2]]| family.iter().map(length).sum::<f64>() / family.len() as f64;
        let means: Vec<f64> = families.iter().map(mean).collect();
        let longest = means.iter().copied().fold(0.0, f64::max);
        // Of a wedge only the height is one direction.
        let directions = if element.shape == Shape::Hex8 { means.len() } else { 1 };
        for k in 0..directions {
            let thinnest = (0..means.len()).all(|j| j == k || means[k] < THIN * means[j]);
            if means[k] < SLICE * longest || (*flagged && thinnest) {
                families[k].iter().for_each(|[a, b]| across.join(nodes[*a], nodes[*b]));
            }
        }
    }
    let mut middles: BTreeMap<u32, ([f64; 3], f64)> = BTreeMap::new();
    for n in bodies.all() {
        let (sum, count) = middles.entry(bodies.find(n)).or_default();
        (0..3).for_each(|i| sum[i] += mesh.nodes[n as usize][i]);
        *count += 1.0;
    }
    // Of a lining the outer one is farthest from the middle of all that hangs together with it.
    let far = |n: u32, body: Option<u32>| {
        let middle = body.and_then(|body| middles.get(&body));
        middle.map_or(0.0, |(sum, count)| norm(minus(mesh.nodes[n as usize], sum.map(|s| s / count))))
    };
    let mut outer: BTreeMap<u32, (f64, u32)> = BTreeMap::new();
    let members = across.all();
    for &n in &members {
        let body = bodies.has(n).then(|| bodies.find(n));
        let at = (far(n, body), n);
        let best = outer.entry(across.find(n)).or_insert(at);
        if at.0 > best.0 {
            *best = at;
        }
    }
    members.iter().map(|&n| (n, outer[&across.find(n)].1)).filter(|(n, lead)| n != lead).collect()
}

/// Sets of nodes that are joined.
#[derive(Default)]
struct Sets {
    up: BTreeMap<u32, u32>,
}

impl Sets {
    fn find(&mut self, n: u32) -> u32 {
        let mut at = n;
        while let Some(&up) = self.up.get(&at).filter(|up| **up != at) {
            at = up;
        }
        self.up.insert(n, at);
        at
    }

    fn has(&self, n: u32) -> bool {
        self.up.contains_key(&n)
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.find(a), self.find(b));
        self.up.insert(a.max(b), a.min(b));
    }

    fn all(&self) -> Vec<u32> {
        self.up.keys().copied().collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boxes::{Axis, BoxSpec};

    #[test]
    fn nodes_through_a_lining_go_by_its_outer_face() {
        // A ring of thin elements round a hall: the border of a box of 5 × 1 × 5 whose outer cells are thin.
        let x = Axis::Coordinates(vec![0.0, 0.3, 2.0, 4.0, 5.7, 6.0]);
        let spec = BoxSpec { x: x.clone(), y: Axis::uniform(0.0, 2.0, 1), z: x, distortion: None };
        let mesh = spec.mesh().unwrap_or_else(|e| panic!("{e}"));
        let whole: Vec<bool> =
            (0..25).map(|e| [0, 4].contains(&(e % 5)) || [0, 4].contains(&(e / 5))).collect();
        let leads = leads(&mesh, &whole);
        for (n, lead) in &leads {
            let [a, b] = [n, lead].map(|n| mesh.nodes[*n as usize]);
            assert!([a[0], a[2]].iter().any(|c| [0.3, 5.7].contains(c)), "{a:?}");
            assert!([b[0], b[2]].iter().any(|c| [0.0, 6.0].contains(c)), "{b:?}");
            assert!(norm(minus(a, b)) < 0.5);
        }
        // Two rows of y, twelve inner nodes; those at corners belong to elements that are thin two ways.
        assert!(leads.len() >= 16, "{}", leads.len());
        // Without a lining only what is very thin counts, and 0.5 of 2 m is not.
        let x = Axis::Coordinates(vec![0.0, 0.5, 2.0, 4.0, 5.5, 6.0]);
        let spec = BoxSpec { x: x.clone(), y: Axis::uniform(0.0, 2.0, 1), z: x, distortion: None };
        let mesh = spec.mesh().unwrap_or_else(|e| panic!("{e}"));
        assert!(super::leads(&mesh, &[false; 25]).is_empty());
    }
}
