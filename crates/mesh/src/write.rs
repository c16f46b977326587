//! The back door for mesh files: writing a mesh in the format that the file's name asks for.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use crate::Mesh;
use crate::note::Note;
use crate::trouble::Trouble;

/// Why a mesh was not written.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// The operating system refused.
    #[error("{}: {source}", path.display())]
    Io { path: PathBuf, source: io::Error },
    /// The file's name does not say which format is wanted.
    #[error(
        "{}: the name ends in no known way; known are: {}",
        path.display(),
        WRITERS.iter().map(|w| format!(".{} ({})", w.extension, w.name)).collect::<Vec<_>>().join(", ")
    )]
    Unknown { path: PathBuf },
    /// The format cannot hold this mesh.
    #[error("{}: not written: {reason}", path.display())]
    Mesh { path: PathBuf, reason: String },
}

/// One format to write.
pub struct Writer {
    /// As the user knows it.
    pub name: &'static str,
    /// How such a file's name ends, in lower case, without the dot.
    pub extension: &'static str,
    pub(crate) write: fn(&Mesh, &mut dyn Write) -> Result<Vec<Note>, Trouble>,
}

/// The formats that [`write()`] knows; of two with the same extension the first is taken.
pub const WRITERS: &[Writer] = &[
    Writer { name: "VTU", extension: "vtu", write: crate::vtu::write_mesh },
    Writer { name: "Gmsh MSH 4.1 ASCII", extension: "msh", write: crate::gmsh::ascii },
    Writer { name: "Gmsh MSH 4.1 binary", extension: "msh", write: crate::gmsh::binary },
    Writer { name: "Abaqus", extension: "inp", write: crate::abaqus::write_mesh },
];

/// Writes a mesh in the format that the name of the file asks for.
///
/// [`crate::read()`] gives the same mesh back, numbers and names included, if it is as that makes meshes: every
/// node in an element, every element in a group, no group empty, groups and faces ascending. The notes say
/// where a format falls short of that. The file appears complete or not at all.
///
/// # Errors
/// If the extension is unknown, the file cannot be written, or the format cannot hold a name or number.
///
/// # Panics
/// If the mesh refers to nodes or elements that it does not have.
pub fn write(path: impl AsRef<Path>, mesh: &Mesh) -> Result<Vec<Note>, WriteError> {
    let path = path.as_ref();
    let extension = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    match WRITERS.iter().find(|w| w.extension == extension) {
        Some(writer) => write_as(path, mesh, writer),
        None => Err(WriteError::Unknown { path: path.to_owned() }),
    }
}

/// Writes a mesh in a given format, whatever the file's name.
///
/// # Errors
/// As [`write()`].
///
/// # Panics
/// As [`write()`].
pub fn write_as(path: impl AsRef<Path>, mesh: &Mesh, writer: &Writer) -> Result<Vec<Note>, WriteError> {
    let path = path.as_ref();
    tremolite_files::replace(path, |out| (writer.write)(mesh, out)).map_err(|trouble| match trouble {
        Trouble::Io(source) => WriteError::Io { path: path.to_owned(), source },
        Trouble::Mesh(reason) => WriteError::Mesh { path: path.to_owned(), reason },
    })
}
