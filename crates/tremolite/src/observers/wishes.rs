//! What all observers of a stage or of the shaking want together: what the first of several ranks is shown.

use super::observer::{Schedule, Wants, Which};
use tremolite_engine::model::Model;
use tremolite_engine::phase::Phase;
use tremolite_engine::ranks::{Marks, Wanted};

/// What some observers want to be shown in the same looks.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
struct Wish {
    nodes: Which,
    elements: Which,
    histories: Which,
    members: Which,
    /// Whether they read what others keep by node and element.
    kept: bool,
}

impl Wish {
    fn of(wants: &Wants) -> Self {
        let Wants { nodes, elements, histories, members, reads_kept, .. } = wants.clone();
        Wish { nodes, elements, histories, members, kept: reads_kept }
    }

    fn and(self, other: &Wish) -> Self {
        Wish {
            nodes: self.nodes.and(&other.nodes),
            elements: self.elements.and(&other.elements),
            histories: self.histories.and(&other.histories),
            members: self.members.and(&other.members),
            kept: self.kept || other.kept,
        }
    }

    fn put(&self, counts: &mut Vec<u64>) {
        for which in [&self.nodes, &self.elements, &self.histories, &self.members] {
            put(which, counts);
        }
        counts.push(self.kept.into());
    }

    fn take(counts: &mut &[u64]) -> Option<Self> {
        let [nodes, elements, histories, members] =
            [take(counts)?, take(counts)?, take(counts)?, take(counts)?];
        Some(Wish { nodes, elements, histories, members, kept: next(counts)? > 0 })
    }

    /// In blocks of nodes and members of a phase that all ranks have together.
    fn wanted(&self, model: &Model, phase: &Phase) -> Wanted {
        let mut wanted = Wanted::default();
        match &self.nodes {
            Which::Nothing => {}
            Which::Some(nodes) => {
                let block =
                    |n: u32| model.nodes.blocks.partition_point(|block| block.nodes.end <= n as usize);
                nodes.iter().for_each(|&n| wanted.blocks.mark(block(n)));
            }
            Which::All => wanted.blocks = Marks::All,
        }
        let of_elements = |which: &Which, marks: &mut Marks| {
            let slots = phase.element_slot.iter().enumerate().filter(|(e, _)| which.has(*e));
            slots.filter_map(|(_, slot)| slot.as_ref()).for_each(|slot| marks.mark(slot.member as usize));
        };
        of_elements(&self.elements, &mut wanted.members);
        of_elements(&self.histories, &mut wanted.histories);
        match &self.members {
            Which::Nothing => {}
            Which::Some(members) => members.iter().for_each(|&m| wanted.members.mark(m as usize)),
            Which::All => wanted.members = Marks::All,
        }
        wanted
    }
}

/// What the observers of a stage or of the shaking want, and when; the same on all ranks.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Wishes {
    looks: Vec<(Schedule, Wish)>,
    /// Of those who glance.
    glances: Option<Wish>,
    /// Engine nodes of whose motion somebody is told in every step.
    pub steps: Which,
}

