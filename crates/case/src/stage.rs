//! `[[stage]]`: what is excavated, installed and changed before the earthquake, one after the other.

mod displacement;

pub(crate) use displacement::in_steps;
pub use displacement::{Displacement, Moved};

use std::ops::Range;

use toml::de::{DeTable, DeValue};
use tremolite_laws::parameter::Dimension;

use crate::bolts::{BOLTS_KIND, Bolts};
use crate::fields::Fields;
use crate::initial::STRESSES;
use crate::keys::{Key, Kind, Limit, Table};
use crate::material::VOID;
use crate::water::{OF_STAGE, StageWater};
use crate::{Diagnostic, Spanned};
use displacement::DISPLACEMENT_KIND;

const GROUPS: Kind = Kind::List(&Kind::Text, 1, 1000);
/// Stages beyond which a case is a slip of whoever wrote the program that wrote it.
const MOST_STAGES: usize = 10_000;

pub(crate) static STAGE: Table = Table {
    path: "stage",
    doc: "A stage before the earthquake. One that changes nothing lets go of what is still held.",
    keys: &[
        Key::required("name", Kind::Text, "what the stage is called"),
        Key::optional("excavate", GROUPS, "", "Groups that are taken out; * stands for any text"),
        Key::optional(
            "install",
            GROUPS,
            "",
            "Groups that stand from here on, free of stress; * stands for any text",
        ),
        Key::default(
            "release",
            Kind::Number(Dimension::NONE, Limit::Within(1.0)),
            "1",
            "Share of what is held that goes in this stage; the rest joins what the next one lets go",
        ),
        Key::optional(
            "material",
            Kind::Map("powerhouse.lining*", &Kind::Text),
            "",
            "Groups that are of another material from here on, each with the material's name",
        ),
        Key::optional(
            "pressure",
            Kind::Map("powerhouse.lining*", &Kind::Number(Dimension::PRESSURE, Limit::Any)),
            "",
            "Pressure from here on, on the faces between the void and a group on either side of them, or on the \"top\"; below 0 it pulls",
        ),
        Key::optional("water", Kind::Table(&OF_STAGE), "", "Water from here on"),
        Key::optional(
            "displacement",
            DISPLACEMENT_KIND,
            "",
            "Nodes that are moved, with the force that it takes in stages.csv: entries, or one in braces",
        ),
        Key::optional(
            "bolts",
            BOLTS_KIND,
            "",
            "Rock bolts and anchors that are placed: entries, or one in braces",
        ),
    ],
    choice: &[],
};

/// A stage before the earthquake.
#[derive(Clone, Debug, PartialEq)]
pub struct Stage {
    /// Unique.
    pub name: Spanned<String>,
    /// Groups that are taken out: names in which `*` stands for any text (see [`pattern::matches`](crate::pattern::matches)).
    pub excavate: Vec<Spanned<String>>,
    /// Groups that stand from here on, likewise, free of stress. One that is excavated in the same stage as well takes the place
    /// of what was there. No pattern stands twice in a list.
    pub install: Vec<Spanned<String>>,
    /// Share of what is held that goes in this stage, in \[0, 1\].
    pub release: Spanned<f64>,
    /// Groups, likewise, and what they are made of from here on: an index into [`Case::materials`](crate::Case::materials).
    pub materials: Vec<(Spanned<String>, Spanned<usize>)>,
    /// Groups, likewise, on either side of faces that bound the void, or "top"; and the pressure there from here on, Pa;
    /// below 0 a pull.
    pub pressures: Vec<(Spanned<String>, Spanned<f64>)>,
    /// Water from here on.
    pub water: StageWater,
    /// Nodes that are moved, and those of other stages where they stand then.
    pub displacements: Vec<Displacement>,
    /// Whether it is the stage itself that moves some.
    pub moves: bool,
    /// Rock bolts and anchors that are placed.
    pub bolts: Vec<Bolts>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

impl Stage {
    /// `names` are those of all materials, in order.
    pub(crate) fn read(f: &Fields, names: &[&str]) -> Option<Self> {
        let index = |name: Spanned<String>| {
            Some(Spanned::new(names.iter().position(|n| *n == name.value)?, name.span))
        };
        let materials = f.entries("material").iter();
        let pressures = f.entries("pressure").iter();
        let name = f.text("name")?;
        Some(Stage {
            displacements: f.tables("displacement").map(Displacement::read).collect::<Option<_>>()?,
            moves: false,
            bolts: f.tables("bolts").map(|bolts| Bolts::read(bolts, &name)).collect::<Option<_>>()?,
            name,
            excavate: f.texts("excavate"),
            install: f.texts("install"),
            release: f.number("release")?,
            materials: materials
                .map(|(pattern, node)| Some((pattern.clone(), index(node.text()?)?)))
                .collect::<Option<_>>()?,
            pressures: pressures
                .map(|(pattern, node)| Some((pattern.clone(), node.number()?)))
                .collect::<Option<_>>()?,
            water: StageWater::read(f)?,
            span: f.span.clone(),
        })
    }

