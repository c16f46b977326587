//! Earthquake records: reading, processing, measures of intensity, response spectra, and the input motion
//! that a model's base is shaken with. This crate knows nothing of meshes.
//!
//! The way of a record, each step a plain function on plain data:
//!
//! 1. [`read`] turns a file of any supported format into [`Channel`]s in m/s².
//! 2. [`align`] and [`common_time_base`] put the components of a record on one time base.
//! 3. [`Channel::window`] and [`process`](crate::process()) cut, correct, filter and scale them.
//! 4. [`Geographic`] turns them into east, north and up, then into the model's axes.
//! 5. [`Motion`] integrates them and answers for any instant; [`Kind`] says what the motion is, and so
//!    how much of it is the incident wave.
//!
//! Beside this way lie [`Intensity`], [`pseudo_acceleration`], [`highest_frequency`],
//! [`strongest_window`] and [`write_text`]; and what makes motions that fit a [`TargetSpectrum`]: [`matched`],
//! [`artificial`](crate::artificial()) and [`select`](crate::select()).
//!
//! Units are SI inside: s, Hz, m, m/s, m/s², rad. Azimuths are clockwise from north. The model's z axis is up.
//!
//! ```
//! use tremolite_motion::{Geographic, Motion, Process, ReadOptions, process, read_bytes};
//!
//! let text = b"# units = \"cm/s2\"\n0.00 0\n0.01 10\n0.02 -10\n0.03 0\n";
//! let mut east = read_bytes("pulse.txt".as_ref(), text, &ReadOptions::default())?.remove(0);
//! process(&mut [&mut east], &[Process::parse("scale 0.5").unwrap()])?;
//! let ground = Geographic::from_parts(Some(&east), None, None)?;
//! let motion = Motion::from_acceleration(ground.dt, ground.model_axes(90f64.to_radians()))?;
//! assert!((motion.at(0.01).a[0] - 0.05).abs() < 1e-15);
//! # Ok::<(), tremolite_motion::Error>(())
//! ```

#![forbid(unsafe_code)]
#![allow(clippy::neg_cmp_op_on_partial_ord, reason = "a negated comparison refuses NaN as well")]

mod artificial;
mod baseline;
mod butterworth;
mod channel;
mod error;
mod fourier;
mod frequency;
mod geographic;
mod integrate;
mod intensity;
mod interpolate;
mod kind;
mod matching;
mod misfit;
mod motion;
mod orientation;
mod polynomial;
mod process;
mod pulse;
mod read;
mod select;
mod sensitivity;
mod shown;
mod spectrum;
mod strongest;
mod target;
mod time_base;
mod transfer;
mod units;
mod write;

pub use artificial::{CORRELATION, Envelope, artificial, correlation};
pub use baseline::{Trend, drift, linear_trend};
pub use butterworth::{Band, Filter, Section};
pub use channel::{Channel, align};
pub use error::Error;
pub use frequency::{frequency_below, highest_frequency};
pub use geographic::Geographic;
pub use integrate::cumulative_trapezoid;
pub use intensity::Intensity;
pub use kind::Kind;
pub use matching::{Matched, matched};
pub use misfit::{Misfit, misfit, scale_to};
pub use motion::{Motion, Sample};
pub use orientation::Orientation;
pub use process::{MATCHED, Process, lowest_lowpass, process, process_towards};
pub use pulse::{Scalar, ricker_velocity};
pub use read::{FORMATS, Format, ReadOptions, Stations, TextColumn, read, read_bytes, recognised};
pub use realfft::num_complex::Complex64;
pub use select::{Candidate, select};
pub use sensitivity::Sensitivity;
pub use spectrum::{default_periods, pseudo_acceleration};
pub use strongest::{Strongest, strongest_window};
pub use target::TargetSpectrum;
pub use time_base::common_time_base;
pub use transfer::{Lines, transferred};
pub use tremolite_files::text::{Encoding, encoding};
pub use units::{STANDARD_GRAVITY, Units};
pub use write::write_text;
