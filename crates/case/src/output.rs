//! `[output]`: what is written, and when.

use std::ops::Range;

use tremolite_laws::parameter::Dimension;

use crate::Spanned;
use crate::defaulted::Defaulted;
use crate::fields::Fields;
use crate::interface::Interface;
use crate::keys::{Key, Kind, Limit, Table};
use crate::material::Material;

const INTERVAL: Kind = Kind::Number(Dimension::TIME, Limit::Positive);
const INTERVAL_OR_NONE: Kind = Kind::Either(&[Kind::Word(&["none"]), INTERVAL]);

/// The field that is for cases with interfaces alone, and the one for those with concrete that cracks.
const OF_INTERFACES: &str = "interface";
const OF_CRACKS: &str = "damage";
/// How the names of laws that crack begin.
const CRACKS: &str = "concrete";

pub(crate) static OUTPUT: Table = Table {
    path: "output",
    doc: "What is written, and when.",
    keys: &[
        Key::default("histories", INTERVAL, r#""0.01 s""#, "Interval between lines of the histories"),
        Key::default(
            "snapshots",
            INTERVAL_OR_NONE,
            r#""0.5 s""#,
            "Interval between field files, or \"none\"",
        ),
        Key::default(
            "fields",
            Kind::List(&Kind::Name, 0, 100),
            r#"["displacement", "velocity", "stress"]"#,
            "Quantities in the field files; left out, also \"damage\" where concrete cracks, and \"interface\" where one is not tied",
        ),
        Key::default(
            "checkpoint",
            INTERVAL_OR_NONE,
            r#""10 min""#,
            "Wall-clock interval between checkpoints, or \"none\"",
        ),
    ],
    choice: &[],
};

/// What is written, and when.
#[derive(Clone, Debug, PartialEq)]
pub struct Output {
    /// Model time between lines of the histories, s.
    pub histories: Spanned<f64>,
    /// Model time between field files, s; nothing: none are written.
    pub snapshots: Option<Spanned<f64>>,
    /// Quantities in the field files, no duplicates; whether they exist is for the registry of quantities to say.
    pub fields: Vec<Spanned<String>>,
    /// Wall-clock time between checkpoints, s; nothing: none are written.
    pub checkpoint: Option<Spanned<f64>>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

impl Output {
    pub(crate) fn read(f: &Fields) -> Option<Self> {
        // The word "none" is no number.
        let (snapshots, checkpoint) = (f.number("snapshots"), f.number("checkpoint"));
        let fields = f.texts("fields");
        Some(Output {
            histories: f.number("histories")?,
            snapshots,
            fields,
            checkpoint,
            span: f.span.clone(),
        })
    }

    /// Adds to fields that were left out what belongs to interfaces and to concrete, and to what is said of them.
    pub(crate) fn show_all(
        &mut self,
        interfaces: &[Interface],
        materials: &[Material],
        defaulted: &mut [Defaulted],
    ) {
        let Some(said) = defaulted.iter_mut().find(|d| d.key == "output.fields") else { return };
        let cracks = materials.iter().any(|material| material.law.value.starts_with(CRACKS));
        let parts = interfaces.iter().any(|interface| interface.contact.is_some());
        for (_, name) in [(cracks, OF_CRACKS), (parts, OF_INTERFACES)].into_iter().filter(|(there, _)| *there)
        {
            self.fields.push(Spanned::new(name.to_owned(), self.span.clone()));
        }
        let words: Vec<String> = self.fields.iter().map(|f| format!("\"{}\"", f.value)).collect();
        said.value = format!("[{}]", words.join(", "));
    }
}
