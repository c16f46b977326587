//! How often parts are evaluated where they step on several levels.

use crate::block::block;
use crate::ready::Ready;
use std::collections::BTreeSet;
use std::sync::atomic::{AtomicU64, Ordering::Relaxed};
use std::sync::{Arc, Mutex};
use tremolite::Lines;
use tremolite::Side;
use tremolite::parts::{
    ElementEnergy, Entry, Kept, Motion, Own, Part, ProbeOut, Reads, Scratch, StateSizes, Tick,
};
use tremolite_laws::{Column, Row};

/// A part whose evaluations are counted, with the steps \[s\] that it was given.
struct Counted {
    inner: Arc<dyn Part>,
    calls: Arc<AtomicU64>,
    steps: Arc<Mutex<BTreeSet<u64>>>,
}

impl Counted {
    fn count(&self, tick: &Tick) {
        self.calls.fetch_add(1, Relaxed);
        self.steps.lock().unwrap().insert(tick.dt.to_bits());
    }
}

impl Part for Counted {
    fn nodes(&self) -> &[u32] {
        self.inner.nodes()
    }
    fn reads(&self) -> Reads {
        self.inner.reads()
    }
    fn state_sizes(&self) -> StateSizes {
        self.inner.state_sizes()
    }
    fn elements(&self) -> (usize, usize) {
        self.inner.elements()
    }
    fn columns(&self) -> &'static [Column] {
        self.inner.columns()
    }
    fn begin(&self, x: &Motion, own: Own) {
        self.inner.begin(x, own);
    }
    fn enter(&self, entry: &Entry, own: Own) {
        self.inner.enter(entry, own);
    }
    fn settle(&self, own: Own) {
        self.inner.settle(own);
    }
    fn forces(&self, tick: &Tick, x: &Motion, own: Own, out: &mut [Row], scratch: &mut Scratch) -> Lines {
        self.count(tick);
        self.inner.forces(tick, x, own, out, scratch)
    }
    fn probe(
        &self,
        tick: &Tick,
        x: &Motion,
        own: Own,
        out: &mut [Row],
        to: ProbeOut,
        scratch: &mut Scratch,
    ) -> Lines {
        self.count(tick);
        self.inner.probe(tick, x, own, out, to, scratch)
    }
    fn energy(&self, x: &Motion, kept: Kept) -> Lines {
        self.inner.energy(x, kept)
    }
    fn stiffness_times(&self, w: &[Row], out: &mut [Row], scratch: &mut Scratch) {
        self.inner.stiffness_times(w, out, scratch);
    }
    fn stiffness_energy(&self, w: &[Row], energy: &mut [ElementEnergy], scratch: &mut Scratch) {
        self.inner.stiffness_energy(w, energy, scratch);
    }
}

/// Each part is evaluated once in a step of its own level, and is given that step; so laws are called as `check` and summary.json say.
#[test]
fn each_part_is_evaluated_once_in_its_own_step() {
    let mut problem = block([6, 5, 14]);
    problem.sides = [Side::FreeField; 2];
    problem.patch_elements = Some(32);
    let mut ready = Ready::new(problem).levelled(|[_, _, z]| (z / 3.0) as u8);
    let mut counts = Vec::new();
    let assembly = Arc::get_mut(&mut ready.assembly).unwrap();
    for member in &mut assembly.members {
        let (calls, steps) = (Arc::<AtomicU64>::default(), Arc::<Mutex<BTreeSet<u64>>>::default());
        counts.push((calls.clone(), steps.clone()));
        member.part = Arc::new(Counted { inner: member.part.clone(), calls, steps });
    }
    let mut state = ready.rest(0.1);
    let dt = state.dt;
    let mut engine = ready.engine();
    // A look brings all to one time, and evaluates what is due then as a step would.
    engine.look(&state);
    counts.iter().for_each(|(calls, _)| calls.store(0, Relaxed));
    let coarse = 6;
    (0..coarse).for_each(|_| engine.step(&mut state));
    let span = ready.phase.span();
    assert_eq!((ready.phase.beats.len(), span, state.steps()), (4, 8, coarse * span));
    let mut seen = BTreeSet::new();
    let mut laws = 0;
    for (&m, (calls, steps)) in ready.phase.active.iter().map(|m| (m, &counts[*m as usize])) {
        let member = &ready.assembly.members[m as usize];
        let own = 1 << member.level;
        assert_eq!(calls.load(Relaxed), coarse * span / own, "{} of level {}", member.name, member.level);
        let steps = steps.lock().unwrap();
        assert_eq!(
            steps.iter().copied().collect::<Vec<_>>(),
            [(own as f64 * dt).to_bits()],
            "{}",
            member.name
        );
        let (elements, points) = member.part.elements();
        laws += calls.load(Relaxed) * (elements * points) as u64;
        seen.insert(member.level);
    }
    assert_eq!(seen.len(), 4, "parts of all levels");
    let one: u64 = (ready.assembly.members.iter())
        .map(|member| member.part.elements())
        .map(|(elements, points)| coarse * span * (elements * points) as u64)
        .sum();
    assert!(laws < one, "{laws} calls of laws, where one level has {one}");
}
