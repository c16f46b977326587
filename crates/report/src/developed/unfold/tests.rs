use super::*;

type Shape = (Vec<[f64; 3]>, Vec<[f64; 3]>, Vec<Vec<u32>>);

/// A strip of plane facets through the points of a section (x, z), pulled along y in `rows` steps of a metre and a half.
/// Every facet has points of its own, as at sharp edges.
fn pulled(section: &[[f64; 2]], rows: u32) -> Shape {
    let mut shape: Shape = Default::default();
    for pair in section.windows(2) {
        for row in 0..rows {
            let [y, next] = [f64::from(row), f64::from(row + 1)].map(|r| 1.5 * r);
            let [[x0, z0], [x1, z1]] = [pair[0], pair[1]];
            quad(
                &mut shape,
                [[x0, y, z0], [x1, y, z1], [x1, next, z1], [x0, next, z0]],
                [z1 - z0, 0.0, x0 - x1],
            );
        }
    }
    shape
}

fn quad(shape: &mut Shape, corners: [[f64; 3]; 4], out: [f64; 3]) {
    let first = shape.0.len() as u32;
    shape.0.extend(corners);
    shape.1.extend([unit(out).unwrap(); 4]);
    shape.2.push((first..first + 4).collect());
}

/// A closed ring of points, against the clock in (x, z) so that normals point out.
fn ring(number: u32, radius: f64) -> Vec<[f64; 2]> {
    let angle = |k: u32| f64::from(k % number) * std::f64::consts::TAU / f64::from(number) + 0.25;
    (0..=number).map(|k| [radius * angle(k).cos(), radius * angle(k).sin()]).collect()
}

/// The section of a tube 4 m wide and 6 m high, of facets of a metre, normals out.
fn tube() -> Vec<[f64; 2]> {
    let corners: [[f64; 2]; 5] = [[0.0, 0.0], [4.0, 0.0], [4.0, 6.0], [0.0, 6.0], [0.0, 0.0]];
    let mut section = vec![corners[0]];
    for pair in corners.windows(2) {
        let [a, b] = [pair[0], pair[1]];
        let steps: f64 = (b[0] - a[0]).abs().max((b[1] - a[1]).abs());
        section
            .extend((1..=steps as u32).map(|k| [0, 1].map(|i| a[i] + f64::from(k) / steps * (b[i] - a[i]))));
    }
    section
}

fn develop(shape: &Shape) -> Vec<Sheet> {
    let sheets = unfold(&shape.0, &shape.1, &shape.2);
    let flat: usize = sheets.iter().map(|sheet| sheet.faces.len()).sum();
    assert_eq!(flat, shape.2.len(), "every face lies somewhere");
    for face in sheets.iter().flat_map(|sheet| &sheet.faces) {
        // A plane face keeps all its lengths, diagonals included.
        for i in 0..face.corners.len() {
            for j in 0..i {
                let there = length(less(shape.0[face.points[i] as usize], shape.0[face.points[j] as usize]));
                let [a, b] = [face.corners[i], face.corners[j]];
                let here = (a[0] - b[0]).hypot(a[1] - b[1]);
                assert!((there - here).abs() < 1e-12 * 50.0, "{there} {here}");
            }
        }
    }
    sheets
}

