//! Straight galleries across, from one cavern to the next: what they are, and the checks on a single one.

use super::error::{Named, value};
use super::{CavernError, CavernSpec, name};

const MOST: usize = 1000;

/// Of an element's size: nothing that a gallery asks for may be smaller.
pub(super) const LEAST: f64 = 0.1;

/// A rectangular gallery across, between two neighbouring caverns with straight walls, such as a bus-bar gallery.
/// All lengths in metres.
///
/// The rock in it is the group `NAME.gallery`, the elements of linings and shotcrete that it passes the group
/// `NAME.opening`; they leave `rock`, the linings' groups and those of shotcrete. Faces of what remains towards them are the face set `NAME.surface`. It is
/// not lined.
///
/// Floor and roof are lines of the grid from wall to wall, so a cavern that a gallery meets has rows of elements that are
/// as high as the levels of galleries and of cuts between benches allow. A cut within a quarter of `near` of a floor or
/// roof moves there, and a [`Note`](crate::note::Note) says so. Floor and roof must lie on the straight walls of both
/// caverns, and its width between the ends of both: the floor on the foot or at least a tenth of `near` above it, the roof as much below the springing.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Gallery {
    /// Prefix of the names of its groups, as a cavern's.
    pub name: String,
    /// Names of the two caverns.
    pub between: [String; 2],
    /// Its middle in y, and its floor in z above the first cavern's clear floor.
    pub at: [f64; 2],
    /// Along y.
    pub width: f64,
    /// Along z.
    pub height: f64,
}

impl Gallery {
    pub(super) fn walls(&self) -> [f64; 2] {
        [self.at[0] - 0.5 * self.width, self.at[0] + 0.5 * self.width]
    }
}

pub(super) fn check(spec: &CavernSpec) -> Result<(), CavernError> {
    if spec.galleries.len() > MOST {
        return Err(value("galleries", spec.galleries.len() as f64, format!("at most {MOST} galleries")));
    }
    for (k, gallery) in spec.galleries.iter().enumerate() {
        let taken = spec.galleries[..k].iter().any(|other| other.name == gallery.name)
            || spec.caverns.iter().any(|cavern| cavern.name == gallery.name);
        name::check(Named::Gallery, &gallery.name, taken)?;
        let key = |key: &str| format!("{}.{key}", gallery.name);
        for (name, length) in [("width", gallery.width), ("height", gallery.height)] {
            if !(length > 0.0 && length <= 1e5) {
                return Err(value(key(name), length, "a length above 0 (and at most 1e5 m)"));
            }
        }
        let least = LEAST * spec.near.min(spec.along.unwrap_or(spec.near));
        for (name, length) in [("width", gallery.width), ("height", gallery.height)] {
            if length < least {
                let must = format!("at least {least:.3} m, a tenth of an element, or `size_near` lower");
                return Err(value(key(name), length, must));
            }
        }
        if !(-1e6..=1e6).contains(&gallery.at[1]) {
            return Err(value(key("at"), gallery.at[1], "a length (and at most 1e6 m)"));
        }
        let [from, to] = gallery.walls();
        if !(from > -0.5 * spec.length && to < 0.5 * spec.length) {
            let must = format!("such that the gallery lies within the block, {} m long", spec.length);
            return Err(value(key("at"), gallery.at[0], must));
        }
    }
    Ok(())
}
