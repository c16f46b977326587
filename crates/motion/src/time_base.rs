//! One time base for the components of a record.

use crate::interpolate::between;
use crate::{Channel, Error};

/// Sampling intervals that differ by less than this part are one, rounded differently by the headers of two files.
const EQUAL_INTERVALS: f64 = 1e-6;

/// Samples that lie nearer to another channel's than this part of an interval are at its times.
const EQUAL_TIMES: f64 = 0.01;

/// Puts channels on one time base and cuts them to the span they share, so that equal indices are equal times.
///
/// The base is that of the channel with the shortest sampling interval, the first of them if there are several. Channels on it
/// already, within a millionth of the interval and a hundredth of a sample, keep their samples bit for bit. The others are
/// interpolated: band-limited, by a Kaiser-windowed sinc over 64 of their own samples, with an error below 3·10⁻⁵ for what is slower
/// than 0.9 of their own Nyquist frequency and further from their ends than 32 samples; nothing is added above it. Each of them
/// says so in its `remarks`.
///
/// # Errors
/// [`Error::Unsuitable`] if there is no channel, or no common span of at least two samples.
pub fn common_time_base(channels: &[&Channel]) -> Result<Vec<Channel>, Error> {
    let finest = channels.iter().map(|c| c.dt).fold(f64::INFINITY, f64::min);
    let Some(base) = channels.iter().find(|c| c.dt <= finest * (1.0 + EQUAL_INTERVALS)) else {
        return Err(Error::unsuitable("no component was given", "name at least one record"));
    };
    let fits: Vec<Fit> = channels.iter().map(|c| Fit::of(c, base)).collect();
    let first = fits.iter().map(|f| f.first).fold(f64::NEG_INFINITY, f64::max);
    let last = fits.iter().map(|f| f.last).fold(f64::INFINITY, f64::min);
    // Negated, so that times which are no numbers, and which neither maximum nor minimum sees, are refused as well.
    if !(last - first >= 1.0 && fits.iter().all(|f| f.first <= first && last <= f.last)) {
        let late = channels.iter().zip(&fits).find(|(_, f)| f.first == first);
        let name = late.map_or("", |(c, _)| &c.name);
        return Err(Error::unsuitable(
            format!("the components have no span of time in common ('{name}' and others)"),
            "check that they belong to one event and have the same zero of time",
        ));
    }
    // Both lie within every channel, the base among them, so they are indices of its samples and not more than it has.
    let count = (last - first) as usize + 1;
    Ok(channels
        .iter()
        .zip(&fits)
        .map(|(channel, fit)| match fit.same {
            true => {
                let skip = (first - fit.first) as usize;
                let kept = channel.acceleration.iter().skip(skip).take(count).copied().collect();
                channel.at(skip as f64 * channel.dt, kept)
            }
            false => interpolated(channel, base, first, count),
        })
        .collect())
}

/// Where a channel lies on the base, in samples of the base from its first one: whole numbers.
struct Fit {
    /// The first and the last of the base's times that the channel reaches.
    first: f64,
    last: f64,
    /// Whether its samples are at the base's times.
    same: bool,
}

impl Fit {
    fn of(channel: &Channel, base: &Channel) -> Fit {
        let shift = (channel.start - base.start) / base.dt;
        let last = channel.acceleration.len() as f64 - 1.0;
        let same = (channel.dt - base.dt).abs() <= EQUAL_INTERVALS * base.dt
            && (shift - shift.round()).abs() < EQUAL_TIMES;
        if same {
            Fit { first: shift.round(), last: shift.round() + last, same }
        } else {
            // A thousandth allows for round-off in the times.
            let end = shift + last * (channel.dt / base.dt);
            Fit { first: (shift - 1e-3).ceil(), last: (end + 1e-3).floor(), same }
        }
    }
}

