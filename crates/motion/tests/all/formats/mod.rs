//! Formats of records, one module each: small files written here, and real ones where they are at hand ([`crate::records`]).

mod cosmos;
mod csmip;
mod esm;
mod figures;
mod geonet;
mod itaca;
mod knet;
mod mseed;
mod mseed_records;
mod networks;
mod pairs;
pub mod sac;
mod smc;
mod usc;

use std::path::Path;

use tremolite_motion::{Channel, Error, ReadOptions, read, read_bytes};

/// Small good files of one format, for [`crate::hostile`] to damage; none of a format that has no module here.
pub fn good(format: &str) -> Vec<Vec<u8>> {
    let text = |files: Vec<String>| files.into_iter().map(String::into_bytes).collect();
    match format {
        "COSMOS" => text(vec![cosmos::small(), cosmos::small_counts()]),
        "SMC" => text(vec![smc::small(), smc::small_pairs()]),
        "CSMIP, CDMG, USC" => text(vec![csmip::small_v2(), csmip::small_v1(), usc::small_pairs()]),
        "K-NET, KiK-net" => text(vec![knet::small()]),
        "ESM (DYNA)" => text(vec![esm::small()]),
        "ITACA" => text(vec![itaca::small()]),
        "miniSEED" => mseed::small(),
        "SAC" => vec![sac::small(false), sac::small(true)],
        "CSMNC" => text(vec![networks::csmnc()]),
        "BHRC" => text(vec![networks::bhrc()]),
        "AFAD, CWB, JMA, ASA" => {
            text(vec![networks::afad(), networks::cwb(), networks::jma(), networks::asa()])
        }
        _ => Vec::new(),
    }
}

fn parse(bytes: impl AsRef<[u8]>, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    read_bytes(Path::new("small"), bytes.as_ref(), options)
}

fn one(bytes: impl AsRef<[u8]>, options: &ReadOptions) -> Channel {
    let mut channels = parse(bytes, options).unwrap();
    assert_eq!(channels.len(), 1);
    channels.remove(0)
}

fn refusal(bytes: impl AsRef<[u8]>, options: &ReadOptions) -> String {
    parse(bytes, options).unwrap_err().to_string()
}

/// Checks that changes of a good file are refused with both parts of a message. A change is a text and what stands in its place.
fn refuses(good: &str, faults: &[([&str; 2], [&str; 2])]) {
    for ([old, new], parts) in faults {
        let bad = good.replacen(old, new, 1);
        assert_ne!(bad, good, "{old:?} is not in the file");
        let message = refusal(&bad, &ReadOptions::default());
        assert!(parts.iter().all(|p| message.contains(p)), "{old:?} to {new:?}: {message}");
    }
}

/// What an independent reading of a real file found: m/s², or counts where they are raw.
struct Figures {
    file: &'static str,
    npts: usize,
    dt: f64,
    /// Largest magnitude as it stands, with its sign, and its index.
    peak: (f64, usize),
    /// The same with the mean taken off.
    about_mean: (f64, usize),
    ends: (f64, f64),
}

/// Compares a real file that holds one channel with its figures, and returns the channel; `None` where it is not at hand.
fn compared(figures: &Figures) -> Option<Channel> {
    let mut channels = read(&crate::records::local(figures.file)?, &ReadOptions::default()).unwrap();
    assert_eq!(channels.len(), 1);
    let channel = channels.remove(0);
    let a = &channel.acceleration;
    let mean = a.iter().sum::<f64>() / a.len() as f64;
    let peak = |offset: f64| {
        a.iter().enumerate().fold((0.0f64, 0), |(most, at), (i, v)| {
            if (v - offset).abs() > most.abs() { (v - offset, i) } else { (most, at) }
        })
    };
    // Both readings round each sample a few times, and the mean sums up to 60,000 of them.
    let near = |x: f64, y: f64| (x - y).abs() <= 1e-13 * figures.peak.0.abs();
    let name = figures.file;
    assert_eq!((a.len(), channel.dt), (figures.npts, figures.dt), "{name}");
    let (raw, about_mean) = (peak(0.0), peak(mean));
    println!(
        "{name}: {} samples of {} s, {}, peak {} at {}",
        a.len(),
        channel.dt,
        channel.units,
        raw.0,
        raw.1
    );
    assert!(near(raw.0, figures.peak.0) && raw.1 == figures.peak.1, "{name}: {raw:?}");
    let expected = figures.about_mean;
    assert!(near(about_mean.0, expected.0) && about_mean.1 == expected.1, "{name}: {about_mean:?}");
    assert!(near(a[0], figures.ends.0) && near(a[a.len() - 1], figures.ends.1), "{name}");
    Some(channel)
}
