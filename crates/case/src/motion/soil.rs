//! Soil of `motion.site.layers` that softens and damps as it is sheared.

use std::ops::Range;

use tremolite_laws::parameter::Dimension;

use crate::Spanned;
use crate::fields::{Fields, Node};
use crate::keys::{Key, Kind, Limit, Table};

/// Keys of a layer that give curves, one of them at most.
pub(super) const CURVES: &[&str] = &["darendeli", "vucetic_dobry", "curves"];

pub(super) static DARENDELI: Table = Table {
    path: "motion.site.layers.darendeli",
    doc: "Curves of modulus and damping by strain after Darendeli (2001).",
    keys: &[
        Key::required(
            "plasticity_index",
            Kind::Number(Dimension::NONE, Limit::Within(200.0)),
            "plasticity index of the soil in %, 0 of sand",
        ),
        Key::required(
            "stress",
            Kind::Number(Dimension::PRESSURE, Limit::Positive),
            "mean effective stress in the middle of the layer",
        ),
        Key::default(
            "overconsolidation",
            Kind::Number(Dimension::NONE, Limit::Positive),
            "1.0",
            "Overconsolidation ratio",
        ),
        Key::default(
            "frequency",
            Kind::Number(Dimension::RATE, Limit::Positive),
            r#""1 Hz""#,
            "Frequency of shaking that the damping is for",
        ),
        Key::default(
            "cycles",
            Kind::Number(Dimension::NONE, Limit::Positive),
            "10.0",
            "Number of cycles that the damping is for",
        ),
    ],
    choice: &[],
};

pub(super) static TABLE: Table = Table {
    path: "motion.site.layers.curves",
    doc: "Curves of modulus and damping by strain, linear in the logarithm of strain between rows and constant beyond.",
    keys: &[
        Key::required(
            "strain",
            Kind::Numbers(Dimension::NONE),
            "shear strains, ascending: 1e-4 is a hundredth of a percent",
        ),
        Key::required(
            "modulus",
            Kind::Numbers(Dimension::NONE),
            "shear modulus over that of small strain, 1 at most",
        ),
        Key::required("damping", Kind::Numbers(Dimension::NONE), "ratio to critical damping"),
    ],
    choice: &[],
};

/// How a layer's modulus and damping go with its shear strain.
#[derive(Clone, Debug, PartialEq)]
pub enum Softening {
    /// Not: its ratio to critical damping, the same at all strains and frequencies.
    None(Spanned<f64>),
    /// After Darendeli (2001).
    Darendeli {
        /// %
        plasticity_index: f64,
        /// Mean effective stress, Pa.
        stress: f64,
        /// Overconsolidation ratio.
        overconsolidation: f64,
        /// Hz
        frequency: f64,
        /// Number of cycles.
        cycles: f64,
    },
    /// After Vucetic and Dobry (1991), by plasticity index, %.
    VuceticDobry(f64),
    /// By rows of shear strain, modulus over that of small strain and damping ratio, as they are written.
    Table {
        /// By row; a column that is shorter than the others has no number at its end.
        rows: Vec<[f64; 3]>,
        /// Its table in the case.
        span: Range<usize>,
    },
}

impl Softening {
    /// Whether it does not soften.
    pub fn is_none(&self) -> bool {
        matches!(self, Softening::None(_))
    }

    pub(super) fn read(layer: &Fields) -> Option<Self> {
        if let Some(f) = layer.table("darendeli") {
            let number = |key| f.number(key).map(|x| x.value);
            return Some(Softening::Darendeli {
                plasticity_index: number("plasticity_index")?,
                stress: number("stress")?,
                overconsolidation: number("overconsolidation")?,
                frequency: number("frequency")?,
                cycles: number("cycles")?,
            });
        }
        if let Some(index) = layer.number("vucetic_dobry") {
            return Some(Softening::VuceticDobry(index.value));
        }
        if let Some(f) = layer.table("curves") {
            let column =
                |key| -> Vec<f64> { f.list(key).iter().filter_map(Node::number).map(|n| n.value).collect() };
            let columns = ["strain", "modulus", "damping"].map(column);
            let longest = columns.iter().map(Vec::len).max().unwrap_or(0);
            let row = |k: usize| columns.each_ref().map(|column| column.get(k).copied().unwrap_or(f64::NAN));
            return Some(Softening::Table { rows: (0..longest).map(row).collect(), span: f.span.clone() });
        }
        layer.number("damping").map(Softening::None)
    }
}
