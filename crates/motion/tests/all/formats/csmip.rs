//! Volumes 1 and 2 of CDMG and CSMIP.

use tremolite_motion::{Orientation, ReadOptions, Units};

use super::figures::{Figures, azimuth, columns, compare, parse, refusal, same};

/// A header: lines of text with those given by number, 7 lines of integers with integer 27, lines of reals.
fn header(first: &str, text_lines: usize, lines: &[(usize, String)], code: u16, real_lines: usize) -> String {
    let mut text = format!("{first}\n");
    for i in 2..=text_lines {
        let line = lines.iter().find(|(n, _)| *n == i).map_or("TEXT", |(_, l)| l);
        text += &format!("{line}\n");
    }
    for i in 0..7 {
        let count = if i == 6 { 4 } else { 16 };
        text += &(0..count)
            .map(|k| format!("{:5}", if (i, k) == (1, 10) { code } else { 0 }))
            .collect::<String>();
        text += "\n";
    }
    text + &"      .000      .000\n".repeat(real_lines)
}

/// A channel of volume 2.
fn corrected(channel: &str, code: u16, acceleration: &[f64]) -> String {
    let n = acceleration.len();
    let lines = [
        (2, "UNCORRECTED ACCELEROGRAM DATA".to_string()),
        (8, format!("CHAN {channel}")),
        (16, format!("  {n} POINTS OF INSTRUMENT- AND BASELINE-CORRECTED ACCEL, VELOC AND DISPL DATA")),
    ];
    let mut text = header("CORRECTED ACCELEROGRAM 1", 25, &lines, code, 13);
    for (name, unit, values) in
        [("ACCEL", "CM/SEC/SEC", acceleration), ("VELOC", "CM/SEC", &[9.0; 10]), ("DISPL", "CM", &[8.0; 3])]
    {
        let n = values.len();
        text += &format!(" {n} POINTS OF {name} DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: {unit})\n");
        text += &columns(values, 8, 10, 3);
    }
    text + "/&  ----------  END OF DATA FOR CHANNEL  1  ----------\n"
}

/// A channel of equally spaced volume 1.
fn digital(head: &str, acceleration: &[f64]) -> String {
    let lines = [(7, "Chan  1: 360 Deg".to_string()), (12, "Units of uncor data are sec and g .".into())];
    header("Uncorrected Accelerogram Data             Processed: 02/13/12", 13, &lines, 360, 7)
        + &format!(" {} {head}\n", acceleration.len())
        + &columns(acceleration, 8, 9, 6)
        + "/&  ----------  End of Data for Channel  1  ----------\n"
}

/// A channel of volume 1 from film, in columns of 7 that touch.
fn film(points: &[[f64; 2]]) -> String {
    let lines = [
        (7, "CHAN  2: UP".to_string()),
        (11, format!("NO. OF POINTS = {:6}  RECORD LENGTH = 59.998 SEC", points.len())),
        (12, "UNITS OF UNCOR ACCEL ARE SEC AND G/10.     MAX  =  -.200 G, AT  11.576 SEC.".into()),
    ];
    header("UNCORRECTED ACCELEROGRAM DATA              PROCESSED: 02/08/94, CDMG", 13, &lines, 500, 7)
        + &columns(points.as_flattened(), 10, 7, 3)
        + "/&  ----------  END OF DATA FOR CHANNEL  2  ----------\n"
}

pub fn small_v2() -> String {
    corrected(" 1:  90 DEG", 90, &[1.0, -200.5, 3.0]) + &corrected(" 2: UP", 500, &[4.0, 5.0])
}

pub fn small_v1() -> String {
    digital("Accelerogram points at 200 pts/sec in units of g .      Format: (8f9.6)", &[0.5; 20])
        + &film(&[[0.0, 1.0], [99.0, 2.0], [100.004, -10.25]].map(|[t, a]| [t / 100.0, a]))
}

#[test]
fn acceleration_of_every_channel_is_taken_from_volume_2() {
    let channels = parse(&small_v2(), &ReadOptions::default()).unwrap();
    assert_eq!(
        channels.iter().map(|c| c.name.as_str()).collect::<Vec<_>>(),
        ["small ch 1 90 DEG", "small ch 2 UP"]
    );
    assert_eq!(channels[1].orientation, Some(Orientation::Up));
    assert_eq!((channels[0].dt, channels[0].units), (0.02, Units::CentimetrePerSecond2));
    same(&channels[0], &[0.01, -2.005, 0.03]);
    same(&channels[1], &[0.04, 0.05]);
}

