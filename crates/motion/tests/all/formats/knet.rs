//! K-NET and KiK-net.

use tremolite_motion::{Orientation, ReadOptions, Units};

use super::{Figures, compared, one, refusal, refuses};

/// Twenty samples of 0.1 s with an offset of 8000 counts; one count is a quarter of a gal.
pub fn small() -> String {
    let header = "Origin Time       2018/01/24 19:51:00\nLat.              41.0\nLong.             142.5\n\
                  Depth. (km)       30\nMag.              6.2\nStation Code      AOM004\nStation Lat.      41.4087\n\
                  Station Long.     141.4486\nStation Height(m) 30\nRecord Time       2018/01/24 19:51:37\n\
                  Sampling Freq(Hz) 10Hz\nDuration Time(s)  2\nDir.              E-W\nScale Factor      25(gal)/100\n\
                  Max. Acc. (gal)   2.0\nLast Correction   2018/01/24 19:51:37\nMemo.             \n";
    let counts: Vec<String> = (0..20).map(|i| format!("{:9}", 8000 + [0, 8, -4, 4][i % 4])).collect();
    let lines: Vec<String> = counts.chunks(8).map(|line| line.concat() + " \n").collect();
    header.to_string() + &lines.concat()
}

#[test]
fn counts_times_the_scale_are_gal_with_their_offset() {
    let channel = one(small(), &ReadOptions::default());
    assert_eq!((channel.acceleration.len(), channel.dt), (20, 0.1));
    assert_eq!((channel.units, channel.raw), (Units::CentimetrePerSecond2, false));
    for (a, expected) in channel.acceleration.iter().zip([20.0, 20.02, 19.99, 20.01, 20.0]) {
        assert!((a - expected).abs() < 1e-13);
    }
    // 19:51:37 in Japan is 10:51:37 UTC, and the first sample 15 s before (date -u -d '2018-01-24 10:51:22' +%s).
    assert_eq!(channel.clock, Some(1_516_791_082.0));
}

#[test]
fn directions_are_words_or_numbers_of_kik_net() {
    for (word, orientation, label) in [
        ("N-S", Orientation::NORTH, "NS"),
        ("E-W", Orientation::EAST, "EW"),
        ("U-D", Orientation::Up, "UD"),
        ("1", Orientation::NORTH, "NS1"),
        ("2", Orientation::EAST, "EW1"),
        ("3", Orientation::Up, "UD1"),
        ("4", Orientation::NORTH, "NS2"),
        ("5", Orientation::EAST, "EW2"),
        ("6", Orientation::Up, "UD2"),
    ] {
        let text = small().replace("E-W", word);
        let channel = one(text, &ReadOptions::default());
        assert_eq!(channel.orientation, Some(orientation), "{word}");
        assert_eq!(channel.name, format!("small {label}"));
        let borehole =
            channel.remarks.iter().any(|r| r.contains("borehole") && r.contains("kind = \"within\""));
        assert_eq!(borehole, label.ends_with('1'), "{word}");
    }
}

