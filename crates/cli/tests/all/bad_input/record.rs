//! Files that are no records: packed, binary, too large, of another kind; and bombs, which unpack to more than a machine has.

use flate2::{Compression, write::GzEncoder};
use std::io::Write;
use std::path::Path;
use tremolite_motion::{ReadOptions, Units, read_bytes};

fn refusal(bytes: &[u8]) -> String {
    let options = ReadOptions { units: Some(Units::G), dt: Some(0.01), ..ReadOptions::default() };
    read_bytes(Path::new("record.txt"), bytes, &options).expect_err("it is no record").to_string()
}

fn packed(bytes: &[u8]) -> Vec<u8> {
    let mut out = GzEncoder::new(Vec::new(), Compression::best());
    out.write_all(bytes).unwrap();
    out.finish().unwrap()
}

#[test]
fn what_is_no_record_is_refused_with_a_way_out() {
    let tar = [vec![b'x'; 257], b"ustar".to_vec()].concat();
    let cut = packed(&[b'1'; 4000]);
    let rows: [(&[u8], &str, &str); 12] = [
        (b"", "record.txt", "; "),
        (b"\n\n\n", "record.txt", "; "),
        (b"# nothing\n", "record.txt", "; "),
        (b"PK\x03\x04....", "which is not read", "unpack it first (unzip)"),
        (b"BZh91AY", "which is not read", "unpack it first (bunzip2)"),
        (b"\xfd7zXZ\0", "which is not read", "unpack it first (unxz)"),
        (&tar, "which is not read", "unpack it first (tar -xf)"),
        (&cut[..cut.len() - 9], "the packed file is broken", "fetch it again"),
        (b"\x1f\x8b\x08\0garbage", "the packed file is broken", "fetch it again"),
        (b"\0\x01\x02\x03\x04\x05\x06\x07", "a binary file of no format that is read", "; "),
        (
            b"<html><body>404 Not Found</body></html>\n",
            "a web page, not the record",
            "download the record itself",
        ),
        (b"1\n1e308\n1e309\n", "'1e309' is not a finite number", "put # before lines of text"),
    ];
    for (bytes, says, remedy) in rows {
        let said = refusal(bytes);
        assert!(said.contains(says) && said.contains(remedy), "{:?}: {said}", String::from_utf8_lossy(bytes));
        assert!(!said.contains(char::is_control), "{said:?}");
    }
}

/// A thousandth of what it unpacks to: it must end at the limit, not in memory.
#[test]
fn a_bomb_is_refused_at_the_limit_and_one_packed_twice_at_once() {
    let bomb = packed(&vec![b'1'; (1 << 26) + 1]);
    assert!(bomb.len() < 1 << 17, "{}", bomb.len());
    let said = refusal(&bomb);
    assert!(said.contains("unpacks to more than 64 MiB") && said.contains("give a single one"), "{said}");
    let said = refusal(&packed(&bomb));
    assert!(said.contains("packed twice") && said.contains("gunzip"), "{said}");
}
