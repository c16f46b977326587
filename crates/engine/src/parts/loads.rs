//! Given nodal forces that vary in time.

use super::{Motion, Own, Part, Scratch, StateSizes, Tick};
use std::sync::Arc;
use tremolite_kernels::{Line, Lines};
use tremolite_laws::Row;

/// Forces with one common history.
#[derive(Clone)]
pub struct Load {
    /// Node and force at factor 1 \[N\].
    pub forces: Vec<(u32, [f64; 3])>,
    /// Factor at a time \[s\].
    pub factor: Arc<dyn Fn(f64) -> f64 + Send + Sync>,
}

impl std::fmt::Debug for Load {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Load").field("forces", &self.forces.len()).finish_non_exhaustive()
    }
}

/// One load as a part.
pub struct Loads {
    nodes: Vec<u32>,
    load: Load,
}

impl Loads {
    /// The part; nodes are the engine's.
    pub fn new(load: Load) -> Self {
        Loads { nodes: load.forces.iter().map(|(node, _)| *node).collect(), load }
    }
}

impl Part for Loads {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    fn bytes(&self) -> usize {
        size_of_val(&self.nodes[..]) + size_of_val(&self.load.forces[..])
    }

    fn state_sizes(&self) -> StateSizes {
        // The last factor, for the work between two steps.
        StateSizes { numbers: 1, ..StateSizes::default() }
    }

    fn forces(&self, tick: &Tick, x: &Motion, own: Own, out: &mut [Row], _: &mut Scratch) -> Lines {
        let factor = (self.load.factor)(tick.time);
        let mean = 0.5 * (factor + own.numbers[0]);
        own.numbers[0] = factor;
        let mut work = Lines::default();
        for ((node, force), out) in self.load.forces.iter().zip(out) {
            let du = x.increment(*node).xyz();
            work[Line::Input] -= mean * (force[0] * du[0] + force[1] * du[1] + force[2] * du[2]);
            *out = Row::new(force.map(|f| -f * factor));
        }
        work
    }

    fn stiffness_times(&self, _: &[Row], out: &mut [Row], _: &mut Scratch) {
        out.fill(Row::ZERO);
    }
}
