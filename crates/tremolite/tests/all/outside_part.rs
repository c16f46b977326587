//! A part and an observer from outside: what ARCHITECTURE.md, 'How to add a part', says.

use crate::block::block;
use crate::contact::between;
use crate::ready::Ready;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use tremolite::member::Kind;
use tremolite::observers::{Event, Observer, OwnObservers, RunTable, Schedule, Setting, Wants, Which};
use tremolite::parts::{Kept, Motion, Own, Part, Scratch, StateSizes, Tick};
use tremolite::plan::Plan;
use tremolite::run::{Control, run};
use tremolite::simulation::{Built, Ending, Simulation, Start};
use tremolite::state::Memory;
use tremolite::{Base, Limit, Line, Lines, Member, Problem, RunError, Side};
use tremolite_laws::Row;
use tremolite_mesh::Mesh;
use tremolite_results::{Column, ResultFolder, Table};

/// Springs of one stiffness \[N/m\] from nodes to the ground. Remembers the last forces, for the work between two steps,
/// and the largest elongation that it saw.
struct Springs {
    nodes: Vec<u32>,
    stiffness: f64,
}

impl Part for Springs {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    fn state_sizes(&self) -> StateSizes {
        StateSizes { numbers: 3 * self.nodes.len() + 1, ..StateSizes::default() }
    }

    fn forces(&self, _: &Tick, x: &Motion, own: Own, out: &mut [Row], _: &mut Scratch) -> Lines {
        let mut work = Lines::default();
        let (most, last) = own.numbers.split_last_mut().unwrap();
        for ((&node, out), last) in self.nodes.iter().zip(out).zip(last.chunks_exact_mut(3)) {
            let (u, du) = (x.u[node as usize].xyz(), x.du[node as usize].xyz());
            let force = u.map(|u| self.stiffness * u);
            for i in 0..3 {
                work[Line::Springs] += 0.5 * (force[i] + last[i]) * du[i];
                last[i] = force[i];
                *most = most.max(u[i].abs());
            }
            *out = Row::new(force);
        }
        work
    }

    fn energy(&self, x: &Motion, _: Kept) -> Lines {
        let square = |&n: &u32| x.u[n as usize].0.iter().map(|u| u * u).sum::<f64>();
        let mut held = Lines::default();
        held[Line::Springs] = 0.5 * self.stiffness * self.nodes.iter().map(square).sum::<f64>();
        held
    }

    fn stiffness_times(&self, w: &[Row], out: &mut [Row], _: &mut Scratch) {
        for (&node, out) in self.nodes.iter().zip(out) {
            *out = Row(w[node as usize].0.map(|w| self.stiffness * w));
        }
    }
}

const NAME: &str = "side springs";

/// The block without base and sides, on springs at its sides.
pub fn on_springs(stiffness: f64) -> Problem {
    let mut problem = block([5, 4, 6]);
    problem.base = Base::Free;
    problem.sides = [Side::Free; 2];
    problem.incident = None;
    problem.rayleigh.mass = 0.0;
    problem.parts = vec![Arc::new(move |mesh: &Mesh, engine_node: &[u32]| {
        let side = |x: &[f64; 3]| x[0] == 0.0 || x[0] == 12.0;
        let nodes: Vec<u32> =
            mesh.nodes.iter().zip(engine_node).filter(|(x, _)| side(x)).map(|(_, &n)| n).collect();
        Member::new(NAME, Box::new(Springs { nodes, stiffness }))
    })];
    problem
}

/// What springs hold at the start is supplied, so the guard lets the block swing on them, and the balance closes. (It
/// counted as nothing, and the guard stopped such a run after a few steps.)
#[test]
fn a_block_released_from_stretched_springs_swings_and_its_balance_closes() {
    let error = |safety: f64| {
        let ready = Ready::new(on_springs(1e7));
        let mut state = ready.rest(safety);
        let mut engine = ready.engine();
        let moved = vec![Row::new([1e-3, 2e-3, 0.0]); state.u.len()];
        let still = vec![Row::ZERO; state.u.len()];
        engine.start(&mut state, moved, &still);
        let springs = 2.0 * 5.0 * 7.0;
        let held = 0.5 * 1e7 * springs * 5e-6;
        assert!((state.ledger.lines[Line::Initial] / held - 1.0).abs() < 1e-12);
        let (mut worst, mut most) = (0.0_f64, 0.0_f64);
        while state.time() < 1.0 {
            let balance = engine.look(&state).snapshot.balance;
            worst = worst.max(balance[Line::Error].abs());
            most = most.max(balance[Line::Kinetic]);
            engine.step(&mut state);
        }
        assert!(most > 0.5 * held, "the block swings: {most:e} of {held:e} J");
        worst / held
    };
    let (coarse, fine) = (error(0.4), error(0.1));
    let order = (coarse / fine).log2() / 2.0;
    assert!(coarse < 0.01 && (order - 2.0).abs() < 0.1, "order {order:.2} from {coarse:e} to {fine:e}");
}

