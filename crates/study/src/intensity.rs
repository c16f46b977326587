//! Measures of how strong a motion is, by which records are scaled and fragilities told.
//!
//! They are of the motion as it is processed and given, in the model's axes, before the kind of the record (an outcrop's half) is
//! seen to. All are of the two horizontal components unless they name an axis.

mod over_target;

use over_target::over_target;
use tremolite_case::units;
use tremolite_laws::parameter::Dimension;
use tremolite_motion::{Intensity, Motion, TargetSpectrum, pseudo_acceleration};

/// What is measured of one component.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// Peak acceleration.
    Pga,
    /// Peak velocity.
    Pgv,
    /// Peak displacement.
    Pgd,
    /// Arias intensity.
    Arias,
    /// Cumulative absolute velocity.
    Cav,
    /// Pseudo-acceleration of an oscillator with this period \[s\] and damping ratio.
    Sa { period: f64, damping: f64 },
    /// e to the mean of ln(Sa/target) over a band of periods \[s\], equally by their logarithm, at the target's damping: 1 for a motion that fits
    /// it in the mean.
    Target { from: f64, to: f64 },
}

/// How one number comes of two horizontal components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    /// The larger of those along x and y.
    Largest,
    /// The root of the product of those along x and y.
    GeometricMean,
    /// The median over all directions (`boore2010`), of half circles in steps of one degree.
    RotD50,
    /// The largest over all directions.
    RotD100,
    /// One axis of the model.
    Axis(usize),
}

/// An intensity measure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measure {
    pub of: Of,
    pub kind: Kind,
}

/// What may be written.
pub const FORMS: &str = "PGA, PGV, PGD, Arias, CAV, Sa(0.5 s) or Sa(0.5 s, 5 %), alone (the larger horizontal component) or behind \
                         geometric-mean, RotD50, RotD100, x, y or z: \"RotD50 Sa(0.5 s, 5 %)\"; or target(0.2 s, 2 s), Sa over a target \
                         spectrum in a band";

const COMPONENTS: [(&str, Of); 7] = [
    ("largest", Of::Largest),
    ("geometric-mean", Of::GeometricMean),
    ("RotD50", Of::RotD50),
    ("RotD100", Of::RotD100),
    ("x", Of::Axis(0)),
    ("y", Of::Axis(1)),
    ("z", Of::Axis(2)),
];

const PLAIN: [(&str, Kind); 5] =
    [("PGA", Kind::Pga), ("PGV", Kind::Pgv), ("PGD", Kind::Pgd), ("Arias", Kind::Arias), ("CAV", Kind::Cav)];

