//! One grid gives many cuts, smooth fields that stay sharp between bodies, and the outside of a lining.

use tremolite_mesh::vtu::{Array, Grid, Values};
use tremolite_mesh::{Element, Mesh, Shape};
use tremolite_results::{Cut, Fields};

/// Bricks between lines along x, y and z, but for those that `keep` leaves out; with the middle of each.
fn bricks(lines: [&[f64]; 3], keep: impl Fn([f64; 3]) -> bool) -> (Grid, Vec<[f64; 3]>) {
    let [x, y, z] = lines;
    let mut mesh = Mesh::default();
    let id = |i: usize, j: usize, k: usize| (i + x.len() * (j + y.len() * k)) as u32;
    for z in z {
        for y in y {
            mesh.nodes.extend(x.iter().map(|x| [*x, *y, *z]));
        }
    }
    let mut middles = Vec::new();
    for k in 0..z.len() - 1 {
        for j in 0..y.len() - 1 {
            for i in 0..x.len() - 1 {
                let middle = [0.5 * (x[i] + x[i + 1]), 0.5 * (y[j] + y[j + 1]), 0.5 * (z[k] + z[k + 1])];
                if keep(middle) {
                    let face = |k| [id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k)];
                    mesh.elements.push(Element::new(Shape::Hex8, &[face(k), face(k + 1)].concat()));
                    middles.push(middle);
                }
            }
        }
    }
    (Grid::from_mesh(&mesh, None).0, middles)
}

#[test]
fn a_plane_that_is_cut_once_shows_every_field_as_if_cut_for_it() {
    let (mut grid, middles) = bricks([&[0.0, 1.0, 3.0], &[0.0, 1.0, 2.0], &[0.0, 2.0, 3.0]], |_| true);
    let values = |i: usize| Values::Float64(middles.iter().map(|m| m[i]).collect());
    grid.cell_data.push(Array::new("s1", "Pa", 1, values(0)));
    grid.cell_data.push(Array::new("s3", "Pa", 1, values(2)));
    let fields = Fields::of(grid.clone());
    let slice = fields.slice(Some(0.5));
    for name in ["s1", "s3"] {
        assert_eq!(fields.cut(&slice, &[name]), Cut::of(&grid, Some(0.5), &[name]));
    }
    assert_eq!(fields.cut(&slice, &["s2"]), None);
}

#[test]
fn smoothing_keeps_a_linear_field_inside_and_the_jump_between_bodies() {
    let lines = [0.0, 1.0, 2.0, 3.0, 4.0];
    let (mut grid, middles) = bricks([&lines, &[0.0, 1.0, 2.0], &lines], |_| true);
    let linear = middles.iter().map(|m| 3.0 * m[0] - m[2]).collect();
    let body: Vec<i32> = middles.iter().map(|m| i32::from(m[0] > 2.0)).collect();
    let jump = body.iter().map(|b| f64::from(4 * b + 1)).collect();
    grid.cell_data.push(Array::new("linear", "", 1, Values::Float64(linear)));
    grid.cell_data.push(Array::new("jump", "", 1, Values::Float64(jump)));
    let whole = Fields::of(grid.clone());
    let slice = whole.slice(None);
    let smooth = whole.smooth(&slice, "linear").unwrap();
    let mut inside = 0;
    for (piece, values) in slice.pieces.iter().zip(&smooth) {
        for (corner, value) in piece.corners.iter().zip(values) {
            let [x, z] = corner.at;
            if x > 0.5 && x < 3.5 && z > 0.5 && z < 3.5 {
                assert!((value - (3.0 * x - z)).abs() < 1e-12, "{x} {z} {value}");
                inside += 1;
            }
        }
    }
    assert_eq!(inside, 36);

    grid.cell_data.push(Array::new("body", "", 1, Values::Int32(body)));
    let parted = Fields::of(grid);
    let slice = parted.slice(None);
    for (piece, values) in slice.pieces.iter().zip(parted.smooth(&slice, "jump").unwrap()) {
        let own = if piece.group == 1 { 5.0 } else { 1.0 };
        assert!(values.iter().all(|value| *value == own), "{values:?}");
    }
}

#[test]
fn vectors_are_interpolated_where_the_plane_meets_the_mesh() {
    let (mut grid, _) = bricks([&[0.0, 2.0], &[0.0, 3.0], &[0.0, 2.0]], |_| true);
    let vectors = grid.points.iter().flat_map(|p| [p[0] + p[1], p[1], p[2] - 2.0 * p[1]]).collect();
    grid.point_data.push(Array::new("displacement", "m", 3, Values::Float64(vectors)));
    let fields = Fields::of(grid);
    let slice = fields.slice(Some(1.2));
    let vectors = fields.vectors(&slice, "displacement").unwrap();
    for (corner, u) in slice.pieces[0].corners.iter().zip(&vectors[0]) {
        let expected = [corner.at[0] + 1.2, 1.2, corner.at[1] - 2.4];
        assert!((0..3).all(|i| (u[i] - expected[i]).abs() < 1e-5), "{u:?} {expected:?}");
    }
    assert_eq!(fields.vectors(&slice, "velocity"), None);
}

#[test]
fn the_skin_of_a_lining_is_what_lies_on_rock_with_all_that_is_behind_it() {
    // A lining of two layers on the floor of a trench between rock; nothing above it.
    let keep = |m: [f64; 3]| !(m[0] > 1.0 && m[0] < 4.0 && m[2] > 2.0);
    let (grid, middles) =
        bricks([&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0], &[0.0, 1.0], &[0.0, 1.0, 1.5, 2.0, 3.0]], keep);
    let inside: Vec<bool> =
        middles.iter().map(|m| m[0] > 1.0 && m[0] < 4.0 && m[2] > 1.0 && m[2] < 2.0).collect();
    let skin = Fields::of(grid).skin(&inside);
    // Three below, and two on either side, which do not come into the open.
    assert_eq!(skin.faces.len(), 7);
    let below: Vec<usize> = (0..7).filter(|&k| skin.normals[4 * k][2] < -0.99).collect();
    assert_eq!(below.len(), 3);
    for (k, behind) in skin.behind.iter().enumerate() {
        assert_eq!(behind.len(), if below.contains(&k) { 2 } else { 1 });
        assert!(behind.iter().all(|&cell| inside[cell]));
    }
    for &k in &below {
        let [outer, inner] = [0, 1].map(|i| middles[skin.behind[k][i]]);
        assert!(outer[0] == inner[0] && outer[2] < inner[2]);
    }
    let sideways = (0..7).filter(|k| !below.contains(k));
    assert!(sideways.clone().all(|k| skin.normals[4 * k][0].abs() > 0.99));
    assert_eq!(sideways.filter(|&k| skin.normals[4 * k][0] < 0.0).count(), 2);
}
