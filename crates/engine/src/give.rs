//! What the elements beside an interface give under pressure: the measure of how stiff it must be to leave results alone.

use crate::hexahedra::hex;
use crate::interface::Seam;
use crate::life::Stage;
use crate::model::Model;
use tremolite_mesh::topology::vector_areas;

/// Closure of an interface over what the elements beside it give at the same pressure, above which results hang on its stiffness: in the
/// first case cracked volumes settle below this, and are a third smaller at 0.8.
pub const MOST_CLOSURE: f64 = 0.1;

/// Stiffness beyond the least that is chosen, so that the check of it does not fail by round-off.
const MARGIN: f64 = 1.01;

/// Σ h/(λ + 2μ) \[m/Pa\] of the elements on both sides, h their extent from the face, mean over the area that stands in the shaking. Not a
/// number where none of it does.
pub fn give_of_elements(model: &Model, seam: &Seam) -> f64 {
    let (mut sum, mut whole) = (0.0, 0.0);
    let standing = seam.faces.iter().zip(&seam.standing).filter(|(_, life)| life.holds(Stage::Shaking));
    for (faces, _) in standing {
        let vector = vector_areas(&model.mesh, &faces[..1]).into_values();
        let vector = vector.fold([0.0; 3], |sum, a| [0, 1, 2].map(|i| sum[i] + a[i]));
        let area = vector.iter().map(|x| x * x).sum::<f64>().sqrt();
        for face in faces {
            let element = face.element as usize;
            let (Some(body), Ok(hex)) = (model.elements.body_of[element], hex(&model.mesh, element)) else {
                continue;
            };
            let moduli = model.bodies[body].material.moduli();
            // The volume is the area times h.
            sum += hex.volume / (moduli.lambda + 2.0 * moduli.mu);
        }
        whole += area;
    }
    sum / whole
}

/// The normal stiffness \[Pa/m\] that an interface has at least where the program chooses it; 0 where nothing of it shakes.
pub(crate) fn least_stiffness(model: &Model, seam: &Seam) -> f64 {
    let give = give_of_elements(model, seam);
    if give > 0.0 { MARGIN / (MOST_CLOSURE * give) } else { 0.0 }
}
