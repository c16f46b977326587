//! Rims: where an interface meets what goes or comes while other things stay.
//!
//! At such a node elements that are there in the same stages and hang together have a copy of their own
//! ([`tremolite_mesh::split`]). While what holds two copies together stands they move as one, increment by increment; so sides that
//! have slipped keep their offset where a lining joins them. A pair of an interface is there while both its sides stand and its
//! nodes are free of each other.

use crate::life::{Life, Stage};
use std::collections::{BTreeMap, BTreeSet};

/// Copies of a node that move as one while both of what has them stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Joint {
    /// Nodes of the mesh.
    pub nodes: [u32; 2],
    pub life: Life,
}

/// Which copies move as one, stage by stage.
#[derive(Clone, Debug, Default)]
pub struct Rims {
    /// Stages from which on it is as it is until the next, ascending, with the smallest copy that moves as one with each.
    roots: BTreeMap<Stage, BTreeMap<u32, u32>>,
}

/// When a pair is there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Spell {
    /// From where its nodes are free of each other for the first time to where they are for the last. One that is held in between
    /// does nothing there, since its nodes move alike.
    pub life: Life,
    /// Whether both its sides stood before, held together.
    pub freed: bool,
}

impl Rims {
    pub fn of(joints: &[Joint]) -> Self {
        let changes: BTreeSet<Stage> =
            joints.iter().flat_map(|joint| [Some(joint.life.born), joint.life.gone]).flatten().collect();
        let roots = |stage: Stage| {
            let mut roots: BTreeMap<u32, u32> = BTreeMap::new();
            for joint in joints.iter().filter(|joint| joint.life.holds(stage)) {
                let [a, b] = joint.nodes.map(|n| root(&roots, n));
                roots.insert(a.max(b), a.min(b));
                roots.entry(a.min(b)).or_insert(a.min(b));
            }
            let nodes: Vec<u32> = roots.keys().copied().collect();
            nodes.into_iter().map(|n| (n, root(&roots, n))).collect()
        };
        Rims { roots: changes.into_iter().map(|stage| (stage, roots(stage))).collect() }
    }

    /// A copy that stands for all that move as one with it in a stage.
    pub fn root(&self, stage: Stage, node: u32) -> u32 {
        let now = self.roots.range(..=stage).next_back();
        now.and_then(|(_, roots)| roots.get(&node)).copied().unwrap_or(node)
    }

    /// Whether two copies are one, or move as one, in a stage.
    pub fn held(&self, stage: Stage, [a, b]: [u32; 2]) -> bool {
        a == b || self.root(stage, a) == self.root(stage, b)
    }

    /// The stages of a life from which on it differs what moves as one.
    fn stages(&self, life: Life) -> impl Iterator<Item = Stage> + '_ {
        let later = self.roots.keys().copied().filter(move |&stage| stage > life.born && life.holds(stage));
        std::iter::once(life.born).chain(later)
    }

    /// Whether two copies move as one as long as this lasts.
    pub fn always_held(&self, life: Life, nodes: [u32; 2]) -> bool {
        self.stages(life).all(|stage| self.held(stage, nodes))
    }

    /// When a pair is there whose sides both stand in `life`; never, if something holds its nodes together all the time.
    pub fn spell(&self, life: Life, nodes: [u32; 2]) -> Option<Spell> {
        let stages: Vec<Stage> = self.stages(life).collect();
        let free = |stage: &Stage| !self.held(*stage, nodes);
        let first = stages.iter().position(free)?;
        let last = stages.iter().rposition(free)?;
        let gone = stages.get(last + 1).copied().or(life.gone);
        Some(Spell { life: Life { born: stages[first], gone }, freed: first > 0 })
    }
}

fn root(roots: &BTreeMap<u32, u32>, mut node: u32) -> u32 {
    while let Some(&above) = roots.get(&node).filter(|&&above| above != node) {
        node = above;
    }
    node
}

#[cfg(test)]
mod tests {
    use super::*;

    fn life(born: u16, gone: Option<u16>) -> Life {
        Life { born: Stage::Before(born), gone: gone.map(Stage::Before) }
    }

    /// Rock that goes with stage 2 holds both sides, and so does a lining that comes with stage 4.
    #[test]
    fn a_pair_at_a_rim_is_there_between_the_rock_that_goes_and_the_lining_that_comes() {
        let joint = |nodes, life| Joint { nodes, life };
        let rock = [joint([1, 7], life(0, Some(2))), joint([2, 7], life(0, Some(2)))];
        let lining = [joint([1, 9], life(4, None)), joint([2, 9], life(4, None))];
        let rims = Rims::of(&[rock, lining].concat());
        let held = |k: u16| rims.held(Stage::Before(k), [1, 2]);
        assert_eq!([0, 1, 2, 3, 4, 5].map(held), [true, true, false, false, true, true]);
        assert!(rims.held(Stage::Shaking, [1, 2]) && !rims.held(Stage::Before(3), [1, 9]));
        let spell = |own: Life| rims.spell(own, [1, 2]);
        assert_eq!(spell(Life::ALWAYS), Some(Spell { life: life(2, Some(4)), freed: true }));
        assert_eq!(spell(life(3, None)), Some(Spell { life: life(3, Some(4)), freed: false }));
        assert_eq!(spell(life(0, Some(2))), None);
        assert_eq!(rims.spell(Life::ALWAYS, [1, 3]), Some(Spell { life: Life::ALWAYS, freed: false }));
        // A support that is taken out again: there from the rock's end to the very end.
        let prop = [joint([1, 9], life(4, Some(6))), joint([2, 9], life(4, Some(6)))];
        let rims = Rims::of(&[rock, prop].concat());
        let spell = rims.spell(Life::ALWAYS, [1, 2]);
        assert_eq!(spell, Some(Spell { life: life(2, None), freed: true }));
        assert!(rims.always_held(life(4, Some(6)), [1, 2]) && !rims.always_held(life(4, None), [1, 2]));
    }
}
