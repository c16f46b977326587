//! Meshes of mixed shapes: the patch test through the model and the engine.

use crate::ready::Ready;
use tremolite::{Body, Problem, Quadrature, elastic};
use tremolite_laws::{Moduli, Row};
use tremolite_mesh::{Element, Mesh, Shape};

/// Two cubes: one of pyramids about an inner node, one of them cut into two tetrahedra; one of two wedges; and
/// hexahedra around an inner node on top.
fn mixed() -> Mesh {
    let mut mesh = Mesh::default();
    let mut number = std::collections::BTreeMap::new();
    let mut node = |mesh: &mut Mesh, x: [f64; 3]| -> u32 {
        *number.entry(x.map(|v| (v * 1e6) as i64)).or_insert_with(|| {
            mesh.nodes.push(x);
            (mesh.nodes.len() - 1) as u32
        })
    };
    let mut cube = |mesh: &mut Mesh, x: [f64; 3]| {
        [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]].map(
            |c: [i32; 3]| {
                let mut p = [0, 1, 2].map(|i| x[i] + f64::from(c[i]));
                // Nodes inside the whole block are moved.
                if p == [1.0, 1.0, 1.0] {
                    p = [1.1, 0.9, 1.2];
                }
                node(mesh, p)
            },
        )
    };
    // A 2 × 2 × 2 block of cubes, each cut in its own way; faces between them are whole quadrilaterals.
    for i in 0..2 {
        for j in 0..2 {
            for k in 0..2 {
                let c = cube(&mut mesh, [f64::from(i), f64::from(j), f64::from(k)]);
                match (i, j, k) {
                    (0, 0, 0) => {
                        let centre = mesh.nodes.len() as u32;
                        mesh.nodes.push([0.55, 0.4, 0.5]);
                        for (n, face) in Shape::Hex8.faces().iter().enumerate() {
                            // Outward faces are turned round, so that the apex lies inside.
                            let f: Vec<u32> = face.iter().rev().map(|&v| c[v]).collect();
                            if n == 4 {
                                // The bottom lies outside, so its diagonal is free.
                                mesh.elements.push(Element::new(Shape::Tet4, &[f[0], f[1], f[2], centre]));
                                mesh.elements.push(Element::new(Shape::Tet4, &[f[0], f[2], f[3], centre]));
                            } else {
                                mesh.elements
                                    .push(Element::new(Shape::Pyramid5, &[f[0], f[1], f[2], f[3], centre]));
                            }
                        }
                    }
                    (1, 1, 0) => {
                        // Cut along the vertical diagonal plane; triangles lie at the bottom and at the top, which
                        // belongs to a cube cut alike.
                        mesh.elements
                            .push(Element::new(Shape::Wedge6, &[c[0], c[1], c[2], c[4], c[5], c[6]]));
                        mesh.elements
                            .push(Element::new(Shape::Wedge6, &[c[0], c[2], c[3], c[4], c[6], c[7]]));
                    }
                    (1, 1, 1) => {
                        mesh.elements
                            .push(Element::new(Shape::Wedge6, &[c[0], c[1], c[2], c[4], c[5], c[6]]));
                        mesh.elements
                            .push(Element::new(Shape::Wedge6, &[c[0], c[2], c[3], c[4], c[6], c[7]]));
                    }
                    _ => mesh.elements.push(Element::new(Shape::Hex8, &c)),
                }
            }
        }
    }
    mesh
}

#[test]
fn a_mixed_mesh_passes_the_patch_test_to_round_off() {
    for quadrature in [Quadrature::OnePoint, Quadrature::Full] {
        let mesh = mixed();
        let moduli = Moduli::from_young_poisson(1e6, 0.25);
        let body = Body {
            name: "block".into(),
            elements: (0..mesh.elements.len() as u32).collect(),
            material: elastic(moduli),
            density: 1000.0,
            quadrature,
            viscosity: 0.0,
        };
        let ready = Ready::new(Problem::new(mesh, vec![body]));
        let (model, phase) = (&ready.model, &ready.phase);
        // MacNeal & Harder's field: all strains 10⁻³, stresses 2000 and 400 Pa.
        let field = |x: [f64; 3]| {
            [
                5e-4 * (2.0 * x[0] + x[1] + x[2]),
                5e-4 * (x[0] + 2.0 * x[1] + x[2]),
                5e-4 * (x[0] + x[1] + 2.0 * x[2]),
            ]
        };
        let mut state = ready.assembly.rest();
        state.dt = 1e-6;
        state.u = model.mesh_node.iter().map(|&n| Row::new(field(model.mesh.nodes[n as usize]))).collect();
        let snapshot = ready.engine().look(&state).snapshot;
        for stress in &snapshot.stress {
            for (found, exact) in stress.iter().zip([2000.0, 2000.0, 2000.0, 400.0, 400.0, 400.0]) {
                assert!((found - exact).abs() < 1e-9 * exact, "{quadrature:?}: {stress:?}");
            }
        }
        let mut inner = 0;
        for (node, a) in snapshot.acceleration.iter().enumerate() {
            let x = model.mesh.nodes[model.mesh_node[node] as usize];
            if x.iter().all(|&v| v > 1e-9 && v < 2.0 - 1e-9) {
                inner += 1;
                let force = a.xyz().map(|a| a * phase.mass[node]);
                assert!(force.iter().all(|f| f.abs() < 1e-10), "{quadrature:?}: {force:?} N at {x:?}");
            }
        }
        assert_eq!(inner, 2);
        let mass: f64 = phase.mass.iter().sum();
        assert!((mass - 8000.0).abs() < 1e-9, "{mass}");
    }
}
