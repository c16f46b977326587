//! Interface laws behind a wall: what the model needs of one without knowing its type.

use crate::contact::{Contact, Pair, PairSeen, gap, load, seen};
use crate::part::Part;
use std::sync::Arc;
use tremolite_laws::{BadParameter, Interface, Isa, LawInfo, Octet, Values};

/// An interface law with its parameters, ready to make parts of pairs.
pub trait AnyInterface: Send + Sync {
    fn info(&self) -> LawInfo;
    /// The values that it was made from.
    fn values(&self) -> &Values;
    /// See [`Interface::stiffness`].
    fn stiffness(&self, pressure: f64) -> [f64; 2];
    /// See [`Interface::stiffest`].
    fn stiffest(&self) -> [f64; 2];
    /// See [`Interface::straight_from`].
    fn straight_from(&self) -> Option<f64>;
    /// See [`Interface::closure_limit`].
    fn closure_limit(&self) -> Option<f64>;
    /// Closure \[m\] of an unbroken pair at a pressure \[Pa\].
    fn closure(&self, pressure: f64) -> f64;
    /// See [`Interface::warnings`].
    fn warnings(&self) -> Vec<String>;
    /// Pairs of this law; their nodes index `nodes`, which are the part's. `damping` is the pressure over the closing velocity
    /// of loose pairs \[Pa s/m\].
    fn contact(&self, nodes: Vec<u32>, pairs: &[Pair], damping: f64, isa: Isa) -> Box<dyn Part>;
    /// Begins a pair of such a part, whose relative displacement is `d` \[m\] now and whose m is `normal`, with a pressure and
    /// shear t \[Pa\]: see [`Interface::start`].
    fn load(
        &self,
        history: &mut [Octet],
        pair: usize,
        d: [f64; 3],
        normal: [f64; 3],
        pressure: f64,
        shear: [f64; 2],
    );
    /// A pair of such a part, from the part's history.
    fn seen(&self, history: &[Octet], pair: usize) -> PairSeen;
    /// [`PairSeen::gap`] alone \[m\].
    fn gap(&self, history: &[Octet], pair: usize) -> f64;
}

struct Instance<I> {
    law: Arc<I>,
    values: Values,
}

impl<I: Interface> AnyInterface for Instance<I> {
    fn info(&self) -> LawInfo {
        LawInfo::of_interface::<I>()
    }

    fn values(&self) -> &Values {
        &self.values
    }

    fn stiffness(&self, pressure: f64) -> [f64; 2] {
        self.law.stiffness(pressure)
    }

    fn stiffest(&self) -> [f64; 2] {
        self.law.stiffest()
    }

    fn straight_from(&self) -> Option<f64> {
        self.law.straight_from()
    }

    fn closure_limit(&self) -> Option<f64> {
        self.law.closure_limit()
    }

    fn closure(&self, pressure: f64) -> f64 {
        -self.law.start(pressure, [0.0; 2]).0
    }

    fn warnings(&self) -> Vec<String> {
        self.law.warnings()
    }

    fn contact(&self, nodes: Vec<u32>, pairs: &[Pair], damping: f64, isa: Isa) -> Box<dyn Part> {
        Box::new(Contact::new(self.law.clone(), nodes, pairs, damping, isa))
    }

    fn load(
        &self,
        history: &mut [Octet],
        pair: usize,
        d: [f64; 3],
        normal: [f64; 3],
        pressure: f64,
        shear: [f64; 2],
    ) {
        load(&*self.law, history, pair, d, normal, pressure, shear);
    }

    fn seen(&self, history: &[Octet], pair: usize) -> PairSeen {
        seen(&*self.law, history, pair)
    }

    fn gap(&self, history: &[Octet], pair: usize) -> f64 {
        gap::<I>(history, pair)
    }
}

/// A checked interface law, or every value that it refuses.
pub type BuiltInterface = Result<Arc<dyn AnyInterface>, Vec<BadParameter>>;

/// One entry of the registry of interface laws.
#[derive(Clone, Copy)]
pub struct InterfaceLaw {
    pub info: LawInfo,
    /// A checked instance from values in SI.
    pub build: fn(&Values) -> BuiltInterface,
}

impl InterfaceLaw {
    /// The entry of law `I`, which need not be in the list of the laws crate.
    pub fn of<I: Interface>() -> Self {
        InterfaceLaw {
            info: LawInfo::of_interface::<I>(),
            build: |values| Ok(Arc::new(Instance { law: Arc::new(I::new(values)?), values: values.clone() })),
        }
    }
}

macro_rules! entries {
    ($($law:ty,)*) => { vec![$(InterfaceLaw::of::<$law>()),*] };
}

/// All interface laws of the laws crate.
#[inline(never)]
pub fn interface_laws() -> Vec<InterfaceLaw> {
    tremolite_laws::for_each_interface!(entries)
}
