//! Water of a case: pressures by level in each stage, and what of the ground has pores.

use super::undrained::{Undrained, is_undrained};
use tremolite_case::{Case, LateralOf, MaterialWater, Pores};
use tremolite_engine::hexahedra::{hex, hex_nodes};
use tremolite_engine::water::Spell;
use tremolite_engine::{Body, Stage, Water};
use tremolite_laws::Dimension;
use tremolite_laws::shapes::hex8::{gauss_point, shape_values};
use tremolite_mesh::Mesh;

/// Height of the water level in the ground \[m\] in each stage, the initial equilibrium first; none without water.
pub fn levels(case: &Case) -> Vec<f64> {
    let Some(water) = &case.water else { return Vec::new() };
    let mut levels = vec![water.level.value];
    for stage in &case.stages {
        let before = levels[levels.len() - 1];
        levels.push(stage.water.level.as_ref().map_or(before, |level| level.value));
    }
    levels
}

/// Pores of a material, where it says so.
pub fn pores(case: &Case, material: usize) -> Option<&Pores> {
    match &case.materials[material].water {
        Some(MaterialWater::Pores(pores)) => Some(pores),
        _ => None,
    }
}

/// Pressure \[Pa\] at a height \[m\] below a level.
fn pressure(case: &Case, level: f64, z: f64) -> f64 {
    case.water.as_ref().map_or(0.0, |water| water.unit_weight.value * (level - z).max(0.0))
}

/// Mean pressure \[Pa\] of an element.
pub fn mean(case: &Case, mesh: &Mesh, element: usize, level: f64) -> f64 {
    let corners = hex_nodes(mesh, element).map(|n| mesh.nodes[n as usize][2]);
    let at = |shares: [f64; 8]| pressure(case, level, shares.iter().zip(corners).map(|(n, z)| n * z).sum());
    mean_of(mesh, element, at)
}

/// Mean over the volume of an element of what a function makes of the shares of its corners at a point, by the 2×2×2 points with their volumes:
/// those of collapsed hexahedra crowd at the corners that fall together, and the plain mean of points would depend on which these are. That
/// plain mean where the element has no volume.
pub fn mean_of(mesh: &Mesh, element: usize, at: impl Fn([f64; 8]) -> f64) -> f64 {
    let weights = hex(mesh, element).map_or([1.0; 8], |hex| hex.weights);
    let of = |(p, weight): (usize, &f64)| weight * at(shape_values(gauss_point(p)));
    weights.iter().enumerate().map(of).sum::<f64>() / weights.iter().sum::<f64>()
}

/// What the initial stress must know: pressure \[Pa\] in the pores of what is there at the start, by element; none without water, or
/// where `lateral` is of total stresses.
pub fn beside_lateral(case: &Case, mesh: &Mesh, materials: &[usize], at_start: &[Option<usize>]) -> Vec<f64> {
    let levels = levels(case);
    let (Some(&level), LateralOf::Effective) = (levels.first(), case.initial.lateral_of) else {
        return Vec::new();
    };
    let porous = |body: &Option<usize>| body.is_some_and(|b| pores(case, materials[b]).is_some());
    let of = |(e, body)| if porous(body) { mean(case, mesh, e, level) } else { 0.0 };
    at_start.iter().enumerate().map(of).collect()
}

/// The water of a mesh with these bodies, which are of these materials.
pub fn of(case: &Case, materials: &[usize], mesh: &Mesh, bodies: &[Body]) -> Water {
    let levels = levels(case);
    if levels.is_empty() {
        return Water::default();
    }
    let mut biot = vec![0.0; mesh.elements.len()];
    let mut modulus = if is_undrained(case) { biot.clone() } else { Vec::new() };
    for (body, &material) in bodies.iter().zip(materials) {
        if let Some(pores) = pores(case, material) {
            body.elements.iter().for_each(|&e| biot[e as usize] = pores.biot.value);
            if let Some(of) = Undrained::of(case, pores, body.material.relaxed()) {
                body.elements.iter().for_each(|&e| modulus[e as usize] = of.modulus);
            }
        }
    }
    let usable = |e: usize| hex(mesh, e).is_ok();
    let mut spells: Vec<Spell> = Vec::new();
    for (k, &level) in levels.iter().enumerate() {
        if k > 0 && levels[k - 1] == level {
            continue;
        }
        let of = |e: usize| if biot[e] > 0.0 && usable(e) { mean(case, mesh, e, level) } else { 0.0 };
        spells.push(Spell {
            from: Stage::Before(k as u16),
            elements: (0..mesh.elements.len()).map(of).collect(),
            nodes: mesh.nodes.iter().map(|x| pressure(case, level, x[2])).collect(),
        });
    }
    Water { biot, modulus, spells }
}

/// A height as people write it.
pub fn shown(height: f64) -> String {
    tremolite_case::units::format(height, Dimension::LENGTH)
}
