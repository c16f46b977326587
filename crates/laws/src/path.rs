//! Driving a material law along a path of strain, with some components of stress prescribed instead if wanted.
//!
//! Scalar lanes on plain arrays: what `tremolite law`, notebooks and tests share. No files here.
//!
//! **Prescribed stress.** The strain that gives it is sought for each row, to round-off. Where none is found for a
//! whole step, the step is gone in smaller ones, of strain and prescribed stress alike, down to a 4096th.
//!
//! **Jumps.** A law whose stress drops at a point of failure, as concrete's from f_c to βf_c with damage in the
//! compliance, has no state there that keeps the prescribed stress: before the drop the strain is too small for
//! failure, and after it the sides must move while the damage is not there yet. What happens in a test is that the
//! damage comes first and the sides follow. So where the smallest step finds no strain, the damage (and plastic
//! strain) of the strain that would have come next is kept, and the search goes on from there. It does so a few times
//! at most; [`Response::between`] tells where.

mod solve;
mod steps;

use crate::material::Material;
use crate::parameter::{BadParameter, Column, Role, Values, position};
use steps::Walk;

/// What a column of a path prescribes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Control {
    Strain,
    Stress,
}

/// A path of one material point, row by row.
#[derive(Clone, Debug)]
pub struct Path {
    /// Time \[s\], not falling. A step without time is one in which time stands still: rates are off.
    pub time: Vec<f64>,
    /// xx, yy, zz, xy, yz, zx: strain (engineering shear), or stress \[Pa\] where `control` says so.
    pub values: Vec<[f64; 6]>,
    pub control: [Control; 6],
    /// Extent h of the element in every direction \[m\]. Laws that soften over displacement or by a fracture energy ask for it.
    pub size: Option<f64>,
}

/// What came of a path, row by row.
#[derive(Clone, Debug)]
pub struct Response {
    /// Strain, engineering shear.
    pub strain: Vec<[f64; 6]>,
    /// Stress \[Pa\].
    pub stress: Vec<[f64; 6]>,
    /// Names, units and meaning of `history`.
    pub columns: &'static [Column],
    /// `history[column][row]`
    pub history: Vec<Vec<f64>>,
    /// Steps taken between rows, in order; none where strains alone are prescribed.
    pub between: Vec<Between>,
}

/// A step on the way to a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Between {
    /// The row that it leads towards.
    pub row: usize,
    /// Its time \[s\]; the row's own step takes what such steps have left, [`Response::last_step`].
    pub dt: f64,
    /// Strain, engineering shear.
    pub strain: [f64; 6],
    /// Whether it stands for a jump of the law: its stress is not the prescribed one, only its history is kept.
    pub jump: bool,
}

impl Response {
    /// A history variable along the path, by its name.
    pub fn column(&self, name: &str) -> Option<&[f64]> {
        let k = self.columns.iter().position(|c| c.name == name)?;
        self.history.get(k).map(Vec::as_slice)
    }

    /// A history variable along the path, by what it means, with its name.
    pub fn with_role(&self, role: Role) -> Option<(&'static str, &[f64])> {
        let k = position(self.columns, role)?;
        Some((self.columns[k].name, self.history.get(k)?))
    }

    /// Time \[s\] of a row's last step, of the `dt` that lies between it and the row before.
    pub fn last_step(&self, row: usize, dt: f64) -> f64 {
        let first = self.between.partition_point(|b| b.row < row);
        let steps = self.between[first..].iter().take_while(|b| b.row == row);
        steps.fold(dt, |left, step| (left - step.dt).max(0.0))
    }
}

/// Why a path cannot be followed. Rows count from 0.
#[derive(Clone, Debug, PartialEq)]
pub enum PathError {
    /// No law of this name; the registered ones are listed.
    UnknownLaw {
        name: String,
        known: Vec<&'static str>,
    },
    /// The law refuses its parameters.
    Parameters(Vec<BadParameter>),
    /// `time` and `values` have different lengths.
    Lengths {
        time: usize,
        values: usize,
    },
    NotFinite {
        row: usize,
    },
    /// Time runs backwards.
    Time {
        row: usize,
    },
    /// The law softens over displacement or by a fracture energy, and no size is given.
    SizeMissing,
    /// The size is not between 0 and the law's limit \[m\].
    Size {
        size: f64,
        limit: f64,
    },
    /// No strain or gap was found that gives what is prescribed; `miss` is what is left \[Pa\].
    NotConverged {
        row: usize,
        miss: f64,
    },
}

