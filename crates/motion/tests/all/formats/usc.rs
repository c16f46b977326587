//! Volumes 1 and 2 of the University of Southern California.

use tremolite_motion::{Orientation, ReadOptions, Units};

use super::figures::{Figures, azimuth, compare, parse, refusal};

/// A component of volume 1, times and accelerations of `G/10` in columns of 7 behind a blank.
pub fn small_pairs() -> String {
    let mut text =
        String::from("FILE     1 OF UNCORRECTED ACCELEROGRAM DATA OF VOLUME I:                  VOL1\n");
    for line in 2..=13 {
        let line = match line {
            7 => "COMP  UP                                                                9 VOL1",
            11 => "NO. OF POINTS =      7      DURATION =   0.050 SEC                      50VOL1",
            12 => "UNITS ARE SEC AND G/10                                                  22VOL1",
            _ => "TEXT                                                                    10",
        };
        text += &format!("{line}\n");
    }
    text += &format!("{}\n", "    0".repeat(16)).repeat(7);
    text += &"      .039      .608    34.696      .300      .100     1.870    34.213   118.537\n".repeat(7);
    text + "    .000   .066   .010   .166   .020  -.834   .030 -1.234   .040  -.034\n    .040   .500   .055   .100\n"
}

#[test]
fn volume_1_is_joined_by_straight_lines() {
    let both = small_pairs() + &small_pairs().replace("COMP  UP ", "COMP N08W");
    let channels = parse(&both, &ReadOptions::default()).unwrap();
    assert_eq!((channels[0].orientation, channels[1].orientation), (Some(Orientation::Up), azimuth(352.0)));
    for channel in channels {
        assert_eq!((channel.dt, channel.start, channel.units), (0.005, 0.0, Units::G));
        // The second of the two points at 0.040 s does not advance and is left out.
        let tenths = [
            0.066,
            0.116,
            0.166,
            -0.334,
            -0.834,
            -1.034,
            -1.234,
            -0.634,
            -0.034,
            -0.034 + 0.134 / 3.0,
            -0.034 + 0.268 / 3.0,
            0.1,
        ];
        assert_eq!(channel.acceleration.len(), 12);
        for (a, e) in channel.acceleration.iter().zip(tenths) {
            assert!((a - 0.980665 * e).abs() < 1e-14, "{:?}", channel.acceleration);
        }
        assert!(
            channel.remarks[1].contains("7 pairs")
                && channel.remarks[1].contains("1 of them did not advance")
        );
    }
}

#[test]
fn faults_of_volume_1_are_named_with_their_line() {
    let good = small_pairs();
    for (text, parts) in [
        (good.replace(" .500   .055", "  NaN   .055"), ["line 29: 5 of the 7 pairs", "fetch"]),
        (good.replace("   .055   .100", "   .055"), ["line 29: 5 of the 7 pairs", "fetch"]),
        (good.replace(" 7      DUR", " 9      DUR"), ["line 30: 7 of the 9 pairs", "fetch"]),
        (good.replace("   .055", "   .025"), ["line 29", "jumps back to 0.025 s"]),
        (good.replace("   .055", " 95.055"), ["line 29", "jumps ahead to 95.055 s"]),
        (good.replace("UNITS ARE", "THEY ARE"), ["line 1", "units = \"g\""]),
    ] {
        let message = refusal(&text);
        assert!(parts.iter().all(|p| message.contains(p)), "{parts:?}: {message}");
    }
}

/// Figures of a few lines of Python that cut the 236 lines under 'POINTS OF ACC' into words of ten characters. The header
/// states the peak with the other sign, as -242.39450 at 4.580 s, and so does its real 66; the numbers have 242.395 there.
#[test]
fn big_tujunga_volume_2() {
    compare(
        "usc_v1/017m30bt.s0a",
        Units::CentimetrePerSecond2,
        &[Figures {
            name: "017m30bt N08W",
            npts: 1887,
            dt: 0.02,
            peak: (242.395, 229),
            first: -1.133,
            last: 2.032,
            sum: 320.091,
            orientation: azimuth(352.0),
        }],
    );
}
