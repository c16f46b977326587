//! How far material is damaged: what counts, and from when on.

use tremolite_laws::Role;

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
