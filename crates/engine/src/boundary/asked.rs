//! What a problem asks of its boundaries.

use super::bed::Bed;
use crate::error::ModelError;
use crate::free_field::{FreeField, GivenField, Incident};
use crate::prescribed::Prescribed;
use std::sync::Arc;

/// What holds or leaves a pair of opposite vertical sides.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Side {
    /// No traction.
    #[default]
    Free,
    /// No displacement.
    Fixed,
    /// No displacement normal to the side.
    Roller,
    /// Dashpots ρc_p, ρc_s (Lysmer & Kuhlemeyer 1969).
    Viscous,
    /// Opposite nodes move as one.
    Periodic,
    /// A slab of the same ground stands outside, moves as the ground would without end, and passes on what it feels.
    FreeField,
}

impl Side {
    /// One of each, for tests that go over all: enter what is added.
    pub const EXAMPLES: [Side; 6] =
        [Side::Free, Side::Fixed, Side::Roller, Side::Viscous, Side::Periodic, Side::FreeField];

    /// What it is before the shaking, where its ground stands against others.
    pub fn before(self) -> Side {
        match self {
            Side::Periodic | Side::Fixed => self,
            _ => Side::Roller,
        }
    }

    /// Whether ground goes on beyond it that is not in the model: openings should keep away from it.
    pub fn ends_ground(self) -> bool {
        !matches!(self, Side::Periodic | Side::Free)
    }
}

/// What acts on the top plane in the shaking.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Top {
    /// No traction: the surface of the ground.
    #[default]
    Free,
    /// Dashpots ρc_p, ρc_s: ground goes on above, and what its surface would send back is missing.
    Viscous,
}

/// What holds or drives the base.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Base {
    #[default]
    Free,
    Fixed,
    /// Dashpots, through which the incident wave enters.
    Viscous,
    /// Dashpots and springs α G/R on the motion scattered by the caverns.
    ViscousSpring {
        /// α_N (normal).
        normal: f64,
        /// α_T (tangential).
        tangential: f64,
        /// R \[m\], from the source of scattering to the base; by default from the centre of what is excavated.
        distance: Option<f64>,
    },
}

impl Base {
    /// Whether springs act, which need the free field of a reference column.
    pub fn has_springs(&self) -> bool {
        matches!(self, Base::ViscousSpring { normal, tangential, .. } if *normal != 0.0 || *tangential != 0.0)
    }
}

/// All that is asked of a model's boundaries.
#[derive(Clone)]
pub struct Boundaries {
    pub base: Base,
    /// Sides normal to x and to y.
    pub sides: [Side; 2],
    /// Whether the springs of the base stand at free-field sides as well; ground beside the model leads them.
    pub side_springs: bool,
    pub top: Top,
    /// What holds the sides and the base before the shaking.
    pub bed: Bed,
    /// What is moved before the shaking.
    pub prescribed: Vec<Prescribed>,
    /// Components held at single nodes of the mesh.
    pub held: Vec<(u32, [bool; 3])>,
    /// Nodes of the mesh that move as one, beside those of periodic sides, slabs and columns.
    pub ties: Vec<(u32, u32)>,
    /// A wave that rises through the base.
    pub incident: Option<Incident>,
    /// Known in advance, in place of slabs and columns.
    pub free_field: Option<Arc<dyn GivenField>>,
}

impl Boundaries {
    /// Refuses what no model can have at once.
    ///
    /// # Errors
    /// If waves come both in a given free field and beside it, or the base does not let those of a given one in.
    pub(crate) fn check(&self) -> Result<(), ModelError> {
        if self.free_field.is_some() && self.incident.is_some() {
            let reason =
                "a free field is given, and a wave that rises beside it; let the field hold all waves";
            return Err(ModelError::FreeField(reason.into()));
        }
        if self.free_field.is_some() && matches!(self.base, Base::Free | Base::Fixed) {
            let reason = "a free field is given, and the base is free or fixed; let it absorb, so that the field comes in";
            return Err(ModelError::FreeField(reason.into()));
        }
        if self.side_springs && (!self.base.has_springs() || self.free_sides() == [false; 2]) {
            let reason =
                "springs of the sides need a base with springs and a free-field side; take side_springs out";
            return Err(ModelError::FreeField(reason.into()));
        }
        if self.side_springs && self.free_field.is_some() {
            let reason = "springs of the sides act on ground beside the model, and a free field is given; take side_springs out";
            return Err(ModelError::FreeField(reason.into()));
        }
        Ok(())
    }

    /// The free field by which waves come in.
    pub(crate) fn waves(&self) -> FreeField {
        FreeField::of(self.free_field.as_ref(), self.incident.as_ref())
    }

    /// Whether the sides normal to x and to y are free field.
    pub(crate) fn free_sides(&self) -> [bool; 2] {
        self.sides.map(|side| side == Side::FreeField)
    }
}
