//! What stages that move nodes leave: the way, the force that it takes, and whether the specimen snapped back.

use indexmap::IndexMap;
use tremolite_engine::engine::Rest;
use tremolite_engine::state::{Memory, State};
use tremolite_engine::{Engine, Model};
use tremolite_kernels::{Booked, Line};

/// Share of the energy at stake in a step beyond which its loss in the step is a snap-back. At stake is what the model held before the
/// step, or what a step of this way stores in the sound model where that is more: the energy that is held passes through zero where a
/// load reverses.
///
/// A bar whose softening is just stable loses none; one that is twice as long as it may be loses most of what it holds (test
/// `specimens`).
const MOST_LOST: f64 = 0.1;
/// Numbers of a name and a stage: way and force along x, y, z.
const EACH: usize = 6;
const HELD: &str = "energy held in stages";
/// What the relaxation's damping takes of a way, over its square \[J/m²\].
const DRAG: &str = "drag of stages";
/// What the first way stored at least in the sound model, over its square \[J/m²\]: half of the reactions' growth times the way.
const STIFFNESS: &str = "stiffness of stages";

/// Work \[J\] of what stages moved, by size, and what the damping of the relaxation took of it.
const WORK: &str = "work of stages";

/// What laws had dissipated \[J\]; the share of the first step's work that they dissipated; the largest share of what was held that a
/// step let go at once, and its stage.
const DISSIPATED: &str = "dissipated in stages";
const FIRST: &str = "first step cracked";
const LOST: &str = "let go at once";

/// The share of the first step's work that laws dissipated.
pub(crate) fn first_step(memory: &Memory) -> Option<f64> {
    memory.get(FIRST)?.first().copied()
}

/// The largest share of what was held that a step let go at once, and its stage.
pub(crate) fn let_go(memory: &Memory) -> Option<(f64, usize)> {
    match memory.get(LOST)?[..] {
        [share, stage] => Some((share, stage as usize)),
        _ => None,
    }
}

/// The work \[J\] of what stages moved, and what the damping on the way to rest took; none where nothing was moved.
pub(crate) fn damped(memory: &Memory) -> Option<(f64, f64)> {
    let sums = memory.get(WORK)?;
    Some((*sums.first()?, *sums.get(1)?))
}

/// The quantities of a name, with their units.
pub(crate) const QUANTITIES: [(&str, &str); EACH] =
    [("ux", "m"), ("uy", "m"), ("uz", "m"), ("reaction_x", "N"), ("reaction_y", "N"), ("reaction_z", "N")];

/// What is moved in a stage, where it is at rest.
pub(crate) struct MovedNodes {
    /// By name: way \[m\] and force \[N\]; not a number along what is free.
    each: Vec<(String, [f64; EACH])>,
    /// What elements, bars, bolts and interfaces hold, and what they have dissipated since the start \[J\].
    held: f64,
    dissipated: f64,
}

impl MovedNodes {
    /// Of a state at rest in the engine's phase.
    pub fn of(model: &Model, engine: &mut Engine, state: &State) -> MovedNodes {
        if model.boundaries.prescribed.is_empty() {
            return MovedNodes { each: Vec::new(), held: 0.0, dissipated: 0.0 };
        }
        let reactions = engine.reactions(state);
        let now = engine.stage();
        let here = model.boundaries.prescribed.iter().zip(reactions).filter(|(one, _)| one.life.holds(now));
        let each = here.map(|(one, force)| {
            let row = std::array::from_fn(|i| match (one.to[i % 3], i < 3) {
                (None, _) => f64::NAN,
                (Some(to), true) => to,
                (Some(_), false) => force[i % 3],
            });
            (one.name.clone(), row)
        });
        let each = each.collect();
        let balance = engine.look(state).snapshot.balance;
        let sum = |booked: Booked| -> f64 {
            let lines = Line::ALL.iter().filter(|line| line.booked() == booked && line.sign() > 0.0);
            lines.map(|&line| balance[line]).sum()
        };
        let sums = engine.from_first(&[sum(Booked::Stored), sum(Booked::Spent)]);
        MovedNodes { each, held: sums[0], dissipated: sums[1] }
    }

