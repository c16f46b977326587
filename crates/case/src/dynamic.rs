//! `[dynamic]`: the run itself, its boundaries and damping.

use std::ops::Range;

use tremolite_laws::parameter::Dimension;

use crate::Spanned;
use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table, When, words};

const DURATION: Kind = Kind::Number(Dimension::TIME, Limit::Positive);
const FREQUENCY: Kind = Kind::Number(Dimension::RATE, Limit::Positive);
const FREQUENCY_OR_REST: Kind = Kind::Number(Dimension::RATE, Limit::NotNegative);
const COEFFICIENT: Kind = Kind::Number(Dimension::NONE, Limit::NotNegative);

pub(crate) static DYNAMIC: Table = Table {
    path: "dynamic",
    doc: "The dynamic run: duration, boundaries, damping, time step.",
    keys: &[
        Key::optional("duration", DURATION, "the length of the processed motion", "Time that is computed"),
        Key::default(
            "base",
            Kind::Brief(&BASE, &["kind"]),
            r#""viscous""#,
            "Boundary at the base, where the motion enters",
        ),
        Key::required("sides", Kind::Brief(&SIDES, &["x", "y"]), "boundary at the four sides"),
        Key::default("top", Kind::Word(Top::WORDS), r#""free""#, "Boundary at the top plane"),
        Key::default("damping", Kind::Table(&DAMPING), "{}", "Damping of the rock and the lining"),
        Key::optional(
            "time_step",
            DURATION,
            "`safety` times the stable step",
            "Time step; where it is not stable the energy guard stops the run",
        ),
        Key::default(
            "safety",
            Kind::Number(Dimension::NONE, Limit::UpTo(1.0)),
            "0.9",
            "Time step over the largest stable one",
        ),
        Key::default(
            "levels",
            Kind::Count(4),
            "4",
            "Levels of steps at most: parts of the model that allow it make steps 2, 4 or 8 times as long; 1 for one step of all",
        ),
    ],
    choice: &[],
};

static BASE: Table = Table {
    path: "dynamic.base",
    doc: "Boundary at the base, where the motion enters. Springs are alpha G/R per area.",
    keys: &[
        Key::required("kind", Kind::Word(BaseKind::WORDS), "what holds the base"),
        Key::default("normal", COEFFICIENT, "1.33", "Spring coefficient alpha normal to the base")
            .when(SPRING),
        Key::default("tangential", COEFFICIENT, "0.67", "Spring coefficient alpha along the base")
            .when(SPRING),
        Key::optional(
            "distance",
            Kind::Number(Dimension::LENGTH, Limit::Positive),
            "from the centre of the caverns to the base",
            "Distance R to the scattering source",
        )
        .when(SPRING),
        Key::default(
            "side_springs",
            Kind::Flag,
            "false",
            "Springs of the same coefficients at free-field sides too, R from the centre of the caverns to each side: they hold a block that yields",
        )
        .when(SPRING),
    ],
    choice: &[],
};

const SPRING: When = When::Is("kind", "viscous-spring");

static SIDES: Table = Table {
    path: "dynamic.sides",
    doc: "Boundaries at the sides normal to x and to y.",
    keys: &[
        Key::required("x", Kind::Brief(&SIDE, &["kind"]), "boundary at the two sides normal to x"),
        Key::required("y", Kind::Brief(&SIDE, &["kind"]), "boundary at the two sides normal to y"),
    ],
    choice: &[],
};

static SIDE: Table = Table {
    path: "dynamic.sides.x",
    doc: "Boundary at a pair of sides.",
    keys: &[Key::required("kind", Kind::Word(SideKind::WORDS), "what holds the two sides")],
    choice: &[],
};

static DAMPING: Table = Table {
    path: "dynamic.damping",
    doc: "Damping of the rock and the lining.",
    keys: &[
        Key::default("rayleigh", Kind::Table(&RAYLEIGH), "{}", "Rayleigh damping, C = mass M + stiffness K"),
        Key::optional(
            "ratio",
            Kind::Number(Dimension::NONE, Limit::Positive),
            "",
            "Damping ratio nearly constant over `band`, by three Maxwell bodies; stiffens and cuts the stable step",
        )
        .when(When::Beside("band")),
        Key::optional(
            "band",
            Kind::List(&FREQUENCY, 2, 2),
            "",
            "Lowest and highest frequency of the constant ratio",
        )
        .when(When::Beside("ratio")),
        Key::optional(
            "reference",
            FREQUENCY_OR_REST,
            "the motion's central frequency",
            "Frequency at which Young's moduli are meant, 0 Hz: at rest; they grow with frequency across the band",
        )
        .when(When::Beside("ratio")),
    ],
    choice: &[],
};

static RAYLEIGH: Table = Table {
    path: "dynamic.damping.rayleigh",
    doc: "Rayleigh damping, C = mass M + stiffness K.",
    keys: &[
        Key::default(
            "mass",
            Kind::Number(Dimension::RATE, Limit::NotNegative),
            r#""0 1/s""#,
            "Factor of the mass matrix; ratio mass / (4 π f) at frequency f",
        ),
        Key::default(
            "stiffness",
            Kind::Number(Dimension::TIME, Limit::NotNegative),
            r#""0 s""#,
            "Factor of the stiffness matrix; ratio π f stiffness; cuts the stable step",
        ),
    ],
    choice: &[],
};

words! {
    /// What holds the base.
    BaseKind {
        /// dashpots and springs on the scattered motion; the incident wave enters here
        ViscousSpring = "viscous-spring",
        /// dashpots (Lysmer & Kuhlemeyer); the incident wave enters here
        Viscous = "viscous",
        /// no displacement; no motion enters
        Fixed = "fixed",
        /// no traction; no motion enters
        Free = "free",
    }
}

words! {
    /// What holds a pair of sides.
    SideKind {
        /// a slab of the same ground outside moves as ground without end would, and presses and absorbs here
        FreeField = "free-field",
        /// opposite nodes move as one: an endless row of such blocks
        Periodic = "periodic",
        /// the other half is its mirror image: no displacement normal to the side; a roller, in the shaking too
        Symmetry = "symmetry",
        /// dashpots (Lysmer & Kuhlemeyer)
        Viscous = "viscous",
        /// no displacement normal to the side
        Roller = "roller",
        /// no displacement
        Fixed = "fixed",
        /// no traction
        Free = "free",
    }
}

words! {
    /// What acts on the top plane in the shaking.
    Top {
        /// no traction: the surface of the ground
        Free = "free",
        /// dashpots: ground goes on above, and the wave that its surface would send back is missing
        Viscous = "viscous",
    }
}

/// The dynamic run.
#[derive(Clone, Debug, PartialEq)]
pub struct Dynamic {
    /// s; nothing: the length of the processed motion.
    pub duration: Option<Spanned<f64>>,
    /// Boundary at the base.
    pub base: Spanned<Base>,
    /// The two sides normal to x, and to y.
    pub sides: [Spanned<Side>; 2],
    /// What acts on the top plane in the shaking.
    pub top: Spanned<Top>,
    /// Damping of all materials.
    pub rayleigh: Rayleigh,
    pub band: Option<BandDamping>,
    /// s; nothing: `safety` times the stable step.
    pub time_step: Option<Spanned<f64>>,
    /// Time step over the largest stable one, in (0, 1].
    pub safety: Spanned<f64>,
    /// Levels of steps at most, from 1 to 4.
    pub levels: Spanned<u32>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

/// Boundary at the base.
#[derive(Clone, Debug, PartialEq)]
pub enum Base {
    /// Dashpots ρc and springs α G/R per area.
    ViscousSpring {
        /// α normal to the base.
        normal: Spanned<f64>,
        /// α along the base.
        tangential: Spanned<f64>,
        /// R, m; nothing: from the centre of the caverns to the base.
        distance: Option<Spanned<f64>>,
        /// Springs at free-field sides too.
        side_springs: bool,
    },
    /// Dashpots ρc alone.
    Viscous,
    /// No displacement; no motion enters.
    Fixed,
    /// No motion enters.
    Free,
}

/// Boundary at a pair of sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Side {
    /// Slabs of the same ground outside lead it.
    FreeField,
    /// Opposite nodes move as one.
    Periodic,
    /// A roller that is meant as a mirror.
    Symmetry,
    /// Dashpots ρc.
    Viscous,
    /// No displacement normal to it.
    Roller,
    /// No displacement.
    Fixed,
    /// No traction.
    Free,
}

/// Damping nearly independent of frequency over a band.
#[derive(Clone, Debug, PartialEq)]
pub struct BandDamping {
    pub ratio: Spanned<f64>,
    /// Hz
    pub band: Spanned<[f64; 2]>,
    /// Hz, 0: at rest; nothing: the motion's central frequency. Given where equilibrium is sought before the earthquake.
    pub reference: Option<Spanned<f64>>,
}

/// Rayleigh damping, C = ω M + ξ K.
#[derive(Clone, Debug, PartialEq)]
pub struct Rayleigh {
    /// ω, 1/s.
    pub mass: Spanned<f64>,
    /// ξ, s.
    pub stiffness: Spanned<f64>,
}

impl Dynamic {
    pub(crate) fn read(f: &Fields) -> Option<Self> {
        let (duration, time_step) = (f.number("duration"), f.number("time_step"));
        let base = f.table("base").and_then(Base::read);
        let side = |key| f.table("sides").and_then(|s| s.table(key)).and_then(Side::read);
        let sides = (side("x"), side("y"));
        let top = f.word("top", Top::from_word);
        let rayleigh = f.table("damping").and_then(|d| d.table("rayleigh")).and_then(Rayleigh::read);
        let band = f.table("damping").and_then(BandDamping::read);
        Some(Dynamic {
            duration,
            band,
            time_step,
            safety: f.number("safety")?,
            levels: f.count("levels")?,
            base: base?,
            sides: [sides.0?, sides.1?],
            top: top?,
            rayleigh: rayleigh?,
            span: f.span.clone(),
        })
    }
}

impl Base {
    /// The word for this kind of base as it is written in a case.
    pub fn word(&self) -> &'static str {
        let kind = match self {
            Base::ViscousSpring { .. } => BaseKind::ViscousSpring,
            Base::Viscous => BaseKind::Viscous,
            Base::Fixed => BaseKind::Fixed,
            Base::Free => BaseKind::Free,
        };
        kind.word()
    }

    fn read(f: &Fields) -> Option<Spanned<Self>> {
        let (normal, tangential, distance) =
            (f.number("normal"), f.number("tangential"), f.number("distance"));
        let side_springs = f.flag("side_springs");
        let kind = f.word("kind", BaseKind::from_word)?;
        let base = match kind.value {
            BaseKind::ViscousSpring => {
                let side_springs = side_springs?;
                Base::ViscousSpring { normal: normal?, tangential: tangential?, distance, side_springs }
            }
            BaseKind::Viscous => Base::Viscous,
            BaseKind::Fixed => Base::Fixed,
            BaseKind::Free => Base::Free,
        };
        Some(Spanned::new(base, kind.span))
    }
}

