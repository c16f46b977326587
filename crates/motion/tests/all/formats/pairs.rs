//! Pairs of time and acceleration at unequal intervals, through the reader of SMC files.

use tremolite_motion::{Channel, ReadOptions};

use super::figures::{parse, refusal};
use super::smc;

fn read(points: &[[f64; 2]]) -> Channel {
    parse(&smc::pairs(points), &ReadOptions::default()).unwrap().remove(0)
}

#[test]
fn lines_between_points_are_sampled_from_the_first_time_on() {
    let channel = read(&[[1.002, 100.0], [1.012, 300.0], [1.016, 0.0], [1.026, -100.0]]);
    assert_eq!((channel.start, channel.dt), (1.002, 0.005));
    let expected = [1.0, 2.0, 3.0, -0.1, -0.6];
    assert_eq!(channel.acceleration.len(), expected.len());
    for (a, e) in channel.acceleration.iter().zip(expected) {
        assert!((a - e).abs() < 1e-9, "{:?}", channel.acceleration);
    }
    let remark = &channel.remarks[0];
    for part in
        ["4 pairs", "0.008 s apart on average and 0.01 s at most", "every 0.005 s", "above 100 Hz is lost"]
    {
        assert!(remark.contains(part), "{remark}");
    }
}

#[test]
fn points_at_equal_intervals_are_taken_as_they_are() {
    // Steps of 0.02 s within 1 %.
    let channel = read(&[[0.0, 1.0], [0.0201, 2.0], [0.04, 3.0], [0.06, 4.0]]);
    assert_eq!((channel.dt, channel.acceleration.as_slice()), (0.02, &[0.01, 0.02, 0.03, 0.04][..]));
    assert!(channel.remarks[0].contains("equally spaced"), "{:?}", channel.remarks);
    assert_eq!(read(&[[0.0, 1.0], [0.0203, 2.0], [0.04, 3.0], [0.06, 4.0]]).dt, 0.005, "1.5 % off");
}

#[test]
fn points_that_do_not_advance_are_left_out_and_jumps_are_refused() {
    let channel =
        read(&[[0.0, 0.0], [0.01, 100.0], [0.01, 900.0], [0.004, 900.0], [0.02, 300.0], [0.035, 0.0]]);
    assert!((channel.acceleration[2] - 1.0).abs() < 1e-12 && (channel.acceleration[3] - 2.0).abs() < 1e-12);
    assert!(channel.remarks[0].contains("2 of them did not advance"), "{:?}", channel.remarks);
    let jump = |t: f64| refusal(&smc::pairs(&[[0.0, 0.0], [0.5, 1.0], [1.0, 2.0], [1.5, 3.0], [t, 4.0]]));
    assert!(jump(1.489).contains("line 30: the time jumps back to 1.489 s"), "{}", jump(1.489));
    assert!(jump(6.6).contains("line 30: the time jumps ahead to 6.6 s"), "{}", jump(6.6));
    assert!(refusal(&smc::pairs(&[[1.0, 0.0], [1.0, 1.0]])).contains("at least two"));
}

#[test]
fn a_declared_interval_must_be_the_one_of_the_samples() {
    let text = smc::pairs(&[[0.0, 0.0], [0.01, 1.0], [0.03, 2.0]]);
    let with = |dt| parse(&text, &ReadOptions { dt: Some(dt), ..ReadOptions::default() });
    assert_eq!(with(0.005).unwrap()[0].dt, 0.005);
    assert!(with(0.01).unwrap_err().to_string().contains("dt = \"0.01 s\""));
}
