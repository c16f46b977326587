//! What interfaces.csv holds of an interface.

use super::{Of, Quantity, seen};
use tremolite_engine::contacts::ContactTotals;

/// Columns of an interface in interfaces.csv, in this order.
pub const INTERFACE: &[Quantity<Of<ContactTotals>>] = &[
    seen("sliding", "m2", |all| all.sliding, "area that slides, by more than 1 nm (as all areas here)"),
    seen("open", "m2", |all| all.open, "area that is open"),
    seen("ever_slid", "m2", |all| all.ever_slid, "area that has slid in any step so far"),
    seen("ever_opened", "m2", |all| all.ever_opened, "area that has opened in any step so far"),
    seen(
        "max_gap",
        "m",
        |all| all.largest_gap,
        "largest gap of any pair whose bond is broken, of all steps so far",
    ),
    seen(
        "max_slip",
        "m",
        |all| all.largest_slip,
        "largest slip of any closed pair whose bond is broken, of all steps so far",
    ),
    seen(
        "impact_gain",
        "J",
        |all| all.impact_gain,
        "energy that the time step found (lost, if negative) at impacts so far; in the balance's error",
    ),
];
