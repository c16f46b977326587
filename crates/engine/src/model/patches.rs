//! Patches: the elements of a model, cut into pieces that one thread works on.

use super::Elements;
use crate::body::Body;
use crate::hexahedra::{centroid, hex};
use crate::levels::Levels;
use crate::life::Life;
use crate::node_table::Domain;
use rayon::prelude::*;
use std::collections::BTreeMap;
use tremolite_kernels::Quadrature;
use tremolite_mesh::Mesh;
use tremolite_mesh::order::hilbert_order;

/// Elements that one thread works on together.
#[derive(Clone, Debug)]
pub struct Patch {
    pub body: usize,
    /// What its elements belong to.
    pub domain: Domain,
    pub life: Life,
    /// Whether its elements have artificial viscosity ([`Elements::viscosity`](super::Elements::viscosity)).
    pub viscous: bool,
    /// Whether its elements take over from others. Each then has nodes of its own among the part's, since displacements count
    /// from other values in each.
    pub takes_over: bool,
    /// Whether they are elements of the simplest shape, which have kernels of their own: of one point bricks with edges along the axes
    /// ([`Hex8::upright`](tremolite_laws::shapes::hex8::Hex8::upright)), of several any bricks
    /// ([`Hex8::is_brick`](tremolite_laws::shapes::hex8::Hex8::is_brick)).
    pub bricks: bool,
    /// The level of their steps in the shaking, the finest of their nodes'.
    pub level: u8,
    /// Indices into the model's elements, in the order of lanes.
    pub elements: Vec<u32>,
}

/// Elements a patch that are wanted of a level with so many: enough patches to share out small models, large ones for locality.
fn patch_size(elements: usize) -> usize {
    (elements / 64).clamp(64, 512)
}

/// By how much smaller patches are whose elements take more work, so that no thread or rank gets much at once.
fn costs(quadrature: Quadrature) -> usize {
    match quadrature {
        Quadrature::OnePoint => 1,
        Quadrature::Full => 2,
        Quadrature::Layered(_) => 4,
    }
}

/// The elements of each of the fewest equal pieces that have no more than so many, in whole groups of lanes.
fn even(elements: usize, most: usize) -> usize {
    let pieces = elements.div_ceil(most.max(1).next_multiple_of(LANES)).max(1);
    elements.div_ceil(pieces).next_multiple_of(LANES)
}

/// Elements that a kernel takes at once.
const LANES: usize = 8;

/// Each body's elements along a Hilbert curve (`skilling2004`), those of one life and level at a time, in pieces of a wanted size.
/// `domain` says what a body belongs to, by its number.
pub(super) fn cut(
    (mesh, bodies, elements): (&Mesh, &[Body], &Elements),
    levels: &Levels,
    wanted: Option<usize>,
    domain: impl Fn(usize) -> Domain,
) -> Vec<Patch> {
    let mut patches = Vec::new();
    // Those of a level alone are evaluated in a step.
    let mut counts = vec![0; usize::from(levels.coarsest()) + 1];
    let all = bodies.iter().flat_map(|body| &body.elements);
    all.for_each(|&e| counts[usize::from(levels.of_element(e))] += 1);
    let sizes: Vec<usize> = counts.into_iter().map(patch_size).collect();
    for (b, body) in bodies.iter().enumerate() {
        let mut lots: BTreeMap<(Life, bool, bool, bool, u8), Vec<u32>> = BTreeMap::new();
        let is_brick = |&e: &u32| {
            hex(mesh, e as usize).is_ok_and(|hex| match body.quadrature {
                Quadrature::OnePoint => hex.upright().is_some(),
                Quadrature::Full | Quadrature::Layered(_) => body.material.has_bricks() && hex.is_brick(),
            })
        };
        let bricks: Vec<bool> = body.elements.par_iter().map(is_brick).collect();
        for (&e, brick) in body.elements.iter().zip(bricks) {
            let viscous = elements.viscosity[e as usize] > 0.0;
            let (life, takes_over) = (elements.lives[e as usize], elements.successors.contains_key(&e));
            let lot = (life, takes_over, viscous, brick, levels.of_element(e));
            lots.entry(lot).or_default().push(e);
        }
        for ((life, takes_over, viscous, bricks, level), lot) in lots {
            let centroids: Vec<[f64; 3]> = lot.iter().map(|&e| centroid(mesh, e)).collect();
            let order: Vec<u32> = hilbert_order(&centroids).into_iter().map(|i| lot[i as usize]).collect();
            let most = wanted.unwrap_or(sizes[usize::from(level)] / costs(body.quadrature));
            patches.extend(order.chunks(even(lot.len(), most)).map(|elements| Patch {
                body: b,
                domain: domain(b),
                life,
                viscous,
                takes_over,
                bricks,
                level,
                elements: elements.to_vec(),
            }));
        }
    }
    patches
}
