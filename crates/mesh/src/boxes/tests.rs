use super::*;

fn distorted(fraction: f64, periodic: bool) -> BoxSpec {
    let distortion = Some(Distortion { fraction, seed: 7, periodic: [periodic; 2] });
    let graded = Axis::Graded { from: 0.0, to: 3.0, elements: 5, ratio: 1.3 };
    BoxSpec { x: graded, y: Axis::uniform(-1.0, 1.0, 4), z: Axis::uniform(-4.0, 0.0, 4), distortion }
}

fn plane(mesh: &Mesh, set: &str) -> Vec<[f64; 3]> {
    let mut nodes: Vec<u32> = mesh.faces[set].iter().flat_map(|&f| mesh.face_nodes(f)).collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes.iter().map(|&n| mesh.nodes[n as usize]).collect()
}

#[test]
fn a_graded_axis_is_a_geometric_row() {
    let axis = Axis::Graded { from: 1.0, to: 8.0, elements: 3, ratio: 2.0 };
    let x = axis.coordinates('x').unwrap();
    for (x, exact) in x.iter().zip([1.0, 2.0, 4.0, 8.0]) {
        assert!((x - exact).abs() < 1e-14, "{x} against {exact}");
    }
}

#[test]
fn face_sets_lie_on_their_planes_with_outward_normals() {
    let mesh = distorted(0.1, false).mesh().unwrap();
    let planes = [
        ("xmin", 0, 0.0),
        ("xmax", 0, 3.0),
        ("ymin", 1, -1.0),
        ("ymax", 1, 1.0),
        ("base", 2, -4.0),
        ("top", 2, 0.0),
    ];
    for (name, axis, value) in planes {
        assert!(plane(&mesh, name).iter().all(|x| x[axis] == value), "{name}");
        for &face in &mesh.faces[name] {
            let n: Vec<[f64; 3]> = mesh.face_nodes(face).map(|n| mesh.nodes[n as usize]).collect();
            let (b, c) = ((axis + 1) % 3, (axis + 2) % 3);
            let area: f64 = (0..4).map(|i| n[i][b] * n[(i + 1) % 4][c] - n[(i + 1) % 4][b] * n[i][c]).sum();
            assert!(
                area * (value + if name == "top" { 1e-9 } else { 0.0 } - [1.5, 0.0, -2.0][axis]) > 0.0,
                "{name}"
            );
        }
    }
    assert_eq!(mesh.faces["xmin"].len(), 16);
    assert_eq!(mesh.faces["base"].len(), 20);
}

#[test]
fn distortion_keeps_the_volume_and_moves_interior_nodes() {
    let (plain, moved) = (distorted(0.0, false).mesh().unwrap(), distorted(0.16, false).mesh().unwrap());
    // Outer nodes move within their planes only, so the outline and with it the volume stay.
    let volume = quality::summary(&moved).volume;
    assert!((volume - 24.0).abs() < 1e-12 * 24.0, "{volume}");
    let shifts = plain.nodes.iter().zip(&moved.nodes).map(|(a, b)| (a[2] - b[2]).abs());
    let largest = shifts.fold(0.0, f64::max);
    assert!(largest > 0.12 && largest <= 0.16, "{largest}");
    assert!(quality::summary(&moved).min_scaled_jacobian < 0.95);
}

#[test]
fn periodic_faces_match_node_by_node() {
    let mesh = distorted(0.15, true).mesh().unwrap();
    for (low, high, axis) in [("xmin", "xmax", 0), ("ymin", "ymax", 1)] {
        for (a, b) in plane(&mesh, low).iter().zip(plane(&mesh, high)) {
            assert!((0..3).all(|i| i == axis || a[i] == b[i]), "{a:?} {b:?}");
        }
    }
    let free = distorted(0.15, false).mesh().unwrap();
    assert!(plane(&free, "xmin").iter().zip(plane(&free, "xmax")).any(|(a, b)| a[1] != b[1]));
}

#[test]
fn the_same_seed_gives_the_same_mesh() {
    assert_eq!(distorted(0.15, true).mesh(), distorted(0.15, true).mesh());
}

#[test]
fn impossible_boxes_are_refused() {
    let with = |x: Axis| BoxSpec { x, ..BoxSpec::uniform([0.0; 3], [1.0; 3], [1; 3]) }.mesh().unwrap_err();
    assert!(matches!(with(Axis::Coordinates(vec![])), BoxError::Empty { axis: 'x' }));
    assert!(matches!(with(Axis::uniform(0.0, 1.0, 0)), BoxError::Empty { axis: 'x' }));
    assert!(matches!(with(Axis::uniform(1.0, 0.0, 4)), BoxError::NotRising { .. }));
    assert!(matches!(
        with(Axis::Coordinates(vec![0.0, f64::NAN, 1.0])),
        BoxError::NotRising { index: 1, .. }
    ));
    assert!(matches!(
        with(Axis::Graded { from: 0.0, to: 1.0, elements: 3, ratio: -2.0 }),
        BoxError::Ratio { .. }
    ));
    assert!(matches!(with(Axis::uniform(0.0, 1.0, u32::MAX)), BoxError::TooMany { .. }));
    // 2^2000 cannot be told apart from infinity: the first elements would have no length.
    assert!(matches!(
        with(Axis::Graded { from: 0.0, to: 1.0, elements: 2000, ratio: 2.0 }),
        BoxError::NotRising { .. }
    ));
    assert!(matches!(distorted(0.9, false).mesh(), Err(BoxError::Distortion { .. })));
    assert!(matches!(distorted(f64::NAN, false).mesh(), Err(BoxError::Distortion { .. })));
}
