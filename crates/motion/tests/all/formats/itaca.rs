//! ITACA before DYNA.

use tremolite_motion::{Orientation, ReadOptions, Units};

use super::{Figures, compared, one, refusal, refuses};

/// Twelve samples whose numbers touch.
pub fn small() -> String {
    let header = "Event Date & Time             : 2009-04-06 01:32:39\nStation Code / Name           : 2987 / L Aquila\n\
                  Orientation                   : WE\nTime Increment (s)            : 0.005\n\
                  Number of Data                : 12\nPGA (m/s/s)                   : 5.0E+00\n\
                  Accelaration time series in m/s/s\n";
    let line = "-1.3724600E-07-2.6835700E-01 5.0000000E+00-5.2976600E-07 6.5981000E-07\n";
    header.to_string() + line + line + " 1.0000000E+00-2.0000000E+00\n"
}

#[test]
fn numbers_are_read_by_column() {
    let channel = one(small(), &ReadOptions::default());
    assert_eq!((channel.dt, channel.units), (0.005, Units::MetrePerSecond2));
    let line = [-1.37246e-7, -0.268357, 5.0, -5.29766e-7, 6.5981e-7];
    assert_eq!(channel.acceleration, [&line[..], &line, &[1.0, -2.0]].concat());
    for (label, orientation) in
        [("WE", Orientation::EAST), ("NS", Orientation::NORTH), ("UP", Orientation::Up)]
    {
        let text = small().replace(": WE", &format!(": {label}"));
        assert_eq!(one(text, &ReadOptions::default()).orientation, Some(orientation));
    }
}

#[test]
fn units_that_the_header_leaves_out_are_asked_for() {
    let text = small().replace(" in m/s/s", "");
    assert!(refusal(&text, &ReadOptions::default()).contains("line 7: the header does not state the units"));
    let gal = ReadOptions { units: Some(Units::CentimetrePerSecond2), ..ReadOptions::default() };
    assert_eq!(one(&text, &gal).acceleration[2], 0.05);
    assert!(refusal(small(), &gal).contains("line 7: the file states units of m/s2"));
}

#[test]
fn faults_are_named_with_their_line() {
    refuses(
        &small(),
        &[
            ([": 12\n", ": 13\n"], ["line 10: fewer than 5 numbers in columns of 14", "fetch"]),
            ([": 12\n", ": 16\n"], ["line 10: fewer than 5", "fetch"]),
            ([": 12\n", ": 99\n"], ["ends before the 99 numbers", "fetch"]),
            ([": 12\n", ": 18446744073709551615\n"], ["ends before the 18446744073709551615", "fetch"]),
            ([": 12\n", ": 11\n"], ["line 10: numbers go on after the 11 samples", "fetch"]),
            ([": 12\n", ": 10\n"], ["line 10: numbers go on after the 10 samples", "fetch"]),
            ([": 12\n", ": many\n"], ["line 5: 'many' is no number", "fetch"]),
            (["-2.6835700E-01", "           NaN"], ["line 8: 'NaN' is not a finite number", "correct"]),
            (["-1.3724600E-07", " -1.3724600E-07"], ["line 8: '7-2.6835700E-0'", "correct"]),
            ([": 0.005", ": -1"], ["line 4: the sampling interval -1 s", "correct"]),
            (["in m/s/s", "in m/s"], ["line 7: 'm/s' is not a unit", "give a record"]),
            (["Accelaration", "Velocity"], ["line 7: 'Velocity time series in m/s/s'", ".acc"]),
            (["Accelaration time series", "Data"], ["names the time series", "fetch"]),
            (["Orientation ", "Azimuth "], ["begins with 'Orientation'", "fetch"]),
        ],
    );
}

/// The figures are by NumPy from slices of 14 characters; the headers have PGA 5.0693293, 4.6756411 and 2.5850007 m/s².
#[test]
fn real_records_have_the_figures_of_an_independent_reading() {
    let figures =
        |file, peak, about_mean, ends| Figures { file, npts: 59220, dt: 0.005, peak, about_mean, ends };
    for (figures, orientation) in [
        (
            figures(
                "itaca_acc/AQG_16833_H1.cor.acc.gz",
                (-5.0693293, 4554),
                (-5.06932929999092, 4554),
                (-1.37246e-07, -1.43844e-06),
            ),
            Orientation::NORTH,
        ),
        (
            figures(
                "itaca_acc/AQG_16833_H2.cor.acc.gz",
                (-4.6756411, 4532),
                (-4.675641100011209, 4532),
                (2.552082e-06, -1.011006e-06),
            ),
            Orientation::EAST,
        ),
        (
            figures(
                "itaca_acc/AQG_16833_V.cor.acc.gz",
                (2.5850007, 4531),
                (2.585000700291787, 4531),
                (-3.3092418e-05, -1.999756e-06),
            ),
            Orientation::Up,
        ),
    ] {
        let Some(channel) = compared(&figures) else { return };
        assert_eq!((channel.orientation, channel.units), (Some(orientation), Units::MetrePerSecond2));
    }
}