impl Wishes {
    pub fn of<'w>(all: impl Iterator<Item = &'w Wants>) -> Self {
        let mut wishes = Wishes::default();
        for wants in all {
            let wish = Wish::of(wants);
            if let Some(schedule) = wants.looks {
                wishes.looks_too(schedule, &wish);
            }
            if wants.glances {
                wishes.glances = Some(wishes.glances.take().unwrap_or_default().and(&wish));
            }
            wishes.steps = std::mem::take(&mut wishes.steps).and(&wants.steps);
        }
        wishes
    }

    fn looks_too(&mut self, schedule: Schedule, wish: &Wish) {
        match self.looks.iter_mut().find(|(other, _)| *other == schedule) {
            Some((_, own)) => *own = std::mem::take(own).and(wish),
            None => self.looks.push((schedule, wish.clone())),
        }
    }

    /// Adds that somebody looks who wants to be shown nothing of other ranks.
    pub fn looks_itself(&mut self, schedule: Schedule) {
        self.looks_too(schedule, &Wish::default());
    }

    /// As numbers, for other ranks.
    pub fn put(&self) -> Vec<u64> {
        let mut counts = Vec::new();
        put(&self.steps, &mut counts);
        counts.push(u64::from(self.glances.is_some()));
        self.glances.iter().for_each(|wish| wish.put(&mut counts));
        for (Schedule { every, last }, wish) in &self.looks {
            counts.extend([*every, u64::from(last.is_some()), last.unwrap_or(0)]);
            wish.put(&mut counts);
        }
        counts
    }

    /// From what [`Wishes::put`] left; none from anything else.
    pub fn take(mut counts: &[u64]) -> Option<Self> {
        let counts = &mut counts;
        let steps = take(counts)?;
        let glances = if next(counts)? > 0 { Some(Wish::take(counts)?) } else { None };
        let mut looks = Vec::new();
        while !counts.is_empty() {
            let [every, is_last, last] = [next(counts)?, next(counts)?, next(counts)?];
            let schedule = Schedule { every, last: (is_last > 0).then_some(last) };
            looks.push((schedule, Wish::take(counts)?));
        }
        Some(Wishes { looks, glances, steps })
    }

    /// Whether anybody looks at a step.
    pub fn is_due(&self, step: u64) -> bool {
        self.looks.iter().any(|(schedule, _)| schedule.due(step))
    }

    /// Whether anybody glances at every step of the coarsest level.
    pub fn glances(&self) -> bool {
        self.glances.is_some()
    }

    /// Members that hold elements which are glanced at.
    pub fn glanced(&self, phase: &Phase) -> Vec<u32> {
        let Some(wish) = &self.glances else { return Vec::new() };
        let slots = phase.element_slot.iter().enumerate().filter(|(e, _)| wish.elements.has(*e));
        let mut members: Vec<u32> = slots.filter_map(|(_, slot)| Some(slot.as_ref()?.member)).collect();
        members.dedup();
        members
    }

    /// In blocks and members.
    pub fn laid_out(&self, model: &Model, phase: &Phase) -> LaidOut {
        let looks = self.looks.iter().map(|(at, wish)| (*at, wish.wanted(model, phase), wish.kept));
        LaidOut {
            looks: looks.collect(),
            glances: self.glances.as_ref().map(|wish| wish.wanted(model, phase)).unwrap_or_default(),
        }
    }
}

/// What is wanted in looks of each schedule and in glances, and whether those who look read what others keep.
pub struct LaidOut {
    looks: Vec<(Schedule, Wanted, bool)>,
    glances: Wanted,
}

impl LaidOut {
    /// What those want who look at a step; who glances looks on.
    pub fn at(&self, step: u64) -> Wanted {
        let mut wanted = self.glances.clone();
        let due = self.looks.iter().filter(|(schedule, ..)| schedule.due(step));
        due.for_each(|(_, more, _)| wanted.join(more));
        wanted
    }

    /// Whether one of them reads what others keep.
    pub fn reads_kept(&self, step: u64) -> bool {
        self.looks.iter().any(|(schedule, _, kept)| *kept && schedule.due(step))
    }

    pub fn glances(&self) -> &Wanted {
        &self.glances
    }
}

const ALL: u64 = u64::MAX;

fn put(which: &Which, counts: &mut Vec<u64>) {
    match which {
        Which::Nothing => counts.push(0),
        Which::Some(all) => {
            counts.push(1 + all.len() as u64);
            counts.extend(all.iter().map(|&one| u64::from(one)));
        }
        Which::All => counts.push(ALL),
    }
}

fn take(counts: &mut &[u64]) -> Option<Which> {
    match next(counts)? {
        0 => Some(Which::Nothing),
        ALL => Some(Which::All),
        count => {
            let (all, rest) = counts.split_at_checked(count as usize - 1)?;
            *counts = rest;
            Some(Which::Some(all.iter().map(|&one| one as u32).collect()))
        }
    }
}

fn next(counts: &mut &[u64]) -> Option<u64> {
    let (&first, rest) = counts.split_first()?;
    *counts = rest;
    Some(first)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_wanted_arrives_as_it_was_sent() {
        let rows = Schedule { every: 5, last: Some(98) };
        let files = Schedule { every: 40, last: None };
        let all = [
            Wants { nodes: Which::some([7, 3]), histories: Which::All, ..Wants::looks(rows) },
            Wants { elements: Which::some([2]), reads_kept: true, ..Wants::looks(files) },
            Wants { nodes: Which::some([4, 7]), ..Wants::looks(rows) },
            Wants { glances: true, members: Which::some([9]), ..Wants::default() },
            Wants { steps: Which::some([1]), ..Wants::default() },
        ];
        let wishes = Wishes::of(all.iter());
        assert_eq!(wishes.looks.len(), 2);
        assert_eq!(wishes.looks[0].1.nodes, Which::some([3, 4, 7]));
        assert_eq!(Wishes::take(&wishes.put()), Some(wishes.clone()));
        assert!(wishes.glances() && wishes.is_due(98) && wishes.is_due(40) && !wishes.is_due(41));
        let cut = wishes.put();
        assert_eq!(Wishes::take(&cut[..cut.len() - 1]), None);
    }
}
