//! Measures of a record in words and as data.

use tremolite_motion::{Channel, Intensity, cumulative_trapezoid};

/// The largest sizes of a record and where it ends, from rest; of counts the first alone means anything.
pub struct Measures {
    raw: bool,
    /// m/s², or counts.
    pga: f64,
    /// m/s.
    pgv: f64,
    /// m.
    pgd: f64,
    /// Displacement at the end (m).
    end: f64,
}

impl Measures {
    /// Of the samples as they are.
    pub fn of(c: &Channel) -> Measures {
        let m = Intensity::of_samples(&c.acceleration, c.dt);
        let displacement = cumulative_trapezoid(&cumulative_trapezoid(&c.acceleration, c.dt), c.dt);
        let end = displacement.last().copied().unwrap_or(0.0);
        Measures { raw: c.raw, pga: m.pga, pgv: m.pgv, pgd: m.pgd, end }
    }

    pub fn text(&self) -> String {
        let [pga, pgv, pgd, end] = [self.pga, self.pgv, self.pgd, self.end].map(figures);
        if self.raw {
            return format!("peak {pga} counts");
        }
        format!("PGA {pga} m/s2, PGV {pgv} m/s, PGD {pgd} m, displacement at the end {end} m")
    }

    /// What has a unit is there only for an acceleration; the peak of counts is in counts.
    pub fn json(&self) -> serde_json::Value {
        let known = |value: f64| if self.raw { serde_json::Value::Null } else { value.into() };
        serde_json::json!({
            "pga": self.pga, "pgv": known(self.pgv), "pgd": known(self.pgd), "displacement_at_end": known(self.end),
        })
    }
}

/// The channel less the mean of its samples, so that a digitiser's offset does not hide everything else.
pub fn less_mean(c: &Channel) -> Channel {
    let mut less = c.clone();
    let mean = c.acceleration.iter().sum::<f64>() / c.acceleration.len().max(1) as f64;
    less.acceleration.iter_mut().for_each(|a| *a -= mean);
    less
}

/// A time to a microsecond, without needless zeros.
pub fn seconds(time: f64) -> String {
    format!("{}", (time * 1e6).round() / 1e6)
}

/// A measure to four figures, of a weak record as of a strong one.
pub fn figures(value: f64) -> String {
    let power = if value == 0.0 { 0.0 } else { value.abs().log10().floor() };
    if !(-6.0..9.0).contains(&power) {
        return format!("{value:.3e}");
    }
    format!("{value:.*}", (3.0 - power).max(0.0) as usize)
}
