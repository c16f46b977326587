//! SMC files of the US Geological Survey.

use tremolite_motion::{Orientation, ReadOptions, Units};

use super::figures::{Figures, azimuth, compare, parse, refusal, same};

const UNKNOWN: i64 = -32768;

/// A trace of numbers; angles are integers 13 and 14, `rate` is real 2.
fn trace(first: &str, angles: [i64; 2], count: usize, rate: &str, numbers: &[f64]) -> String {
    let mut text = format!("{first}\n*\nDVD0A\n1989 Loma Prieta\nMag\nstation\ndist\ninst\n*\n*\n*\n");
    let mut integers = [UNKNOWN; 48];
    (integers[12], integers[13], integers[15], integers[16]) = (angles[0], angles[1], 1, count as i64);
    for line in integers.chunks(8) {
        text += &(line.iter().map(|i| format!("{i:10}")).collect::<String>() + "\n");
    }
    let reals = ["0.1700000E+39", rate].into_iter().chain(std::iter::repeat_n("0.1700000E+39", 48));
    for line in reals.collect::<Vec<_>>().chunks(5) {
        text += &(line.iter().map(|r| format!("{r:>15}")).collect::<String>() + "\n");
    }
    text += "|comment\n";
    for line in numbers.chunks(8) {
        text += &(line.iter().map(|x| format!("{:>10}", fortran(*x))).collect::<String>() + "\n");
    }
    text
}

/// `-8.6040E-2`: columns of ten are full, so numbers touch.
fn fortran(x: f64) -> String {
    let text = format!("{x:.4e}").to_uppercase();
    if text.contains("E-") { text } else { text.replace('E', "E+") }
}

pub fn pairs(points: &[[f64; 2]]) -> String {
    // Four figures behind the point are all the times need in these tests.
    trace("1 UNCORRECTED ACCELEROGRAM", [90, 65], 2 * points.len(), "0.1700000E+39", points.as_flattened())
}

fn corrected(angles: [i64; 2]) -> String {
    trace(
        "2 CORRECTED ACCELEROGRAM",
        angles,
        10,
        "0.2000000E+03",
        &[-1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, -8.0, -9.0, 1.0],
    )
}

pub fn small() -> String {
    corrected([90, 360]) + &corrected([0, UNKNOWN])
}

pub fn small_pairs() -> String {
    pairs(&[[0.0, 1.5], [0.003, -2.5], [0.011, -3.0], [0.015, 4.0], [0.03, 5.0]])
}

#[test]
fn corrected_traces_one_behind_the_other_are_channels() {
    let channels = parse(&small(), &ReadOptions::default()).unwrap();
    assert_eq!(channels.len(), 2);
    assert_eq!((channels[0].orientation, channels[1].orientation), (azimuth(0.0), Some(Orientation::Up)));
    assert_eq!((channels[0].name.as_str(), channels[1].name.as_str()), ("small 360 deg", "small vertical"));
    for channel in &channels {
        assert_eq!((channel.dt, channel.units), (0.005, Units::CentimetrePerSecond2));
        same(channel, &[-0.015, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, -0.08, -0.09, 0.01]);
    }
}

#[test]
fn a_trace_that_looks_down_is_turned() {
    let channel = parse(&corrected([180, UNKNOWN]), &ReadOptions::default()).unwrap().remove(0);
    assert_eq!((channel.orientation, channel.acceleration[0]), (Some(Orientation::Up), 0.015));
    assert!(channel.remarks[0].contains("down is positive"));
    let unknown = parse(&corrected([UNKNOWN, 30]), &ReadOptions::default()).unwrap().remove(0);
    assert_eq!((unknown.orientation, unknown.name.as_str()), (azimuth(30.0), "small 30 deg"));
    assert!(unknown.remarks[0].contains("integer 14"));
}

/// Integer 17 counts numbers in the files met; a file with twice as many must have counted pairs. Whole lines behind the
/// count stand in the files met, too.
#[test]
fn pairs_may_be_counted_either_way_and_what_goes_on_behind_them_is_told() {
    let points = [[0.0, 1.0], [0.01, 2.0], [0.03, 3.0], [0.04, 4.0]];
    let numbers = points.as_flattened();
    let first = "1 UNCORRECTED ACCELEROGRAM";
    let plain = parse(&pairs(&points), &ReadOptions::default()).unwrap().remove(0);
    assert_eq!(plain.acceleration.len(), 9);
    let more: Vec<f64> = numbers.iter().chain(&[9.0; 16]).copied().collect();
    let longer =
        parse(&trace(first, [90, 65], 8, "0.17E+39", &more), &ReadOptions::default()).unwrap().remove(0);
    assert_eq!(longer.acceleration, plain.acceleration);
    assert!(longer.remarks[0].contains("2 line(s) of numbers were left out"), "{:?}", longer.remarks);
    let longer = [numbers, &[0.05, 5.0, 0.06, 6.0, 0.07, 7.0, 0.08, 8.0]].concat();
    let halved =
        parse(&trace(first, [90, 65], 8, "0.17E+39", &longer), &ReadOptions::default()).unwrap().remove(0);
    assert_eq!(halved.acceleration.len(), 17);
}

