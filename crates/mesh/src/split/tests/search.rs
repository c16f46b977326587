//! Components compared with a search of all elements around each node.

use super::*;
use crate::sample::Random;

/// Bodies 0, 1 and 2 by element, and 3 for what is not there; interfaces between 1 and the others.
struct Mixed {
    mesh: Mesh,
    body: Vec<usize>,
}

impl Mixed {
    fn there(&self, e: usize) -> bool {
        self.body[e] < 3
    }

    fn apart(&self, a: usize, b: usize) -> bool {
        self.body[a] != self.body[b] && (self.body[a] == 1 || self.body[b] == 1)
    }

    fn has(&self, e: usize, node: u32) -> bool {
        self.mesh.elements[e].nodes().contains(&node)
    }

    /// Whether two elements share a face.
    fn touch(&self, a: usize, b: usize) -> bool {
        a != b && self.mesh.elements[a].nodes().iter().filter(|&&n| self.has(b, n)).count() == 4
    }

    /// Whether two of the elements at a node meet across an interface, of those that meet at all.
    fn opens(&self, node: u32, meet: impl Fn(usize, usize) -> bool) -> bool {
        let around: Vec<usize> =
            (0..self.body.len()).filter(|&e| self.there(e) && self.has(e, node)).collect();
        let interface = |a, b| self.touch(a, b) && self.apart(a, b) && meet(a, b);
        around.iter().any(|&a| around.iter().any(|&b| interface(a, b)))
    }

    /// The components at a node of some elements; all in one if it is on no interface.
    fn components(&self, node: u32, on: bool, of: impl Fn(usize) -> bool) -> Vec<Vec<usize>> {
        let around: Vec<usize> =
            (0..self.body.len()).filter(|&e| self.there(e) && of(e) && self.has(e, node)).collect();
        let mut left = around.clone();
        let mut groups = Vec::new();
        while let (true, Some(first)) = (on, left.pop()) {
            let mut group = vec![first];
            let mut next = 0;
            while let Some(&own) = group.get(next) {
                let tied = |&&e: &&usize| self.touch(own, e) && !self.apart(own, e);
                group.extend(left.iter().filter(tied));
                left.retain(|e| !group.contains(e));
                next += 1;
            }
            group.sort_unstable();
            groups.push(group);
        }
        if groups.is_empty() && !around.is_empty() {
            groups.push(around);
        }
        groups
    }
}

/// Many of the bodies touch along edges only, and interfaces end where 0 and 2 hang together.
#[test]
fn components_are_those_of_a_search_around_each_node() {
    let mut random = Random(11);
    let mesh = Mesh { node_ids: (0..125).map(|n| 1000 - n).collect(), ..grid([4, 4, 4]) };
    for _ in 0..20 {
        let mixed = Mixed { body: (0..64).map(|_| random.below(4)).collect(), mesh: mesh.clone() };
        let of = |k: usize| (0..64).filter(|&e| mixed.body[e as usize] == k).collect::<Vec<u32>>();
        let bodies = [of(0), of(1), of(2)];
        let there: Vec<bool> = (0..64).map(|e| mixed.there(e)).collect();
        let cuts = [cut("01", &bodies[0], &bodies[1]), cut("12", &bodies[1], &bodies[2])];
        let (mesh, split) = checked(&mixed.mesh, &cuts, &there);
        for node in 0..125 {
            let groups = mixed.components(node, mixed.opens(node, |_, _| true), |_| true);
            let own = |e: usize| {
                let nodes = mesh.elements[e].nodes().iter().copied();
                nodes.into_iter().find(|&n| split.origin[n as usize] == node).expect("a copy")
            };
            assert!(groups.iter().all(|g| g.windows(2).all(|w| own(w[0]) == own(w[1]))), "one a component");
            let nodes: HashSet<u32> = groups.iter().map(|group| own(group[0])).collect();
            assert_eq!(nodes.len(), groups.len(), "node {node}");

            let at_node = |f: &&[Face; 2]| f.iter().all(|f| mixed.has(f.element as usize, node));
            let firsts = |group: &Vec<usize>| {
                let faces = split.faces.iter().flatten().filter(at_node);
                faces.filter(|f| group.contains(&(f[0].element as usize))).count()
            };
            let keeper = groups.iter().min_by_key(|group| (firsts(group), group[0]));
            assert!(keeper.is_none_or(|group| own(group[0]) == node), "node {node}");
        }
    }
}

/// Rock that comes and goes at random: at each time what then hangs together has one node, or nodes that then move as one.
#[test]
fn at_each_time_what_hangs_together_then_moves_as_one() {
    const TIMES: u32 = 3;
    let mut random = Random(23);
    let mesh = grid([4, 4, 4]);
    let mut rims = 0;
    for _ in 0..20 {
        let mixed = Mixed { body: (0..64).map(|_| random.below(4)).collect(), mesh: mesh.clone() };
        let mut time = |e: usize| {
            let [a, b] = [0, 1].map(|_| random.below(TIMES as usize + 1) as u32);
            let whole = random.below(2) == 0 || a == b;
            if !mixed.there(e) {
                0..0
            } else if whole {
                0..TIMES
            } else {
                a.min(b)..a.max(b)
            }
        };
        let times: Vec<Range<u32>> = (0..64).map(&mut time).collect();
        let of = |k: usize| (0..64).filter(|&e| mixed.body[e as usize] == k).collect::<Vec<u32>>();
        let bodies = [of(0), of(1), of(2)];
        let cuts = [cut("01", &bodies[0], &bodies[1]), cut("12", &bodies[1], &bodies[2])];
        let mut mesh = mixed.mesh.clone();
        let split = split(&mut mesh, &cuts, &times).expect("it splits");
        rims += split.joints.len();
        for node in 0..125 {
            let opens = mixed.opens(node, |a, b| meet(&times[a], &times[b]));
            for now in 0..TIMES {
                let there = |e: usize| times[e].contains(&now);
                let mut parent: Vec<u32> = (0..mesh.nodes.len() as u32).collect();
                for joint in
                    split.joints.iter().filter(|joint| joint.elements.iter().all(|&e| there(e as usize)))
                {
                    let [a, b] = joint.nodes.map(|n| crate::topology::root(&mut parent, n));
                    parent[a.max(b) as usize] = a.min(b);
                }
                let mut own = |e: usize| {
                    let nodes = mesh.elements[e].nodes().iter().copied();
                    let node = nodes.into_iter().find(|&n| split.origin[n as usize] == node).expect("a copy");
                    crate::topology::root(&mut parent, node)
                };
                let groups = mixed.components(node, opens, there);
                assert!(
                    groups.iter().all(|g| g.windows(2).all(|w| own(w[0]) == own(w[1]))),
                    "one a component"
                );
                let nodes: HashSet<u32> = groups.iter().map(|group| own(group[0])).collect();
                assert_eq!(nodes.len(), groups.len(), "node {node} at {now}");
            }
        }
    }
    assert!(rims > 300, "{rims}");
}
