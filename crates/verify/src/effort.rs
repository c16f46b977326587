//! How much time verification may take.

/// How much time a run may take, in three steps. Seconds are those of two cores with nothing else to do.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum Effort {
    /// What `cargo test` runs: at most 2 s a problem in the dev profile.
    Test,
    /// What `tremolite verify` runs: at most six minutes for all problems in the release profile.
    #[default]
    Verify,
    /// Finer meshes, series of parameters and long runs, minutes a problem.
    Full,
}