#[test]
fn springs_that_set_the_step_are_named_by_their_part() {
    let stiff = Ready::new(on_springs(1e12));
    let stable = tremolite::stable_step(&stiff.model, &stiff.assembly, &stiff.phase);
    assert!(matches!(stable.limit, Limit::Part { .. }), "{stable:?}");
    let words = tremolite::survey::limit_in_words(&stiff.model, &stiff.assembly, &stable).to_string();
    assert!(words.starts_with("side springs at node "), "{words}");
}

/// Writes how far the springs were stretched: a result and a file of its own.
struct Stretched {
    schedule: Schedule,
    springs: Which,
    table: RunTable,
}

impl Stretched {
    fn path(folder: &ResultFolder) -> PathBuf {
        folder.root().join("springs.csv")
    }

    fn new(setting: &Setting) -> Result<Self, RunError> {
        let columns = [Column::new("time", "s"), Column::new("stretch", "m")];
        let table = RunTable::new(&Self::path(setting.folder), &columns, setting.memory)?;
        let springs = Which::members(setting.assembly, |kind| kind == Kind::Own);
        Ok(Stretched { schedule: setting.rows(), springs, table })
    }
}

impl Observer for Stretched {
    fn wants(&self) -> Wants {
        Wants { members: self.springs.clone(), ..Wants::looks(self.schedule) }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        let Event::Look(view) = event else { return Ok(()) };
        let Some((_, slices)) = view.assembly.named(NAME) else { return Ok(()) };
        let most = view.numbers_of(slices).last().copied().unwrap_or(0.0);
        self.table.write(&[view.snapshot.time, most], memory)
    }
}

#[test]
fn an_observer_from_outside_writes_a_file_of_what_a_part_from_outside_remembers() {
    let folder = tempfile::tempdir().unwrap();
    let mut problem = on_springs(1e7);
    problem.base = Base::Viscous;
    problem.incident = block([1; 3]).incident;
    let Ready { model, assembly, phase } = Ready::new(problem);
    let plan = Plan {
        page: tremolite_results::PageWish::default(),
        boundaries: Default::default(),
        target: None,
        title: "springs".into(),
        stages: Vec::new(),
        duration: 0.1,
        recorded: None,
        waves: None,
        histories: 0.002,
        snapshots: None,
        fields: Vec::new(),
        field_elements: 250_000,
        checkpoint: None,
        monitors: Vec::new(),
        pairs: Vec::new(),
        bolts: Vec::new(),
        bars: 0,
        water: false,
        relatives: Vec::new(),
        sections: Vec::new(),
    };
    let results = ResultFolder::create(Some(folder.path()), "springs", true).unwrap();
    let mut control = Control { stop: &AtomicBool::new(false), progress: &mut |_| {} };
    let own: OwnObservers =
        vec![Arc::new(|setting: &Setting| Ok(Some(Box::new(Stretched::new(setting)?) as Box<dyn Observer>)))];
    let outcome = Simulation::new(&Built::of(&model, &assembly, &phase), &plan, &results, Start::Rest, own)
        .and_then(|simulation| run(simulation, &mut control))
        .unwrap();
    assert_eq!(outcome.ending, Ending::Done);
    let table = Table::read(&Stretched::path(&results)).unwrap();
    let stretch = table.column("stretch").unwrap();
    assert_eq!(stretch.len(), 51);
    assert!(stretch.is_sorted() && *stretch.last().unwrap() > 1e-5, "{stretch:?}");
}

#[test]
fn parts_that_the_engine_could_not_take_are_refused_by_name() {
    type Change = fn(&mut Member);
    let refused = |nodes: Vec<u32>, change: Change| {
        let mut problem = on_springs(1e7);
        problem.parts = vec![Arc::new(move |_: &Mesh, _: &[u32]| {
            let mut member = Member::new(NAME, Box::new(Springs { nodes: nodes.clone(), stiffness: 1e7 }));
            change(&mut member);
            member
        })];
        let model = tremolite::Model::new(problem).unwrap();
        tremolite::Assembly::new(&model).err().expect("it is refused").to_string()
    };
    let void = refused(vec![3, u32::MAX], |_| ());
    assert!(void.contains("'side springs'") && void.contains("leave out nodes"), "{void}");
    let light = refused(vec![3, 4], |member| member.masses = vec![1.0]);
    assert!(light.contains("1 masses for 2 nodes"), "{light}");
    let uncounted = refused(vec![3], |member| member.counted = false);
    assert!(uncounted.contains("count it"), "{uncounted}");
}

/// Dashpots of one rate \[N s/m\] from nodes to the ground, by the velocity half a step ago.
struct Dashpots {
    nodes: Vec<u32>,
    rate: f64,
}

impl Part for Dashpots {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    fn state_sizes(&self) -> StateSizes {
        StateSizes { numbers: 3 * self.nodes.len(), ..StateSizes::default() }
    }

