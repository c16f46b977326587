//! What water in the pores of ground and in interfaces pushes nodes with before the shaking, constant in each stage.

use crate::hexahedra::{hex, hex_nodes};
use crate::interface::Seam;
use crate::life::{Life, Stage};
use crate::model::{Model, Patch};
use crate::node_table::Domain;
use crate::water::Water;
use std::collections::{BTreeMap, BTreeSet};
use tremolite_laws::shapes::hex8::Hex8;

/// V b of each corner \[m²\]: ∫∂N/∂x dV.
fn gradients(hex: &Hex8) -> [[f64; 3]; 8] {
    let mut all = [[0.0; 3]; 8];
    for (corner, own) in all.iter_mut().enumerate() {
        for (axis, b) in own.iter_mut().enumerate() {
            let mut u = [[0.0; 3]; 8];
            u[corner][axis] = 1.0;
            *b = hex.volume * hex.mean_strain(&u)[axis];
        }
    }
    all
}

/// Forces on engine nodes while they stay the same, and whether they are those of ground outside.
pub(crate) struct Acting {
    pub life: Life,
    pub outside: bool,
    /// Engine node and force \[N\], ascending.
    pub forces: Vec<(u32, [f64; 3])>,
}

/// Times before the shaking in which nothing changes of what is there, by these lives and the spells of a water.
fn spans(water: &Water, lives: impl Iterator<Item = Life>) -> Vec<Life> {
    let mut changes: BTreeSet<Stage> = water.spells.iter().map(|spell| spell.from).collect();
    for life in lives {
        changes.insert(life.born);
        changes.extend(life.gone);
    }
    let mut starts: Vec<Stage> = changes.into_iter().filter(|stage| *stage < Stage::Shaking).collect();
    starts.push(Stage::Shaking);
    starts.windows(2).map(|pair| Life { born: pair[0], gone: Some(pair[1]) }).collect()
}

/// What the pressure in pores pushes with, ∫Bᵀ p I, before the shaking.
pub(crate) fn in_pores(model: &Model) -> Vec<Acting> {
    let water = &model.water;
    if water.spells.is_empty() {
        return Vec::new();
    }
    let wet = |e: &u32| water.wets(*e as usize);
    let patches: Vec<_> = model.patches.iter().filter(|patch| patch.elements.iter().any(wet)).collect();
    let mut acting = Vec::new();
    for life in spans(water, patches.iter().map(|patch| patch.life)) {
        for outside in [false, true] {
            let mut forces: BTreeMap<u32, [f64; 3]> = BTreeMap::new();
            let there =
                |patch: &&&Patch| (patch.domain != Domain::Model) == outside && patch.life.holds(life.born);
            for &e in patches.iter().filter(there).flat_map(|patch| &patch.elements) {
                let p = water.pressure(e as usize, life.born);
                // Every element of a patch was checked.
                let (true, Ok(hex)) = (p > 0.0, hex(&model.mesh, e as usize)) else { continue };
                let nodes = hex_nodes(&model.mesh, e as usize);
                for (node, b) in nodes.into_iter().zip(gradients(&hex)) {
                    let sum = forces.entry(model.engine_node[node as usize]).or_default();
                    (0..3).for_each(|i| sum[i] += p * b[i]);
                }
            }
            let forces: Vec<_> = forces.into_iter().collect();
            if !forces.is_empty() {
                acting.push(Acting { life, outside, forces });
            }
        }
    }
    acting
}

/// What the water in an interface pushes its two sides apart with, before the shaking.
pub(crate) fn in_seam(model: &Model, seam: &Seam) -> Vec<Acting> {
    let water = &model.water;
    if water.spells.is_empty() {
        return Vec::new();
    }
    let mut acting = Vec::new();
    for life in spans(water, seam.lives.iter().copied()) {
        let mut forces: BTreeMap<u32, [f64; 3]> = BTreeMap::new();
        for (k, pair) in seam.pairs.iter().enumerate().filter(|(k, _)| seam.lives[*k].holds(life.born)) {
            let push = water.in_pair(seam, k, life.born) * pair.normal_area;
            if push == 0.0 {
                continue;
            }
            for (node, sign) in pair.nodes.into_iter().zip([-1.0, 1.0]) {
                let sum = forces.entry(model.engine_node[node as usize]).or_default();
                (0..3).for_each(|i| sum[i] += sign * push * pair.normal[i]);
            }
        }
        let forces: Vec<_> = forces.into_iter().collect();
        if !forces.is_empty() {
            acting.push(Acting { life, outside: seam.of.is_some(), forces });
        }
    }
    acting
}
