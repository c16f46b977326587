//! What a step of a model, and a cycle of its stages, cost here: short timings of the real engine on states of its own.

use std::sync::Arc;
use std::time::Instant;
use tremolite_engine::engine::Release;
use tremolite_engine::{Assembly, Engine, Model, Phase};
use tremolite_laws::Row;

/// Time that a timing goes on for \[s\], and rounds that it makes at least and at most.
const LONG: f64 = 0.3;
const ROUNDS: [u32; 2] = [3, 50];

/// Seconds a step of the finest level takes, in the mean over one of the coarsest.
pub fn time_step_cost(model: &Arc<Model>, assembly: &Arc<Assembly>, phase: &Arc<Phase>, dt: f64) -> f64 {
    let mut state = assembly.rest();
    state.dt = dt;
    let mut engine = Engine::new(model, assembly, phase);
    // At rest with a tiny motion, so that no number is subnormal or zero throughout.
    let v = vec![Row::new([1e-6, 2e-6, 3e-6]); state.u.len()];
    let u = state.u.clone();
    engine.start(&mut state, u, &v);
    let mut timing = Timing::begin();
    while timing.goes_on() {
        for _ in 0..4 {
            engine.step(&mut state);
        }
        timing.round();
    }
    timing.best / (4 * phase.span()) as f64
}

/// Seconds a cycle of a stage's relaxation takes, 0 where none could be made: time stands still, all have one level, and every cycle is asked
/// how near to rest it is.
pub fn time_cycle_cost(model: &Arc<Model>, assembly: &Arc<Assembly>, stage: &Arc<Phase>) -> f64 {
    let mut state = assembly.rest();
    let mut engine = Engine::new(model, assembly, stage);
    let mut timing = Timing::begin();
    engine.relax_watched(&mut state, &Release::default(), &mut |_, rest| {
        match rest.cycles {
            // What goes before the first cycle is done once a stage.
            0 => timing = Timing::begin(),
            _ => timing.round(),
        }
        timing.goes_on()
    });
    if timing.rounds > 0 { timing.best } else { 0.0 }
}

/// The best of several rounds.
struct Timing {
    begin: Instant,
    last: Instant,
    rounds: u32,
    best: f64,
}

impl Timing {
    fn begin() -> Self {
        let now = Instant::now();
        Timing { begin: now, last: now, rounds: 0, best: f64::INFINITY }
    }

    fn goes_on(&self) -> bool {
        let [least, most] = ROUNDS;
        self.rounds < least || (self.begin.elapsed().as_secs_f64() < LONG && self.rounds < most)
    }

    fn round(&mut self) {
        let now = Instant::now();
        self.best = self.best.min((now - self.last).as_secs_f64());
        self.last = now;
        self.rounds += 1;
    }
}
