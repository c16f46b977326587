//! Files as users have them (`tests/data`), each of one component or three of a test motion, with the figures by which they were written.

use std::path::{Path, PathBuf};

use tremolite_motion::{
    Channel, Error, Orientation, ReadOptions, TextColumn, Units, encoding, read, read_bytes,
};

/// Peak of the test motion (cm/s²).
const PEAK: f64 = 118.13957244064902;

fn path(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)
}

fn gal() -> ReadOptions {
    ReadOptions { units: Some(Units::CentimetrePerSecond2), ..ReadOptions::default() }
}

fn gal_every_5_ms() -> ReadOptions {
    ReadOptions { dt: Some(0.005), ..gal() }
}

fn columns(words: &[&str]) -> Option<Vec<TextColumn>> {
    words.iter().map(|w| w.parse().ok()).collect()
}

fn text(text: &str, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    read_bytes(Path::new("small.txt"), text.as_bytes(), options)
}

fn refusal(of: &str, options: &ReadOptions) -> String {
    text(of, options).unwrap_err().to_string()
}

/// The largest magnitude with its sign (m/s²).
fn peak(channel: &Channel) -> f64 {
    channel.acceleration.iter().fold(0.0f64, |most, a| if a.abs() > most.abs() { *a } else { most })
}

/// 1,200 samples every 5 ms with a peak of so many cm/s², to the figures of the file.
fn is_motion(channel: &Channel, expected: f64) {
    assert_eq!((channel.acceleration.len(), channel.dt), (1200, 0.005), "{}", channel.name);
    let found = peak(channel).abs() * 100.0;
    assert!((found - expected).abs() <= 1e-3, "{}: {found} cm/s2 against {expected}", channel.name);
}

fn degrees(channel: &Channel) -> Option<f64> {
    match channel.orientation? {
        Orientation::Azimuth(a) => Some((a.to_degrees() * 1e6).round() / 1e6),
        Orientation::Up => None,
    }
}

#[test]
fn a_stated_count_of_all_numbers_means_one_series_in_rows() {
    let file = path("rows_of_one_series_taken_for_columns.txt");
    let channel = read(&file, &gal_every_5_ms()).unwrap().remove(0);
    is_motion(&channel, PEAK);
    assert!(channel.remarks[0].contains("line 12 states 1200 samples"), "{:?}", channel.remarks);
    // What is declared is not taken for columns against the count.
    let skip = ["acceleration", "skip", "skip", "skip", "skip", "skip", "skip", "skip"];
    let declared = ReadOptions { columns: columns(&skip), ..gal_every_5_ms() };
    let message = read(&file, &declared).unwrap_err().to_string();
    assert!(message.contains("states 1200 samples") && message.contains("--columns rows"), "{message}");
}

#[test]
fn rows_without_a_stated_count_are_refused_with_both_readings_and_read_as_declared() {
    let rows = "1 2 3 4 5\n6 7 8 9 10\n11 12 13\n";
    let message = refusal(rows, &gal_every_5_ms());
    for part in [
        "line 1: numbers on a line: 5",
        "5 columns of 3 samples",
        "one series of 13 samples",
        "--columns rows",
    ] {
        assert!(message.contains(part), "{part}: {message}");
    }
    let declared = ReadOptions { columns: columns(&["rows"]), ..gal_every_5_ms() };
    let channel = text(rows, &declared).unwrap().remove(0);
    assert_eq!(channel.acceleration.len(), 13);
    assert!((channel.acceleration[12] - 0.13).abs() < 1e-15);
    assert_eq!(
        text(&format!("# columns = rows\n{rows}"), &gal_every_5_ms()).unwrap()[0].acceleration.len(),
        13
    );
    let torn = refusal("1 2 3\n4 5\n6 7 8\n", &declared);
    assert!(torn.contains("line 2: 2 number(s)") && torn.contains("complete"), "{torn}");
    let mixed = ReadOptions { columns: columns(&["rows", "skip", "skip"]), ..gal_every_5_ms() };
    assert!(refusal("1 2 3\n4 5 6\n", &mixed).contains("[\"rows\"] alone"));
    // A count that is that of the lines leaves columns what they are.
    let lines = "# NPTS = 3\n0 1\n0.005 2\n0.010 3\n";
    assert_eq!(text(lines, &gal()).unwrap()[0].acceleration, [0.01, 0.02, 0.03]);
}

