//! `[[motion.wave]]`: a plane wave at an angle that carries a component of the motion.

use std::ops::Range;

use tremolite_laws::parameter::Dimension;

use super::Direction;
use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table, When, words};
use crate::{Diagnostic, Spanned};

/// 89°: nearer to level a wave never gets through a model.
const STEEPEST: f64 = 89.0 / 180.0 * std::f64::consts::PI;

pub(crate) static WAVE: Table = Table {
    path: "motion.wave",
    doc: "A plane wave at an angle that carries a component of the motion. Several are added; all have the record's time at `at`.",
    keys: &[
        Key::required("type", Kind::Word(WaveWord::WORDS), "what it is: P, SV or SH"),
        Key::required(
            "angle",
            Kind::Number(Dimension::ANGLE, Limit::Within(STEEPEST)),
            "its way from the vertical, in the rock of the base",
        ),
        Key::required(
            "azimuth",
            Kind::Number(Dimension::ANGLE, Limit::Any),
            "its way in plan, clockwise from north",
        ),
        Key::required(
            "component",
            Kind::Word(WaveComponent::WORDS),
            "which component of the motion is its own: along its way (P), h cos θ − z sin θ (SV) or z × h (SH), h being its way in plan; \
             or \"together\": a P, an SV and an SH wave that make all of it",
        ),
        Key::default("scale", Kind::Number(Dimension::NONE, Limit::Any), "1.0", "Factor on that component"),
        Key::optional(
            "surface_component",
            Kind::Word(SurfacePart::WORDS),
            "",
            "With `kind = \"outcrop\"`, the part of the rock surface's motion under it that the component is: \"along\" unless given",
        )
        .when(When::IsNot("type", "SH")),
    ],
    choice: &[],
};

words! {
    /// The type of a plane wave.
    WaveWord {
        /// Pressure: it moves along its way.
        P = "P",
        /// Shear in the vertical plane of its way.
        Sv = "SV",
        /// Shear across that plane.
        Sh = "SH",
    }
}

words! {
    /// What of a motion a wave carries.
    WaveComponent {
        /// The component towards east.
        East = "east",
        /// That towards north.
        North = "north",
        /// That upwards.
        Up = "up",
        /// All components, with two other waves: one is P, one SV and one SH.
        Together = "together",
    }
}

words! {
    /// A part of the motion of a rock surface under a P or SV wave.
    SurfacePart {
        /// Along the wave's way in plan.
        Along = "along",
        /// Upwards.
        Up = "up",
    }
}

/// A plane wave at an angle.
#[derive(Clone, Debug, PartialEq)]
pub struct Wave {
    /// What it is.
    pub kind: Spanned<WaveWord>,
    /// Its way from the vertical in the rock of the base, rad.
    pub angle: Spanned<f64>,
    /// Its way in plan, clockwise from north, rad.
    pub azimuth: Spanned<f64>,
    /// The component of the motion that it carries.
    pub component: Spanned<WaveComponent>,
    /// Factor on that.
    pub scale: Spanned<f64>,
    /// With an outcrop's motion, which part of that the component is; nothing: along its way, across it for SH.
    pub part: Option<Spanned<SurfacePart>>,
    /// Its table in the case.
    pub span: Range<usize>,
}

impl Wave {
    pub(super) fn read(f: &Fields) -> Option<Self> {
        Some(Wave {
            kind: f.word("type", WaveWord::from_word)?,
            angle: f.number("angle")?,
            azimuth: f.number("azimuth")?,
            component: f.word("component", WaveComponent::from_word)?,
            scale: f.number("scale")?,
            part: f.word("surface_component", SurfacePart::from_word),
            span: f.span.clone(),
        })
    }
}

/// Refuses components that no wave carries. Those of one file with all components are warned of where the file is read.
fn check_carried(motion: &Fields, waves: &[&Fields], problems: &mut Vec<Diagnostic>) {
    let carried: Vec<String> = waves.iter().filter_map(|f| Some(f.text("component")?.value)).collect();
    // A wave without its component is refused by itself.
    if waves.is_empty() || carried.len() < waves.len() {
        return;
    }
    for name in Direction::WORDS {
        let (Some(node), false) = (motion.get(name), carried.iter().any(|word| word == name)) else {
            continue;
        };
        problems.push(Diagnostic::new(
            node.span.clone(),
            format!("no [[motion.wave]] carries `{name}`, so it does not enter"),
            format!("add a wave with component = \"{name}\", or leave `{name}` out: an inclined wave moves other axes as well"),
        ));
    }
}

/// Refuses waves that are no part of the motion that is given.
pub(super) fn check(motion: &Fields, problems: &mut Vec<Diagnostic>) {
    let waves: Vec<&Fields> = motion.tables("wave").collect();
    if let (Some(wave), Some(kind)) = (waves.first(), motion.text("kind"))
        && ["within", "surface"].contains(&kind.value.as_str())
    {
        problems.push(Diagnostic::new(
            wave.span.clone(),
            format!(
                "a motion of kind \"{}\" goes through layered ground straight up alone, and waves at an angle are given beside it",
                kind.value
            ),
            "give the waves' own motion with kind = \"incident\", or that of bare rock with \"outcrop\"; or leave the waves out",
        ));
    }
    let part = waves.iter().find_map(|wave| wave.get("surface_component"));
    if let (Some(part), Some(kind)) = (part, motion.text("kind"))
        && kind.value == "incident"
    {
        problems.push(Diagnostic::new(
            part.span.clone(),
            "`part` is one of a rock surface's motion, and the motion is the incident wave itself",
            "leave it out, or write kind = \"outcrop\"",
        ));
    }
    let together =
        |f: &&Fields| f.text("component").is_some_and(|word| word.value == WaveComponent::Together.word());
    if let Some(first) = waves.iter().copied().find(|f| together(f)) {
        let mut kinds: Vec<String> = waves.iter().filter_map(|f| Some(f.text("type")?.value)).collect();
        kinds.sort_unstable();
        let part = waves.iter().any(|f| f.get("surface_component").is_some());
        if !waves.iter().all(together) || kinds != ["P", "SH", "SV"] || part {
            problems.push(Diagnostic::new(
                first.get("component").map_or(first.span.clone(), |node| node.span.clone()),
                "waves carry a motion together as one P, one SV and one SH wave, each with component = \"together\" and without `part`",
                "give these three, or each wave a component of its own",
            ));
        }
        return;
    }
    if motion.text("file").is_some() {
        return;
    }
    check_carried(motion, &waves, problems);
    for wave in waves {
        let Some(component) = wave.word("component", Direction::from_word) else { continue };
        if motion.table(component.value.word()).is_none() {
            let message = format!(
                "the motion has no component '{}' that this wave could carry",
                component.value.word()
            );
            problems.push(Diagnostic::at(&component, message, "name one that [motion] gives"));
        }
    }
}
