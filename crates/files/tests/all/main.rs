//! What files are left, as users of the crate see it.

mod losses;
