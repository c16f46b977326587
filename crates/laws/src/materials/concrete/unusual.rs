//! What is unusual about a concrete's parameters though the law accepts them.

use super::{Concrete, Split};
use crate::materials::elastic::soft_for_its_strength;

impl Concrete {
    /// A sentence each.
    pub(super) fn unusual(&self) -> Vec<String> {
        let mut warnings = Vec::from_iter(soft_for_its_strength(&self.moduli, self.fc));
        if let Some(grade) = self.replaced {
            warnings.push(format!(
                "cohesion gives f_c = {:.2} MPa, which is used in place of the grade's {:.2} MPa; leave the cohesion \
                 out to use the grade's",
                self.fc / 1e6,
                grade / 1e6
            ));
        }
        if self.slope * self.ft >= self.fc {
            let cracked = if self.split == Split::Effective && !self.nominal {
                "and so does any such pressure on an open crack (shear_tension = effective)"
            } else {
                "and on an open crack as long as it carries so much"
            };
            warnings.push(format!(
                "N f_t = {:.3} MPa reaches f_c = {:.3} MPa: any pressure across a tension of f_c/N = {:.3} MPa counts as \
                 shear failure (D⁻ of 1 − β or more) before the concrete cracks, {cracked}; raise the compressive \
                 strength or the cohesion, or lower the friction angle",
                self.slope * self.ft / 1e6,
                self.fc / 1e6,
                self.fc / self.slope / 1e6,
            ));
        }
        warnings
    }
}