#[test]
fn faults_are_named_with_their_line() {
    refuses(
        &small(),
        &[
            (["7996     8004 \n", "7996 \n"], ["line 21: the file has 19 samples", "10 Hz over 2 s make 20"]),
            (["     8008", "      NaN"], ["line 18: 'NaN' is not a finite number", "correct"]),
            (["     8008", "     8o08"], ["line 18: '8o08' is not a finite number", "correct"]),
            (["Duration Time(s)  2", "Duration Time(s)  3"], ["has 20 samples", "make 30"]),
            (["Duration Time(s)  2", "Duration Time(s)  "], ["line 12: ''", "above 0"]),
            (["10Hz", "0Hz"], ["line 11: '0Hz'", "above 0"]),
            (["25(gal)/100", "25(gal)/0"], ["line 14: '25(gal)/0' is no scale", "3920(gal)"]),
            (["25(gal)/100", "25/100"], ["line 14: '25/100' is no scale", "3920(gal)"]),
            (["25(gal)/100", "25(cm/s)/100"], ["line 14: '25(cm/s)/100' is no scale", "fetch"]),
            (
                ["25(gal)/100", "25(kine)/100"],
                ["line 14: 'kine' is not a unit of acceleration", "give a record"],
            ),
            (["E-W", "7"], ["line 13: '7' is none of N-S", "fetch"]),
            (["Record Time       2018", "Record Time       20x8"], ["line 10:", "no date and time"]),
            (["Scale Factor", "Skale Factor"], ["begins with 'Scale Factor'", "fetch"]),
            (["Mag.              6.2\n", ""], ["line 17: the 17th line", "fetch"]),
        ],
    );
    let header: String = small().lines().take(12).map(|l| format!("{l}\n")).collect();
    assert!(refusal(header, &ReadOptions::default()).contains("17th line"));
    let sensitivity = ReadOptions { sensitivity: "5 counts/g".parse().ok(), ..ReadOptions::default() };
    assert!(refusal(small(), &sensitivity).contains("is in cm/s2, not in counts"));
    let units = ReadOptions { units: Some(Units::G), ..ReadOptions::default() };
    assert!(refusal(small(), &units).contains("line 14: the file states units of cm/s2"));
    let dt = ReadOptions { dt: Some(0.01), ..ReadOptions::default() };
    assert!(refusal(small(), &dt).contains("line 11: the file states an interval of 0.1 s"));
}

/// The figures are by NumPy from the counts and the header's scale, and ObsPy 1.5.1 reads the same with its scale. `Max. Acc.`
/// is the header's, in gal to three places, without the mean.
#[test]
fn real_records_have_the_figures_of_an_independent_reading() {
    let knet = |file, peak, about_mean, ends| Figures { file, npts: 9700, dt: 0.01, peak, about_mean, ends };
    let kiknet = |file, peak, about_mean, ends| Figures {
        npts: 28600,
        dt: 0.005,
        ..knet(file, peak, about_mean, ends)
    };
    for (figures, orientation, clock, most) in [
        (
            knet(
                "knet/AOM0041801241951.EW",
                (-0.18070231082844704, 3176),
                (0.11971018833031719, 2980),
                (-0.06783390139130399, -0.06849328317882578),
            ),
            Orientation::EAST,
            1_516_791_082.0,
            11.971,
        ),
        (
            knet(
                "knet/AOM0041801241951.NS",
                (-0.29973340389512065, 2808),
                (-0.25307354719549385, 2808),
                (-0.046670282095652736, -0.04874353060064912),
            ),
            Orientation::NORTH,
            1_516_791_082.0,
            25.307,
        ),
        (
            knet(
                "knet/AOM0041801241951.UD",
                (-0.18425282814587207, 2002),
                (0.0693425856149674, 1903),
                (-0.12875697443262, -0.13028496492101183),
            ),
            Orientation::Up,
            1_516_791_082.0,
            6.934,
        ),
        (
            kiknet(
                "kiknet/AICH040010061330.EW2",
                (0.05020856857299805, 16244),
                (-0.03895856417142428, 11632),
                (0.016601085662841797, 0.018780231475830078),
            ),
            Orientation::EAST,
            970_806_669.0,
            3.896,
        ),
        (
            kiknet(
                "kiknet/AICH040010061330.UD2",
                (0.09111404418945312, 10885),
                (-0.014879852074843186, 15133),
                (0.07781028747558594, 0.07848739624023438),
            ),
            Orientation::Up,
            970_806_669.0,
            1.488,
        ),
    ] {
        let Some(channel) = compared(&figures) else { return };
        assert_eq!(
            (channel.orientation, channel.clock),
            (Some(orientation), Some(clock)),
            "{}",
            figures.file
        );
        assert_eq!(channel.units, Units::CentimetrePerSecond2);
        assert!((figures.about_mean.0.abs() * 100.0 - most).abs() <= 0.0005, "{}", figures.file);
    }
}
