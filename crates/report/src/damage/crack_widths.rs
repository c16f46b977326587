//! What is to be said beside widths of cracks.

use crate::language::{Language, say};

/// That they go by the mesh.
pub fn width_by_mesh(language: Language) -> String {
    say!(
        language,
        "The number of cracks that share a uniform strain, and so the width of each, depends on the mesh: smaller elements make more and narrower cracks. Their total opening does not depend on it."
    )
}
