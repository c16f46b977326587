//! What the files of bolts hold.

use super::{Quantity, q};

/// Arrays of bolts/*.vtu, a line for each segment.
pub const BOLT_LINES: [Quantity; 12] = [
    q("displacement", "m", "of the ends of segments, in the ground they lie in"),
    q("from_head", "m", "distance of the ends from the head along the bolt"),
    q("group", "", "which group of bolts, from 0; group:NAME marks each"),
    q("bolt", "", "its number in the group, from 1"),
    q("force", "N", "tension positive"),
    q("force_over_yield", "", "as in monitors.csv"),
    q("slip", "m", "of the bond beside it"),
    q("plastic_strain", "", "of the bar"),
    q("state", "", "as in monitors.csv"),
    q(
        "force_max",
        "N",
        "force of largest size in any step since the stage, or the earthquake, began, tension positive",
    ),
    q("force_over_yield_max", "", "the same over what it yields at"),
    q("slip_max", "m", "largest size of the slip in any step since it was placed"),
];
