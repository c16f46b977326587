//! A law that hands back the strain: a probe of such a part reads the strains that another law sees at its points.

use tremolite_laws::materials::Elastic;
use tremolite_laws::{BadParameter, Column, Lane, Material, Moduli, Parameter, Point, Sym, Values};

/// The law. The moduli are those of the law whose strains are wanted: they shape the field within an element.
pub struct Strain(pub Moduli);

impl Material for Strain {
    const NAME: &'static str = "strain";
    const SUMMARY: &'static str = "the strain in place of the stress";
    const SOURCE: &'static str = "no law: a reading of the elements' strains";
    const PARAMETERS: &'static [Parameter] = Elastic::PARAMETERS;
    const HISTORY: &'static [Column] = &[];
    type History<L: Lane> = [L; 0];

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        Elastic::new(values).map(|law| Strain(law.moduli()))
    }

    fn moduli(&self) -> Moduli {
        self.0
    }

    #[inline(always)]
    fn update<L: Lane>(&self, _: &Point<L>, strain: Sym<L>, old: [L; 0]) -> (Sym<L>, [L; 0]) {
        (strain, old)
    }
}