    /// The energy \[J\] that a step lost, and what was held before, where it lost too much of it to have gone along states at rest.
    ///
    /// What the damping of the relaxation takes of a model that stays linear goes by the square of the way: the first step, in which
    /// nothing should crack, says how much of that is none.
    pub fn snapped_back(&self, memory: &mut Memory, stage: usize, rest: &Rest) -> Option<(f64, f64)> {
        let before = *memory.get(HELD)?.last()?;
        let (mut square, mut gained) = (0.0, 0.0);
        for (name, now) in &self.each {
            let earlier = of_stage(memory, name, stage.checked_sub(1)?)?;
            for i in (0..3).filter(|&i| (now[i] - earlier[i]).is_finite()) {
                let way = now[i] - earlier[i];
                square += way * way;
                gained += 0.5 * (now[i + 3] - earlier[i + 3]) * way;
            }
        }
        if square == 0.0 {
            return None;
        }
        let Some(drag) = memory.get(DRAG).map(|kept| kept[0]) else {
            memory.insert(DRAG.into(), vec![rest.damped / square]);
            memory.insert(STIFFNESS.into(), vec![gained.max(0.0) / square]);
            return None;
        };
        let stiffness = memory.get(STIFFNESS).map_or(0.0, |kept| kept[0]);
        let at_stake = before.max(stiffness * square);
        let lost = rest.damped - drag * square;
        if at_stake <= 0.0 {
            return None;
        }
        if lost > MOST_LOST * at_stake {
            return Some((lost, at_stake));
        }
        let known = memory.entry(LOST.into()).or_insert_with(|| vec![0.0; 2]);
        if lost / at_stake > known[0] {
            *known = vec![lost / at_stake, stage as f64];
        }
        None
    }

    pub fn remember(&self, memory: &mut Memory, stage: usize, rest: &Rest) {
        if self.each.is_empty() {
            return;
        }
        let before = memory.get(DISSIPATED).and_then(|kept| kept.first().copied()).unwrap_or(0.0);
        memory.insert(DISSIPATED.into(), vec![self.dissipated]);
        let mut work = 0.0;
        for (name, now) in &self.each {
            let earlier = stage.checked_sub(1).and_then(|before| of_stage(memory, name, before));
            let Some(earlier) = earlier else { continue };
            let ways = (0..3).map(|i| 0.5 * (earlier[i + 3] + now[i + 3]) * (now[i] - earlier[i]));
            work += ways.filter(|work| work.is_finite()).sum::<f64>();
        }
        if work != 0.0 {
            let sums = memory.entry(WORK.into()).or_insert_with(|| vec![0.0; 2]);
            (sums[0], sums[1]) = (sums[0] + work.abs(), sums[1] + rest.damped);
            memory.entry(FIRST.into()).or_insert_with(|| vec![(self.dissipated - before) / work.abs()]);
        }
        memory.entry(HELD.into()).or_default().push(self.held);
        for (name, row) in &self.each {
            let rows = memory.entry(key(name)).or_default();
            rows.resize(stage * EACH, f64::NAN);
            rows.extend(row);
        }
    }
}

fn key(name: &str) -> String {
    format!("moved {name}")
}

fn of_stage(memory: &Memory, name: &str, stage: usize) -> Option<[f64; EACH]> {
    memory.get(&key(name))?.as_chunks::<EACH>().0.get(stage).copied()
}

/// What is remembered of a stage: name → quantity → value, of what is not free.
pub(crate) fn recall(
    model: &Model,
    memory: &Memory,
    stage: usize,
) -> IndexMap<String, IndexMap<String, f64>> {
    let mut all = IndexMap::new();
    for one in &model.boundaries.prescribed {
        let Some(row) = of_stage(memory, &one.name, stage) else { continue };
        let known = QUANTITIES.iter().zip(row).filter(|(_, value)| value.is_finite());
        all.insert(one.name.clone(), known.map(|((name, _), value)| ((*name).to_owned(), value)).collect());
    }
    all
}
