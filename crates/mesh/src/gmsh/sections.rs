//! The sections of an MSH file, and whether its version can be read.

use std::collections::HashMap;

use super::fields::{Fields, Lines};
use crate::read::Fault;

/// What to do about a file of another kind.
const EXPORT: &str = "export it as MSH 4.1 ASCII (in Gmsh: File > Export, .msh, `Version 4 ASCII`; or \
                      `gmsh FILE -save -format msh41 -o NEW.msh`)";
/// The sections that are read; each may be there once.
const READ: [&str; 4] = ["PhysicalNames", "Entities", "Nodes", "Elements"];

/// Whether a file is an MSH file of any version: one of its first lines opens the section $MeshFormat.
pub(super) fn is_msh(bytes: &[u8]) -> bool {
    let head = &bytes[..bytes.len().min(1 << 16)];
    let head = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(head);
    Lines::after(0, head).any(|line| line.text == b"$MeshFormat")
}

/// The lines between `$Name` and `$EndName`.
#[derive(Clone, Copy)]
pub(super) struct Section<'a> {
    body: &'a [u8],
    /// Number of the line `$Name`.
    line: usize,
}

impl<'a> Section<'a> {
    pub(super) fn lines(&self) -> Lines<'a> {
        Lines::after(self.line, self.body)
    }
}

/// The sections of a file by name.
pub(super) struct Sections<'a>(HashMap<&'a [u8], Section<'a>>);

impl<'a> Sections<'a> {
    /// Finds the sections to be read, whatever their order, and checks the file's version.
    pub(super) fn find(bytes: &'a [u8]) -> Result<Self, Fault> {
        let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
        let mut lines = Lines::after(0, bytes);
        let mut sections = HashMap::new();
        while let Some(Fields { text, line }) = lines.next() {
            let Some(name) = text.strip_prefix(b"$") else { continue };
            let shown = name[..name.len().min(40)].escape_ascii();
            if name == b"MeshFormat" {
                // Before the end of the section is looked for: a binary file has no lines.
                check_version(lines.expect("the version")?)?;
            }
            if name == b"PartitionedEntities" || name == b"GhostElements" {
                return Err(Fault::at(
                    line,
                    "the mesh is partitioned; remove the partition (in Gmsh: Mesh > Unpartition) and save again",
                ));
            }
            let rest = lines.rest();
            let mut end = None;
            while end.is_none() {
                let here = rest.len() - lines.rest().len();
                let Some(l) = lines.next() else { break };
                end = (l.text.strip_prefix(b"$End") == Some(name)).then_some(here);
            }
            let Some(end) = end else {
                return Err(Fault::at(
                    line,
                    format!(
                        "the section ${shown} is not closed by $End{shown}; the file is cut short or damaged"
                    ),
                ));
            };
            let twice = sections.insert(name, Section { body: &rest[..end], line }).is_some();
            if twice && READ.iter().any(|read| read.as_bytes() == name) {
                return Err(Fault::at(
                    line,
                    format!("a second section ${shown}; save the mesh in one piece"),
                ));
            }
        }
        Ok(Sections(sections))
    }

    pub(super) fn get(&self, name: &str) -> Option<&Section<'a>> {
        self.0.get(name.as_bytes())
    }
}

fn check_version(mut line: Fields) -> Result<(), Fault> {
    let version = line.real("the version of the format")?;
    if version != 4.1 {
        return Err(Fault::at(line.line, format!("this is MSH version {version}, expected 4.1; {EXPORT}")));
    }
    if line.count("0 for ASCII or 1 for binary")? != 0 {
        return Err(Fault::at(line.line, format!("this is a binary MSH file; {EXPORT}")));
    }
    Ok(())
}