impl std::fmt::Display for PathError {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            PathError::UnknownLaw { name, known } => {
                write!(f, "there is no law '{name}'; known are {}", known.join(", "))
            }
            PathError::Parameters(faults) => {
                for (k, fault) in faults.iter().enumerate() {
                    write!(f, "{}{fault}", if k > 0 { "\n" } else { "" })?;
                }
                Ok(())
            }
            PathError::Lengths { time, values } => {
                write!(f, "the path has {time} times and {values} rows of values; give one time a row")
            }
            PathError::NotFinite { row } => {
                write!(f, "row {row} of the path holds a value that is not finite")
            }
            PathError::Time { row } => {
                write!(f, "time falls at row {row} of the path; sort the rows by time")
            }
            PathError::SizeMissing => {
                write!(
                    f,
                    "the law softens over displacement and needs the element's extent; give `size` in m"
                )
            }
            PathError::Size { size, limit } => write!(
                f,
                "a size of {size} m is not possible: it must be positive and below {limit:.3} m, where an element \
                 stores as much energy as it dissipates"
            ),
            PathError::NotConverged { row, miss } => write!(
                f,
                "nothing gives the stress prescribed at row {row} ({miss:.3e} Pa are missing), in small steps \
                 either: the law may not carry it; prescribe the strain or gap there"
            ),
        }
    }
}

impl std::error::Error for PathError {}

impl Path {
    /// A path of strains alone.
    pub fn strains(time: Vec<f64>, values: Vec<[f64; 6]>) -> Self {
        Path { time, values, control: [Control::Strain; 6], size: None }
    }

    fn check(&self, asked: bool, limit: f64) -> Result<[f64; 6], PathError> {
        check_rows(&self.time, &self.values)?;
        match self.size {
            None if asked => Err(PathError::SizeMissing),
            None => Ok([0.0; 6]),
            Some(h) if h > 0.0 && h < limit && h.is_finite() => Ok([h * h, h * h, h * h, 0.0, 0.0, 0.0]),
            Some(size) => Err(PathError::Size { size, limit }),
        }
    }
}

/// As many times as rows, all finite, time not falling.
pub(crate) fn check_rows<const N: usize>(time: &[f64], values: &[[f64; N]]) -> Result<(), PathError> {
    if time.len() != values.len() {
        return Err(PathError::Lengths { time: time.len(), values: values.len() });
    }
    for (row, (t, values)) in time.iter().zip(values).enumerate() {
        if !(t.is_finite() && values.iter().all(|x| x.is_finite())) {
            return Err(PathError::NotFinite { row });
        }
        if row > 0 && *t < time[row - 1] {
            return Err(PathError::Time { row });
        }
    }
    Ok(())
}

/// Follows a path with a law, from virgin material. The first row takes no time.
///
/// # Errors
/// See [`PathError`].
pub fn drive<M: Material>(law: &M, path: &Path) -> Result<Response, PathError> {
    let size = path.check(law.asks_size(), law.size_limit())?;
    let rows = path.time.len();
    let mut response = Response {
        strain: Vec::with_capacity(rows),
        stress: Vec::with_capacity(rows),
        columns: law.columns(),
        history: vec![Vec::with_capacity(rows); law.columns().len()],
        between: Vec::new(),
    };
    let mut walk = Walk::new(law, size, path.control);
    for (row, (t, values)) in path.time.iter().zip(&path.values).enumerate() {
        let dt = if row > 0 { t - path.time[row - 1] } else { 0.0 };
        walk.row(row, dt, values, &mut response.between)
            .map_err(|miss| PathError::NotConverged { row, miss })?;
        response.strain.push(walk.reached.strain);
        response.stress.push(walk.reached.stress);
        for (column, value) in response.history.iter_mut().zip(walk.history.as_ref()) {
            column.push(*value);
        }
    }
    Ok(response)
}

macro_rules! drivers {
    ($($law:ty,)*) => {
        &[$((<$law as Material>::NAME, drive_values::<$law> as Driver)),*]
    };
}

type Driver = fn(&Values, &Path) -> Result<Response, PathError>;

const DRIVERS: &[(&str, Driver)] = crate::for_each_material!(drivers);

fn drive_values<M: Material>(values: &Values, path: &Path) -> Result<Response, PathError> {
    drive(&M::new(values).map_err(PathError::Parameters)?, path)
}

/// Follows a path with a registered law, by its name and parameters.
///
/// # Errors
/// See [`PathError`].
// Inlined into another crate it would be compiled there, with every law.
#[inline(never)]
pub fn drive_named(name: &str, values: &Values, path: &Path) -> Result<Response, PathError> {
    match DRIVERS.iter().find(|(own, _)| *own == name) {
        Some((_, drive)) => drive(values, path),
        None => Err(PathError::UnknownLaw {
            name: name.to_owned(),
            known: DRIVERS.iter().map(|(own, _)| *own).collect(),
        }),
    }
}
