//! A round cavity with a bonded liner in a space without end, under steady P waves of 3, 9 and 15 Hz.
//!
//! As [`super::cavity_sines`]: rock with a wall of 8.5 m, a liner half a metre thick of concrete, one ring of 2×2×2 points, whose
//! points near the inner and the outer face are compared with what is exact there (`pao1973` has the equations, with tractions and
//! displacements handed on between rock and liner; `scattering`). Beside the cavity the liner has 5.8 times the incident
//! stress within and 5.1 times without.

use super::cavity_sines::Series;
use crate::full_space::{LINED, ROCK};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::TAU;

const NAME: &str = "lined_cavity_sines";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "round cavity with a bonded liner in full space under steady P waves: hoop stress of the liner in amplitude and phase",
    source: "`pao1973`",
    from: Effort::Verify,
    run,
};

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let waves = &[(1, "3 Hz"), (3, "9 Hz"), (5, "15 Hz")];
    let fundamental = TAU * 3.0 * LINED.radius / ROCK.speeds().0;
    let series = Series { name: NAME, cavity: LINED, fundamental, waves };
    let mut checks = series.boxes(20, &[8.0, 16.0])?;
    if effort == Effort::Full {
        checks.extend(series.meshes([10, 20], 16.0)?);
        checks.extend(series.boxes(30, &[16.0, 32.0])?);
    }
    Ok(checks)
}
