//! Stresses as they are given: the nodal forces of what elements carry without their stabilisation.

use tremolite_laws::materials::Elastic;
use tremolite_laws::{BadParameter, Column, Lane, Material, Moduli, Parameter, Point, Sym, Values};

const fn column(name: &'static str) -> Column {
    Column::new(name, "Pa", "the stress")
}

/// The law: its history is the stress, whatever the strain.
pub(super) struct Prescribed(pub Moduli);

impl Material for Prescribed {
    const NAME: &'static str = "prescribed";
    const SUMMARY: &'static str = "a given stress";
    const SOURCE: &'static str = "none";
    const PARAMETERS: &'static [Parameter] = Elastic::PARAMETERS;
    const HISTORY: &'static [Column] =
        &[column("sxx"), column("syy"), column("szz"), column("sxy"), column("syz"), column("szx")];
    type History<L: Lane> = [L; 6];

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        Elastic::new(values).map(|law| Prescribed(law.moduli()))
    }

    fn moduli(&self) -> Moduli {
        self.0
    }

    fn scaled(&self, factor: f64) -> Self {
        Prescribed(self.0.scaled(factor))
    }

    #[inline(always)]
    fn hourglass_share<L: Lane>(&self, _: &[L; 6]) -> L {
        L::splat(0.0)
    }

    #[inline(always)]
    fn update<L: Lane>(&self, _: &Point<L>, _: Sym<L>, stress: [L; 6]) -> (Sym<L>, [L; 6]) {
        (stress, stress)
    }
}
