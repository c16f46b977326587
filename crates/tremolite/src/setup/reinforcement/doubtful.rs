//! What of reinforcement cannot be meant.

use crate::sections::Station;
use std::collections::HashMap;
use tremolite_case::{BarDirection, BarFace, Case, Diagnostic, Reinforcement, Side};
use tremolite_engine::outer_faces::NEAR;

pub fn too_thin(steel: &Reinforcement, group: &str, stations: &[Station]) -> Option<Diagnostic> {
    let thinnest = stations.iter().map(|s| s.thickness).min_by(f64::total_cmp)?;
    let (least, why) = match steel.face.value {
        BarFace::Both => {
            (0.5 * thinnest, "half the thickness, so bars of both faces would meet or pass each other")
        }
        BarFace::Intrados | BarFace::Extrados => (thinnest, "the thickness, so bars would lie outside"),
    };
    (steel.cover.value >= least).then(|| {
        Diagnostic::at(
            &steel.cover,
            format!(
                "'{group}' is {} thick; a cover of {} reaches {why}",
                millimetres(thinnest),
                millimetres(steel.cover.value)
            ),
            format!(
                "give less than {}, from the concrete's face to the bars' axis, or look at the unit of the thickness",
                millimetres(least)
            ),
        )
    })
}

/// A length \[m\] as those of sections are written, in millimetres.
fn millimetres(length: f64) -> String {
    match 1e3 * length {
        few if few < 10.0 => format!("{few:.1} mm"),
        many => format!("{many:.0} mm"),
    }
}

/// A bar that lies along a free-field side in an element at it: the slab outside stands for the same section, and has no bars.
pub fn not_in_slabs(
    case: &Case,
    steel: &Reinforcement,
    bounds: ([f64; 3], [f64; 3]),
    mut nodes: impl Iterator<Item = [f64; 3]>,
    [from, to]: &[[f64; 3]; 2],
) -> Option<Diagnostic> {
    case.motion.as_ref()?;
    let length = (0..3).map(|i| (to[i] - from[i]).powi(2)).sum::<f64>().sqrt();
    let along = |axis: usize| (to[axis] - from[axis]).abs() < ALONG * length;
    let free = |axis: &usize| case.dynamic.sides[*axis].value == Side::FreeField;
    let axes: Vec<usize> = (0..2).filter(free).filter(|&axis| along(axis)).collect();
    let at = |x: [f64; 3], axis: usize| {
        let near = NEAR * (bounds.1[axis] - bounds.0[axis]);
        [bounds.0, bounds.1].iter().any(|end| (x[axis] - end[axis]).abs() < near)
    };
    let axis = nodes.find_map(|x| axes.iter().copied().find(|&axis| at(x, axis)))?;
    let name = ["x", "y"][axis];
    Some(Diagnostic::at(
        steel.on.first()?,
        format!(
            "bars lie in the free-field side across {name}: the slab outside has this lining without them, and drives it there as a plain \
             lining would"
        ),
        format!(
            "write sides = {{ {name} = \"periodic\" }} or \"symmetry\" where the cavern goes on like this, or let it end in rock before the side"
        ),
    ))
}

/// A way along a side over the length of a bar up to which it lies along it.
const ALONG: f64 = 0.1;

/// Thicker \[m\] than linings are.
const THICKEST: f64 = 5.0;
/// Steel over concrete beyond which a unit is wrong.
const MOST_STEEL: f64 = 0.1;

pub fn too_thick(steel: &Reinforcement, group: &str, stations: &[Station]) -> Option<Diagnostic> {
    let thickest = stations.iter().map(|s| s.thickness).max_by(f64::total_cmp).filter(|t| *t > THICKEST)?;
    let on = steel.on.first()?;
    Some(Diagnostic::at(
        on,
        format!("'{group}' is {thickest:.1} m thick in places, so it is no lining"),
        "name the groups of the lining",
    ))
}

pub fn too_much(steel: &Reinforcement, group: &str, stations: &[Station]) -> Option<Diagnostic> {
    let thinnest = stations.iter().map(|s| s.thickness).min_by(f64::total_cmp)?;
    let faces = if steel.face.value == BarFace::Both { 2.0 } else { 1.0 };
    let share = faces * steel.area.value / thinnest;
    (share > MOST_STEEL).then(|| {
        Diagnostic::at(
            &steel.area,
            format!("'{group}' would be {:.0} % of steel where it is {thinnest:.2} m thick", 100.0 * share),
            "look at the unit: \"1570 mm2/m\" is 20 mm every 20 cm",
        )
    })
}

/// What bars lie in so far, with their direction, face and cover \[m\].
pub type Laid = HashMap<u32, Vec<(BarDirection, BarFace, f64)>>;

/// Bars of one table where those of another lie.
pub fn twice(steel: &Reinforcement, group: &str, elements: &[u32], laid: &mut Laid) -> Option<Diagnostic> {
    let (direction, face, cover) = (steel.direction.value, steel.face.value, steel.cover.value);
    let meets = |&(d, f, c): &(BarDirection, BarFace, f64)| {
        d == direction
            && (f == face || f == BarFace::Both || face == BarFace::Both)
            && (c - cover).abs() < 1e-6
    };
    let again = elements.iter().any(|e| laid.get(e).is_some_and(|known| known.iter().any(meets)));
    elements.iter().for_each(|&e| laid.entry(e).or_default().push((direction, face, cover)));
    again.then(|| {
        Diagnostic::new(
            steel.span.clone(),
            format!("'{group}' has bars of another [[reinforcement]] at the same place already"),
            "give the whole area once, or another cover or direction",
        )
    })
}
