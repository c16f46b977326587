//! What the initial stress is to the ground that it is in, before anything moves.

use crate::history::History;
use rayon::prelude::*;
use std::collections::HashMap;
use std::sync::Arc;
use tremolite_engine::engine::{Engine, Release};
use tremolite_engine::hexahedra::{centroid, hex};
use tremolite_engine::ties::Ties;
use tremolite_engine::water::with_pressure;
use tremolite_engine::{Assembly, Model, Phase};
use tremolite_laws::Role;
use tremolite_laws::sym3::principal_values;
use tremolite_mesh::topology::{all_faces, face_key};
use tremolite_mesh::{Face, Mesh};

/// Tension \[Pa\] that is more than round-off of a stress that is none.
const TENSION: f64 = 1.0;

/// What the initial stress is to the ground.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct AtRest {
    /// What stands at first, and of it what is in tension and what lies beyond yield \[m³\].
    pub volume: f64,
    pub tension: f64,
    pub beyond: f64,
    /// The largest tension, and where its element has its centre.
    pub largest: Option<(f64, [f64; 3])>,
    /// Where the walls of what is taken out are loaded most for their strength.
    pub wall: Option<Wall>,
    /// Vertical forces out of balance, summed by size over the nodes that are free, over the weight of what stands at first; none
    /// without weight.
    pub imbalance: Option<f64>,
}

/// An opening's wall before its rock yields.
#[derive(Clone, Debug, PartialEq)]
pub struct Wall {
    /// The centre of an element that is taken out there \[m\].
    pub at: [f64; 3],
    /// The largest elastic stress at the wall, compression positive \[Pa\]: of an ellipse of the opening's extents (`inglis1913`), or 3σ₁ − σ₃
    /// of a circle (`kirsch1898`) if that is more. Of a mesh whose axis is not known the circle in the better of the two upright sections.
    pub load: f64,
    /// Width and height \[m\] of the openings across y, if they go along y.
    pub extents: Option<[f64; 2]>,
    /// The material's uniaxial compressive strength \[Pa\].
    pub strength: f64,
}

/// What the initial stress is to what stands at first; nothing where there is none. Parts are evaluated once, without motion.
/// `along_y`: the openings are known to go along y.
pub fn at_rest(
    model: &Arc<Model>,
    assembly: &Arc<Assembly>,
    first: &Arc<Phase>,
    along_y: bool,
) -> Option<AtRest> {
    if model.elements.initial.is_empty() {
        return None;
    }
    let seen = Engine::new(model, assembly, first).look(&assembly.rest());
    let history = History::new(assembly, &seen.history);
    let strengths: Vec<Option<f64>> = model.bodies.iter().map(strength).collect();
    let extents = if along_y { extents(model) } else { None };
    let mut found = AtRest { imbalance: imbalance(model, assembly, first), ..AtRest::default() };
    let volume = |e: usize| hex(&model.mesh, e).ok().map(|shape| shape.volume);
    let volumes: Vec<Option<f64>> = (0..model.user.elements).into_par_iter().map(volume).collect();
    for ((e, slot), volume) in first.element_slot.iter().enumerate().zip(volumes) {
        let (Some(slot), Some(volume)) = (slot, volume) else { continue };
        let total = model.elements.initial[e];
        // Rock bears by effective stress.
        let stress = &with_pressure(total, model.water.pressure(e, first.stage));
        let [high, ..] = principal_values(stress);
        found.volume += volume;
        if high > TENSION {
            found.tension += volume;
            if found.largest.is_none_or(|(most, _)| high > most) {
                found.largest = Some((high, centroid(&model.mesh, e as u32)));
            }
        }
        let yields = history.with_role(slot, Role::PlasticShear);
        if yields.is_some_and(|column| history.values(slot, column).any(|shear| shear > 0.0)) {
            found.beyond += volume;
        }
        let strength = model.elements.body_of[e].and_then(|body| strengths[body]);
        if let (Some(strength), Some(_)) = (strength, model.elements.lives[e].gone) {
            let [xx, yy, zz, _, yz, zx] = *stress;
            let across = round(xx, zz, zx);
            let load = match extents {
                Some(extents) => across.max(at_ellipse(xx, zz, extents)),
                None if along_y => across,
                None => across.min(round(yy, zz, yz)),
            };
            if found.wall.as_ref().is_none_or(|wall| load / strength > wall.load / wall.strength) {
                found.wall = Some(Wall { at: centroid(&model.mesh, e as u32), load, extents, strength });
            }
        }
    }
    Some(found)
}

