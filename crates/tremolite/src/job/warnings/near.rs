//! What sides, base and top that stand near an opening change of the stress around it.

use crate::near_sides::{MOST, NearSide};
use tremolite_case::{Case, Diagnostic, Side};

/// Across x and y, whether a side stands for a mirror.
pub fn mirrored(case: &Case) -> [bool; 2] {
    case.dynamic.sides.each_ref().map(|side| side.value == Side::Symmetry)
}

/// Of boundaries that stand too near an opening, the worst of each axis.
pub fn of_near(case: &Case, near: &[NearSide]) -> Vec<Diagnostic> {
    let mut worst: Vec<&NearSide> = Vec::new();
    for near in near.iter().filter(|near| near.share() > MOST) {
        match worst.iter_mut().find(|other| other.axis == near.axis) {
            Some(other) if near.share() > other.share() => *other = near,
            Some(_) => {}
            None => worst.push(near),
        }
    }
    worst.into_iter().map(|near| warning(case, near)).collect()
}

fn warning(case: &Case, near: &NearSide) -> Diagnostic {
    let (span, remedy) = match near.axis {
        2 => (case.dynamic.base.span.clone(), "of a generated mesh `below`, at the top `overburden`"),
        axis => {
            (case.dynamic.sides[axis].span.clone(), "of a generated mesh `sides`, along the caverns `length`")
        }
    };
    Diagnostic::new(
        span,
        format!(
            "{} is {:.1} m from an opening of {:.1} m: stresses around it will be wrong by about {:.0} %, 1.5 (R/(R + d))²",
            near.name(),
            near.distance,
            2.0 * near.radius,
            100.0 * near.share()
        ),
        format!("use at least {:.0} m, which makes it {:.0} %: {remedy}", near.enough().ceil(), 100.0 * MOST),
    )
}
