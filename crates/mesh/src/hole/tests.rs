use super::*;
use crate::boxes::BoxSpec;
use crate::places::middle as middle_of;
use crate::topology::plane_faces;
use std::f64::consts::PI;

/// What is left of a mesh without the elements that a place holds, without the nodes that nothing has any more.
fn without(mesh: &Mesh, hole: &Place) -> Mesh {
    let kept: Vec<usize> =
        (0..mesh.elements.len()).filter(|&e| !hole.holds(middle_of(mesh, e as u32))).collect();
    let mut number: BTreeMap<u32, u32> = BTreeMap::new();
    let mut left = Mesh::default();
    for e in kept {
        let element = mesh.elements[e];
        let nodes: Vec<u32> = element
            .nodes()
            .iter()
            .map(|&n| {
                *number.entry(n).or_insert_with(|| {
                    left.nodes.push(mesh.nodes[n as usize]);
                    left.nodes.len() as u32 - 1
                })
            })
            .collect();
        left.elements.push(Element::new(element.shape, &nodes));
    }
    left.groups.insert("rock".into(), (0..left.elements.len() as u32).collect());
    left
}

/// A block of 12 × 8 × 10 m in bricks of 1 m, its middle the origin.
fn block() -> Mesh {
    BoxSpec::uniform([-6.0, -4.0, -5.0], [6.0, 4.0, 5.0], [12, 8, 10])
        .mesh()
        .unwrap_or_else(|e| panic!("{e}"))
}

/// Each brick as six tetrahedra round its longest diagonal, so that neighbours fit.
fn tetrahedra(mesh: &Mesh) -> Mesh {
    let mut parted = Mesh { nodes: mesh.nodes.clone(), ..Mesh::default() };
    for element in &mesh.elements {
        let n = element.nodes;
        for [a, b] in [[1, 2], [2, 3], [3, 7], [7, 4], [4, 5], [5, 1]] {
            parted.elements.push(Element::new(Shape::Tet4, &[n[0], n[a], n[b], n[6]]));
        }
    }
    parted
}

fn through() -> Place {
    Place::Box([[-3.0, -4.0, -2.0], [2.0, 4.0, 2.0]])
}

fn lining(thickness: f64, layers: usize) -> HoleLining {
    HoleLining { name: "lining".into(), place: None, thickness, layers }
}

fn cast_volume(mesh: &mut Mesh, what: &HoleLining) -> f64 {
    cast(mesh, what).unwrap_or_else(|e| panic!("{e}")).volume
}

#[test]
fn round_a_rectangle_and_in_a_closed_box_the_lining_has_its_thickness_everywhere() {
    let chamber = Place::Box([[-3.0, -2.0, -2.0], [2.0, 2.0, 2.0]]);
    for (t, layers) in [(0.3, 1), (0.6, 2), (0.9, 3)] {
        // Wedges as thick as their faces are wide would be too poor in the corners.
        for parted in [false, true].into_iter().take(if t < 0.5 { 2 } else { 1 }) {
            for (hole, deep) in [(&through(), None), (&chamber, Some(4.0 - 2.0 * t))] {
                let bricks = without(&block(), hole);
                let mut mesh = if parted { tetrahedra(&bricks) } else { bricks };
                let before = mesh.clone();
                let volume = cast_volume(&mut mesh, &lining(t, layers));
                let whole = if deep.is_some() { 5.0 * 4.0 * 4.0 } else { 5.0 * 4.0 * 8.0 };
                let left = (5.0 - 2.0 * t) * (4.0 - 2.0 * t) * deep.unwrap_or(8.0);
                assert!((volume - (whole - left)).abs() < 1e-9 * whole, "{volume} {whole} {left}");
                assert_eq!(mesh.nodes[..before.nodes.len()], before.nodes);
                assert_eq!(mesh.elements[..before.elements.len()], before.elements);
                // It fills up to what is left, and hangs together with the rock: its outer faces are none of the hole's any more.
                let all: f64 = (0..mesh.elements.len()).map(|e| quality::of(&mesh, e).volume).sum();
                assert!((all - (960.0 - left)).abs() < 1e-9 * all);
                let sides = plane_faces(&mesh, 1e-9);
                let outer: usize = sides.values().map(Vec::len).sum();
                assert_eq!(exterior_faces(&mesh, None).len(), outer + walls(&before).len());
            }
        }
    }
}

