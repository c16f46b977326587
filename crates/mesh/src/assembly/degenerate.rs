//! Hexahedra with repeated nodes: the wedge, pyramid, tetrahedron or pair of pyramids that they are.

use crate::{Element, Shape};

/// Orders in which the nodes of a hexahedron can be listed with the same orientation: its 24 rotations.
fn rotations() -> Vec<[usize; 8]> {
    const ABOUT_Z: [usize; 8] = [1, 2, 3, 0, 5, 6, 7, 4];
    const ABOUT_X: [usize; 8] = [4, 5, 1, 0, 7, 6, 2, 3];
    let mut all = vec![[0, 1, 2, 3, 4, 5, 6, 7]];
    let mut done = 0;
    while done < all.len() {
        for turn in [ABOUT_Z, ABOUT_X] {
            let turned = turn.map(|k| all[done][k]);
            if !all.contains(&turned) {
                all.push(turned);
            }
        }
        done += 1;
    }
    all
}

/// Whether a hexahedron uses a node twice.
pub(super) fn is_degenerate(element: &Element) -> bool {
    element.shape == Shape::Hex8 && (1..8).any(|i| element.nodes[..i].contains(&element.nodes[i]))
}

/// What a hexahedron with repeated nodes is: one element, or two pyramids. None if it is no such body.
pub(super) fn collapse(element: &Element) -> Option<(Element, Option<Element>)> {
    let mut distinct = element.nodes;
    distinct.sort_unstable();
    let count = 1 + distinct.windows(2).filter(|pair| pair[0] != pair[1]).count();
    rotations().iter().find_map(|order| {
        let n = order.map(|k| element.nodes[k]);
        let edge = n[2] == n[3];
        let top = n[4] == n[5] && n[5] == n[6] && n[6] == n[7];
        match count {
            6 if edge && n[6] == n[7] => {
                Some((Element::new(Shape::Wedge6, &[n[0], n[1], n[2], n[4], n[5], n[6]]), None))
            }
            5 if top => Some((Element::new(Shape::Pyramid5, &n[..5]), None)),
            4 if edge && top => Some((Element::new(Shape::Tet4, &[n[0], n[1], n[2], n[4]]), None)),
            // One collapsed edge: from there, pyramids on the two sides that it does not touch.
            7 if n[5] == n[6] => Some((
                Element::new(Shape::Pyramid5, &[n[0], n[3], n[7], n[4], n[5]]),
                Some(Element::new(Shape::Pyramid5, &[n[0], n[1], n[2], n[3], n[5]])),
            )),
            _ => None,
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quality::volume;

    const CUBE: [[f64; 3]; 8] = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 1.0],
        [1.0, 1.0, 1.0],
        [0.0, 1.0, 1.0],
    ];

    #[test]
    fn a_hexahedron_has_24_rotations_that_keep_its_volume() {
        let all = rotations();
        assert_eq!(all.len(), 24);
        for order in all {
            assert_eq!(volume(Shape::Hex8, &order.map(|k| CUBE[k])), 1.0, "{order:?}");
        }
    }

    #[test]
    fn a_collapsed_cube_has_the_volume_of_what_it_becomes() {
        // Nodes that fall together, and the volume that stays: half a cube, a third, a sixth; of the cube
        // without one edge the two pyramids of a third each.
        let cases: [(&[[usize; 2]], Shape, f64); 4] = [
            (&[[3, 2], [7, 6]], Shape::Wedge6, 0.5),
            (&[[5, 4], [6, 4], [7, 4]], Shape::Pyramid5, 1.0 / 3.0),
            (&[[3, 2], [5, 4], [6, 4], [7, 4]], Shape::Tet4, 1.0 / 6.0),
            (&[[6, 5]], Shape::Pyramid5, 2.0 / 3.0),
        ];
        for (pairs, shape, exact) in cases {
            let mut nodes = [0, 1, 2, 3, 4, 5, 6, 7];
            for &[from, to] in pairs {
                nodes[from] = to as u32;
            }
            for order in rotations() {
                let element = Element::new(Shape::Hex8, &order.map(|k| nodes[k]));
                assert!(is_degenerate(&element));
                let (first, second) = collapse(&element).unwrap();
                assert_eq!(first.shape, shape);
                let of = |e: &Element| {
                    let x: Vec<[f64; 3]> = e.nodes().iter().map(|&n| CUBE[n as usize]).collect();
                    volume(e.shape, &x)
                };
                let total = of(&first) + second.as_ref().map_or(0.0, of);
                assert!((total - exact).abs() < 1e-15, "{shape:?} {total}");
            }
        }
        let folded = Element::new(Shape::Hex8, &[0, 1, 2, 3, 4, 5, 0, 7]);
        assert!(is_degenerate(&folded) && collapse(&folded).is_none());
    }
}
