//! SAC, with and without StationXML.

use std::path::Path;
use std::sync::Arc;

use tremolite_motion::{Orientation, ReadOptions, Stations, Units};

use super::{one, refusal};

/// Words of the header that are set, by their index: floats, integers, texts of eight characters.
const FLOATS: [(usize, f32); 4] = [(0, 0.005), (5, 2.5), (57, 30.0), (58, 90.0)];
const INTEGERS: [(usize, i32); 10] =
    [(70, 2001), (71, 1), (72, 12), (73, 0), (74, 0), (75, 250), (76, 6), (79, 5), (85, 1), (105, 1)];
const TEXTS: [(usize, &str); 3] = [(110, "TEST    "), (150, "HN1     "), (152, "XX      ")];

/// Five samples, 1 to 5.
pub fn small(big: bool) -> Vec<u8> {
    let mut words = vec![(-12345.0f32).to_bits(); 70];
    words.extend(vec![(-12345i32) as u32; 40]);
    for (i, v) in FLOATS {
        words[i] = v.to_bits();
    }
    for (i, v) in INTEGERS {
        words[i] = v as u32;
    }
    let order = |w: u32| if big { w.to_be_bytes() } else { w.to_le_bytes() };
    let mut bytes: Vec<u8> = words.into_iter().flat_map(order).collect();
    bytes.extend(b"-12345  ".repeat(24));
    for (i, text) in TEXTS {
        bytes[4 * i..4 * i + 8].copy_from_slice(text.as_bytes());
    }
    bytes.extend((1..=5).flat_map(|k| order((k as f32).to_bits())));
    bytes
}

fn gal() -> ReadOptions {
    ReadOptions { units: Some(Units::CentimetrePerSecond2), ..ReadOptions::default() }
}

fn with(bytes: &[u8], word: usize, value: [u8; 4]) -> Vec<u8> {
    let mut changed = bytes.to_vec();
    changed[4 * word..4 * word + 4].copy_from_slice(&value);
    changed
}

/// One channel in two epochs, and a seismometer.
pub const STATIONS: &str = r#"<?xml version="1.0"?>
<FDSNStationXML xmlns="http://www.fdsn.org/xml/station/1" schemaVersion="1.1"><Network code="XX"><Station code="TEST">
<Channel code="HN1" locationCode="" startDate="2000-01-01T00:00:00" endDate="2001-01-01T12:00:04Z"><Azimuth>330</Azimuth><Dip>0</Dip>
<Response><InstrumentSensitivity><Value>200</Value><Frequency>1</Frequency><InputUnits><Name>M/S**2</Name></InputUnits>
<OutputUnits><Name>COUNTS</Name></OutputUnits></InstrumentSensitivity></Response></Channel>
<Channel code="HN1" locationCode="" startDate="2001-01-01T12:00:04" endDate="2599-12-31T23:59:59"><Azimuth>30</Azimuth><Dip>90</Dip>
<Response><InstrumentSensitivity><Value>400</Value><Frequency>1</Frequency><InputUnits><Name>M/S**2</Name></InputUnits>
<OutputUnits><Name>COUNTS</Name></OutputUnits></InstrumentSensitivity></Response></Channel>
<Channel code="HHZ" locationCode=""><Azimuth>0</Azimuth><Dip>-90</Dip><Response><InstrumentSensitivity><Value>1</Value>
<InputUnits><Name>M/S</Name></InputUnits><OutputUnits><Name>COUNTS</Name></OutputUnits></InstrumentSensitivity></Response></Channel>
</Station></Network></FDSNStationXML>"#;

fn stations(text: &str) -> ReadOptions {
    let stations = Stations::from_bytes(Path::new("XX.xml"), text.as_bytes()).unwrap();
    ReadOptions { stations: Some(Arc::new(stations)), ..ReadOptions::default() }
}

#[test]
fn both_byte_orders_give_the_same_record() {
    for big in [false, true] {
        let channel = one(small(big), &gal());
        assert_eq!((channel.format, channel.dt, channel.start), ("SAC", 0.005, 2.5));
        assert_eq!(channel.orientation, Some(Orientation::from_degrees(30.0)));
        // 2001-01-01 12:00:00.25, and the first sample 2.5 s later.
        assert_eq!(channel.clock, Some(978_350_402.75));
        assert!((channel.acceleration[4] - 0.05).abs() < 1e-15);
    }
    let turned = one(with(&small(false), 58, 180f32.to_le_bytes()), &gal());
    assert_eq!((turned.orientation, turned.acceleration[0]), (Some(Orientation::Up), -0.01));
}

