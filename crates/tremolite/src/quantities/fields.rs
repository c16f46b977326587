//! The fields of VTU files.

use super::{Quantity, q};
use tremolite_laws::shapes::hex8::Quadrature;
use tremolite_laws::{Column, Role};

/// Cell arrays of every VTU file, whatever fields are asked for.
pub const CELLS: [Quantity; 3] = [
    q("element", "", "the element's number, as messages, the verdict and the page name it"),
    q("body", "", "which region of the case the element belongs to, from 0"),
    q("group:NAME", "", "1 in the mesh's group NAME (lining, crown, walls …), 0 outside"),
];

/// A field of the VTU files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Field {
    Displacement,
    Velocity,
    Acceleration,
    Stress,
    Principal,
    Envelope,
    Damage,
    Plastic,
    History,
    Interface,
    Seepage,
}

impl Field {
    pub const ALL: [Field; 11] = [
        Field::Displacement,
        Field::Velocity,
        Field::Acceleration,
        Field::Stress,
        Field::Principal,
        Field::Envelope,
        Field::Damage,
        Field::Plastic,
        Field::History,
        Field::Interface,
        Field::Seepage,
    ];

    /// The word in `output.fields`, and the arrays it writes.
    pub const fn description(self) -> (&'static str, &'static str) {
        match self {
            Field::Displacement => ("displacement", "displacement (m) at nodes since the start of shaking"),
            Field::Velocity => ("velocity", "velocity (m/s) at nodes"),
            Field::Acceleration => ("acceleration", "acceleration (m/s2) at nodes"),
            Field::Stress => {
                ("stress", "stress (Pa) of elements (xx, yy, zz, xy, yz, zx), mean over their points")
            }
            Field::Principal => (
                "principal",
                "s1, s3 (Pa): largest and smallest principal stress over an element's points; where there is water p, \
                     s1_eff, s3_eff (Pa) as well: pressure in the pores, and effective stresses s + p",
            ),
            Field::Envelope => (
                "envelope",
                "displacement_max (m), s1_max, s3_min (Pa): extremes over time, sampled with the histories; stresses of \
                 elements of several points at the fibre (extrapolated to their corners) as long as they are intact, else at points",
            ),
            Field::Damage => (
                "damage",
                "d_tension, d_shear, d_b, d_b_max (1): damage, mean over an element's points, zero where its law has \
                 none; crack_opening (m): widest so far, sampled with the histories; crack_across (m): the same of those that cross bars, all but \
                 those parallel to the wall; crack_direction: which way the widest runs, 1 longitudinal, 2 round the ring, 3 parallel to the wall, \
                 4 where walls meet, 0 no crack",
            ),
            Field::Plastic => (
                "plastic",
                "plastic_… (1): plastic strains, mean over an element's points; plastic_state: all flags its points have, \
                 1 shear now, 2 tension now, 4 and 8 the same in the past",
            ),
            Field::History => (
                "history",
                "all that the laws keep, by the names of 'list materials' (state as plastic_state), as above",
            ),
            Field::Interface => (
                "interface",
                "in files of their own, interfaces.pvd: gap, slip (m), pressure, shear (Pa), state, slid, opened, gap_max, \
                 slip_max (m) at the pairs of all interfaces",
            ),
            Field::Seepage => (
                "seepage",
                "seepage (m/s): specific discharge of the steady flow in the element (x, y, z), mean over its points, where pressures \
                 come from seepage",
            ),
        }
    }

    /// Whether this field writes a column of a law's history.
    pub fn holds(self, column: &Column) -> bool {
        match self {
            Field::Damage => matches!(
                column.role,
                Role::TensionDamage | Role::ShearDamage | Role::MeanDamage | Role::MeanDamagePeak
            ),
            Field::Plastic => matches!(
                column.role,
                Role::PlasticShear | Role::PlasticTension | Role::PlasticStrain | Role::PlasticState
            ),
            Field::History => true,
            _ => false,
        }
    }

    /// The field of a word.
    pub fn from_word(word: &str) -> Option<Field> {
        Field::ALL.into_iter().find(|f| f.description().0 == word)
    }
}

/// The name of a history column among the fields.
pub fn field_name(column: &Column) -> &'static str {
    if column.role == Role::PlasticState { "plastic_state" } else { column.name }
}

/// One value for an element from those of its points: all flags that any of them has, the mean of everything else.
pub fn of_element(column: &Column, quadrature: Quadrature, values: impl Iterator<Item = f64>) -> f64 {
    if column.role == Role::PlasticState {
        values.fold(0, |flags, value| flags | value as u32).into()
    } else {
        values.zip(quadrature.shares()).map(|(value, share)| share * value).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_element_has_every_flag_of_its_points_and_the_mean_of_its_measures() {
        let column = |name, role| Column::with_role(name, "1", role, "");
        let flags = column("flow", Role::PlasticState);
        let damage = column("kappa", Role::TensionDamage);
        let of = |column: &Column, values: [f64; 8]| of_element(column, Quadrature::Full, values.into_iter());
        assert_eq!(of(&flags, [4.0, 8.0, 0.0, 5.0, 0.0, 0.0, 0.0, 0.0]), 13.0);
        assert_eq!(of(&damage, [0.0, 0.5, 1.0, 0.5, 0.0, 0.5, 1.0, 0.5]), 0.5);
        assert_eq!(field_name(&flags), "plastic_state");
        assert_eq!(field_name(&damage), "kappa");
        assert!(Field::Plastic.holds(&flags) && !Field::Damage.holds(&flags) && Field::Damage.holds(&damage));
    }
}
