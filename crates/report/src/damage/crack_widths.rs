//! What is to be said beside widths of cracks.

use crate::language::{Language, say};

/// That they go by the mesh.
pub fn width_by_mesh(language: Language) -> String {
    say!(
        language,
        "How many cracks share an even stretch, and so how wide each is, goes by the mesh: smaller elements make more of them, each less \
         wide. What the cracks take together does not go by it."
    )
}
