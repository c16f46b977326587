//! Driving an interface law along a path of gap, or pressure, and slip. Scalar lanes on plain arrays, as in [`crate::path`].
//!
//! **Prescribed pressure.** The gap that gives it, with the history of the row before, is sought for each row to round-off.
//! A pair that is open carries nothing, so that no gap gives it a tension: that is refused with what is missing.

use crate::interface::{Interface, PairState};
use crate::material::History;
use crate::parameter::{Column, Values};
use crate::path::{PathError, check_rows};

/// What the first value of a path's rows prescribes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Across {
    /// Gap \[m\], positive when open.
    Gap,
    /// Pressure \[Pa\], positive in compression.
    Pressure,
}

/// A path of one pair, row by row.
#[derive(Clone, Debug)]
pub struct InterfacePath {
    /// Time \[s\], not falling. Interface laws know no time: it is for figures.
    pub time: Vec<f64>,
    /// Gap \[m\] or pressure \[Pa\], then the slip along both tangents \[m\].
    pub values: Vec<[f64; 3]>,
    pub across: Across,
}

/// What came of a path, row by row.
#[derive(Clone, Debug)]
pub struct InterfaceResponse {
    /// \[m\], positive when open.
    pub gap: Vec<f64>,
    /// \[m\]
    pub slip: Vec<[f64; 2]>,
    /// \[Pa\], positive in compression.
    pub pressure: Vec<f64>,
    /// Shear \[Pa\] along the slip that caused it: −t, so that it grows with the slip as in a shear test.
    pub shear: Vec<[f64; 2]>,
    /// Names, units and meaning of `history`.
    pub columns: &'static [Column],
    /// `history[column][row]`
    pub history: Vec<Vec<f64>>,
    /// Column of the [`PairState`].
    pub state: usize,
    /// Columns that are 1 once the pair has slid, and once it has opened.
    pub slid: usize,
    pub opened: usize,
}

impl InterfaceResponse {
    /// A history variable along the path, by its name.
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        let k = self.columns.iter().position(|c| c.name == name)?;
        self.history.get(k).map(Vec::as_slice)
    }
}

/// Follows a path with a law, from a pair that was just made.
///
/// # Errors
/// See [`PathError`]; [`PathError::NotConverged`] where the pair cannot carry the prescribed pressure.
pub fn drive_interface<I: Interface>(law: &I, path: &InterfacePath) -> Result<InterfaceResponse, PathError> {
    check_rows(&path.time, &path.values)?;
    let rows = path.time.len();
    let mut response = InterfaceResponse {
        gap: Vec::with_capacity(rows),
        slip: Vec::with_capacity(rows),
        pressure: Vec::with_capacity(rows),
        shear: Vec::with_capacity(rows),
        columns: I::HISTORY,
        history: vec![Vec::with_capacity(rows); I::HISTORY.len()],
        state: I::STATE,
        slid: I::SLID,
        opened: I::OPENED,
    };
    let mut pair = Pair { law, gap: 0.0, history: <I::History<f64> as History<f64>>::zero() };
    for (row, &[across, s1, s2]) in path.values.iter().enumerate() {
        let slip = [s1, s2];
        pair.gap = match path.across {
            Across::Gap => across,
            Across::Pressure => {
                pair.gap_at(across, slip).map_err(|miss| PathError::NotConverged { row, miss })?
            }
        };
        let (pressure, shear, history) = law.update(pair.gap, slip, pair.history);
        pair.history = history;
        response.gap.push(pair.gap);
        response.slip.push(slip);
        response.pressure.push(pressure);
        response.shear.push(shear.map(|t| -t));
        for (column, value) in response.history.iter_mut().zip(pair.history.as_ref()) {
            column.push(*value);
        }
    }
    Ok(response)
}

/// A pair on its way.
struct Pair<'a, I: Interface> {
    law: &'a I,
    gap: f64,
    history: I::History<f64>,
}

/// Share of a prescribed pressure that may be missing: neighbouring gaps near the end of a hyperbola differ by that.
const ROUND_OFF: f64 = 1e-11;

impl<I: Interface> Pair<'_, I> {
    /// Pressure that the next update would answer with, and whether the pair would be open.
    fn answer(&self, gap: f64, slip: [f64; 2]) -> (f64, bool) {
        let (pressure, _, new) = self.law.update(gap, slip, self.history);
        (pressure, is_open::<I>(&new))
    }

    /// The gap at which it carries a pressure \[Pa\], or what is missing of it.
    fn gap_at(&self, pressure: f64, slip: [f64; 2]) -> Result<f64, f64> {
        if pressure == 0.0 {
            let gap = if is_open::<I>(&self.history) { self.gap.max(0.0) } else { 0.0 };
            let miss = self.answer(gap, slip).0.abs();
            return if miss == 0.0 { Ok(gap) } else { Err(miss) };
        }
        // The pressure falls as the gap grows, up to where the pair opens.
        let too_wide = |gap: f64| {
            let (found, open) = self.answer(gap, slip);
            open || found < pressure
        };
        let mut reach = pressure.abs() / self.law.stiffness(0.0)[0];
        while too_wide(-reach.copysign(pressure)) == (pressure > 0.0) {
            reach *= 2.0;
            if !reach.is_finite() {
                return Err(pressure.abs());
            }
        }
        let [mut narrow, mut wide] = if pressure > 0.0 { [-reach, 0.0] } else { [0.0, reach] };
        loop {
            let middle = 0.5 * (narrow + wide);
            if !(narrow < middle && middle < wide) {
                break;
            }
            if too_wide(middle) {
                wide = middle;
            } else {
                narrow = middle;
            }
        }
        let miss = |gap: f64| (self.answer(gap, slip).0 - pressure).abs();
        let gap = if miss(wide) < miss(narrow) { wide } else { narrow };
        if miss(gap) <= ROUND_OFF * pressure.abs() { Ok(gap) } else { Err(miss(gap)) }
    }
}

fn is_open<I: Interface>(history: &I::History<f64>) -> bool {
    history.as_ref()[I::STATE] == PairState::Open.number()
}

macro_rules! drivers {
    ($($law:ty,)*) => {
        &[$((<$law as Interface>::NAME, drive_values::<$law> as Driver)),*]
    };
}

type Driver = fn(&Values, &InterfacePath) -> Result<InterfaceResponse, PathError>;

const DRIVERS: &[(&str, Driver)] = crate::for_each_interface!(drivers);

fn drive_values<I: Interface>(values: &Values, path: &InterfacePath) -> Result<InterfaceResponse, PathError> {
    drive_interface(&I::new(values).map_err(PathError::Parameters)?, path)
}

/// Follows a path with a registered law, by its name and parameters.
///
/// # Errors
/// See [`PathError`].
// Inlined into another crate it would be compiled there, with every law.
#[inline(never)]
pub fn drive_interface_named(
    name: &str,
    values: &Values,
    path: &InterfacePath,
) -> Result<InterfaceResponse, PathError> {
    match DRIVERS.iter().find(|(own, _)| *own == name) {
        Some((_, drive)) => drive(values, path),
        None => Err(PathError::UnknownLaw {
            name: name.to_owned(),
            known: DRIVERS.iter().map(|(own, _)| *own).collect(),
        }),
    }
}
