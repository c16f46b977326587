//! Records digitised from film: pairs of time and acceleration at unequal intervals.
//!
//! Volume 1 of the strong-motion archives holds the points that were digitised; between them the trace is a straight line
//! (Trifunac and Lee 1973). Everything that is done with a record here needs equal intervals, so the lines are sampled every
//! 0.005 s, which is the custom of the field (USGS gmprocess does so too).

use super::source::Source;
use crate::Error;

/// Interval (s) at which the lines between unequally spaced points are sampled.
const INTERVAL: f64 = 0.005;
/// Points are equally spaced if no step differs from the mean by more than this part.
const EQUAL: f64 = 0.01;
/// A point may lie this far (s) before the one in front of it: a pen's width on film. It is left out.
const SLIP: f64 = 0.01;
/// Points further apart (s) than this are not joined: part of the record is missing.
const GAP: f64 = 5.0;
/// More samples than this (14 hours) are no record.
const MOST: f64 = 1e7;

/// A record at equal intervals.
#[derive(Debug)]
pub(super) struct Even {
    /// Time of the first point (s).
    pub start: f64,
    /// Interval (s).
    pub dt: f64,
    /// Samples, in the file's unit.
    pub values: Vec<f64>,
    /// What was done, for the channel's remarks.
    pub remark: String,
}

/// Brings pairs, `numbers` being time, value, time, value …, to equal intervals from the first time on.
///
/// A point at the time of the one in front of it, or up to 0.01 s before it, is left out. `line` tells the line index of each
/// pair, and `declared` is the interval the user declared, if any.
///
/// # Errors
/// At the line of a pair whose time goes back further than that or comes more than 5 s after the one in front; and for fewer
/// than two points.
pub(super) fn equal_intervals(
    source: &Source,
    numbers: &[f64],
    line: impl Fn(usize) -> usize,
    declared: Option<f64>,
) -> Result<Even, Error> {
    let mut points: Vec<[f64; 2]> = Vec::with_capacity(numbers.len() / 2);
    for (i, pair) in numbers.chunks_exact(2).enumerate() {
        let [time, value] = [pair[0], pair[1]];
        let step = points.last().map_or(GAP, |last| time - last[0]);
        if !(-SLIP..=GAP).contains(&step) {
            let way = if step > 0.0 { "ahead" } else { "back" };
            return Err(source.error(
                line(i),
                format!("the time jumps {way} to {time} s"),
                "correct the time, or cut the record there",
            ));
        }
        if step > 0.0 {
            points.push([time, value]);
        }
    }
    let ([first, _], [last, _], true) = (
        points.first().copied().unwrap_or_default(),
        points.last().copied().unwrap_or_default(),
        points.len() >= 2,
    ) else {
        return Err(source.error(line(0), "fewer than two times were found", "a record needs at least two"));
    };
    let mean = (last - first) / (points.len() - 1) as f64;
    let steps = || points.windows(2).map(|p| p[1][0] - p[0][0]);
    let left_out = numbers.len() / 2 - points.len();
    let mut remark = format!(
        "The file holds {} pairs of time and acceleration, {} s apart on average",
        numbers.len() / 2,
        rounded(mean, 3)
    );
    let (dt, values) = if steps().all(|step| (step - mean).abs() <= EQUAL * mean) {
        remark += "; they are equally spaced and were taken as they are.";
        (rounded(mean, 6), points.iter().map(|p| p[1]).collect())
    } else {
        let count = ((last - first) / INTERVAL + 1e-6).floor();
        if !(count < MOST) {
            return Err(source.error(
                line(0),
                format!("the times run from {first} s to {last} s"),
                "this is no record; check the times",
            ));
        }
        remark += &format!(
            " and {} s at most; they were joined by straight lines and sampled every {INTERVAL} s, so content above \
             {} Hz is lost.",
            rounded(steps().fold(0.0, f64::max), 3),
            0.5 / INTERVAL
        );
        (INTERVAL, sampled(&points, count as usize + 1))
    };
    if left_out > 0 {
        remark += &format!(" {left_out} of them did not advance in time and were left out.");
    }
    let dt = source.stated_interval(line(0), dt, declared)?;
    Ok(Even { start: first, dt, values, remark })
}

/// The straight lines between points, `count` times from the first.
fn sampled(points: &[[f64; 2]], count: usize) -> Vec<f64> {
    let mut at = 0;
    let value = |i: usize| {
        let time = points[0][0] + i as f64 * INTERVAL;
        // The last line serves for round-off beyond the last point.
        while at + 2 < points.len() && points[at + 1][0] <= time {
            at += 1;
        }
        let ([t0, a0], [t1, a1]) = (points[at], points[at + 1]);
        let x = ((time - t0) / (t1 - t0)).clamp(0.0, 1.0);
        a0 * (1.0 - x) + a1 * x
    };
    (0..count).map(value).collect()
}

/// A number to so many significant figures.
fn rounded(x: f64, figures: usize) -> f64 {
    format!("{x:.*e}", figures - 1).parse().unwrap_or(x)
}