#[test]
fn columns_are_declared_by_a_comment_of_the_file() {
    let numbers = "0.0 1 4\n0.1 2 5\n0.2 3 6\n";
    for written in ["[\"time\", \"N28W\", \"up\"]", "time, N28W, up", "time N28W up"] {
        let channels = text(&format!("# columns = {written}\n{numbers}"), &gal()).unwrap();
        assert_eq!(channels.len(), 2, "{written}");
        assert_eq!((degrees(&channels[0]), channels[1].orientation), (Some(332.0), Some(Orientation::Up)));
        assert_eq!(channels[1].acceleration, [0.04, 0.05, 0.06]);
    }
    let wrong = refusal(&format!("# columns = time, nord, up\n{numbers}"), &gal());
    assert!(wrong.contains("line 1: 'nord'") && wrong.contains("# columns = time, east, skip"), "{wrong}");
    let declared = ReadOptions { columns: columns(&["time", "east", "up"]), ..gal() };
    assert!(refusal(&format!("# columns = time, north, up\n{numbers}"), &declared).contains("other columns"));
    assert_eq!(text(&format!("# columns = time, east, up\n{numbers}"), &declared).unwrap().len(), 2);
}

#[test]
fn three_columns_are_read_as_declared() {
    let file = path("three_columns_have_no_place_on_the_command_line.txt");
    let message = read(&file, &gal_every_5_ms()).unwrap_err().to_string();
    assert!(message.contains("--columns time,acceleration,skip"), "{message}");
    let declared = ReadOptions { columns: columns(&["east", "north", "up"]), ..gal_every_5_ms() };
    let channels = read(&file, &declared).unwrap();
    assert_eq!(channels.len(), 3);
    is_motion(&channels[0], PEAK);
    assert_eq!(channels[1].orientation, Some(Orientation::NORTH));
}

#[test]
fn the_number_of_samples_and_the_interval_above_the_samples_are_a_header() {
    for name in [
        "npts_dt_line_above_one_column.txt",
        "npts_dt_line_above_two_columns.txt",
        "npts_and_dt_on_lines_of_their_own_read_as_samples.txt",
    ] {
        let channel = read(&path(name), &gal()).unwrap().remove(0);
        is_motion(&channel, PEAK);
        assert!(
            channel.remarks.iter().any(|r| r.contains("1200 samples every 0.005 s")),
            "{:?}",
            channel.remarks
        );
        let other = ReadOptions { dt: Some(0.01), ..gal() };
        assert!(read(&path(name), &other).unwrap_err().to_string().contains("dt = \"0.01 s\""), "{name}");
    }
    let rows = "0.005 6\n1 2 3 4\n5 6\n";
    assert_eq!(text(rows, &gal()).unwrap()[0].acceleration.len(), 6, "the interval first, samples in rows");
}

#[test]
fn a_header_with_another_number_of_samples_is_refused_at_its_line() {
    let samples =
        |count: usize| (0..count).map(|i| format!("{}\n", (i as f64 * 0.7).sin())).collect::<String>();
    let pairs =
        |count: usize| (0..count).map(|i| format!("{} {}\n", i as f64 * 0.005, i % 3)).collect::<String>();
    for bad in [
        format!("200 0.005\n{}", samples(199)),
        format!("200\n0.005\n{}", samples(199)),
        format!("200 0.005\n{}", pairs(199)),
    ] {
        let message = refusal(&bad, &gal_every_5_ms());
        assert!(
            message.contains("line 1: header: 200 samples") && message.contains("put # before"),
            "{message}"
        );
        let (head, rest) = bad.split_at(bad.find("0.005\n").unwrap() + 6);
        let followed = head.lines().map(|l| format!("# {l}\n")).collect::<String>() + rest;
        assert_eq!(text(&followed, &gal_every_5_ms()).unwrap()[0].acceleration.len(), 199);
    }
    // Samples that only begin with such numbers.
    assert_eq!(
        text(&format!("3\n0.5\n{}", samples(50)), &gal_every_5_ms()).unwrap()[0].acceleration.len(),
        52
    );
    assert_eq!(text("2 0.5\n2.005 1\n2.01 2\n", &gal()).unwrap()[0].start, 2.0);
}

