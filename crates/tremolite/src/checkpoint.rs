//! checkpoint/state.bin: the state and nothing else, so that a run can go on bit for bit. The one before it is kept as
//! state.earlier.bin, and a run goes on from that where the last is damaged or missing.
//!
//! A line that names the format; the length of a JSON header as u64; the header (columns in order, with names, units
//! and lengths, and the fingerprint of the model); the columns as little-endian numbers; a CRC-32 of all before it.

use serde::{Deserialize, Serialize};
use std::io::Read;
use std::path::{Path, PathBuf};
use tremolite_engine::state::{State, StateColumn};
use tremolite_laws::{Octet, Row};
use tremolite_results::{CHECKPOINTS, HAND_OVER};

const MAGIC: &[u8] = b"tremolite checkpoint 4\n";
/// What is being written, and is none yet.
const NEXT: &str = "state.next.bin";

/// Why a checkpoint could not be written or read.
#[derive(Debug, thiserror::Error)]
pub enum CheckpointError {
    #[error("{}: {source}", path.display())]
    Io { path: PathBuf, source: std::io::Error },
    #[error("{}: {problem}; start the run again without it", path.display())]
    Damaged { path: PathBuf, problem: String },
    #[error(
        "{}: the checkpoint belongs to another model or plan; resume with the case it was made from, or start the \
         run again without --resume",
        path.display()
    )]
    Other { path: PathBuf },
    #[error(
        "{}: the state before the earthquake is that of another mesh, other materials, stages, base, sides or damping over a \
         band; give the folder of a run whose case differs in motion, Rayleigh damping and output alone. One without an \
         earthquake must have the same [dynamic] base and sides already",
        path.display()
    )]
    OtherBefore { path: PathBuf },
    #[error("{}: {source}; give the folder of a run that went through its stages", path.display())]
    NoHandOver { path: PathBuf, source: std::io::Error },
}

impl CheckpointError {
    /// The file and what is wrong with it, without a remedy.
    pub fn what(&self) -> String {
        match self {
            CheckpointError::Damaged { path, problem } => format!("{}: {problem}", path.display()),
            other => other.to_string(),
        }
    }
}

#[derive(Serialize, Deserialize)]
struct Header {
    fingerprint: u64,
    columns: Vec<Entry>,
}

#[derive(Serialize, Deserialize, PartialEq, Debug)]
struct Entry {
    name: String,
    unit: String,
    /// Number of 8-byte values.
    values: usize,
}

fn values(column: &StateColumn) -> usize {
    match column {
        StateColumn::Count(_) => 1,
        StateColumn::Scalars(s) => s.len(),
        StateColumn::Numbers(n) => n.len(),
        StateColumn::Rows(r) | StateColumn::SomeRows(r) => 4 * r.len(),
        StateColumn::Octets(o) => 8 * o.len(),
    }
}

fn append(column: &StateColumn, out: &mut Vec<u8>) {
    let mut put = |x: f64| out.extend(x.to_bits().to_le_bytes());
    match column {
        StateColumn::Scalars(s) => s.iter().for_each(|x| put(**x)),
        StateColumn::Numbers(n) => n.iter().for_each(|&x| put(x)),
        StateColumn::Rows(r) | StateColumn::SomeRows(r) => r.iter().flat_map(|r| r.0).for_each(put),
        StateColumn::Octets(o) => o.iter().flat_map(|o| o.0).for_each(put),
        StateColumn::Count(c) => out.extend(c.to_le_bytes()),
    }
}

fn restore(column: StateColumn, words: &mut impl Iterator<Item = u64>) {
    let mut take = || words.next().unwrap_or(0);
    let mut number = || f64::from_bits(take());
    match column {
        StateColumn::Scalars(s) => s.into_iter().for_each(|x| *x = number()),
        StateColumn::Numbers(n) => n.iter_mut().for_each(|x| *x = number()),
        StateColumn::Rows(r) | StateColumn::SomeRows(r) => {
            r.iter_mut().flat_map(|Row(r)| r).for_each(|x| *x = number())
        }
        StateColumn::Octets(o) => o.iter_mut().flat_map(|Octet(o)| o).for_each(|x| *x = number()),
        StateColumn::Count(c) => *c = take(),
    }
}

