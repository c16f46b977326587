//! What cannot be split.

use super::*;

fn refusal(mesh: &Mesh, cuts: &[Cut], there: &[bool]) -> SplitError {
    let times: Vec<Range<u32>> = there.iter().map(|there| 0..u32::from(*there)).collect();
    let mut copy = mesh.clone();
    let error = super::split(&mut copy, cuts, &times).expect_err("it is refused");
    assert_eq!(&copy, mesh, "unchanged on an error");
    error
}

#[test]
fn sides_without_elements_or_with_common_ones_are_refused() {
    let mut mesh = grid([4, 1, 1]);
    mesh.element_ids = vec![10, 20, 30, 40];
    let error = refusal(&mesh, &[cut("joint", &[0, 1], &[])], &all(&mesh));
    assert_eq!(error, SplitError::Empty { name: "joint".into(), side: 2 });
    let error = refusal(&mesh, &[cut("joint", &[0], &[1])], &[false, true, true, true]);
    assert_eq!(error, SplitError::Empty { name: "joint".into(), side: 1 });
    let error = refusal(&mesh, &[cut("joint", &[0, 1, 2], &[2, 3])], &all(&mesh));
    assert_eq!(error, SplitError::BothSides { name: "joint".into(), element: 30 });
}

#[test]
fn sides_apart_are_refused_with_their_distance() {
    let mesh = grid([4, 1, 1]);
    let error = refusal(&mesh, &[cut("joint", &[0], &[3])], &all(&mesh));
    assert_eq!(error, SplitError::Apart { name: "joint".into(), distance: 2.0 });
    // Along an edge only.
    let mesh = grid([2, 1, 2]);
    let error = refusal(&mesh, &[cut("joint", &[0], &[3])], &all(&mesh));
    assert_eq!(error, SplitError::Apart { name: "joint".into(), distance: 0.0 });
    assert!(
        error.to_string().starts_with("interface 'joint': its two sides have no face in common"),
        "{error}"
    );
}

#[test]
fn a_gap_above_the_tolerance_is_no_interface() {
    let mut mesh = grid([2, 1, 1]);
    super::split(&mut mesh, &[cut("joint", &[0], &[1])], &[0..1, 0..1]).expect("it splits");
    for x in &mut mesh.nodes[12..] {
        x[0] -= 2e-6;
    }
    let error = refusal(&mesh, &[cut("joint", &[0], &[1])], &[true; 2]);
    let SplitError::Apart { distance, .. } = error else { panic!("{error}") };
    assert!((distance - 2e-6).abs() < 1e-12);
}

#[test]
fn bodies_that_overlap_do_not_touch() {
    // The second cube lies on the first, with nodes of its own: the same places, but none looks at another.
    let mut mesh = grid([1, 1, 1]);
    mesh.nodes.extend_from_within(..);
    let twin = mesh.elements[0].nodes.map(|n| n + 8);
    mesh.elements.push(Element::new(Shape::Hex8, &twin));
    let error = refusal(&mesh, &[cut("joint", &[0], &[1])], &[true; 2]);
    assert!(matches!(error, SplitError::Apart { distance: 0.0, .. }), "{error}");
}

#[test]
fn a_face_on_two_interfaces_is_refused() {
    let mesh = grid([3, 1, 1]);
    let cuts = [cut("one", &[0], &[1]), cut("other", &[1, 2], &[0])];
    let error = refusal(&mesh, &cuts, &all(&mesh));
    let SplitError::Claimed { first, second, element } = error else { panic!("{error}") };
    assert_eq!((first.as_str(), second.as_str()), ("one", "other"));
    assert!(element == 1 || element == 2);
}

#[test]
fn elements_on_one_another_are_refused() {
    let mut mesh = grid([2, 1, 1]);
    mesh.elements.push(mesh.elements[1]);
    let error = refusal(&mesh, &[cut("joint", &[0], &[1, 2])], &all(&mesh));
    assert!(matches!(error, SplitError::Crowded { first: 2, second: 3, .. }), "{error}");
}