/// Extent along u and v.
fn extent(sheet: &Sheet) -> [f64; 2] {
    let all = || sheet.faces.iter().flat_map(|face| &face.corners);
    [0, 1].map(|i| {
        let c = || all().map(|corner| corner[i]);
        c().fold(f64::NEG_INFINITY, f64::max) - c().fold(f64::INFINITY, f64::min)
    })
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

#[test]
fn a_square_tube_opens_along_the_middle_of_its_floor() {
    let section = tube();
    let sheets = develop(&pulled(&section, 5));
    let [sheet] = &sheets[..] else { panic!("one sheet") };
    assert_eq!((sheet.axis, sheet.wraps, sheet.pieces), ([0.0, 1.0, 0.0], true, 1));
    let [along, around] = extent(sheet);
    assert!(close(along, 7.5) && close(around, 20.0), "{along} {around}");
    let v = |face: &Flat| face.corners.iter().map(|c| c[1]).sum::<f64>() / 4.0;
    for face in &sheet.faces {
        let [x, _, z] = face.normal;
        match v(face).abs() {
            far if far < 2.0 => assert!(z > 0.9, "the crown lies in the middle"),
            far if far < 8.0 => {
                assert!(x * -v(face).signum() > 0.9, "the right wall on the side of negative v")
            }
            _ => assert!(z < -0.9, "the floor outside"),
        }
    }
    // Two creases beside the crown, two above the floor; two ends and two sides of the cut.
    let total =
        |lines: &[[[f64; 2]; 2]]| lines.iter().map(|[a, b]| (a[0] - b[0]).hypot(a[1] - b[1])).sum::<f64>();
    assert!(close(total(&sheet.creases), 4.0 * 7.5), "{}", total(&sheet.creases));
    assert!(close(total(&sheet.outline), 2.0 * 20.0 + 2.0 * 7.5), "{}", total(&sheet.outline));
}

#[test]
fn a_cylinder_becomes_a_rectangle_as_long_as_its_facets_together() {
    let section = ring(24, 3.0);
    let sheets = develop(&pulled(&section, 4));
    let [sheet] = &sheets[..] else { panic!("one sheet") };
    let [along, around] = extent(sheet);
    let chord = 6.0 * (std::f64::consts::PI / 24.0).sin();
    assert!(close(along, 6.0) && close(around, 24.0 * chord), "{along} {around}");
    assert!(sheet.creases.is_empty(), "15° are no crease");
    // Cut once: at the lowest facets.
    let outermost = sheet.faces.iter().filter(|f| f.corners.iter().any(|c| c[1].abs() > 11.0 * chord));
    assert!(outermost.into_iter().all(|face| face.normal[2] < -0.9));
}

#[test]
fn an_end_wall_hangs_on_the_crown_as_the_flap_of_a_box() {
    let section = tube();
    let mut shape = pulled(&section, 5);
    for i in 0..4 {
        for j in 0..6 {
            let ([x, z], y) = ([f64::from(i), f64::from(j)], 7.5);
            quad(
                &mut shape,
                [[x, y, z], [x + 1.0, y, z], [x + 1.0, y, z + 1.0], [x, y, z + 1.0]],
                [0.0, 1.0, 0.0],
            );
        }
    }
    let sheets = develop(&shape);
    let [sheet] = &sheets[..] else { panic!("one sheet") };
    assert_eq!(sheet.pieces, 1);
    let [along, around] = extent(sheet);
    assert!(close(along, 7.5 + 6.0) && close(around, 20.0), "{along} {around}");
    for face in sheet.faces.iter().filter(|face| face.end) {
        assert!(
            face.corners.iter().all(|c| c[0] > 7.5 - 1e-9 && c[1].abs() < 2.0 + 1e-9),
            "{:?}",
            face.corners
        );
    }
}

#[test]
fn surfaces_that_do_not_touch_are_sheets_of_their_own() {
    let section = ring(12, 2.0);
    let mut shape = pulled(&section, 2);
    let number = shape.0.len() as u32;
    let (points, normals, faces) = pulled(&section, 3);
    shape.0.extend(points.iter().map(|p| [p[0] + 20.0, p[1], p[2]]));
    shape.1.extend(normals);
    shape.2.extend(faces.iter().map(|face| face.iter().map(|p| p + number).collect::<Vec<_>>()));
    let sheets = develop(&shape);
    assert_eq!(sheets.iter().map(|s| s.faces.len()).collect::<Vec<_>>(), [24, 36]);
}

#[test]
fn a_fault_lies_as_it_is_with_its_dip_upwards() {
    // 30 m along a strike of 30° from x, 20 m down a dip of 50°, of triangles.
    let strike = [30_f64.to_radians().cos(), 30_f64.to_radians().sin(), 0.0];
    let dip = 50_f64.to_radians();
    let down = [-strike[1] * dip.cos(), strike[0] * dip.cos(), -dip.sin()];
    let normal = cross(strike, down);
    let mut shape: Shape = Default::default();
    for i in 0..6 {
        for j in 0..4 {
            let at =
                |a: u32, b: u32| [0, 1, 2].map(|k| 5.0 * (f64::from(a) * strike[k] + f64::from(b) * down[k]));
            for corners in
                [[at(i, j), at(i + 1, j), at(i + 1, j + 1)], [at(i, j), at(i + 1, j + 1), at(i, j + 1)]]
            {
                let first = shape.0.len() as u32;
                shape.0.extend(corners);
                shape.1.extend([normal; 3]);
                shape.2.push((first..first + 3).collect());
            }
        }
    }
    let sheets = develop(&shape);
    let [sheet] = &sheets[..] else { panic!("one sheet") };
    assert!(!sheet.wraps && sheet.creases.is_empty() && sheet.pieces == 1);
    assert!(close(dot(sheet.axis, strike).abs(), 1.0));
    let [along, up] = extent(sheet);
    assert!(close(along, 30.0) && close(up, 20.0), "{along} {up}");
    for face in &sheet.faces {
        for (point, corner) in face.points.iter().zip(&face.corners) {
            let height = shape.0[*point as usize][2];
            let top = sheet.faces.iter().flat_map(|f| &f.corners).map(|c| c[1]).fold(f64::MIN, f64::max);
            assert!(close(height, (corner[1] - top) * dip.sin()), "{height} {corner:?}");
        }
    }
}

#[test]
fn warped_faces_keep_their_edges_and_collapsed_ones_are_left_out() {
    let points = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 1.0, 0.5], [0.0, 1.0, 0.0], [4.0, 0.0, 0.0]];
    let faces = [vec![0, 1, 2, 3], vec![1, 4, 2], vec![0, 1, 1, 0]];
    let sheets = unfold(&points, &[[0.0, 0.0, 1.0]; 5], &faces);
    let [sheet] = &sheets[..] else { panic!("one sheet") };
    assert_eq!(sheet.faces.len(), 2);
    for face in &sheet.faces {
        let n = face.corners.len();
        for k in 0..n {
            let ends = [k, (k + 1) % n];
            let [a, b] = ends.map(|i| points[face.points[i] as usize]);
            let [c, d] = ends.map(|i| face.corners[i]);
            assert!(close(length(less(a, b)), (c[0] - d[0]).hypot(c[1] - d[1])));
        }
    }
}

#[test]
fn what_would_lie_on_something_else_is_moved_apart() {
    // Five squares around a point make 450°: the fifth has no room beside the other four.
    let mut shape: Shape = Default::default();
    let points = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]];
    let cycle = [[0, 1], [1, 2], [2, 3], [3, 4], [4, 0]];
    for [a, b] in cycle {
        let (p, q): ([f64; 3], [f64; 3]) = (points[a], points[b]);
        let far = [0, 1, 2].map(|i| p[i] + q[i]);
        quad(&mut shape, [[0.0; 3], p, far, q], cross(p, q));
    }
    let sheets = develop(&shape);
    let [sheet] = &sheets[..] else { panic!("one sheet") };
    assert!(sheet.pieces == 2, "{}", sheet.pieces);
}