/// Writes the state into a folder; the checkpoint there becomes the earlier one. Tables whose lengths the state knows have to be on the disk
/// before ([`ResultFolder::sync`](tremolite_results::ResultFolder::sync)).
///
/// # Errors
/// If the file cannot be written; older ones are then untouched.
pub fn write(folder: &Path, state: &mut State, fingerprint: u64) -> Result<(), CheckpointError> {
    write_file(folder, NEXT, state, fingerprint)?;
    let [last, earlier] = CHECKPOINTS.map(|name| folder.join(name));
    let rename = |from: &Path, to: &Path| {
        tremolite_files::rename(from, to).map_err(|source| CheckpointError::Io { path: to.into(), source })
    };
    if last.exists() {
        rename(&last, &earlier)?;
    }
    rename(&folder.join(NEXT), &last)
}

/// Writes the state that the shaking begins with beside the checkpoint.
///
/// # Errors
/// As [`write()`].
pub fn write_hand_over(folder: &Path, state: &mut State, fingerprint: u64) -> Result<(), CheckpointError> {
    write_file(folder, HAND_OVER, state, before_the_shaking(fingerprint))
}

/// Reads what [`write_hand_over`] left, of a model with the same mesh, laws and stages, whatever shakes it.
///
/// # Errors
/// As [`read`].
pub fn read_hand_over(folder: &Path, state: &mut State, fingerprint: u64) -> Result<(), CheckpointError> {
    read_file(folder.join(HAND_OVER), state, before_the_shaking(fingerprint)).map_err(|e| match e {
        CheckpointError::Other { path } => CheckpointError::OtherBefore { path },
        CheckpointError::Io { path, source } => CheckpointError::NoHandOver { path, source },
        e => e,
    })
}

/// Whether a folder has what [`write_hand_over`] left and no checkpoint: of a run that was killed soon after its stages.
pub fn is_hand_over_alone(folder: &Path) -> bool {
    folder.join(HAND_OVER).is_file() && CHECKPOINTS.iter().all(|name| !folder.join(name).exists())
}

/// Whether [`read_hand_over`] will take what is there, by its header alone.
///
/// # Errors
/// As [`read_hand_over`], but for damage behind the header.
pub fn check_hand_over(folder: &Path, fingerprint: u64) -> Result<(), CheckpointError> {
    let path = folder.join(HAND_OVER);
    let none = |source| CheckpointError::NoHandOver { path: path.clone(), source };
    let mut file = std::io::BufReader::new(std::fs::File::open(&path).map_err(none)?);
    let mut bytes = vec![0; MAGIC.len() + 8];
    file.read_exact(&mut bytes).map_err(none)?;
    let damaged = |problem: &str| CheckpointError::Damaged { path: path.clone(), problem: problem.into() };
    let length = bytes.strip_prefix(MAGIC).and_then(|rest| rest.first_chunk::<8>());
    let length = length.copied().ok_or_else(|| damaged("this is no checkpoint of this version"))?;
    bytes.clear();
    file.take(u64::from_le_bytes(length)).read_to_end(&mut bytes).map_err(none)?;
    let header: Header = serde_json::from_slice(&bytes).map_err(|e| damaged(&e.to_string()))?;
    if header.fingerprint == before_the_shaking(fingerprint) {
        Ok(())
    } else {
        Err(CheckpointError::OtherBefore { path })
    }
}

/// The half of a fingerprint that is of the model in space and its stages.
fn before_the_shaking(fingerprint: u64) -> u64 {
    fingerprint >> 32
}

