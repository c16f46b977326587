//! Steady seepage of a stage, as results tell of it.

use tremolite_results::StageSeepage;

/// What flows from a stage on, until the next that has a flow of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct StageFlow {
    /// Walls, drains and heads by name, in their order, with what leaves the ground there \[m³/s\]: negative where water comes in.
    pub places: Vec<(String, f64)>,
    /// Places from here on are heads.
    pub heads: usize,
    /// All that comes into the ground \[m³/s\].
    pub inflow: f64,
    /// What comes in less what leaves, over what comes in.
    pub mass_error: f64,
    /// Share of the conductivity that is left in dry ground.
    pub left: f64,
    /// Iterations for the free surface, and of conjugate gradients in all of them.
    pub iterations: usize,
    pub linear_iterations: usize,
    /// Wall time \[s\].
    pub seconds: f64,
    /// Specific discharge \[m/s\] in each element of the problem's mesh; zero where nothing flows.
    pub velocities: Vec<[f64; 3]>,
}

impl StageFlow {
    /// As `summary.json` has it.
    pub fn summary(&self) -> StageSeepage {
        let (taken, comes) = self.places.split_at(self.heads);
        StageSeepage {
            taken: taken.iter().cloned().collect(),
            comes: comes.iter().map(|(name, out)| (name.clone(), 0.0 - out)).collect(),
            inflow: self.inflow,
            mass_error: self.mass_error,
            iterations: self.iterations,
        }
    }

    /// Walls and drains with what they take \[m³/s\].
    pub fn taken(&self) -> &[(String, f64)] {
        &self.places[..self.heads]
    }
}
