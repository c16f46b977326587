//! Stages of a model's history.

/// A stage of a model's history, in their order.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Stage {
    /// Before the earthquake, counted from 0: time stands still.
    Before(u16),
    /// The earthquake.
    Shaking,
}
