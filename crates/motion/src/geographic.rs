//! From recorded components to east, north and up, and on to the model's axes.

use crate::sensitivity::REMEDY;
use crate::{Channel, Error, Orientation, common_time_base};

/// Ground acceleration in east, north and up on one time base.
#[derive(Debug, Clone, PartialEq)]
pub struct Geographic {
    /// Sampling interval (s).
    pub dt: f64,
    /// Time of the first sample (s).
    pub start: f64,
    /// Acceleration (m/s²), positive to the east; zeros where nothing was given. All three are equally long.
    pub east: Vec<f64>,
    /// Acceleration (m/s²), positive to the north.
    pub north: Vec<f64>,
    /// Acceleration (m/s²), positive upwards.
    pub up: Vec<f64>,
}

/// Two horizontal components nearer to parallel than this (rad) are refused (10°).
const SMALLEST_ANGLE: f64 = std::f64::consts::PI / 18.0;

impl Geographic {
    /// From components that are already called east, north and up; what is missing stays zero.
    ///
    /// # Errors
    /// As [`common_time_base`], and for channels of a sensor that does not record acceleration or that are in counts still.
    pub fn from_parts(
        east: Option<&Channel>,
        north: Option<&Channel>,
        up: Option<&Channel>,
    ) -> Result<Geographic, Error> {
        let parts = [east, north, up];
        let given: Vec<&Channel> = parts.iter().flatten().copied().collect();
        given.iter().try_for_each(|c| c.of_accelerometer())?;
        if let Some(raw) = given.iter().find(|c| c.raw) {
            return Err(Error::unsuitable(
                format!("'{}' is in counts, and nothing says what a count is", raw.name),
                REMEDY,
            ));
        }
        let cut = common_time_base(&given)?;
        // common_time_base refuses an empty list, so there is a first one.
        let (dt, start, count) = (cut[0].dt, cut[0].start, cut[0].acceleration.len());
        let mut cut = cut.into_iter();
        let [east, north, up] = parts.map(|part| match part.and_then(|_| cut.next()) {
            Some(channel) => channel.acceleration,
            None => vec![0.0; count],
        });
        Ok(Geographic { dt, start, east, north, up })
    }

    /// From channels whose files state their orientation: two horizontal ones in any two directions at least
    /// 10° apart, and at most one vertical one.
    ///
    /// # Errors
    /// [`Error::Unsuitable`] if an orientation is missing, the set is not as said, or as [`common_time_base`].
    pub fn from_channels(channels: &[Channel]) -> Result<Geographic, Error> {
        let mut horizontal = Vec::new();
        let mut vertical = Vec::new();
        for channel in channels {
            match channel.orientation {
                Some(Orientation::Azimuth(azimuth)) => horizontal.push((channel, azimuth)),
                Some(Orientation::Up) => vertical.push(channel),
                None => {
                    return Err(Error::unsuitable(
                        format!("the direction of component '{}' is not known", channel.name),
                        "give the components one by one, as east, north and up",
                    ));
                }
            }
        }
        let (&[(first, alpha), (second, beta)], [] | [_]) = (&horizontal[..], &vertical[..]) else {
            return Err(Error::unsuitable(
                format!(
                    "{} horizontal and {} vertical components were found, not two and at most one",
                    horizontal.len(),
                    vertical.len()
                ),
                "give the components one by one, as east, north and up",
            ));
        };
        let turn = (beta - alpha).sin();
        if !(turn.abs() >= SMALLEST_ANGLE.sin()) {
            return Err(Error::unsuitable(
                format!("the components '{}' and '{}' are nearly parallel", first.name, second.name),
                "check their azimuths; two different horizontal directions are needed",
            ));
        }
        let mut ground = Geographic::from_parts(Some(first), Some(second), vertical.first().copied())?;
        // Recorded r = e sin θ + n cos θ for each of the two; the inverse of that 2 × 2 system.
        for (e, n) in ground.east.iter_mut().zip(&mut ground.north) {
            let (r, s) = (*e, *n);
            *e = (s * alpha.cos() - r * beta.cos()) / turn;
            *n = (r * beta.sin() - s * alpha.sin()) / turn;
        }
        Ok(ground)
    }

