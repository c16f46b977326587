//! Parallel lined caverns in a block of rock, all hexahedra.
//!
//! The section across the caverns is made of quadrilaterals and extruded along y. Each cavern sits in a
//! rectangle of a grid whose lines run through the whole block: inside the opening rows of quadrilaterals
//! with horizontal cuts between the benches, then the lining in layers that follow the profile, then rings
//! of rock that lead over to the rectangle's edge nodes. Where the outline is a closed curve the lining goes all
//! round, and so does a ring of the opening inside it. So opposite sides of the block match node by node.
//!
//! A cavern goes through the whole block, or has a length of its own and ends in rock: the section is the same there, and what
//! is opening, lining or shotcrete along the cavern is rock beyond its ends. So its end walls are plane and bare.
//!
//! x points across the caverns, y along them with y = 0 in the middle of the block, z up with z = 0 at the
//! ground. The first cavern's axis is x = 0.

mod along;
mod build;
mod check;
mod claims;
mod closed;
mod error;
mod extrude;
mod gallery;
mod ground;
mod layout;
mod lines;
mod name;
mod opening;
mod passage;
mod plot;
mod presets;
mod profile;
mod rings;
mod rows;
mod section;
mod shell;
mod smooth;
mod spread;
mod stops;
mod strata;
mod stretch;
#[cfg(test)]
mod tests;
mod trial;
mod tube;
mod wall;

pub use error::{CavernError, Named};
pub use gallery::Gallery;
pub use ground::GroundSurface;
pub use strata::RockLayer;

use crate::mesh::Mesh;
use crate::note::Note;

/// A block of rock with parallel caverns. All lengths in metres.
///
/// The default has no caverns and no lengths; it is there to fill the rest of a description from.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CavernSpec {
    /// From z = 0, the ground where it is level, down to the first cavern's crown, measured to the clear profile
    /// (intrados).
    pub overburden: f64,
    /// Rock below the lowest clear floor.
    pub below: f64,
    /// Rock on either side of the outermost walls, measured from the outside of their linings and shotcrete.
    pub sides: f64,
    /// Length of the block along the caverns.
    pub length: f64,
    /// Element size in the section at the caverns.
    pub near: f64,
    /// Largest element size in the rock of the section.
    pub far: f64,
    /// Element size along the caverns; `near` if none. The number of elements is even, so that y = 0 is a
    /// plane of nodes. Where all caverns end in rock elements grow from the outermost ends on, up to `far` (or this, if
    /// larger); all ends are planes of nodes, and so are the caverns' middles.
    pub along: Option<f64>,
    pub caverns: Vec<Cavern>,
    /// Layers of rock from the ground down; none: all rock is alike. Level planes become lines of the grid between
    /// the caverns' surroundings and the edges of the block where that keeps the growth of elements within 1.3;
    /// elsewhere, and with a dip, each element goes to the layer of its middle.
    pub layers: Vec<RockLayer>,
    pub ground: GroundSurface,
    /// Across, between caverns.
    pub galleries: Vec<Gallery>,
}

/// Outline of a cavern.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CavernShape {
    /// A flat floor, straight walls and a roof that is an arc of a circle.
    #[default]
    Arch,
    /// A flat floor, straight walls and a roof that is half an ellipse.
    Ellipse,
    /// A flat floor, straight walls and a flat roof.
    Rectangle,
    /// A semicircle over walls that bend inwards and an invert. The walls are arcs round the opposite springings
    /// with the width for their radius, the invert one round the crown with the height for its radius: the
    /// standard horseshoe where height and width are equal.
    Horseshoe,
    Circle,
}

impl CavernShape {
    /// Whether the outline is a closed curve, without a flat floor. A lining then goes all round.
    pub fn is_closed(self) -> bool {
        matches!(self, CavernShape::Horseshoe | CavernShape::Circle)
    }
}

/// One cavern. Width, height and rise are those of the clear opening (intrados). All lengths in metres.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cavern {
    /// Prefix of the names of its groups. No dots, stars, question marks, brackets or blanks.
    pub name: String,
    pub shape: CavernShape,
    /// Centre line in x and clear floor (the lowest clear point) in z, both measured from the first cavern's.
    pub at: [f64; 2],
    /// From end wall to end wall, at most that of the block; none: it goes through the block. The end walls are without
    /// lining and shotcrete, whose own ends butt against the rock. At least an element (`along`) of rock lies beyond an end, and ends
    /// of different caverns that are not in one plane are at least a tenth of an element apart.
    pub length: Option<f64>,
    /// y of the middle between the ends; used with `length` alone.
    pub middle: f64,
    pub width: f64,
    /// From floor to crown. Of a circle the same as the width; of a horseshoe from 0.75 to 1.1 of it.
    pub height: f64,
    /// From the springing to the crown, part of the height. Of an arc of a circle at most half the width (a
    /// semicircle), of an ellipse at most the width; not used by the other shapes.
    pub arch_rise: f64,
    /// Number of benches, numbered from the top, cut horizontally. The walls are divided equally among them;
    /// bench 1 has the roof besides, the last bench the invert. A circle's walls and invert are the quarters
    /// beside and below its centre; a horseshoe's walls reach up into its crown by half a right angle.
    pub benches: u32,
    pub lining: Lining,
    pub shotcrete: Shotcrete,
}

