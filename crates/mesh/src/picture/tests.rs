use super::*;
use crate::boxes::{Axis, BoxSpec};
use crate::cavern::CavernSpec;
use crate::{Element, Shape};

fn brick(elements: [u32; 3]) -> Mesh {
    let [x, y, z] =
        elements.map(|elements| Axis::Graded { from: 0.0, to: f64::from(elements), elements, ratio: 1.0 });
    BoxSpec { x, y, z, distortion: None }.mesh().unwrap()
}

fn area(polygon: &[[f64; 2]]) -> f64 {
    let next = polygon.iter().cycle().skip(1);
    0.5 * polygon.iter().zip(next).map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>()
}

#[test]
fn a_section_covers_the_block_once_wherever_it_is_cut() {
    let mesh = brick([3, 4, 2]);
    for y in [0.3, 1.0, 2.5, 4.0] {
        let pieces = cut::pieces(&mesh, y);
        assert_eq!(pieces.len(), 6, "{y}");
        assert!(pieces.iter().all(|(_, p)| (area(p) - 1.0).abs() < 1e-12), "{y}");
    }
    assert!(cut::pieces(&mesh, 4.1).is_empty() && cut::pieces(&mesh, f64::NAN).is_empty());
}

#[test]
fn a_section_through_a_tetrahedron_is_the_similar_triangle() {
    let nodes = vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let elements = vec![Element::new(Shape::Tet4, &[0, 1, 2, 3])];
    let mesh = Mesh { nodes, elements, ..Mesh::default() };
    let pieces = cut::pieces(&mesh, 0.25);
    assert!((area(&pieces[0].1) - 0.5 * 0.75 * 0.75).abs() < 1e-12);
}

#[test]
fn a_view_of_a_brick_shows_three_of_its_sides() {
    let svg = view(&brick([3, 4, 2]), None);
    assert_eq!(svg.matches("<polygon").count(), 3 * 2 + 4 * 2 + 3 * 4);
    let svg = view(&brick([3, 4, 2]), Some(&[0]));
    assert_eq!(svg.matches("<polygon").count(), 3);
}

#[test]
fn parts_are_coloured_and_not_their_unions() {
    let mesh = CavernSpec::yingxiuwan().mesh().unwrap();
    let window = window_of(&mesh, 2.0, |g| g.ends_with(".lining")).unwrap();
    // Outside of the linings: x from −9 to 37.1.
    assert!((window[0][0] + 11.0).abs() < 1e-9 && (window[1][0] - 39.1).abs() < 1e-9, "{window:?}");
    let svg = section(&mesh, 0.0, Some(window));
    for part in ["rock", "powerhouse.lining.crown", "transformer.bench4"] {
        assert!(svg.contains(&format!(">{part} — {}<", mesh.groups[part].len())), "{part}");
    }
    assert!(!svg.contains(">powerhouse.lining —"));
    roxmltree::Document::parse(&svg).unwrap();
}

#[test]
fn hostile_meshes_give_a_picture_that_is_still_xml() {
    let mut mesh = brick([1, 1, 1]);
    mesh.groups = [("<a&\u{1}\"".to_owned(), vec![0])].into();
    let mut broken = mesh.clone();
    broken.nodes[0] = [f64::NAN, f64::INFINITY, 1e300];
    for mesh in [mesh, broken, Mesh::default()] {
        for svg in [section(&mesh, 0.5, None), section(&mesh, f64::NAN, None), view(&mesh, None)] {
            roxmltree::Document::parse(&svg).unwrap();
            assert!(!svg.contains("NaN,") && !svg.contains("inf,"));
        }
    }
}
