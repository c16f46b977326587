//! Records of earthquakes.

use std::path::Path;
use std::sync::Arc;
use tremolite_motion::{ReadOptions, Stations, Units, read_bytes, recognised};

/// Reads content of one format, as it is and with what it may leave open. Channels that are handed out are finite numbers at a step above 0.
pub fn read(format: &str, bytes: &[u8]) -> bool {
    if recognised(bytes).is_none_or(|known| known.name != format) {
        return false;
    }
    let told =
        ReadOptions { units: Some(Units::CentimetrePerSecond2), dt: Some(0.01), ..ReadOptions::default() };
    for options in [ReadOptions::default(), told] {
        let Ok(channels) = read_bytes(Path::new("record"), bytes, &options) else {
            continue;
        };
        assert!(!channels.is_empty(), "a file that is read has a channel");
        for channel in channels {
            assert!(channel.dt > 0.0 && channel.dt.is_finite(), "{}", channel.dt);
            assert!(channel.acceleration.iter().all(|a| a.is_finite()));
        }
    }
    true
}

/// Reads StationXML, and a record of miniSEED with it.
pub fn stations(bytes: &[u8]) -> bool {
    let Ok(stations) = Stations::from_bytes(Path::new("stations.xml"), bytes) else { return false };
    let options = ReadOptions { stations: Some(Arc::new(stations)), ..ReadOptions::default() };
    let record = include_bytes!("../../../crates/motion/tests/data/obspy_HN1.mseed");
    if let Ok(channels) = read_bytes(Path::new("record"), record, &options) {
        assert!(channels.iter().all(|c| !c.raw && c.acceleration.iter().all(|a| a.is_finite())));
    }
    true
}
