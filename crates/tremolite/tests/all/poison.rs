//! What a part reads it has named: everything else is not a number to it, and the bits are the same.

use crate::block::block;
use crate::bolts_bits;
use crate::contact::jointed;
use crate::ready::Ready;
use crate::rims_cavern::cavern;
use crate::staged::stiffened;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;
use tremolite::engine::{Relaxed, Release};
use tremolite::parts::{Motion, Own, Part, Reads, Scratch, Tick};
use tremolite::{
    Assembly, Base, Engine, Kind, Lines, Member, Model, Phase, Problem, Quadrature, Side, Stage, State,
    stable_step,
};
use tremolite_laws::{Isa, Row};

/// Stages that need not come near to rest, and some steps.
struct Way {
    stages: u16,
    steps: u64,
}

impl Way {
    /// The state at the end as text, since what is not known is not a number; none where a stage falls or a step halts.
    fn end(&self, model: &Arc<Model>, assembly: &Arc<Assembly>, poisoned: bool) -> Option<String> {
        let engine = |phase: &Arc<Phase>| {
            let engine = Engine::new(model, assembly, phase);
            if poisoned { engine.poisoned() } else { engine }
        };
        let mut state: State = assembly.rest();
        let release = Release { cycles: 20, tolerance: [2e-2, 2e-1], most: 3000, ..Release::default() };
        for k in 0..self.stages {
            let phase = Phase::of(model, assembly, Stage::Before(k)).unwrap();
            match engine(&phase).relax_watched(&mut state, &release, &mut |_, _| true) {
                Relaxed::AtRest(_) => {}
                _ => return None,
            }
        }
        let phase = Phase::of(model, assembly, Stage::Shaking).unwrap();
        let mut engine = engine(&phase);
        state.dt = 0.8 * stable_step(model, assembly, &phase).dt;
        if self.stages > 0 {
            let dt = state.dt;
            engine.hand_over(&mut state, dt);
        }
        let mut seen = Vec::new();
        for step in 0..self.steps {
            if step % 10 == 9 {
                let look = engine.look(&state);
                engine.guard(&look.snapshot).ok()?;
                seen.push((look.snapshot.balance, look.snapshot.stress, look.snapshot.velocity));
            }
            engine.step(&mut state);
        }
        Some(format!("{state:?} {seen:?}"))
    }

    /// As [`Way::end`]; none as well where a part cannot go on with what is not a number.
    fn poisoned(&self, model: &Arc<Model>, assembly: &Arc<Assembly>) -> Option<String> {
        catch_unwind(AssertUnwindSafe(|| self.end(model, assembly, true))).unwrap_or(None)
    }

    /// The same bits where all that is not named is poisoned; not so once any name is left out.
    fn holds(&self, what: &str, problem: impl Fn() -> Problem) -> [usize; 2] {
        let model = Model::new(problem()).unwrap();
        let assembly = || Assembly::new(&model).unwrap();
        let whole = self.end(&model, &assembly(), false);
        assert!(whole.is_some(), "{what}: it runs");
        assert!(whole == self.end(&model, &assembly(), true), "{what}: something reads what it did not name");

        let mut left_out = [0; 2];
        let members = 0..assembly().members.len();
        let reading = |m: usize| assembly().members[m].reads.clone();
        for (m, reads) in members.map(|m| (m, reading(m))) {
            // The first and the last of each stand for all.
            for (kind, all) in [&reads.nodes, &reads.elements].into_iter().enumerate() {
                let ends = [0, all.len().saturating_sub(1)];
                for k in &ends[..all.len().min(2)] {
                    let mut less = assembly();
                    let member = &mut Arc::get_mut(&mut less).unwrap().members[m];
                    let named = [&mut member.reads.nodes, &mut member.reads.elements];
                    named.into_iter().nth(kind).unwrap().remove(*k);
                    let name = member.name.clone();
                    assert!(whole != self.poisoned(&model, &less), "{what}: '{name}' does without {k}");
                    left_out[kind] += 1;
                }
            }
        }
        left_out
    }
}

