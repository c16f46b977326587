//! What a file leaves unsaid.

/// A key that was left out.
#[derive(Clone, Debug, PartialEq)]
pub struct Defaulted {
    /// Its path: `mesh.caverns.cavern[powerhouse].benches`.
    pub key: String,
    /// What is used, as it would be written, or what happens instead.
    pub value: String,
}
