//! A head that is linear in space is exact on any mesh.

use crate::common::{K, Made, even, farthest, grid, noise};
use tremolite_seepage::{Holds, Place};

const SLOPE: [f64; 3] = [0.3, -0.2, 0.5];

/// Far above the ground, so that all of it is below the free surface.
fn head(x: [f64; 3]) -> f64 {
    1000.0 + SLOPE.iter().zip(x).map(|(s, x)| s * x).sum::<f64>()
}

/// Holds the head at the outer nodes, and looks at all others and at the flow.
fn passes(made: &Made, is_outer: &[bool]) {
    let outer = (0..made.nodes.len() as u32).filter(|&n| is_outer[n as usize]);
    let hold = |n: u32| Place {
        name: n.to_string(),
        holds: Holds::Head(head(made.nodes[n as usize])),
        nodes: vec![(n, 1.0)],
    };
    let flow = made.solve(&outer.map(hold).collect::<Vec<_>>()).unwrap();
    let far = farthest(made, &flow, head);
    // Heads differ by some 10 m.
    assert!(far < 1e-9, "{far}");
    for q in &flow.velocities {
        let off = q.iter().zip(SLOPE).map(|(q, s)| (q + K * s).abs()).fold(0.0, f64::max);
        assert!(off < 1e-9 * K, "{q:?}");
    }
    assert!(is_outer.iter().any(|outer| !outer));
}

fn outer(made: &Made, size: [f64; 3]) -> Vec<bool> {
    let on = |x: &[f64; 3]| (0..3).any(|i| x[i] == 0.0 || x[i] == size[i]);
    made.nodes.iter().map(on).collect()
}

/// A box of unlike sides, its inner nodes moved by up to a quarter of an element, turned in space.
fn bent() -> (Made, Vec<bool>) {
    let size = [3.0, 8.0, 20.0];
    let mut made = grid(&even(0.0, size[0], 4), &even(0.0, size[1], 4), &even(0.0, size[2], 4));
    let outer = outer(&made, size);
    for (n, x) in made.nodes.iter_mut().enumerate().filter(|(n, _)| !outer[*n]) {
        (0..3).for_each(|i| x[i] += 0.25 * noise(n, i) * size[i] / 4.0);
    }
    turn(&mut made);
    (made, outer)
}

fn turn(made: &mut Made) {
    let (a, b) = (0.6_f64, 0.9_f64);
    for x in &mut made.nodes {
        let [u, v, w] = *x;
        let [u, v] = [a.cos() * u - a.sin() * v, a.sin() * u + a.cos() * v];
        *x = [u, b.cos() * v - b.sin() * w, b.sin() * v + b.cos() * w];
    }
}

#[test]
fn hexahedra_bent_and_turned() {
    let (made, outer) = bent();
    passes(&made, &outer);
}

/// Each hexahedron of the bent mesh as two wedges, its corners 2 and 3 and 6 and 7 falling together.
#[test]
fn wedges() {
    let (mut made, outer) = bent();
    made.elements = made
        .elements
        .iter()
        .flat_map(|n| {
            [
                [n[0], n[1], n[2], n[2], n[4], n[5], n[6], n[6]],
                [n[0], n[2], n[3], n[3], n[4], n[6], n[7], n[7]],
            ]
        })
        .collect();
    made.conductivity = vec![K; made.elements.len()];
    passes(&made, &outer);
}

/// Each as six tetrahedra about its diagonal, as collapsed hexahedra.
#[test]
fn tetrahedra() {
    let (mut made, outer) = bent();
    let ring = [1, 2, 3, 7, 4, 5];
    let of = |n: &[u32; 8]| {
        let n = *n;
        (0..6).map(move |k| [n[0], n[ring[k]], n[ring[(k + 1) % 6]], n[6]])
    };
    made.elements = made.elements.iter().flat_map(of).map(|[a, b, c, d]| [a, b, c, c, d, d, d, d]).collect();
    made.conductivity = vec![K; made.elements.len()];
    passes(&made, &outer);
}

/// Each as six pyramids about a node in its middle.
#[test]
fn pyramids() {
    let (mut made, mut outer) = bent();
    const BASES: [[usize; 4]; 6] =
        [[0, 3, 7, 4], [1, 5, 6, 2], [0, 4, 5, 1], [3, 2, 6, 7], [0, 1, 2, 3], [4, 7, 6, 5]];
    let mut pyramids = Vec::new();
    for e in 0..made.elements.len() {
        let n = made.elements[e];
        let apex = made.nodes.len() as u32;
        made.nodes.push(crate::common::middle(&made, e));
        outer.push(false);
        pyramids.extend(BASES.map(|b| [n[b[0]], n[b[1]], n[b[2]], n[b[3]], apex, apex, apex, apex]));
    }
    made.elements = pyramids;
    made.conductivity = vec![K; made.elements.len()];
    passes(&made, &outer);
}