#[test]
fn all_sides_and_bases_name_what_they_read() {
    let springs = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: Some(20.0) };
    let way = Way { stages: 1, steps: 30 };
    let mut left_out = [0; 2];
    for (k, side) in Side::EXAMPLES.into_iter().enumerate() {
        for base in [Base::Free, Base::Fixed, Base::Viscous, springs] {
            let problem = || {
                let mut problem = block([4, 4, 5]);
                problem.base = base;
                problem.sides = [side, Side::EXAMPLES[(k + 1) % Side::EXAMPLES.len()]];
                problem.patch_elements = Some(16);
                problem.ties = vec![(3, 40)];
                // With ξ ≠ 0 every part is asked for products besides.
                problem.rayleigh.stiffness = if k % 2 == 0 { 1e-5 } else { 0.0 };
                problem
            };
            // Ground at the corners is no column where it is held.
            if Model::new(problem()).is_err() {
                continue;
            }
            let some = way.holds(&format!("{side:?} {base:?}"), problem);
            (0..2).for_each(|i| left_out[i] += some[i]);
        }
    }
    // Springs read them, of which there are three kinds of sides.
    assert!(left_out[0] >= 6, "columns' feet were left out: {left_out:?}");
}

#[test]
fn bolts_interfaces_and_stages_name_what_they_read() {
    let bolted = Way { stages: 3, steps: 20 };
    let left_out = bolted.holds("bolts", || bolts_bits::bolted(Isa::best()));
    assert!(left_out[1] > 4, "hosts were left out: {left_out:?}");
    let mut joint = Way { stages: 0, steps: 40 };
    joint.holds("joint", || jointed(Isa::best()));
    joint.stages = 1;
    joint.holds("joint at rest before", || jointed(Isa::best()));
    let changed = Way { stages: 3, steps: 20 };
    for quadrature in [Quadrature::OnePoint, Quadrature::Full] {
        let left_out = changed.holds("changed material", || stiffened(quadrature, 0.17));
        assert!(left_out[1] > 0, "elements that others take over from were left out: {left_out:?}");
    }
    let rims = Way { stages: 6, steps: 20 };
    let left_out = rims.holds("fault through a cavern", || cavern(false));
    assert!(left_out[1] > 4, "elements beside freed pairs were left out: {left_out:?}");
}

/// A spring between two nodes of which it pushes one.
pub struct OneSided {
    pub nodes: [u32; 1],
    pub other: u32,
    pub named: bool,
}

impl Part for OneSided {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    fn reads(&self) -> Reads {
        let nodes = if self.named { vec![self.other] } else { Vec::new() };
        Reads { nodes, ..Reads::default() }
    }

    fn keeps_books(&self) -> bool {
        false
    }

    fn forces(&self, _: &Tick, x: &Motion, _: Own, out: &mut [Row], _: &mut Scratch) -> Lines {
        let [a, b] = [self.nodes[0], self.other].map(|n| x.u[n as usize]);
        out[0] = Row([0, 1, 2, 3].map(|i| 1e6 * (a.0[i] - b.0[i])));
        Lines::default()
    }

    fn stiffness_times(&self, _: &[Row], out: &mut [Row], _: &mut Scratch) {
        out.fill(Row::ZERO);
    }
}

#[test]
fn a_programs_own_part_is_told_what_it_forgot_to_name() {
    let way = Way { stages: 0, steps: 30 };
    for named in [true, false] {
        let mut problem = block([4, 4, 5]);
        problem.parts = vec![Arc::new(move |_: &_, engine_node: &[u32]| {
            let part = OneSided { nodes: [engine_node[0]], other: engine_node[7], named };
            Member::new("one-sided", Box::new(part))
        })];
        let Ready { model, assembly, .. } = Ready::new(problem);
        assert_eq!(assembly.members.last().map(|member| member.kind), Some(Kind::Own));
        let whole = way.end(&model, &assembly, false).unwrap();
        assert_eq!(way.end(&model, &assembly, true).as_ref() == Some(&whole), named);
    }
}
