//! A plane meets every element it crosses exactly once.

use tremolite_mesh::vtu::{Array, Grid, Values};
use tremolite_mesh::{Element, Mesh, Shape};
use tremolite_results::Cut;

/// A box of nx × ny × nz bricks from the origin, edges 1 m.
fn bricks(n: [usize; 3]) -> Mesh {
    let mut mesh = Mesh::default();
    let id = |i: usize, j: usize, k: usize| (i + (n[0] + 1) * (j + (n[1] + 1) * k)) as u32;
    for k in 0..=n[2] {
        for j in 0..=n[1] {
            for i in 0..=n[0] {
                mesh.nodes.push([i as f64, j as f64, k as f64]);
            }
        }
    }
    for k in 0..n[2] {
        for j in 0..n[1] {
            for i in 0..n[0] {
                let face = |k| [id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k)];
                mesh.elements.push(Element::new(Shape::Hex8, &[face(k), face(k + 1)].concat()));
            }
        }
    }
    mesh
}

fn area(outline: &[[f64; 2]]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    0.5 * outline.iter().zip(next).map(|(a, b)| a[0] * b[1] - a[1] * b[0]).sum::<f64>()
}

#[test]
fn the_cut_covers_the_section_once_even_where_the_plane_lies_in_faces() {
    let (mut grid, _) = Grid::from_mesh(&bricks([3, 4, 2]), None);
    let rows: Vec<f64> = (0..24).map(|e| f64::from(e / 3 % 4)).collect();
    grid.cell_data.push(Array::new("s1_max", "Pa", 1, Values::Float64(rows)));
    grid.cell_data.push(Array::new("group", "", 1, Values::Int32((0..24).collect())));
    // The middle, y = 2, is a plane of faces; so are both ends. Each belongs to one row of elements.
    for (y, row) in [(None, 2.0), (Some(0.0), 0.0), (Some(4.0), 3.0), (Some(99.0), 3.0), (Some(1.5), 1.0)] {
        let cut = Cut::of(&grid, y, &["s1_max"]).unwrap();
        assert_eq!(cut.cells.len(), 6, "{y:?}");
        assert!(cut.cells.iter().all(|cell| cell.value == row && cell.outline.len() == 4), "{y:?}");
        let total: f64 = cut.cells.iter().map(|cell| area(&cell.outline)).sum();
        assert!((total - 6.0).abs() < 1e-12, "{total}");
        assert_eq!((cut.unit.as_str(), cut.cells[0].group), ("Pa", 3 * row as i64));
    }
}

#[test]
fn wedges_pyramids_and_tetrahedra_are_cut_to_their_exact_areas() {
    // Each shape fits the unit cube; the plane y = 0.25 gives areas known by hand.
    let nodes = vec![
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 1.0],
        [1.0, 1.0, 1.0],
        [0.0, 1.0, 1.0],
    ];
    for (shape, corners, expected) in [
        // x + y + z ≤ 1: a triangle of legs 0.75.
        (Shape::Tet4, vec![0, 1, 3, 4], 0.5 * 0.75 * 0.75),
        // Base z = 0, apex (0, 0, 1): between z = 0 and z = 1 − y, x from 0 to 1 − z.
        (Shape::Pyramid5, vec![0, 1, 2, 3, 4], 0.75 - 0.5 * 0.75 * 0.75),
        // Triangle x + y ≤ 1, extruded in z: 0.75 by 1.
        (Shape::Wedge6, vec![0, 1, 3, 4, 5, 7], 0.75),
    ] {
        let mesh =
            Mesh { nodes: nodes.clone(), elements: vec![Element::new(shape, &corners)], ..Mesh::default() };
        let (mut grid, _) = Grid::from_mesh(&mesh, None);
        grid.cell_data.push(Array::new("s1_max", "Pa", 1, Values::Float32(vec![7.0])));
        let cut = Cut::of(&grid, Some(0.25), &["s1_max"]).unwrap();
        // The nudge moves the plane by 1e-6 m.
        assert!(
            (area(&cut.cells[0].outline) - expected).abs() < 2e-6,
            "{shape:?} {:?}",
            cut.cells[0].outline
        );
        assert_eq!(cut.cells[0].value, 7.0);
    }
}

#[test]
fn node_fields_are_averaged_vectors_measured_and_preference_kept() {
    let (mut grid, _) = Grid::from_mesh(&bricks([1, 1, 1]), None);
    let vectors = (0..8).flat_map(|_| [3.0, 0.0, 4.0]).collect();
    grid.point_data.push(Array::new("displacement", "m", 3, Values::Float64(vectors)));
    let ramp = (0..8).map(f64::from).collect();
    grid.point_data.push(Array::new("head", "m", 1, Values::Float64(ramp)));
    assert_eq!(Cut::of(&grid, None, &["s1_max", "displacement", "head"]).unwrap().cells[0].value, 5.0);
    assert_eq!(Cut::of(&grid, None, &["head"]).unwrap().cells[0].value, 3.5);
    assert_eq!(Cut::of(&grid, None, &["s1_max"]), None);
}

#[test]
fn a_grid_without_extent_or_with_broken_points_gives_no_cells_and_no_panic() {
    for fault in [f64::NAN, f64::INFINITY, 0.0] {
        let (mut grid, _) = Grid::from_mesh(&bricks([1, 1, 1]), None);
        grid.points.iter_mut().for_each(|point| point[1] = fault);
        grid.cell_data.push(Array::new("s1_max", "Pa", 1, Values::Float64(vec![1.0])));
        assert!(Cut::of(&grid, None, &["s1_max"]).unwrap().cells.is_empty());
    }
}
