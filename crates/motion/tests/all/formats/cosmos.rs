//! COSMOS version 1.20.

use tremolite_motion::{Orientation, ReadOptions, Sensitivity, Units};

use super::figures::{Figures, azimuth, columns, compare, parse, refusal, same};

/// A series whose headers hold -999 but for the integers and reals given by number, under a line that states `head`.
fn series(integers: &[(usize, i64)], reals: &[(usize, f64)], head: &str, numbers: &str) -> String {
    let mut text = String::from("Corrected acceleration    (Format v01.20 with 13 text lines) Src: x\n");
    for line in 2..=13 {
        let line = if line == 9 { "Sta Cha:  1: 340 deg (Rcrdr Chan  1) Location: x" } else { "text" };
        text += &format!("{line}\n");
    }
    let value = |i: usize| integers.iter().find(|(n, _)| *n == i).map_or(-999, |(_, v)| *v);
    text += " 100 Integer-header values follow on  10 lines, Format= (10I8)\n";
    for line in 0..10 {
        text += &((1..=10).map(|i| format!("{:8}", value(10 * line + i))).collect::<String>() + "\n");
    }
    let value = |i: usize| reals.iter().find(|(n, _)| *n == i).map_or(-999.0, |(_, v)| *v);
    text += " 100 Real-header values follow on  17 lines, Format= (6F13.6)\n";
    text += &columns(&(1..=100).map(value).collect::<Vec<f64>>(), 6, 13, 6);
    text += "  1 Comment line(s) follow, each starting with a \"|\":\n| comment\n";
    text + head + "\n" + numbers + "/&  ----------  End of data for channel  1  ----------\n"
}

const HEAD: &str = "   3  acceleration pts, approx    0 secs, units=cm/sec2(04),Format=(8F10.5)";
const VALUES: &str = "   -.00001-200.12345 100.00000\n";

fn acceleration(azimuth: i64) -> String {
    series(&[(1, 2), (2, 1), (3, 4), (54, azimuth)], &[(34, 0.005), (62, 10.0)], HEAD, VALUES)
}

fn velocity() -> String {
    let head = HEAD.replace("acceleration", "velocity").replace("cm/sec2(04)", "cm/sec(05)");
    series(&[(1, 2), (2, 2), (3, 5), (54, 90)], &[(62, 10.0)], &head, VALUES)
}

pub fn small() -> String {
    acceleration(90) + &velocity() + &acceleration(401)
}

pub fn small_counts() -> String {
    let head = "   3 raw accel.   pts, approx  210 secs, units= counts(50),Format=(1I8)";
    let reals = [(22, 0.298024), (34, 0.005), (42, 1.2553), (47, 1.0)];
    series(&[(1, 0), (2, 1), (3, 50), (54, 360)], &reals, head, " -160876\n -160942\n      17\n")
}

#[test]
fn acceleration_of_every_channel_is_taken_with_the_interval_of_the_series() {
    let channels = parse(&small(), &ReadOptions::default()).unwrap();
    assert_eq!(channels.len(), 2, "velocity is passed over");
    assert_eq!(
        (channels[0].name.as_str(), channels[1].name.as_str()),
        ("small ch 1 340 deg", "small ch 1 340 deg (2)")
    );
    assert_eq!((channels[0].dt, channels[0].units), (0.01, Units::CentimetrePerSecond2));
    assert_eq!(
        (channels[0].orientation, channels[1].orientation),
        (Some(Orientation::EAST), Some(Orientation::Up))
    );
    same(&channels[0], &[-1e-7, -2.0012345, 1.0]);
    same(&channels[1], &[1e-7, 2.0012345, -1.0]);
    assert!(channels[1].remarks.iter().any(|r| r.contains("down is positive")));
}