fn write_file(folder: &Path, file: &str, state: &mut State, fingerprint: u64) -> Result<(), CheckpointError> {
    let columns = state.columns();
    let header = Header {
        fingerprint,
        columns: columns
            .iter()
            .map(|(name, unit, column)| Entry {
                name: name.clone(),
                unit: (*unit).into(),
                values: values(column),
            })
            .collect(),
    };
    let header = serde_json::to_vec(&header).unwrap_or_default();
    let total: usize = columns.iter().map(|(_, _, c)| 8 * values(c)).sum();
    let mut bytes = Vec::with_capacity(MAGIC.len() + 8 + header.len() + total + 4);
    bytes.extend(MAGIC);
    bytes.extend((header.len() as u64).to_le_bytes());
    bytes.extend(header);
    for (_, _, column) in &columns {
        append(column, &mut bytes);
    }
    bytes.extend(crc32fast::hash(&bytes).to_le_bytes());
    let path = folder.join(file);
    tremolite_files::make_folder(folder)
        .map_err(|source| CheckpointError::Io { path: folder.into(), source })?;
    tremolite_results::replace_file(&path, &bytes)
        .map_err(|e| CheckpointError::Io { path, source: std::io::Error::other(e) })
}

/// Reads the state that [`write()`] left in a folder into one of the same model. Where the last is damaged or missing it is the earlier one, and
/// the error says of the last why.
///
/// # Errors
/// If there is none, both are damaged, or the last is of another model or plan.
pub fn read(
    folder: &Path,
    state: &mut State,
    fingerprint: u64,
) -> Result<Option<CheckpointError>, CheckpointError> {
    let [last, earlier] = CHECKPOINTS.map(|name| folder.join(name));
    match read_file(last, state, fingerprint) {
        Ok(()) => Ok(None),
        Err(other @ CheckpointError::Other { .. }) => Err(other),
        Err(damaged) => match read_file(earlier, state, fingerprint) {
            Ok(()) => Ok(Some(damaged)),
            Err(_) => Err(damaged),
        },
    }
}

fn read_file(path: PathBuf, state: &mut State, fingerprint: u64) -> Result<(), CheckpointError> {
    let bytes = std::fs::read(&path).map_err(|source| CheckpointError::Io { path: path.clone(), source })?;
    let damaged = |problem: &str| CheckpointError::Damaged { path: path.clone(), problem: problem.into() };
    let (body, crc) = bytes.split_last_chunk::<4>().ok_or_else(|| damaged("the file is cut short"))?;
    let rest = body.strip_prefix(MAGIC).ok_or_else(|| damaged("this is no checkpoint of this version"))?;
    if crc32fast::hash(body).to_le_bytes() != *crc {
        return Err(damaged("the checksum does not fit: the file is cut short or was changed"));
    }
    let (length, rest) = rest.split_first_chunk::<8>().ok_or_else(|| damaged("the header is missing"))?;
    let length = usize::try_from(u64::from_le_bytes(*length)).unwrap_or(usize::MAX);
    let header = rest.get(..length).ok_or_else(|| damaged("the header is cut short"))?;
    let header: Header = serde_json::from_slice(header).map_err(|e| damaged(&e.to_string()))?;
    if header.fingerprint != fingerprint {
        return Err(CheckpointError::Other { path });
    }
    let data = &rest[length..];
    // Before anything is made room for: a header may tell of any number.
    let wanted = header.columns.iter().try_fold(0usize, |sum, e| sum.checked_add(e.values.checked_mul(8)?));
    if wanted != Some(data.len()) {
        return Err(CheckpointError::Other { path });
    }
    state.observers = header
        .columns
        .iter()
        .filter_map(|e| Some((e.name.strip_prefix("observer ")?.to_owned(), vec![0.0; e.values])))
        .collect();
    let mut columns = state.columns();
    for ((_, _, column), entry) in columns.iter_mut().zip(&header.columns) {
        if let StateColumn::SomeRows(rows) = column {
            rows.resize(entry.values / 4, Row::ZERO);
        }
    }
    let fits = columns.len() == header.columns.len()
        && columns
            .iter()
            .zip(&header.columns)
            .all(|((name, _, c), e)| *name == e.name && values(c) == e.values);
    if !fits {
        return Err(CheckpointError::Other { path });
    }
    let mut words = data.chunks_exact(8).map(|w| {
        let mut word = [0; 8];
        word.copy_from_slice(w);
        u64::from_le_bytes(word)
    });
    for (_, _, column) in columns {
        restore(column, &mut words);
    }
    Ok(())
}
