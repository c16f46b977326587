//! `[initial]`: what is there before the earthquake, and how equilibrium is sought.

use std::ops::Range;

use tremolite_laws::parameter::Dimension;

use crate::defaulted::Defaulted;
use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table, When, words};
use crate::water::LateralOf;
use crate::{Diagnostic, Spanned};

const COORDINATE: Kind = Kind::Number(Dimension::LENGTH, Limit::Any);
const STRESS: Kind = Kind::Number(Dimension::PRESSURE, Limit::Any);
const GRADIENT: Kind = Kind::Number(Dimension::UNIT_WEIGHT, Limit::Any);
const RATIO: Kind = Kind::Number(Dimension::NONE, Limit::NotNegative);

/// The keys that say what the initial stress is, of which one at most is given.
pub(crate) const STRESSES: &[&str] = &["lateral", "stress", "measured"];
/// The keys that have no meaning where no equilibrium is sought.
const SEARCH: [&str; 5] = ["sides", "base", "release_cycles", "max_cycles", "tolerance"];
/// Components of stress, in the order in which they are kept.
const COMPONENTS: [&str; 6] = ["xx", "yy", "zz", "xy", "yz", "zx"];
/// Measured tensors: more are no measurements at points but a field.
const MOST_MEASURED: usize = 1000;

pub(crate) static INITIAL: Table = Table {
    path: "initial",
    doc: "What is there before the earthquake: gravity, stress in the ground, and how equilibrium is sought.",
    keys: &[
        Key::default(
            "gravity",
            Kind::Number(Dimension::ACCELERATION, Limit::NotNegative),
            r#""9.81 m/s2""#,
            "Acceleration of gravity along -z; turns unit weights into densities",
        ),
        Key::optional(
            "lateral",
            Kind::Brief(&LATERAL, &["x", "y"]),
            "",
            "Initial stress by the weight above: horizontal over vertical stress, along x and y or one number for both",
        ),
        Key::optional(
            "k0_stress",
            Kind::Word(LateralOf::WORDS),
            "",
            "Of which stresses `lateral` is the ratio where there is water: effective ones, if left out, or total",
        )
        .when(When::Beside("lateral")),
        Key::optional(
            "stress",
            Kind::Table(&FIELD),
            "",
            "Initial stress as a field, constant or linear over height; tension positive",
        ),
        Key::optional(
            "measured",
            Kind::Tables(&MEASURED),
            "",
            "Initial stress by measured tensors, made a field by a linear regression over depth; tension positive",
        ),
        Key::optional(
            "overburden",
            Kind::Number(Dimension::PRESSURE, Limit::Positive),
            "",
            "Pressure on the top plane, of the ground above that is not modelled",
        )
        .when(When::BesideAny(STRESSES)),
        Key::default(
            "sides",
            Kind::Brief(&HOLD, &["x", "y"]),
            r#""roller""#,
            "What holds the four sides before the earthquake, where they are neither periodic nor fixed; free for specimens",
        ),
        Key::default(
            "base",
            Kind::Word(BaseHold::WORDS),
            r#""fixed""#,
            "What holds the base before the earthquake; free for specimens",
        ),
        Key::default(
            "release_cycles",
            Kind::Count(1_000_000),
            "200",
            "Cycles of relaxation over which what is held is let go",
        ),
        Key::default(
            "max_cycles",
            Kind::Count(100_000_000),
            "20000",
            "Cycles of relaxation after which a stage that is not at rest has failed",
        ),
        Key::default(
            "tolerance",
            Kind::Number(Dimension::NONE, Limit::UpTo(0.01)),
            "1e-5",
            "At rest: what is out of balance over all contributions; motion left is judged at a hundred times this",
        ),
    ],
    choice: &[&["lateral"], &["stress"], &["measured"], &[]],
};

static HOLD: Table = Table {
    path: "initial.sides",
    doc: "What holds the sides normal to x and to y before the earthquake.",
    keys: &[
        Key::required("x", Kind::Word(SideHold::WORDS), "what holds the two sides normal to x"),
        Key::required("y", Kind::Word(SideHold::WORDS), "what holds the two sides normal to y"),
    ],
    choice: &[],
};

words! {
    /// What holds a pair of sides before the earthquake.
    SideHold {
        /// no displacement normal to them
        Roller = "roller",
        /// nothing
        Free = "free",
    }
}

words! {
    /// What holds the base before the earthquake.
    BaseHold {
        /// no displacement
        Fixed = "fixed",
        /// no displacement along z
        Roller = "roller",
        /// nothing
        Free = "free",
    }
}

