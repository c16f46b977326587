//! The engine's numbers of nodes.

use super::Patch;
use crate::levels::Levels;
use crate::node_table::Nodes;
use crate::parts::loads::Load;
use tremolite_mesh::Mesh;

/// Nodes of the mesh and of the engine.
pub(super) struct Numbering {
    /// Engine node → node of the mesh.
    pub mesh_node: Vec<u32>,
    /// Node of the mesh → engine node; `u32::MAX` if no active element uses it.
    pub engine_node: Vec<u32>,
    pub nodes: Nodes,
}

impl Numbering {
    /// In the order in which the patches first touch them, those of a level together: a patch's nodes lie close in memory.
    pub fn of(mesh: &Mesh, patches: &[Patch], levels: &Levels) -> Self {
        let mut engine_node = vec![u32::MAX; mesh.nodes.len()];
        let mut mesh_node = Vec::new();
        let mut nodes = Nodes::default();
        let shared = shared(mesh, patches);
        for patch in patches {
            for alone in [true, false] {
                for level in 0..=levels.coarsest() {
                    let before = mesh_node.len();
                    for n in of_patch(mesh, patch) {
                        let own = shared[n as usize] != alone && levels.of_node(n) == level;
                        if engine_node[n as usize] == u32::MAX && own {
                            engine_node[n as usize] = mesh_node.len() as u32;
                            mesh_node.push(n);
                        }
                    }
                    nodes.push(patch.domain, level, mesh_node.len() - before);
                }
            }
        }
        Numbering { mesh_node, engine_node, nodes }
    }

    /// Loads on engine nodes, of those that some element uses.
    pub fn of_loads(&self, loads: Vec<Load>) -> Vec<Load> {
        let renumbered = |mut load: Load| {
            load.forces.retain_mut(|(node, _)| {
                *node = self.engine_node.get(*node as usize).copied().unwrap_or(u32::MAX);
                *node != u32::MAX
            });
            load
        };
        loads.into_iter().map(renumbered).collect()
    }
}

/// Whether more than one patch touches each node of the mesh.
fn shared(mesh: &Mesh, patches: &[Patch]) -> Vec<bool> {
    // The last patch that touched it, and how many did: beyond one it does not matter how many.
    let mut touched = vec![(u32::MAX, 0u8); mesh.nodes.len()];
    for (p, patch) in (0u32..).zip(patches) {
        for n in of_patch(mesh, patch) {
            let (last, count) = &mut touched[n as usize];
            if *last != p {
                (*last, *count) = (p, count.saturating_add(1));
            }
        }
    }
    touched.into_iter().map(|(_, count)| count > 1).collect()
}

/// The nodes of a patch's elements, one element after the other.
fn of_patch<'a>(mesh: &'a Mesh, patch: &'a Patch) -> impl Iterator<Item = u32> + 'a {
    patch.elements.iter().flat_map(|&e| mesh.elements[e as usize].nodes()).copied()
}
