//! `[[monitor]]` and `[[monitor_pair]]`: points whose histories are kept.

use std::ops::Range;

use tremolite_laws::parameter::Dimension;

use crate::Spanned;
use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table, When};
use crate::pattern;

const COORDINATE: Kind = Kind::Number(Dimension::LENGTH, Limit::Any);

pub(crate) static MONITOR: Table = Table {
    path: "monitor",
    doc: "A point whose histories are kept.",
    keys: &[
        Key::required("name", Kind::Name, "first part of the names of its columns"),
        Key::required(
            "at",
            Kind::Either(&[Kind::Text, Kind::List(&COORDINATE, 3, 3)]),
            "a named point of the mesh such as \"powerhouse.crown\", or [x, y, z]",
        ),
        Key::optional(
            "body",
            Kind::Text,
            "any body at that place",
            "The body it lies in: \"lining\" is every group called lining, or with .lining in its name",
        )
        .when(When::WithoutAny(&["interface", "bolt"])),
        Key::optional(
            "interface",
            Kind::Text,
            "",
            "The interface at whose nearest pair it is: gap, slip, pressure and shear are kept, no motion",
        ),
        Key::optional(
            "bolt",
            Kind::Text,
            "",
            "The bolts, by their name, at whose nearest segment it is: its force and slip are kept, no motion",
        )
        .when(When::Without("interface")),
    ],
    choice: &[],
};

pub(crate) static RELATIVE: Table = Table {
    path: "monitor_pair",
    doc: "Two monitors whose difference of displacement is kept.",
    keys: &[Key::required("between", Kind::List(&Kind::Text, 2, 2), "names of two monitors")],
    choice: &[],
};

/// A point whose histories are kept.
#[derive(Clone, Debug, PartialEq)]
pub struct Monitor {
    /// Unique; without blanks, dots, commas and brackets.
    pub name: Spanned<String>,
    /// Where it is.
    pub at: Spanned<Place>,
    /// The body it lies in, see [`Monitor::lies_in`]; nothing: any.
    pub body: Option<Spanned<String>>,
    /// Index into [`Case::interfaces`](crate::Case::interfaces) of the one it looks at, not tied; then there is no body.
    pub interface: Option<Spanned<usize>>,
    /// Which of [`Case::bolts`](crate::Case::bolts) it looks at, counted through all stages; then there is no body and no
    /// interface.
    pub bolt: Option<Spanned<usize>>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

/// A place in the model.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// A point that the mesh has a name for.
    Named(String),
    /// x, y, z in m.
    Point([f64; 3]),
}

/// Two monitors whose difference of displacement is kept.
#[derive(Clone, Debug, PartialEq)]
pub struct Relative {
    /// Indices into [`Case::monitors`](crate::Case::monitors), not equal; neither looks at an interface or a bolt.
    pub between: [usize; 2],
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

impl Monitor {
    /// Whether the monitor may lie in an element of this group: always where no body is given, else in the group of
    /// that name, or in one that has it behind a dot (`powerhouse.lining`, `powerhouse.lining.crown`). The body may
    /// be a pattern.
    pub fn lies_in(&self, group: &str) -> bool {
        self.body.as_ref().is_none_or(|body| {
            pattern::matches(body, group) || pattern::matches(&format!("*.{}*", body.value), group)
        })
    }

    /// Whether it is in an element, whose motion and stress it keeps: at no interface and at no bolt.
    pub fn is_in_element(&self) -> bool {
        self.interface.is_none() && self.bolt.is_none()
    }

    /// `interfaces` and `bolts` are the names of all of them, in order.
    pub(crate) fn read(f: &Fields, interfaces: &[&str], bolts: &[&str]) -> Option<Self> {
        let body = f.text("body");
        let one_of = |key: &'static str, names: &[&str]| match f.text(key) {
            Some(name) => Some(Some(Spanned::new(names.iter().position(|n| *n == *name)?, name.span))),
            None => Some(None),
        };
        let (interface, bolt) = (one_of("interface", interfaces)?, one_of("bolt", bolts)?);
        let at = f.get("at")?;
        let place = match at.text() {
            Some(name) => Place::Named(name.value),
            None => Place::Point(at.numbers()?.value),
        };
        Some(Monitor {
            name: f.text("name")?,
            at: Spanned::new(place, at.span.clone()),
            body,
            interface,
            bolt,
            span: f.span.clone(),
        })
    }
}

impl Relative {
    /// `names` are those of all monitors, in order.
    pub(crate) fn read(f: &Fields, names: &[&str]) -> Option<Self> {
        let between: Option<Vec<usize>> =
            f.texts("between").iter().map(|n| names.iter().position(|m| *m == n.value)).collect();
        Some(Relative { between: between?.try_into().ok()?, span: f.span.clone() })
    }
}
