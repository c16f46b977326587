//! Whether linings crack when their fibres reach the strength.

use crate::evidence::Evidence;
use crate::observers::Fibres;
use crate::places;
use tremolite_engine::hexahedra::centroid;
use tremolite_results::{TrustLine, said};

/// Use of the tensile strength at the fibre of an intact element that is still in order. Points inside an element crack late: in
/// pure bending the fibre of n layers of 2×2×2 points reaches n/(n − 1 + 1/√3), 1.73, 1.27, 1.16 and 1.12 for one to four, and the
/// largest moment of the section is then 18, 4, 2 and 0 % too large (exponential softening; under a thrust of 1.5 MPa 13, 6, 2 and
/// 1 %; beside sixteen layers). So three layers pass. Layers with points at the faces stay at 1.
const USED: f64 = 1.2;

pub(super) fn line(evidence: &Evidence) -> TrustLine {
    const ID: &str = "fibre_stress_of_intact_elements";
    let name = said!("fibre stress of intact elements over the tensile strength");
    let Evidence { model, outcome, .. } = evidence;
    let Some(kept) = outcome.state.observers.get(Fibres::MEMORY) else {
        return TrustLine::not_applicable(
            ID,
            name,
            said!("no lining with several points per element can crack"),
        );
    };
    let worst = kept.chunks_exact(3).enumerate().max_by(|a, b| a.1[0].total_cmp(&b.1[0]));
    let (used, element, time, body) = match worst {
        Some((body, &[used, element, time])) => (used, element as u32, time, &model.bodies[body].name),
        _ => {
            return TrustLine::not_applicable(
                ID,
                name,
                said!("no lining with several points per element can crack"),
            );
        }
    };
    TrustLine::at_most(ID, name, used, USED, "").with("time", time).with_note(said!(
        "{body}, element {element} at {place} at {time} s; points inside an element crack later than its fibre: \
         element = \"layered\" has points at both faces",
        body = body,
        element = model.mesh.element_id(element as usize).to_string(),
        place = places::point(centroid(&model.mesh, element)),
        time = format!("{time:.2}"),
    ))
}