static LATERAL: Table = Table {
    path: "initial.lateral",
    doc: "Horizontal over vertical stress K0.",
    keys: &[
        Key::required("x", RATIO, "stress along x over vertical stress"),
        Key::required("y", RATIO, "stress along y over vertical stress"),
    ],
    choice: &[],
};

static FIELD: Table = Table {
    path: "initial.stress",
    doc: "A field of stress, tension positive: its value at a point, and its change with height.",
    keys: &[
        Key::default(
            "at",
            Kind::List(&COORDINATE, 3, 3),
            r#"["0 m", "0 m", "0 m"]"#,
            "Where the stress has this value, [x, y, z]",
        ),
        Key::default("xx", STRESS, r#""0 Pa""#, "Normal stress along x"),
        Key::default("yy", STRESS, r#""0 Pa""#, "Normal stress along y"),
        Key::default("zz", STRESS, r#""0 Pa""#, "Normal stress along z"),
        Key::default("xy", STRESS, r#""0 Pa""#, "Shear stress in xy"),
        Key::default("yz", STRESS, r#""0 Pa""#, "Shear stress in yz"),
        Key::default("zx", STRESS, r#""0 Pa""#, "Shear stress in zx"),
        Key::optional(
            "gradient",
            Kind::Table(&CHANGE),
            "the stress is the same at every height",
            "Change of stress per metre of z",
        ),
    ],
    choice: &[],
};

static CHANGE: Table = Table {
    path: "initial.stress.gradient",
    doc: "Change of stress per metre of z.",
    keys: &[
        Key::default("xx", GRADIENT, r#""0 N/m3""#, "Change of the normal stress along x"),
        Key::default("yy", GRADIENT, r#""0 N/m3""#, "Change of the normal stress along y"),
        Key::default("zz", GRADIENT, r#""0 N/m3""#, "Change of the normal stress along z"),
        Key::default("xy", GRADIENT, r#""0 N/m3""#, "Change of the shear stress in xy"),
        Key::default("yz", GRADIENT, r#""0 N/m3""#, "Change of the shear stress in yz"),
        Key::default("zx", GRADIENT, r#""0 N/m3""#, "Change of the shear stress in zx"),
    ],
    choice: &[],
};

static MEASURED: Table = Table {
    path: "initial.measured",
    doc: "A tensor of stress measured at a point, tension positive.",
    keys: &[
        Key::required("at", Kind::List(&COORDINATE, 3, 3), "where it was measured, [x, y, z]"),
        Key::required("xx", STRESS, "normal stress along x"),
        Key::required("yy", STRESS, "normal stress along y"),
        Key::required("zz", STRESS, "normal stress along z"),
        Key::required("xy", STRESS, "shear stress in xy"),
        Key::required("yz", STRESS, "shear stress in yz"),
        Key::required("zx", STRESS, "shear stress in zx"),
    ],
    choice: &[],
};

/// What is there before the earthquake, and how equilibrium is sought.
#[derive(Clone, Debug, PartialEq)]
pub struct Initial {
    /// Acceleration of gravity along −z, m/s²; may be 0.
    pub gravity: Spanned<f64>,
    /// Nothing: the ground is free of stress.
    pub stress: Option<InitialStress>,
    /// Of which stresses `lateral` is the ratio, where there is water.
    pub lateral_of: LateralOf,
    /// Pressure on the top plane, Pa, above 0; only beside a stress.
    pub overburden: Option<Spanned<f64>>,
    /// What holds the sides normal to x and to y, where they are neither periodic nor fixed.
    pub sides: [Spanned<SideHold>; 2],
    /// What holds the base.
    pub base: Spanned<BaseHold>,
    /// Cycles over which what is held is let go.
    pub release_cycles: Spanned<u32>,
    /// More than `release_cycles`.
    pub max_cycles: Spanned<u32>,
    /// Out of balance over all contributions, in (0, 0.01]. Motion left is judged at a hundred times this.
    pub tolerance: Spanned<f64>,
}

/// Initial stress of the ground.
#[derive(Clone, Debug, PartialEq)]
pub enum InitialStress {
    /// The vertical stress is the weight above, and the horizontal ones are these ratios of it.
    Lateral {
        /// Along x, 0 or more.
        x: Spanned<f64>,
        /// Along y, 0 or more.
        y: Spanned<f64>,
        /// The key's value in the case.
        span: Range<usize>,
    },
    /// A given field.
    Field(StressField),
    /// Measured tensors, 1 to 1000 of them.
    Measured(Vec<MeasuredStress>),
}

/// A field of stress: `stress` at `at`, and `gradient` times the height above it.
#[derive(Clone, Debug, PartialEq)]
pub struct StressField {
    /// m
    pub at: [f64; 3],
    /// xx, yy, zz, xy, yz, zx, Pa; tension positive.
    pub stress: [f64; 6],
    /// Change of each per metre of z, Pa/m.
    pub gradient: [f64; 6],
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

/// A tensor of stress measured at a point.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredStress {
    /// m
    pub at: [f64; 3],
    /// xx, yy, zz, xy, yz, zx, Pa; tension positive.
    pub stress: [f64; 6],
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

impl InitialStress {
    /// Its place in the case.
    pub fn span(&self) -> Range<usize> {
        match self {
            InitialStress::Lateral { span, .. } => span.clone(),
            InitialStress::Field(field) => field.span.clone(),
            InitialStress::Measured(all) => {
                let span = |one: Option<&MeasuredStress>| one.map_or(0..0, |m| m.span.clone());
                span(all.first()).start..span(all.last()).end
            }
        }
    }

    fn read(f: &Fields) -> Option<Self> {
        if let Some(lateral) = f.table("lateral") {
            let (x, y) = (lateral.number("x")?, lateral.number("y")?);
            return Some(InitialStress::Lateral { x, y, span: lateral.span.clone() });
        }
        if let Some(field) = f.table("stress") {
            let gradient = field.table("gradient").map_or(Some([0.0; 6]), components)?;
            let (at, stress) = (field.numbers("at")?.value, components(field)?);
            let span = field.span.clone();
            return Some(InitialStress::Field(StressField { at, stress, gradient, span }));
        }
        let measured = |m: &Fields| {
            let (at, stress) = (m.numbers("at")?.value, components(m)?);
            Some(MeasuredStress { at, stress, span: m.span.clone() })
        };
        let all = f.tables("measured").map(measured).collect::<Option<Vec<_>>>()?;
        (!all.is_empty()).then_some(InitialStress::Measured(all))
    }
}

/// The six components of a table that has them all.
fn components(f: &Fields) -> Option<[f64; 6]> {
    let values = COMPONENTS.map(|key| f.number(key).map(|x| x.value));
    values.into_iter().collect::<Option<Vec<f64>>>()?.try_into().ok()
}

impl Initial {
    pub(crate) fn read(f: &Fields) -> Option<Self> {
        let (stress, overburden) = (InitialStress::read(f), f.number("overburden"));
        // One that was refused has been reported, and is not none.
        if stress.is_none() && STRESSES.iter().any(|key| f.get(key).is_some()) {
            return None;
        }
        let (release_cycles, max_cycles) = (f.count("release_cycles"), f.count("max_cycles"));
        let side = |axis| f.table("sides")?.word(axis, SideHold::from_word);
        Some(Initial {
            sides: [side("x")?, side("y")?],
            base: f.word("base", BaseHold::from_word)?,
            gravity: f.number("gravity")?,
            lateral_of: f
                .word("k0_stress", LateralOf::from_word)
                .map_or(LateralOf::Effective, |word| word.value),
            stress,
            overburden,
            release_cycles: release_cycles?,
            max_cycles: max_cycles?,
            tolerance: f.number("tolerance")?,
        })
    }

    /// What lies between keys; looks at each value that is good, whatever the others are.
    pub(crate) fn check(f: &Fields, problems: &mut Vec<Diagnostic>) {
        if let (Some(release), Some(most)) = (f.count("release_cycles"), f.count("max_cycles"))
            && *most <= *release
        {
            // A default stands for the whole table: what was written is what is wrong.
            let at = if most.span == f.span { &release } else { &most };
            problems.push(Diagnostic::at(
                at,
                format!("{} cycles at most end before {} have let go what is held", *most, *release),
                "give `max_cycles` above `release_cycles`; 20000 and 200 are usual",
            ));
        }
        if let Some(first) = f.tables("measured").nth(MOST_MEASURED) {
            problems.push(Diagnostic::new(
                first.span.clone(),
                format!("there are {} measured stresses", f.tables("measured").count()),
                format!("give at most {MOST_MEASURED}, or their field with `stress`"),
            ));
        }
    }

    /// Takes what has no meaning without a search for equilibrium out of what is said of keys left out.
    pub(crate) fn hide_search(defaulted: &mut Vec<Defaulted>) {
        let of_search =
            |d: &Defaulted| d.key.strip_prefix("initial.").is_some_and(|key| SEARCH.contains(&key));
        defaulted.retain(|d| !of_search(d));
    }
}
