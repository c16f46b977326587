//! Elasticity of what damage has left: the K of Rayleigh's ξK and of artificial viscosity in bodies that lose stiffness.

use std::sync::Arc;
use tremolite_laws::materials::Elastic;
use tremolite_laws::shapes::hex8::LEFT;
use tremolite_laws::{
    BadParameter, Column, InPlace, Lane, Material, Moduli, Octet, Parameter, Point, Sym, Values,
};

const fn column(name: &'static str) -> Column {
    Column::new(name, "1", "what damage has left")
}

/// The law; its history holds what is left ([`LEFT`]) and a factor, and stays as it is.
pub struct Weakened(pub Moduli);

impl Material for Weakened {
    const NAME: &'static str = "weakened";
    const SUMMARY: &'static str = "elasticity of what damage has left";
    const SOURCE: &'static str = "wang2018, damage of (7) on the damping of (19)";
    const PARAMETERS: &'static [Parameter] = Elastic::PARAMETERS;
    const HISTORY: &'static [Column] = &[
        column("left_xx"),
        column("left_yy"),
        column("left_zz"),
        column("left_xy"),
        column("left_yz"),
        column("left_zx"),
        column("left_hourglass"),
        Column::new("factor", "1 or s", "all stresses are multiplied by it"),
    ];
    type History<L: Lane> = [L; LEFT];

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        Elastic::new(values).map(|law| Weakened(law.moduli()))
    }

    fn moduli(&self) -> Moduli {
        self.0
    }

    fn scaled(&self, factor: f64) -> Self {
        Weakened(self.0.scaled(factor))
    }

    #[inline(always)]
    fn hourglass_share<L: Lane>(&self, left: &[L; LEFT]) -> L {
        left[6] * left[7]
    }

    #[inline(always)]
    fn update<L: Lane>(&self, _: &Point<L>, e: Sym<L>, left: [L; LEFT]) -> (Sym<L>, [L; LEFT]) {
        let v = [left[0], left[1], left[2], left[3], left[4], left[5]];
        let mut stress = self.0.stress(&e);
        // A closed crack leaves V at I but for the round-off of its axes: it carries all, whatever is in other lanes.
        let lessened = (v[0] + v[1] + v[2]).less(L::splat(3.0));
        if L::any(lessened) {
            let left = self.0.stress_left(&e, &v);
            let mut k = 0;
            while k < 6 {
                stress[k] = L::select(lessened, left[k], stress[k]);
                k += 1;
            }
        }
        let mut k = 0;
        while k < 6 {
            stress[k] = left[7] * stress[k];
            k += 1;
        }
        (stress, left)
    }

    #[inline(always)]
    fn update_in_place<L: Lane>(
        &self,
        point: &Point<L>,
        e: Sym<L>,
        left: &mut [Octet],
        at: usize,
    ) -> InPlace<L> {
        let mut kept = [L::splat(0.0); LEFT];
        let mut k = 0;
        while k < LEFT {
            kept[k] = L::load(&left[k], at);
            k += 1;
        }
        let (zero, one) = (L::splat(0.0), L::splat(1.0));
        let (stress, _) = self.update(point, e, kept);
        InPlace { stress, left: [one, one, one, zero, zero, zero], before: one, now: one }
    }
}

/// A law of which nothing is asked but what its history has left: no stress, no update.
pub(super) struct Remembered<M>(pub Arc<M>);

impl<M: Material> Material for Remembered<M> {
    const NAME: &'static str = M::NAME;
    const SUMMARY: &'static str = M::SUMMARY;
    const SOURCE: &'static str = M::SOURCE;
    const PARAMETERS: &'static [Parameter] = M::PARAMETERS;
    const HISTORY: &'static [Column] = M::HISTORY;
    const DAMAGES: bool = M::DAMAGES;
    const DISSIPATION: Option<usize> = None;
    const CREATION: Option<usize> = None;
    type History<L: Lane> = M::History<L>;

    fn columns(&self) -> &'static [Column] {
        self.0.columns()
    }

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        M::new(values).map(|law| Remembered(Arc::new(law)))
    }

    fn moduli(&self) -> Moduli {
        self.0.moduli()
    }

    fn scaled(&self, factor: f64) -> Self {
        Remembered(Arc::new(self.0.scaled(factor)))
    }

    #[inline(always)]
    fn integrity<L: Lane>(&self, strain: &Sym<L>, history: &M::History<L>) -> Sym<L> {
        self.0.integrity(strain, history)
    }

    #[inline(always)]
    fn hourglass_share<L: Lane>(&self, history: &M::History<L>) -> L {
        self.0.hourglass_share(history)
    }

    #[inline(always)]
    fn update<L: Lane>(&self, _: &Point<L>, _: Sym<L>, history: M::History<L>) -> (Sym<L>, M::History<L>) {
        ([L::splat(0.0); 6], history)
    }
}
