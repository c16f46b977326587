//! A file that describes a mesh and no study.

use std::path::{Path, PathBuf};

use toml::de::DeTable;

use crate::case::{CASE, X_AZIMUTH};
use crate::check::{Checker, UNITS};
use crate::keys::{Key, Kind, Table};
use crate::laws::Laws;
use crate::mesh::{Ground, MESH, Mesh};
use crate::{Diagnostic, Report, syntax};

static MESH_ALONE: Table = Table {
    path: "",
    doc: "A mesh on its own.",
    keys: &[
        Key::optional("title", Kind::Text, "", "What the mesh is for"),
        UNITS,
        X_AZIMUTH,
        Key::required("mesh", Kind::Table(&MESH), "with [mesh.caverns], [mesh.box] or [mesh.file]"),
    ],
    choice: &[],
};

/// A `[mesh]` read from a file that has no other table of a case, under the same keys and checks as in a case.
#[derive(Clone, Debug, PartialEq)]
pub struct MeshAlone {
    /// The file as the user named it.
    pub path: PathBuf,
    /// Its text, unchanged.
    pub source: String,
    pub mesh: Mesh,
    /// What is made of it.
    pub ground: Ground,
}

impl MeshAlone {
    /// Reads and checks such a file; nothing if the file has other tables of a case and is to be read as one.
    ///
    /// # Errors
    /// All problems of the file at once.
    pub fn read(path: &Path) -> Result<Option<MeshAlone>, Report> {
        MeshAlone::parse(path, &syntax::read(path, "mesh description")?)
    }

    /// Checks the text of such a file. Touches no files; `path` names it in messages.
    ///
    /// # Errors
    /// All problems of the text at once: of its syntax, or else of its content.
    pub fn parse(path: &Path, source: &str) -> Result<Option<MeshAlone>, Report> {
        let report = |problems| Report::new(path, source, problems);
        let document = syntax::parse(source).map_err(report)?;
        if is_case(document.get_ref()) {
            return Ok(None);
        }
        let mut checker = Checker::new(&CASE, Laws { materials: &[], interfaces: &[] }, document.get_ref());
        let written = checker.table(&MESH_ALONE, Some(&[]), document.get_ref(), document.span(), "");
        let Checker { mut problems, .. } = checker;
        let mesh = written.table("mesh");
        if let Some(mesh) = mesh {
            Mesh::check(mesh, &mut problems);
        }
        let azimuth = written.number(X_AZIMUTH.name).map(|azimuth| azimuth.value);
        let parts = |mesh, azimuth| Some((Mesh::read(mesh, azimuth)?, Ground::read(mesh, azimuth)?));
        match mesh.zip(azimuth).and_then(|(mesh, azimuth)| parts(mesh, azimuth)) {
            Some((mesh, ground)) if problems.is_empty() => {
                Ok(Some(MeshAlone { path: path.to_owned(), source: source.to_owned(), mesh, ground }))
            }
            _ => Err(report(problems)),
        }
    }

    /// A report of problems found later, to be shown in this file's text.
    pub fn report(&self, problems: Vec<Diagnostic>) -> Report {
        Report::new(&self.path, &self.source, problems)
    }
}

/// Whether the file has a table that only a case has.
fn is_case(document: &DeTable<'_>) -> bool {
    let only = CASE.keys.iter().filter(|key| MESH_ALONE.keys.iter().all(|own| own.name != key.name));
    only.into_iter().any(|key| document.contains_key(key.name))
}

#[cfg(test)]
mod tests {
    use super::*;

    const BOX: &str = "[mesh.box]\nx = { from = 0, to = \"4 m\", elements = 2 }\ny = { from = 0, to = \"4 m\", elements = 2 }\n\
                       z = { from = 0, to = \"4 m\", elements = 2 }\n";

    fn parse(source: &str) -> Result<Option<MeshAlone>, Report> {
        MeshAlone::parse(Path::new("mesh.toml"), source)
    }

    #[test]
    fn a_mesh_is_read_alone_and_a_case_is_left_to_be_read_as_one() {
        let alone = parse(BOX).unwrap_or_else(|e| panic!("{e}"));
        assert!(matches!(alone, Some(MeshAlone { mesh: Mesh::Box(_), .. })));
        assert!(matches!(parse(&format!("title = \"a\"\n{BOX}")), Ok(Some(_))));
        assert_eq!(parse(&format!("{BOX}[dynamic]\n")), Ok(None));
    }

    #[test]
    fn its_problems_are_shown_at_their_lines() {
        for (source, line, says) in [
            (BOX.replace("elements = 2", "element = 2"), 2, "`element` is no key"),
            (BOX.replace("to = \"4 m\"", "to = \"-4 m\""), 2, "to"),
            (format!("tittle = 1\n{BOX}"), 1, "did you mean `title`?"),
        ] {
            let text = parse(&source).expect_err(&source).to_string();
            assert!(text.contains(&format!("mesh.toml:{line}")) && text.contains(says), "{text}");
        }
        assert!(parse("").expect_err("nothing").to_string().contains("`mesh` is missing"));
    }
}