#[test]
fn a_hole_in_times_is_named_at_its_line_without_a_remedy_that_closes_it() {
    let message = read(&path("hole_in_times_blamed_on_wrong_line.txt"), &gal()).unwrap_err().to_string();
    assert!(message.contains("line 703") && message.contains("from 3.5 s to 3.6 s"), "{message}");
    assert!(!message.contains("skip"), "{message}");
}

#[test]
fn a_vertical_that_is_positive_downwards_is_turned() {
    let channel =
        read(&path("peer_vertical_down_not_turned.AT2"), &ReadOptions::default()).unwrap().remove(0);
    assert_eq!(channel.orientation, Some(Orientation::Up));
    assert!(channel.remarks[0].contains("down is positive"), "{:?}", channel.remarks);
    is_motion(&channel, PEAK);
    // The file has -1.2046884E-01 g at its largest.
    assert!(peak(&channel) > 0.0);
    let comment = text("# direction = \"down\"\n0 1\n0.1 2\n", &gal()).unwrap().remove(0);
    assert_eq!(
        (comment.orientation, &comment.acceleration[..]),
        (Some(Orientation::Up), &[-0.01, -0.02][..])
    );
}

#[test]
fn an_smc_azimuth_counts_without_the_angle_from_the_vertical() {
    let file = path("smc_azimuth_lost_where_the_vertical_angle_is_not_given.smc");
    let channel = read(&file, &ReadOptions::default()).unwrap().remove(0);
    assert_eq!((channel.label.as_str(), degrees(&channel)), ("90 deg", Some(90.0)));
    assert!(channel.remarks[0].contains("integer 14"), "{:?}", channel.remarks);
    let whole = std::fs::read_to_string(&file).unwrap();
    let changed = |words: &str, azimuth: &str| {
        let text = whole
            .replace("component= 090", words)
            .replace("-32768        90 ", &format!("-32768{azimuth:>10} "));
        read_bytes(&file, text.as_bytes(), &ReadOptions::default()).unwrap().remove(0)
    };
    let at_odds = changed("component= 180", "90");
    assert!(at_odds.orientation.is_none() && at_odds.remarks[0].contains("contradicts"));
    assert_eq!(changed("component= UP", "0").orientation, Some(Orientation::Up));
    assert_eq!(changed("component= ?", "0").orientation, None);
    assert_eq!(degrees(&changed("component= ?", "90")), Some(90.0));
}

/// Files that need no declaration: the orientations by channel, and the peak of the strongest.
#[test]
fn files_of_networks_are_read_as_they_are() {
    let (north, east, up) = (Some(Orientation::NORTH), Some(Orientation::EAST), Some(Orientation::Up));
    let azimuth = |degrees| Some(Orientation::from_degrees(degrees));
    for (name, looks) in [
        ("china_csmnc_eight_values_a_line.dat", vec![east]),
        ("iran_bhrc_three_components.V1", vec![azimuth(352.0), up, azimuth(82.0)]),
        ("turkey_afad_three_columns.txt", vec![north, east, up]),
        ("taiwan_cwb_four_columns.dat", vec![up, north, east]),
        ("mexico_asa2_three_columns.101", vec![up, north, east]),
        ("japan_jma.csv", vec![north, east, up]),
    ] {
        let channels = read(&path(name), &ReadOptions::default()).unwrap();
        assert_eq!(channels.iter().map(|c| c.orientation).collect::<Vec<_>>(), looks, "{name}");
        let strongest = channels.iter().max_by(|a, b| peak(a).abs().total_cmp(&peak(b).abs())).unwrap();
        is_motion(strongest, PEAK);
    }
}

#[test]
fn a_sac_file_is_read_with_its_unit_declared() {
    let file = path("binary_record_told_to_put_hash.sac");
    let channel = read(&file, &gal()).unwrap().remove(0);
    is_motion(&channel, PEAK);
    assert_eq!((channel.format, channel.orientation), ("SAC", Some(Orientation::EAST)));
    let message = read(&file, &ReadOptions::default()).unwrap_err().to_string();
    assert!(message.contains("--units cm/s2") && !message.contains('#'), "{message}");
}

