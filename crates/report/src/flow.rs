//! Arrows of the flow of water: of a field of elements as many as can be told apart.

use std::collections::HashMap;

/// Flow below this share of the largest is not drawn.
const LEAST: f64 = 1e-3;
/// The longest arrow over the side of the cubes of which each has one.
const LONGEST: f64 = 0.9;

/// Where water flows, and how: the middle of an arrow (m), and from its tail to its head (m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FlowArrow {
    pub at: [f64; 3],
    pub way: [f64; 3],
}

/// Arrows, and the side of the cubes of which each has one (m).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Flow {
    pub arrows: Vec<FlowArrow>,
    pub side: f64,
}

/// At most `most` arrows of elements, given by their middles (m) and specific discharges (m/s). Space is parted into equal cubes; a
/// cube in which water flows has the arrow of the element nearest to its centre. Lengths go with the root of the discharge, which
/// falls with the distance from an opening: the largest is 0.9 times the side of a cube.
pub fn arrows(elements: &[([f64; 3], [f64; 3])], most: usize) -> Flow {
    let size = |v: &[f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let largest = elements.iter().map(|(_, q)| size(q)).filter(|q| q.is_finite()).fold(0.0, f64::max);
    let seen = |q: f64| q.is_finite() && q > LEAST * largest;
    let flowing: Vec<_> = elements.iter().filter(|(_, q)| seen(size(q))).collect();
    let ends = |low: bool| {
        [0, 1, 2].map(|k| {
            let along = flowing.iter().map(|(at, _)| at[k]);
            if low { along.fold(f64::INFINITY, f64::min) } else { along.fold(f64::NEG_INFINITY, f64::max) }
        })
    };
    let (low, high) = (ends(true), ends(false));
    let widest = (0..3).map(|k| high[k] - low[k]).fold(0.0, f64::max);
    if flowing.is_empty() || most == 0 {
        return Flow::default();
    }
    // One cube holds all in the end.
    let mut side = (widest / most as f64).max(f64::MIN_POSITIVE);
    loop {
        let cube = |at: &[f64; 3]| [0, 1, 2].map(|k| ((at[k] - low[k]) / side).floor() as i64);
        let off = |at: &[f64; 3]| {
            let centre = |k: usize| low[k] + (cube(at)[k] as f64 + 0.5) * side;
            size(&[0, 1, 2].map(|k| at[k] - centre(k)))
        };
        let mut chosen: HashMap<[i64; 3], usize> = HashMap::new();
        for (e, (at, _)) in flowing.iter().enumerate() {
            let known = chosen.entry(cube(at)).or_insert(e);
            if off(at) < off(&flowing[*known].0) {
                *known = e;
            }
        }
        if chosen.len() <= most {
            let mut chosen: Vec<usize> = chosen.into_values().collect();
            chosen.sort_unstable();
            let arrow = |e: usize| {
                let (at, q) = flowing[e];
                let length = LONGEST * side * (size(q) / largest).sqrt();
                FlowArrow { at: *at, way: q.map(|x| x / size(q) * length) }
            };
            return Flow { arrows: chosen.into_iter().map(arrow).collect(), side };
        }
        side *= 1.1;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Radial flow: every arrow points to the middle, the longest stands nearest to it, and no two share a cube.
    #[test]
    fn arrows_follow_the_flow_and_are_as_many_as_can_be_told_apart() {
        let elements: Vec<_> = (0..40 * 40)
            .map(|k| {
                let [x, z] = [k % 40, k / 40].map(|i| f64::from(i) - 19.5);
                let square = x * x + z * z;
                ([x, 1.0, z], [-1e-8 * x / square, 0.0, -1e-8 * z / square])
            })
            .collect();
        let flow = arrows(&elements, 150);
        assert!((75..=150).contains(&flow.arrows.len()), "{}", flow.arrows.len());
        let length = |a: &FlowArrow| a.way.iter().map(|x| x * x).sum::<f64>().sqrt();
        let radius = |a: &FlowArrow| a.at[0].hypot(a.at[2]);
        for arrow in &flow.arrows {
            let inwards = -(arrow.at[0] * arrow.way[0] + arrow.at[2] * arrow.way[2]);
            assert!((inwards / (length(arrow) * radius(arrow)) - 1.0).abs() < 1e-12, "{arrow:?}");
            // Discharge goes with 1/r and the length with its root; the largest of all is at a radius of √½.
            let wanted = LONGEST * flow.side * (0.5f64.sqrt() / radius(arrow)).sqrt();
            assert!((length(arrow) / wanted - 1.0).abs() < 1e-12, "{arrow:?}");
        }
        let cubes: std::collections::HashSet<_> = flow
            .arrows
            .iter()
            .map(|a| [0, 2].map(|k| ((a.at[k] + 19.5) / flow.side).floor() as i64))
            .collect();
        assert_eq!(cubes.len(), flow.arrows.len());
        // Still water has none, nor has a value that is no number.
        assert_eq!(arrows(&[([0.0; 3], [0.0; 3]), ([1.0; 3], [f64::NAN; 3])], 150), Flow::default());
        assert_eq!(arrows(&elements[..1], 150).arrows.len(), 1);
    }
}