/// A round tunnel along y in a block, of `n` bricks round; its circle's radius is 3 m.
fn round(n: usize) -> Mesh {
    let mut mesh = Mesh::default();
    let slices = 3;
    for k in 0..=slices {
        for i in 0..n {
            let a = 2.0 * PI * i as f64 / n as f64;
            // On a square outside, whose corners are nodes, so that the sides are planes.
            let far = 8.0 / a.sin().abs().max(a.cos().abs());
            for r in [3.0, far] {
                mesh.nodes.push([r * a.cos(), 2.0 * k as f64, r * a.sin()]);
            }
        }
    }
    for k in 0..slices {
        for i in 0..n {
            let node = |k: usize, i: usize, r: usize| (2 * (k * n + i % n) + r) as u32;
            let ring = |k: usize| [node(k, i, 0), node(k, i + 1, 0), node(k, i + 1, 1), node(k, i, 1)];
            mesh.elements.push(Element::new(Shape::Hex8, &[ring(k), ring(k + 1)].concat()));
        }
    }
    let inside_out = quality::of(&mesh, 0).volume < 0.0;
    for element in mesh.elements.iter_mut().filter(|_| inside_out) {
        let n = element.nodes;
        element.nodes = [n[4], n[5], n[6], n[7], n[0], n[1], n[2], n[3]];
    }
    mesh.groups.insert("rock".into(), (0..mesh.elements.len() as u32).collect());
    mesh
}

#[test]
fn round_a_tunnel_it_is_the_ring_of_a_polygon_and_goes_to_that_of_a_circle() {
    let (t, length) = (0.4, 6.0);
    let circle = PI * (9.0 - 2.6 * 2.6) * length;
    let mut last = f64::INFINITY;
    for n in [16, 32, 64] {
        let mut mesh = round(n);
        let volume = cast_volume(&mut mesh, &lining(t, 2));
        let half = PI / n as f64;
        let inner = 3.0 * half.cos();
        let ring = n as f64 * half.tan() * (inner * inner - (inner - t) * (inner - t)) * length;
        assert!((volume - ring).abs() < 1e-9 * ring);
        let error = (volume - circle).abs();
        assert!(last.is_infinite() || (3.8..4.2).contains(&(last / error)), "{last} {error}");
        last = error;
        // Its ends stay on the sides.
        let off = |&n: &u32| mesh.nodes[n as usize][1].min(length - mesh.nodes[n as usize][1]);
        let ends = mesh.groups["lining"].iter().flat_map(|&e| mesh.elements[e as usize].nodes());
        assert!(ends.filter(|n| off(n) < 1.0).all(|n| off(n).abs() < 1e-12));
    }
}

#[test]
fn a_second_lining_is_cast_against_the_first() {
    let mut mesh = without(&block(), &through());
    cast_volume(&mut mesh, &HoleLining { name: "shotcrete".into(), ..lining(0.2, 1) });
    let volume = cast_volume(&mut mesh, &lining(0.3, 1));
    assert!((volume - 8.0 * (4.6 * 3.6 - 4.0 * 3.0)).abs() < 1e-9);
    assert_eq!(mesh.groups.keys().collect::<Vec<_>>(), ["lining", "rock", "shotcrete"]);
}

#[test]
fn a_box_says_which_hole_and_a_shaft_needs_one() {
    // Two holes, and a shaft from the ground that ends in the rock.
    let two = without(
        &without(&block(), &Place::Box([[-5.0, -4.0, -2.0], [-3.0, 4.0, 1.0]])),
        &Place::Box([[1.0, -1.0, -1.0], [3.0, 1.0, 5.0]]),
    );
    let mut mesh = two.clone();
    let one = cast_volume(&mut mesh, &lining(0.25, 1));
    assert!((one - 8.0 * (2.0 * 3.0 - 1.5 * 2.5)).abs() < 1e-9, "the tunnel alone: {one}");
    let shaft = HoleLining {
        name: "shaft.lining".into(),
        place: Some(Place::Box([[1.0, -1.0, -1.0], [3.0, 1.0, 4.9]])),
        ..lining(0.25, 1)
    };
    let other = cast_volume(&mut mesh, &shaft);
    assert!((other - (2.0 * 2.0 * 6.0 - 1.5 * 1.5 * 5.75)).abs() < 1e-9, "{other}");
    assert_eq!(mesh.bounds().1[2], 5.0);
}

