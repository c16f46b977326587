//! Files of text that a user writes.

use std::path::Path;
use tremolite_case::study::StudyFile;
use tremolite_case::{Case, LawFile, Limits, MeshAlone, Report};
use tremolite_laws::materials::MATERIALS;

/// The text, where the bytes are one.
fn text(bytes: &[u8]) -> Option<&str> {
    std::str::from_utf8(bytes).ok()
}

/// A refusal says at a place of the text what is wrong and what to do, and can be shown.
fn refused(source: &str, report: &Report) {
    assert!(!report.problems.is_empty(), "a refusal says why");
    for problem in &report.problems {
        let span = &problem.span;
        assert!(span.start <= span.end && span.end <= source.len(), "{span:?} of {}", source.len());
        assert!(!problem.message.is_empty() && !problem.remedy.is_empty(), "{problem:?}");
        report.position(problem);
    }
    let shown = report.render(false);
    let raw = |c: char| c.is_control() && c != '\n';
    assert!(!shown.contains(raw), "a control character is shown: {shown:?}");
}

fn checked<T>(source: &str, read: Result<T, Report>) -> bool {
    if let Err(report) = &read {
        refused(source, report);
    }
    true
}

pub fn case_text(source: &str) -> bool {
    checked(source, Case::parse(Path::new("case.toml"), source, MATERIALS))
}

pub fn study_text(source: &str) -> bool {
    checked(source, StudyFile::parse(Path::new("study.toml"), source))
}

pub fn case(bytes: &[u8]) -> bool {
    text(bytes).is_some_and(case_text)
}

pub fn study(bytes: &[u8]) -> bool {
    text(bytes).is_some_and(study_text)
}

pub fn law(bytes: &[u8]) -> bool {
    text(bytes)
        .is_some_and(|source| checked(source, LawFile::parse(Path::new("law.toml"), source, MATERIALS)))
}

pub fn limits(bytes: &[u8]) -> bool {
    text(bytes).is_some_and(|source| checked(source, Limits::parse(Path::new("limits.toml"), source)))
}

pub fn mesh_description(bytes: &[u8]) -> bool {
    text(bytes).is_some_and(|source| checked(source, MeshAlone::parse(Path::new("mesh.toml"), source)))
}
