//! What a reader says of itself. The list of them all is [`FORMATS`](crate::read::FORMATS).

use std::path::Path;

use crate::Mesh;
use crate::fault::Fault;
use crate::input::Input;
use crate::note::Note;

/// What a reader comes to.
pub(crate) type Outcome = Result<(Mesh, Vec<Note>), Fault>;

/// One mesh format.
pub struct Format {
    /// As the user knows it.
    pub name: &'static str,
    /// Whether a file that begins so is of this kind.
    pub(crate) recognises: fn(&[u8]) -> bool,
    /// The mesh in a file; the path is there for files that refer to others.
    pub(crate) parse: fn(&mut Input, &Path) -> Outcome,
}
