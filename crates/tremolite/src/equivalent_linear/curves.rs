//! How soil softens and damps as it is sheared: modulus over that of small strains, and damping ratio, by shear strain.

use super::darendeli::Darendeli;
use super::table::CurveTable;
use super::vucetic_dobry;

/// A soil's curves.
#[derive(Clone, Debug, PartialEq)]
pub enum Curves {
    /// Stays as it is: its damping ratio.
    Linear(f64),
    Darendeli(Darendeli),
    Table(CurveTable),
}

impl Curves {
    /// Those of Vucetic and Dobry (1991) for a plasticity index \[%\] from 0 to 200; nothing beyond.
    pub fn vucetic_dobry(plasticity_index: f64) -> Option<Curves> {
        vucetic_dobry::table(plasticity_index).map(Curves::Table)
    }

    /// G/G_max and damping ratio at a shear strain (0.01 is a hundredth).
    pub fn at(&self, strain: f64) -> [f64; 2] {
        match self {
            Curves::Linear(damping) => [1.0, *damping],
            Curves::Darendeli(darendeli) => darendeli.at(strain),
            Curves::Table(table) => table.at(strain),
        }
    }
}
