//! Strength of a rectangular section under thrust and moment, and in shear: what codes of concrete structures say, as functions of
//! numbers. It knows no meshes, no cases, no time.
//!
//! A section is a metre wide and `thickness` deep. Depths are measured from its mid-surface, positive towards the intrados. Thrust N
//! \[N/m\] is positive in tension, moment M \[N m/m\] with tension at the intrados, as in `sections.csv`.
//!
//! - [`Concrete`]: parabola and rectangle (EN 1992-1-1 3.1.7, GB 50010 6.2.1), without tension; [`Layer`]s of steel, elastic and plastic.
//! - [`Section`]: forces of plane strains, in closed form; [`Diagram`]: all N and M that its limits of strain allow.
//! - [`Plain`]: concrete without steel, by its own rule (EN 1992-1-1 12.6.1).
//! - [`Shear`]: EN 1992-1-1 6.2.2 and 12.6.3, GB 50010 6.3.3.
//! - [`CrackRule`]: the width of cracks under lasting forces, EN 1992-1-1 7.3.4.
//! - [`Grade`]: characteristic strengths by grade.
//! - [`Rule`]: all of it by a code with its factors, and [`Capacity`], what a section bears by it.
//!
//! **Utilisation** is that of proportional loading: the factor by which the strength on the ray from the origin through (N, M) is
//! exceeded, 1 on the border, N and M growing together. A state within has less than 1. It is the usual measure where both grow with
//! the load; where thrust stays while moment grows, the utilisation by moment at that thrust differs, and only their sides of 1 agree.

#![forbid(unsafe_code)]

mod capacity;
mod code;
mod concrete;
mod crack;
mod diagram;
mod grade;
mod plain;
mod section;
mod shear;

pub use capacity::{Capacity, Rule};
pub use code::Code;
pub use concrete::Concrete;
pub use crack::{Crack, CrackRule};
pub use diagram::Diagram;
pub use grade::Grade;
pub use plain::Plain;
pub use section::{Layer, Section};
pub use shear::Shear;
