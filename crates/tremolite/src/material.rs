//! Laws behind a wall: what the model needs of a material without knowing its type.

use crate::parts::solid::{Full, OnePoint, Solid};
use crate::parts::{Part, Quadrature};
use std::sync::Arc;
use tremolite_laws::band::Band;
use tremolite_laws::parameter::Derived;
use tremolite_laws::shapes::hex8::Hex8;
use tremolite_laws::{BadParameter, Isa, LawInfo, Material, Moduli, Values};

/// A law with its parameters, ready to make patches of elements.
pub trait AnyMaterial: Send + Sync {
    fn info(&self) -> LawInfo;
    /// The material's own elastic moduli: wave speeds and boundaries go by them.
    fn moduli(&self) -> Moduli;
    /// The stiffest moduli it can show: the time step goes by them.
    fn stiffest(&self) -> Moduli {
        self.moduli()
    }
    /// See [`Material::size_limit`].
    fn size_limit(&self) -> f64;
    /// See [`Material::crack_energy`].
    fn crack_energy(&self, extent: f64) -> Option<f64>;
    /// See [`Material::derived`]; of a law with damping over a band also its relaxed modulus.
    fn derived(&self, extents: [f64; 2]) -> Vec<Derived>;
    /// The Maxwell bodies beside the law, if there are any.
    fn band(&self) -> Option<Band> {
        None
    }
    /// See [`Material::warnings`].
    fn warnings(&self) -> Vec<String>;
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

    fn size_limit(&self) -> f64 {
        self.0.size_limit()
    }

    fn crack_energy(&self, extent: f64) -> Option<f64> {
        self.0.crack_energy(extent)
    }

    fn derived(&self, extents: [f64; 2]) -> Vec<Derived> {
        self.0.derived(extents)
    }

    fn warnings(&self) -> Vec<String> {
        self.0.warnings()
    }

    fn patch(
        &self,
        quadrature: Quadrature,
        nodes: Vec<u32>,
        corners: &[[u16; 8]],
        geometry: &[Hex8],
        isa: Isa,
    ) -> Box<dyn Part> {
        patch(&self.0, self.moduli(), None, quadrature, nodes, corners, geometry, isa)
    }
}

/// A law with damping over a band beside it.
pub struct Banded<M> {
    /// The law with relaxed moduli.
    law: Arc<M>,
    band: Band,
    /// The material's own moduli, meant at the band's reference frequency.
    own: Moduli,
}

impl<M: Material> AnyMaterial for Banded<M> {
    fn info(&self) -> LawInfo {
        LawInfo::of::<M>()
    }

    fn moduli(&self) -> Moduli {
        self.own
    }

    fn size_limit(&self) -> f64 {
        self.law.size_limit()
    }

    fn crack_energy(&self, extent: f64) -> Option<f64> {
        self.law.crack_energy(extent)
    }

    fn derived(&self, extents: [f64; 2]) -> Vec<Derived> {
        let relaxed = self.law.moduli().young();
        let doc = "E of the law beside the Maxwell bodies, for slow loading: thresholds f_t/E and limits of size go by it";
        let mut all = vec![Derived::new("relaxed_young", relaxed, "Pa", doc)];
        all.extend(self.law.derived(extents));
        all
    }

    fn band(&self) -> Option<Band> {
        Some(self.band)
    }

    fn warnings(&self) -> Vec<String> {
        self.law.warnings()
    }

    fn stiffest(&self) -> Moduli {
        self.own.scaled(self.band.unrelaxed())
    }

    fn patch(
        &self,
        quadrature: Quadrature,
        nodes: Vec<u32>,
        corners: &[[u16; 8]],
        geometry: &[Hex8],
        isa: Isa,
    ) -> Box<dyn Part> {
        patch(&self.law, self.own, Some(self.band), quadrature, nodes, corners, geometry, isa)
    }
}

fn patch<M: Material>(
    law: &Arc<M>,
    moduli: Moduli,
    band: Option<Band>,
    quadrature: Quadrature,
    nodes: Vec<u32>,
    corners: &[[u16; 8]],
    geometry: &[Hex8],
    isa: Isa,
) -> Box<dyn Part> {
    let law = law.clone();
    match quadrature {
        Quadrature::OnePoint => {
            Box::new(Solid::<M, OnePoint>::new(law, moduli, band, nodes, corners, geometry, isa))
        }
        Quadrature::Full => Box::new(Solid::<M, Full>::new(law, moduli, band, nodes, corners, geometry, isa)),
    }
}

/// A checked material, or every value that its law refuses.
pub type Built = Result<Arc<dyn AnyMaterial>, Vec<BadParameter>>;

/// One entry of the registry of laws.
#[derive(Clone, Copy)]
pub struct Law {
    pub info: LawInfo,
    /// A checked instance from values in SI.
    pub build: fn(&Values) -> Built,
    /// The same with damping over a band: the law gets the modulus that makes the whole as stiff as given at the
    /// band's reference frequency.
    pub build_banded: fn(&Values, Band) -> Built,
}

impl Law {
    /// The entry of law `M`, which need not be in the list of the laws crate.
    pub fn of<M: Material>() -> Self {
        Law {
            info: LawInfo::of::<M>(),
            build: |values| Ok(Arc::new(Instance(Arc::new(M::new(values)?)))),
            build_banded: |values, band| {
                let own = M::new(values)?.moduli();
                let relaxed = values.clone().with("young", band.relaxed() * own.young());
                Ok(Arc::new(Banded { law: Arc::new(M::new(&relaxed)?), band, own }))
            },
        }
    }
}

macro_rules! entries {
    ($($law:ty,)*) => { vec![$(Law::of::<$law>()),*] };
}

/// All laws of the laws crate.
pub fn laws() -> Vec<Law> {
    tremolite_laws::for_each_material!(entries)
}
