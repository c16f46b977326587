//! The nodes that a stage moves.

use crate::error::ModelError;
use crate::life::Stage;
use crate::model::Model;
use std::collections::HashMap;
use std::collections::hash_map::Entry;

/// A node that a stage moves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Driven {
    /// Engine node, of those that move as one their master.
    pub node: u32,
    /// Index in [`Boundaries::prescribed`](crate::boundary::Boundaries::prescribed).
    pub by: u32,
    /// Displacement \[m\] at the stage's end, counted from the initial equilibrium; a component without one is not held.
    pub to: [Option<f64>; 3],
}

/// The nodes that are moved in a stage. Where several mean a component of a node the first has it, and with it the reaction.
///
/// # Errors
/// If two of them would bring it to different places.
pub fn driven(model: &Model, stage: Stage, master: &[u32]) -> Result<Vec<Driven>, ModelError> {
    let here =
        (0u32..).zip(&model.boundaries.prescribed).filter(|(_, prescribed)| prescribed.life.holds(stage));
    let mut all = Vec::new();
    let mut taken: HashMap<(u32, usize), (u32, f64)> = HashMap::new();
    for (by, prescribed) in here {
        // A node is there as long as any element is: those that are meant may be gone.
        let corners = prescribed.corners.iter().flat_map(|&(e, corners)| {
            let nodes = model.mesh.elements[e as usize].nodes().iter().enumerate();
            nodes.filter(move |(k, _)| corners >> k & 1 == 1).map(|(_, &node)| node)
        });
        let engine = corners.map(|node| model.engine_node[node as usize]).filter(|&node| node != u32::MAX);
        let mut nodes: Vec<u32> = engine.map(|node| master[node as usize]).collect();
        nodes.sort_unstable();
        nodes.dedup();
        for node in nodes {
            let mut to = prescribed.to;
            for (i, way) in to.iter_mut().enumerate() {
                let Some(end) = *way else { continue };
                match taken.entry((node, i)) {
                    Entry::Vacant(free) => _ = free.insert((by, end)),
                    Entry::Occupied(other) => {
                        let (first, there) = *other.get();
                        if there != end {
                            let names =
                                [first, by].map(|k| model.boundaries.prescribed[k as usize].name.clone());
                            return Err(ModelError::MovedTwice { names, ways: [there, end] });
                        }
                        *way = None;
                    }
                }
            }
            all.push(Driven { node, by, to });
        }
    }
    Ok(all)
}
