//! What can be wrong with a description of caverns, and the checks on a single value or cavern.

use std::fmt;

use super::profile::Profile;
use super::section::LEAST_JACOBIAN;
use super::tube::{HORSESHOE, Tube};
use super::{Cavern, CavernShape, CavernSpec};
use crate::boxes::MOST_ELEMENTS;
use crate::grading::GradingError;

const MOST_CAVERNS: usize = 1000;
const MOST_LAYERS: u32 = 20;

/// Why no mesh could be made. `key` is the name of the value in [`CavernSpec`], with the cavern's name in
/// front where it belongs to one, such as `powerhouse.arch_rise`.
#[derive(Clone, Debug, PartialEq)]
pub enum CavernError {
    /// A value out of its range; `must` says what it has to be.
    Value { key: String, value: f64, must: String },
    /// A name that cannot be used; `must` says what it has to be.
    Name { name: String, must: &'static str },
    /// No cavern, or more than a thousand.
    Caverns { count: usize },
    /// Two caverns that overlap or leave less rock between them than two elements need.
    TooClose { first: String, second: String, rock: f64, needed: f64 },
    /// A cavern that does not fit between the ground, the base and the sides with room for elements.
    TooNearToEdge { cavern: String, key: &'static str, rock: f64, needed: f64 },
    /// More elements than fifty million.
    TooMany { elements: f64 },
    /// A line of the grid could not be divided.
    Grading { line: &'static str, cause: GradingError },
    /// Elements round a cavern came out inverted, or with a smaller scaled Jacobian than `limit`.
    Poor { cavern: String, scaled_jacobian: f64, limit: f64 },
    /// A gallery that cannot be made; `why` says what is wrong, after its name.
    Gallery { gallery: String, why: String },
    /// A gallery that no rows of elements lead through from wall to wall.
    GalleryRows { gallery: String },
    /// The ground comes too near to the surroundings of the caverns; `at` is x and y.
    LowGround { at: [f64; 2], height: f64, needed: f64 },
    /// Rock that follows the ground came out with a smaller scaled Jacobian than `limit`.
    SteepGround { scaled_jacobian: f64, limit: f64 },
}

impl CavernError {
    /// What the error is about: the name of a value as in `key`, or of a cavern or gallery; empty for the whole.
    pub fn subject(&self) -> &str {
        match self {
            Self::Value { key, .. } => key,
            Self::Name { name, .. } => name,
            Self::TooClose { second: name, .. }
            | Self::TooNearToEdge { cavern: name, .. }
            | Self::Poor { cavern: name, .. }
            | Self::Gallery { gallery: name, .. }
            | Self::GalleryRows { gallery: name } => name,
            Self::Caverns { .. }
            | Self::TooMany { .. }
            | Self::Grading { .. }
            | Self::LowGround { .. }
            | Self::SteepGround { .. } => "",
        }
    }
}

impl fmt::Display for CavernError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Value { key, value, must } => write!(f, "{key} is {value}; it must be {must}"),
            Self::Name { name, must } => write!(f, "the name {name:?} must {must}"),
            Self::Caverns { count } => {
                write!(f, "{count} caverns; there must be at least one and at most {MOST_CAVERNS}")
            }
            Self::TooClose { first, second, rock, needed } => write!(
                f,
                "caverns {first:?} and {second:?}: {rock:.3} m of rock between their linings (negative: they \
                 overlap), {needed:.3} m are needed; move them apart with `at` or lower `near`"
            ),
            Self::TooNearToEdge { cavern, key, rock, needed } => write!(
                f,
                "cavern {cavern:?}: {rock:.3} m of rock to the edge of the block, {needed:.3} m are needed; \
                 raise `{key}` or lower `near`"
            ),
            Self::TooMany { elements } => write!(
                f,
                "about {elements:.1e} elements, the limit is {MOST_ELEMENTS}; raise `near`, `far` or `along` \
                 (check their units)"
            ),
            Self::Grading { line, cause } => {
                write!(f, "grid along {line}: {cause}; check `near`, `far`, `along`")
            }
            Self::Poor { cavern, scaled_jacobian, limit } if *limit == LEAST_JACOBIAN[1] => write!(
                f,
                "cavern {cavern:?}: an element of its lining has a scaled Jacobian of {scaled_jacobian:.3}, below {limit}; \
                 bring `lining.walls`, `lining.crown` and `lining.floor` nearer to one another, or lower `near`"
            ),
            Self::Poor { cavern, scaled_jacobian, limit } => write!(
                f,
                "cavern {cavern:?}: an element has a scaled Jacobian of {scaled_jacobian:.3}, below {limit}; \
                 try another `near`, more rock around the cavern, or fewer benches"
            ),
            Self::Gallery { gallery, why } => write!(f, "gallery {gallery:?} {why}"),
            Self::GalleryRows { gallery } => write!(
                f,
                "gallery {gallery:?} and the benches, floors and roofs of its two caverns leave no way to lead rows of \
                 elements from wall to wall; lower `near`, or move the gallery or a cavern with `at`"
            ),
            Self::LowGround { at: [x, y], height, needed } => write!(
                f,
                "the ground at x = {x:.1} m, y = {y:.1} m is at z = {height:.1} m; the caverns' surroundings need \
                 at least {needed:.1} m there; raise `overburden` or the ground"
            ),
            Self::SteepGround { scaled_jacobian, limit } => write!(
                f,
                "the ground is so steep that an element has a scaled Jacobian of {scaled_jacobian:.3}, below \
                 {limit}; smooth the table of heights or lower the slope"
            ),
        }
    }
}

