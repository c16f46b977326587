//! What has no flow is said so.

use crate::common::{even, grid};
use tremolite_seepage::{Holds, SeepageError};

#[test]
fn ground_without_a_way_for_water() {
    let mut made = grid(&even(0.0, 4.0, 4), &even(0.0, 1.0, 1), &even(0.0, 4.0, 4));
    // The column 1 to 2 m is taken out: what is left of it touches the head, what is right does not.
    let kept: Vec<[u32; 8]> = (0..16).filter(|e| e % 4 != 1).map(|e| made.elements[e]).collect();
    made.elements = kept;
    made.conductivity.truncate(12);
    let left = made.place("left", Holds::Head(3.0), |x| x[0] == 0.0);
    let apart = made.solve(std::slice::from_ref(&left));
    assert_eq!(apart, Err(SeepageError::Apart(1)));
    // Open at a wall, all its water has left.
    let right = made.place("right", Holds::Open(None), |x| x[0] == 4.0);
    let flow = made.solve(&[left, right]).unwrap();
    for (x, h) in made.nodes.iter().zip(&flow.heads) {
        assert_eq!(*h, if x[0] <= 1.0 { 3.0 } else { x[2] });
    }
    assert_eq!(flow.outflows[1], 0.0);
}

#[test]
fn numbers_that_cannot_be() {
    let mut made = grid(&[0.0, 1.0], &[0.0, 1.0], &[0.0, 1.0]);
    let left = [made.place("left", Holds::Head(3.0), |x| x[0] == 0.0)];
    made.conductivity[0] = 0.0;
    assert!(matches!(made.solve(&left), Err(SeepageError::Input(_))));
    made.conductivity[0] = 1.0;
    made.elements[0].swap(0, 4);
    assert_eq!(made.solve(&left), Err(SeepageError::Shape(0)));
}
