//! The elements around each node of an interface, and which of them share a node.

use std::cmp::Reverse;
use std::collections::{BTreeSet, HashSet};
use std::ops::Range;

use super::{Joint, faces, meet};
use crate::topology::{all_faces, face_key, root};
use crate::{Face, Mesh};

/// The elements around each node of an interface.
pub(super) struct Around {
    /// Node and element, ascending.
    slots: Vec<(u32, u32)>,
    /// Faces of first sides that a slot's element has at its node.
    firsts: Vec<u32>,
    /// Slots that hang together as long as they are there, as trees.
    parent: Vec<u32>,
    /// Slots of a node that hang together while both are there, of elements that are there at different times.
    meetings: Vec<[u32; 2]>,
}

impl Around {
    pub fn new(mesh: &Mesh, found: &faces::Found, times: &[Range<u32>]) -> Self {
        let came_split: HashSet<Face> = found.apart.iter().flatten().copied().collect();
        let mut open = vec![false; mesh.nodes.len()];
        for &face in found.faces.iter().flatten().flatten().filter(|face| !came_split.contains(face)) {
            for node in mesh.face_nodes(face) {
                open[node as usize] = true;
            }
        }
        let mut slots = Vec::new();
        let mut elements = Vec::new();
        for (e, element) in (0..).zip(&mesh.elements).filter(|(e, _)| !times[*e as usize].is_empty()) {
            let before = slots.len();
            slots.extend(element.nodes().iter().filter(|&&n| open[n as usize]).map(|&n| (n, e)));
            if slots.len() > before {
                elements.push(e);
            }
        }
        slots.sort_unstable();
        let parent = (0..slots.len() as u32).collect();
        let mut around = Around { firsts: vec![0; slots.len()], slots, parent, meetings: Vec::new() };
        for &[first, _] in found.faces.iter().flatten() {
            for node in mesh.face_nodes(first).filter(|&n| open[n as usize]) {
                let slot = around.slot(node, first.element);
                around.firsts[slot as usize] += 1;
            }
        }
        let interface: HashSet<[Face; 2]> =
            found.faces.iter().flatten().map(|&pair| faces::sorted(pair)).collect();
        let near = |face: &Face| mesh.face_nodes(*face).any(|n| open[n as usize]);
        let mut keyed: Vec<([u32; 4], Face)> =
            all_faces(mesh, Some(&elements)).filter(near).map(|face| (face_key(mesh, face), face)).collect();
        keyed.sort_unstable();
        for same in keyed.chunk_by(|a, b| a.0 == b.0) {
            for (k, &(_, a)) in same.iter().enumerate() {
                for &(_, b) in same[k + 1..].iter().filter(|(_, b)| !interface.contains(&[a, *b])) {
                    let both = [a, b].map(|face| &times[face.element as usize]);
                    if meet(both[0], both[1]) {
                        for node in mesh.face_nodes(a).filter(|&n| open[n as usize]) {
                            around.join(node, [a.element, b.element], both[0] == both[1]);
                        }
                    }
                }
            }
        }
        around
    }

    /// Place of a node and an element that are in the list.
    fn slot(&self, node: u32, element: u32) -> u32 {
        self.slots.partition_point(|&slot| slot < (node, element)) as u32
    }

    fn join(&mut self, node: u32, elements: [u32; 2], always: bool) {
        let slots = elements.map(|e| self.slot(node, e));
        if always {
            self.unite(slots);
        } else {
            self.meetings.push(slots);
        }
    }

    fn unite(&mut self, slots: [u32; 2]) {
        let [a, b] = slots.map(|slot| root(&mut self.parent, slot));
        self.parent[a.max(b) as usize] = a.min(b);
    }

