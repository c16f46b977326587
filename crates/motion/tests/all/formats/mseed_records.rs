//! Records of miniSEED: headers, encodings, faults.

use miniseed_rs::{ByteOrder, EncodingFormat, Samples, crc, encode};
use tremolite_motion::{ReadOptions, Units};

use super::mseed::{BEGIN, INTS, built, ints, none, record};
use super::{one, refusal};

#[test]
fn every_encoding_of_both_versions_gives_the_samples_that_were_written() {
    // Differences of every width: 4, 5, 6, 8, 10, 15, 16 and 30 bits.
    let mut wave = vec![5, 6, 0, 1, -3, 4, 4, 5, 15, 0, 14, -1, 10, 20, -10, 20, 0, 30, -1, 100, 0, -100, 20];
    wave.extend([500, 100, -300, 16_000, 0, -16_000, 300_000_000, -200_000_000, 7, -7, 9]);
    let floats: Vec<f32> = wave.iter().map(|v| *v as f32 / 8.0).collect();
    let doubles: Vec<f64> = wave.iter().map(|v| f64::from(*v) / 3.0).collect();
    let exact: Vec<f64> = wave.iter().copied().map(f64::from).collect();
    let short: Vec<i32> = wave.iter().map(|v| v % 30_000).collect();
    for version in [2, 3] {
        for (encoding, samples, expected) in [
            (
                EncodingFormat::Int16,
                Samples::Int(short.clone()),
                short.iter().copied().map(f64::from).collect(),
            ),
            (INTS, Samples::Int(wave.clone()), exact.clone()),
            (EncodingFormat::Steim1, Samples::Int(wave.clone()), exact.clone()),
            (EncodingFormat::Steim2, Samples::Int(wave.clone()), exact.clone()),
            (
                EncodingFormat::Float32,
                Samples::Float(floats.clone()),
                floats.iter().copied().map(f64::from).collect(),
            ),
            (EncodingFormat::Float64, Samples::Double(doubles.clone()), doubles.clone()),
        ] {
            // The crate turns all four bytes of a little-endian word of Steim's round, whatever it holds; libmseed does not.
            let steim = matches!(encoding, EncodingFormat::Steim1 | EncodingFormat::Steim2);
            for order in [ByteOrder::Big, ByteOrder::Little].into_iter().take(if steim { 1 } else { 2 }) {
                let mut record = built(version, "HNE", 0, encoding, samples.clone()).with_record_length(1024);
                record.byte_order = order;
                let channel = one(encode(&record).unwrap(), &none());
                assert_eq!(channel.acceleration, expected, "version {version}, {encoding}, {order:?}");
                assert_eq!((channel.dt, channel.clock), (0.01, Some(BEGIN)), "version {version}");
                assert_eq!((channel.units, channel.raw), (Units::Counts, true));
            }
        }
    }
}

/// Little-endian records, header and all, which ObsPy 1.5.1 (libmseed) wrote of these samples: 8, 16, 32 bits and Steim 2's.
#[test]
fn little_endian_differences_are_those_of_libmseed() {
    let data = [
        "e80300000a000800000000000000000000c06a0105000000090000000001fa01\
         fc070001c3000cfeac3f80c180c16f3e1a",
        "e80300000b00080000000000000000000000aa030500000009000000701c1a80\
         0c0e13c08041d69f6f3ec0a01a000040",
    ];
    let header = "3030303030314420434c4320202020484e454349e307bb000313350090010f00\
                  64000100000000010000000040003000";
    for data in data {
        let text = format!("{header}{data}");
        let mut bytes: Vec<u8> =
            (0..text.len() / 2).map(|i| u8::from_str_radix(&text[2 * i..2 * i + 2], 16).unwrap()).collect();
        bytes.resize(256, 0);
        let channel = one(&bytes, &none());
        let wave = [5, 6, 0, 1, -3, 4, 4, 5, 200, -300, 16000, 0, -16000, -17, 9].map(f64::from);
        assert_eq!((channel.acceleration.as_slice(), channel.dt), (&wave[..], 0.01));
        assert_eq!((channel.clock, channel.name.as_str()), (Some(BEGIN), "small"));
    }
}

/// Encoders that go on from the record before leave a first difference other than 0, which the first sample has in it
/// (SEED manual, appendix B).
#[test]
fn the_first_difference_of_a_record_leads_there_from_the_one_before() {
    let mut file = record(2, "HNE", 0, EncodingFormat::Steim1, Samples::Int(vec![40, 41, 43, 46]));
    assert_eq!(file[76..80], [0, 1, 2, 3]);
    file[76] = 7;
    assert_eq!(one(&file, &none()).acceleration, [40.0, 41.0, 43.0, 46.0]);
}

#[test]
fn what_the_headers_say_of_time_is_heeded() {
    let mut file = ints(2, "HNE", 0, &[1, 2, 3]);
    // The data move to 64 for a blockette 1001, then one of 100: 0.25 s of correction, 63 µs, 99.5 Hz.
    let data = file[56..68].to_vec();
    file[80..92].copy_from_slice(&data);
    file[44..46].copy_from_slice(&80u16.to_be_bytes());
    file[40..44].copy_from_slice(&2500i32.to_be_bytes());
    file[50..52].copy_from_slice(&56u16.to_be_bytes());
    file[56..64].copy_from_slice(&[3, 233, 0, 64, 100, 63, 0, 0]);
    file[64..68].copy_from_slice(&[0, 100, 0, 0]);
    file[68..72].copy_from_slice(&99.5f32.to_be_bytes());
    let channel = one(&file, &none());
    assert_eq!((channel.acceleration.as_slice(), channel.dt), (&[1.0, 2.0, 3.0][..], 1.0 / 99.5));
    assert!((channel.clock.unwrap() - BEGIN - 0.250_063).abs() < 1e-6);
    // The correction is in the start already.
    file[36] = 2;
    assert!((one(&file, &none()).clock.unwrap() - BEGIN - 0.000_063).abs() < 1e-6);
    for (factor, multiplier, dt) in [(100i16, 1i16, 0.01), (1000, -10, 0.01), (-50, 1, 50.0), (-5, -4, 20.0)]
    {
        let mut file = ints(2, "HNE", 0, &[1, 2, 3]);
        file[32..34].copy_from_slice(&factor.to_be_bytes());
        file[34..36].copy_from_slice(&multiplier.to_be_bytes());
        assert_eq!(one(&file, &none()).dt, dt);
    }
    let mut period = built(3, "HNE", 0, INTS, Samples::Int(vec![1, 2]));
    period.sample_rate = -0.25;
    assert_eq!(one(encode(&period).unwrap(), &none()).dt, 0.25);
}

