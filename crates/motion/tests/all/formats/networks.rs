//! CSMNC, BHRC, and the networks whose headers declare columns: AFAD, CWB, JMA, ASA.

use tremolite_motion::{Orientation, ReadOptions, Units};

use super::{one, parse, refusal, refuses};

pub fn csmnc() -> String {
    "099TST010101120001\nCOMP. UD\nUNCORRECTED ACCELERATION          UNIT: CM/SEC/SEC\n\
     NO. OF POINTS:  11  EQUALLY SPACED INTERVALS OF:  0.005  SEC\nPEAK VALUE:    -118.140   AT   2.875 SEC\n\
     PRE-EVENT TIME:  20  SEC  RECORDER TIME:  2001-01-01 12:00:00.500 BTM\nTEST\n\n"
        .to_string()
        + " 1.0 2.0 3.0 4.0 5.0 6.0 7.0 8.0\n-9.0 -1.0E+01 0.0\n"
}

pub fn bhrc() -> String {
    let component = |name: &str| {
        format!("{}\n\nCOMP {name}\nTest Altitude 100m   Azimuth L 352   T 82\n", &name[..1])
            + "NO. OF POINTS =     12      DURATION =   0.060\nUNITS ARE SECONDS AND G/10\n\n"
            + &("    0    0    0    0    0    0    0    0    0    0\n".repeat(10))
            + &(" 0.0E+00 0.0E+00 0.0E+00 0.0E+00 0.0E+00\n".repeat(10))
            + "-1.5E-01-2.5E-01 3.5E-01-4.5E-01 0.0E+00 1.0E-01\n 1.0E-01 2.0E-01 1.0E-01 0.0E+00 0.0E+00 0.0E+00\n\n"
    };
    "* VOL1DS FILE:  9999/01\n".to_string() + &component("L1") + &component("V1") + &component("T1")
}

pub fn afad() -> String {
    "STRONG GROUND MOTION RECORDS OF TURKIYE\nNUMBER OF DATA          : 4\nSAMPLING INTERVAL (sec) : 0.010\n\
     RAW PGA VALUES (gal)    : (N-S) 4.0 (E-W) 0.5 (U-D) 0.2\n       N-S          E-W          U-D\n"
        .to_string()
        + "    1.0  0.1  0.01\n    2.0  0.2  0.02\n    3.0  0.3  0.03\n   -4.0 -0.5  0.2\n"
}

pub fn cwb() -> String {
    "#StationCode: TST\n#StartTime(GMT+08): 2001/01/01-12:00:00.000\n#RecordLength(sec): 0.02\n#SampleRate(Hz): 200\n\
     #AmplitudeUnit:  gal. DCoffset(corr)\n#DataSequence: Time U(+); N(-); E(+)\n#Data: 4F10.3\n"
        .to_string()
        + "  5.000  0.01  1.0  0.1\n  5.005  0.02  2.0  0.2\n  5.010  0.03  3.0  0.3\n  5.015  0.2 -4.0 -0.5\n"
}

pub fn jma() -> String {
    " SITE CODE= 99999Test,35.0,135.0,,,\r\n SAMPLING RATE= 100Hz,,\r\n UNIT  = gal(cm/s/s),,\r\n\
     \x20INITIAL TIME = 2001 01 01 12 00 00,,\r\nNS,EW,UD\r\n"
        .to_string()
        + "1.0,0.1,0.01\r\n2.0,0.2,0.02\r\n3.0,0.3,0.03\r\n-4.0,-0.5,0.2\r\n"
}

pub fn asa() -> String {
    "ORIENTACION C1-C6 (rumbo;orientacion)  : /V/N00E/S45E\nVEL. DE MUESTREO, C1-C6 (muestras/s)   : /100/100/100\n\
     NUM. TOTAL DE MUESTRAS, C1-C6          : /4/4/4\nUNIDADES DE LOS DATOS                  : Gal (cm/s/s)\n\
     DATOS DE ACELERACION:\n         V      N00E      S45E\n----------------\n"
        .to_string()
        + "  0.01  1.0  0.1\n  0.02  2.0  0.2\n  0.03  3.0  0.3\n  0.2 -4.0 -0.5\n"
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-12
}

#[test]
fn a_csmnc_file_is_read_by_rows_with_direction_and_time() {
    let channel = one(csmnc(), &ReadOptions::default());
    assert_eq!((channel.format, channel.dt, channel.acceleration.len()), ("CSMNC", 0.005, 11));
    assert_eq!((channel.orientation, channel.units), (Some(Orientation::Up), Units::CentimetrePerSecond2));
    // 4 in the morning of 2001-01-01, UTC.
    assert_eq!(channel.clock, Some(978_321_600.5));
    assert!(near(channel.acceleration[9], -0.1) && near(channel.acceleration[8], -0.09));
}

