//! Lines of nodes that take water.

use crate::common::{Made, even, grid};
use tremolite_seepage::{Holds, Place};

/// Ground 40 × 10 × 30 m under a head of 20 m at its sides.
fn ground() -> (Made, Place) {
    let made = grid(&even(0.0, 40.0, 20), &even(0.0, 10.0, 3), &even(0.0, 30.0, 15));
    let sides = made.place("sides", Holds::Head(20.0), |x| x[0] == 0.0 || x[0] == 40.0);
    (made, sides)
}

fn line(made: &Made, z: f64) -> Place {
    let on = |n: &u32| made.nodes[*n as usize][0] == 20.0 && made.nodes[*n as usize][2] == z;
    let nodes = (0..made.nodes.len() as u32).filter(on).map(|n| (n, 1.0)).collect();
    Place { name: "drain".into(), holds: Holds::Open(None), nodes }
}

#[test]
fn a_line_takes_what_comes() {
    let (made, sides) = ground();
    let drain = line(&made, 8.0);
    let flow = made.solve(&[sides, drain.clone()]).unwrap();
    assert!(flow.outflows[1] > 0.0 && flow.mass_error < 1e-6);
    assert!((flow.outflows[1] + flow.outflows[0]).abs() < 1e-6 * flow.inflow);
    for &(n, _) in &drain.nodes {
        assert!((flow.heads[n as usize] - 8.0).abs() < 1e-9, "p = 0 at the drain");
    }
    assert!(flow.heads.iter().all(|h| *h < 20.0 + 1e-9));
}

#[test]
fn a_line_above_the_free_surface_takes_none() {
    let (made, sides) = ground();
    let drain = line(&made, 26.0);
    let flow = made.solve(&[sides, drain]).unwrap();
    assert_eq!(flow.outflows[1], 0.0);
    assert!(flow.heads.iter().all(|h| (*h - 20.0).abs() < 1e-9));
}

/// Nothing comes in at a side above its head: there heads follow the ground.
#[test]
fn a_head_holds_up_to_itself() {
    let (made, sides) = ground();
    let drain = line(&made, 2.0);
    let flow = made.solve(&[sides, drain]).unwrap();
    let at = |z: f64| {
        let node = made.nodes.iter().position(|x| *x == [0.0, 0.0, z]);
        flow.heads[node.unwrap()]
    };
    assert!(at(20.0) == 20.0 && at(0.0) == 20.0);
    assert!((20.0 - at(26.0)).abs() > 1e-3, "{}", at(26.0));
}

/// Of two walls with a common edge each is given its share of what leaves there, and no more in all.
#[test]
fn places_share_their_nodes() {
    let (made, sides) = ground();
    let whole = made.place("base", Holds::Open(None), |x| x[2] == 0.0);
    let of = |low: f64| {
        made.place("half", Holds::Open(None), move |x| x[2] == 0.0 && (low..=low + 20.0).contains(&x[0]))
    };
    let one = made.solve(&[sides.clone(), whole]).unwrap();
    let two = made.solve(&[sides, of(0.0), of(20.0)]).unwrap();
    assert_eq!(one.heads, two.heads);
    assert!((two.outflows[1] / two.outflows[2] - 1.0).abs() < 1e-6, "{:?}", two.outflows);
    assert!(((two.outflows[1] + two.outflows[2]) / one.outflows[1] - 1.0).abs() < 1e-12);
}
