//! GeoNet volume 1; volume 2 is in `readers.rs` and `reference.rs`.

use tremolite_motion::{Orientation, ReadOptions, Units};

use super::figures::{Figures, azimuth, compare, parse, refusal, same};

/// An uncorrected component of three samples.
fn small(component: &str, factor: &str) -> String {
    let mut text = String::from("Uncorrected accelerogram X\n");
    for line in 2..=16 {
        text += &match line {
            10 => "Number of points     3    Duration 0.01 s\n".to_string(),
            11 => format!("Raw readings in units of {factor} mm/s/s  at intervals of 0.005 s\n"),
            13 => format!("Component {component}\n"),
            14 => "Acceleration:  Peak  -1024.7 mm/s/s at   0.01 s     RMS   719.0 mm/s/s\n".to_string(),
            15 => "Velocity record unevaluated\n".to_string(),
            _ => "\n".to_string(),
        };
    }
    text += "\n\n\n       3       0       0       3       0       0       0\n\n\n\n\n\n\n";
    text + "   100.0-11024.7-11024.6\n"
}

#[test]
fn volume_1_is_read_with_its_factor() {
    let text = small("S90E", "1.00") + &small("N00E", "0.10") + &small("Up", "1.00");
    let channels = parse(&text, &ReadOptions::default()).unwrap();
    let found: Vec<_> = channels.iter().map(|c| c.orientation.unwrap()).collect();
    assert_eq!(found, [Orientation::EAST, Orientation::NORTH, Orientation::Up]);
    assert_eq!((channels[0].dt, channels[0].units), (0.005, Units::MillimetrePerSecond2));
    same(&channels[0], &[0.1, -11.0247, -11.0246]);
    same(&channels[1], &[0.01, -1.10247, -1.10246]);
    assert!(channels[0].remarks.is_empty() && channels[1].remarks[0].contains("0.1 mm/s2"));
}

#[test]
fn faults_of_volume_1_are_named_with_their_line() {
    let good = small("Up", "1.00");
    for (text, parts) in [
        (good.replace("1.00 mm", "x mm"), ["line 11", "factor"]),
        (good.replace("1.00 mm", "-1 mm"), ["line 11", "factor"]),
        (good.replace("1.00 mm/s/s ", "1.00 mm/s"), ["line 11", "'mm/s' is not a unit"]),
        (good.replace(" at intervals of", ""), ["line 1", "at intervals of"]),
        (good.replace("points     3", "points     4"), ["line 20", "both 4 and 3"]),
        (good.replace("-11024.6", "     NaN"), ["line 27", "'NaN' is not"]),
        (good.replace("   100.0-11024.7-11024.6\n", ""), ["line 27", "fewer than 10"]),
        (good.replace("-11024.6", ""), ["line 27", "fewer than 10"]),
    ] {
        let message = refusal(&text);
        assert!(parts.iter().all(|p| message.contains(p)), "{message}");
    }
}

/// Figures of a few lines of Python that cut the file's lines 27–5946 (and as far behind the two headers that follow) into
/// words of eight characters; the headers state the same peaks.
#[test]
fn top_house_volume_1() {
    let figures = |name, peak, first, last, sum, orientation| Figures {
        name,
        npts: 59200,
        dt: 0.005,
        peak,
        first,
        last,
        sum,
        orientation,
    };
    compare(
        "geonet_v1a/20161113_110313_THZ_20.V1A.gz",
        Units::MillimetrePerSecond2,
        &[
            figures("20161113_110313_THZ_20 S90E", (399.7, 23073), -0.4, -0.1, -114.6, azimuth(90.0)),
            figures("20161113_110313_THZ_20 N00E", (484.6, 18769), 0.0, 0.3, -146.5, azimuth(0.0)),
            figures("20161113_110313_THZ_20 Up", (-249.1, 23548), -0.0, -0.1, 4.3, Some(Orientation::Up)),
        ],
    );
}
