//! Colours of a map by value, and the bar that says which is which.

use crate::drawing::svg::{Anchor, Style, Svg};
use crate::drawing::ticks::Ticks;

/// Steps that a map distinguishes.
pub const LEVELS: usize = 24;

/// The colour map magma (N. Smith and S. van der Walt, matplotlib, CC0), from light to dark and without its black
/// end: evenly graded for the eye, also in grey and for the colour-blind.
const COLOURS: [[f64; 3]; 9] = [
    [252.0, 253.0, 191.0],
    [254.0, 207.0, 146.0],
    [254.0, 159.0, 109.0],
    [247.0, 112.0, 92.0],
    [222.0, 73.0, 104.0],
    [183.0, 55.0, 121.0],
    [140.0, 41.0, 129.0],
    [100.0, 26.0, 128.0],
    [59.0, 15.0, 112.0],
];

/// The level of a value between two ends.
pub fn level(value: f64, (low, high): (f64, f64)) -> usize {
    (((value - low) / (high - low) * LEVELS as f64).max(0.0) as usize).min(LEVELS - 1)
}

/// The colour of a level, as `#rrggbb`.
pub fn colour(level: usize) -> String {
    let s = (level as f64 + 0.5) / LEVELS as f64;
    let at = s.clamp(0.0, 1.0) * (COLOURS.len() - 1) as f64;
    let i = (at as usize).min(COLOURS.len() - 2);
    let mix =
        |k: usize| (COLOURS[i][k] + (at - i as f64) * (COLOURS[i + 1][k] - COLOURS[i][k])).round() as u8;
    format!("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2))
}

/// A bar from `low` below to `high` above, in the display unit, with its upper left corner at a point; `turned`
/// with the dark end below.
pub fn bar(svg: &mut Svg, (left, top): (f64, f64), height: f64, (low, high): (f64, f64), turned: bool) {
    let step = height / LEVELS as f64;
    for level in 0..LEVELS {
        let top = top + height - (level + 1) as f64 * step;
        let corners = vec![(left, top), (left + 16.0, top), (left + 16.0, top + step), (left, top + step)];
        svg.areas(&colour(if turned { LEVELS - 1 - level } else { level }), &[corners]);
    }
    let ticks = Ticks::within(low, high, (height / 50.0) as usize);
    for (value, label) in &ticks.marks {
        let y = top + height * (1.0 - ticks.fraction(*value));
        svg.rule((left + 16.0, y), (left + 21.0, y), true);
        svg.text((left + 25.0, y + 4.0), Anchor::Start, 12.0, Style::Muted, label);
    }
}
