//! Interface laws, one a file. A law enters the program by one line in
//! [`for_each_interface!`](crate::for_each_interface).

pub mod bandis;
pub mod coulomb;
pub mod hyperbola;
pub mod joint;
pub mod strength;

pub use bandis::Bandis;
pub use coulomb::Coulomb;

use crate::parameter::LawInfo;

/// Calls a macro with the list of all interface laws: the one place where such a law is registered.
#[macro_export]
macro_rules! for_each_interface {
    ($then:ident) => {
        $then!($crate::interfaces::Bandis, $crate::interfaces::Coulomb,)
    };
}

macro_rules! infos {
    ($($law:ty,)*) => { &[$(LawInfo::of_interface::<$law>()),*] };
}

/// Descriptions of all interface laws, in the order of registration.
pub const INTERFACES: &[LawInfo] = for_each_interface!(infos);
