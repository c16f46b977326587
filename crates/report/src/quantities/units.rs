//! One unit for one quantity on the whole page, so that its numbers can be set beside one another.

use tremolite_results::{Peaks, Summary};

use crate::quantities::scale::Scale;

/// A quantity that has one unit on the page. Others take the unit that suits their size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Displacements, and differences of them.
    Displacement,
    /// Openings of cracks and joints, and slip: smaller by orders than what the ground moves by.
    Opening,
    Velocity,
    Acceleration,
    /// Stresses and pressures.
    Stress,
    /// Forces of bolts.
    Force,
    Energy,
}

impl Kind {
    const ALL: [Kind; 7] = [
        Kind::Displacement,
        Kind::Opening,
        Kind::Velocity,
        Kind::Acceleration,
        Kind::Stress,
        Kind::Force,
        Kind::Energy,
    ];

    /// What a history of a monitor in this SI unit is, openings apart.
    pub fn of_unit(unit: &str) -> Option<Kind> {
        match unit {
            "m" => Some(Kind::Displacement),
            "m/s" => Some(Kind::Velocity),
            "m/s2" | "m/s^2" | "m/s²" => Some(Kind::Acceleration),
            "Pa" => Some(Kind::Stress),
            "N" => Some(Kind::Force),
            "J" => Some(Kind::Energy),
            _ => None,
        }
    }

    /// What a monitor's quantity of this name is.
    fn of_quantity(name: &str) -> Option<Kind> {
        match name {
            "u" | "ux" | "uy" | "uz" => Some(Kind::Displacement),
            "gap" | "slip1" | "slip2" => Some(Kind::Opening),
            "vx" | "vy" | "vz" => Some(Kind::Velocity),
            "ax" | "ay" | "az" => Some(Kind::Acceleration),
            "s1" | "s1_elastic" | "s2" | "s3" | "sxx" | "syy" | "szz" | "sxy" | "syz" | "szx"
            | "pressure" | "shear1" | "shear2" => Some(Kind::Stress),
            _ => None,
        }
    }

    /// The unit for sizes up to `largest`, in SI.
    fn scale(self, largest: f64) -> Scale {
        match self {
            // Millimetres as long as they can be read: metres would show nothing of what strains a lining, and widths of
            // cracks are set beside limits in millimetres.
            Kind::Displacement | Kind::Opening if largest == 0.0 || (1e-4..10.0).contains(&largest) => {
                Scale::suiting("m", 1e-2)
            }
            Kind::Displacement | Kind::Opening => Scale::suiting("m", largest),
            // What ground at rest in one direction does beside what it does in another still has its figures.
            Kind::Velocity => Scale::suiting("m/s", 0.1 * largest),
            Kind::Acceleration => Scale::suiting("m/s2", largest),
            // Field files may hold what nothing here knows of.
            Kind::Stress if largest == 0.0 => Scale::suiting("Pa", 1e6),
            Kind::Stress => Scale::suiting("Pa", largest),
            Kind::Force if largest == 0.0 => Scale::suiting("N", 1e4),
            Kind::Force => Scale::suiting("N", largest),
            // The error of the balance, and what joints and bolts hold, are small beside the largest line.
            Kind::Energy => Scale::suiting("J", 0.1 * largest),
        }
    }
}

/// The page's units, fixed once from the largest of each kind that the summary and the tables know.
pub struct Units([Scale; Kind::ALL.len()]);

impl Units {
    /// From a summary and what tables hold beyond it, by kind.
    pub fn of(facts: &Summary, tables: impl Iterator<Item = (Kind, f64)>) -> Self {
        let mut largest = [0.0_f64; Kind::ALL.len()];
        let mut meet = |kind: Kind, value: f64| {
            if value.is_finite() {
                largest[kind as usize] = largest[kind as usize].max(value.abs());
            }
        };
        for (name, peaks) in facts.monitors.peaks.values().chain(facts.monitors.relative.values()).flatten() {
            if let Some(kind) = Kind::of_quantity(name) {
                let Peaks { max, min, .. } = peaks;
                [*max, *min].into_iter().for_each(|x| meet(kind, x));
            }
        }
        for stage in &facts.computed.stages {
            meet(Kind::Displacement, stage.largest_motion);
            stage.walls.values().flatten().for_each(|x| meet(Kind::Displacement, *x));
            for (name, value) in stage.monitors.values().flatten() {
                if let (Some(kind), Some(value)) = (Kind::of_quantity(name), value) {
                    meet(kind, *value);
                }
            }
        }
        for stress in facts.parts.stress.values() {
            [stress.s1.value, stress.s3.value].into_iter().for_each(|x| meet(Kind::Stress, x));
        }
        for cracks in facts.parts.damage.values().filter_map(|group| group.cracks.as_ref()) {
            meet(Kind::Opening, cracks.opening);
        }
        for interface in facts.parts.interfaces.values() {
            [interface.max_slip.value, interface.max_gap.value]
                .into_iter()
                .for_each(|x| meet(Kind::Opening, x));
            meet(Kind::Stress, interface.max_pressure);
        }
        for bolts in facts.parts.bolts.values() {
            meet(Kind::Opening, bolts.max_slip);
            [bolts.largest.force, bolts.yield_force].into_iter().for_each(|x| meet(Kind::Force, x));
        }
        facts.soundness.energy.values().for_each(|x| meet(Kind::Energy, *x));
        tables.for_each(|(kind, value)| meet(kind, value));
        Units(Kind::ALL.map(|kind| kind.scale(largest[kind as usize])))
    }

    /// The unit of a kind.
    pub fn scale(&self, kind: Kind) -> Scale {
        self.0[kind as usize].clone()
    }

    /// The unit of values in the SI unit `unit` up to `largest`: that of their kind, or else what suits them.
    pub fn suiting(&self, unit: &str, largest: f64) -> Scale {
        Kind::of_unit(unit).map_or_else(|| Scale::suiting(unit, largest), |kind| self.scale(kind))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_kind_keeps_its_unit_whatever_the_size_of_one_value() {
        let unit = |kind: Kind, largest: f64| kind.scale(largest).unit;
        assert_eq!(unit(Kind::Displacement, 1.3), "mm");
        assert_eq!(unit(Kind::Displacement, 4e-4), "mm");
        assert_eq!(unit(Kind::Displacement, 4e-6), "µm");
        assert_eq!(unit(Kind::Displacement, 40.0), "m");
        assert_eq!(unit(Kind::Opening, 4e-4), "mm");
        assert_eq!(unit(Kind::Energy, 3.4e9), "MJ");
        assert_eq!(unit(Kind::Stress, 0.0), "MPa");
    }
}