/// Files of later years state a format above some blocks, in unlike columns, and the units in other words.
#[test]
fn formats_above_the_numbers_are_followed() {
    let nine = [0.1234567; 10];
    let new = header("Corrected accelerogram", 25, &[(8, "Chan 11: Roof - East".into())], 45, 13)
        + " 3 points of accel data equally spaced at  .005 sec, in cm/sec2. (8f10.6)\n"
        + &columns(&[-1.5, 2.0, 0.25], 8, 10, 6)
        + " 10 points of displ data equally spaced at  .005 sec, in cm. (9f10.7)\n"
        + &columns(&nine, 9, 10, 7)
        + " 10 points of veloc data equally spaced at  .005 sec, in cm/sec.\n"
        + &columns(&nine, 9, 10, 7);
    let channels = parse(&(new.clone() + &new), &ReadOptions::default()).unwrap();
    assert_eq!((channels.len(), channels[0].dt), (2, 0.005));
    assert_eq!(
        (channels[0].name.as_str(), channels[1].name.as_str()),
        ("small ch 11 Roof - East", "small ch 11 Roof - East (2)")
    );
    assert_eq!(channels[0].orientation, azimuth(45.0), "the code serves where words do not");
    same(&channels[1], &[-0.015, 0.02, 0.0025]);
}

#[test]
fn equally_spaced_volume_1_is_read_in_columns_of_nine() {
    for head in [
        "Accelerogram points at 200 pts/sec in units of g .      Format: (8f9.6)",
        "POINTS OF ACCEL DATA EQUALLY SPACED AT .005 SEC.  (UNITS: G)",
    ] {
        let channels =
            parse(&digital(head, &[0.1, -0.2, -0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9]), &ReadOptions::default());
        let channel = channels.unwrap().remove(0);
        assert_eq!((channel.dt, channel.units, channel.orientation), (0.005, Units::G, azimuth(0.0)));
        same(&channel, &[0.1, -0.2, -0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9].map(|a| a * 9.80665));
    }
}

#[test]
fn film_is_read_by_column_where_numbers_touch() {
    let text = film(&[[0.0, 0.0], [4.0, 4.0], [8.0, -10.125], [8.25, -10.0]]);
    assert!(text.contains("8.000-10.125"));
    let channel = parse(&text, &ReadOptions::default()).unwrap().remove(0);
    assert_eq!((channel.dt, channel.start, channel.units), (0.005, 0.0, Units::G));
    assert_eq!((channel.orientation, channel.acceleration.len()), (Some(Orientation::Up), 1651));
    let tenth = 0.980665;
    for (t, value) in [(2.0, 2.0), (4.0, 4.0), (6.0, -3.0625), (8.0, -10.125), (8.25, -10.0)] {
        let a = channel.acceleration[(t / 0.005_f64).round() as usize];
        assert!((a - value * tenth).abs() < 1e-9, "{t}: {a}");
    }
    assert!(
        channel.remarks.iter().any(|r| r.contains("G/10"))
            && channel.remarks.iter().any(|r| r.contains("4 pairs"))
    );
}

#[test]
fn a_channel_that_looks_down_is_turned_and_one_at_odds_with_itself_says_so() {
    let down = parse(&corrected(" 1: DOWN", 600, &[1.0, 2.0]), &ReadOptions::default()).unwrap().remove(0);
    assert_eq!(down.orientation, Some(Orientation::Up));
    same(&down, &[-0.01, -0.02]);
    assert!(down.remarks[0].contains("down is positive"));
    for (code, sign) in [(600, -1.0), (500, 1.0), (400, 1.0)] {
        let coded =
            parse(&corrected(" 1: BASEMENT (STA CHN: 1)", code, &[1.0, 2.0]), &ReadOptions::default());
        let coded = coded.unwrap().remove(0);
        assert_eq!((coded.name.as_str(), coded.orientation), ("small ch 1 BASEMENT", Some(Orientation::Up)));
        same(&coded, &[0.01 * sign, 0.02 * sign]);
    }
    let odd = parse(&corrected(" 1: 360 DEG", 90, &[1.0, 2.0]), &ReadOptions::default()).unwrap().remove(0);
    assert_eq!(odd.orientation, azimuth(0.0));
    assert!(odd.remarks[0].contains("'360 DEG' in words and 90"), "{:?}", odd.remarks);
}

