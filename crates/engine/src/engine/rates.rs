//! Products with the stiffness that ξ ≠ 0 needs.

use super::measure::measure;
use super::node_step::Products;
use super::product::{self, Product};
use crate::assembly::Assembly;
use crate::model::Model;
use crate::parts::Kept;
use crate::phase::Phase;
use crate::ranks::Ranks;
use crate::state::State;
use tremolite_laws::Row;

/// The products, and room for them; empty where ξ is 0.
#[derive(Clone, Debug, Default)]
pub(super) struct Rates {
    pub products: Products,
    velocity: Vec<Row>,
    contributions: Vec<Row>,
}

impl Rates {
    /// Room for the products, if the model needs them.
    pub fn new(model: &Model, assembly: &Assembly, phase: &Phase) -> Self {
        if model.scheme.rayleigh.stiffness == 0.0 {
            return Rates::default();
        }
        let zero = vec![Row::ZERO; model.mesh_node.len()];
        Rates {
            products: Products { minus: zero.clone(), hat: zero.clone() },
            velocity: zero,
            contributions: phase.room(assembly),
        }
    }

    /// Room for contributions to them.
    pub fn contributions(&self) -> &[Row] {
        &self.contributions
    }

    /// Both products at the state, whose forces are in `contributions`, with what parts remember there.
    pub fn update(
        &mut self,
        model: &Model,
        assembly: &Assembly,
        phase: &Phase,
        contributions: &[Row],
        state: &State,
        kept: Kept,
        ranks: Option<&Ranks>,
    ) {
        if model.scheme.rayleigh.stiffness == 0.0 {
            return;
        }
        let Rates { products, velocity, contributions: own } = self;
        for (v, du) in velocity.iter_mut().zip(&state.du) {
            *v = Row(du.0.map(|d| d / state.dt));
        }
        let damping = Product::Damping(&state.u, kept);
        product::times(assembly, phase, damping, velocity, own, &mut products.minus, ranks);
        // Tied nodes move as their masters, of which alone v̂ is worked out.
        *velocity = measure(model, phase, contributions, products, state).velocity;
        product::times(assembly, phase, damping, velocity, own, &mut products.hat, ranks);
    }
}
