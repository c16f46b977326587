//! ESM and ITACA, DYNA 1.x.

use tremolite_motion::{Orientation, ReadOptions, Units};

use super::{Figures, compared, one, refusal, refuses};

/// Eight samples of 0.005 s. The header has the lines that matter and some of the others.
pub fn small() -> String {
    "EVENT_NAME: GREECE\nEVENT_ID: EMSC-20190728_0000106\nNETWORK: HL\nSTATION_NAME: Delfoi: east, Greece\nVS30_M/S: \n\
     DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS: 20190728_160905.700\nSAMPLING_INTERVAL_S: 0.005000\nNDATA: 8\n\
     STREAM: HNE\nUNITS: cm/s^2\nHEADER_FORMAT: DYNA 1.2\nDATA_TYPE: ACCELERATION\nUSER1: \nUSER5: \n\
     0.000000\n-0.500000\n1.25\n-2.000000\n0.5\n0.25\n0.125\n-0.000014\n"
        .into()
}

#[test]
fn one_number_a_line_is_read_in_the_units_of_the_header() {
    let channel = one(small(), &ReadOptions::default());
    assert_eq!((channel.dt, channel.start, channel.units), (0.005, 0.0, Units::CentimetrePerSecond2));
    for (a, expected) in channel.acceleration.iter().zip([0.0, -0.005, 0.0125, -0.02, 0.005, 0.0025]) {
        assert!((a - expected).abs() < 1e-16);
    }
    assert_eq!(channel.acceleration.len(), 8);
    // date -u -d '2019-07-28 16:09:05.7' +%s.%N
    assert_eq!(channel.clock, Some(1_564_330_145.7));
    for (stream, orientation) in [
        ("HNE", Some(Orientation::EAST)),
        ("HGN", Some(Orientation::NORTH)),
        ("HNZ", Some(Orientation::Up)),
        ("HN1", None),
        ("", None),
    ] {
        let text = small().replace("STREAM: HNE", &format!("STREAM: {stream}"));
        assert_eq!(one(text, &ReadOptions::default()).orientation, orientation, "{stream}");
    }
    let unknown = small().replace("20190728_160905.700", "");
    assert_eq!(one(unknown, &ReadOptions::default()).clock, None);
}

#[test]
fn faults_are_named_with_their_line() {
    refuses(
        &small(),
        &[
            (["-0.000014\n", ""], ["line 22: the file has 7 samples, but NDATA is 8", "fetch"]),
            (["-0.000014\n", "-0.000014\n1\n"], ["has 9 samples", "fetch"]),
            (["-2.000000", "NaN"], ["line 18: 'NaN' is not a finite number", "correct"]),
            (["-2.000000", "1 2"], ["line 18: '1 2' is not a finite number", "correct"]),
            (["NDATA: 8", "NDATA: 99999999999999999999"], ["line 8:", "no number of samples"]),
            (["NDATA: 8", "NDATA: 18446744073709551615"], ["has 8 samples", "NDATA is 18446744073709551615"]),
            (["INTERVAL_S: 0.005000", "INTERVAL_S: "], ["line 7: the sampling interval is missing", "fetch"]),
            (["INTERVAL_S: 0.005000", "INTERVAL_S: 0"], ["line 7: the sampling interval 0 s", "correct"]),
            (["UNITS: cm/s^2", "UNITS: "], ["line 10: '' is not a unit of acceleration", "give a record"]),
            (["UNITS: cm/s^2\n", ""], ["begins with 'UNITS:'", "fetch"]),
            (["TYPE: ACCELERATION", "TYPE: VELOCITY"], ["line 12: the file holds 'VELOCITY'", ".ACC."]),
            (
                ["TYPE: ACCELERATION", "TYPE: ACCELERATION RESPONSE SPECTRUM"],
                ["'ACCELERATION RESPONSE SPECTRUM', not", ".ACC."],
            ),
            (["20190728_160905", "20190728"], ["line 6: '20190728.700' is no date", "fetch"]),
            (["USER5: \n", ""], ["header does not end", "'USER5:'"]),
        ],
    );
    let units = ReadOptions { units: Some(Units::G), ..ReadOptions::default() };
    assert!(refusal(small(), &units).contains("line 10: the file states units of cm/s2"));
}

/// The figures are by NumPy (`loadtxt` behind 64 lines); the header has a PGA of −0.227973 cm/s² at 36.31 s.
#[test]
fn a_real_record_has_the_figures_of_an_independent_reading() {
    let figures = Figures {
        file: "esm/HL.DLFA..HNE.D.20190728.160908.C.ACC.ASC",
        npts: 13876,
        dt: 0.005,
        peak: (-0.00227973, 7262),
        about_mean: (-0.002279729980541943, 7262),
        ends: (0.0, -1.4e-07),
    };
    let Some(channel) = compared(&figures) else { return };
    assert_eq!((channel.orientation, channel.clock), (Some(Orientation::EAST), Some(1_564_330_145.7)));
    assert_eq!((channel.units, figures.peak.1 as f64 * channel.dt), (Units::CentimetrePerSecond2, 36.31));
}
