//! How much of a wave is seen on the surface of bare rock.

use super::heading::WaveType;
use super::modes::p_sv;
use super::rock::Rock;
use tremolite_motion::Complex64;

/// Motion of the surface of a bare, undamped half-space over that of the wave that comes up, along h, t and up: the same at all
/// frequencies ω > 0, real up to the critical angle (`aki2002`, section 5.2).
pub fn coefficients(kind: WaveType, angle: f64, rock: &Rock) -> [Complex64; 3] {
    let zero = Complex64::default();
    if kind == WaveType::Sh {
        return [zero, Complex64::from(2.0), zero];
    }
    let rock = rock.undamped();
    let p = angle.sin() / kind.speed(&rock);
    let s = Complex64::new(0.0, 1.0);
    let seen = rock.at(s);
    let modes = p_sv(&seen, [rock.p, rock.s], p, s);
    let [qp, qs] = modes.slowness;
    let slow = rock.s.powi(-2);
    let bent = slow - 2.0 * p * p;
    let rayleigh = bent * bent + 4.0 * p * p * qp * qs;
    match kind {
        WaveType::P => {
            let share = 2.0 * rock.p * slow / rayleigh;
            [share * 2.0 * p * qp * qs, zero, share * bent * qp]
        }
        _ => {
            let share = 2.0 * qs / (rock.s * rayleigh);
            [share * bent, zero, -share * 2.0 * p * qp]
        }
    }
}
