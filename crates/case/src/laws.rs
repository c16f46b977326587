//! The laws that a file may name.

use tremolite_laws::interfaces::INTERFACES;
use tremolite_laws::parameter::LawInfo;

/// The laws that a file may name: those of the program's lists, or of one's own beside them.
///
/// Made of laws of materials alone, it has the interface laws of the list [`INTERFACES`].
#[derive(Clone, Copy)]
pub struct Laws<'a> {
    /// Usually [`MATERIALS`](tremolite_laws::materials::MATERIALS).
    pub materials: &'a [LawInfo],
    /// Usually [`INTERFACES`].
    pub interfaces: &'a [LawInfo],
}

impl<'a, T: AsRef<[LawInfo]> + ?Sized> From<&'a T> for Laws<'a> {
    fn from(materials: &'a T) -> Self {
        Laws { materials: materials.as_ref(), interfaces: INTERFACES }
    }
}
