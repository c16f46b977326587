//! The engine: a problem in space, made into parts and masses, and the step that moves it.
//!
//! [`Problem`] → [`Model`] (checked, immutable) → [`Assembly`] (every part it will ever have) → [`Phase`] (what of it is
//! active in a stage) + [`State`] (all that evolves) → [`Engine`] (the step). It knows nothing of case files, of results
//! and of who observes.

mod assemble;
pub mod assembly;
pub mod bench;
pub mod body;
pub mod bolting;
pub mod bolts;
pub mod boundary;
pub mod bytes;
pub mod column;
pub mod contacts;
pub mod courses;
pub mod division;
pub mod engine;
pub mod error;
pub mod exchange;
pub mod extent;
pub mod free_field;
pub mod give;
pub mod hexahedra;
pub mod interface;
mod level_finding;
mod levels;
pub mod life;
pub mod member;
pub mod model;
pub mod node_table;
pub mod outer_faces;
mod pair_masses;
pub mod parts;
mod patch_part;
pub mod phase;
mod pore_forces;
pub mod prescribed;
pub mod problem;
pub mod ranks;
pub mod rims;
mod seams;
pub mod sheet;
mod slabs;
mod soon;
pub mod state;
mod sums;
mod thickness;
mod thin;
pub mod ties;
pub mod traction;
pub mod water;

pub use assembly::Assembly;
pub use body::Body;
pub use bolts::{Bar, Bolts, Bond};
pub use boundary::bed::{Bed, Footing};
pub use boundary::{Base, Side, Top};
pub use bytes::Bytes;
pub use division::Division;
pub use engine::{ContactLimit, Engine, Found, Halt, Limit, Snapshot, StableStep, stable_step};
pub use error::ModelError;
pub use exchange::{Alone, Exchange, Loopback};
pub use free_field::Incident;
pub use interface::{Interface, Seam};
pub use level_finding::{find_levels, finer_levels, settle_levels, sure_step};
pub use levels::Levels;
pub use life::{Life, Stage};
pub use member::{Kind, Member};
pub use model::Model;
pub use node_table::{Domain, Nodes};
pub use patch_part::law_axes;
pub use phase::Phase;
pub use prescribed::Prescribed;
pub use problem::{MOST_LEVELS, Problem, Rayleigh, TimeStep};
pub use ranks::Ranks;
pub use state::State;
pub use traction::Traction;
pub use tremolite_kernels::{
    AnyInterface, AnyMaterial, Booked, InterfaceLaw, Law, Layers, Line, Lines, Points, Quadrature, elastic,
    interface_laws, laws,
};
pub use water::Water;
