//! checkpoint/state.bin: the state and nothing else, so that a run can go on bit for bit. The one before it is kept as
//! state.earlier.bin, and a run goes on from that where the last is damaged or missing.
//!
//! A line that names the format; the length of a JSON header as u64; the header (columns in order, with names, units
//! and lengths, and the fingerprint of the model); the columns as little-endian numbers; a CRC-32 of all before it. The file is the same whether
//! one process writes it or several ranks: these send the first what they have piece by piece, and each reads its own.

mod among;

pub use among::Among;

use serde::{Deserialize, Serialize};
use std::fs::File;
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use tremolite_engine::state::{State, StateColumn};
use tremolite_laws::Row;
use tremolite_results::{CHECKPOINTS, HAND_OVER};

/// What a file begins with: the version of the format.
pub const MAGIC: &[u8] = b"tremolite checkpoint 7\n";
/// What is being written, and is none yet.
const NEXT: &str = "state.next.bin";

/// Why a checkpoint could not be written or read.
#[derive(Debug, thiserror::Error)]
pub enum CheckpointError {
    #[error("{}: {source}", path.display())]
    Io { path: PathBuf, source: std::io::Error },
    #[error("{}: {problem}; begin the run anew (--overwrite)", path.display())]
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

/// Writes the state into a folder; the checkpoint there becomes the earlier one. Tables that the state knows have to be on the disk
/// before ([`ResultFolder::sync`](tremolite_results::ResultFolder::sync)).
///
/// # Errors
/// If the file cannot be written; older ones are then untouched.
pub fn write(
    folder: &Path,
    state: &mut State,
    fingerprint: u64,
    among: &Among,
) -> Result<(), CheckpointError> {
    write_file((folder, NEXT), state, fingerprint, among)?;
    if !among.is_first() {
        return Ok(());
    }
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
pub fn write_hand_over(
    folder: &Path,
    state: &mut State,
    fingerprint: u64,
    among: &Among,
) -> Result<(), CheckpointError> {
    write_file((folder, HAND_OVER), state, before_the_shaking(fingerprint), among)
}

/// Reads what [`write_hand_over`] left, of a model with the same mesh, laws and stages, whatever shakes it.
///
/// # Errors
/// As [`read`].
pub fn read_hand_over(
    folder: &Path,
    state: &mut State,
    fingerprint: u64,
    among: &Among,
) -> Result<(), CheckpointError> {
    read_file(folder.join(HAND_OVER), state, before_the_shaking(fingerprint), among).map_err(|e| match e {
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

fn write_file(
    (folder, file): (&Path, &str),
    state: &mut State,
    fingerprint: u64,
    among: &Among,
) -> Result<(), CheckpointError> {
    let columns = state.columns();
    if !among.is_first() {
        let nothing = |(name, _, column): &(String, _, StateColumn)| among.put(name, column, &mut |_| Ok(()));
        return columns
            .iter()
            .try_for_each(nothing)
            .map_err(|source| CheckpointError::Io { path: folder.join(file), source });
    }
    let header = Header {
        fingerprint,
        columns: columns
            .iter()
            .map(|(name, unit, column)| Entry {
                name: name.clone(),
                unit: (*unit).into(),
                values: among.values(name, column),
            })
            .collect(),
    };
    let header = serde_json::to_vec(&header).unwrap_or_default();
    let path = folder.join(file);
    tremolite_files::make_folder(folder)
        .map_err(|source| CheckpointError::Io { path: folder.into(), source })?;
    let written = tremolite_files::replace(&path, |out| {
        let mut crc = crc32fast::Hasher::new();
        let mut put = |bytes: &[u8]| {
            crc.update(bytes);
            out.write_all(bytes)
        };
        put(MAGIC)?;
        put(&(header.len() as u64).to_le_bytes())?;
        put(&header)?;
        for (name, _, column) in &columns {
            among.put(name, column, &mut put)?;
        }
        out.write_all(&crc.finalize().to_le_bytes())
    });
    written.map_err(|source: std::io::Error| CheckpointError::Io { path, source })
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
    among: &Among,
) -> Result<Option<CheckpointError>, CheckpointError> {
    let [last, earlier] = CHECKPOINTS.map(|name| folder.join(name));
    match read_file(last, state, fingerprint, among) {
        Ok(()) => Ok(None),
        Err(other @ CheckpointError::Other { .. }) => Err(other),
        Err(damaged) => match read_file(earlier, state, fingerprint, among) {
            Ok(()) => Ok(Some(damaged)),
            Err(_) => Err(damaged),
        },
    }
}

fn read_file(
    path: PathBuf,
    state: &mut State,
    fingerprint: u64,
    among: &Among,
) -> Result<(), CheckpointError> {
    let io = |source| CheckpointError::Io { path: path.clone(), source };
    let damaged = |problem: &str| CheckpointError::Damaged { path: path.clone(), problem: problem.into() };
    let file = File::open(&path).map_err(io)?;
    let length = file.metadata().map_err(io)?.len();
    let body = length.checked_sub(4).ok_or_else(|| damaged("the file is cut short"))?;
    let mut file = BufReader::with_capacity(1 << 20, file);
    let mut magic = [0; MAGIC.len()];
    let known = file.read_exact(&mut magic).is_ok() && magic == *MAGIC;
    if !known {
        return Err(damaged("this is no checkpoint of this version"));
    }
    file.rewind().map_err(io)?;
    let mut crc = crc32fast::Hasher::new();
    let mut left = body;
    while left > 0 {
        let bytes = file.fill_buf().map_err(io)?;
        let some = bytes.len().min(usize::try_from(left).unwrap_or(usize::MAX));
        if some == 0 {
            return Err(damaged("the file is cut short"));
        }
        crc.update(&bytes[..some]);
        file.consume(some);
        left -= some as u64;
    }
    let mut kept = [0; 4];
    file.read_exact(&mut kept).map_err(io)?;
    if crc.finalize().to_le_bytes() != kept {
        return Err(damaged("the checksum does not fit: the file is cut short or was changed"));
    }
    file.seek(SeekFrom::Start(MAGIC.len() as u64)).map_err(io)?;
    let rest = body - MAGIC.len() as u64;
    let mut word = [0; 8];
    if rest < 8 {
        return Err(damaged("the header is missing"));
    }
    file.read_exact(&mut word).map_err(io)?;
    let length = u64::from_le_bytes(word);
    let rest = (rest - 8).checked_sub(length).ok_or_else(|| damaged("the header is cut short"))?;
    let mut header = vec![0; usize::try_from(length).unwrap_or(0)];
    file.read_exact(&mut header).map_err(io)?;
    let header: Header = serde_json::from_slice(&header).map_err(|e| damaged(&e.to_string()))?;
    if header.fingerprint != fingerprint {
        return Err(CheckpointError::Other { path });
    }
    // Before anything is made room for: a header may tell of any number.
    let bytes = |values: usize| u64::try_from(values).ok()?.checked_mul(8);
    let wanted = header.columns.iter().try_fold(0u64, |sum, e| sum.checked_add(bytes(e.values)?));
    if wanted != Some(rest) {
        return Err(CheckpointError::Other { path });
    }
    state.observers = header
        .columns
        .iter()
        .filter_map(|e| Some((e.name.strip_prefix("observer ")?.to_owned(), vec![0.0; e.values])))
        .collect();
    let mut columns = state.columns();
    for ((name, _, column), entry) in columns.iter_mut().zip(&header.columns) {
        if let StateColumn::SomeRows(rows) = column {
            rows.resize(among.rows(name, entry.values / 4), Row::ZERO);
        }
    }
    let fits = columns.len() == header.columns.len()
        && columns
            .iter()
            .zip(&header.columns)
            .all(|((name, _, c), e)| *name == e.name && among.values(name, c) == e.values);
    if !fits {
        return Err(CheckpointError::Other { path });
    }
    for (name, _, column) in columns {
        among.take(&name, column, &mut file).map_err(io)?;
    }
    Ok(())
}
