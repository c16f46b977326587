//! `fields.pvd`: which field file belongs to which time. ParaView opens it as one animation.

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use crate::folder::is_inside;
use crate::{Error, number, replace_file};

/// One line of the collection.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    /// Time (s).
    pub time: f64,
    /// The file, relative to the folder of `fields.pvd`, with forward slashes.
    pub file: String,
}

/// The collection of field files. It is written anew, whole, at each snapshot, so that it is
/// complete at any moment of the run.
#[derive(Clone, Debug, PartialEq)]
pub struct Pvd {
    path: PathBuf,
    snapshots: Vec<Snapshot>,
}

impl Pvd {
    /// Starts an empty collection and writes it.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn create(path: &Path) -> Result<Self, Error> {
        let pvd = Pvd { path: path.to_owned(), snapshots: Vec::new() };
        pvd.write()?;
        Ok(pvd)
    }

    /// Opens the collection of a run that goes on after time `t` (s): later snapshots leave the list. Their
    /// files stay until they are written again.
    ///
    /// # Errors
    /// As [`Pvd::read`], and [`Error::Io`] on writing.
    pub fn resume(path: &Path, t: f64) -> Result<Self, Error> {
        let mut pvd = Self::read(path)?;
        pvd.snapshots.retain(|snapshot| snapshot.time <= t);
        pvd.write()?;
        Ok(pvd)
    }

    /// Reads a collection, ours or another program's.
    ///
    /// # Errors
    /// [`Error::Io`]; [`Error::Format`] if it is not XML, or a data set lacks its time or a file in the folder.
    pub fn read(path: &Path) -> Result<Self, Error> {
        let text = fs::read_to_string(path).map_err(Error::io(path, "read this file"))?;
        let document = roxmltree::Document::parse(&text).map_err(|e| {
            Error::format(path, Some(e.pos().row as usize), format!("not a ParaView collection: {e}"))
        })?;
        let mut snapshots = Vec::new();
        for node in document.descendants().filter(|node| node.has_tag_name("DataSet")) {
            let line = document.text_pos_at(node.range().start).row as usize;
            let time = node
                .attribute("timestep")
                .and_then(|t| t.trim().parse().ok())
                .filter(|t: &f64| t.is_finite());
            let file = node.attribute("file").filter(|file| !file.is_empty());
            let (Some(time), Some(file)) = (time, file) else {
                return Err(Error::format(
                    path,
                    Some(line),
                    "a data set needs `timestep`, a number, and `file`",
                ));
            };
            // A folder may come from anybody: nothing outside it is read.
            if !is_inside(file) {
                let what = format!("`file` does not lie in this folder: {file:?}");
                return Err(Error::format(path, Some(line), what));
            }
            snapshots.push(Snapshot { time, file: file.into() });
        }
        Ok(Pvd { path: path.to_owned(), snapshots })
    }

    /// Adds a field file that is complete. `file` is relative to the folder of `fields.pvd`.
    ///
    /// # Errors
    /// [`Error::Io`].
    pub fn add(&mut self, time: f64, file: &str) -> Result<(), Error> {
        self.snapshots.push(Snapshot { time, file: file.replace('\\', "/") });
        self.write()
    }

    /// All snapshots, in the order they were added.
    pub fn snapshots(&self) -> &[Snapshot] {
        &self.snapshots
    }

    /// Where the file of a snapshot lies.
    pub fn locate(&self, snapshot: &Snapshot) -> PathBuf {
        self.path.with_file_name(&snapshot.file)
    }

    fn write(&self) -> Result<(), Error> {
        let mut text = String::from(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n\
             <Collection>\n",
        );
        for snapshot in &self.snapshots {
            let mut time = String::new();
            number::push(&mut time, snapshot.time);
            let file = escape(&snapshot.file);
            // Writing to a String cannot fail.
            let _ = writeln!(text, "<DataSet timestep=\"{time}\" part=\"0\" file=\"{file}\"/>");
        }
        text.push_str("</Collection>\n</VTKFile>\n");
        replace_file(&self.path, text.as_bytes())
    }
}

fn escape(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