    /// The components along the model's axes x, y, z (m/s²).
    ///
    /// `model_x_azimuth` (rad, clockwise from north) is where x points; z is up and y completes a right-handed
    /// system, 90° counter-clockwise from x seen from above. At 90° x is east and y is north.
    pub fn model_axes(&self, model_x_azimuth: f64) -> [Vec<f64>; 3] {
        // A quarter of a turn in radians is none by 10⁻¹⁶: what stands still along an axis should.
        let whole = |x: f64| if x.abs() < 1e-15 { 0.0 } else { x };
        let (sin, cos) = model_x_azimuth.sin_cos();
        let (sin, cos) = (whole(sin), whole(cos));
        let pairs = || self.east.iter().zip(&self.north);
        [
            pairs().map(|(e, n)| e * sin + n * cos).collect(),
            pairs().map(|(e, n)| n * sin - e * cos).collect(),
            self.up.clone(),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn channel(orientation: Option<Orientation>, acceleration: Vec<f64>) -> Channel {
        Channel { orientation, ..Channel::new(format!("{orientation:?}"), 0.01, acceleration) }
    }

    fn wave(k: f64) -> Vec<f64> {
        (0..50).map(|i| (k * f64::from(i)).sin()).collect()
    }

    #[test]
    fn components_at_any_two_azimuths_give_back_east_and_north() {
        let (east, north, up) = (wave(0.3), wave(0.7), wave(0.5));
        for (alpha, beta) in [(332.0, 242.0), (90.0, 0.0), (10.0, 55.0), (200.0, 350.0)] {
            let seen = |degrees: f64| {
                let (sin, cos) = degrees.to_radians().sin_cos();
                let values = east.iter().zip(&north).map(|(e, n)| e * sin + n * cos).collect();
                channel(Some(Orientation::from_degrees(degrees)), values)
            };
            let set = [channel(Some(Orientation::Up), up.clone()), seen(alpha), seen(beta)];
            let ground = Geographic::from_channels(&set).unwrap();
            for i in 0..50 {
                assert!(
                    (ground.east[i] - east[i]).abs() < 1e-14 && (ground.north[i] - north[i]).abs() < 1e-14
                );
            }
            assert_eq!(ground.up, up);
        }
    }

    #[test]
    fn model_axes_are_right_handed_with_x_at_its_azimuth() {
        let ground = Geographic {
            dt: 0.01,
            start: 0.0,
            east: vec![1.0, 0.0],
            north: vec![0.0, 1.0],
            up: vec![2.0, 3.0],
        };
        for (degrees, x, y) in [(90.0, [1.0, 0.0], [0.0, 1.0]), (0.0, [0.0, 1.0], [-1.0, 0.0])] {
            let axes = ground.model_axes(f64::to_radians(degrees));
            for i in 0..2 {
                assert_eq!((axes[0][i], axes[1][i]), (x[i], y[i]), "{degrees}");
            }
            assert_eq!(axes[2], [2.0, 3.0]);
        }
    }

    #[test]
    fn missing_parts_are_zero_and_sets_that_do_not_fit_are_refused() {
        let east = channel(Some(Orientation::EAST), wave(0.3));
        let ground = Geographic::from_parts(Some(&east), None, Some(&east)).unwrap();
        assert_eq!((&ground.east, &ground.north, &ground.up), (&wave(0.3), &vec![0.0; 50], &wave(0.3)));
        assert!(Geographic::from_parts(None, None, None).is_err());
        let parallel = channel(Some(Orientation::from_degrees(275.0)), wave(0.1));
        let blind = channel(None, wave(0.1));
        let unknown = channel(Some(Orientation::Azimuth(f64::NAN)), wave(0.1));
        for set in [
            vec![],
            vec![east.clone()],
            vec![east.clone(), parallel],
            vec![east.clone(), blind],
            vec![east, unknown],
        ] {
            assert!(Geographic::from_channels(&set).is_err());
        }
    }
}