#[test]
fn directions_follow_the_table() {
    for (code, orientation, remarks) in [
        (360, Some(Orientation::NORTH), 1),
        (400, Some(Orientation::Up), 1),
        (402, Some(Orientation::Up), 2),
        (340, azimuth(340.0), 0),
        (0, azimuth(340.0), 0),
        (500, azimuth(340.0), 0),
        (-999, azimuth(340.0), 0),
    ] {
        let channel = parse(&acceleration(code), &ReadOptions::default()).unwrap().remove(0);
        assert_eq!((channel.orientation, channel.remarks.len()), (orientation, remarks), "{code}");
    }
    // Integer 55 counts from the azimuth in integer 20 or 21.
    let turned = |integers: &[(usize, i64)]| {
        let text = series(&[&[(2, 1), (3, 4)], integers].concat(), &[(62, 10.0)], HEAD, VALUES);
        parse(&text.replace("1: 340 deg", "?:Other"), &ReadOptions::default()).unwrap()[0].orientation
    };
    assert_eq!(turned(&[(55, 90), (21, 360)]), azimuth(90.0));
    assert_eq!(turned(&[(55, 90), (20, 350), (21, 10)]), azimuth(80.0));
    assert_eq!(turned(&[(55, 0), (20, 350)]), azimuth(350.0));
    assert_eq!(turned(&[(55, 400)]), Some(Orientation::Up));
    assert_eq!(turned(&[(55, 90)]), None);
    assert_eq!(turned(&[(54, 0)]), None);
    // The channel's code comes last.
    for (code, words, orientation) in [
        ("BMR.BNZ.AK.--", "?:Other", Some(Orientation::Up)),
        ("8040.HNN.NP.01", "?:Other", Some(Orientation::NORTH)),
        ("8040.HN1.NP.01", "?:Other", None),
        ("BMR", "?:Other", None),
        ("BMR.BNZ.AK.--", "1: 340 deg", azimuth(340.0)),
    ] {
        let text = acceleration(0).replace("1: 340 deg", words);
        let text = text.replace("| comment", &format!("|<SCNL>{code}    <AUTH> 2019/02/01 21:38:15.000"));
        assert_eq!(parse(&text, &ReadOptions::default()).unwrap()[0].orientation, orientation, "{code}");
    }
}

#[test]
fn units_follow_the_table_and_numbers_the_format() {
    for (code, units, factor) in
        [(2, Units::G, 9.80665), (11, Units::G, 9.80665e-3), (10, Units::CentimetrePerSecond2, 0.01)]
    {
        let head = format!("   3  acceleration pts, approx 0 secs, units=?({code:02}),Format=(1P, 2E15.6)");
        let numbers = "   1.000000E-01  -2.500000E+00\n   3.000000D+00\n";
        let text = series(&[(1, 2), (2, 1), (3, code)], &[(34, 0.005)], &head, numbers);
        let channel = parse(&text, &ReadOptions::default()).unwrap().remove(0);
        assert_eq!((channel.dt, channel.units, channel.orientation), (0.005, units, azimuth(340.0)));
        same(&channel, &[0.1 * factor, -2.5 * factor, 3.0 * factor]);
    }
}

#[test]
fn the_line_above_the_numbers_has_the_last_word_on_units() {
    let text = series(&[(3, 2), (54, 340)], &[(62, 10.0)], HEAD, VALUES);
    let channel = parse(&text, &ReadOptions::default()).unwrap().remove(0);
    assert_eq!(channel.units, Units::CentimetrePerSecond2);
    assert!(channel.remarks[0].contains("code 4, the header 2"), "{:?}", channel.remarks);
}

#[test]
fn velocity_and_displacement_may_follow_without_headers() {
    let head = HEAD.replace("acceleration", "velocity").replace("cm/sec2(04)", "cm/sec(05)");
    let follows = format!("{}{head}\n{VALUES}{head}\n{VALUES}", acceleration(340).replace("/&", ""));
    assert_eq!(parse(&(follows.clone() + &follows), &ReadOptions::default()).unwrap().len(), 2);
    assert!(refusal(follows.trim_end().rsplit_once('\n').unwrap().0).contains("before 3 numbers"));
}

#[test]
fn counts_stay_counts_until_a_sensitivity_is_declared() {
    let raw = parse(&small_counts(), &ReadOptions::default()).unwrap().remove(0);
    assert_eq!(
        (raw.raw, raw.units, raw.acceleration.as_slice()),
        (true, Units::Counts, &[-160876.0, -160942.0, 17.0][..])
    );
    // 1.2553 V/g / 0.298024 µV / 9.80665 m/s².
    let remark = raw.remarks.iter().find(|r| r.contains("not applied")).unwrap();
    let told = remark.split('"').nth(1).unwrap();
    let sensitivity: Sensitivity = told.parse().unwrap();
    assert!((sensitivity.counts() - 429_512.308).abs() < 0.5, "{told}");
    let options = ReadOptions { sensitivity: Some(sensitivity), ..ReadOptions::default() };
    let known = parse(&small_counts(), &options).unwrap().remove(0);
    assert!(!known.raw && (known.acceleration[0] + 160876.0 / 429_512.308).abs() < 1e-6);
    assert!(parse(&acceleration(90), &options).unwrap_err().to_string().contains("sensitivity"));
}