#[test]
fn mirrored_and_moved_it_is_the_same() {
    let mut mesh = without(&block(), &through());
    let volume = cast_volume(&mut mesh, &lining(0.7, 2));
    for axis in 0..3 {
        let mut other = without(&block(), &through());
        for x in &mut other.nodes {
            x[axis] = 1000.0 - x[axis];
        }
        for element in &mut other.elements {
            let n = element.nodes;
            element.nodes = [n[4], n[5], n[6], n[7], n[0], n[1], n[2], n[3]];
        }
        let again = cast_volume(&mut other, &lining(0.7, 2));
        assert!((again - volume).abs() < 1e-9 * volume, "{again} {volume}");
    }
}

#[test]
fn what_finds_no_room_or_no_wall_is_refused_and_changes_nothing() {
    let holed = without(&block(), &through());
    let named = HoleLining { name: "rock".into(), ..lining(0.3, 1) };
    let elsewhere = HoleLining { place: Some(Place::Box([[3.0; 3], [4.0; 3]])), ..lining(0.3, 1) };
    for (mesh, what, says) in [
        (holed.clone(), named, "has a group 'rock'"),
        (holed.clone(), elsewhere, "no face of a hole has its middle in the box"),
        (block(), lining(0.3, 1), "has no hole"),
        (holed.clone(), lining(0.0, 1), "no thickness"),
        (holed.clone(), lining(0.3, 0), "no layer"),
        (holed.clone(), lining(1.9, 1), "scaled Jacobian"),
        (holed, lining(2.0, 1), "scaled Jacobian"),
        (round(32), lining(3.2, 1), "scaled Jacobian"),
        (thin_gap(), lining(0.7, 1), "would lie in other elements"),
    ] {
        let mut tried = mesh.clone();
        let text = cast(&mut tried, &what).expect_err(says).to_string();
        assert!(text.contains(says) && text.contains("; "), "{text}");
        assert!(tried == mesh, "{says}");
    }
}

/// A hole of 12 × 8 × 1 m, whose roof and floor are a metre apart and whose other walls are the block's sides.
fn thin_gap() -> Mesh {
    without(&block(), &Place::Box([[-6.0, -4.0, -1.0], [6.0, 4.0, 0.0]]))
}

/// A corner or an edge that is cut off, below or beside, is the block's outside and no hole; what is dug into its base is one.
#[test]
fn chamfers_and_steps_of_the_block_are_no_holes() {
    let chamfered = |mesh: &Mesh, axis: usize| {
        let mut mesh = mesh.clone();
        for x in &mut mesh.nodes {
            // The lower edge of the side at the highest x, or an upright one, by a slope of one to two.
            let off = 0.5 * if axis == 0 { -2.0 - x[2] } else { x[1] - 1.0 };
            x[0] -= off.max(0.0) * (x[0] - 2.0).max(0.0) / 4.0;
        }
        mesh
    };
    let stepped = without(&block(), &Place::Box([[4.0, -4.0, -5.0], [6.0, 4.0, -3.0]]));
    for solid in [chamfered(&block(), 0), chamfered(&block(), 1), stepped] {
        assert_eq!(walls(&solid), []);
        let refused = cast(&mut solid.clone(), &lining(0.3, 1)).map_err(|e| e.to_string());
        assert!(refused.as_ref().is_err_and(|e| e.contains("no hole") && e.contains("`box`")), "{refused:?}");
        // The tunnel beside it is lined as without.
        let mut mesh = without(&solid, &through());
        assert!((cast_volume(&mut mesh, &lining(0.3, 1)) - (5.0 * 4.0 - 4.4 * 3.4) * 8.0).abs() < 1e-9);
    }
    let dug = without(&block(), &Place::Box([[-1.0, -4.0, -5.0], [1.0, 4.0, -2.0]]));
    assert_eq!(walls(&dug).len(), 8 * (3 + 3 + 2));
}
