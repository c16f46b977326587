//! `[motion.target]`: the spectrum that the design calls for.

use std::path::PathBuf;

use tremolite_laws::parameter::Dimension;

use crate::fields::{Fields, Node};
use crate::keys::{Key, Kind, Table};
use crate::{Diagnostic, Spanned};

pub(crate) static TARGET: Table = Table {
    path: "motion.target",
    doc: "Response spectrum that the design calls for of the motion given, horizontal, with 5 % damping, by points or from a file. The page \
          draws it beside the record's; a step \"match\" of `processing` fits the motion to it.",
    keys: &[
        Key::optional(
            "file",
            Kind::File,
            "",
            "A CSV file with the columns `period [s]` and `sa [m/s2]` or `sa [g]`",
        ),
        Key::optional("period", Kind::Numbers(Dimension::TIME), "", "Periods, ascending"),
        Key::optional(
            "sa",
            Kind::Numbers(Dimension::ACCELERATION),
            "",
            "Spectral acceleration at each of them",
        ),
    ],
    choice: &[&["file"], &["period", "sa"]],
};

/// A target, or the words of one that a code has.
pub(crate) const TARGETS: Kind = Kind::Either(&[Kind::Text, Kind::Table(&TARGET)]);

/// A target as it is given.
#[derive(Clone, Debug, PartialEq)]
pub enum Target {
    /// By the words of a code, "EN 1998-1 type 1 ground B 2 m/s2"; read by the motion crate.
    Code(Spanned<String>),
    /// A CSV file; as written, relative to the case's directory.
    File(Spanned<PathBuf>),
    /// By points.
    Table(Spanned<TargetSpectrum>),
}

impl Target {
    /// Nothing where the motion has none.
    pub(super) fn read(motion: &Fields) -> Option<Self> {
        let node = motion.get("target")?;
        let Some(f) = node.table() else { return node.text().map(Target::Code) };
        Some(match f.text("file") {
            Some(file) => Target::File(Spanned::new(file.value.into(), file.span)),
            None => Target::Table(Spanned::new(TargetSpectrum::read(f), f.span.clone())),
        })
    }
}

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
        if f.text("file").is_some() {
            return;
        }
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
