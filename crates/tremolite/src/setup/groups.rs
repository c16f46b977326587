//! Groups that a case names and the mesh has not.

use tremolite_case::{Diagnostic, Spanned, nearest};
use tremolite_mesh::Mesh;

/// That no group of a mesh fits a pattern, with the group that may be meant and those that there are.
pub fn nothing_fits(mesh: &Mesh, pattern: &Spanned<String>) -> Diagnostic {
    let known = || mesh.groups.keys().map(String::as_str);
    let meant =
        nearest(&pattern.value, known()).map_or(String::new(), |name| format!("did you mean '{name}'? "));
    let all: Vec<&str> = known().collect();
    Diagnostic::at(
        pattern,
        format!("no group of the mesh fits '{}'", pattern.value),
        format!("{meant}the mesh has the groups {}", all.join(", ")),
    )
}