/// D. M. Boore's programs write five columns of 14 on request and then set integer 47.
#[test]
fn files_of_more_figures_have_wider_columns() {
    let text = corrected([90, 360]).lines().take(28).collect::<Vec<_>>().join("\n");
    let unknown = "    -32768    -32768    -32768    -32768    -32768    -32768    -32768    -32768\n  0.17";
    assert!(text.contains(unknown));
    let wide = text.replace(unknown, &unknown.replace("    -32768    -32768\n", "         8    -32768\n"))
        + "\n -1.5000000E+0  2.0000000E+0  3.0000000E+0  4.0000000E+0  5.0000000E+0\n  6.0000000E+0  7.0000000E+0 \
           -8.0000000E+0 -9.0000000E+0  1.0000000E+0\n";
    let channel = parse(&wide, &ReadOptions::default()).unwrap().remove(0);
    same(&channel, &[-0.015, 0.02, 0.03, 0.04, 0.05, 0.06, 0.07, -0.08, -0.09, 0.01]);
}

#[test]
fn faults_are_named_with_their_line() {
    let good = corrected([90, 360]);
    let cut = |lines: usize| good.lines().take(lines).collect::<Vec<_>>().join("\n");
    let odd = trace("1 UNCORRECTED ACCELEROGRAM", [90, 0], 9, "0.17E+39", &[1.0; 9]);
    for (text, parts) in [
        (
            good.replace("2 CORRECTED ACCELEROGRAM", "3 VELOCITY"),
            ["line 1: the trace is velocity", "give a trace of acc"],
        ),
        (
            good.replace("2 CORRECTED ACCELEROGRAM", "4 DISPLACEMENT"),
            ["line 1: the trace is displacement", "give"],
        ),
        (
            good.replace("2 CORRECTED ACCELEROGRAM", "5 RESPONSE SPECTRA"),
            ["line 1: the trace is response", "give"],
        ),
        (
            good.replace("2 CORRECTED ACCELEROGRAM", "6 FOURIER AMPLITUDE"),
            ["line 1: the trace is a Fourier", "give"],
        ),
        (
            good.replace("2 CORRECTED ACCELEROGRAM", "0 UNKNOWN"),
            ["line 1: the trace is what the first line", "give"],
        ),
        (good.replace("2 CORRECTED ACCELEROGRAM", "*"), ["line 1: the trace is what the first line", "give"]),
        (
            good.clone() + &good.replace("2 CORRECTED ACCELEROGRAM", "3 VELOCITY"),
            ["line 31: the trace is velocity", "give"],
        ),
        (cut(14), ["line 14", "before the 48 numbers"]),
        (cut(20), ["line 20", "before the 50 numbers"]),
        (cut(29), ["line 29", "before the 10 numbers"]),
        (good.replace("        10    -32768", "    -32768    -32768"), ["line 14", "integer 17"]),
        (good.replace("        10    -32768", "999999999999-32768  "), ["line 14", "is not a finite"]),
        (
            corrected([90, 1])
                .replace("         1\n        10", "         3\n         0")
                .lines()
                .take(28)
                .collect::<Vec<_>>()
                .join("\n")
                + "\n|\n"
                + &good,
            ["line 29", "before the 0 numbers"],
        ),
        (good.replace("|comment", "comment"), ["line 28", "does not begin with '|'"]),
        (good.replace("-9.0000E+0", "       NaN"), ["line 30: 'NaN' is not", "finite"]),
        (good.replace("0.2000000E+03", "0.1700000E+39"), ["line 18", "dt = \"0.005 s\""]),
        (odd, ["line 14", "holds pairs, but 9 numbers"]),
    ] {
        let message = refusal(&text);
        assert!(parts.iter().all(|p| message.contains(p)), "{parts:?}: {message}");
    }
    let rateless = good.replace("0.2000000E+03", "0.1700000E+39");
    let declared = ReadOptions { dt: Some(0.01), ..ReadOptions::default() };
    assert_eq!(parse(&rateless, &declared).unwrap()[0].dt, 0.01);
    assert!(parse(&good, &declared).unwrap_err().to_string().contains("0.01 s"));
    let g = ReadOptions { units: Some(Units::G), ..ReadOptions::default() };
    assert!(parse(&good, &g).unwrap_err().to_string().contains("states units of cm/s2"));
}

/// Figures of a few lines of Python: the lines from 36 on cut into words of ten characters, the first 41240 of them (integer
/// 17; one more line of eight follows) as pairs, and `numpy.interp` at every 0.005 s from 0 to 29.655 s. The header states
/// the peak of the points, -80.19088 at 10.65442 s, which lies between samples.
#[test]
fn del_valle_dam_pairs() {
    let channels = compare(
        "smc/891018_1.sma-1.0444a.smc.gz",
        Units::CentimetrePerSecond2,
        &[Figures {
            name: "891018_1.sma-1.0444a 65 deg",
            npts: 5932,
            dt: 0.005,
            peak: (-80.1, 2131),
            first: -0.08604,
            last: 2.6544,
            sum: -2266.181588517408,
            orientation: azimuth(65.0),
        }],
    );
    if let Some(channels) = channels {
        let remarks = channels[0].remarks.join(" ");
        for part in ["20620 pairs", "0.00144 s apart", "1 line(s) of numbers were left out"] {
            assert!(remarks.contains(part), "{remarks}");
        }
    }
}