/// See [`AtRest::imbalance`]: of one evaluation of the forces. A vertical stress that is the weight above leaves nothing, whatever the
/// horizontal ones are.
fn imbalance(model: &Arc<Model>, assembly: &Arc<Assembly>, first: &Arc<Phase>) -> Option<f64> {
    let mut state = assembly.rest();
    // The relaxation evaluates all forces and is stopped before its second cycle.
    Engine::new(model, assembly, first)
        .relax_watched(&mut state, &Release::default(), &mut |_, rest| rest.cycles == 0);
    let free = |node: usize| first.inverse_mass[node].0[2] > 0.0;
    let counts = |node: usize| model.nodes.counts(node);
    let forces = state.held.iter().enumerate().filter(|(node, _)| free(*node) && counts(*node));
    let out: f64 = forces.map(|(_, force)| force.0[2].abs()).sum();
    let standing = model.standing(first.stage);
    let weight = |&e: &u32| -> Option<f64> {
        let body = model.elements.body_of[e as usize]?;
        Some(model.bodies[body].density * hex(&model.mesh, e as usize).ok()?.volume)
    };
    let weight = model.loading.gravity * standing.iter().filter_map(weight).sum::<f64>();
    (weight > 0.0).then_some(out / weight)
}

/// 3σ₁ − σ₃, compression positive, of a stress in a plane, tension positive \[Pa\].
fn round(a: f64, b: f64, shear: f64) -> f64 {
    let (middle, radius) = (0.5 * (a + b), (0.25 * (a - b).powi(2) + shear * shear).sqrt());
    (middle + radius) - 3.0 * (middle - radius)
}

/// The larger of the stresses at crown and wall of an ellipse with horizontal and vertical axes, compression positive, under
/// stresses along these, tension positive \[Pa\]: σ_x (1 + 2h/w) − σ_z and σ_z (1 + 2w/h) − σ_x.
fn at_ellipse(xx: f64, zz: f64, [width, height]: [f64; 2]) -> f64 {
    let crown = zz - xx * (1.0 + 2.0 * height / width);
    let wall = xx - zz * (1.0 + 2.0 * width / height);
    crown.max(wall)
}

/// Width and height \[m\] of what is taken out across y: medians over its elements of the length of the row and of the column that each
/// lies in. A gallery between caverns is in few of them.
fn extents(model: &Model) -> Option<[f64; 2]> {
    let gone = |e: &u32| {
        let e = *e as usize;
        model.elements.body_of[e].is_some() && model.elements.lives[e].gone.is_some()
    };
    let elements: Vec<u32> = (0..model.user.elements as u32).filter(gone).collect();
    let row_of = |axis: usize| -> Option<f64> {
        let mut beside: HashMap<[u32; 4], u32> = HashMap::new();
        let mut rows = Ties::new(model.user.elements);
        for face in all_faces(&model.mesh, Some(&elements)) {
            let normal = normal(&model.mesh, face).map(f64::abs);
            if normal[axis] < normal[(axis + 1) % 3].max(normal[(axis + 2) % 3]) {
                continue;
            }
            if let Some(other) = beside.insert(face_key(&model.mesh, face), face.element) {
                rows.join(face.element, other);
            }
        }
        let roots = rows.roots();
        let mut ends: HashMap<u32, [f64; 2]> = HashMap::new();
        for &e in &elements {
            let [low, high] = ends.entry(roots[e as usize]).or_insert([f64::INFINITY, f64::NEG_INFINITY]);
            for &n in model.mesh.elements[e as usize].nodes() {
                let x = model.mesh.nodes[n as usize][axis];
                (*low, *high) = (low.min(x), high.max(x));
            }
        }
        let length = |e: &u32| ends.get(&roots[*e as usize]).map(|[low, high]| high - low);
        let mut lengths: Vec<f64> = elements.iter().filter_map(length).collect();
        lengths.sort_by(f64::total_cmp);
        lengths.get(lengths.len() / 2).copied()
    };
    Some([row_of(0)?, row_of(2)?])
}

/// A vector along the normal of a face \[m²\].
fn normal(mesh: &Mesh, face: Face) -> [f64; 3] {
    let corners: Vec<[f64; 3]> = mesh.face_nodes(face).map(|n| mesh.nodes[n as usize]).collect();
    let last = corners.len() - 1;
    let [a, b] = [[corners[2], corners[0]], [corners[last], corners[1]]]
        .map(|[to, from]| [0, 1, 2].map(|i| to[i] - from[i]));
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The uniaxial compressive strength of what yields.
fn strength(body: &tremolite_engine::Body) -> Option<f64> {
    let yields = body.material.info().history.iter().any(|column| column.role == Role::PlasticShear);
    let constants = if yields { body.material.derived([1.0; 2]) } else { Vec::new() };
    constants.iter().find(|c| c.name == "compressive_strength").map(|c| c.range[0]).filter(|x| *x > 0.0)
}

#[cfg(test)]
mod tests {
    use super::{at_ellipse, round};

    #[test]
    fn the_ellipse_of_a_circle_has_the_stress_of_kirsch_and_a_tall_one_more_at_its_crown() {
        assert!((at_ellipse(-1.3, -1.0, [10.0, 10.0]) - round(-1.3, -1.0, 0.0)).abs() < 1e-12);
        assert!((at_ellipse(-0.5, -1.0, [10.0, 10.0]) - round(-0.5, -1.0, 0.0)).abs() < 1e-12);
        // 1.3 (1 + 2 · 80/25) − 1.
        assert!((at_ellipse(-1.3, -1.0, [25.0, 80.0]) - 8.62).abs() < 1e-12);
    }
}
