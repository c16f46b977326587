//! Linings that a case casts against the walls of holes in its mesh.

use tremolite_case::{self as case, Diagnostic};
use tremolite_mesh::Mesh;
use tremolite_mesh::hole::{CastError, HoleLining, cast};
use tremolite_mesh::places::Place;

/// Casts them one after the other; one that finds no room is among the problems, and those after it are tried all the same.
pub fn line(linings: &[case::HoleLining], mesh: &mut Mesh, problems: &mut Vec<Diagnostic>) {
    for lining in linings {
        let what = HoleLining {
            name: lining.name.value.clone(),
            place: lining.place.as_ref().map(|corners| Place::Box(corners.each_ref().map(|c| c.value))),
            thickness: lining.thickness.value,
            layers: lining.layers.value as usize,
        };
        if let Err(e) = cast(mesh, &what) {
            let text = e.to_string();
            let (what, remedy) = text.rsplit_once("; ").unwrap_or((&text, "change the lining"));
            problems.push(Diagnostic::new(span(lining, &e), what, remedy));
        }
    }
}

/// Where the case says what is at fault.
fn span(lining: &case::HoleLining, fault: &CastError) -> std::ops::Range<usize> {
    match (fault, &lining.place) {
        (CastError::Known { .. }, _) => lining.name.span.clone(),
        (CastError::NoWall { .. }, Some([one, _])) => one.span.clone(),
        (CastError::NoWall { .. }, None) => lining.span.clone(),
        (CastError::Thin { .. } | CastError::Poor { .. } | CastError::Overlap { .. }, _) => {
            lining.thickness.span.clone()
        }
    }
}