impl std::error::Error for CavernError {
    fn source(&self) -> Option<&(dyn std::error::Error + 'static)> {
        match self {
            Self::Grading { cause, .. } => Some(cause),
            _ => None,
        }
    }
}

pub(super) fn value(key: impl Into<String>, value: f64, must: impl Into<String>) -> CavernError {
    CavernError::Value { key: key.into(), value, must: must.into() }
}

/// The checks that need no geometry of the block as a whole.
pub(super) fn check(spec: &CavernSpec) -> Result<(), CavernError> {
    let lengths = [
        ("overburden", spec.overburden),
        ("below", spec.below),
        ("sides", spec.sides),
        ("length", spec.length),
        ("near", spec.near),
        ("far", spec.far),
        ("along", spec.along.unwrap_or(spec.near)),
    ];
    for (key, length) in lengths {
        // A block larger than the Earth is a slip, and its squares stay finite.
        if !(length > 0.0 && length <= 1e7) {
            return Err(value(key, length, "a length above 0 (and at most 1e7 m)"));
        }
    }
    if spec.far < spec.near {
        return Err(value("far", spec.far, format!("at least `near`, {} m", spec.near)));
    }
    if spec.caverns.is_empty() || spec.caverns.len() > MOST_CAVERNS {
        return Err(CavernError::Caverns { count: spec.caverns.len() });
    }
    for (k, cavern) in spec.caverns.iter().enumerate() {
        let name = &cavern.name;
        check_name(name, spec.caverns[..k].iter().any(|other| other.name == *name))?;
        check_cavern(cavern, spec.near)?;
    }
    super::strata::check(&spec.layers)?;
    super::ground::check(&spec.ground)?;
    super::gallery::check(spec)
}

/// The first part of a group's name, or the last; `taken` if another has it.
pub(super) fn check_name(name: &str, taken: bool) -> Result<(), CavernError> {
    let forbidden = |c: char| c.is_whitespace() || c.is_control() || ".*?[]{}\"'".contains(c);
    let must = if name.is_empty() || name.contains(forbidden) {
        "be a word without dots, stars, question marks, brackets, quotes or blanks"
    } else if name == "rock" || taken {
        "be used once, and not be \"rock\""
    } else {
        return Ok(());
    };
    Err(CavernError::Name { name: name.to_owned(), must })
}

