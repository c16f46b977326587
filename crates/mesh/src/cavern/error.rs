//! What can be wrong with a description of caverns, and the limits that the messages name.

use std::fmt;

use crate::boxes::MOST_ELEMENTS;
use crate::grading::GradingError;

pub(super) const MOST_CAVERNS: usize = 1000;

/// No element round a cavern may have a smaller scaled Jacobian, and none of a lining or of shotcrete.
pub(super) const LEAST_JACOBIAN: [f64; 2] = [0.3, 0.6];

/// Why no mesh could be made. `key` is the name of the value in [`CavernSpec`](super::CavernSpec), with the cavern's
/// name in front where it belongs to one, such as `powerhouse.arch_rise`.
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
                "cavern {cavern:?}: an element of its lining or shotcrete has a scaled Jacobian of {scaled_jacobian:.3}, below {limit}; \
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