/// Thickness of a lining \[m\]. With walls, crown and floor all 0 the cavern is unlined.
///
/// On the walls the thickness is `walls`; over the arch it changes from there to `crown` at the top: the
/// extrados is the arc through the three points. A floor slab spans the full width and carries the walls;
/// without it the walls stand on rock at floor level.
///
/// Round an ellipse the extrados is an ellipse. A rectangle has its full thickness up to the corners, which roof
/// and wall share along their diagonal. Circle and horseshoe are lined all round, so `floor` must be above 0:
/// over the crown, and of a circle over the invert, the thickness changes from `walls` at mid-height with the
/// square of the sine of the angle; over a horseshoe's invert with the square of the distance from its middle.
#[derive(Clone, Debug, Default, PartialEq)]
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

/// Shotcrete between rock and lining, or alone where there is no lining.
///
/// It lies on walls and crown, and round a closed outline also under the invert. Outside of it are, as of the lining, an
/// arc or an ellipse through three points, where it has its thickness measured across; so round an ellipse, and round an arc
/// of which the lining changes its thickness, it is a little thinner or thicker between them. It reaches down beside a floor
/// slab, which lies on rock.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shotcrete {
    /// \[m\], 0 for none.
    pub thickness: f64,
    /// Layers of elements through the thickness.
    pub layers: u32,
}

impl Shotcrete {
    /// No shotcrete at all.
    pub const NONE: Shotcrete = Shotcrete { thickness: 0.0, layers: 0 };

    pub(crate) fn is_none(&self) -> bool {
        self.thickness == 0.0
    }
}

impl CavernSpec {
    /// The mesh: all hexahedra, of scaled Jacobian at least 0.3, in linings and shotcrete at least 0.6.
    ///
    /// Neighbours differ in size, across the face that they share, by at most the factor 1.3 along y everywhere, and
    /// in the section in the rock outside the transitions. These are: linings, shotcrete and what touches them, since their thickness
    /// is given; openings; the rings of rock that lead from a cavern to the grid, out to about one and a half arch rises or
    /// three times `near` (up to 4); the levels of galleries' floors and roofs, where the benches leave no room (up to 2
    /// for caverns and galleries as those of Yingxiuwan, more where levels are a fraction of `near` apart); rock that is
    /// squeezed under a ground that is not level.
    ///
    /// Groups: `rock`, and with layers `rock.NAME` of each that has elements; for each cavern `NAME.lining.crown`,
    /// `NAME.lining.walls`, `NAME.lining.floor` (if there is one) and their union `NAME.lining`; `NAME.bench1` … from the
    /// top down and their union `NAME.excavation`; `NAME.lining1` …, the lining beside each bench, the crown with the
    /// first and the floor with the last; `NAME.shotcrete`, and of it `NAME.shotcrete1` … beside each bench; for each gallery
    /// `NAME.gallery` and `NAME.opening`.
    ///
    /// Face sets: `xmin`, `xmax`, `ymin`, `ymax`, `base`, `top`; `NAME.intrados`, faces of the lining towards
    /// the opening; `NAME.extrados`, faces of the lining towards the rock or the shotcrete (the feet of walls without a
    /// floor slab and the ends of a lining that butt against rock included). Of a cavern with shotcrete alone both are those
    /// of the shotcrete; of one with neither, `NAME.intrados` has the faces of the rock towards the opening, without its ends.
    /// `NAME.ends`, of a cavern that ends in rock: the faces of its end walls.
    ///
    /// Points at y = 0, or in the middle of a cavern with a length, on the intrados: `NAME.crown`, `NAME.floor` (in the middle), `NAME.wall.left` (lower
    /// x) and `NAME.wall.right`, both at half the height.
    ///
    /// # Errors
    /// See [`CavernError`]; each names the key and the remedy.
    pub fn mesh(&self) -> Result<Mesh, CavernError> {
        self.mesh_with_notes().map(|(mesh, _)| mesh)
    }

    /// The mesh, as [`CavernSpec::mesh`], and where it departs from the description.
    ///
    /// # Errors
    /// As [`CavernSpec::mesh`].
    pub fn mesh_with_notes(&self) -> Result<(Mesh, Vec<Note>), CavernError> {
        check::check(self)?;
        let section = build::build(self)?;
        let mesh = extrude::extrude(self, &section)?;
        Ok((mesh, section.notes))
    }
}
