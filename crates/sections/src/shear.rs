//! Resistance to shear of sections without links.

use crate::Section;

/// Which clause gives the resistance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shear {
    /// EN 1992-1-1 6.2.2 (1), with the recommended C_Rd,c = 0.18/γ_c, k_1 = 0.15 and v_min = 0.035 k^1.5 f_ck^0.5.
    En {
        /// f_ck \[Pa\].
        characteristic: f64,
        /// f_cd \[Pa\].
        design: f64,
        /// γ_c.
        factor: f64,
    },
    /// EN 1992-1-1 12.6.3, plain concrete: 1.5 V/A_cc ≤ f_cvd, A_cc what is pressed.
    EnPlain {
        /// f_cd and f_ctd of plain concrete \[Pa\].
        compression: f64,
        tension: f64,
    },
    /// GB 50010-2010 6.3.3, slabs without links: 0.7 β_h f_t h_0; less 0.2 N where N pulls (6.3.14). Pressure is left out, to the safe
    /// side.
    Gb {
        /// f_t \[Pa\].
        tension: f64,
    },
}

impl Shear {
    /// Resistance V \[N/m\] of a section under N \[N/m\] and M \[N m/m\], whose sign says which layers are
    /// pulled, and whose size what of plain concrete is pressed. Not a number where there are none and the clause asks for them.
    pub fn resistance(&self, section: &Section, [n, m]: [f64; 2]) -> f64 {
        let thickness = section.thickness;
        let sign = if m < 0.0 { -1.0 } else { 1.0 };
        let pulled = section.layers.iter().filter(|l| sign * l.depth > 0.0);
        let (area, lever) = pulled.fold((0.0, 0.0), |(a, s), l| (a + l.area, s + l.area * sign * l.depth));
        // Said here, since the least of a number and of none is the number.
        if area == 0.0 && !matches!(self, Shear::EnPlain { .. }) {
            return f64::NAN;
        }
        let effective = 0.5 * thickness + lever / area;
        // MPa and mm, as the clauses are written; compression positive.
        const MEGA: f64 = 1e6;
        match *self {
            Shear::En { characteristic, design, factor } => {
                let (f_ck, f_cd) = (characteristic / MEGA, design / MEGA);
                let k = (1.0 + (0.2 / effective).sqrt()).min(2.0);
                let ratio = (area / effective).min(0.02);
                let pressure = -n / thickness / MEGA;
                let along = 0.15 * pressure.min(0.2 * f_cd);
                let with_steel = 0.18 / factor * k * (100.0 * ratio * f_ck).cbrt();
                let least = 0.035 * k.powf(1.5) * f_ck.sqrt();
                ((with_steel.max(least) + along) * effective * MEGA).max(0.0)
            }
            Shear::EnPlain { compression, tension } => {
                let (f_cd, f_ctd) = (compression / MEGA, tension / MEGA);
                // What is pressed, as 12.6.1 has it, once the force leaves the core; under tension the whole.
                let eccentricity = if n < 0.0 { (m / n).abs() } else { 0.0 };
                let pressed =
                    if eccentricity > thickness / 6.0 { thickness - 2.0 * eccentricity } else { thickness };
                if pressed <= 0.0 {
                    return 0.0;
                }
                let pressure = -n / pressed / MEGA;
                let limit = f_cd - 2.0 * (f_ctd * (f_ctd + f_cd)).sqrt();
                let beyond = 0.5 * (pressure - limit).max(0.0);
                let square = f_ctd * f_ctd + pressure * f_ctd - beyond * beyond;
                square.max(0.0).sqrt() * pressed / 1.5 * MEGA
            }
            Shear::Gb { tension } => {
                let deep = (0.8 / effective.clamp(0.8, 2.0)).powf(0.25);
                (0.7 * deep * tension * effective - 0.2 * n.max(0.0)).max(0.0)
            }
        }
    }
}
