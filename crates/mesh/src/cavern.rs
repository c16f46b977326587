//! Parallel lined caverns in a block of rock, all hexahedra.
//!
//! The section across the caverns is made of quadrilaterals and extruded along y. Each cavern sits in a
//! rectangle of a grid whose lines run through the whole block: inside the opening rows of quadrilaterals
//! with horizontal cuts between the benches, then the lining in layers that follow the profile, then rings
//! of rock that lead over to the rectangle's edge nodes. So opposite sides of the block match node by node.
//!
//! x points across the caverns, y along them with y = 0 in the middle of the block, z up with z = 0 at the
//! ground. The first cavern's axis is x = 0.

mod error;
mod extrude;
mod layout;
mod opening;
mod presets;
mod profile;
mod rows;
mod section;
mod smooth;
#[cfg(test)]
mod tests;

pub use error::CavernError;

use crate::mesh::Mesh;

/// A block of rock with parallel caverns. All lengths in metres.
#[derive(Clone, Debug, PartialEq)]
pub struct CavernSpec {
    /// From the ground down to the first cavern's crown, measured to the clear profile (intrados).
    pub overburden: f64,
    /// Rock below the lowest clear floor.
    pub below: f64,
    /// Rock on either side of the outermost walls, measured from the outside of their linings.
    pub sides: f64,
    /// Length of the block along the caverns.
    pub length: f64,
    /// Element size in the section at the caverns.
    pub near: f64,
    /// Largest element size in the rock of the section.
    pub far: f64,
    /// Element size along the caverns; `near` if none. The number of elements is even, so that y = 0 is a
    /// plane of nodes.
    pub along: Option<f64>,
    pub caverns: Vec<Cavern>,
}

/// One cavern: a flat floor, straight walls and a roof that is an arc of a circle. Width, height and rise
/// are those of the clear opening (intrados). All lengths in metres.
#[derive(Clone, Debug, PartialEq)]
pub struct Cavern {
    /// Prefix of the names of its groups. No dots, stars, question marks, brackets or blanks.
    pub name: String,
    /// Centre line in x and clear floor in z, both measured from the first cavern's.
    pub at: [f64; 2],
    pub width: f64,
    /// From floor to crown.
    pub height: f64,
    /// From the springing to the crown, part of the height; at most half the width (a semicircle).
    pub arch_rise: f64,
    /// Number of benches, numbered from the top. The straight walls are divided equally among them, and
    /// bench 1 has the arch besides.
    pub benches: u32,
    pub lining: Lining,
}

/// Thickness of a lining \[m\]. With walls, crown and floor all 0 the cavern is unlined.
///
/// On the walls the thickness is `walls`; over the arch it changes from there to `crown` at the top: the
/// extrados is the arc through the three points. A floor slab spans the full width and carries the walls;
/// without it the walls stand on rock at floor level.
#[derive(Clone, Debug, PartialEq)]
pub struct Lining {
    pub walls: f64,
    pub crown: f64,
    /// 0 for none.
    pub floor: f64,
    /// Layers of elements through the thickness.
    pub layers: u32,
}

impl Lining {
    /// No lining at all.
    pub const NONE: Lining = Lining { walls: 0.0, crown: 0.0, floor: 0.0, layers: 0 };

    pub(crate) fn is_none(&self) -> bool {
        self.walls == 0.0 && self.crown == 0.0 && self.floor == 0.0
    }
}

impl CavernSpec {
    /// The mesh.
    ///
    /// Groups: `rock`; for each cavern `NAME.lining.crown`, `NAME.lining.walls`, `NAME.lining.floor` (if
    /// there is one) and their union `NAME.lining`; `NAME.bench1` … from the top down and their union
    /// `NAME.excavation`.
    ///
    /// Face sets: `xmin`, `xmax`, `ymin`, `ymax`, `base`, `top`; `NAME.intrados`, faces of the lining towards
    /// the opening; `NAME.extrados`, faces of the lining towards the rock (the feet of walls without a floor
    /// slab included). Of an unlined cavern `NAME.intrados` has the faces of the rock towards the opening.
    ///
    /// Points at y = 0, on the intrados: `NAME.crown`, `NAME.floor` (in the middle), `NAME.wall.left` (lower
    /// x) and `NAME.wall.right`, both at half the height.
    ///
    /// # Errors
    /// See [`CavernError`]; each names the key and the remedy.
    pub fn mesh(&self) -> Result<Mesh, CavernError> {
        error::check(self)?;
        let section = section::build(self)?;
        extrude::extrude(self, &section)
    }
}
