//! The quantities that results hold: names, units and meaning in one list.

use tremolite_laws::shapes::hex8::Quadrature;
use tremolite_laws::{Column, Role, Row};

/// A component of a monitor's history.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quantity {
    pub name: &'static str,
    pub unit: &'static str,
    pub doc: &'static str,
}

const fn q(name: &'static str, unit: &'static str, doc: &'static str) -> Quantity {
    Quantity { name, unit, doc }
}

/// Columns of a monitor in monitors.csv, in this order.
pub const MONITOR: [Quantity; 19] = [
    q("ux", "m", "displacement along x since the start of shaking, interpolated in the element"),
    q("uy", "m", "displacement along y"),
    q("uz", "m", "displacement along z"),
    q("vx", "m/s", "velocity along x"),
    q("vy", "m/s", "velocity along y"),
    q("vz", "m/s", "velocity along z"),
    q(
        "ax",
        "m/s2",
        "acceleration along x: velocity of this row less that of the last, over the time between them, so valid half a row \
         earlier; 0 in the first row. Such a mean passes little above the rows' Nyquist frequency; peaks of single steps are \
         in summary.json (step_max, step_min)",
    ),
    q("ay", "m/s2", "acceleration along y"),
    q("az", "m/s2", "acceleration along z"),
    q(
        "sxx",
        "Pa",
        "normal stress along x, tension positive: of the element (one-point), or extrapolated from its points; \
         of the nearest of them once one has cracked or yielded",
    ),
    q("syy", "Pa", "normal stress along y"),
    q("szz", "Pa", "normal stress along z"),
    q("sxy", "Pa", "shear stress xy"),
    q("syz", "Pa", "shear stress yz"),
    q("szx", "Pa", "shear stress zx"),
    q("s1", "Pa", "largest principal stress, tension positive"),
    q("s2", "Pa", "middle principal stress"),
    q("s3", "Pa", "smallest principal stress"),
    q(
        "s1_elastic",
        "Pa",
        "largest principal value of σ₀ + C:Δε at the monitor: the stress when the shaking begins and what the strain since then \
         would add if nothing cracked or yielded. Without what the Maxwell bodies of damping over a band add to a fast change, by \
         which s1 may lie above it. At the end of a stage s1 itself",
    ),
];

/// Columns of a monitor on an interface, in this order.
pub const PAIR: [Quantity; 7] = [
    q("gap", "m", "opening of the pair nearest to the point, negative where it is closed under pressure"),
    q(
        "slip1",
        "m",
        "displacement of the second side against the first along e1, horizontal (x on a level interface)",
    ),
    q("slip2", "m", "the same along e2 = m × e1, m out of the first side"),
    q("pressure", "Pa", "between the two sides, compression positive, without contact damping"),
    q("shear1", "Pa", "shear along the slip that caused it, e1"),
    q("shear2", "Pa", "the same along e2"),
    q("state", "1", "0 bonded, 1 stuck (bond broken, closed), 2 sliding, 3 open"),
];

/// Columns of an interface in interfaces.csv, in this order.
pub const INTERFACE: [Quantity; 7] = [
    q("sliding", "m2", "area that slides, by more than 1 nm (as all areas here)"),
    q("open", "m2", "area that is open"),
    q("ever_slid", "m2", "area that has slid in any step so far"),
    q("ever_opened", "m2", "area that has opened in any step so far"),
    q("max_gap", "m", "largest gap of any pair whose bond is broken, of all steps so far"),
    q("max_slip", "m", "largest slip of any closed pair whose bond is broken, of all steps so far"),
    q(
        "impact_gain",
        "J",
        "energy that the time step found (lost, if negative) at impacts so far; in the balance's error",
    ),
];

/// Columns of a monitor on a bolt, in this order.
pub const BOLT: [Quantity; 4] = [
    q("force", "N", "of the bolt's segment nearest to the point, tension positive"),
    q("force_over_yield", "1", "its size over the force at which the segment yields; 0 where it never does"),
    q(
        "slip",
        "m",
        "of the bond beside it, bar less ground along the bolt, from its head on; 0 without a bond",
    ),
    q(
        "state",
        "1",
        "0 elastic, 1 its bond slides or has slid, 2 it has yielded, 3 broken, 4 cut off by an excavation",
    ),
];

