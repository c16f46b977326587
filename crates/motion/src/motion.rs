//! The input motion, evaluated at any instant.

use crate::{Error, cumulative_trapezoid};

/// Acceleration (m/s²), velocity (m/s) and displacement (m) at one instant, along x, y, z.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Sample {
    pub a: [f64; 3],
    pub v: [f64; 3],
    pub u: [f64; 3],
}

/// A motion in the model's axes, sampled every `dt` from time 0.
///
/// All nine columns are equally long and hold at least two samples.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// Sampling interval (s).
    pub dt: f64,
    /// Acceleration (m/s²) along x, y, z.
    pub acceleration: [Vec<f64>; 3],
    /// Velocity (m/s).
    pub velocity: [Vec<f64>; 3],
    /// Displacement (m).
    pub displacement: [Vec<f64>; 3],
}

/// The stop after the last sample takes this part of the motion's duration.
const STOP: f64 = 0.05;

impl Motion {
    /// Integrates a record of acceleration (m/s²), taken as linear between samples, from rest at 0.
    ///
    /// Both integrals are exact for that course: velocity is the cumulative trapezoid; displacement differs
    /// from a second cumulative trapezoid (as [`crate::Intensity`] takes) by dt² (a − a(0))/12, so that
    /// acceleration, velocity and displacement are derivatives of each other at every instant.
    ///
    /// # Errors
    /// [`Error::Unsuitable`] if `dt` is not above 0, there are fewer than two samples, the components differ
    /// in length, or a value or an integral is not finite.
    pub fn from_acceleration(dt: f64, acceleration: [Vec<f64>; 3]) -> Result<Motion, Error> {
        let velocity = acceleration.each_ref().map(|a| cumulative_trapezoid(a, dt));
        let displacement = [0, 1, 2].map(|c| {
            let first = acceleration[c].first().copied().unwrap_or(0.0);
            let mut u = cumulative_trapezoid(&velocity[c], dt);
            u.iter_mut().zip(&acceleration[c]).for_each(|(u, a)| *u -= dt * dt / 12.0 * (a - first));
            u
        });
        Motion { dt, acceleration, velocity, displacement }.checked()
    }

    /// Samples an analytic motion every `dt` (s) from 0 to at least `duration` (s).
    ///
    /// Between samples [`Motion::at`] then errs by O(dt²) in acceleration, O(dt⁴) in velocity and O(dt⁶) in
    /// displacement.
    ///
    /// # Errors
    /// As [`Motion::from_acceleration`], and for more than 10⁸ samples.
    pub fn sampled(dt: f64, duration: f64, motion: impl Fn(f64) -> Sample) -> Result<Motion, Error> {
        let steps = (duration / dt - 1e-9).ceil();
        if !(1.0..1e8).contains(&steps) {
            return Err(Error::unsuitable(
                format!("a motion of {duration} s sampled every {dt} s has no sensible number of samples"),
                "choose an interval above 0 and below the duration",
            ));
        }
        let samples: Vec<Sample> = (0..=steps as usize).map(|i| motion(i as f64 * dt)).collect();
        let columns =
            |pick: fn(&Sample) -> [f64; 3]| [0, 1, 2].map(|c| samples.iter().map(|s| pick(s)[c]).collect());
        Motion {
            dt,
            acceleration: columns(|s| s.a),
            velocity: columns(|s| s.v),
            displacement: columns(|s| s.u),
        }
        .checked()
    }

    /// Hands the motion on if it keeps what the type promises.
    fn checked(self) -> Result<Motion, Error> {
        let count = self.acceleration[0].len();
        let columns = || self.acceleration.iter().chain(&self.velocity).chain(&self.displacement);
        if !(self.dt > 0.0 && self.dt.is_finite()) {
            return Err(Error::unsuitable(
                format!("the sampling interval {} s is not above 0", self.dt),
                "give the interval in s",
            ));
        }
        if count < 2 || columns().any(|c| c.len() != count) {
            return Err(Error::unsuitable(
                "the components of the motion are not equally long, or have fewer than two samples",
                "cut them to a common span of time",
            ));
        }
        if columns().flatten().any(|x| !x.is_finite()) {
            return Err(Error::unsuitable(
                "the motion or its integral is not finite",
                "check the record's values and units",
            ));
        }
        Ok(self)
    }

    /// Time of the last sample (s); the first is at 0.
    pub fn duration(&self) -> f64 {
        self.acceleration[0].len().saturating_sub(1) as f64 * self.dt
    }

    /// The largest displacement at the end over that component's peak: 0 for a record that comes back to rest.
    pub fn drift(&self) -> f64 {
        let of = |u: &Vec<f64>| {
            let peak = u.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            if peak > 0.0 { u.last().map_or(0.0, |last| last.abs() / peak) } else { 0.0 }
        };
        self.displacement.iter().map(of).fold(0.0, f64::max)
    }

