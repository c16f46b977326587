//! What a step of a model costs here.

use std::sync::Arc;
use std::time::Instant;
use tremolite_engine::{Assembly, Engine, Model, Phase};

/// Seconds a step of the finest level takes here, in the mean over one of the coarsest, from a short timing of the real engine on a state of its own.
pub fn time_step_cost(model: &Arc<Model>, assembly: &Arc<Assembly>, phase: &Arc<Phase>, dt: f64) -> f64 {
    let mut state = assembly.rest();
    state.dt = dt;
    let mut engine = Engine::new(model, assembly, phase);
    // At rest with a tiny motion, so that no number is subnormal or zero throughout.
    let v = vec![tremolite_laws::Row::new([1e-6, 2e-6, 3e-6]); state.u.len()];
    let u = state.u.clone();
    engine.start(&mut state, u, &v);
    let mut best = f64::INFINITY;
    let begin = Instant::now();
    let mut rounds = 0;
    while rounds < 3 || (begin.elapsed().as_secs_f64() < 0.3 && rounds < 50) {
        let start = Instant::now();
        for _ in 0..4 {
            engine.step(&mut state);
        }
        best = best.min(start.elapsed().as_secs_f64() / (4 * phase.span()) as f64);
        rounds += 1;
    }
    best
}
