//! What is seen of the stages before the shaking.

mod beginning;
mod beside;
mod grids;
mod relaxation;
mod rows;

pub use beginning::{Beginning, Begins, uneven};
pub use beside::{Beside, BesidePlanes};
pub use grids::StageGrids;
pub use relaxation::Relaxation;
pub use rows::{StageRows, summaries};
