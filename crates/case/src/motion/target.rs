//! `[motion.target]`: the spectrum that the design calls for.

use tremolite_laws::parameter::Dimension;

use crate::Diagnostic;
use crate::fields::{Fields, Node};
use crate::keys::{Key, Kind, Table};

pub(crate) static TARGET: Table = Table {
    path: "motion.target",
    doc: "Response spectrum that the design calls for of the motion given, horizontal, with 5 % damping. The page draws it beside the \
          record's; nothing is fitted to it.",
    keys: &[
        Key::required("period", Kind::Numbers(Dimension::TIME), "periods, ascending"),
        Key::required("sa", Kind::Numbers(Dimension::ACCELERATION), "spectral acceleration at each of them"),
    ],
    choice: &[],
};

/// A target spectrum: as many accelerations as periods, these ascending.
#[derive(Clone, Debug, PartialEq)]
pub struct TargetSpectrum {
    /// s
    pub period: Vec<f64>,
    /// m/s²
    pub sa: Vec<f64>,
}

impl TargetSpectrum {
    pub(crate) fn read(f: &Fields) -> Self {
        let numbers = |key| f.list(key).iter().filter_map(Node::number).map(|n| n.value).collect();
        TargetSpectrum { period: numbers("period"), sa: numbers("sa") }
    }

    /// Refuses what is no spectrum.
    pub(crate) fn check(f: &Fields, problems: &mut Vec<Diagnostic>) {
        let target = TargetSpectrum::read(f);
        let ascends = target.period.windows(2).all(|pair| pair[0] < pair[1]);
        let positive = target.period.iter().all(|t| *t > 0.0) && target.sa.iter().all(|a| *a >= 0.0);
        if target.period.len() != target.sa.len() || target.period.len() < 2 || !ascends || !positive {
            problems.push(Diagnostic::new(
                f.span.clone(),
                "this is no spectrum",
                "give as many accelerations as periods, two at least, the periods above 0 and ascending",
            ));
        }
    }
}
