use super::*;

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

/// Regular shapes with edges of length 1, and their volumes.
fn regular() -> [(Shape, Vec<[f64; 3]>, f64); 4] {
    let (h, r) = (3f64.sqrt() / 2.0, 3f64.sqrt() / 6.0);
    let triangle = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.5, h, 0.0]];
    let mut wedge = triangle.to_vec();
    wedge.extend(triangle.map(|p| [p[0], p[1], 1.0]));
    let mut pyramid = CUBE[..4].to_vec();
    pyramid.push([0.5, 0.5, 0.5f64.sqrt()]);
    let mut tet = triangle.to_vec();
    tet.push([0.5, r, (2.0f64 / 3.0).sqrt()]);
    [
        (Shape::Hex8, CUBE.to_vec(), 1.0),
        (Shape::Wedge6, wedge, h / 2.0),
        (Shape::Pyramid5, pyramid, 0.5f64.sqrt() / 3.0),
        (Shape::Tet4, tet, 2f64.sqrt() / 12.0),
    ]
}

#[test]
fn regular_shapes_have_scaled_jacobian_one_and_their_volume() {
    for (shape, x, exact) in regular() {
        assert!((scaled_jacobian(shape, &x) - 1.0).abs() < 1e-14, "{shape:?}");
        assert!((volume(shape, &x) - exact).abs() < 1e-15, "{shape:?} {}", volume(shape, &x));
    }
}

#[test]
fn every_corner_counts() {
    // Pulling one corner of the cube along its diagonal flattens that corner alone at 1/3 of the way
    // from it: the corner then lies in the plane of its three neighbours.
    for moved in 0..8 {
        let mut x = CUBE;
        for c in &mut x[moved] {
            *c += (0.5 - *c) * (2.0 / 3.0);
        }
        assert!(scaled_jacobian(Shape::Hex8, &x).abs() < 1e-15, "corner {moved}");
    }
    for (shape, x, _) in regular() {
        let mirrored: Vec<[f64; 3]> = x.iter().map(|p| [p[0], p[1], -p[2]]).collect();
        assert!((scaled_jacobian(shape, &mirrored) + 1.0).abs() < 1e-14, "{shape:?}");
    }
}

#[test]
fn hexahedron_volume_equals_its_gauss_integral() {
    let mut x = CUBE;
    for (n, p) in x.iter_mut().enumerate() {
        for (i, c) in p.iter_mut().enumerate() {
            *c += 1000.0 + 0.2 * ((7 * n + 3 * i) as f64).sin();
        }
    }
    // 2×2×2 points integrate det J of a trilinear map exactly (degree 2 in each coordinate).
    let mut exact = 0.0;
    for point in CUBE {
        let g = point.map(|c| (2.0 * c - 1.0) / 3f64.sqrt());
        let mut j = [[0.0; 3]; 3];
        for (corner, p) in CUBE.iter().zip(&x) {
            let s = corner.map(|c| 2.0 * c - 1.0);
            let f = [1.0 + s[0] * g[0], 1.0 + s[1] * g[1], 1.0 + s[2] * g[2]];
            let slope = [s[0] * f[1] * f[2], f[0] * s[1] * f[2], f[0] * f[1] * s[2]];
            for (row, d) in j.iter_mut().zip(slope) {
                for (value, c) in row.iter_mut().zip(p) {
                    *value += d / 8.0 * (c - 1000.0);
                }
            }
        }
        exact += triple(j[0], j[1], j[2]);
    }
    assert!((volume(Shape::Hex8, &x) - exact).abs() < 1e-11, "{} {exact}", volume(Shape::Hex8, &x));
}

#[test]
fn a_brick_reports_its_edges_and_groups() {
    let spec = crate::boxes::BoxSpec::uniform([0.0; 3], [4.0, 1.0, 6.0], [2, 2, 3]);
    let mut mesh = spec.mesh().unwrap();
    mesh.groups.insert("low".into(), vec![0, 1, 2, 3]);
    let one = of(&mesh, 5);
    assert_eq!((one.shortest_edge, one.longest_edge, one.aspect()), (0.5, 2.0, 4.0));
    assert!((one.size() - 2f64.cbrt()).abs() < 1e-15);
    let low = by_group(&mesh)["low"];
    assert_eq!(low.elements, 4);
    assert!((low.volume - 8.0).abs() < 1e-13 && (summary(&mesh).volume - 24.0).abs() < 1e-13);
}

#[test]
fn a_collapsed_element_is_the_worst() {
    let mut mesh = crate::boxes::BoxSpec::uniform([0.0; 3], [2.0, 1.0, 1.0], [2, 1, 1]).mesh().unwrap();
    let far = mesh.elements[1].nodes[1] as usize;
    mesh.nodes[far] = mesh.nodes[mesh.elements[1].nodes[0] as usize];
    assert_eq!(summary(&mesh).worst, Some(1));
}
