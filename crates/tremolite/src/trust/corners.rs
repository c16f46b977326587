//! What is left of the strength at corners where concrete drops to a plateau, which goes by the element size.

use crate::evidence::Evidence;
use tremolite_engine::Body;
use tremolite_laws::Role;
use tremolite_results::{Said, TrustLine, said, snake};

/// Share of the right strength that passes. Assumption: 15 % is what peaks of measured and computed specimens are told apart by
/// (tests of the half-notched beam bear 933 to 1,114 N, `gregoire2013`). The estimate is that of the end of a crack; a corner of 270°
/// keeps up to a quarter more.
pub const LEAST: f64 = 0.85;
const ID: &str = "plateau_corner_strength";

fn name() -> Said {
    said!("strength at corners over that by the fracture energy")
}

/// The extent \[m\] that half of them exceed or have: in a lining that comes to pieces many cracks run along it, and have its
/// thickness for their extent, and those do not decide.
pub fn typical(mut extents: Vec<f64>) -> Option<f64> {
    extents.sort_unstable_by(f64::total_cmp);
    extents.get(extents.len() / 2).copied()
}

/// A line for each body whose strength at corners goes by its elements.
pub(super) fn lines(evidence: &Evidence) -> Vec<TrustLine> {
    let bodies = evidence.model.user_bodies().iter();
    let plateau = |body: &&Body| body.material.corner_strength(1.0).is_some();
    let mut lines: Vec<TrustLine> = bodies.filter(plateau).map(|body| line(evidence, body)).collect();
    if lines.is_empty() {
        lines.push(TrustLine::not_applicable(
            ID,
            name(),
            said!("no concrete has the plateau (evolution = residual)"),
        ));
    }
    lines
}

fn line(evidence: &Evidence, body: &Body) -> TrustLine {
    let cracked = cracked(evidence, body);
    let count = cracked.len();
    let (least, most) = cracked.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), &h| (a.min(h), b.max(h)));
    let extent = typical(cracked);
    // Too low a strength would have cracked it.
    let left = extent.map_or(Some(1.0), |h| body.material.corner_strength(h)).unwrap_or(f64::NAN);
    let id = format!("{ID}_{}", snake(&body.name));
    let name = said!("{check}, {body}", check = name(), body = &body.name);
    let line = TrustLine::at_least(id, name, left, LEAST, "");
    let Some(extent) = extent else {
        return line.with_note(said!("none of it has cracked; a plateau makes corners too weak"));
    };
    let size = format!("{extent:.3}");
    let line =
        line.with("extent", extent).with("least", least).with("most", most).with("cracked", count as f64);
    let pass = line.pass;
    line.with_note(if pass {
        said!(
            "half of the {count} cracked points are in elements that extend over {size} m or more across the crack, large enough for the drop to \
             a plateau",
            count = count.to_string(),
            size = size,
        )
    } else {
        said!(
            "half of the {count} cracked points are in elements that extend over {size} m or less across the crack: dropping to a plateau \
             these break by their mean stress where it concentrates, at this share of the load, and the smaller they are the earlier; \
             evolution = \"exponential\" keeps to the fracture energy",
            count = count.to_string(),
            size = size,
        )
    })
}

/// Of each point that has cracked the extent of its element across the crack \[m\].
fn cracked(evidence: &Evidence, body: &Body) -> Vec<f64> {
    let Evidence { model, assembly, phase, outcome, .. } = evidence;
    let history = outcome.history(assembly);
    let mut extents = Vec::new();
    for element in model.lasting(body) {
        let Some(slot) = &phase.element_slot[element as usize] else { continue };
        let [damage, extent] =
            [Role::TensionDamage, Role::CrackExtent].map(|role| history.with_role(slot, role));
        let (Some(damage), Some(extent)) = (damage, extent) else { continue };
        let points = history.values(slot, damage).zip(history.values(slot, extent));
        extents.extend(points.filter(|(damage, _)| *damage > 0.0).map(|(_, extent)| extent));
    }
    extents
}

#[cfg(test)]
mod tests {
    use super::typical;

    #[test]
    fn fewer_than_half_may_be_smaller_than_what_is_judged() {
        let many =
            |small: usize| (0..20).map(|k| if k < small { 0.5 } else { 3.0 }).rev().collect::<Vec<_>>();
        assert_eq!([10, 11].map(|small| typical(many(small))), [Some(3.0), Some(0.5)]);
        assert_eq!((typical(vec![2.0]), typical(vec![])), (Some(2.0), None));
    }
}