    fn forces(&self, tick: &Tick, x: &Motion, own: Own, out: &mut [Row], _: &mut Scratch) -> Lines {
        let mut work = Lines::default();
        for ((&node, out), last) in self.nodes.iter().zip(out).zip(own.numbers.chunks_exact_mut(3)) {
            let du = x.increment(node).xyz();
            let force = du.map(|du| self.rate * du / tick.dt);
            (0..3).for_each(|i| work[Line::Own] += 0.5 * (force[i] + last[i]) * du[i]);
            last.copy_from_slice(&force);
            *out = Row::new(force);
        }
        work
    }

    fn stiffness_times(&self, _: &[Row], out: &mut [Row], _: &mut Scratch) {
        out.fill(Row::ZERO);
    }

    fn viscosity_times(&self, w: &[Row], out: &mut [Row], _: &mut Scratch) -> bool {
        for (&node, out) in self.nodes.iter().zip(out) {
            *out = Row(w[node as usize].0.map(|w| self.rate * w));
        }
        true
    }
}

/// The block without base and sides, with dashpots at its sides.
fn on_dashpots(rate: f64) -> Problem {
    let mut problem = on_springs(0.0);
    problem.parts = vec![Arc::new(move |mesh: &Mesh, engine_node: &[u32]| {
        let side = |x: &[f64; 3]| x[0] == 0.0 || x[0] == 12.0;
        let nodes: Vec<u32> =
            mesh.nodes.iter().zip(engine_node).filter(|(x, _)| side(x)).map(|(_, &n)| n).collect();
        Member { line: Some(Line::Own), ..Member::new("dashpots", Box::new(Dashpots { nodes, rate })) }
    })];
    problem
}

/// Weak ones change the step little; strong ones make it 2 m/c, which is what a single mass allows at v⁻. Just within, motion dies out; beyond
/// by a tenth it grows.
#[test]
fn the_step_goes_by_the_dashpots_of_an_own_part() {
    let bound = |rate: f64| {
        let Ready { model, assembly, phase } = Ready::new(on_dashpots(rate));
        let stable = tremolite::stable_step(&model, &assembly, &phase);
        let least = assembly.members.iter().flat_map(|m| m.part.nodes()).map(|&n| phase.mass[n as usize]);
        (stable, least.fold(f64::INFINITY, f64::min))
    };
    let (free, mass) = bound(0.0);
    let (weak, _) = bound(1e-3 * mass / free.dt);
    assert!(weak.dt < free.dt && weak.dt > 0.998 * free.dt, "{} of {}", weak.dt, free.dt);
    let rate = 1e3 * mass / free.dt;
    let (strong, _) = bound(rate);
    let single = 2.0 * mass / rate;
    // What elements hold adds λ_K Δt/2 to the rate, 2·10⁻³ of it here.
    assert!((strong.dt / single - 1.0).abs() < 3e-3, "{} of {single}", strong.dt);
    assert!(matches!(strong.limit, Limit::Part { .. }), "{:?}", strong.limit);
    for (share, grows) in [(0.98, false), (1.1, true)] {
        let ready = Ready::new(on_dashpots(rate));
        let mut state = ready.rest(share);
        let mut engine = ready.engine();
        let nodes = state.u.len();
        let moves: Vec<Row> = (0..nodes).map(|n| Row::new([1e-3 * (n as f64).sin(), 0.0, 0.0])).collect();
        engine.start(&mut state, vec![Row::ZERO; nodes], &moves);
        let before = engine.look(&state).snapshot.balance[Line::Kinetic];
        (0..400).for_each(|_| engine.step(&mut state));
        let after = engine.look(&state).snapshot.balance[Line::Kinetic];
        assert_eq!(after.is_nan() || after >= before, grows, "{share}: {before:e} to {after:e} J");
    }
}

/// Parts of a program's own may ask for a shorter step than elements do, so that the stable step is found wherever a stiffness is left out. Without
/// them it is left unfound where the choice is the same with any; and then it is the same.
#[test]
fn a_stiffness_that_is_left_out_is_the_same_beside_a_part_that_does_nothing() {
    let frequencies = [[4, 3, 5], [60, 3, 5]].map(|size| {
        [
            ("coulomb", &[("friction_coefficient", 0.6)][..]),
            ("bandis", &[("max_closure", 2e-3), ("friction_coefficient", 0.7)]),
        ]
        .map(|(law, own)| {
            let [plain, beside] = [block(size), on_springs(0.0)].map(|parts| {
                let mut problem = block(size);
                problem.base = Base::Viscous;
                problem.interfaces = vec![between(&problem, [1, 0], law, own)];
                problem.parts = parts.parts;
                let contacts = &Ready::new(problem).assembly.contacts[0];
                (contacts.frequency, contacts.law.stiffest())
            });
            assert_eq!(plain, beside, "{law} {size:?}");
            plain.0
        })
    });
    // In the coarse block the least that a joint must have governs, which closure stiffens by Bandis' law; in the fine one the step, which bounds the
    // stiffest state of either law.
    let [[coulomb, bandis], [fine_coulomb, fine_bandis]] = frequencies;
    assert!(bandis > 1.5 * coulomb && (fine_bandis / fine_coulomb - 1.0).abs() < 1e-9, "{frequencies:?}");
}
