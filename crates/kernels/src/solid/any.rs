//! Any law, in one lane at a time: the reference is compiled once for each quadrature, not once for each law in each quadrature.

use std::any::Any;
use tremolite_laws::{
    BadParameter, Column, Facts, History, InPlace, Lane, Material, Moduli, Octet, Parameter, Point, Sym,
    Values,
};

/// Columns of history that a law may have.
const MOST: usize = 64;

/// A law whose type is not known. Whatever calls its functions, they give the same bits. It has what kernels ask of a law; what parts
/// and the model ask stays with the law itself.
#[derive(Clone, Copy)]
pub(super) struct AnyLaw<'a> {
    law: &'a dyn OneLane,
    facts: Facts,
}

impl<'a> AnyLaw<'a> {
    pub fn of<M: Material>(law: &'a M) -> Self {
        const { assert!(M::HISTORY.len() <= MOST, "a law of more columns than `MOST`") };
        AnyLaw { law, facts: law.facts() }
    }
}

/// A law's functions in one lane. A history is as long as the longest; its first columns are the law's.
trait OneLane: Sync {
    fn moduli(&self) -> Moduli;
    fn integrity(&self, strain: &Sym<f64>, history: &[f64; MOST]) -> Sym<f64>;
    fn unbroken(&self, history: &[f64; MOST]) -> f64;
    fn hourglass_share(&self, history: &[f64; MOST]) -> f64;
    fn stored_energy(&self, strain: &Sym<f64>, stress: &Sym<f64>, history: &[f64; MOST]) -> f64;
    fn update(&self, point: &Point<f64>, strain: Sym<f64>, history: &mut [f64; MOST]) -> Sym<f64>;
    fn update_left(
        &self,
        point: &Point<f64>,
        strain: Sym<f64>,
        history: &mut [f64; MOST],
    ) -> (Sym<f64>, Sym<f64>);
    fn update_in_place(
        &self,
        point: &Point<f64>,
        strain: Sym<f64>,
        history: &mut [Octet],
        at: usize,
    ) -> InPlace<f64>;
}

/// The columns of law `M`.
fn own<M: Material>(history: &[f64; MOST]) -> M::History<f64> {
    let mut own = <M::History<f64> as History<f64>>::zero();
    own.as_mut().copy_from_slice(&history[..M::HISTORY.len()]);
    own
}

impl<M: Material> OneLane for M {
    fn moduli(&self) -> Moduli {
        Material::moduli(self)
    }

    fn integrity(&self, strain: &Sym<f64>, history: &[f64; MOST]) -> Sym<f64> {
        Material::integrity(self, strain, &own::<M>(history))
    }

    fn unbroken(&self, history: &[f64; MOST]) -> f64 {
        Material::unbroken(self, &own::<M>(history))
    }

    fn hourglass_share(&self, history: &[f64; MOST]) -> f64 {
        Material::hourglass_share(self, &own::<M>(history))
    }

    fn stored_energy(&self, strain: &Sym<f64>, stress: &Sym<f64>, history: &[f64; MOST]) -> f64 {
        Material::stored_energy(self, strain, stress, &own::<M>(history))
    }

    fn update(&self, point: &Point<f64>, strain: Sym<f64>, history: &mut [f64; MOST]) -> Sym<f64> {
        let (stress, new) = Material::update(self, point, strain, own::<M>(history));
        history[..M::HISTORY.len()].copy_from_slice(new.as_ref());
        stress
    }

    fn update_left(
        &self,
        point: &Point<f64>,
        strain: Sym<f64>,
        history: &mut [f64; MOST],
    ) -> (Sym<f64>, Sym<f64>) {
        let (stress, new, left) = Material::update_left(self, point, strain, own::<M>(history));
        history[..M::HISTORY.len()].copy_from_slice(new.as_ref());
        (stress, left)
    }

    fn update_in_place(
        &self,
        point: &Point<f64>,
        strain: Sym<f64>,
        history: &mut [Octet],
        at: usize,
    ) -> InPlace<f64> {
        Material::update_in_place(self, point, strain, history, at)
    }
}

/// What is of a lane's type as what it is, of one lane of 64 bits: [`AnyLaw`] is run in no other.
#[inline(always)]
fn same<T: Copy + 'static, U: Copy + 'static>(x: T) -> U {
    *(&x as &dyn Any).downcast_ref().expect("one lane")
}

impl Material for AnyLaw<'_> {
    const NAME: &'static str = "any";
    const SUMMARY: &'static str = "any law, in one lane";
    const SOURCE: &'static str = "none";
    const PARAMETERS: &'static [Parameter] = &[];
    const HISTORY: &'static [Column] = &[];
    type History<L: Lane> = [L; MOST];

    fn facts(&self) -> Facts {
        self.facts
    }

    /// A law without a type is made of one with.
    fn new(_: &Values) -> Result<Self, Vec<BadParameter>> {
        Err(Vec::new())
    }

    fn moduli(&self) -> Moduli {
        self.law.moduli()
    }

    /// Kernels do not ask.
    fn scaled(&self, _: f64) -> Self {
        *self
    }

    fn integrity<L: Lane>(&self, strain: &Sym<L>, history: &[L; MOST]) -> Sym<L> {
        same(self.law.integrity(&same(*strain), &same(*history)))
    }

    fn unbroken<L: Lane>(&self, history: &[L; MOST]) -> L {
        same(self.law.unbroken(&same(*history)))
    }

    fn hourglass_share<L: Lane>(&self, history: &[L; MOST]) -> L {
        same(self.law.hourglass_share(&same(*history)))
    }

    fn stored_energy<L: Lane>(&self, strain: &Sym<L>, stress: &Sym<L>, history: &[L; MOST]) -> L {
        same(self.law.stored_energy(&same(*strain), &same(*stress), &same(*history)))
    }

    fn update<L: Lane>(&self, point: &Point<L>, strain: Sym<L>, history: [L; MOST]) -> (Sym<L>, [L; MOST]) {
        let mut history: [f64; MOST] = same(history);
        let stress = self.law.update(&same(*point), same(strain), &mut history);
        (same(stress), same(history))
    }

    fn update_left<L: Lane>(
        &self,
        point: &Point<L>,
        strain: Sym<L>,
        history: [L; MOST],
    ) -> (Sym<L>, [L; MOST], Sym<L>) {
        let mut history: [f64; MOST] = same(history);
        let (stress, left) = self.law.update_left(&same(*point), same(strain), &mut history);
        (same(stress), same(history), same(left))
    }

    fn update_in_place<L: Lane>(
        &self,
        point: &Point<L>,
        strain: Sym<L>,
        history: &mut [Octet],
        at: usize,
    ) -> InPlace<L> {
        let InPlace { stress, left, before, now } =
            self.law.update_in_place(&same(*point), same(strain), history, at);
        InPlace { stress: same(stress), left: same(left), before: same(before), now: same(now) }
    }
}
