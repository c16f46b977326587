//! Laws behind a wall: what the model needs of a material without knowing its type.

use crate::part::Part;
use crate::solid::{Full, FullBricks, Layered, OnePoint, PoresOf, Solid};
use std::sync::Arc;
use tremolite_laws::band::Band;
use tremolite_laws::materials::Elastic;
use tremolite_laws::parameter::Derived;
use tremolite_laws::shapes::hex8::{
    BrickField, BrickGeometry, Hex8, LayeredGeometry, OnePointGeometry, Quadrature,
};
use tremolite_laws::{BadParameter, Column, Isa, LawInfo, Material, Moduli, Softens, Values};

/// A law with its parameters, ready to make patches of elements.
pub trait AnyMaterial: Send + Sync {
    fn info(&self) -> LawInfo;
    /// See [`Material::columns`].
    fn columns(&self) -> &'static [Column];
    /// The values that it was made from.
    fn values(&self) -> &Values;
    /// The material's own elastic moduli: wave speeds and boundaries go by them.
    fn moduli(&self) -> Moduli;
    /// The stiffest moduli it can show: the time step goes by them.
    fn stiffest(&self) -> Moduli;
    /// Those of the law itself, without Maxwell bodies: what it shows while time stands still.
    fn relaxed(&self) -> Moduli;
    /// See [`Material::size_limit`].
    fn size_limit(&self) -> f64;
    /// See [`Material::softens`].
    fn softens(&self) -> Softens;
    /// See [`Material::crack_energy`].
    fn crack_energy(&self, extent: f64) -> Option<f64>;
    /// See [`Material::corner_strength`].
    fn corner_strength(&self, extent: f64) -> Option<f64>;
    /// See [`Material::derived`]; of a law with damping over a band also its relaxed modulus.
    fn derived(&self, extents: [f64; 2]) -> Vec<Derived>;
    /// See [`Material::compressive_strength`].
    fn compressive_strength(&self) -> Option<f64>;
    /// See [`Material::tension_use`]; `history` is that of a point.
    fn tension_use(&self, stress: &[f64; 6], beside: &[f64; 6], history: &[f64]) -> Option<f64>;
    /// See [`Material::uses_at_most`].
    fn uses_at_most(&self, stress: &[f64; 6], share: f64) -> bool;
    /// The Maxwell bodies beside the law, if there are any.
    fn band(&self) -> Option<Band>;
    /// See [`Material::warnings`].
    fn warnings(&self) -> Vec<String>;
    /// Whether bricks of several points have kernels of their own ([`AnyMaterial::patch`]). Laws see strains along the edges there, so
    /// the history must know of no axes: that of a law that damages, or none.
    fn has_bricks(&self) -> bool;
    /// A patch of hexahedra of this material. One-point elements of which all are bricks with natural axes along x, y and z
    /// ([`Hex8::upright`]) get kernels for those, and so do bricks of several points, wherever their edges point, of a law that damages or
    /// has no history ([`Hex8::is_brick`]). `corners` index `nodes`, which are the patch's (of layered elements numbered so that
    /// ζ is their thickness, [`tremolite_laws::shapes::hex8::turned`], as their geometry is), and `viscosity` is that of each
    /// element over its stiffness \[s\], or empty. `sizes` are the size tensors \[m²\] that the law is to see, or empty for the
    /// elements' own. `pores` are those of each element whose water changes its pressure in the shaking, or empty.
    fn patch(
        &self,
        quadrature: Quadrature,
        nodes: Vec<u32>,
        corners: &[[u16; 8]],
        geometry: &[Hex8],
        viscosity: &[f64],
        sizes: &[[f64; 6]],
        pores: &[PoresOf],
        isa: Isa,
    ) -> Box<dyn Part>;
}

/// The order of corners of what need not be turned.
const STRAIGHT: [usize; 8] = [0, 1, 2, 3, 4, 5, 6, 7];

/// Any law of the laws crate, or of a user's own.
struct Instance<M> {
    /// With a band, the law with relaxed moduli.
    law: Arc<M>,
    /// The material's own moduli: with a band, meant at its reference frequency.
    own: Moduli,
    band: Option<Band>,
    values: Values,
}

