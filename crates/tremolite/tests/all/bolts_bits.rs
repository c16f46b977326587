//! Bolts through stages and the shaking: bits that do not depend on threads or instruction sets, and runs that are taken up again.

use crate::block::block;
use std::sync::Arc;
use tremolite::checkpoint::Among;
use tremolite::engine::{Relaxed, Release};
use tremolite::{
    Assembly, Bar, Bolts, Bond, Engine, Life, Model, Phase, Problem, Stage, State, checkpoint, stable_step,
};
use tremolite_engine::bolts::SegmentState;
use tremolite_laws::Isa;

const STAGES: u16 = 3;
const STEPS: u64 = 150;

fn kind(name: &str, bars: Vec<[[f64; 3]; 2]>) -> Bolts {
    Bolts {
        name: name.into(),
        bars: bars.into_iter().map(|ends| Bar { points: ends.to_vec(), areas: vec![4.9e-4] }).collect(),
        young: 200e9,
        yields: f64::INFINITY,
        breaks: f64::INFINITY,
        bond: None,
        pretension: 0.0,
        free_length: 0.0,
        plates: [false; 2],
        born: Stage::Before(1),
    }
}

/// A block under its weight. The first stage places anchors that are pulled, slide, and feel the pressure on them, and bars that
/// yield; the second takes a pit out of the top, and some of the bolts' heads with it.
pub fn bolted(isa: Isa) -> Problem {
    bolted_of(isa, [6, 5, 7])
}

/// The same of so many elements along each axis.
pub fn bolted_of(isa: Isa, elements: [u32; 3]) -> Problem {
    let mut problem = block(elements);
    problem.isa = isa;
    problem.gravity = 9.81;
    problem.lives = (0..problem.mesh.elements.len() as u32)
        .map(|e| {
            let [x, y, z] = tremolite::hexahedra::centroid(&problem.mesh, e);
            let pit = (x - 6.0).abs() < 2.0 && (y - 5.0).abs() < 2.0 && z > 12.0;
            Life { born: Stage::Before(0), gone: pit.then_some(Stage::Before(2)) }
        })
        .collect();
    let grid = |n: u32, of: &dyn Fn(f64, f64) -> [[f64; 3]; 2]| {
        let places = (0..n * n).map(|k| [k % n, k / n].map(|i| (f64::from(i) + 0.5) / f64::from(n)));
        places.map(|[a, b]| of(a, b)).collect::<Vec<_>>()
    };
    let anchors =
        grid(8, &|a, b| [[0.5 + 11.0 * a, 0.5 + 9.0 * b, 13.8], [1.5 + 9.0 * a, 9.0 * b + 0.8, 3.0]]);
    let bars = grid(9, &|a, b| [[0.3, 0.5 + 9.0 * a, 1.0 + 12.0 * b], [11.8, 9.2 - 8.0 * a, 1.5 + 11.0 * b]]);
    let bond = Bond { stiffness: 2e8, strength: 2e3, friction: 0.5, perimeter: 0.08, segment: 0.7 };
    problem.bolts = vec![
        Bolts {
            bond: Some(bond),
            pretension: 20e3,
            free_length: 3.0,
            plates: [true, false],
            ..kind("anchors", anchors)
        },
        Bolts { yields: 5e6, ..kind("bars", bars) },
    ];
    problem
}

struct Built {
    model: Arc<Model>,
    assembly: Arc<Assembly>,
}

impl Built {
    fn new(isa: Isa) -> Self {
        let model = Model::new(bolted(isa)).unwrap();
        let assembly = Assembly::new(&model).unwrap();
        // More than one part of either kind, so that threads share them.
        for set in &model.bolts {
            let parts = assembly.members.iter().filter(|member| member.name == set.kind.name).count();
            assert!(parts > 1, "{} {parts}", set.kind.name);
        }
        Built { model, assembly }
    }

    fn phase(&self, stage: Stage) -> Arc<Phase> {
        Phase::of(&self.model, &self.assembly, stage).unwrap()
    }

