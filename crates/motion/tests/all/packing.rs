//! Records packed by gzip.

use std::io::Write;
use std::path::Path;

use flate2::Compression;
use flate2::write::GzEncoder;
use tremolite_motion::{ReadOptions, read_bytes};

const TEXT: &str = "# units = \"cm/s2\"\n# dt = \"0.01 s\"\n1\n2\n3\n";

fn packed(bytes: &[u8]) -> Vec<u8> {
    let mut out = GzEncoder::new(Vec::new(), Compression::fast());
    out.write_all(bytes).unwrap();
    out.finish().unwrap()
}

fn refusal(bytes: &[u8]) -> String {
    read_bytes(Path::new("a.txt.gz"), bytes, &ReadOptions::default()).unwrap_err().to_string()
}

#[test]
fn a_packed_record_is_the_record() {
    let channels =
        read_bytes(Path::new("a.txt.gz"), &packed(TEXT.as_bytes()), &ReadOptions::default()).unwrap();
    assert_eq!(channels[0].name, "a");
    assert_eq!(channels[0].acceleration, [0.01, 0.02, 0.03]);
    // gunzip reads what several runs of gzip wrote one behind the other, so this does.
    let (one, two) = TEXT.split_at(40);
    let members = [packed(one.as_bytes()), packed(two.as_bytes())].concat();
    assert_eq!(
        read_bytes(Path::new("a.gz"), &members, &ReadOptions::default()).unwrap()[0].acceleration.len(),
        3
    );
}

/// A gigabyte of zeros in a megabyte, and as much behind each of its parts: neither is unpacked beyond the limit.
#[test]
fn what_unpacks_to_a_gigabyte_is_refused_early() {
    let part = packed(&vec![0; 1 << 24]);
    let message = refusal(&part.repeat(64));
    assert!(message.contains("more than 64 MiB") && message.contains("a.txt.gz"), "{message}");
    let message = refusal(&packed(&b"1\n".repeat(5_000_000)));
    assert!(message.contains("more than 4000000 lines"), "{message}");
    let message = refusal(&packed(&part));
    assert!(message.contains("packed twice"), "{message}");
}

#[test]
fn broken_and_other_packing_is_refused_with_the_way_out() {
    let good = packed(TEXT.as_bytes());
    for end in 2..good.len() {
        assert!(refusal(&good[..end]).contains("broken"), "{end}");
    }
    let mut torn = good.clone();
    torn[good.len() / 2] ^= 0x55;
    assert!(refusal(&torn).contains("broken"));
    let mut archive = vec![0; 512];
    archive[257..262].copy_from_slice(b"ustar");
    for (bytes, program) in [
        (b"PK\x03\x04..".to_vec(), "unzip"),
        (b"BZh9..".to_vec(), "bunzip2"),
        (archive.clone(), "tar"),
        (packed(&archive), "tar"),
    ] {
        assert!(refusal(&bytes).contains(program), "{program}");
    }
}
