use super::*;
use crate::placement::Placement;
use crate::sample::{distorted_box, elements_where, grid};

/// A box of 20 × 12 × 6 m in cubes of 2 m, far from the origin, after its nodes were moved and all was turned by so many
/// degrees.
fn turned(degrees: f64, shape: impl Fn([f64; 3]) -> [f64; 3]) -> Mesh {
    let mut mesh = grid([10, 6, 3]);
    for x in &mut mesh.nodes {
        *x = shape([2.0 * x[0] + 300.0, 2.0 * x[1] - 800.0, 2.0 * x[2]]);
    }
    Placement { rotation: degrees.to_radians(), ..Placement::AS_IT_IS }.apply(&mut mesh);
    mesh
}

fn same(x: [f64; 3]) -> [f64; 3] {
    x
}

#[test]
fn a_turned_box_has_the_angle_it_was_turned_by_within_a_right_angle() {
    for (by, found) in
        [(0.0, 0.0), (20.0, 20.0), (-37.0, -37.0), (45.0, 45.0), (-45.0, 45.0), (70.0, -20.0), (180.0, 0.0)]
    {
        let sides = sides(&turned(by, same)).unwrap();
        assert!((sides.angle.to_degrees() - found).abs() < 1e-10, "{by}: {sides:?}");
        assert!(sides.off.iter().all(|off| *off < 1e-13), "{by}: {sides:?}");
        let straight = sides.off_axes.iter().all(|off| *off < 1e-13);
        assert_eq!(straight, found == 0.0, "{by}: {sides:?}");
    }
}

/// The tolerance of boundaries, 10⁻⁶ of the width, would allow for a thousand times more.
#[test]
fn a_box_turned_back_by_the_angle_found_lies_on_the_axes_to_a_billionth_of_its_size() {
    for by in [20.0, -37.0, 45.0, 12.345_678] {
        let mut mesh = turned(by, same);
        let angle = sides(&mesh).unwrap().angle;
        Placement { rotation: -angle, ..Placement::AS_IT_IS }.apply(&mut mesh);
        let back = sides(&mesh).unwrap();
        assert!(back.off_axes.iter().all(|off| *off < 1e-9), "{by}: {back:?}");
    }
}

#[test]
fn a_ground_that_is_not_level_and_an_opening_through_a_side_change_nothing() {
    let mut mesh = turned(20.0, |[x, y, z]| [x, y, z * (1.0 + 0.02 * (x - 300.0))]);
    let angle = sides(&mesh).unwrap().angle;
    assert!((angle.to_degrees() - 20.0).abs() < 1e-10);
    // A tunnel along the box's own y axis, in the middle of its height.
    let tunnel =
        elements_where(&grid([10, 6, 3]), |[x, _, z]| (4.0..6.0).contains(&x) && (1.0..2.0).contains(&z));
    assert_eq!(tunnel.len(), 12);
    let mut e = 0..;
    mesh.elements.retain(|_| e.next().is_some_and(|e| !tunnel.contains(&e)));
    let sides = sides(&mesh).unwrap();
    assert!((sides.angle.to_degrees() - 20.0).abs() < 1e-10, "{sides:?}");
    assert!(sides.off.iter().all(|off| *off < 1e-13), "{sides:?}");
}

/// Nodes as a file with six digits has them: the angle is right, and how far they are off is told.
#[test]
fn sides_that_are_rounded_are_found_and_what_they_are_off_is_told() {
    let mut mesh = turned(20.0, same);
    for x in mesh.nodes.iter_mut().flatten() {
        *x = format!("{x:.5e}").parse().unwrap();
    }
    let sides = sides(&mesh).unwrap();
    // Half a unit of the last digit of 950 m is 5·10⁻⁴ m.
    assert!((sides.angle.to_degrees() - 20.0).abs() < 0.005, "{sides:?}");
    assert!(sides.off.iter().all(|off| (1e-6..2e-3 / 12.0).contains(off)), "{sides:?}");
}

#[test]
fn plans_that_are_no_rectangles_are_refused_at_an_edge_without_faces() {
    type Shape = fn([f64; 3]) -> [f64; 3];
    let wavy: Shape = |[x, y, z]| [x, y + if y < -799.0 { 0.3 * (x - 300.0).sin() } else { 0.0 }, z];
    let tilted: Shape = |[x, y, z]| [if x < 301.0 { x + 0.1 * z } else { x }, y, z];
    let parallelogram: Shape = |[x, y, z]| [x + 0.2 * (y + 800.0), y, z];
    let trapezoid: Shape = |[x, y, z]| [310.0 + (x - 310.0) * (1.0 + 0.01 * (y + 800.0)), y, z];
    for (name, shape) in
        [("wavy", wavy), ("tilted", tilted), ("parallelogram", parallelogram), ("trapezoid", trapezoid)]
    {
        for by in [0.0, 20.0] {
            let error = sides(&turned(by, shape)).expect_err(name);
            assert!(error.covered < 0.9, "{name}, {by}: {error}");
            assert!(error.to_string().contains("two pairs of parallel vertical planes"), "{error}");
        }
    }
    let mut corner = turned(20.0, same);
    let cut = elements_where(&grid([10, 6, 3]), |[x, y, _]| x > 7.0 && y > 4.0);
    let mut e = 0..;
    corner.elements.retain(|_| e.next().is_some_and(|e| !cut.contains(&e)));
    let kept: Vec<u32> = corner.elements.iter().flat_map(|e| e.nodes().to_vec()).collect();
    let other = corner.elements[0].nodes()[0] as usize;
    for n in 0..corner.nodes.len() {
        if !kept.contains(&(n as u32)) {
            corner.nodes[n] = corner.nodes[other];
        }
    }
    assert!(sides(&corner).unwrap_err().covered < 0.8);
}

/// A plan with eight sides, four of them along the axes.
#[test]
fn an_octagon_is_refused() {
    let mesh = turned(0.0, |[x, y, z]| {
        let (u, v) = ((x - 310.0) / 10.0, (y + 794.0) / 6.0);
        let most = u.abs().max(v.abs());
        let shrink = if u.abs() + v.abs() > 1.5 * most { 1.5 * most / (u.abs() + v.abs()) } else { 1.0 };
        [10.0 * u * shrink, 10.0 * v * shrink, z]
    });
    let error = sides(&mesh).unwrap_err();
    assert!(error.covered < 0.6, "{error}");
}

#[test]
fn inner_nodes_do_not_count_and_a_small_tilt_is_told_by_how_far_it_is_off() {
    let unit = sides(&distorted_box(5)).unwrap();
    assert_eq!((unit.off, unit.off_axes), ([0.0; 2], [0.0; 2]));
    let tilted = sides(&turned(-37.0, |[x, y, z]| [if x > 319.0 { x + 1e-4 * z } else { x }, y, z])).unwrap();
    // 6·10⁻⁴ m of 20 m; the other sides are plane, but for the angle that this takes the mean by.
    assert!((tilted.off[0] / 3e-5 - 1.0).abs() < 0.1 && tilted.off[1] < 1e-5, "{tilted:?}");
}
