//! The front door for mesh files: the format is recognised by content, not by the file's name.

use std::fs::File;
use std::io::{self, Cursor};
use std::path::{Path, PathBuf};

use tremolite_files::text::Encoding;

use crate::Mesh;
use crate::content;
use crate::fault::Fault;
use crate::foreign::foreign;
use crate::input::Source;
use crate::note::Note;

pub use crate::format::Format;

/// Why a mesh file could not be read.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// The operating system refused.
    #[error("{}: {source}", path.display())]
    Io { path: PathBuf, source: io::Error },
    /// No reader knows the file's kind.
    #[error(
        "{}: this is no mesh file of a known kind; known are: {}",
        path.display(),
        FORMATS.iter().map(|f| f.name).collect::<Vec<_>>().join(", ")
    )]
    Unknown { path: PathBuf },
    /// The file's contents cannot be used; the text says what to do.
    #[error("{}, line {line}: {problem}", path.display())]
    Line { path: PathBuf, line: usize, problem: String },
    /// The same, where no single line is to blame.
    #[error("{}: {problem}", path.display())]
    File { path: PathBuf, problem: String },
}

/// The formats that [`read`] knows. A new one is a module with a `FORMAT` and a line here.
pub const FORMATS: &[Format] = &[
    crate::gmsh::FORMAT,
    crate::vtu::FORMAT,
    crate::vtk::FORMAT,
    crate::f3grid::FORMAT,
    crate::cdb::FORMAT,
    crate::dyna::FORMAT,
    crate::abaqus::FORMAT,
    crate::nastran::FORMAT,
];

/// Reads a mesh file; as [`read_with_notes`] without the notes.
///
/// # Errors
/// As [`read_with_notes`].
pub fn read(path: impl AsRef<Path>) -> Result<Mesh, ReadError> {
    read_with_notes(path).map(|(mesh, _)| mesh)
}

/// Reads a mesh file, and says what was done to it on the way. A file packed by gzip is unpacked.
///
/// Whatever the format, every element of the result has a positive Jacobian (one numbered in mirror
/// image is renumbered), every node belongs to an element, and every element to a group; no group is empty.
/// Coordinates are taken as metres, z up. The notes tell what was reduced, passed over, renumbered or
/// dropped, and whether nodes coincide.
///
/// # Errors
/// If the file cannot be opened, is of no known kind, or its contents cannot be used: the message names
/// the file, where there is one the line, and the way out.
pub fn read_with_notes(path: impl AsRef<Path>) -> Result<(Mesh, Vec<Note>), ReadError> {
    read_encoded(path, None)
}

/// As [`read_with_notes`], where the text is in an encoding that the user states, unless a byte order mark states another.
///
/// # Errors
/// As [`read_with_notes`], and if the text is not in that encoding.
pub fn read_encoded(
    path: impl AsRef<Path>,
    encoding: Option<&'static Encoding>,
) -> Result<(Mesh, Vec<Note>), ReadError> {
    let path = path.as_ref();
    let file = File::open(path).map_err(|source| ReadError::Io { path: path.to_owned(), source })?;
    read_from(path, file, encoding)
}

/// As [`read_with_notes`], from content already in memory; `path` serves for messages, and for files that the content refers to.
///
/// # Errors
/// [`ReadError::Unknown`], [`ReadError::Line`], [`ReadError::File`].
pub fn read_bytes(path: &Path, bytes: &[u8]) -> Result<(Mesh, Vec<Note>), ReadError> {
    read_from(path, Cursor::new(bytes), None)
}

/// The format that content which begins so is read as.
pub fn recognised(head: &[u8]) -> Option<&'static Format> {
    FORMATS.iter().find(|format| (format.recognises)(head))
}

fn read_from(
    path: &Path,
    source: impl Source,
    encoding: Option<&'static Encoding>,
) -> Result<(Mesh, Vec<Note>), ReadError> {
    let place = |Fault { file, line, problem }| {
        let path = file.unwrap_or_else(|| path.to_owned());
        match line {
            Some(line) => ReadError::Line { path, line, problem },
            None => ReadError::File { path, problem },
        }
    };
    let mut input = content::open(source, encoding).map_err(place)?;
    let head = input.head().map_err(place)?;
    let Some(format) = recognised(head) else {
        return Err(match foreign(head) {
            Some(kind) => place(Fault::whole(kind.problem())),
            None => ReadError::Unknown { path: path.to_owned() },
        });
    };
    let (mesh, mut notes) = (format.parse)(&mut input, path).map_err(place)?;
    notes.extend(input.assumed.map(|encoding| Note::Assumed { encoding: encoding.to_owned() }));
    Ok((mesh, notes))
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn a_file_is_known_by_its_contents_and_faults_name_it() {
        let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
        assert_eq!(read(data.join("tunnel.msh")).unwrap().elements.len(), 160);
        let error = read(data.join("tunnel.geo")).unwrap_err();
        assert!(matches!(error, ReadError::Unknown { .. }), "{error}");
        assert!(error.to_string().contains("tunnel.geo: this is no mesh file of a known kind"), "{error}");
        let error = read(data.join("absent.msh")).unwrap_err();
        assert!(matches!(error, ReadError::Io { .. }), "{error}");

        let folder = std::env::temp_dir().join(format!("tremolite-read-{}", std::process::id()));
        fs::create_dir_all(&folder).unwrap();
        let path = folder.join("old.mesh");
        fs::write(&path, "$MeshFormat\n3 0 8\n").unwrap();
        let message = read(&path).unwrap_err().to_string();
        assert!(message.contains("old.mesh, line 2: this is MSH version 3"), "{message}");
        fs::write(&path, "").unwrap();
        assert!(matches!(read(&path), Err(ReadError::Unknown { .. })));
        fs::remove_dir_all(&folder).unwrap();
    }

    /// The tests of files go through the folder, so a format without a file there would go untested.
    #[test]
    fn every_format_has_a_file_of_the_same_mesh_among_the_tests() {
        let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
        for (k, format) in FORMATS.iter().enumerate() {
            let has = fs::read_dir(&data).unwrap().map(|file| file.unwrap().path()).any(|path| {
                let head = fs::read(&path).unwrap();
                let first = FORMATS.iter().position(|f| (f.recognises)(&head));
                path.file_name().unwrap().to_string_lossy().starts_with("shapes") && first == Some(k)
            });
            assert!(
                has,
                "{}: put the mesh of shapes.geo into {} as such a file",
                format.name,
                data.display()
            );
        }
    }
}