    /// The motion times a number: the incident part of an outcrop motion, say
    /// ([`crate::Kind::incident_factor`]).
    pub fn scaled(mut self, factor: f64) -> Motion {
        let all = self.acceleration.iter_mut().chain(&mut self.velocity).chain(&mut self.displacement);
        all.flatten().for_each(|x| *x *= factor);
        self
    }

    /// The motion at time `t` (s) from the first sample.
    ///
    /// - Between samples acceleration is linear, velocity the cubic through its samples with the accelerations
    ///   as slopes, displacement the quintic with velocities and accelerations. For an integrated record these
    ///   are the exact quadratic and cubic. Velocity is smooth to its first derivative, displacement to its
    ///   second.
    /// - Before the first sample everything is zero.
    /// - After the last sample the ground is brought to a stop: a base held at a constant velocity would push
    ///   the model away for ever, and a velocity cut to zero would hit it. Over 5 % of the duration the
    ///   velocity falls to zero along a cubic; then displacement holds. What is left in the velocity at the
    ///   end is an error of the record, small where it was detrended or filtered, and tapered.
    pub fn at(&self, t: f64) -> Sample {
        let mut out = Sample::default();
        let last = self.acceleration[0].len().saturating_sub(1);
        if !(t >= 0.0) || last == 0 {
            return out;
        }
        let place = t / self.dt;
        for c in 0..3 {
            let (a, v, u) = (&self.acceleration[c], &self.velocity[c], &self.displacement[c]);
            (out.a[c], out.v[c], out.u[c]) = if place <= last as f64 {
                let i = (place as usize).min(last - 1);
                between([a[i], a[i + 1]], [v[i], v[i + 1]], [u[i], u[i + 1]], self.dt, place - i as f64)
            } else {
                let stop = STOP * self.duration();
                stopping(v[last], u[last], stop, ((t - self.duration()) / stop).min(1.0))
            };
        }
        out
    }
}

/// Acceleration, velocity and displacement at the fraction `x` of an interval `h` (s) from its end values.
fn between(a: [f64; 2], v: [f64; 2], u: [f64; 2], h: f64, x: f64) -> (f64, f64, f64) {
    // In departures from the motion that goes on with the first sample's acceleration.
    let da = h * (a[1] - a[0]);
    let dv = v[1] - v[0] - h * a[0];
    let du = u[1] - u[0] - h * (v[0] + 0.5 * h * a[0]);
    let (hda, hdv) = (h * da, h * dv);
    let velocity = v[0] + x * (h * a[0] + x * (3.0 * dv - da + x * (da - 2.0 * dv)));
    let cubic = 10.0 * du - 4.0 * hdv + 0.5 * hda;
    let quartic = -15.0 * du + 7.0 * hdv - hda;
    let quintic = 6.0 * du - 3.0 * hdv + 0.5 * hda;
    let displacement =
        u[0] + x * (h * v[0] + x * (0.5 * h * h * a[0] + x * (cubic + x * (quartic + x * quintic))));
    (a[0] + x * (a[1] - a[0]), velocity, displacement)
}

