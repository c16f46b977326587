//! The quantities that results hold: names, units and meaning in one list, and with them how each follows from what is seen.

mod bolts;
mod fields;
mod interface;
mod measures;
mod monitored;

pub use bolts::BOLT_LINES;
pub use fields::{CELLS, Field, field_name, of_element};
pub use interface::INTERFACE;
pub use measures::{MEASURES, Measure, SHARE_OF_VOLUME, YIELDED, threshold};
pub use monitored::{BOLT, MONITOR, MonitorSeen, Moved, OfMonitor, PAIR, RELATIVE, WET, over_yield};

use tremolite_laws::Row;

/// A quantity in words, and its value as a function of what is seen, where the list is that of a table's numbers.
#[derive(Clone, Copy, Debug)]
pub struct Quantity<V = ()> {
    pub name: &'static str,
    pub unit: &'static str,
    pub doc: &'static str,
    pub value: V,
}

/// How a quantity follows from what is seen.
pub type Of<S> = fn(&S) -> f64;

/// One in words alone.
const fn q(name: &'static str, unit: &'static str, doc: &'static str) -> Quantity {
    Quantity { name, unit, doc, value: () }
}

/// One that follows from what is seen.
const fn seen<S>(name: &'static str, unit: &'static str, value: Of<S>, doc: &'static str) -> Quantity<Of<S>> {
    Quantity { name, unit, doc, value }
}

/// Length of a row.
pub fn length(row: &Row) -> f64 {
    let [x, y, z] = row.xyz();
    (x * x + y * y + z * z).sqrt()
}

#[cfg(test)]
mod tests;
