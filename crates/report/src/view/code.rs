//! Numbers as the blocks hold them: whole numbers of few bytes, as differences where neighbours are alike.

/// Where u16 coordinates stand: place = origin + step × number.
#[derive(Clone, Copy)]
pub struct Grid16 {
    pub origin: [f64; 3],
    /// 0 along an axis along which all is flat.
    pub step: [f64; 3],
}

impl Grid16 {
    /// The finest that holds all these points.
    pub fn around<'a>(points: impl Iterator<Item = &'a [f64; 3]>) -> Self {
        let mut ends = [[f64::INFINITY, f64::NEG_INFINITY]; 3];
        for point in points {
            for (end, &x) in ends.iter_mut().zip(point).filter(|(_, x)| x.is_finite()) {
                *end = [end[0].min(x), end[1].max(x)];
            }
        }
        let origin = ends.map(|[low, _]| if low.is_finite() { low } else { 0.0 });
        let step = ends.map(|[low, high]| ((high - low) / f64::from(u16::MAX)).max(0.0));
        Grid16 { origin, step }
    }

    /// Points: all x, then all y, then all z.
    pub fn points(&self, points: &[[f64; 3]]) -> Vec<u8> {
        let along = |axis: usize| {
            points.iter().map(move |point| {
                let number = (point[axis] - self.origin[axis]) / self.step[axis];
                // A flat axis gives NaN, which becomes 0.
                number.round() as u16
            })
        };
        (0..3).flat_map(|axis| deltas16(along(axis))).collect()
    }
}

/// Whole numbers as differences to the one before, of the first to 0, modulo 2¹⁶.
fn deltas16(numbers: impl Iterator<Item = u16>) -> Vec<u8> {
    let mut before = 0u16;
    numbers
        .flat_map(|number| number.wrapping_sub(std::mem::replace(&mut before, number)).to_le_bytes())
        .collect()
}

/// As [`deltas16`], modulo 2³².
pub fn deltas32(numbers: impl Iterator<Item = u32>) -> Vec<u8> {
    let mut before = 0u32;
    numbers
        .flat_map(|number| number.wrapping_sub(std::mem::replace(&mut before, number)).to_le_bytes())
        .collect()
}

/// The largest level of a value.
const LEVELS: f64 = 254.0;
/// Instead of a level: nothing stands there.
const NOTHING: u8 = 255;

/// The levels of `count` values between `low` and `high`; of those that are missing or not finite [`NOTHING`].
pub fn levels(values: &[f32], count: usize, low: f32, high: f32) -> Vec<u8> {
    let (low, high) = (f64::from(low), f64::from(high));
    let level = |value: &f32| match f64::from(*value) {
        value if value.is_finite() => ((value - low) / (high - low) * LEVELS).round() as u8,
        _ => NOTHING,
    };
    let mut levels: Vec<u8> = values.iter().map(level).collect();
    levels.resize(count, NOTHING);
    levels
}

/// Displacements of `count` points in units of `step`: all x, then all y, then all z; 0 where a point is missing.
pub fn displacements(values: &[[f32; 3]], count: usize, step: f64) -> Vec<u8> {
    let units = |axis: usize| {
        (0..count)
            .map(move |k| values.get(k).map_or(0, |u| (f64::from(u[axis]) / step).round() as i16 as u16))
    };
    (0..3).flat_map(|axis| deltas16(units(axis))).collect()
}

/// One bit a cell, the lowest first.
pub fn bits(inside: &[bool], count: usize) -> Vec<u8> {
    let mut bytes = vec![0; count.div_ceil(8)];
    for (k, _) in inside.iter().enumerate().filter(|(_, inside)| **inside) {
        bytes[k / 8] |= 1 << (k % 8);
    }
    bytes
}
