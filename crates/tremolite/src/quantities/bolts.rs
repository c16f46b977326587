//! What bolts.csv and the files of bolts hold.

use super::{Quantity, q};

/// Columns of bolts.csv behind `bolt` and `name`, a row for each bolt of a group and time.
pub const BOLTS: [Quantity; 11] = [
    q("time", "s", "in the earthquake, when field files are written; NaN at the end of a stage"),
    q("max_force", "N", "force of largest size along the bolt, tension positive"),
    q(
        "force_over_yield",
        "1",
        "size of the force over what its segment yields at, at most along the bolt; 0 where it never does",
    ),
    q("max_slip", "m", "largest size of the slip along the bolt in any step since it was placed"),
    q(
        "state",
        "",
        "elastic, slid, yielded or broken: the worst of what is left of the bolt; cut-off where an excavation left nothing",
    ),
    q("stage", "", "the stage at whose end it is so, or earthquake"),
    q("x", "m", "where max_force is: the middle of its segment"),
    q("y", "m", "the same along y"),
    q("z", "m", "the same along z"),
    q(
        "largest_force",
        "N",
        "largest size of the force along the bolt in any step since the stage, or the earthquake, began",
    ),
    q("cut_off", "m", "length of the bolt that excavations have taken; it counts in no other column"),
];

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
