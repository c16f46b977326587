//! A checkpoint of a small model. Bytes that begin with `S` are a header's length (two bytes), a header and numbers, to which the program's own
//! beginning and checksum are added: else every change would end at the checksum. Those that begin with `C` are changes of the sound header's columns,
//! ten bytes each: which, what is done, and a number. Others are a file as it is.

use std::fs;
use std::path::Path;
use std::sync::OnceLock;
use tremolite::checkpoint::{self, Among, MAGIC};
use tremolite::job::{Given, Job};
use tremolite::state::State;
use tremolite_results::CHECKPOINTS;

const CASE: &str = r#"
title = "a column at rest"
[mesh.box]
group = "rock"
x = { from = "0 m", to = "2 m", elements = 1 }
y = { from = "0 m", to = "2 m", elements = 1 }
z = { from = "-4 m", to = "0 m", elements = 2 }
[material.rock]
law = "mohr-coulomb"
young = "2 GPa"
poisson = 0.25
density = "2500 kg/m3"
cohesion = "1 MPa"
friction_angle = "40 deg"
[[region]]
groups = ["rock"]
material = "rock"
element = "reduced-integration"
[initial]
lateral = 0.5
[[stage]]
name = "rest"
"#;

/// Of all checkpoints here.
const FINGERPRINT: u64 = 38;

fn job() -> &'static Job {
    static JOB: OnceLock<Job> = OnceLock::new();
    JOB.get_or_init(|| match Job::of_text(CASE, Path::new("."), &Given::default()) {
        Ok(job) => job,
        Err(fault) => panic!("{fault}"),
    })
}

/// The state of the column at rest, as bytes that begin with `S`.
pub fn seed() -> Vec<u8> {
    let folder = tempfile::tempdir().expect("a folder");
    checkpoint::write(folder.path(), &mut job().assembly.rest(), FINGERPRINT, &Among(None))
        .expect("a checkpoint");
    let file = fs::read(folder.path().join(CHECKPOINTS[0])).expect("it was written");
    let (length, rest) = file[MAGIC.len()..file.len() - 4].split_first_chunk::<8>().expect("a length");
    let length = u16::try_from(u64::from_le_bytes(*length)).expect("a short header");
    [b"S", &length.to_le_bytes()[..], rest].concat()
}

/// The sound header with its columns changed, and the sound numbers.
fn changed(changes: &[u8]) -> Vec<u8> {
    static SEED: OnceLock<Vec<u8>> = OnceLock::new();
    let seed = SEED.get_or_init(seed);
    let end = 3 + usize::from(u16::from_le_bytes([seed[1], seed[2]]));
    let mut header: serde_json::Value = serde_json::from_slice(&seed[3..end]).expect("a header");
    let Some(columns) = header["columns"].as_array_mut() else {
        return Vec::new();
    };
    for change in changes.chunks_exact(10).take(8).filter(|_| !seed.is_empty()) {
        let [at, what, number @ ..] = change else {
            break;
        };
        let number = number.iter().fold(0u64, |n, &byte| n << 8 | u64::from(byte));
        let count = columns.len();
        if count == 0 {
            break;
        }
        let at = usize::from(*at) % count;
        match what % 5 {
            0 => columns[at]["values"] = number.into(),
            1 => columns[at]["name"] = format!("observer {number}").into(),
            2 => drop(columns.remove(at)),
            3 => columns.insert(at, columns[(number % count as u64) as usize].clone()),
            _ => columns.swap(at, (number % count as u64) as usize),
        }
    }
    let header = serde_json::to_vec(&header).unwrap_or_default();
    let length = u16::try_from(header.len()).unwrap_or(u16::MAX);
    [b"S", &length.to_le_bytes()[..], &header, &seed[end..]].concat()
}

/// The file that the bytes stand for.
fn file(bytes: &[u8]) -> Vec<u8> {
    let bytes = match bytes.split_first() {
        Some((b'C', changes)) => &changed(changes),
        _ => bytes,
    };
    let Some((b'S', rest)) = bytes.split_first() else {
        return bytes.to_vec();
    };
    let Some((length, rest)) = rest.split_first_chunk::<2>() else {
        return bytes.to_vec();
    };
    let mut file = MAGIC.to_vec();
    file.extend(u64::from(u16::from_le_bytes(*length)).to_le_bytes());
    file.extend(rest);
    file.extend(crc32fast::hash(&file).to_le_bytes());
    file
}

/// What a state consists of: names, and how many numbers.
fn shape(state: &mut State) -> Vec<String> {
    state.columns().iter().map(|(name, unit, _)| format!("{name} [{unit}]")).collect()
}

pub fn state(bytes: &[u8]) -> bool {
    static FOLDER: OnceLock<std::path::PathBuf> = OnceLock::new();
    let root = FOLDER.get_or_init(|| {
        let root = tempfile::Builder::new().prefix("tremolite-state-").tempdir().expect("a folder").keep();
        // What is made of its own numbers is taken: else every change would end at the beginning.
        fs::write(root.join(CHECKPOINTS[0]), file(&seed())).expect("a file in memory");
        let mut sound = job().assembly.rest();
        checkpoint::read(&root, &mut sound, FINGERPRINT, &Among(None)).expect("a sound checkpoint");
        root
    });
    let [last, earlier] = CHECKPOINTS.map(|name| root.join(name));
    let given = file(bytes);
    fs::write(&last, &given).expect("a file in memory");
    let _ = fs::remove_file(earlier);
    let mut state = job().assembly.rest();
    let own: Vec<String> = shape(&mut state);
    match checkpoint::read(root, &mut state, FINGERPRINT, &Among(None)) {
        Err(why) => assert!(!why.what().is_empty()),
        Ok(_) => {
            let read = shape(&mut state);
            assert!(own.iter().all(|column| read.contains(column)), "columns are lost");
            checkpoint::write(root, &mut state, FINGERPRINT, &Among(None))
                .expect("what was read can be written");
            let mut again = job().assembly.rest();
            checkpoint::read(root, &mut again, FINGERPRINT, &Among(None)).expect("and read again");
        }
    }
    true
}