impl Side {
    /// Each word with what it means.
    pub const MEANINGS: &'static [(&'static str, &'static str)] = SideKind::MEANINGS;

    /// The word for this kind of side as it is written in a case.
    pub fn word(self) -> &'static str {
        let kind = match self {
            Side::FreeField => SideKind::FreeField,
            Side::Periodic => SideKind::Periodic,
            Side::Symmetry => SideKind::Symmetry,
            Side::Viscous => SideKind::Viscous,
            Side::Roller => SideKind::Roller,
            Side::Fixed => SideKind::Fixed,
            Side::Free => SideKind::Free,
        };
        kind.word()
    }

    fn read(f: &Fields) -> Option<Spanned<Self>> {
        let kind = f.word("kind", SideKind::from_word)?;
        let side = match kind.value {
            SideKind::FreeField => Side::FreeField,
            SideKind::Periodic => Side::Periodic,
            SideKind::Symmetry => Side::Symmetry,
            SideKind::Viscous => Side::Viscous,
            SideKind::Roller => Side::Roller,
            SideKind::Fixed => Side::Fixed,
            SideKind::Free => Side::Free,
        };
        Some(Spanned::new(side, kind.span))
    }
}

impl BandDamping {
    /// Nothing where no band is given.
    fn read(f: &Fields) -> Option<Self> {
        let (ratio, reference) = (f.number("ratio"), f.number("reference"));
        let band = f.get("band").and_then(|node| node.numbers());
        Some(BandDamping { ratio: ratio?, band: band?, reference })
    }
}

impl Rayleigh {
    fn read(f: &Fields) -> Option<Self> {
        let (mass, stiffness) = (f.number("mass"), f.number("stiffness"));
        Some(Rayleigh { mass: mass?, stiffness: stiffness? })
    }
}
