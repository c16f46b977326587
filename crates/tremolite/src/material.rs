//! Laws behind a wall: what the model needs of a material without knowing its type.

use crate::parts::solid::{Full, OnePoint, Solid};
use crate::parts::{Part, Quadrature};
use std::sync::Arc;
use tremolite_laws::shapes::hex8::Hex8;
use tremolite_laws::{BadParameter, Isa, LawInfo, Material, Moduli, Values};

/// A law with its parameters, ready to make patches of elements.
pub trait AnyMaterial: Send + Sync {
    fn info(&self) -> LawInfo;
    fn moduli(&self) -> Moduli;
    /// A patch of hexahedra of this material; `corners` index `nodes`, which are the patch's.
    fn patch(
        &self,
        quadrature: Quadrature,
        nodes: Vec<u32>,
        corners: &[[u16; 8]],
        geometry: &[Hex8],
        isa: Isa,
    ) -> Box<dyn Part>;
}

/// Any law of the laws crate, or of a user's own.
pub struct Instance<M>(pub Arc<M>);

impl<M: Material> AnyMaterial for Instance<M> {
    fn info(&self) -> LawInfo {
        LawInfo::of::<M>()
    }

    fn moduli(&self) -> Moduli {
        self.0.moduli()
    }

    fn patch(
        &self,
        quadrature: Quadrature,
        nodes: Vec<u32>,
        corners: &[[u16; 8]],
        geometry: &[Hex8],
        isa: Isa,
    ) -> Box<dyn Part> {
        let law = self.0.clone();
        match quadrature {
            Quadrature::OnePoint => Box::new(Solid::<M, OnePoint>::new(law, nodes, corners, geometry, isa)),
            Quadrature::Full => Box::new(Solid::<M, Full>::new(law, nodes, corners, geometry, isa)),
        }
    }
}

/// One entry of the registry of laws.
#[derive(Clone, Copy)]
pub struct Law {
    pub info: LawInfo,
    /// A checked instance from values in SI.
    pub build: fn(&Values) -> Result<Arc<dyn AnyMaterial>, Vec<BadParameter>>,
}

impl Law {
    /// The entry of law `M`, which need not be in the list of the laws crate.
    pub fn of<M: Material>() -> Self {
        Law { info: LawInfo::of::<M>(), build: |values| Ok(Arc::new(Instance(Arc::new(M::new(values)?)))) }
    }
}

macro_rules! entries {
    ($($law:ty,)*) => { vec![$(Law::of::<$law>()),*] };
}

/// All laws of the laws crate.
pub fn laws() -> Vec<Law> {
    tremolite_laws::for_each_material!(entries)
}
