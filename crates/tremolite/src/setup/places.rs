//! Groups by place, and planes that cut the ground: what a case makes of its mesh.

use std::ops::Range;
use tremolite_case::{self as case, Case, Diagnostic, pattern};
use tremolite_mesh::Mesh;
use tremolite_mesh::places::{Place, Taken, take};
use tremolite_mesh::plane::Plane;

/// Makes the groups of a case by their places, one after the other. `overlays` are groups beside those that tile the mesh, which
/// elements do not leave unless they are named.
pub fn group(
    source: &case::Mesh,
    groups: &[case::PlacedGroup],
    overlays: &[String],
    mesh: &mut Mesh,
    problems: &mut Vec<Diagnostic>,
) -> Vec<Taken> {
    let mut taken: Vec<Taken> = Vec::new();
    for group in groups {
        let Some(of) = losing(source, group, overlays, &taken, mesh, problems) else { continue };
        match take(mesh, &group.name.value, &of, &place(&group.place), &taken) {
            Ok(made) => taken.push(made),
            Err(e) => {
                let text = e.to_string();
                let (what, remedy) = text.rsplit_once("; ").unwrap_or((&text, "change its place or `of`"));
                problems.push(Diagnostic::new(span(group), what, remedy));
            }
        }
    }
    taken
}

/// The groups that an entry is taken of; nothing if a pattern fits none.
fn losing(
    source: &case::Mesh,
    group: &case::PlacedGroup,
    overlays: &[String],
    taken: &[Taken],
    mesh: &Mesh,
    problems: &mut Vec<Diagnostic>,
) -> Option<Vec<String>> {
    let apart = |name: &str| overlays.iter().any(|o| o == name) || taken.iter().any(|t| t.name == name);
    if group.of.is_empty() {
        let ground = |name: &str| match source {
            case::Mesh::Caverns(_) => name == "rock" || name.starts_with("rock."),
            case::Mesh::Box(_) | case::Mesh::File(_) => true,
        };
        return Some(mesh.groups.keys().filter(|name| ground(name) && !apart(name)).cloned().collect());
    }
    let mut of: Vec<String> = Vec::new();
    for pattern in &group.of {
        let fits = |name: &&String| {
            pattern.value == **name || pattern::matches(&pattern.value, name) && !apart(name)
        };
        let found: Vec<String> = mesh.groups.keys().filter(fits).cloned().collect();
        if found.is_empty() {
            problems.push(super::groups::nothing_fits(mesh, pattern));
            return None;
        }
        of.extend(found);
    }
    of.sort();
    of.dedup();
    Some(of)
}

fn place(place: &case::GroupPlace) -> Place {
    match place {
        case::GroupPlace::Box(corners) => Place::Box(corners.each_ref().map(|c| c.value)),
        case::GroupPlace::Halfspace { plane: at, above } => {
            Place::Halfspace { plane: plane(at), above: *above }
        }
        case::GroupPlace::Cylinder { ends, radius } => {
            Place::Cylinder { ends: ends.each_ref().map(|e| e.value), radius: radius.value }
        }
        case::GroupPlace::Levels(levels) => Place::Levels(levels.value),
        case::GroupPlace::Planes(planes) => Place::Planes(planes.each_ref().map(plane)),
    }
}

/// A plane of a case.
pub fn plane(at: &case::PlaneAt) -> Plane {
    Plane::dipping(at.through.value, at.dip.value, at.dip_direction.value)
}

/// Where the place of a group is written.
fn span(group: &case::PlacedGroup) -> Range<usize> {
    match &group.place {
        case::GroupPlace::Box([one, _]) => one.span.clone(),
        case::GroupPlace::Halfspace { plane, .. } => plane.through.span.clone(),
        case::GroupPlace::Cylinder { radius, .. } => radius.span.clone(),
        case::GroupPlace::Levels(levels) => levels.span.clone(),
        case::GroupPlace::Planes([upper, _]) => upper.through.span.clone(),
    }
}

/// That a stage names a group that lost elements, and not the group that has them now.
pub fn warnings(case: &Case, taken: &[Taken]) -> Vec<Diagnostic> {
    let mut warnings = Vec::new();
    for stage in &case.stages {
        for (verb, patterns) in [("excavates", &stage.excavate), ("installs", &stage.install)] {
            let named = |name: &str| patterns.iter().any(|p| pattern::matches(&p.value, name));
            for made in taken.iter().filter(|made| !named(&made.name)) {
                // One group whose parts are named as well is enough.
                let lost =
                    made.from.iter().filter(|(group, _)| named(group)).max_by_key(|(_, lost)| lost.len());
                let Some((group, lost)) = lost else { continue };
                let at = patterns.iter().find(|p| pattern::matches(&p.value, group));
                let Some(at) = at else { continue };
                warnings.push(Diagnostic::at(
                    at,
                    format!(
                        "'{}' {verb} '{group}' but not the {} elements that '{}' took of it",
                        stage.name.value,
                        lost.len(),
                        made.name
                    ),
                    format!("name '{}' here as well, or leave '{group}' out of its `of`", made.name),
                ));
            }
        }
    }
    warnings
}