/// Columns of bolts.csv behind `bolt` and `name`, a row for each bolt of a group and time.
pub const BOLTS: [Quantity; 11] = [
    q("time", "s", "in the earthquake, when field files are written; NaN at the end of a stage"),
    q("max_force", "N", "force of largest size along the bolt, tension positive"),
    q(
        "force_over_yield",
        "1",
        "size of the force over what its segment yields at, at most along the bolt; 0 where it never does",
    ),
    q("max_slip", "m", "largest size of the slip along the bolt in any step since it was placed"),
    q(
        "state",
        "",
        "elastic, slid, yielded or broken: the worst of what is left of the bolt; cut-off where an excavation left nothing",
    ),
    q("stage", "", "the stage at whose end it is so, or earthquake"),
    q("x", "m", "where max_force is: the middle of its segment"),
    q("y", "m", "the same along y"),
    q("z", "m", "the same along z"),
    q(
        "largest_force",
        "N",
        "largest size of the force along the bolt in any step since the stage, or the earthquake, began",
    ),
    q("cut_off", "m", "length of the bolt that excavations have taken; it counts in no other column"),
];

/// Arrays of bolts/*.vtu, a line for each segment.
pub const BOLT_LINES: [Quantity; 12] = [
    q("displacement", "m", "of the ends of segments, in the ground they lie in"),
    q("from_head", "m", "distance of the ends from the head along the bolt"),
    q("group", "", "which group of bolts, from 0; group:NAME marks each"),
    q("bolt", "", "its number in the group, from 1"),
    q("force", "N", "tension positive"),
    q("force_over_yield", "", "as in monitors.csv"),
    q("slip", "m", "of the bond beside it"),
    q("plastic_strain", "", "of the bar"),
    q("state", "", "as in monitors.csv"),
    q(
        "force_max",
        "N",
        "force of largest size in any step since the stage, or the earthquake, began, tension positive",
    ),
    q("force_over_yield_max", "", "the same over what it yields at"),
    q("slip_max", "m", "largest size of the slip in any step since it was placed"),
];

/// Columns of a pair of monitors.
pub const RELATIVE: [Quantity; 4] = [
    q("ux", "m", "displacement of the first monitor less that of the second, along x"),
    q("uy", "m", "the same along y"),
    q("uz", "m", "the same along z"),
    q("u", "m", "its length"),
];

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
}

impl Field {
    pub const ALL: [Field; 10] = [
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
            Field::Principal => {
                ("principal", "s1, s3 (Pa): largest and smallest principal stress over an element's points")
            }
            Field::Envelope => (
                "envelope",
                "displacement_max (m), s1_max, s3_min (Pa): extremes over time, sampled with the histories; stresses of \
                 elements of several points at the fibre (extrapolated to their corners) as long as they are intact, else at points",
            ),
            Field::Damage => (
                "damage",
                "d_tension, d_shear, d_b, d_b_max (1): damage, mean over an element's points, zero where its law has \
                 none; crack_opening (m): widest so far, sampled with the histories",
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

/// Unit of the columns of damage.csv that say in which share of a group's volume a measure counts.
pub const SHARE_OF_VOLUME: &str = "m3/m3";

/// What columns of the laws' histories say of how far material is damaged, and the values that count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measure {
    pub role: Role,
    /// In words, as the verdict has it.
    pub words: &'static str,
    /// Volumes beyond these are reported.
    pub thresholds: &'static [f64],
    /// Beyond this it has begun.
    pub onset: f64,
    /// Beyond this a point counts as damaged.
    pub counts: f64,
}

impl Measure {
    /// What a column of damage.csv means whose law calls this measure `name`.
    pub fn meaning(&self, name: &str) -> String {
        format!("share of the group's volume in which {name} is above {}", threshold(self.counts))
    }
}

/// A threshold as one writes it: 0.5, 1e-6.
pub fn threshold(x: f64) -> String {
    if x.abs() < 1e-3 { format!("{x:e}") } else { x.to_string() }
}

/// Plastic strain from which on a point counts as yielded. The stress that it relieves, 10 kPa at E = 10 GPa, is below
/// what the loads of a model are known to.
pub const YIELDED: f64 = 1e-6;

const fn damage(role: Role, words: &'static str) -> Measure {
    Measure { role, words, thresholds: &[0.1, 0.5, 0.9], onset: 0.0, counts: 0.5 }
}

const fn plastic(role: Role, words: &'static str) -> Measure {
    Measure { role, words, thresholds: &[YIELDED], onset: YIELDED, counts: YIELDED }
}

/// What summaries report of damage, and from when on; laws without such a column are left
/// out.
pub const MEASURES: [Measure; 5] = [
    damage(Role::TensionDamage, "cracked"),
    damage(Role::ShearDamage, "crushed or sheared"),
    damage(Role::MeanDamagePeak, "mean principal damage"),
    plastic(Role::PlasticShear, "yielded in shear"),
    plastic(Role::PlasticTension, "yielded in tension"),
];

/// Length of a row.
pub fn length(row: &Row) -> f64 {
    let [x, y, z] = row.xyz();
    (x * x + y * y + z * z).sqrt()
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
