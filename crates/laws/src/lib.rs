//! Pointwise physics: material laws and element shapes over lanes. No allocation in hot paths, no threads, no I/O.

pub mod band;
pub mod interface;
pub mod interface_path;
pub mod interfaces;
pub mod lane;
pub mod material;
pub mod materials;
pub mod parameter;
pub mod path;
pub mod shapes;
pub mod sym3;

pub use interface::{Interface, PairState};
pub use lane::{Isa, Lane, Octet, Row};
pub use material::{
    Facts, History, InPlace, Material, Moduli, Point, Softens, Sym, complementary_energy, virgin,
};
pub use parameter::{
    BadParameter, Choice, Column, Dimension, Kind, LawInfo, Need, Parameter, Role, Value, Values,
};