    /// Gives every component but one of each node a copy, and says of which node it is one. Which of them move as one for a
    /// time is what is left.
    pub fn copy_nodes(mut self, mesh: &mut Mesh, times: &[Range<u32>], origin: &mut Vec<u32>) -> Vec<Joint> {
        self.meetings.sort_unstable();
        let meetings = std::mem::take(&mut self.meetings);
        let mut left: Vec<[u32; 2]> = Vec::new();
        let mut node_of: Vec<u32> = self.slots.iter().map(|slot| slot.0).collect();
        let (mut start, mut next) = (0, 0);
        while let Some(&(node, _)) = self.slots.get(start) {
            let end = start + self.slots[start..].partition_point(|slot| slot.0 == node);
            let count = meetings[next..].partition_point(|slots| (slots[0] as usize) < end);
            self.hold(start..end, &meetings[next..next + count], times, &mut left);
            next += count;
            let roots: Vec<u32> = (start..end).map(|s| root(&mut self.parent, s as u32)).collect();
            let components: BTreeSet<u32> = roots.iter().copied().collect();
            let own = |component: u32| {
                (start..end).filter(|slot| roots[slot - start] == component).collect::<Vec<usize>>()
            };
            // Of what is there in the end, if anything is: what other things name by the file's nodes is then there.
            let rank = |component: &u32| {
                let own = own(*component);
                let last = own.iter().map(|&slot| times[self.slots[slot].1 as usize].end).max();
                let smallest = own.iter().find(|&&slot| Some(times[self.slots[slot].1 as usize].end) == last);
                (Reverse(last), own.iter().map(|&slot| self.firsts[slot]).sum::<u32>(), smallest.copied())
            };
            let keeper = components.iter().copied().min_by_key(rank);
            for component in components.into_iter().filter(|c| Some(*c) != keeper) {
                let copy = mesh.nodes.len() as u32;
                mesh.nodes.push(mesh.nodes[node as usize]);
                origin.push(node);
                for slot in own(component) {
                    node_of[slot] = copy;
                    // The unused tail of an element's nodes repeats the last of them.
                    for own in &mut mesh.elements[self.slots[slot].1 as usize].nodes {
                        *own = if *own == node { copy } else { *own };
                    }
                }
            }
            start = end;
        }
        let mut known: HashSet<([u32; 2], Range<u32>)> = HashSet::new();
        let joint = |slots: [u32; 2]| {
            let mut both = slots.map(|slot| (node_of[slot as usize], self.slots[slot as usize].1));
            both.sort_unstable();
            let (nodes, elements) = (both.map(|b| b.0), both.map(|b| b.1));
            let [a, b] = elements.map(|e| &times[e as usize]);
            let common = a.start.max(b.start)..a.end.min(b.end);
            (nodes[0] != nodes[1] && known.insert((nodes, common))).then_some(Joint { nodes, elements })
        };
        left.into_iter().filter_map(joint).collect()
    }

    /// Unites components of a node that meet, where that leaves no two of them together at a time at which nothing holds them:
    /// all that hang together at some time, or else those of them that are there in the end. The meetings of the others are left.
    fn hold(
        &mut self,
        slots: Range<usize>,
        meetings: &[[u32; 2]],
        times: &[Range<u32>],
        left: &mut Vec<[u32; 2]>,
    ) {
        if meetings.is_empty() {
            return;
        }
        let first = slots.start;
        let of: Vec<usize> = slots.map(|s| root(&mut self.parent, s as u32) as usize - first).collect();
        let time = |component: usize| &times[self.slots[first + component].1 as usize];
        let edge = |pair: &[u32; 2]| pair.map(|slot| of[slot as usize - first]);
        let edges: BTreeSet<[usize; 2]> = meetings.iter().map(edge).collect();
        let members: BTreeSet<usize> = edges.iter().flatten().copied().collect();
        let end = members.iter().map(|&m| time(m).end).max();
        let lasts = |m: &usize| Some(time(*m).end) == end;
        let whole = trees(of.len(), edges.iter().copied());
        let lasting = trees(of.len(), edges.iter().copied().filter(|edge| edge.iter().all(lasts)));
        let (mut parted, mut parted_lasting) = (BTreeSet::new(), BTreeSet::new());
        // What hangs together changes where a component comes or goes.
        let changes: BTreeSet<u32> = members.iter().flat_map(|&m| [time(m).start, time(m).end]).collect();
        for now in changes {
            let there: Vec<usize> = members.iter().copied().filter(|&m| time(m).contains(&now)).collect();
            let both = |edge: &[usize; 2]| edge.iter().all(|m| there.contains(m));
            let held = trees(of.len(), edges.iter().copied().filter(both));
            for &a in &there {
                for &b in there.iter().filter(|&&b| held[b] != held[a]) {
                    if whole[a] == whole[b] {
                        parted.insert(whole[a]);
                    }
                    if lasting[a] == lasting[b] {
                        parted_lasting.insert(lasting[a]);
                    }
                }
            }
        }
        for pair in meetings {
            let [a, b] = edge(pair);
            if !parted.contains(&whole[a]) {
                self.unite(*pair);
                continue;
            }
            left.push(*pair);
            if lasting[a] == lasting[b] && !parted_lasting.contains(&lasting[a]) {
                self.unite(*pair);
            }
        }
    }
}

/// The root of each of some numbers, where edges join them.
fn trees(count: usize, edges: impl Iterator<Item = [usize; 2]>) -> Vec<usize> {
    let mut parent: Vec<u32> = (0..count as u32).collect();
    for edge in edges {
        let [a, b] = edge.map(|k| root(&mut parent, k as u32));
        parent[a.max(b) as usize] = a.min(b);
    }
    (0..count as u32).map(|k| root(&mut parent, k) as usize).collect()
}
