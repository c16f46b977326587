//! What a writer finds wrong.

use std::io;

/// What a writer finds wrong; [`write`](crate::write()) adds the file.
#[derive(Debug)]
pub(crate) enum Trouble {
    Io(io::Error),
    Mesh(String),
}

impl From<io::Error> for Trouble {
    fn from(error: io::Error) -> Self {
        Trouble::Io(error)
    }
}
