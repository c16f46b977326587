//! What can be wrong with a description of caverns, and the limits that the messages name.

use std::fmt;

use crate::boxes::MOST_ELEMENTS;
use crate::grading::GradingError;

pub(super) const MOST_CAVERNS: usize = 1000;

/// No element round a cavern may have a smaller scaled Jacobian, and none of a lining or of shotcrete.
pub(super) const LEAST_JACOBIAN: [f64; 2] = [0.3, 0.6];

/// Rock beside a cavern that elements need, over the size `near`.
pub(super) const ROCK: f64 = 1.2;

/// Why no mesh could be made. `key` is the name of the value in [`CavernSpec`](super::CavernSpec), with the cavern's
/// name in front where it belongs to one, such as `powerhouse.arch_rise`.
#[derive(Clone, Debug, PartialEq)]
pub enum CavernError {
    /// A value out of its range; `must` says what it has to be.
    Value { key: String, value: f64, must: String },
    /// A name that cannot be used, of a cavern, a gallery or a layer; `why` says what is wrong with it.
    Name { of: Named, name: String, why: String },
    /// No cavern, or more than a thousand.
    Caverns { count: usize },
    /// Two caverns that overlap or leave less rock between them than two elements need.
    TooClose { first: String, second: String, rock: f64, needed: f64 },
    /// A cavern that does not fit between the ground, the base and the sides with room for elements.
    TooNearToEdge { cavern: String, key: &'static str, rock: f64, needed: f64 },
    /// More elements than fifty million, of the sizes `near` and `along` \[m\].
    TooMany { elements: f64, near: f64, along: f64 },
    /// A line of the grid could not be divided by the size of this key.
    Grading { line: &'static str, key: &'static str, cause: GradingError },
    /// Elements round a cavern came out inverted, or with a smaller scaled Jacobian than `limit`, with elements of the size `near` \[m\].
    Poor { cavern: String, near: f64, scaled_jacobian: f64, limit: f64 },
    /// A gallery that cannot be made; `why` says what is wrong, after its name.
    Gallery { gallery: String, why: String },
    /// A gallery that no rows of elements of the size `near` \[m\] lead through from wall to wall.
    GalleryRows { gallery: String, near: f64 },
    /// The ground comes too near to the surroundings of the caverns; `at` is x and y.
    LowGround { at: [f64; 2], height: f64, needed: f64 },
    /// Rock that follows the ground came out with a smaller scaled Jacobian than `limit`.
    SteepGround { scaled_jacobian: f64, limit: f64 },
}

/// What has a name in a description of caverns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Named {
    Cavern,
    Gallery,
    Layer,
}

impl Named {
    fn word(self) -> &'static str {
        match self {
            Named::Cavern => "cavern",
            Named::Gallery => "gallery",
            Named::Layer => "layer",
        }
    }
}

impl CavernError {
    /// What is to be changed, or is wrong: the name of a value as in `key`, or of a cavern or gallery; empty for the whole.
    pub fn subject(&self) -> String {
        match self {
            Self::Value { key, .. } => key.clone(),
            Self::TooNearToEdge { key, .. } | Self::Grading { key, .. } => (*key).to_owned(),
            Self::TooClose { second, .. } => format!("{second}.at"),
            Self::Name { of: Named::Layer, name, .. } => format!("layer {name}"),
            Self::Name { name, .. } | Self::Gallery { gallery: name, .. } => name.clone(),
            Self::Poor { cavern, limit, .. } if *limit == LEAST_JACOBIAN[1] => format!("{cavern}.lining"),
            Self::Poor { .. } | Self::GalleryRows { .. } => "size_near".to_owned(),
            Self::TooMany { near, along, .. } => {
                if along < near { "size_along" } else { "size_near" }.to_owned()
            }
            Self::LowGround { .. } => "overburden".to_owned(),
            Self::SteepGround { .. } => "ground".to_owned(),
            Self::Caverns { .. } => String::new(),
        }
    }
}

/// To the centimetre above and below, so that a length that is named is taken; round-off makes no other centimetre.
fn at_least(length: f64) -> f64 {
    (100.0 * length - 1e-6).ceil() / 100.0
}

fn at_most(length: f64) -> f64 {
    (100.0 * length + 1e-6).floor() / 100.0
}

/// A size \[m\] of elements of which a cavern has this much rock beside it, if there is one worth the name.
fn smaller(rock: f64) -> String {
    match at_most(rock / ROCK) {
        near if near > 0.0 => format!(", or lower `size_near` to {near} m"),
        _ => String::new(),
    }
}

impl fmt::Display for CavernError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Value { key, value, must } => write!(f, "{key} is {value}; it must be {must}"),
            Self::Name { of, name, why } => write!(f, "{} {name:?}: {why}; choose another name", of.word()),
            Self::Caverns { count } => {
                write!(f, "{count} caverns; there must be at least one and at most {MOST_CAVERNS}")
            }
            Self::TooClose { first, second, rock, needed } => write!(
                f,
                "caverns {first:?} and {second:?}: {rock:.3} m of rock between their linings (negative: they \
                 overlap), {needed:.3} m are needed, {ROCK} times `size_near`; move them apart by {apart} m with `at`{smaller}",
                apart = at_least(needed - rock),
                smaller = smaller(*rock)
            ),
            Self::TooNearToEdge { cavern, key, rock, needed } => write!(
                f,
                "cavern {cavern:?}: {rock:.3} m of rock to the edge of the block (negative: it lies beyond), {needed:.3} m are \
                 needed, {ROCK} times `size_near`; raise `{key}` by {more} m{smaller}",
                more = at_least(needed - rock),
                smaller = smaller(*rock)
            ),
            Self::TooMany { elements, near, along } => write!(
                f,
                "about {elements:.1e} elements with `size_near` {near} m and {along} m along the caverns, the limit is {MOST_ELEMENTS}; raise \
                 {} (look at its unit)",
                if along < near { "`size_along`" } else { "`size_near`, or `size_far` with it" }
            ),
            Self::Grading { line, key, cause } => {
                write!(f, "grid along {line}: {cause}; change `{key}` (look at its unit)")
            }
            Self::Poor { cavern, near, scaled_jacobian, limit } if *limit == LEAST_JACOBIAN[1] => write!(
                f,
                "cavern {cavern:?} in elements of {near} m: one of its lining or shotcrete has a scaled Jacobian of {scaled_jacobian:.3}, \
                 below {limit}; bring `lining.walls`, `lining.crown` and `lining.floor` nearer to one another, or try another `size_near`"
            ),
            Self::Poor { cavern, near, scaled_jacobian, limit } => write!(
                f,
                "cavern {cavern:?} in elements of {near} m: one of them has a scaled Jacobian of {scaled_jacobian:.3}, below {limit}; \
                 try another `size_near`, more rock around the cavern, or fewer benches"
            ),
            Self::Gallery { gallery, why } => write!(f, "gallery {gallery:?} {why}"),
            Self::GalleryRows { gallery, near } => write!(
                f,
                "gallery {gallery:?} and the benches, floors and roofs of its two caverns leave no way to lead rows of elements of {near} m \
                 from wall to wall; lower `size_near`, or move the gallery or a cavern with `at`"
            ),
            Self::LowGround { at: [x, y], height, needed } => write!(
                f,
                "the ground at x = {x:.1} m, y = {y:.1} m is at z = {height:.1} m; the caverns' surroundings need \
                 at least {needed:.1} m there; raise `overburden`, or the ground, by {more} m",
                more = at_least(needed - height)
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