#[test]
fn faults_are_named_with_their_line() {
    let good = acceleration(90);
    let cut = |lines: usize| good.lines().take(lines).collect::<Vec<_>>().join("\n");
    for (text, parts) in [
        (velocity(), ["line 45: the file holds velocity", "file of acceleration of the same channel"]),
        (
            velocity() + &velocity().replace("       2       2       5", "       2       3       5"),
            ["holds velocity", "line 45"],
        ),
        (cut(20), ["line 20", "before the 100 numbers"]),
        (cut(24), ["line 24", "Real-header"]),
        (cut(42), ["line 42", "comment lines"]),
        (cut(45), ["line 45", "before the 3 numbers"]),
        (good.replace(" 3  acc", " 4  acc"), ["line 46", "fewer than 8"]),
        (good.replace(" 3  acc", " 99  acc"), ["line 45", "before the 99 numbers"]),
        (good.replace(" 3  acc", " 99999999999999999  acc"), ["line 45", "before the 99999999999999999"]),
        (good.replace("Format=(8F10.5)", "Format=(8A10)"), ["line 45", "Format=(8F10.5)"]),
        (good.replace("(10I8)", "(10X8)"), ["line 14", "(10I8)"]),
        (good.replace(" 1 Comment", " 9 Comment"), ["line 48", "7000 acceleration pts"]),
        (good.replace("-200.12345", "       NaN"), ["line 46: 'NaN' is not", "finite"]),
        (
            good.replace("cm/sec2(04)", "psi(60)").replace("       1       4", "       1      60"),
            ["line 45", "code 60"],
        ),
        (
            good.replace("(04)", "").replace("       1       4", "       1    -999"),
            ["line 45", "units = \"cm/s2\""],
        ),
        (
            good.replace("    10.000000", "  -999.000000").replace("     0.005000", "  -999.000000"),
            ["line 1", "dt = "],
        ),
        (good.replace("    10.000000", "     0.000000"), ["line 45", "interval 0 s"]),
        (good.replace("/&  ---", "1 2 3\n/& ---"), ["line 47", "go on"]),
    ] {
        let message = refusal(&text);
        assert!(parts.iter().all(|p| message.contains(p)), "{parts:?}: {message}");
    }
}

/// Figures of a few lines of Python that cut the 875 lines under each 'acceleration pts' into words of ten characters; both
/// channels hold the same numbers. The header states the peak, -161.962 at 27.850 s. It says up in integer 54 of the first
/// channel and 340 deg in words, and 25 (degrees) for the units of the second.
#[test]
fn standard_test_volume_1() {
    let figures = |name, orientation| Figures {
        name,
        npts: 7000,
        dt: 0.01,
        peak: (-161.9618, 2785),
        first: -1e-5,
        last: -3e-5,
        sum: 0.03276,
        orientation,
    };
    let channels = compare(
        "cosmos/Cosmos12TimeSeriesTest2.v1",
        Units::CentimetrePerSecond2,
        &[
            figures("Cosmos12TimeSeriesTest2 ch 1 340 deg", Some(Orientation::Up)),
            figures("Cosmos12TimeSeriesTest2 ch 2 90 deg", azimuth(90.0)),
        ],
    );
    if let Some(channels) = channels {
        assert!(channels[0].remarks[0].contains("'340 deg' in words"), "{:?}", channels[0].remarks);
        assert!(channels[1].remarks[0].contains("the header 25"), "{:?}", channels[1].remarks);
    }
}

/// As above, one integer a line under 'raw accel.'; the header states the peak without its sign, 1033406 at 45.580 s.
#[test]
fn anchorage_volume_0() {
    let channels = compare(
        "cosmos/NP8040-n.1000hyfh.HNE.01.V0c.gz",
        Units::Counts,
        &[Figures {
            name: "NP8040-n.1000hyfh.HNE.01 ch 1 90 Deg",
            npts: 42000,
            dt: 0.005,
            peak: (-1_033_406.0, 9116),
            first: -160_876.0,
            last: -163_466.0,
            sum: -6_758_505_350.0,
            orientation: Some(Orientation::EAST),
        }],
    );
    if let Some(channels) = channels {
        assert!(channels[0].remarks[0].contains("429512 counts/(m/s2)"), "{:?}", channels[0].remarks);
    }
}
