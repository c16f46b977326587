//! Which way cracks of a lining run: by their normals in the lining's own frame.

use crate::observers::section_forces::lined;
use std::collections::HashMap;
use tremolite_engine::model::Model;
use tremolite_laws::Octet;
use tremolite_laws::sym3::eigen_of_eight;
use tremolite_results::CrackDirection;

/// Unit vectors of a lining at an element: round the ring, and through the thickness; the third is along the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    pub round: [f64; 3],
    pub through: [f64; 3],
}

/// The frames of the elements of linings that a station passes through, those before a change of material included. Where walls meet there
/// is none.
pub(super) fn frames(model: &Model) -> HashMap<u32, Frame> {
    let mut found = HashMap::new();
    for (_, station) in lined(model) {
        let frame = Frame { round: station.along, through: station.normal };
        for (e, _) in &station.stack {
            let same = std::iter::successors(Some(*e), |e| model.elements.successors.get(e).copied());
            found.extend(same.map(|e| (e, frame)));
        }
    }
    found
}

/// Less than this share of the widest crack of a point is the round-off of its square.
const ROUND_OFF: f64 = 1e-6;
/// Square of the cosine of 45°, and a little more, so that a crack at just 45° is one across bars.
const OBLIQUE: f64 = 0.5 + 1e-9;

impl Frame {
    /// The same in other axes, given by their unit vectors.
    pub fn within(&self, axes: &[[f64; 3]; 3]) -> Frame {
        let turn = |v: &[f64; 3]| axes.map(|axis| (0..3).map(|i| axis[i] * v[i]).sum::<f64>());
        Frame { round: turn(&self.round), through: turn(&self.through) }
    }

    /// Of a crack with this unit normal: parallel to the wall if the normal lies within 45° of the thickness, else by whether it lies nearer
    /// the ring or the axis.
    pub fn direction(&self, normal: &[f64; 3]) -> CrackDirection {
        let along = |way: &[f64; 3]| (0..3).map(|i| normal[i] * way[i]).sum::<f64>().powi(2);
        let (through, round) = (along(&self.through), along(&self.round));
        match (through > OBLIQUE, round >= 1.0 - through - round) {
            (true, _) => CrackDirection::Parallel,
            (false, true) => CrackDirection::Longitudinal,
            (false, false) => CrackDirection::Ring,
        }
    }
}

/// The widest crack \[m\] of each direction at some points, by the openings squared \[m²\] and the width of the widest crack \[m\] of each.
pub(super) fn widths(
    frame: Option<&Frame>,
    points: impl Iterator<Item = ([f64; 6], f64)>,
) -> [f64; CrackDirection::ALL.len()] {
    let mut found = [0.0_f64; CrackDirection::ALL.len()];
    let mut meet = |direction: CrackDirection, opening: f64| {
        let most = &mut found[direction as usize];
        *most = most.max(opening);
    };
    let mut open = points.filter(|(_, width)| *width > 0.0).peekable();
    while open.peek().is_some() {
        let (mut squares, mut widths) = ([Octet::ZERO; 6], Vec::with_capacity(8));
        for (lane, (of_point, width)) in open.by_ref().take(8).enumerate() {
            squares.iter_mut().zip(of_point).for_each(|(octet, x)| octet.0[lane] = x);
            widths.push(width);
        }
        let Some(frame) = frame else {
            widths.into_iter().for_each(|width| meet(CrackDirection::Unplaced, width));
            continue;
        };
        let cracks = eigen_of_eight(&squares);
        for (lane, width) in widths.into_iter().enumerate() {
            for (k, (square, normal)) in cracks.values.iter().zip(&cracks.vectors).enumerate() {
                let opening = if k == 0 { width } else { square.0[lane].max(0.0).sqrt() };
                if opening > ROUND_OFF * width {
                    meet(frame.direction(&normal.map(|x| x.0[lane])), opening);
                }
            }
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Frame = Frame { round: [0.6, 0.0, 0.8], through: [-0.8, 0.0, 0.6] };

    /// In the frame: round the ring, along the axis, through the thickness.
    fn turned(n: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|i| n[0] * FRAME.round[i] + n[1] * [0.0, 1.0, 0.0][i] + n[2] * FRAME.through[i])
    }

    #[test]
    fn a_crack_is_parallel_to_the_wall_within_45_degrees_and_else_goes_by_the_nearer_bars() {
        let of = |n| FRAME.direction(&turned(n));
        assert_eq!(of([1.0, 0.0, 0.0]), CrackDirection::Longitudinal);
        assert_eq!(of([0.0, -1.0, 0.0]), CrackDirection::Ring);
        assert_eq!(of([0.0, 0.0, 1.0]), CrackDirection::Parallel);
        for (degrees, expected) in [
            (44.0_f64, CrackDirection::Parallel),
            (45.0, CrackDirection::Longitudinal),
            (46.0, CrackDirection::Longitudinal),
        ] {
            let (sine, cosine) = degrees.to_radians().sin_cos();
            assert_eq!(of([sine, 0.0, cosine]), expected, "{degrees}");
        }
        // 54.7° off the thickness: the largest component is no criterion.
        assert_eq!(of([0.57, 0.58, 0.582]), CrackDirection::Ring);
        assert_eq!(of([0.5_f64.sqrt(), 0.5_f64.sqrt(), 0.0]), CrackDirection::Longitudinal);
    }

    #[test]
    fn the_widest_crack_of_each_direction_counts_and_all_of_them_where_there_is_no_frame() {
        let (split, ring) = (turned([0.0, 0.0, 1.0]), turned([0.0, 1.0, 0.0]));
        let of = |i: usize, k: usize| 9e-6 * split[i] * split[k] + 1e-6 * ring[i] * ring[k];
        let squares = [of(0, 0), of(1, 1), of(2, 2), of(0, 1), of(1, 2), of(2, 0)];
        let [longitudinal, across, parallel, unplaced] = widths(Some(&FRAME), [(squares, 3e-3)].into_iter());
        assert_eq!([longitudinal, parallel, unplaced], [0.0, 3e-3, 0.0]);
        assert!((across - 1e-3).abs() < 1e-12, "{across}");
        assert_eq!(widths(None, [(squares, 3e-3)].into_iter()), [0.0, 0.0, 0.0, 3e-3]);
        assert_eq!(widths(Some(&FRAME), [([0.0; 6], 0.0)].into_iter()), [0.0; 4]);
        // Of many points, the widest of each, wherever it lies among them.
        let many = (0..19).map(|k| match k {
            17 => (squares, 3e-3),
            _ => ([0.0; 6], if k % 2 == 0 { 0.0 } else { 1e-9 }),
        });
        let [_, across, parallel, _] = widths(Some(&FRAME), many);
        assert!((across - 1e-3).abs() < 1e-12 && parallel == 3e-3, "{across} {parallel}");
    }
}