#[test]
fn what_a_sac_file_does_not_state_is_asked_for() {
    let good = small(false);
    assert!(refusal(&good, &ReadOptions::default()).contains("units = \"cm/s2\" (--units cm/s2)"));
    for (word, value, part) in [
        (86, 7i32.to_le_bytes(), "velocity"),
        (79, 6i32.to_le_bytes(), "samples: 5 (6 stated)"),
        (105, 0i32.to_le_bytes(), "no equally spaced time series"),
        (0, 0f32.to_le_bytes(), "interval 0 s"),
        (160, f32::NAN.to_le_bytes(), "sample 3 is not finite"),
    ] {
        let message = refusal(with(&good, word, value), &gal());
        assert!(message.contains(part) && message.contains("byte"), "{message}");
    }
    let velocity = {
        let mut bytes = good.clone();
        bytes[600..603].copy_from_slice(b"HHZ");
        bytes
    };
    let counts = ReadOptions { sensitivity: "200 counts/(m/s2)".parse().ok(), ..ReadOptions::default() };
    assert!(refusal(&velocity, &counts).contains("not of an accelerometer"));
    assert!((one(&good, &counts).acceleration[0] - 0.005).abs() < 1e-15);
}

#[test]
fn station_metadata_give_sensitivity_and_direction_by_epoch() {
    let good = small(false);
    let first = one(&good, &stations(STATIONS));
    assert!((first.acceleration[1] - 0.01).abs() < 1e-15 && !first.raw);
    assert_eq!(first.orientation, Some(Orientation::from_degrees(330.0)));
    assert!(
        first.remarks[0].contains("200 counts/(m/s2) at 1 Hz, by XX.xml, epoch since 2000-01-01"),
        "{:?}",
        first.remarks
    );
    assert!(first.remarks[1].contains("response was not removed"));
    // Two seconds later the other epoch, whose sensor looks down.
    let second = one(with(&good, 74, 2i32.to_le_bytes()), &stations(STATIONS));
    assert_eq!((second.orientation, second.acceleration[1]), (Some(Orientation::Up), -0.005));
}

#[test]
fn records_of_two_epochs_and_channels_without_metadata_are_refused() {
    let good = small(false);
    // From 3.99 s to 4.01 s after noon.
    let across = with(&with(&good, 74, 1i32.to_le_bytes()), 75, 490i32.to_le_bytes());
    let message = refusal(&across, &stations(STATIONS));
    assert!(message.contains("lies in 2 epochs") && message.contains("cut the record"), "{message}");
    let early = with(&good, 70, 1999i32.to_le_bytes());
    assert!(refusal(&early, &stations(STATIONS)).contains("no epoch at the time"));
    let other = STATIONS.replace("\"HN1\"", "\"HN2\"");
    assert!(
        refusal(&good, &stations(&other))
            .contains("XX.TEST..HN1: not in XX.xml, which has XX.TEST..HN2, XX.TEST..HHZ")
    );
    let without = STATIONS.replace("InstrumentSensitivity", "Other");
    assert!(refusal(&good, &stations(&without)).contains("no InstrumentSensitivity"));
    let velocity = STATIONS.replace("M/S**2", "M/S");
    assert!(refusal(&good, &stations(&velocity)).contains("velocity sensor"));
    let untimed = with(&good, 70, (-12345i32).to_le_bytes());
    assert!(refusal(&untimed, &stations(STATIONS)).contains("states no time"));
    assert!(
        refusal("# units = \"g\"\n0 1\n0.1 2\n", &stations(STATIONS)).contains("serves miniSEED and SAC")
    );
}

#[test]
fn broken_station_metadata_are_refused() {
    for (text, part) in [
        ("", "no XML"),
        ("<a/>", "no StationXML"),
        ("<FDSNStationXML/>", "describes no channel"),
        (&STATIONS.replace("2000-01-01T", "2000-13-01T"), "startDate of XX.TEST..HN1"),
        (&STATIONS[..500], "no XML"),
    ] {
        let message = Stations::from_bytes(Path::new("XX.xml"), text.as_bytes()).unwrap_err().to_string();
        assert!(message.contains(part) && message.contains("XX.xml"), "{message}");
    }
    assert!(Stations::read(Path::new("/no/such.xml")).is_err());
}
