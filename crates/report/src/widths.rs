//! What is to be said beside widths of cracks.

use crate::language::{Language, say};

/// That they go by the mesh.
pub fn width_by_mesh(language: Language) -> String {
    say!(
        language,
        "How many cracks share an even stretch, and so how wide each is, goes by the mesh: a plain column parted in 2 cracks of 3.6 mm \
         with elements of 1 m, and in 16 of up to 0.9 mm with elements of 0.06 m. What the cracks take together does not."
    )
}
