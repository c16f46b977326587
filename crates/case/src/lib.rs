//! The case file: one page of TOML that says all about a study, read into a checked [`Case`] in SI.
//!
//! Each part of the case has one file here: its table of keys, the type it is read into, and the reading. The
//! tables are the one source of what may be written: they drive the checks, the defaults, the suggestions and the
//! JSON [`schema`]. All problems of a file are reported at once, each at its place ([`Report`]).
//!
//! A case can be changed by the paths of its keys before it is checked ([`Change`]); its text is changed, so that it stays a
//! case file.
//!
//! The crate knows no meshes and no records: whether a group or a point exists, or a step of processing can be
//! read, is found by the builder of the model, which reports it at the same place through [`Case::report`].
//!
//! A law can also stand in a file of its own ([`LawFile`]), and so can a mesh ([`MeshAlone`]), under the same keys.

#![forbid(unsafe_code)]

pub mod pattern;
pub mod units;

mod bolts;
mod case;
mod change;
mod check;
mod consistency;
mod defaulted;
mod dynamic;
mod fields;
mod initial;
mod inline;
mod interface;
mod key_path;
mod keyed;
mod keys;
mod law_file;
mod law_key;
mod law_table;
mod laws;
mod limits_file;
mod listing;
mod material;
mod mesh;
mod mesh_alone;
mod monitor;
mod motion;
mod output;
mod page;
mod reference;
mod region;
mod reinforcement;
mod renamed;
mod report;
mod schema;
mod seams;
mod section;
mod seepage;
mod spanned;
mod stage;
pub mod study;
mod suggest;
mod syntax;
mod value;
mod water;
mod wet;

pub use bolts::{BoltBond, BoltPattern, BoltPlace, BoltedFaces, Bolts, Plate};
pub use case::Case;
pub use change::Change;
pub use defaulted::Defaulted;
pub use dynamic::{BandDamping, Base, BaseKind, Dynamic, Rayleigh, Side, Top};
pub use initial::{BaseHold, Initial, InitialStress, MeasuredStress, SideHold, StressField};
pub use interface::{Contact, Interface};
pub use law_file::{LawFile, LawKind};
pub use laws::Laws;
pub use listing::{Listed, ListedValue, bolt_keys, interface_keys, mesh_tables};
pub use material::Material;
pub use mesh::{
    Axis, Cavern, CavernShape, Caverns, CutPlane, Gallery, Ground, GroundSurface, GroupPlace, HoleLining,
    Length, Lining, Mesh, MeshBox, MeshFile, MeshPart, PlacedGroup, PlaneAt, RockLayer, Seam, Shotcrete,
    Stand,
};
pub use mesh_alone::MeshAlone;
pub use monitor::{Monitor, Place, Relative};
pub use motion::{
    Component, Corner, Direction, Motion, MotionKind, Record, RecordUnit, Records, Site, SiteLayer,
    Softening, SurfacePart, Target, TargetSpectrum, TextColumn, Wave, WaveComponent, WaveWord, Window,
};
pub use output::Output;
pub use page::{Language, Limits, Page};
pub use reference::reference;
pub use region::{Element, Fill, Region};
pub use reinforcement::{BarDirection, BarFace, Reinforcement};
pub use report::{Diagnostic, Report, Severity};
pub use schema::schema;
pub use section::{Section, SectionCode};
pub use seepage::{Drain, Pressure};
pub use spanned::Spanned;
pub use stage::{Displacement, Moved, Stage};
pub use suggest::nearest;
pub use value::{NO_FORMULA, begins_a_formula};
pub use water::{Earthquake, LateralOf, MaterialWater, Pores, StageWater, Water};
