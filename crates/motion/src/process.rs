//! Processing of a record, written as data so that a case file can hold it and a report can print it.

mod notation;

use crate::baseline::{bring_to_rest, detrend_linear, taper};
use crate::intensity::peak;
use crate::interpolate::between;
use crate::polynomial::detrend_polynomial;
use crate::sensitivity::REMEDY;
use crate::shown::rounded;
use crate::{Band, Channel, Error, Filter, Orientation, TargetSpectrum, Units, matched};

/// One step of processing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Process {
    /// Takes off the straight line of best fit (least squares).
    DetrendLinear,
    /// Brings velocity and displacement to zero at the end by a slow, smooth correction of the acceleration, so
    /// that a window cut from a record does not drift. Its period is the record's length, so it does not touch the
    /// shaking; whatever permanent displacement the record had is lost.
    Baseline,
    /// Takes off the polynomial of this degree (1 to 10) that fits the *acceleration* best (least squares), as the baseline
    /// correction of SeismoSignal does (its help; degrees to 3 there) and ObsPy's `detrend("polynomial", order=…)`. Degree 1 is
    /// [`DetrendLinear`](Process::DetrendLinear). It does not bring the motion to rest, as [`Baseline`](Process::Baseline)
    /// does. It is not PEER's correction (Ancheta and others, 2013; `baseline_sixth_order` of gmprocess), which
    /// fits the displacement.
    BaselinePolynomial { degree: usize },
    /// Takes the mean of the first seconds off the whole record: the sensor's offset, as seen before the
    /// first wave. Both ends of the time are included, and at least two samples are in it.
    PreEvent { seconds: f64 },
    /// Fades in and out with half a cosine wave of this length (s) at both ends.
    Taper { seconds: f64 },
    /// Fourth-order Butterworth high-pass, forwards and backwards; corner (Hz).
    Highpass { hz: f64 },
    /// Fourth-order Butterworth low-pass, forwards and backwards; corner (Hz).
    Lowpass { hz: f64 },
    /// Fourth-order Butterworth band-pass (eight poles), forwards and backwards; corners (Hz).
    Bandpass { low: f64, high: f64 },
    /// Samples this many seconds apart, closer than they were: the band-limited course between the samples
    /// ([`common_time_base`](crate::common_time_base)), where a model else takes the acceleration as linear. Straight lines between
    /// samples Δt apart leave sinc²(fΔt) of the amplitude at a frequency f.
    Resample { seconds: f64 },
    /// Multiplies by a number.
    Scale(f64),
    /// Multiplies all channels by the one factor that brings the largest |a| among them to this value, in these units: the
    /// component that shakes most comes to it and the others keep their ratio to it. Not for channels in counts.
    PeakAcceleration { value: f64, units: Units },
    /// Matches each channel in time to a target spectrum ([`matched`]), from one period (s) to the other or wherever the target says
    /// something, within [`MATCHED`]. Channels are sampled twenty times in the shortest period then.
    Match { band: Option<[f64; 2]> },
}

/// How near to a target [`Process::Match`] comes, Sa/target − 1 at 200 periods that were not matched.
pub const MATCHED: f64 = 0.05;

/// How much closer samples may be made.
const MOST_FINER: f64 = 1000.0;

impl Process {
    /// Applies the step to the channels of one record in place: to each by itself, but for
    /// [`PeakAcceleration`](Process::PeakAcceleration).
    ///
    /// # Errors
    /// [`Error::Process`] if a sensor does not record acceleration, a corner is not below the Nyquist frequency, the corners
    /// are not in order, the record is not longer than the filter's padding ([`Filter::padding`]), than two tapers or than the
    /// time before the event, has too few samples for the polynomial, if nothing shakes that could be scaled, or values leave
    /// the range of numbers. All channels are then as before.
    pub fn apply(&self, channels: &mut [&mut Channel]) -> Result<(), Error> {
        self.apply_towards(channels, None)
    }

    /// The same with the target that [`Process::Match`] asks for; other steps do not look at it.
    ///
    /// # Errors
    /// As [`apply`](Process::apply), and where a channel cannot be matched: there is no target, the channel says that it is vertical,
    /// the target being one of horizontal motion, or it comes no nearer.
    pub fn apply_towards(
        &self,
        channels: &mut [&mut Channel],
        target: Option<&TargetSpectrum>,
    ) -> Result<(), Error> {
        for channel in &*channels {
            if let Err(Error::Unsuitable { problem, remedy }) = channel.of_accelerometer() {
                return Err(self.refusal(channel, problem, remedy));
            }
        }
        if let Process::Match { band } = *self {
            return self.fitted(channels, target, band);
        }
        let factor = match *self {
            Process::PeakAcceleration { value, units } => self.factor(channels, value, units)?,
            _ => 1.0,
        };
        let mut all = Vec::with_capacity(channels.len());
        for channel in &*channels {
            let values = self.of_one(channel, factor)?;
            if values.iter().any(|v| !v.is_finite()) {
                return Err(self.refusal(
                    channel,
                    "the result is not finite",
                    "check the record's values and the numbers of this step",
                ));
            }
            all.push(values);
        }
        for (channel, values) in channels.iter_mut().zip(all) {
            channel.acceleration = values;
            if let Process::Resample { seconds } = *self {
                channel.dt = seconds;
            }
        }
        Ok(())
    }