/// The stop from velocity `v` and displacement `u` over the time `stop` (s), at its fraction `x` in 0 to 1.
fn stopping(v: f64, u: f64, stop: f64, x: f64) -> (f64, f64, f64) {
    (
        v / stop * 6.0 * x * (x - 1.0),
        v * (1.0 + x * x * (2.0 * x - 3.0)),
        u + v * stop * x * (1.0 + x * x * (0.5 * x - 1.0)),
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ricker_velocity;

    fn rough() -> Motion {
        let a = |k: f64| (0..40).map(|i| (k * f64::from(i * i)).sin()).collect();
        Motion::from_acceleration(0.02, [a(1.0), a(2.0), a(3.0)]).unwrap()
    }

    #[test]
    fn samples_are_met_and_velocity_is_the_cumulative_trapezoid() {
        let motion = rough();
        for i in 0..40 {
            let s = motion.at(i as f64 * 0.02);
            for c in 0..3 {
                assert!((s.a[c] - motion.acceleration[c][i]).abs() < 1e-12);
                assert!((s.v[c] - motion.velocity[c][i]).abs() < 1e-14);
                assert!((s.u[c] - motion.displacement[c][i]).abs() < 1e-15);
            }
        }
        assert_eq!(motion.velocity[1], cumulative_trapezoid(&motion.acceleration[1], 0.02));
    }

    /// Simpson's rule is exact for cubics, so over a part of one interval it must give the difference.
    #[test]
    fn a_record_is_its_own_derivative_at_every_instant() {
        let motion = rough();
        for i in 0..39 {
            for part in [[0.0, 0.3], [0.3, 1.0], [0.0, 1.0]] {
                let [from, to] = part.map(|x| (i as f64 + x) * 0.02);
                let [p, q, r] = [from, 0.5 * (from + to), to].map(|t| motion.at(t));
                for c in 0..3 {
                    let simpson = |f: [f64; 3]| (to - from) / 6.0 * (f[0] + 4.0 * f[1] + f[2]);
                    assert!((r.v[c] - p.v[c] - simpson([p.a[c], q.a[c], r.a[c]])).abs() < 1e-14);
                    assert!((r.u[c] - p.u[c] - simpson([p.v[c], q.v[c], r.v[c]])).abs() < 1e-15);
                }
            }
        }
    }

    #[test]
    fn constant_acceleration_gives_the_exact_parabola() {
        let motion = Motion::from_acceleration(0.1, [vec![2.0; 11], vec![0.0; 11], vec![-1.0; 11]]).unwrap();
        let s = motion.at(0.537);
        assert!((s.v[0] - 1.074).abs() < 1e-14 && (s.u[0] - 0.537f64.powi(2)).abs() < 1e-14);
        assert!((s.u[2] + 0.5 * 0.537f64.powi(2)).abs() < 1e-14 && s.u[1] == 0.0);
    }

    #[test]
    fn before_the_start_all_is_zero_and_after_the_end_the_ground_stops_without_a_jump() {
        let motion = Motion::from_acceleration(0.1, [vec![1.0; 11], vec![0.0; 11], vec![0.0; 11]]).unwrap();
        assert_eq!(motion.at(-1e-9), Sample::default());
        assert_eq!(motion.at(f64::NAN), Sample::default());
        let (end, after) = (motion.at(1.0), motion.at(1.0 + 1e-9));
        assert!((end.v[0] - after.v[0]).abs() < 1e-8 && (end.u[0] - after.u[0]).abs() < 1e-8);
        // The stop lasts 0.05 s; a symmetric cubic covers half of v × 0.05.
        for t in [1.05, 2.0, 1e6, f64::INFINITY] {
            let s = motion.at(t);
            assert!(
                s.v[0].abs() < 1e-12 && s.a[0].abs() < 1e-10 && (s.u[0] - 0.525).abs() < 1e-12,
                "{t} {s:?}"
            );
        }
        let (p, q, r) = (motion.at(1.01), motion.at(1.02), motion.at(1.03));
        assert!((r.u[0] - p.u[0] - 0.02 / 6.0 * (p.v[0] + 4.0 * q.v[0] + r.v[0])).abs() < 1e-15);
        assert!((r.v[0] - p.v[0] - 0.02 / 6.0 * (p.a[0] + 4.0 * q.a[0] + r.a[0])).abs() < 1e-14);
    }

    #[test]
    fn an_analytic_pulse_is_met_to_fourth_and_sixth_order() {
        let pulse = ricker_velocity(2.0, 1.0, 0.3);
        let error = |dt: f64| {
            let motion = Motion::sampled(dt, 2.0, |t| pulse(t).along([0.0, 0.0, 1.0])).unwrap();
            (0..2000).fold((0.0f64, 0.0f64), |(v, u), i| {
                let t = 0.00097 * f64::from(i);
                let (s, exact) = (motion.at(t), pulse(t));
                (v.max((s.v[2] - exact.v).abs()), u.max((s.u[2] - exact.u).abs()))
            })
        };
        let (coarse, fine) = (error(0.02), error(0.01));
        let order = |a: f64, b: f64| (a / b).log2();
        assert!((order(coarse.0, fine.0) - 4.0).abs() < 0.2, "{coarse:?} {fine:?}");
        assert!((order(coarse.1, fine.1) - 6.0).abs() < 0.3, "{coarse:?} {fine:?}");
    }

    #[test]
    fn scaling_scales_everything() {
        let (whole, half) = (rough().at(0.333), rough().scaled(0.5).at(0.333));
        for c in 0..3 {
            assert!(
                (half.u[c] - 0.5 * whole.u[c]).abs() < 1e-16 && (half.v[c] - 0.5 * whole.v[c]).abs() < 1e-16
            );
        }
    }

    #[test]
    fn motions_that_cannot_be_are_refused() {
        let ok = || vec![0.0, 1.0];
        for (dt, columns) in [
            (0.0, [ok(), ok(), ok()]),
            (f64::NAN, [ok(), ok(), ok()]),
            (0.1, [ok(), ok(), vec![0.0]]),
            (0.1, [vec![0.0], vec![0.0], vec![0.0]]),
            (0.1, [vec![], vec![], vec![]]),
            (0.1, [ok(), vec![0.0, f64::INFINITY], ok()]),
        ] {
            assert!(Motion::from_acceleration(dt, columns).is_err());
        }
        for (dt, duration) in [(0.1, 0.0), (0.0, 1.0), (1e-9, 1e9), (f64::NAN, 1.0)] {
            assert!(Motion::sampled(dt, duration, |_| Sample::default()).is_err());
        }
    }
}
