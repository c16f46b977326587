//! Where heads, drained walls and drains are, by their names in a case.

use super::super::groups::nothing_fits;
use super::is_asked;
use tremolite_case::{Case, Diagnostic, Drain, Spanned, nearest, pattern};
use tremolite_mesh::Mesh;

/// All four sides at once.
pub(super) const SIDES: &str = "sides";
/// Outer planes by name: the axis, and whether it is the upper one.
pub(super) const PLANES: [(&str, usize, usize); 6] =
    [("xmin", 0, 0), ("xmax", 0, 1), ("ymin", 1, 0), ("ymax", 1, 1), ("base", 2, 0), ("top", 2, 1)];

/// The outer planes that a name means.
pub(super) fn planes(name: &str) -> Vec<(usize, usize)> {
    let is_meant = |plane: &&(&str, usize, usize)| plane.0 == name || (name == SIDES && plane.1 < 2);
    PLANES.iter().filter(is_meant).map(|&(_, axis, upper)| (axis, upper)).collect()
}

/// Refuses names that the mesh has not.
pub fn check_names(case: &Case, mesh: &Mesh, problems: &mut Vec<Diagnostic>) {
    let (true, Some(water)) = (is_asked(case), &case.water) else { return };
    let fits = |name: &str| mesh.groups.keys().any(|group| pattern::matches(name, group));
    let of_stages = case.stages.iter().flat_map(|stage| &stage.water.heads);
    for (name, _) in water.heads.iter().chain(of_stages) {
        if planes(name).is_empty() && !mesh.faces.contains_key(&name.value) && !fits(name) {
            problems.push(unknown(mesh, name));
        }
    }
    for stage in &case.stages {
        let groups = stage.water.drains.iter().flatten().filter_map(|drain| match drain {
            Drain::Group(group) => Some(group),
            Drain::Line(..) => None,
        });
        let patterns = stage.water.drained.iter().flatten().chain(groups);
        problems.extend(patterns.filter(|name| !fits(name)).map(|name| nothing_fits(mesh, name)));
    }
}

fn unknown(mesh: &Mesh, name: &Spanned<String>) -> Diagnostic {
    let known = || {
        let planes = std::iter::once(SIDES).chain(PLANES.iter().map(|(name, ..)| *name));
        let faces = mesh.faces.keys().filter(|face| planes_of(face)).map(String::as_str);
        planes.chain(faces).chain(mesh.groups.keys().map(String::as_str))
    };
    let meant = nearest(name, known()).map_or(String::new(), |name| format!("did you mean '{name}'? "));
    let all: Vec<&str> = known().collect();
    Diagnostic::at(
        name,
        format!("nothing is called '{}' where a head could be", name.value),
        format!("{meant}there are {}", all.join(", ")),
    )
}

/// Whether a face of the mesh is no outer plane, which are listed already.
fn planes_of(face: &str) -> bool {
    planes(face).is_empty()
}
