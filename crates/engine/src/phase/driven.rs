//! The nodes that a stage moves.

use crate::life::Stage;
use crate::model::Model;

/// A node that a stage moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Driven {
    /// Engine node, of those that move as one their master.
    pub node: u32,
    /// Index in [`Model::prescribed`].
    pub by: u32,
    /// Displacement \[m\] at the stage's end, counted from the initial equilibrium; a component without one is not held.
    pub to: [Option<f64>; 3],
}

/// The nodes that are moved in a stage, each once for each that moves it.
pub fn driven(model: &Model, stage: Stage, master: &[u32]) -> Vec<Driven> {
    let here = (0u32..).zip(&model.prescribed).filter(|(_, prescribed)| prescribed.life.holds(stage));
    let mut all = Vec::new();
    for (by, prescribed) in here {
        let standing = prescribed.corners.iter().filter(|(e, _)| model.lives[*e as usize].holds(stage));
        let corners = standing.flat_map(|&(e, corners)| {
            let nodes = model.mesh.elements[e as usize].nodes().iter().enumerate();
            nodes.filter(move |(k, _)| corners >> k & 1 == 1).map(|(_, &node)| node)
        });
        let engine = corners.map(|node| model.engine_node[node as usize]).filter(|&node| node != u32::MAX);
        let mut nodes: Vec<u32> = engine.map(|node| master[node as usize]).collect();
        nodes.sort_unstable();
        nodes.dedup();
        all.extend(nodes.into_iter().map(|node| Driven { node, by, to: prescribed.to }));
    }
    all
}
