//! Nodal forces that do not change: weight and tractions before the shaking. They are in no line of the balance.

use super::{Motion, Own, Part, Scratch, Tick};
use tremolite_kernels::Lines;
use tremolite_laws::Row;

/// Constant forces on nodes.
pub struct Constant {
    nodes: Vec<u32>,
    /// What resists them \[N\]: their opposites.
    resisting: Vec<Row>,
}

impl Constant {
    /// The part from forces \[N\] on engine nodes, one entry a node.
    pub fn new(forces: impl IntoIterator<Item = (u32, [f64; 3])>) -> Self {
        let (nodes, resisting) =
            forces.into_iter().map(|(node, force)| (node, Row::new(force.map(|f| -f)))).unzip();
        Constant { nodes, resisting }
    }
}

impl Part for Constant {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    fn bytes(&self) -> usize {
        size_of_val(&self.nodes[..]) + size_of_val(&self.resisting[..])
    }

    fn forces(&self, _: &Tick, _: &Motion, _: Own, out: &mut [Row], _: &mut Scratch) -> Lines {
        out.copy_from_slice(&self.resisting);
        Lines::default()
    }

    fn stiffness_times(&self, _: &[Row], out: &mut [Row], _: &mut Scratch) {
        out.fill(Row::ZERO);
    }
}