    fn fitted(
        &self,
        channels: &mut [&mut Channel],
        target: Option<&TargetSpectrum>,
        band: Option<[f64; 2]>,
    ) -> Result<(), Error> {
        let Some(first) = channels.first() else { return Ok(()) };
        let target = target.ok_or_else(|| {
            self.refusal(
                first,
                "there is no target that it could be matched to",
                "give the spectrum as the target",
            )
        })?;
        let told = |channel: &Channel, e: Error| {
            let (problem, remedy) = e.message_and_remedy();
            self.refusal(channel, problem, remedy)
        };
        let band = target.band(band).map_err(|e| told(first, e))?;
        let mut all = Vec::with_capacity(channels.len());
        for channel in &*channels {
            if channel.orientation == Some(Orientation::Up) {
                return Err(self.refusal(
                    channel,
                    "the channel is vertical, and the target is a spectrum of horizontal motion",
                    "match the horizontal channels alone",
                ));
            }
            let made = matched(channel, target, band, MATCHED).map_err(|e| told(channel, e))?;
            all.push(made.channel);
        }
        for (channel, made) in channels.iter_mut().zip(all) {
            channel.dt = made.dt;
            channel.acceleration = made.acceleration;
        }
        Ok(())
    }

    fn refusal(&self, channel: &Channel, problem: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error::Process {
            channel: channel.name.clone(),
            step: self.to_string(),
            problem: problem.into(),
            remedy: remedy.into(),
        }
    }

    /// What brings the largest |a| of the channels to `value`.
    fn factor(&self, channels: &[&mut Channel], value: f64, units: Units) -> Result<f64, Error> {
        if let Some(raw) = channels.iter().find(|c| c.raw) {
            return Err(self.refusal(
                raw,
                "the record is in counts, and nothing says what a count is",
                REMEDY,
            ));
        }
        let largest = channels.iter().map(|c| peak(&c.acceleration)).fold(0.0, f64::max);
        match (channels.first(), units.factor()) {
            (Some(first), _) if largest == 0.0 => Err(self.refusal(
                first,
                "the record is zero everywhere, so no factor brings it to a peak",
                "check the record, its window and the steps before",
            )),
            (Some(first), None) => Err(self.refusal(first, "a peak in counts", "give it in m/s2 or g")),
            (_, unit) => Ok(value * unit.unwrap_or(1.0) / largest),
        }
    }

    /// The channel's samples after the step; `factor` is that of a peak that was asked for.
    fn of_one(&self, channel: &Channel, factor: f64) -> Result<Vec<f64>, Error> {
        let count = channel.acceleration.len();
        let filtered = |band: Band| -> Result<Vec<f64>, Error> {
            let filter = Filter::design(band, channel.dt)
                .map_err(|[problem, remedy]| self.refusal(channel, problem, remedy))?;
            filter.zero_phase(&channel.acceleration).ok_or_else(|| {
                let problem = format!(
                    "the record has {count} samples and the filter needs more than {}",
                    filter.padding()
                );
                self.refusal(channel, problem, "take a longer window")
            })
        };
        let mut values = channel.acceleration.clone();
        match *self {
            Process::Highpass { hz } => values = filtered(Band::High(hz))?,
            Process::Lowpass { hz } => values = filtered(Band::Low(hz))?,
            Process::Bandpass { low, high } => values = filtered(Band::Pass(low, high))?,
            Process::DetrendLinear => detrend_linear(&mut values),
            Process::Baseline => bring_to_rest(&mut values, channel.dt),
            Process::BaselinePolynomial { degree } => {
                if count <= degree + 1 {
                    return Err(self.refusal(
                        channel,
                        format!(
                            "the record has {count} samples, and the polynomial {} coefficients",
                            degree + 1
                        ),
                        "take a lower degree or a longer window",
                    ));
                }
                detrend_polynomial(&mut values, degree);
            }
            Process::PreEvent { seconds } => {
                // The cast saturates; a thousandth of an interval is allowed for round-off, as in a window.
                let before = ((seconds / channel.dt + 1e-3).floor() as usize).saturating_add(1);
                if !(before >= 2 && before <= count) {
                    let problem = format!(
                        "the record lasts {} s in samples {} s apart, and the time before the event needs two of \
                         them and ends within the record",
                        rounded(channel.duration()),
                        channel.dt
                    );
                    return Err(self.refusal(
                        channel,
                        problem,
                        "give the seconds before the first wave arrives",
                    ));
                }
                let mean = values[..before].iter().sum::<f64>() / before as f64;
                values.iter_mut().for_each(|v| *v -= mean);
            }
            Process::Taper { seconds } => {
                if !(seconds > 0.0 && 2.0 * seconds <= channel.duration()) {
                    return Err(self.refusal(
                        channel,
                        format!("the record lasts {} s, less than two tapers", rounded(channel.duration())),
                        "shorten the taper or take a longer window",
                    ));
                }
                taper(&mut values, channel.dt, seconds);
            }
            Process::Resample { seconds } => {
                let finer = channel.dt / seconds;
                if !((1.0..=MOST_FINER).contains(&finer)) {
                    return Err(self.refusal(
                        channel,
                        format!("the samples lie {} s apart", rounded(channel.dt)),
                        "give an interval that is shorter, to a thousandth of that",
                    ));
                }
                // A thousandth of an interval is allowed for round-off in the length.
                let last = ((count - 1) as f64 * finer + 1e-3).floor() as usize;
                values = (0..=last).map(|i| between(&channel.acceleration, i as f64 / finer)).collect();
            }
            Process::Scale(number) => values.iter_mut().for_each(|v| *v *= number),
            // All channels have it from `fitted`.
            Process::Match { .. } => {}
            Process::PeakAcceleration { .. } => values.iter_mut().for_each(|v| *v *= factor),
        }
        Ok(values)
    }
}

