//! Levels of columns of ground, and which column is the free field of a place.

use super::columns::edge;
use std::collections::BTreeSet;
use tremolite_engine::Domain;
use tremolite_engine::column::Column;
use tremolite_engine::life::Stage;
use tremolite_engine::model::Model;
use tremolite_laws::Row;
use tremolite_mesh::locate::Location;

/// A level of a column, which moves as one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    /// m
    pub z: f64,
    /// An engine node of it.
    pub node: usize,
}

/// The size of a model along its longest edge, times what counts as nothing.
fn near(model: &Model) -> f64 {
    let (low, high) = model.faces.bounds;
    1e-6 * (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max)
}

/// The levels of a column in the shaking, upwards.
pub fn levels(model: &Model, column: &Column) -> Vec<Level> {
    let elements = model.bodies[column.bodies.clone()].iter().flat_map(|body| &body.elements);
    let standing = elements.filter(|&&e| model.elements.lives[e as usize].holds(Stage::Shaking));
    let nodes: BTreeSet<u32> =
        standing.flat_map(|&e| model.mesh.elements[e as usize].nodes().iter().copied()).collect();
    let level =
        |n: u32| Level { z: model.mesh.nodes[n as usize][2], node: model.engine_node[n as usize] as usize };
    let mut levels: Vec<Level> = nodes.into_iter().map(level).collect();
    levels.sort_by(|a, b| a.z.total_cmp(&b.z));
    let near = near(model);
    levels.dedup_by(|above, below| above.z - below.z < near);
    levels
}

/// The nodes of the model itself along a vertical edge, level with those of a column; none where the mesh has no such edge.
pub fn beside(model: &Model, corner: usize, levels: &[Level]) -> Vec<usize> {
    let (at, near) = (edge(model, corner), near(model));
    let place = |n: usize| model.mesh.nodes[model.mesh_node[n] as usize];
    let along: Vec<usize> = model
        .nodes
        .of(Domain::Model)
        .filter(|&n| (0..2).all(|i| (place(n)[i] - at[i]).abs() < near))
        .collect();
    let off = |n: usize, level: &Level| (place(n)[2] - level.z).abs();
    let nearest =
        |level: &Level| along.iter().copied().min_by(|a, b| off(*a, level).total_cmp(&off(*b, level)));
    levels.iter().filter_map(nearest).collect()
}

/// Which of the model's columns is the free field of a place, and at which corner of the model: that which stands for the corner
/// nearest in plan, the first where corners are equally near or a corner has several. None without columns.
pub fn nearest(model: &Model, [x, y]: [f64; 2]) -> Option<(usize, usize)> {
    let near = near(model);
    let mut best: Option<(f64, (usize, usize))> = None;
    for (k, column) in model.outside.columns.iter().enumerate() {
        for &corner in &column.corners {
            let [at_x, at_y] = edge(model, corner);
            let away = (at_x - x).hypot(at_y - y);
            if best.is_none_or(|(least, _)| away < least - near) {
                best = Some((away, (k, corner)));
            }
        }
    }
    best.map(|(_, found)| found)
}

/// Where a point lies that was found in an element \[m\].
pub fn place(model: &Model, location: &Location) -> [f64; 3] {
    let nodes = model.mesh.elements[location.element as usize].nodes();
    let mut at = [0.0; 3];
    for (&node, weight) in nodes.iter().zip(location.weights) {
        (0..3).for_each(|i| at[i] += weight * model.mesh.nodes[node as usize][i]);
    }
    at
}

/// A height in a column, between two of its levels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Height {
    nodes: [usize; 2],
    /// Share of the upper one.
    upper: f64,
}

impl Height {
    /// Above or below the column its end; none without levels.
    pub fn of(levels: &[Level], z: f64) -> Option<Height> {
        let above = levels.partition_point(|level| level.z <= z).min(levels.len().saturating_sub(1)).max(1);
        let (&below, &above) = (levels.get(above - 1)?, levels.get(above)?);
        let upper = ((z - below.z) / (above.z - below.z)).clamp(0.0, 1.0);
        Some(Height { nodes: [below.node, above.node], upper })
    }

    /// Engine nodes that it lies between.
    pub fn nodes(&self) -> [usize; 2] {
        self.nodes
    }

    /// What rows by engine node have there, linear between levels as in the column's elements.
    pub fn at(&self, rows: &[Row]) -> [f64; 3] {
        let [below, above] = self.nodes.map(|n| rows[n].xyz());
        [0, 1, 2].map(|i| (1.0 - self.upper) * below[i] + self.upper * above[i])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_height_lies_between_its_levels_and_at_an_end_beyond_them() {
        let levels = [(0.0, 2), (1.0, 0), (4.0, 1)].map(|(z, node)| Level { z, node });
        let rows = [10.0, 40.0, 0.0].map(|x| Row::new([x, -x, 0.0]));
        for (z, found) in
            [(-1.0, 0.0), (0.0, 0.0), (0.5, 5.0), (1.0, 10.0), (2.0, 20.0), (4.0, 40.0), (9.0, 40.0)]
        {
            assert_eq!(Height::of(&levels, z).unwrap().at(&rows), [found, -found, 0.0], "{z}");
        }
        assert_eq!(Height::of(&levels[..1], 0.0), None);
    }
}
