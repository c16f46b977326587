//! What is seen at monitors, and what monitors.csv and stages.csv hold of it.

use super::{Of, Quantity, seen};
use tremolite_engine::bolts::SegmentSeen;
use tremolite_kernels::contact::PairSeen;

/// What is seen of a monitor at one time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MonitorSeen {
    pub moved: Moved,
    /// xx, yy, zz, xy, yz, zx \[Pa\], tension positive.
    pub stress: [f64; 6],
    /// Its principal values \[Pa\], the largest first.
    pub principal: [f64; 3],
    /// Pressure in the pores \[Pa\].
    pub pore: f64,
}

/// What of it is known in every step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moved {
    /// Displacement \[m\].
    pub u: [f64; 3],
    /// Velocity \[m/s\].
    pub v: [f64; 3],
    /// Acceleration \[m/s²\].
    pub a: [f64; 3],
    /// Largest principal value of σ₀ + C:Δε \[Pa\].
    pub s1_elastic: f64,
}

/// How a quantity of a monitor follows.
#[derive(Clone, Copy, Debug)]
pub enum OfMonitor {
    /// From its motion: extremes of all steps are followed too.
    Moved(Of<Moved>),
    /// From all that is seen in a row.
    Seen(Of<MonitorSeen>),
}

impl OfMonitor {
    pub fn at(self, seen: &MonitorSeen) -> f64 {
        match self {
            OfMonitor::Moved(value) => value(&seen.moved),
            OfMonitor::Seen(value) => value(seen),
        }
    }
}

const fn moved(
    name: &'static str,
    unit: &'static str,
    value: Of<Moved>,
    doc: &'static str,
) -> Quantity<OfMonitor> {
    Quantity { name, unit, doc, value: OfMonitor::Moved(value) }
}

const fn of_all(
    name: &'static str,
    unit: &'static str,
    value: Of<MonitorSeen>,
    doc: &'static str,
) -> Quantity<OfMonitor> {
    Quantity { name, unit, doc, value: OfMonitor::Seen(value) }
}

/// Columns of a monitor behind those of [`MONITOR`], where there is water in the ground.
pub const WET: &[Quantity<OfMonitor>] = &[
    of_all("p", "Pa", |m| m.pore, "pressure of the water in the pores of its element; 0 of what has none"),
    of_all(
        "s1_eff",
        "Pa",
        |m| m.principal[0] + m.pore,
        "largest effective principal stress, s1 + p: what strength goes by",
    ),
    of_all("s2_eff", "Pa", |m| m.principal[1] + m.pore, "middle effective principal stress"),
    of_all("s3_eff", "Pa", |m| m.principal[2] + m.pore, "smallest effective principal stress"),
];

/// Columns of a monitor, in this order.
pub const MONITOR: &[Quantity<OfMonitor>] = &[
    moved(
        "ux",
        "m",
        |m| m.u[0],
        "displacement along x since the start of shaking, interpolated in the element",
    ),
    moved("uy", "m", |m| m.u[1], "displacement along y"),
    moved("uz", "m", |m| m.u[2], "displacement along z"),
    moved("vx", "m/s", |m| m.v[0], "velocity along x"),
    moved("vy", "m/s", |m| m.v[1], "velocity along y"),
    moved("vz", "m/s", |m| m.v[2], "velocity along z"),
    moved(
        "ax",
        "m/s2",
        |m| m.a[0],
        "acceleration along x: velocity of this row less that of the last, over the time between them, so valid half a row \
         earlier; 0 in the first row. Such a mean passes little above the rows' Nyquist frequency; peaks of single steps are \
         in summary.json (step_max, step_min)",
    ),
    moved("ay", "m/s2", |m| m.a[1], "acceleration along y"),
    moved("az", "m/s2", |m| m.a[2], "acceleration along z"),
    of_all(
        "sxx",
        "Pa",
        |m| m.stress[0],
        "normal stress along x, tension positive: of the element (one-point), or extrapolated from its points; \
         of the nearest of them once one has cracked or yielded",
    ),
    of_all("syy", "Pa", |m| m.stress[1], "normal stress along y"),
    of_all("szz", "Pa", |m| m.stress[2], "normal stress along z"),
    of_all("sxy", "Pa", |m| m.stress[3], "shear stress xy"),
    of_all("syz", "Pa", |m| m.stress[4], "shear stress yz"),
    of_all("szx", "Pa", |m| m.stress[5], "shear stress zx"),
    of_all("s1", "Pa", |m| m.principal[0], "largest principal stress, tension positive"),
    of_all("s2", "Pa", |m| m.principal[1], "middle principal stress"),
    of_all("s3", "Pa", |m| m.principal[2], "smallest principal stress"),
    moved(
        "s1_elastic",
        "Pa",
        |m| m.s1_elastic,
        "largest principal value of σ₀ + C:Δε at the monitor: the stress when the shaking begins and what the strain since then \
         would add if nothing cracked or yielded. Without what the Maxwell bodies of damping over a band add to a fast change, by \
         which s1 may lie above it. At the end of a stage s1 itself",
    ),
];

/// Columns of a pair of monitors: of the displacement \[m\] of the first less that of the second.
pub const RELATIVE: &[Quantity<Of<[f64; 3]>>] = &[
    seen("ux", "m", |d| d[0], "displacement of the first monitor less that of the second, along x"),
    seen("uy", "m", |d| d[1], "the same along y"),
    seen("uz", "m", |d| d[2], "the same along z"),
    seen("u", "m", |d| (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt(), "its length"),
];

/// Columns of a monitor on an interface, in this order.
pub const PAIR: &[Quantity<Of<PairSeen>>] = &[
    seen(
        "gap",
        "m",
        |pair| pair.gap,
        "opening of the pair nearest to the point, negative where it is closed under pressure",
    ),
    seen(
        "slip1",
        "m",
        |pair| pair.slip[0],
        "displacement of the second side against the first along e1, horizontal (x on a level interface)",
    ),
    seen("slip2", "m", |pair| pair.slip[1], "the same along e2 = m × e1, m out of the first side"),
    seen(
        "pressure",
        "Pa",
        |pair| pair.pressure,
        "between the two sides, compression positive, without contact damping",
    ),
    seen("shear1", "Pa", |pair| -pair.shear[0], "shear along the slip that caused it, e1"),
    seen("shear2", "Pa", |pair| -pair.shear[1], "the same along e2"),
    seen(
        "state",
        "1",
        |pair| f64::from(pair.state),
        "0 bonded, 1 stuck (bond broken, closed), 2 sliding, 3 open",
    ),
];

/// Columns of a monitor on a bolt, in this order.
pub const BOLT: &[Quantity<Of<SegmentSeen>>] = &[
    seen("force", "N", |s| s.force, "of the bolt's segment nearest to the point, tension positive"),
    seen(
        "force_over_yield",
        "1",
        |s| over_yield(s.force, s),
        "its size over the force at which the segment yields; 0 where it never does",
    ),
    seen(
        "slip",
        "m",
        |s| s.slip,
        "of the bond beside it, bar less ground along the bolt, from its head on; 0 without a bond",
    ),
    seen(
        "state",
        "1",
        |s| f64::from(s.state as u8),
        "0 elastic, 1 its bond slides or has slid, 2 it has yielded, 3 broken, 4 cut off by an excavation",
    ),
];

/// Size of a force \[N\] over that at which a segment yields; 0 where it never does.
pub fn over_yield(force: f64, seen: &SegmentSeen) -> f64 {
    if seen.yields_at.is_finite() && seen.yields_at > 0.0 { force.abs() / seen.yields_at } else { 0.0 }
}