#[test]
fn bhrc_components_have_their_azimuths_and_tenths_of_g() {
    let channels = parse(bhrc(), &ReadOptions::default()).unwrap();
    let looks: Vec<_> = channels.iter().map(|c| (c.label.as_str(), c.orientation, c.dt)).collect();
    let azimuth = |degrees| Some(Orientation::from_degrees(degrees));
    assert_eq!(
        looks,
        [("L1", azimuth(352.0), 0.005), ("V1", Some(Orientation::Up), 0.005), ("T1", azimuth(82.0), 0.005)]
    );
    assert!(near(channels[2].acceleration[1], -0.025 * 9.80665), "numbers touch");
    assert!(channels[0].remarks[0].contains("G/10"));
    // A duration from the first sample to the last.
    let between = bhrc().replace("0.060", "0.055");
    assert_eq!(parse(between, &ReadOptions::default()).unwrap()[0].dt, 0.005);
}

#[test]
fn a_declared_header_names_its_columns() {
    let (north, east) = (Some(Orientation::NORTH), Some(Orientation::EAST));
    let up = Some(Orientation::Up);
    let azimuth = |degrees| Some(Orientation::from_degrees(degrees));
    for (file, dt, start, looks) in [
        (afad(), 0.01, 0.0, [north, east, up]),
        (cwb(), 0.005, 5.0, [up, azimuth(180.0), east]),
        (jma(), 0.01, 0.0, [north, east, up]),
        (asa(), 0.01, 0.0, [up, north, azimuth(135.0)]),
    ] {
        let channels = parse(&file, &ReadOptions::default()).unwrap();
        assert_eq!(channels.iter().map(|c| c.orientation).collect::<Vec<_>>(), looks, "{file}");
        for channel in &channels {
            assert_eq!((channel.dt, channel.start, channel.acceleration.len()), (dt, start, 4), "{file}");
            let strongest = looks.iter().find(|l| **l == north || **l == azimuth(180.0));
            let last = match channel.orientation {
                Some(Orientation::Up) => 0.002,
                other if Some(&other) == strongest => -0.04,
                _ => -0.005,
            };
            assert!(near(channel.acceleration[3], last), "{}: {:?}", channel.label, channel.acceleration);
        }
    }
    // 4 and 3 in the morning of 2001-01-01, UTC.
    assert_eq!(parse(cwb(), &ReadOptions::default()).unwrap()[0].clock, Some(978_321_600.0));
    assert_eq!(parse(jma(), &ReadOptions::default()).unwrap()[0].clock, Some(978_318_000.0));
}

#[test]
fn broken_files_of_networks_are_refused_at_their_lines() {
    refuses(
        &csmnc(),
        &[
            (["NO. OF POINTS:  11", "NO. OF POINTS:  12"], ["line 4", "samples: 11 (12 stated)"]),
            (["0.005  SEC", "x  SEC"], ["line 4", "interval is missing"]),
            (["CM/SEC/SEC", "CM/SEC"], ["line 3", "'CM/SEC' is not a unit of acceleration"]),
            (["-9.0 ", "x "], ["line 10", "'x' is not"]),
        ],
    );
    refuses(
        &bhrc(),
        &[
            (["POINTS =     12", "POINTS =     13"], ["line 6", "samples: 12 (13 stated)"]),
            (["DURATION =   0.060", "DURATION =   0"], ["line 6", "no number above 0"]),
            (["G/10", "FURLONGS"], ["line 7", "'FURLONGS'"]),
            ([" 3.5E-01", " 3.5F-01"], ["line 29", "no row of numbers"]),
        ],
    );
    refuses(
        &afad(),
        &[
            (["DATA          : 4", "DATA          : 5"], ["line 2", "samples: 4 (5 stated)"]),
            (["2.0  0.2  0.02", "2.0  0.2"], ["line 7", "numbers on this line: 2 (columns by line 5: 3)"]),
            (["(gal)", "(cm/s)"], ["line 4", "'cm/s' is not a unit"]),
        ],
    );
    refuses(
        &cwb(),
        &[
            (["5.010", "5.020"], ["line 10", "missing samples"]),
            (["Time U(+)", "U(+)"], ["line 8", "numbers on this line: 4"]),
            (["#RecordLength(sec): 0.02", "#RecordLength(sec): 90"], ["line 3", "90 s stated"]),
        ],
    );
    refuses(
        &jma(),
        &[(["= 100Hz", "= Hz"], ["line 2", "is no number"]), (["0.3,0.03", "0.3,x"], ["line 8", "'x'"])],
    );
    refuses(
        &asa(),
        &[
            (["/100/100/100", "/100/200/100"], ["line 2", "the channels differ"]),
            (["/4/4/4", "/4/4/3"], ["line 3", "the channels differ"]),
        ],
    );
    let other = ReadOptions { units: Some(Units::G), dt: Some(0.02), ..ReadOptions::default() };
    for file in [csmnc(), bhrc(), afad(), cwb(), jma(), asa()] {
        assert!(refusal(&file, &other).contains("was declared"));
    }
}