/// Applies the steps in order to the channels of one record. They belong together for
/// [`Process::PeakAcceleration`] alone, which keeps the ratio of the components.
///
/// # Errors
/// That of the first step that cannot be applied (see [`Process::apply`]); earlier steps stay applied.
pub fn process(channels: &mut [&mut Channel], steps: &[Process]) -> Result<(), Error> {
    steps.iter().try_for_each(|step| step.apply(channels))
}

/// The same with the target that [`Process::Match`] asks for.
///
/// # Errors
/// That of the first step that cannot be applied (see [`Process::apply_towards`]); earlier steps stay applied.
pub fn process_towards(
    channels: &mut [&mut Channel],
    steps: &[Process],
    target: Option<&TargetSpectrum>,
) -> Result<(), Error> {
    steps.iter().try_for_each(|step| step.apply_towards(channels, target))
}

/// The lowest upper corner (Hz) among the steps: what the user cut off on purpose. `None` without a low-pass.
pub fn lowest_lowpass(steps: &[Process]) -> Option<f64> {
    steps
        .iter()
        .filter_map(|step| match step {
            Process::Lowpass { hz } => Some(*hz),
            Process::Bandpass { high, .. } => Some(*high),
            _ => None,
        })
        .min_by(f64::total_cmp)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::STANDARD_GRAVITY;

    fn channel(acceleration: Vec<f64>) -> Channel {
        Channel::new("test", 0.01, acceleration)
    }

    /// Twenty points a period, and the sine itself between them; a straight line would leave sinc² 0.2, 87 %, of it.
    #[test]
    fn samples_between_samples_are_those_of_the_band_limited_course() {
        let sine = |t: f64| (2.0 * std::f64::consts::PI * 10.0 * t).sin();
        let coarse: Vec<f64> = (0..401).map(|k| sine(0.02 * f64::from(k))).collect();
        let mut record = Channel::new("sine", 0.02, coarse.clone());
        Process::Resample { seconds: 0.0025 }.apply(&mut [&mut record]).unwrap();
        assert_eq!((record.dt, record.acceleration.len()), (0.0025, 3201));
        for (k, a) in record.acceleration.iter().enumerate() {
            if k % 8 == 0 {
                assert_eq!(*a, coarse[k / 8]);
            }
            if (300..2900).contains(&k) {
                assert!((a - sine(0.0025 * k as f64)).abs() < 1e-4, "{k}: {a}");
            }
        }
        for seconds in [0.021, 1e-9] {
            let message =
                Process::Resample { seconds }.apply(&mut [&mut record.clone()]).unwrap_err().to_string();
            assert!(message.contains("samples lie 0.0025 s apart"), "{message}");
        }
    }

    #[test]
    fn steps_apply_in_order() {
        let mut record = channel((0..101).map(|i| 1.0 + 0.1 * f64::from(i)).collect());
        let mut other = record.clone();
        process(&mut [&mut record], &[Process::DetrendLinear, Process::Taper { seconds: 0.2 }]).unwrap();
        process(&mut [&mut other], &[Process::Taper { seconds: 0.2 }, Process::DetrendLinear]).unwrap();
        assert!(record.acceleration.iter().all(|a| a.abs() < 1e-12));
        assert!(other.acceleration.iter().any(|a| a.abs() > 0.1));
    }

    #[test]
    fn a_refused_step_says_why_and_leaves_the_record_alone() {
        let record = channel((0..27).map(f64::from).collect());
        for (step, word) in [
            (Process::Lowpass { hz: 60.0 }, "Nyquist"),
            (Process::Bandpass { low: 5.0, high: 5.0 }, "lower corner"),
            (Process::Bandpass { low: 1.0, high: 5.0 }, "27 samples"),
            (Process::Taper { seconds: 0.14 }, "two tapers"),
            (Process::Scale(1e308), "finite"),
            (Process::PeakAcceleration { value: 1e308, units: Units::G }, "finite"),
            (Process::PeakAcceleration { value: 1.0, units: Units::Counts }, "in counts"),
            (Process::PreEvent { seconds: 0.27 }, "lasts 0.26 s"),
            (Process::PreEvent { seconds: 0.009 }, "needs two"),
            (Process::PreEvent { seconds: f64::NAN }, "needs two"),
            (Process::BaselinePolynomial { degree: 26 }, "27 coefficients"),
        ] {
            // The second channel alone is at fault in some, and the first must not be touched either.
            let long = channel(vec![1.0; 200]);
            let (mut first, mut touched) = (long.clone(), record.clone());
            let message = step.apply(&mut [&mut first, &mut touched]).unwrap_err().to_string();
            assert!(message.contains(word) && message.contains("test"), "{message}");
            assert_eq!((first, touched), (long, record.clone()));
        }
    }

    #[test]
    fn the_mean_before_the_event_comes_off_the_whole_record() {
        // 0.5 for 21 samples, both ends included, and something else behind.
        let mut record = channel((0..101).map(|i| if i <= 20 { 0.5 } else { 3.0 }).collect());
        Process::PreEvent { seconds: 0.2 }.apply(&mut [&mut record]).unwrap();
        assert!(record.acceleration[..=20].iter().all(|a| *a == 0.0));
        assert!(record.acceleration[21..].iter().all(|a| *a == 2.5));
        let mut whole = channel((0..101).map(f64::from).collect());
        Process::PreEvent { seconds: 1.0 }.apply(&mut [&mut whole]).unwrap();
        assert_eq!((whole.acceleration[0], whole.acceleration[100]), (-50.0, 50.0));
    }

    #[test]
    fn the_largest_component_comes_to_the_peak_and_the_others_keep_their_ratio() {
        let (mut a, mut b) = (channel(vec![0.0, 1.0, -4.0]), channel(vec![2.0, 0.5, 1.0]));
        Process::PeakAcceleration { value: 0.3, units: Units::G }.apply(&mut [&mut a, &mut b]).unwrap();
        assert!((a.acceleration[2] + 0.3 * STANDARD_GRAVITY).abs() < 1e-15);
        assert!((b.acceleration[0] - 0.15 * STANDARD_GRAVITY).abs() < 1e-15);
        let mut silent = channel(vec![0.0; 3]);
        let step = Process::PeakAcceleration { value: 1.0, units: Units::MetrePerSecond2 };
        let message = step.apply(&mut [&mut silent]).unwrap_err().to_string();
        assert!(message.contains("zero everywhere"), "{message}");
        let mut counts = Channel { raw: true, ..channel(vec![1.0, 5.0]) };
        let message = step.apply(&mut [&mut a, &mut counts]).unwrap_err().to_string();
        assert!(message.contains("counts") && message.contains("sensitivity"), "{message}");
        step.apply(&mut []).unwrap();
    }

    #[test]
    fn no_step_is_applied_to_what_is_no_acceleration() {
        let mut other = Channel { raw: true, other_sensor: true, ..channel(vec![1.0, 5.0]) };
        let before = other.clone();
        let message = Process::Scale(2.0).apply(&mut [&mut other]).unwrap_err().to_string();
        assert!(message.contains("does not record acceleration") && message.contains("HNE"), "{message}");
        assert_eq!(other, before);
    }

    #[test]
    fn times_in_messages_are_without_round_off() {
        let mut record = Channel::new("test", 0.1, vec![0.0; 4]);
        assert_ne!(record.duration().to_string(), "0.3");
        for step in [Process::Taper { seconds: 5.0 }, Process::PreEvent { seconds: 5.0 }] {
            let message = step.apply(&mut [&mut record]).unwrap_err().to_string();
            assert!(message.contains("lasts 0.3 s"), "{message}");
        }
    }

    #[test]
    fn the_lowest_upper_corner_counts() {
        let steps = [Process::Bandpass { low: 0.1, high: 20.0 }, Process::Lowpass { hz: 15.0 }];
        assert_eq!(lowest_lowpass(&steps), Some(15.0));
        assert_eq!(lowest_lowpass(&[Process::DetrendLinear]), None);
    }
}
