//! A law out of line: the reference in one lane at a time is compiled once for each law, not once for each law in each quadrature.

use tremolite_laws::{
    BadParameter, Column, InPlace, Lane, Material, Moduli, Octet, Parameter, Point, Sym, Values,
};

/// The law `M` with its functions called, not inlined. Whatever surrounds them, they give the same bits. It has what kernels ask of a law;
/// what parts and the model ask stays with `M`.
#[repr(transparent)]
pub(super) struct Apart<M>(M);

impl<M> Apart<M> {
    pub fn of(law: &M) -> &Self {
        // SAFETY: `Apart` is transparent, and a borrow of it does no more than one of what it holds.
        unsafe { &*std::ptr::from_ref(law).cast() }
    }
}

impl<M: Material> Material for Apart<M> {
    const NAME: &'static str = M::NAME;
    const SUMMARY: &'static str = M::SUMMARY;
    const SOURCE: &'static str = M::SOURCE;
    const PARAMETERS: &'static [Parameter] = M::PARAMETERS;
    const HISTORY: &'static [Column] = M::HISTORY;
    const NEEDS_SIZE: bool = M::NEEDS_SIZE;
    const FLOWS: bool = M::FLOWS;
    const DAMAGES: bool = M::DAMAGES;
    const DISSIPATION: Option<usize> = M::DISSIPATION;
    const CREATION: Option<usize> = M::CREATION;
    type History<L: Lane> = M::History<L>;

    fn new(values: &Values) -> Result<Self, Vec<BadParameter>> {
        M::new(values).map(Apart)
    }

    fn moduli(&self) -> Moduli {
        self.0.moduli()
    }

    fn scaled(&self, factor: f64) -> Self {
        Apart(self.0.scaled(factor))
    }

    #[inline(never)]
    fn integrity<L: Lane>(&self, strain: &Sym<L>, history: &M::History<L>) -> Sym<L> {
        self.0.integrity(strain, history)
    }

    #[inline(never)]
    fn unbroken<L: Lane>(&self, history: &M::History<L>) -> L {
        self.0.unbroken(history)
    }

    #[inline(never)]
    fn hourglass_share<L: Lane>(&self, history: &M::History<L>) -> L {
        self.0.hourglass_share(history)
    }

    #[inline(never)]
    fn stored_energy<L: Lane>(&self, strain: &Sym<L>, stress: &Sym<L>, history: &M::History<L>) -> L {
        self.0.stored_energy(strain, stress, history)
    }

    #[inline(never)]
    fn update<L: Lane>(
        &self,
        point: &Point<L>,
        strain: Sym<L>,
        history: M::History<L>,
    ) -> (Sym<L>, M::History<L>) {
        self.0.update(point, strain, history)
    }

    #[inline(never)]
    fn update_left<L: Lane>(
        &self,
        point: &Point<L>,
        strain: Sym<L>,
        history: M::History<L>,
    ) -> (Sym<L>, M::History<L>, Sym<L>) {
        self.0.update_left(point, strain, history)
    }

    #[inline(never)]
    fn update_in_place<L: Lane>(
        &self,
        point: &Point<L>,
        strain: Sym<L>,
        history: &mut [Octet],
        at: usize,
    ) -> InPlace<L> {
        self.0.update_in_place(point, strain, history, at)
    }
}