impl Measure {
    /// Reads a measure as it is written, [`FORMS`]; capital or small letters do not matter.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn parse(text: &str) -> Result<Measure, String> {
        let text = text.trim();
        let (of, rest) = match text.split_once(char::is_whitespace) {
            Some((first, rest)) => match COMPONENTS.iter().find(|(name, _)| name.eq_ignore_ascii_case(first))
            {
                Some((_, of)) => (*of, rest.trim()),
                None => (Of::Largest, text),
            },
            None => (Of::Largest, text),
        };
        if let Some((_, kind)) = PLAIN.iter().find(|(name, _)| name.eq_ignore_ascii_case(rest)) {
            return Ok(Measure { of, kind: *kind });
        }
        let period = |written: &str| {
            units::parse(written, Dimension::TIME)
                .map_err(|e| format!("the period in `{text}` {}", e.message("period")))
        };
        let unknown = || format!("`{text}` is no measure of intensity");
        let inside = |name: &str| {
            let named = rest.get(..name.len()).filter(|own| own.eq_ignore_ascii_case(name));
            named.and_then(|_| rest[name.len()..].trim().strip_prefix('(')?.strip_suffix(')'))
        };
        if let Some(band) = inside("target") {
            let (from, to) = band.split_once(',').ok_or_else(|| {
                format!("`{text}` needs two periods, the band in which Sa is set beside the target")
            })?;
            let [from, to] = [from, to].map(period);
            let (from, to) = (from?, to?);
            if !(from > 0.0 && to >= 1.5 * from) {
                return Err(format!(
                    "`{text}` needs the shorter period first, the longer at least half as long again"
                ));
            }
            return Ok(Measure { of, kind: Kind::Target { from, to } });
        }
        let inside = inside("Sa");
        let (own, damping) = match inside.ok_or_else(unknown)?.split_once(',') {
            Some((own, damping)) => (own, damping),
            None => (inside.unwrap_or_default(), "5 %"),
        };
        let period = period(own)?;
        let damping = units::parse(damping, Dimension::NONE)
            .map_err(|e| format!("the damping ratio in `{text}` {}", e.message("damping")))?;
        if !(period > 0.0) || !(0.0..1.0).contains(&damping) {
            return Err(format!("`{text}` needs a period above 0 and a damping ratio from 0 to below 100 %"));
        }
        Ok(Measure { of, kind: Kind::Sa { period, damping } })
    }

    pub fn dimension(&self) -> Dimension {
        match self.kind {
            Kind::Pga | Kind::Sa { .. } => Dimension::ACCELERATION,
            Kind::Pgv | Kind::Arias | Kind::Cav => Dimension::VELOCITY,
            Kind::Pgd => Dimension::LENGTH,
            Kind::Target { .. } => Dimension::NONE,
        }
    }

    /// The unit that people tell it in, and its SI value.
    pub fn unit(&self) -> (&'static str, f64) {
        match self.kind {
            Kind::Pga | Kind::Sa { .. } => ("g", units::STANDARD_GRAVITY),
            Kind::Pgv | Kind::Arias | Kind::Cav => ("m/s", 1.0),
            Kind::Pgd => ("m", 1.0),
            Kind::Target { .. } => ("1", 1.0),
        }
    }

    /// What is left of a motion that has it `now` to be at `level`: the factor for all components.
    pub fn factor(&self, now: f64, level: f64) -> f64 {
        let ratio = level / now;
        if self.kind == Kind::Arias { ratio.sqrt() } else { ratio }
    }

    /// The measure of a motion times a factor, of that of the motion.
    pub fn scaled(&self, now: f64, factor: f64) -> f64 {
        if self.kind == Kind::Arias { now * factor * factor } else { now * factor.abs() }
    }

    /// The measure in SI; `target` is the spectrum that one over a target is over.
    ///
    /// # Errors
    /// Where there is no target for it, or none in its band; else none for measures that were read and motions that hold what they promise.
    pub fn of(
        &self,
        motion: &Motion,
        target: Option<&TargetSpectrum>,
    ) -> Result<f64, tremolite_motion::Error> {
        if let Kind::Target { from, to } = self.kind {
            return over_target(self.of, [from, to], motion, target);
        }
        let along = |axis: usize| self.kind.of(&motion.acceleration[axis], motion.dt);
        Ok(match self.of {
            Of::Axis(axis) => along(axis)?,
            Of::Largest => along(0)?.max(along(1)?),
            Of::GeometricMean => (along(0)? * along(1)?).sqrt(),
            Of::RotD50 | Of::RotD100 => {
                let mut turned = self.kind.turned(motion)?;
                turned.sort_by(f64::total_cmp);
                let half = turned.len() / 2;
                if self.of == Of::RotD100 {
                    turned[turned.len() - 1]
                } else {
                    0.5 * (turned[half - 1] + turned[half])
                }
            }
        })
    }
}

impl Kind {
    fn of(self, acceleration: &[f64], dt: f64) -> Result<f64, tremolite_motion::Error> {
        if let Kind::Sa { period, damping } = self {
            return Ok(pseudo_acceleration(acceleration, dt, &[period], damping)?[0]);
        }
        let all = Intensity::of_samples(acceleration, dt);
        Ok(match self {
            Kind::Pgv => all.pgv,
            Kind::Pgd => all.pgd,
            Kind::Arias => all.arias,
            Kind::Cav => all.cav,
            _ => all.pga,
        })
    }

    /// In 180 directions one degree apart, from x on.
    fn turned(self, motion: &Motion) -> Result<Vec<f64>, tremolite_motion::Error> {
        let [x, y, _] = &motion.acceleration;
        (0..180)
            .map(|degree| {
                let angle = f64::from(degree).to_radians();
                let (sin, cos) = (libm::sin(angle), libm::cos(angle));
                let along: Vec<f64> = x.iter().zip(y).map(|(x, y)| x * cos + y * sin).collect();
                self.of(&along, motion.dt)
            })
            .collect()
    }
}

impl std::fmt::Display for Measure {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        if self.of != Of::Largest
            && let Some((name, _)) = COMPONENTS.iter().find(|(_, of)| *of == self.of)
        {
            write!(f, "{name} ")?;
        }
        if let Kind::Sa { period, damping } = self.kind {
            return write!(f, "Sa({period} s, {} %)", tremolite_case::study::rounded(100.0 * damping));
        }
        if let Kind::Target { from, to } = self.kind {
            return write!(f, "target({from} s, {to} s)");
        }
        let name = PLAIN.iter().find(|(_, kind)| *kind == self.kind).map_or("", |(name, _)| name);
        f.write_str(name)
    }
}

#[cfg(test)]
mod tests;