fn check_cavern(cavern: &Cavern, near: f64) -> Result<(), CavernError> {
    let key = |k: &str| format!("{}.{k}", cavern.name);
    let rise =
        if matches!(cavern.shape, CavernShape::Arch | CavernShape::Ellipse) { cavern.arch_rise } else { 1.0 };
    for (k, length) in [("width", cavern.width), ("height", cavern.height), ("arch_rise", rise)] {
        if !(length > 0.0 && length <= 1e5) {
            return Err(value(key(k), length, "a length above 0 (and at most 1e5 m)"));
        }
    }
    for at in cavern.at {
        if !(-1e6..=1e6).contains(&at) {
            return Err(value(key("at"), at, "a length (and at most 1e6 m)"));
        }
    }
    let half = cavern.width / 2.0;
    let (walls, what) = match cavern.shape {
        CavernShape::Arch | CavernShape::Ellipse => {
            let (most, why) = if cavern.shape == CavernShape::Arch {
                (half, "half the width")
            } else {
                (cavern.width, "the width")
            };
            if cavern.arch_rise > most * (1.0 + 1e-12) {
                let must = format!("at most {why}, {most} m, for a roof of this shape");
                return Err(value(key("arch_rise"), cavern.arch_rise, must));
            }
            // An ellipse that is flatter bends too sharply at the springings.
            let least = if cavern.shape == CavernShape::Arch { 0.02 } else { 0.15 } * cavern.width;
            if cavern.arch_rise < least {
                let must = format!("at least {least:.3} m for this width and shape");
                return Err(value(key("arch_rise"), cavern.arch_rise, must));
            }
            (cavern.height - cavern.arch_rise, "straight wall")
        }
        CavernShape::Rectangle => (cavern.height, "straight wall"),
        CavernShape::Circle => {
            if (cavern.height / cavern.width - 1.0).abs() > 1e-9 {
                let must = format!("the width, {} m, for a circle", cavern.width);
                return Err(value(key("height"), cavern.height, must));
            }
            (cavern.height * std::f64::consts::FRAC_1_SQRT_2, "wall")
        }
        CavernShape::Horseshoe => {
            let [low, high] = HORSESHOE.map(|share| share * cavern.width);
            if !(low..=high).contains(&cavern.height) {
                let must = format!("from {low} m to {high} m for a horseshoe of this width");
                return Err(value(key("height"), cavern.height, must));
            }
            let [low, high] = Tube::new(cavern).wall();
            (high - low, "wall")
        }
    };
    if walls < 0.25 * near {
        let must = format!(
            "above the arch rise, {} m, by at least a quarter of `near`: the walls are straight up to the arch",
            cavern.arch_rise
        );
        return Err(value(key("height"), cavern.height, must));
    }
    let most = (walls / (0.25 * near)).floor();
    if cavern.benches == 0 || f64::from(cavern.benches) > most {
        let must = format!(
            "from 1 to {most}: with {walls} m of {what} a bench may not be lower than a quarter of `near`"
        );
        return Err(value(key("benches"), f64::from(cavern.benches), must));
    }
    check_lining(cavern, half, &key)
}

fn check_lining(cavern: &Cavern, half: f64, key: &dyn Fn(&str) -> String) -> Result<(), CavernError> {
    let lining = &cavern.lining;
    for (k, thickness) in
        [("lining.walls", lining.walls), ("lining.crown", lining.crown), ("lining.floor", lining.floor)]
    {
        if !(thickness >= 0.0 && thickness <= half) {
            return Err(value(key(k), thickness, format!("from 0 to half the width, {half} m")));
        }
    }
    if lining.is_none() {
        return Ok(());
    }
    if lining.walls == 0.0 || lining.crown == 0.0 {
        let (k, other) = if lining.walls == 0.0 { ("walls", "crown") } else { ("crown", "walls") };
        let must = format!("above 0 where `lining.{other}` is, or leave out both and the floor");
        return Err(value(key(&format!("lining.{k}")), 0.0, must));
    }
    if lining.layers == 0 || lining.layers > MOST_LAYERS {
        let must = format!("from 1 to {MOST_LAYERS}");
        return Err(value(key("lining.layers"), f64::from(lining.layers), must));
    }
    if cavern.shape.is_closed() {
        if lining.floor == 0.0 {
            return Err(value(key("lining.floor"), 0.0, "above 0: round this shape the lining is closed"));
        }
        return Ok(());
    }
    if cavern.shape != CavernShape::Arch {
        return Ok(());
    }
    let profile = Profile::new(cavern);
    let rise = profile.outer.rise;
    if rise < 0.02 * cavern.width || rise > 1.1 * profile.outer.half {
        let least = lining.crown + 0.02 * cavern.width - rise;
        let most = lining.crown + 1.1 * profile.outer.half - rise;
        let must = format!(
            "from {:.3} m to {most:.3} m, so that the extrados stays an arch on walls of {} m",
            least.max(0.0),
            lining.walls
        );
        return Err(value(key("lining.crown"), lining.crown, must));
    }
    Ok(())
}