    /// Through the stages from here, or to a cycle of one.
    fn settle(&self, state: &mut State, from: u16, stop: Option<(u16, u64)>) {
        for k in from..STAGES {
            let phase = self.phase(Stage::Before(k));
            let mut cycles = 0;
            let mut watch = |_: &mut State, _: &tremolite::engine::Rest| {
                cycles += 1;
                stop != Some((k, cycles))
            };
            let mut engine = Engine::new(&self.model, &self.assembly, &phase);
            match engine.relax_watched(state, &Release::default(), &mut watch) {
                Relaxed::AtRest(_) => {}
                Relaxed::Stopped(_) => return,
                other => panic!("{k}: {other:?}"),
            }
        }
    }

    fn shake(&self, state: &mut State, steps: u64) {
        let phase = self.phase(Stage::Shaking);
        let mut engine = Engine::new(&self.model, &self.assembly, &phase);
        if state.carried.is_empty() {
            let dt = 0.9 * stable_step(&self.model, &self.assembly, &phase).dt;
            engine.hand_over(state, dt);
        }
        (0..steps).for_each(|_| engine.step(state));
    }

    fn again(&self, state: &mut State) -> State {
        let folder = tempfile::tempdir().unwrap();
        checkpoint::write(folder.path(), state, 1, &Among(None)).unwrap();
        let mut read = self.assembly.rest();
        checkpoint::read(folder.path(), &mut read, 1, &Among(None)).unwrap();
        assert!(read == *state);
        read
    }

    fn states(&self, state: &State, set: usize) -> Vec<SegmentState> {
        let bolts = 0..self.model.bolts[set].bolts.len();
        bolts.flat_map(|b| self.assembly.bolts[set].seen(&state.numbers, b)).map(|seen| seen.state).collect()
    }
}

fn on<T: Send>(threads: usize, run: impl FnOnce() -> T + Send) -> T {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(run)
}

#[test]
fn a_bolted_model_has_the_same_bits_on_any_threads_and_instruction_sets_through_stages_and_shaking() {
    let whole = |isa: Isa, threads: usize| {
        let built = Built::new(isa);
        on(threads, || {
            let mut state = built.assembly.rest();
            built.settle(&mut state, 0, None);
            let rested = state.clone();
            built.shake(&mut state, STEPS);
            (built, rested, state)
        })
    };
    let (built, rested, shaken) = whole(Isa::best(), 1);
    // What is compared has slid, yielded and been cut off.
    for (set, wanted) in [(0, SegmentState::Slid), (0, SegmentState::CutOff), (1, SegmentState::Yielded)] {
        let [before, after] = [&rested, &shaken]
            .map(|state| built.states(state, set).into_iter().filter(|state| *state == wanted).count());
        // Bars move with the rock: they have nothing to yield by before it is shaken.
        let enough = before > 0 || wanted == SegmentState::Yielded;
        assert!(enough && after > 0, "{wanted:?}: {before}, {after}");
    }
    let moved = (0..shaken.u.len()).map(|n| shaken.shown(n).0[0].abs()).fold(0.0, f64::max);
    assert!(moved > 1e-4, "{moved}");
    for (isa, threads) in [(Isa::best(), 2), (Isa::best(), 4), (Isa::Scalar, 1)] {
        let (_, other, last) = whole(isa, threads);
        assert!(other == rested, "{isa:?}, {threads} threads: at rest");
        assert!(last == shaken, "{isa:?}, {threads} threads: after the shaking");
    }
}

#[test]
fn a_bolted_model_stopped_in_a_stage_and_in_the_shaking_goes_on_to_the_same_bits() {
    let built = Built::new(Isa::best());
    let mut whole = built.assembly.rest();
    built.settle(&mut whole, 0, None);
    let rested = whole.clone();
    built.shake(&mut whole, STEPS);
    // While the anchors' tension is kept, and while what is cut off is let go.
    for stop in [(1, 60), (2, 150)] {
        let mut state = built.assembly.rest();
        on(2, || built.settle(&mut state, 0, Some(stop)));
        let mut state = built.again(&mut state);
        assert!(state.relaxing.cycle > 1 && state != rested);
        on(3, || built.settle(&mut state, stop.0, None));
        assert!(state == rested, "{stop:?}");
    }
    let mut state = built.again(&mut rested.clone());
    built.shake(&mut state, STEPS / 3);
    let mut state = built.again(&mut state);
    on(2, || built.shake(&mut state, STEPS - STEPS / 3));
    assert!(state == whole);
}