impl<M: Material + 'static> AnyMaterial for Instance<M> {
    fn info(&self) -> LawInfo {
        LawInfo::of::<M>()
    }

    fn columns(&self) -> &'static [Column] {
        self.law.columns()
    }

    fn values(&self) -> &Values {
        &self.values
    }

    fn moduli(&self) -> Moduli {
        self.own
    }

    fn stiffest(&self) -> Moduli {
        self.band.map_or(self.own, |band| self.own.scaled(band.unrelaxed()))
    }

    fn relaxed(&self) -> Moduli {
        self.law.moduli()
    }

    fn size_limit(&self) -> f64 {
        self.law.size_limit()
    }

    fn softens(&self) -> Softens {
        self.law.softens()
    }

    fn crack_energy(&self, extent: f64) -> Option<f64> {
        self.law.crack_energy(extent)
    }

    fn corner_strength(&self, extent: f64) -> Option<f64> {
        self.law.corner_strength(extent)
    }

    fn derived(&self, extents: [f64; 2]) -> Vec<Derived> {
        let doc = "E of the law beside the Maxwell bodies, for slow loading: thresholds f_t/E and limits of size go by it";
        let relaxed = || Derived::new("relaxed_young", self.law.moduli().young(), "Pa", doc);
        let mut all: Vec<Derived> = self.band.iter().map(|_| relaxed()).collect();
        all.extend(self.law.derived(extents));
        all
    }

    fn compressive_strength(&self) -> Option<f64> {
        self.law.compressive_strength()
    }

    fn tension_use(&self, stress: &[f64; 6], beside: &[f64; 6], history: &[f64]) -> Option<f64> {
        let mut own = tremolite_laws::virgin::<M>();
        own.as_mut().copy_from_slice(history);
        self.law.tension_use(stress, beside, &own)
    }

    fn uses_at_most(&self, stress: &[f64; 6], share: f64) -> bool {
        self.law.uses_at_most(stress, share)
    }

    fn band(&self) -> Option<Band> {
        self.band
    }

    fn warnings(&self) -> Vec<String> {
        self.law.warnings()
    }

    fn has_bricks(&self) -> bool {
        M::DAMAGES || M::HISTORY.is_empty()
    }

    fn patch(
        &self,
        quadrature: Quadrature,
        nodes: Vec<u32>,
        corners: &[[u16; 8]],
        geometry: &[Hex8],
        viscosity: &[f64],
        sizes: &[[f64; 6]],
        pores: &[PoresOf],
        isa: Isa,
    ) -> Box<dyn Part> {
        let (law, own, band) = (self.law.clone(), self.own, self.band);
        macro_rules! solid {
            ($rule:expr) => {
                Box::new(Solid::new(
                    $rule, law, own, band, nodes, corners, geometry, viscosity, sizes, pores, isa,
                ))
            };
        }
        // Said outright, so that kernels that no patch can have are not compiled.
        let bricks = (M::DAMAGES || M::HISTORY.is_empty()) && geometry.iter().all(Hex8::is_brick);
        match quadrature {
            Quadrature::OnePoint if geometry.iter().all(|hex| hex.upright() == Some(STRAIGHT)) => {
                solid!(OnePoint::<BrickGeometry>::default())
            }
            Quadrature::OnePoint => solid!(OnePoint::<OnePointGeometry>::default()),
            Quadrature::Full if bricks => solid!(FullBricks),
            Quadrature::Full => solid!(Full),
            Quadrature::Layered(layers) if bricks => solid!(Layered::<BrickField>::new(layers)),
            Quadrature::Layered(layers) => solid!(Layered::<LayeredGeometry>::new(layers)),
        }
    }
}

/// A checked material, or every value that its law refuses.
pub type Built = Result<Arc<dyn AnyMaterial>, Vec<BadParameter>>;

fn instance<M: Material + 'static>(law: M, values: Values) -> Arc<dyn AnyMaterial> {
    Arc::new(Instance { own: law.moduli(), law: Arc::new(law), band: None, values })
}

/// An elastic material.
// Inlined into another crate it would be compiled there, kernels and all.
#[inline(never)]
pub fn elastic(moduli: Moduli) -> Arc<dyn AnyMaterial> {
    let values = Values::default().with("young", moduli.young()).with("poisson", moduli.poisson());
    instance(Elastic::from_moduli(moduli), values)
}

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
    /// The entry of law `M`, which need not be in the list of the laws crate. Its kernels are compiled where this is
    /// called, so call it once. A law may have up to 64 columns of history.
    pub fn of<M: Material + 'static>() -> Self {
        Law {
            info: LawInfo::of::<M>(),
            build: |values| Ok(instance(M::new(values)?, values.clone())),
            build_banded: |values, band| {
                let law = M::new(values)?;
                let own = law.moduli();
                let law = Arc::new(law.scaled(band.relaxed()));
                Ok(Arc::new(Instance { law, own, band: Some(band), values: values.clone() }))
            },
        }
    }
}

macro_rules! entries {
    ($($law:ty,)*) => { vec![$(Law::of::<$law>()),*] };
}

/// All laws of the laws crate.
#[inline(never)]
pub fn laws() -> Vec<Law> {
    tremolite_laws::for_each_material!(entries)
}
