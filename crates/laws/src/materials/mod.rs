//! Material laws, one a file. A law enters the program by one line in [`for_each_material!`](crate::for_each_material).

pub mod concrete;
pub mod drucker_prager;
pub mod elastic;
pub mod hoek_brown;
pub mod mohr_coulomb;
mod plastic;

pub use concrete::Concrete;
pub use drucker_prager::DruckerPrager;
pub use elastic::Elastic;
pub use hoek_brown::HoekBrown;
pub use mohr_coulomb::MohrCoulomb;

use crate::parameter::LawInfo;

/// Calls a macro with the list of all laws: the one place where a law is registered.
#[macro_export]
macro_rules! for_each_material {
    ($then:ident) => {
        $then!(
            $crate::materials::Elastic,
            $crate::materials::Concrete,
            $crate::materials::MohrCoulomb,
            $crate::materials::DruckerPrager,
            $crate::materials::HoekBrown,
        )
    };
}

macro_rules! infos {
    ($($law:ty,)*) => { &[$(LawInfo::of::<$law>()),*] };
}

/// Descriptions of all laws, in the order of registration.
pub const MATERIALS: &[LawInfo] = for_each_material!(infos);