    /// A stage of the same name and place that changes nothing.
    pub(crate) fn plain(of: &Stage) -> Stage {
        Stage {
            excavate: Vec::new(),
            install: Vec::new(),
            materials: Vec::new(),
            pressures: Vec::new(),
            water: StageWater::default(),
            displacements: Vec::new(),
            bolts: Vec::new(),
            ..of.clone()
        }
    }

    /// What lies between the stages.
    pub(crate) fn check(case: &Fields, written: &Written, problems: &mut Vec<Diagnostic>) {
        let steps = |stage: &Fields| {
            stage
                .tables("displacement")
                .find_map(|f| f.count("steps"))
                .map_or(1, |steps| steps.value as usize)
        };
        let total: usize = case.tables("stage").map(steps).sum();
        if total > MOST_STAGES
            && let Some(last) = case.tables("stage").last()
        {
            problems.push(Diagnostic::new(
                last.span.clone(),
                format!("there are {total} stages, each step of a displacement being one"),
                format!("give at most {MOST_STAGES}"),
            ));
        }
        Displacement::check(case, problems);
        for region in case.tables("region") {
            let Some(before) = region.text("before") else { continue };
            if *before == VOID {
                problems.push(Diagnostic::at(
                    &before,
                    "what stands in the place until it is excavated is a material",
                    "name the material, and take it out with the `excavate` of a [[stage]]",
                ));
            } else if !written.installs {
                problems.push(Diagnostic::at(
                    &before,
                    "no stage installs anything, so nothing stands there before",
                    "leave `before` out, or add a [[stage]] with install = [\"…\"]",
                ));
            }
        }
    }
}

/// What a case has, whether or not it is good; what is refused is reported, and not missed as well.
#[derive(Clone, Debug)]
pub(crate) struct Written {
    /// An earthquake.
    pub motion: bool,
    /// Initial stress.
    pub stress: bool,
    /// Initial stress, or stages.
    pub equilibrium: bool,
    /// A stage that installs something.
    pub installs: bool,
    /// Of each stage whether it excavates something.
    pub excavates: Vec<bool>,
    /// Entries of bolts in all stages.
    pub bolts: usize,
    /// The frequency at which moduli are meant.
    pub reference: bool,
    /// Paths of keys and tables that were refused one by one: what follows from them alone is not told beside them.
    pub refused: Vec<String>,
}

impl Written {
    pub fn of(document: &DeTable<'_>, refused: Vec<String>) -> Self {
        let table = |value: &DeValue<'_>, keys: &[&str]| {
            value.as_table().is_none_or(|table| keys.iter().any(|key| table.contains_key(*key)))
        };
        let stages = document.get("stage").map(|v| v.get_ref());
        let stress = document.get("initial").is_some_and(|v| table(v.get_ref(), STRESSES));
        let each = stages.and_then(DeValue::as_array);
        Written {
            motion: document.contains_key("motion"),
            stress,
            equilibrium: stages.is_some() || stress,
            installs: stages.is_some()
                && each.is_none_or(|all| all.iter().any(|v| table(v.get_ref(), &["install"]))),
            excavates: each
                .into_iter()
                .flat_map(|all| all.iter().map(|v| table(v.get_ref(), &["excavate"])))
                .collect(),
            bolts: each
                .into_iter()
                .flat_map(|all| all.iter().filter_map(|v| v.get_ref().as_table()?.get("bolts")))
                .map(|v| v.get_ref().as_array().map_or(1, |entries| entries.len()))
                .sum(),
            reference: document
                .get("dynamic")
                .and_then(|v| v.get_ref().as_table()?.get("damping"))
                .is_some_and(|v| table(v.get_ref(), &["reference"])),
            refused,
        }
    }

    /// Whether something at a path or below it was refused.
    pub fn is_refused(&self, path: &str) -> bool {
        let below = |refused: &String| {
            let rest = refused.strip_prefix(path);
            rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(['.', '[']))
        };
        self.refused.iter().any(below)
    }
}
