//! The columns of a model, as they are watched, and the nodes of the model itself beside them.

use std::ops::Range;
use tremolite_engine::Domain;
use tremolite_engine::column::Column;
use tremolite_engine::model::Model;

/// The ends of a column, in the order in which they are told everywhere here.
pub const ENDS: [&str; 2] = ["top", "base"];

/// A column of ground far from the caverns.
pub struct Watched {
    pub name: String,
    /// Engine nodes of its top and base.
    pub ends: [usize; 2],
    /// The corners of the model for which it stands: bit 0 for the high end of x, bit 1 for that of y.
    pub at: Vec<usize>,
    /// Engine nodes of the model itself there, level with its top and base.
    pub corners: [Vec<usize>; 2],
    /// Its own, of the model's.
    pub bodies: Range<usize>,
}

/// The columns of a model.
pub fn watched(model: &Model) -> Vec<Watched> {
    let level = |n: u32| model.mesh.nodes[n as usize][2];
    let watched = |column: &Column| {
        let ends = [column.top, column.bottom];
        Watched {
            name: column.name.clone(),
            ends: ends.map(|n| model.engine_node[n as usize] as usize),
            at: column.corners.clone(),
            corners: ends.map(|n| column.corners.iter().map(|&k| beside(model, k, level(n))).collect()),
            bodies: column.bodies.clone(),
        }
    };
    model.outside.columns.iter().map(watched).collect()
}

/// Where a vertical edge of the model is, by its corner.
pub fn edge(model: &Model, corner: usize) -> [f64; 2] {
    let (low, high) = model.faces.bounds;
    [if corner & 1 == 0 { low[0] } else { high[0] }, if corner & 2 == 0 { low[1] } else { high[1] }]
}

/// The engine node of the user's model nearest a vertical edge at a level \[m\].
fn beside(model: &Model, corner: usize, level: f64) -> usize {
    let [x, y] = edge(model, corner);
    let at = [x, y, level];
    let distance = |n: usize| {
        let x = model.mesh.nodes[model.mesh_node[n] as usize];
        (0..3).map(|i| (x[i] - at[i]).powi(2)).sum::<f64>()
    };
    model.nodes.of(Domain::Model).min_by(|a, b| distance(*a).total_cmp(&distance(*b))).unwrap_or(0)
}

/// Engine nodes of the model itself at the upper and lower ends of its four vertical edges: level with the columns that stand
/// for them, or else the highest and the lowest of the edge.
pub fn edges(model: &Model, columns: &[Watched]) -> [[usize; 4]; 2] {
    let (low, high) = model.faces.bounds;
    let near = 1e-6 * (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max);
    let place = |n: usize| model.mesh.nodes[model.mesh_node[n] as usize];
    [0, 1].map(|end| {
        [0, 1, 2, 3].map(|corner| {
            let level = match columns.iter().find(|column| column.at.contains(&corner)) {
                Some(column) => place(column.ends[end])[2],
                None => {
                    let at = edge(model, corner);
                    let along = model.nodes.of(Domain::Model).map(place);
                    let along = along.filter(|x| (0..2).all(|i| (x[i] - at[i]).abs() < near)).map(|x| x[2]);
                    let extreme = if end == 0 { along.reduce(f64::max) } else { along.reduce(f64::min) };
                    extreme.unwrap_or([high[2], low[2]][end])
                }
            };
            beside(model, corner, level)
        })
    })
}