/// The figures of `independent.py`, which shares nothing with the readers.
#[test]
fn an_independent_reader_finds_the_same_figures() {
    let mut compared = 0;
    for line in include_str!("../data/independent.csv").lines().skip(1) {
        let [name, component, npts, dt, pga] = line.split(',').collect::<Vec<_>>()[..] else {
            panic!("{line}")
        };
        let channels = read(&path(name), &ReadOptions::default()).unwrap();
        let channel = &channels[component.parse::<usize>().unwrap()];
        assert_eq!(
            (channel.acceleration.len(), channel.dt),
            (npts.parse().unwrap(), dt.parse().unwrap()),
            "{line}"
        );
        let pga: f64 = pga.parse().unwrap();
        assert!((peak(channel) - pga).abs() <= 1e-13 * pga.abs(), "{line}: {}", peak(channel));
        compared += 1;
    }
    assert_eq!(compared, 13);
}

#[test]
fn names_in_another_encoding_do_not_hinder_a_record() {
    let gbk = b"# \xce\xa7\xd1\xd2\n# units = \"cm/s2\"\n0 1\n0.1 2\n";
    let read = |bytes: &[u8], name: &str| {
        let encoding = encoding(name).ok();
        read_bytes(Path::new("a"), bytes, &ReadOptions { encoding, ..ReadOptions::default() })
    };
    let assumed = read(gbk, "").unwrap().remove(0);
    assert_eq!(assumed.acceleration, [0.01, 0.02]);
    assert!(assumed.remarks[0].contains("gb18030"), "{:?}", assumed.remarks);
    assert!(read(gbk, "gbk").unwrap()[0].remarks.is_empty());
    assert!(
        read(b"# caf\xe9 \n# units = g\n0 1\n1 2\n", "").unwrap()[0].remarks[0].contains("neither UTF-8")
    );
    let wrong = read(b"# \xff\n# units = g\n0 1\n1 2\n", "big5").unwrap_err().to_string();
    assert!(wrong.contains("no characters of Big5"), "{wrong}");
    let units = "# units = \"g\"\n0 1\n0.1 2\n";
    let utf16: Vec<u8> =
        [0xfeff].into_iter().chain(units.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    assert_eq!(read(&utf16, "").unwrap()[0].dt, 0.1);
}

/// StationXML of ObsPy beside the records of ObsPy.
fn with_stations() -> ReadOptions {
    ReadOptions::default().with_sensitivity("obspy.xml", |name| path(name.to_str().unwrap())).unwrap()
}

#[test]
fn files_of_obspy_are_read_with_its_figures() {
    let mut compared = 0;
    for line in include_str!("../data/others.csv").lines().skip(1) {
        let [name, points, interval, extreme, index, azimuth, counts] =
            line.split(',').collect::<Vec<_>>()[..]
        else {
            panic!("{line}")
        };
        let options = if name.ends_with(".mseed") {
            with_stations()
        } else {
            ReadOptions { units: Some(Units::MetrePerSecond2), ..ReadOptions::default() }
        };
        let channel = read(&path(name), &options).unwrap().remove(0);
        let number = |word: &str| word.parse::<f64>().unwrap();
        assert_eq!(
            (channel.acceleration.len() as f64, channel.dt),
            (number(points), number(interval)),
            "{line}"
        );
        let expected = number(extreme) / number(counts);
        assert!((peak(&channel) - expected).abs() <= 1e-14 * expected.abs(), "{line}: {}", peak(&channel));
        assert_eq!(channel.acceleration[index.parse::<usize>().unwrap()], peak(&channel), "{line}");
        assert_eq!(degrees(&channel), Some(number(azimuth)), "{line}");
        // 2015-03-04 05:06:07.25, UTC.
        assert!(channel.clock.is_some_and(|clock| (clock - 1_425_445_567.25).abs() < 1e-6), "{line}");
        compared += 1;
    }
    assert_eq!(compared, 2);
}

#[test]
fn station_metadata_beside_miniseed_are_taken_by_channel_and_epoch() {
    let horizontal = read(&path("obspy_HN1.mseed"), &with_stations()).unwrap().remove(0);
    for part in ["200000 counts/(m/s2) at 1 Hz", "epoch since 2014-01-01", "response was not removed"] {
        assert!(horizontal.remarks.iter().any(|r| r.contains(part)), "{part}: {:?}", horizontal.remarks);
    }
    let vertical = read(&path("obspy_HNZ.mseed"), &with_stations()).unwrap().remove(0);
    assert_eq!(vertical.orientation, Some(Orientation::Up));
    assert!(peak(&vertical) > 0.0 && peak(&horizontal) < 0.0, "a dip of 90 degrees is downwards");
    let refused = |name: &str| read(&path(name), &with_stations()).unwrap_err().to_string();
    let across = refused("obspy_HN2.mseed");
    assert!(across.contains("lies in 2 epochs") && across.contains("cut the record"), "{across}");
    assert!(refused("obspy_HHZ.mseed").contains("velocity sensor"));
    let sac = ReadOptions { units: None, ..with_stations() };
    let sac = read(&path("obspy.sac"), &sac).unwrap().remove(0);
    assert!((peak(&sac) + 19570.837890625 / 2e5).abs() < 1e-15 && !sac.raw);
    let missing = ReadOptions::default().with_sensitivity("none.xml", |name| path(name.to_str().unwrap()));
    assert!(missing.unwrap_err().contains("none.xml"));
}

#[test]
fn files_that_are_no_records_are_named_with_a_way_on() {
    let shipped = |name: &str| std::fs::read(path(name)).unwrap();
    let mut hdf5_matlab = b"MATLAB 7.3 MAT-file, Platform: GLNXA64".to_vec();
    hdf5_matlab.resize(512, b' ');
    hdf5_matlab.extend(b"\x89HDF\r\n\x1a\n");
    let mut workbook = b"PK\x03\x04".to_vec();
    workbook.resize(30, 0);
    workbook.extend(b"[Content_Types].xml");
    let win32 =
        [&[0; 4][..], &[0x20, 0x18, 0x01, 0x24, 0x10, 0x51, 0x37, 0, 0, 0, 0, 10, 0, 0, 0, 20]].concat();
    let win = [&[0, 0, 0, 12, 0x17, 0x01, 0x26, 0, 0x03, 0, 1, 2][..]; 2].concat();
    for (bytes, kind, way) in [
        (shipped("numpy.npy"), "NumPy array", "numpy.savetxt"),
        (shipped("scipy.mat"), "MATLAB file", "scipy.io.loadmat"),
        (shipped("h5py.h5"), "HDF5 file", "h5py.File"),
        (hdf5_matlab, "MATLAB file (.mat 7.3", "h5py.File"),
        (workbook, "workbook of Excel", "CSV"),
        (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1".to_vec(), "workbook of Excel", "CSV"),
        (
            b"version https://git-lfs.github.com/spec/v1\noid sha256:0\n".to_vec(),
            "pointer of Git LFS",
            "git lfs pull",
        ),
        (win32, "WIN32", "export"),
        (win, "file of WIN", "obspy.read"),
        (b"K\x01\x01\x14\0\0\x01\x07\xf8\0\0\x12".to_vec(), "Kinemetrics", "obspy.read"),
        (b"000001V 010009402.3121970,001\0".to_vec(), "full SEED volume", "obspy.read"),
        (b"<!DOCTYPE html>\n<html>1 2</html>".to_vec(), "web page", "download"),
        (shipped("obspy.xml"), "StationXML", "--sensitivity"),
        (b"<?xml version='1.0'?><a/>".to_vec(), "XML", "two columns of text"),
        (b"%PDF-1.7".to_vec(), "PDF", "the record itself"),
        (b"BZh9".to_vec(), "bzip2", "bunzip2"),
        (b"\xfd7zXZ\0".to_vec(), "xz", "unxz"),
        (b"\x28\xb5\x2f\xfd".to_vec(), "Zstandard", "unzstd"),
        (b"\x04\x22\x4d\x18".to_vec(), "LZ4", "unlz4"),
        (b"7z\xbc\xaf\x27\x1c".to_vec(), "7-Zip", "7z x"),
        (b"Rar!\x1a\x07".to_vec(), "RAR", "unrar"),
        (b"\x01\x02\0\x03 1 2 3".to_vec(), "binary file of no format", "two columns of text"),
    ] {
        let message = read_bytes(Path::new("x"), &bytes, &gal_every_5_ms()).unwrap_err().to_string();
        assert!(
            message.contains(kind) && message.contains(way) && !message.contains('#'),
            "{kind}: {message}"
        );
    }
}
