//! Linear isotropic elasticity.

use crate::lane::Lane;
use crate::material::{Material, Moduli, Point, Sym};
use crate::parameter::{BadParameter, Column, Dimension, Kind, Need, Parameter, Values};

/// σ = λ tr(ε) I + 2μ ε (Hooke). No damage, no yielding, no rate.
#[derive(Clone, Copy, Debug)]
pub struct Elastic {
    moduli: Moduli,
}

/// Young's modulus, as every elastic law names it.
pub const YOUNG: Parameter = Parameter {
    name: "young",
    kind: Kind::Number(Dimension::PRESSURE),
    need: Need::Required,
    doc: "Young's modulus E",
};

/// Poisson's ratio, as every elastic law names it.
pub const POISSON: Parameter = Parameter {
    name: "poisson",
    kind: Kind::Number(Dimension::NONE),
    need: Need::Required,
    doc: "Poisson's ratio ν, from 0 up to below 0.5",
};

/// Reads and checks E and ν, for any law that starts from them.
///
/// # Errors
/// E ≤ 0, ν outside \[0, 0.5), or a missing value.
pub fn read_moduli(values: &Values) -> Result<Moduli, Vec<BadParameter>> {
    let young =
        values.number_where("young", |e| e > 0.0, "must be positive", "for rock 1 to 80 GPa is usual");
    let poisson = values.number_where(
        "poisson",
        |nu| (0.0..0.5).contains(&nu),
        "must be at least 0 and below 0.5",
        "for rock and concrete 0.15 to 0.35 is usual",
    );
    match (young, poisson) {
        (Ok(e), Ok(nu)) => Ok(Moduli::from_young_poisson(e, nu)),
        (e, nu) => Err([e.err(), nu.err()].into_iter().flatten().collect()),
    }
}

/// A sentence where E is less than 100 times the uniaxial compressive strength f_c \[Pa\], as no rock or concrete is:
/// most have 200 to 1000.
pub(super) fn soft_for_its_strength(moduli: &Moduli, fc: f64) -> Option<String> {
    let young = moduli.young();
    (young < 100.0 * fc).then(|| {
        format!(
            "young = {:.3} GPa is only {:.0} times the uniaxial compressive strength of {:.3} MPa, where 200 to 1000 \
             times is usual: one of the two looks wrong by its unit",
            young / 1e9,
            young / fc,
            fc / 1e6
        )
    })
}

impl Elastic {
    /// The law with given moduli, checked already.
    pub const fn from_moduli(moduli: Moduli) -> Self {
        Elastic { moduli }
    }
}

impl Material for Elastic {
    const NAME: &'static str = "elastic";
    const SUMMARY: &'static str = "linear isotropic elasticity";
    const SOURCE: &'static str = "wang2018, effective stress above (2)";
    const PARAMETERS: &'static [Parameter] = &[YOUNG, POISSON];
    const HISTORY: &'static [Column] = &[];
    type History<L: Lane> = [L; 0];

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        Ok(Elastic { moduli: read_moduli(values)? })
    }

    fn moduli(&self) -> Moduli {
        self.moduli
    }

    fn scaled(&self, factor: f64) -> Self {
        Elastic { moduli: self.moduli.scaled(factor) }
    }

    #[inline(always)]
    fn update<L: Lane>(&self, _: &Point<L>, e: Sym<L>, history: [L; 0]) -> (Sym<L>, [L; 0]) {
        (self.moduli.stress(&e), history)
    }
}