#[test]
fn faults_are_named_with_their_line() {
    let good = corrected(" 1:  90 DEG", 90, &[1.0, -200.5, 3.0]);
    let cut = |text: &str, lines: usize| text.lines().take(lines).collect::<Vec<_>>().join("\n");
    let film = film(&[[0.0, 0.0], [4.0, 4.0], [8.0, 4.0], [8.25, -10.0]]);
    for (text, parts) in [
        (cut(&good, 30), ["line 1", "how many points of acceleration"]),
        (cut(&good, 46), ["line 46: 3 numbers were promised", "fewer"]),
        (cut(&good, 48), ["line 48: 10 numbers were promised", "fewer"]),
        (good.replace(" 3 POINTS OF ACC", " 4 POINTS OF ACC"), ["line 46: 4 numbers were promised", "fewer"]),
        (
            good.replace(" 3 POINTS OF ACC", "99999999999999999 POINTS OF ACC"),
            ["line 46: 99999999999999999 numbers", "fewer"],
        ),
        (good.replace(" 10 POINTS", " 99 POINTS"), ["line 48: 99 numbers were promised", "fewer"]),
        (good.replace(" 10 POINTS", " 8 POINTS"), ["line 50", "go on"]),
        (good.replace("  -200.500", "       NaN"), ["line 47", "'NaN' is not"]),
        (good.replace("(UNITS: CM/SEC/SEC)", ""), ["line 46", "units = \"g\""]),
        (good.replace("(UNITS: CM/SEC/SEC)", "(UNITS: FURLONG)"), ["line 46", "'FURLONG' is not a unit"]),
        (
            good.replace("  .020 SEC.  (UNITS: CM/SEC/", "  .000 SEC.  (UNITS: CM/SEC/"),
            ["line 46", "interval 0 s"],
        ),
        (good.replace("OF ACCEL DATA", "OF VELOC DATA"), ["line 46", "no acceleration"]),
        ("RESPONSE AND FOURIER AMPLITUDE SPECTRA\nCORRECTED ACCELEROGRAM\n".into(), ["line 1", "volume 3"]),
        (cut(&film, 27), ["line 27: 0 of the 4 pairs", "fetch"]),
        (film.replace("POINTS =      4", "POINTS =      5"), ["line 29: 4 of the 5 pairs", "fetch"]),
        (film.replace("POINTS =      4", "POINTS =      3"), ["line 28", "go on after the 3 pairs"]),
        (film.replace("  8.250", "  7.250"), ["line 28", "jumps back to 7.25 s"]),
        (film.replace("AND G/10", "AND G/20"), ["line 12", "'G/20' is not a unit"]),
        (film.replace("NO. OF", "NO OF"), ["line 1", "NO. OF POINTS"]),
    ] {
        let message = refusal(&text);
        assert!(parts.iter().all(|p| message.contains(p)), "{parts:?}: {message}");
    }
    let blank = good.replace("(UNITS: CM/SEC/SEC)", "");
    let peak = blank.replacen("TEXT", "PEAK ACCELERATION =  -200.500    CMS/SEC/SEC  AT   10.940   SEC.", 1);
    same(&parse(&peak, &ReadOptions::default()).unwrap()[0], &[0.01, -2.005, 0.03]);
    let declared = ReadOptions { units: Some(Units::CentimetrePerSecond2), ..ReadOptions::default() };
    same(&parse(&blank, &declared).unwrap()[0], &[0.01, -2.005, 0.03]);
}

/// Figures of a few lines of Python that cut what stands under each line 'POINTS OF ACCEL' into words of ten characters; the
/// headers state the same peaks.
#[test]
fn coalinga_volume_2() {
    let figures = |name, npts, peak, first, last, sum, orientation| Figures {
        name,
        npts,
        dt: 0.02,
        peak,
        first,
        last,
        sum,
        orientation,
    };
    compare(
        "dmg_v1v2/CE36456.V2",
        Units::CentimetrePerSecond2,
        &[
            figures("CE36456 ch 1 90 DEG", 3251, (-267.957, 547), -3.038, -1.308, -0.893, azimuth(90.0)),
            figures("CE36456 ch 2 UP", 3250, (-94.805, 584), 2.335, 3.153, 35.946, Some(Orientation::Up)),
            figures("CE36456 ch 3 0 DEG", 3250, (-256.231, 387), 1.527, -4.292, -33.476, azimuth(0.0)),
        ],
    );
}

/// As above, words of nine characters under 'Accelerogram points'.
#[test]
fn willow_creek_volume_1() {
    let figures = |name, peak, first, last, sum, orientation| Figures {
        name,
        npts: 13200,
        dt: 0.005,
        peak,
        first,
        last,
        sum,
        orientation,
    };
    compare(
        "dmg_v1v2/CE89146.V1.gz",
        Units::G,
        &[
            figures("CE89146 ch 1 360 Deg", (0.07918, 6118), 1e-5, -9.3e-5, -5.4e-5, azimuth(0.0)),
            figures("CE89146 ch 2 Up", (0.021055, 6118), 1.3e-5, 3.2e-5, -6.3e-5, Some(Orientation::Up)),
            figures("CE89146 ch 3 90 Deg", (-0.04529, 6115), -1.3e-5, 1.36e-4, 8e-6, azimuth(90.0)),
        ],
    );
}
