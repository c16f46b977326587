//! Patches: the elements of a model, cut into pieces that one thread works on.

use super::Draft;
use crate::hexahedra::{centroid, hex};
use crate::life::Life;
use crate::node_table::Domain;
use std::collections::BTreeMap;
use tremolite_kernels::Quadrature;
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
    /// Whether they are one-point elements of the simplest shape, bricks with edges along the axes
    /// ([`Hex8::upright`](tremolite_laws::shapes::hex8::Hex8::upright)), which have kernels of their own.
    pub bricks: bool,
    /// Indices into the model's elements, in the order of lanes.
    pub elements: Vec<u32>,
}

/// Elements a patch: enough patches to share out small models, large ones for locality.
fn patch_size(wanted: Option<usize>, elements: usize) -> usize {
    wanted.unwrap_or((elements / 64).clamp(64, 512)).max(1).next_multiple_of(8)
}

/// Each body's elements along a Hilbert curve (`skilling2004`), those of one life at a time, in pieces of a wanted size.
/// `domain` says what a body belongs to, by its number.
pub(super) fn cut(draft: &Draft, wanted: Option<usize>, domain: impl Fn(usize) -> Domain) -> Vec<Patch> {
    let Draft { mesh, bodies, elements, .. } = draft;
    let mut patches = Vec::new();
    let size = patch_size(wanted, bodies.iter().map(|b| b.elements.len()).sum());
    for (b, body) in bodies.iter().enumerate() {
        let mut lots: BTreeMap<(Life, bool, bool, bool), Vec<u32>> = BTreeMap::new();
        for &e in &body.elements {
            let viscous = elements.viscosity[e as usize] > 0.0;
            let brick = body.quadrature == Quadrature::OnePoint
                && hex(mesh, e as usize).is_ok_and(|hex| hex.upright().is_some());
            let lot = (elements.lives[e as usize], elements.successors.contains_key(&e), viscous, brick);
            lots.entry(lot).or_default().push(e);
        }
        for ((life, takes_over, viscous, bricks), lot) in lots {
            let centroids: Vec<[f64; 3]> = lot.iter().map(|&e| centroid(mesh, e)).collect();
            let order: Vec<u32> = hilbert_order(&centroids).into_iter().map(|i| lot[i as usize]).collect();
            patches.extend(order.chunks(size).map(|elements| Patch {
                body: b,
                domain: domain(b),
                life,
                viscous,
                takes_over,
                bricks,
                elements: elements.to_vec(),
            }));
        }
    }
    patches
}