/// A channel at `count` times of the base from its sample `first` on.
fn interpolated(channel: &Channel, base: &Channel, first: f64, count: usize) -> Channel {
    let later = base.start - channel.start + first * base.dt;
    let samples = (0..count)
        .map(|i| between(&channel.acceleration, (later + i as f64 * base.dt) / channel.dt))
        .collect();
    let what = if (channel.dt - base.dt).abs() <= EQUAL_INTERVALS * base.dt {
        format!("moved by a part of the sampling interval, to the times of '{}'", base.name)
    } else {
        format!("interpolated from an interval of {} s to the {} s of '{}'", channel.dt, base.dt, base.name)
    };
    let mut made = Channel { dt: base.dt, ..channel.at(later, samples) };
    made.remarks.push(format!("the samples of '{}' were {what} (band-limited)", channel.name));
    made
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn ramp(start: f64, dt: f64, count: usize) -> Channel {
        let acceleration = (0..count).map(|i| start + i as f64 * dt).collect();
        Channel { start, ..Channel::new("ramp", dt, acceleration) }
    }

    /// A motion of several frequencies to 30 Hz that comes and goes, sampled.
    fn motion(start: f64, dt: f64, count: usize) -> Channel {
        let at = |t: f64| {
            let burst = (-((t - 5.0) / 1.5).powi(2)).exp();
            burst * [0.4, 1.3, 5.0, 12.0, 30.0].iter().map(|f| (2.0 * PI * f * t).sin()).sum::<f64>()
        };
        let acceleration = (0..count).map(|i| at(start + i as f64 * dt)).collect();
        Channel { start, ..Channel::new(format!("motion {dt}"), dt, acceleration) }
    }

    #[test]
    fn components_are_cut_to_their_common_span() {
        let (a, b) = (ramp(0.0, 0.01, 101), ramp(0.20, 0.01, 101));
        let cut = common_time_base(&[&a, &b]).unwrap();
        assert_eq!(
            (&cut[0].acceleration[..], &cut[1].acceleration[..]),
            (&a.acceleration[20..], &b.acceleration[..81])
        );
        assert!((cut[0].start - 0.2).abs() < 1e-12 && cut[1].start == 0.2);
        assert!(cut.iter().all(|c| c.remarks.is_empty()));
    }

    #[test]
    fn equal_grids_keep_their_bits_however_headers_round_them() {
        let a = motion(0.0, 0.005, 2001);
        let b = Channel { dt: 0.005 * (1.0 - 5e-7), start: 4e-5, ..motion(0.0, 0.005, 2001) };
        for cut in [common_time_base(&[&a, &b]).unwrap(), common_time_base(&[&b, &a]).unwrap()] {
            assert!(cut.iter().all(|c| c.acceleration == a.acceleration && c.remarks.is_empty()));
        }
    }

    #[test]
    fn two_samplings_of_one_motion_agree_on_the_finer_base() {
        let (coarse, fine) = (motion(0.0, 0.01, 1001), motion(0.0, 0.005, 2001));
        for order in [[&coarse, &fine], [&fine, &coarse]] {
            let both = common_time_base(&order).unwrap();
            assert_eq!((both[0].dt, both[1].dt), (0.005, 0.005));
            assert_eq!((both[0].acceleration.len(), both[1].acceleration.len()), (2001, 2001));
            let worst = both[0].acceleration.iter().zip(&both[1].acceleration);
            let worst = worst.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max);
            println!("100 Hz against 200 Hz: {worst:.1e} of a peak near 4");
            // The highest, 30 Hz, is at 0.6 of the coarser Nyquist: 5e-6 of each of the five.
            assert!(worst < 2.5e-5, "{worst:e}");
            let changed: Vec<&Channel> = both.iter().filter(|c| !c.remarks.is_empty()).collect();
            assert_eq!(changed.len(), 1);
            assert!(
                changed[0].name == "motion 0.01" && changed[0].remarks[0].contains("0.01 s to the 0.005 s")
            );
        }
    }

    #[test]
    fn samples_between_samples_are_moved_to_the_times_of_the_first() {
        let (a, b) = (motion(0.0, 0.01, 1001), motion(0.205, 0.01, 900));
        let both = common_time_base(&[&a, &b]).unwrap();
        assert_eq!((both[0].acceleration.len(), both[1].acceleration.len()), (899, 899));
        assert!(
            both[0].remarks.is_empty() && both[1].remarks[0].contains("'motion 0.01'"),
            "{:?}",
            both[1].remarks
        );
        for c in &both {
            assert!((c.start - 0.21).abs() < 1e-12 && (c.end() - 9.19).abs() < 1e-12);
        }
        for (x, y) in both[0].acceleration.iter().zip(&both[1].acceleration) {
            assert!((x - y).abs() < 1e-4, "{x} {y}");
        }
    }

    #[test]
    fn channels_without_a_common_span_are_refused_with_the_way_out() {
        let a = ramp(0.0, 0.01, 101);
        for b in [ramp(f64::MAX, 0.01, 3), ramp(5.0, 0.01, 3), ramp(1.0, 0.02, 5), ramp(-0.5, 0.5, 2)] {
            for order in [[&a, &b], [&b, &a]] {
                let message = common_time_base(&order).unwrap_err().to_string();
                assert!(
                    message.contains("no span of time in common") && message.contains("one event"),
                    "{message}"
                );
            }
        }
        assert!(common_time_base(&[]).is_err());
        assert!(common_time_base(&[&a, &Channel { start: f64::NAN, ..a.clone() }]).is_err());
        // A hostile ratio of intervals makes no more samples than there are.
        let b = ramp(0.0, 1e6, 3);
        assert_eq!(common_time_base(&[&a, &b]).unwrap()[1].acceleration.len(), 101);
    }
}