#[test]
fn records_without_samples_are_passed_over() {
    let mut log = ints(2, "LOG", 0, &[1, 2]);
    log[52] = 0;
    let empty = ints(2, "HNN", 0, &[]);
    let file = [log.clone(), empty, ints(2, "HNE", 0, &[1, 2])].concat();
    assert_eq!(one(file, &none()).name, "small");
    assert!(refusal(log, &none()).contains("no record holds samples"));
}

#[test]
fn faults_are_named_with_their_byte() {
    let good = ints(2, "HNE", 0, &[1, 2, 3]);
    let next = ints(2, "HNE", 3, &[4, 5, 6]);
    // Changes of the second record, each of one byte.
    for (at, value, part) in [
        (0, b'x', "no record of miniSEED begins here"),
        (23, 0, "has the date 2019, day 0"),
        (30, 1, "promises 259 samples"),
        (33, 0, "no rate of them"),
        (47, 0, "no blockette 1000"),
        (49, 0, "no blockette 1000"),
        (52, 30, "encoding 30, which is not read; write it anew"),
        (52, 10, "its differences lead to"),
        (54, 6, "length of 2^6 bytes"),
        (54, 40, "length of 2^40 bytes"),
        (54, 8, "has 256 bytes, but 128 are left"),
        (44, 255, "promises 3 samples of 4 bytes and has 0 bytes"),
    ] {
        let mut next = next.clone();
        next[at] = value;
        if value == 10 {
            next[45] = 64;
            next[67] = 0x80;
            next[64] = 0x03;
            next[75] = 9;
        }
        let message = refusal([good.clone(), next].concat(), &none());
        assert!(message.contains("small, byte 128: ") && message.contains(part), "{at}: {message}");
    }
    let whole = [good.clone(), next].concat();
    for end in 129..256 {
        assert!(refusal(&whole[..end], &none()).contains("small, byte 128: "), "{end}");
    }
    let nan = record(2, "HNE", 0, EncodingFormat::Float32, Samples::Float(vec![1.0, f32::NAN]));
    assert!(refusal(nan, &none()).contains("byte 0: the record that begins here is broken: sample 2"));
    let single = refusal(ints(2, "HNE", 0, &[7]), &none());
    assert!(single.contains("byte 0: 1 sample(s)"), "{single}");
    let dt = ReadOptions { dt: Some(0.02), ..none() };
    assert!(refusal(good, &dt).contains("byte 0: the file states an interval of 0.01 s"));
    let mut volume = b"000001V 010009402.4122019".to_vec();
    volume.resize(4096, b' ');
    assert!(refusal(volume, &none()).contains("byte 0: this is a full SEED volume"));
}

/// A ring of blockettes, counts beyond the data, differences that overflow: none is followed, reserved for, or panics.
#[test]
fn headers_made_to_break_readers_are_refused() {
    let mut ring = ints(2, "HNE", 0, &[1, 2]);
    ring[48..52].copy_from_slice(&[0, 99, 0, 48]);
    assert!(refusal(ring, &none()).contains("no blockette 1000"));
    for encoding in [EncodingFormat::Steim1, EncodingFormat::Steim2, INTS] {
        let mut huge = record(3, "HNE", 0, encoding, Samples::Int(vec![1, 2]));
        for (count, part) in
            [(1u32 << 26, "broken: it promises 67108864"), ((1 << 26) + 1, "the file too long")]
        {
            huge[24..28].copy_from_slice(&count.to_le_bytes());
            crc::compute_v3_crc(&mut huge);
            let message = refusal(&huge, &none());
            assert!(message.contains(part) && !message.contains("has 2"), "{message}");
        }
        huge[24..28].copy_from_slice(&(1u32 << 26).to_le_bytes());
        crc::compute_v3_crc(&mut huge);
        let second = [ints(3, "HNE", 0, &[1, 2]), huge.clone()].concat();
        assert!(refusal(second, &none()).contains("the file too long"));
        huge[36..40].copy_from_slice(&u32::MAX.to_le_bytes());
        assert!(refusal(&huge, &none()).contains("bytes, but"));
    }
    let wave = Samples::Int(vec![i32::MAX - 1, i32::MIN, i32::MAX, 0]);
    let wraps = record(3, "HNE", 0, EncodingFormat::Steim1, wave);
    assert_eq!(one(wraps, &none()).acceleration[1], f64::from(i32::MIN));
}

#[test]
fn a_checksum_of_version_3_finds_each_changed_byte() {
    let good = ints(3, "HNE", 0, &[1, -2, 3]);
    assert_eq!(one(&good, &none()).acceleration, [1.0, -2.0, 3.0]);
    for at in (40..good.len()).chain(28..32) {
        let mut bad = good.clone();
        bad[at] ^= 4;
        assert!(refusal(bad, &none()).contains("another checksum than it states"), "{at}");
    }
}
