//! `[[interface]]`: surfaces between bodies that may slide and open.

use std::f64::consts::PI;
use std::ops::Range;

use toml::de::DeTable;
use tremolite_laws::parameter::{Dimension, Values};

use crate::check::Checker;
use crate::fields::{Fields, Node};
use crate::keys::{Key, Kind, Limit, Table, When};
use crate::law_table::LawTable;
use crate::water::{self, OF_INTERFACE};
use crate::{Spanned, law_key, pattern};

/// The word in place of a law for bodies that share their nodes.
pub(crate) const TIED: &str = "tied";

const SIDE: Kind = Kind::Either(&[Kind::Text, Kind::List(&Kind::Text, 1, 1000)]);
const OF_A_LAW: When = When::IsNot("law", TIED);

/// The keys that every interface has; those of its law come from the law.
pub(crate) static INTERFACE: Table = Table {
    path: "interface",
    doc: "Where two bodies meet: their surfaces may slide and open as a law says, or are tied.",
    keys: &[
        Key::required("name", Kind::Name, "first part of the names of its columns"),
        Key::required(
            "between",
            Kind::List(&SIDE, 2, 2),
            "groups on the first side and on the second; of several a list, * stands for any text",
        ),
        Key::required("law", Kind::Text, "the interface law, or \"tied\": nothing slides or opens"),
        Key::default(
            "corner",
            Kind::Number(Dimension::ANGLE, Limit::UpTo(60.0 * PI / 180.0)),
            r#""45 deg""#,
            "angle below which faces that meet at a node share its pair and normal; across a sharper edge it has a second pair",
        )
        .when(OF_A_LAW),
        Key::default(
            "contact_damping",
            Kind::Number(Dimension::NONE, Limit::Within(0.2)),
            "0.01",
            "dashpot against bouncing, normal to closed pairs whose bond is broken: share of critical damping",
        )
        .when(OF_A_LAW),
        Key::default(
            "contact_limit",
            Kind::Number(Dimension::NONE, Limit::UpTo(1.0)),
            "0.8",
            "largest ω_c Δt of contact, ω_c of the stiffest pairs between their masses: the step keeps it, lest impacts make energy",
        )
        .when(OF_A_LAW),
        Key::default(
            "viscosity",
            Kind::Number(Dimension::NONE, Limit::Within(0.5)),
            "0.06",
            "artificial viscosity of the elements that touch it, where their region has less: share of critical damping at an \
             element's own highest frequency, against vibrations that sliding feeds",
        )
        .when(OF_A_LAW),
        Key::optional("water", Kind::Table(&OF_INTERFACE), "", "Water between the two sides").when(OF_A_LAW),
    ],
    choice: &[],
};

/// Where two bodies meet.
#[derive(Clone, Debug, PartialEq)]
pub struct Interface {
    /// Unique; without blanks, dots, commas and brackets.
    pub name: Spanned<String>,
    /// Group names of the first side and of the second, in which `*` stands for any text (see [`pattern::matches`]); none
    /// stands twice.
    pub between: [Vec<Spanned<String>>; 2],
    /// What happens there; nothing: the bodies share their nodes.
    pub contact: Option<Contact>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

/// What happens at an interface that is not tied.
#[derive(Clone, Debug, PartialEq)]
pub struct Contact {
    /// Name of one of the laws given to [`Case::read`](crate::Case::read).
    pub law: Spanned<String>,
    /// The law's parameters, defaults filled in. What [`Need::Chosen`](tremolite_laws::Need::Chosen) leaves open may be
    /// missing: the law has accepted the others beside a value of its own choice.
    pub parameters: Values,
    /// Angle below which faces that meet at a node share a pair, in (0, π/3].
    pub corner: Spanned<f64>,
    /// Share of critical damping, normal to closed pairs whose bond is broken, in \[0, 0.2\].
    pub damping: Spanned<f64>,
    /// Largest ω_c Δt, in (0, 1].
    pub limit: Spanned<f64>,
    /// Artificial viscosity of the elements beside it, in \[0, 0.5\].
    pub viscosity: Spanned<f64>,
    /// Share of the ground's water pressure between the two sides, where it is given, in \[0, 1\].
    pub water: Option<Spanned<f64>>,
}

impl Interface {
    /// Whether a group of this name lies on the first side, and on the second.
    pub fn sides_of(&self, group: &str) -> [bool; 2] {
        self.between.each_ref().map(|side| side.iter().any(|p| pattern::matches(p, group)))
    }

    pub(crate) fn read(f: &Fields) -> Option<Self> {
        let law = f.text("law")?;
        let (corner, damping, limit) =
            (f.number("corner"), f.number("contact_damping"), f.number("contact_limit"));
        let contact = if *law == TIED {
            None
        } else {
            let parameters = f.values()?;
            let viscosity = f.number("viscosity")?;
            let water = water::of_interface(f);
            let (corner, damping, limit) = (corner?, damping?, limit?);
            Some(Contact { law, parameters, corner, damping, limit, viscosity, water })
        };
        Some(Interface { name: f.text("name")?, between: sides(f)?, contact, span: f.span.clone() })
    }
}

/// The patterns of both sides.
pub(crate) fn sides(f: &Fields) -> Option<[Vec<Spanned<String>>; 2]> {
    let side = |node: &Node| node.text().map_or_else(|| node.texts(), |one| vec![one]);
    f.list("between").iter().map(side).collect::<Vec<_>>().try_into().ok()
}

impl Checker<'_> {
    /// Checks one interface, against the parameters of its law and by the law itself.
    pub(crate) fn interface(
        &mut self,
        table: &'static Table,
        written: &DeTable<'_>,
        span: Range<usize>,
        path: &str,
    ) -> Fields {
        let laws = self.laws.interfaces;
        if written.get("law").and_then(|v| v.get_ref().as_str()) == Some(TIED) {
            // The keys of a law are known here, to be refused for the right reason.
            let mut keys: Vec<Key> = Vec::new();
            for parameter in laws.iter().flat_map(|law| law.parameters) {
                if keys.iter().all(|k| k.name != parameter.name) {
                    keys.push(law_key::of(parameter).when(OF_A_LAW));
                }
            }
            return self.table(table, Some(&keys), written, span, path);
        }
        let form = LawTable { table, laws, instead: &[TIED], key: law_key::of, more: &[] };
        self.law(&form, written, span, path)
    }
}
