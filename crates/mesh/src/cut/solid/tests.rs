use std::collections::{BTreeMap, BTreeSet};

use super::*;
use crate::boxes::BoxSpec;
use crate::cut::{Bounds, Cut, Done};
use crate::quality::{summary, summary_of};
use crate::topology::{all_faces, exterior_faces, face_key, plane_faces};
use crate::{Face, Shape};

/// A block of 16 × 16 × 14 m in bricks of 2 m.
fn block() -> Mesh {
    let spec = BoxSpec::uniform([-8.0, -8.0, -14.0], [8.0, 8.0, 0.0], [8, 8, 7]);
    let mut mesh = spec.mesh().unwrap_or_else(|e| panic!("{e}"));
    mesh.groups = [("rock".to_owned(), (0..mesh.elements.len() as u32).collect())].into();
    mesh.faces = plane_faces(&mesh, 1e-9);
    mesh
}

fn fault(through: [f64; 3], dip: f64, direction: f64) -> Cut {
    let plane = Plane::dipping(through, dip.to_radians(), direction.to_radians());
    Cut::through("fault", plane)
}

fn cut_of(base: &Mesh, cuts: &[Cut]) -> (Mesh, Done) {
    let mut mesh = base.clone();
    let done = crate::cut::cut(&mut mesh, cuts, &Bounds::default());
    (mesh, done.unwrap_or_else(|e| panic!("{cuts:?}: {e}")))
}

/// Dips and dip directions at which planes are tried, with where each goes through the block.
const PLANES: [(f64, f64, f64); 9] = [
    (20.0, 30.0, 0.0),
    (30.0, 75.0, 0.5),
    (40.0, 30.0, 0.25),
    (45.0, 45.0, 0.75),
    (50.0, 120.0, 1.0),
    (55.0, 30.0, 0.0),
    (65.0, 75.0, 1.25),
    (75.0, 200.0, 0.5),
    (60.0, 0.0, 0.3),
];

fn volume(mesh: &Mesh, group: &str) -> f64 {
    summary_of(mesh, mesh.groups[group].iter().copied()).volume
}

/// Each face with the elements that have it.
fn owners(mesh: &Mesh) -> BTreeMap<[u32; 4], Vec<Face>> {
    let mut owners: BTreeMap<[u32; 4], Vec<Face>> = BTreeMap::new();
    all_faces(mesh, None).for_each(|face| owners.entry(face_key(mesh, face)).or_default().push(face));
    owners
}

/// The volume of a box of which a plane leaves what is above, by slices: exact up to the integration along x.
fn above(plane: &Plane, low: [f64; 3], high: [f64; 3]) -> f64 {
    // ∫∫∫ over the corners' cubes (inclusion and exclusion): V = Σ ± max(0, d_corner)³ / (6 n1 n2 n3).
    let n = plane.normal.map(|c| if c.abs() < 1e-12 { 1e-12 } else { c });
    let mut sum = 0.0;
    for k in 0..8 {
        let corner = [0, 1, 2].map(|i| if k >> i & 1 == 1 { high[i] } else { low[i] });
        let sign = if (k as u32).count_ones() % 2 == 1 { 1.0 } else { -1.0 };
        sum += sign * plane.distance(corner).max(0.0).powi(3);
    }
    sum / (6.0 * n[0] * n[1] * n[2])
}

#[test]
fn oblique_planes_leave_good_elements_that_meet_and_sides_that_match() {
    let base = block();
    for (dip, direction, x) in PLANES {
        let cut = fault([x, 0.0, -7.0], dip, direction);
        let (mesh, done) = cut_of(&base, std::slice::from_ref(&cut));
        let label = format!("{dip} {direction} {x}");
        assert!(done.jacobian >= LEAST_JACOBIAN, "{label}: {}", done.jacobian);
        // All of it fills the block, each element on one side.
        assert!((summary(&mesh).volume / summary(&base).volume - 1.0).abs() < 1e-12, "{label}");
        let (one, two) = (&mesh.groups["fault.above"], &mesh.groups["fault.below"]);
        assert_eq!(one.len() + two.len(), mesh.elements.len(), "{label}");
        assert!(one.iter().all(|e| two.binary_search(e).is_err()), "{label}");
        assert_eq!(mesh.groups["rock"].len(), mesh.elements.len(), "{label}");
        // What did not change is as it was.
        let changed: BTreeSet<u32> = done.changed.iter().copied().collect();
        for e in (0..base.elements.len()).filter(|e| !changed.contains(&(*e as u32))) {
            assert_eq!(mesh.elements[e], base.elements[e], "{label}");
        }
        // Every face is shared by two, or lies on the outside as before.
        let owners = owners(&mesh);
        assert!(owners.values().all(|faces| faces.len() <= 2), "{label}");
        let planes = plane_faces(&mesh, 1e-9);
        let listed: BTreeSet<Face> = planes.values().flatten().copied().collect();
        assert_eq!(listed.len(), exterior_faces(&mesh, None).len(), "{label}");
        for side in ["xmin", "xmax", "ymin", "ymax", "base", "top"] {
            assert_eq!(mesh.faces[side], planes[side], "{label} {side}");
        }
        for (sides, axis) in [(["xmin", "xmax"], 0), (["ymin", "ymax"], 1)] {
            let nodes = sides.map(|side| {
                let nodes = planes[side].iter().flat_map(|&f| mesh.face_nodes(f));
                let place = |n: u32| [1 - axis, 2].map(|i| (mesh.nodes[n as usize][i] * 1e6).round() as i64);
                nodes.map(place).collect::<BTreeSet<_>>()
            });
            assert_eq!(nodes[0], nodes[1], "{label}");
        }
        // The border is the plane, but for corners into which it may bend.
        let mut far = 0.0f64;
        for faces in owners.values().filter(|faces| faces.len() == 2) {
            let [a, b] = [0, 1].map(|k| one.binary_search(&faces[k].element).is_ok());
            if a != b {
                let nodes = mesh.face_nodes(faces[0]);
                far = nodes.map(|n| cut.plane.distance(mesh.nodes[n as usize]).abs()).fold(far, f64::max);
            }
        }
        if far < 1e-9 {
            let exact = above(&cut.plane, [-8.0, -8.0, -14.0], [8.0, 8.0, 0.0]);
            if dip < 90.0 && direction % 90.0 != 0.0 {
                let found = volume(&mesh, "fault.above");
                assert!((found / exact - 1.0).abs() < 1e-9, "{label}: {found} {exact}");
            }
        } else {
            assert!(far < 0.8, "{label}: {far}");
        }
    }
}

#[test]
fn where_sides_want_unlike_ways_the_plane_bends_by_little() {
    // An upright plane through two corners of the block, where nodes of all four sides move together.
    let cut = fault([0.4, 0.0, -7.0], 90.0, 45.0);
    let (mesh, _) = cut_of(&block(), std::slice::from_ref(&cut));
    let one = &mesh.groups["fault.above"];
    for faces in owners(&mesh).values().filter(|faces| faces.len() == 2) {
        let [a, b] = [0, 1].map(|k| one.binary_search(&faces[k].element).is_ok());
        let far = |n: u32| cut.plane.distance(mesh.nodes[n as usize]).abs();
        // 0.4 of the longest edge in that direction, that of a brick's face.
        assert!(a == b || mesh.face_nodes(faces[0]).all(|n| far(n) < 0.4 * 2.0 * 2f64.sqrt()));
    }
}

#[test]
fn a_plane_turned_by_a_right_angle_parts_the_same_volumes() {
    // A square block, so that the turned plane parts it as the first does.
    let base = block();
    for (dip, direction) in [(55.0, 30.0), (35.0, 60.0)] {
        let [first, second] = [0.0, 90.0].map(|turn| {
            let (mesh, _) = cut_of(&base, &[fault([0.0, 0.0, -7.0], dip, direction + turn)]);
            ["fault.above", "fault.below"].map(|group| volume(&mesh, group))
        });
        for (a, b) in first.into_iter().zip(second) {
            // Half each, since the plane goes through the middle; it may bend into corners by a part of an element.
            assert!((a / b - 1.0).abs() < 1e-3, "{dip} {direction}: {first:?} {second:?}");
            assert!((a / 1792.0 - 1.0).abs() < 1e-3, "{dip} {direction}: {a}");
        }
    }
}

#[test]
fn an_oblique_plane_may_end_in_the_rock() {
    let short = Cut { extent: Some(4.0), ..fault([0.0, 0.0, -7.0], 60.0, 30.0) };
    let (mesh, _) = cut_of(&block(), &[short]);
    let some = mesh.groups["fault.above"].len() + mesh.groups["fault.below"].len();
    assert!(some > 20 && some < mesh.elements.len() / 2, "{some}");
}

/// Two wedges of each brick of the block.
fn wedges() -> Mesh {
    let base = block();
    let mut wedges = Mesh { nodes: base.nodes.clone(), ..Mesh::default() };
    for element in &base.elements {
        let n = element.nodes;
        wedges.elements.push(crate::Element::new(Shape::Wedge6, &[n[0], n[1], n[2], n[4], n[5], n[6]]));
        wedges.elements.push(crate::Element::new(Shape::Wedge6, &[n[0], n[2], n[3], n[4], n[6], n[7]]));
    }
    wedges.groups = [("rock".to_owned(), (0..wedges.elements.len() as u32).collect())].into();
    wedges
}

#[test]
fn a_plane_through_wedges_leaves_good_elements() {
    let base = wedges();
    let mut mesh = base.clone();
    let done = crate::cut::cut(&mut mesh, &[fault([0.2, 0.1, -7.0], 50.0, 20.0)], &Bounds::default());
    let done = done.unwrap_or_else(|e| panic!("{e}"));
    assert!(done.jacobian >= LEAST_JACOBIAN, "{}", done.jacobian);
    assert!((summary(&mesh).volume / summary(&base).volume - 1.0).abs() < 1e-12);
    let left = stable_step(&mesh) / stable_step(&base);
    assert!(left > 0.4, "{left}");
}

#[test]
fn oblique_planes_that_cross_part_the_block_into_four() {
    let one = Cut { name: "one".to_owned(), ..fault([0.0, 0.0, -7.0], 60.0, 30.0) };
    let two = Cut { name: "two".to_owned(), ..fault([0.3, 0.0, -7.0], 70.0, 140.0) };
    let base = block();
    let (mesh, done) = cut_of(&base, &[one, two]);
    assert!(done.jacobian >= LEAST_JACOBIAN, "{}", done.jacobian);
    let in_both = |a: &str, b: &str| {
        let other: BTreeSet<u32> = mesh.groups[b].iter().copied().collect();
        let both = mesh.groups[a].iter().copied().filter(|e| other.contains(e));
        summary_of(&mesh, both).volume
    };
    let quarters = ["one.above", "one.below"].map(|a| ["two.above", "two.below"].map(|b| in_both(a, b)));
    let quarters = quarters.as_flattened();
    assert!(quarters.iter().all(|volume| *volume > 400.0), "{quarters:?}");
    assert!((quarters.iter().sum::<f64>() / summary(&base).volume - 1.0).abs() < 1e-12);
    assert!(owners(&mesh).values().all(|faces| faces.len() <= 2));
    // Where they cross pieces are small. `check` refuses what leaves less than 0.4 of the step, so this one (0.30).
    let left = stable_step(&mesh) / stable_step(&base);
    assert!(left > 0.2, "{left}");
}

#[test]
fn what_comes_out_too_poor_is_refused_and_the_mesh_is_left_as_it_was() {
    // All nodes stay where they are: borders all round each brick, and edges at 1 % of which the plane passes nodes.
    let mut base = block();
    for e in 0..base.elements.len() as u32 {
        base.groups.insert(format!("brick{e}"), vec![e]);
    }
    let mut mesh = base.clone();
    let refused =
        crate::cut::cut(&mut mesh, &[fault([0.02, 0.0, -7.0], 88.0, 80.0)], &Bounds::default()).unwrap_err();
    assert!(refused.to_string().contains("Gmsh"), "{refused}");
    assert_eq!(mesh, base);
}

/// The stable step of a mesh of one-point elements with λ = μ = 1/3 and density 1, by power iteration.
fn stable_step(mesh: &Mesh) -> f64 {
    let mut mass = vec![0.0; mesh.nodes.len()];
    let mut gradients = Vec::new();
    for element in &mesh.elements {
        let x: Vec<[f64; 3]> = element.nodes().iter().map(|&k| mesh.nodes[k as usize]).collect();
        let volume = crate::quality::volume(element.shape, &x);
        element.nodes().iter().for_each(|&k| mass[k as usize] += volume / x.len() as f64);
        // Central differences of the volume: V b.
        let areas: Vec<[f64; 3]> = (0..x.len())
            .map(|k| {
                std::array::from_fn(|i| {
                    let volume = |h: f64| {
                        let mut x = x.clone();
                        x[k][i] += h;
                        crate::quality::volume(element.shape, &x)
                    };
                    (volume(1e-3) - volume(-1e-3)) / 2e-3
                })
            })
            .collect();
        gradients.push((volume, areas));
    }
    let start = |k: usize| [7919, 104_729, 1_299_709].map(|p| ((k * p + 13) % 101) as f64 - 50.0);
    let mut u: Vec<[f64; 3]> = (0..mesh.nodes.len()).map(start).collect();
    let mut square = 0.0;
    for _ in 0..300 {
        let size = u.iter().zip(&mass).map(|(u, m)| m * dot(*u, *u)).sum::<f64>().sqrt();
        u.iter_mut().for_each(|u| *u = u.map(|c| c / size));
        let mut force = vec![[0.0; 3]; u.len()];
        for (element, (volume, areas)) in mesh.elements.iter().zip(&gradients) {
            let corners = || element.nodes().iter().map(|&n| n as usize).zip(areas);
            let mut h = [[0.0; 3]; 3];
            for (n, area) in corners() {
                (0..9).for_each(|k| h[k / 3][k % 3] += u[n][k / 3] * area[k % 3] / volume);
            }
            let third = (h[0][0] + h[1][1] + h[2][2]) / 3.0;
            for (n, area) in corners() {
                for i in 0..3 {
                    let shear: f64 = (0..3).map(|j| (h[i][j] + h[j][i]) / 3.0 * area[j]).sum();
                    force[n][i] += shear + third * area[i];
                }
            }
        }
        square = u.iter().zip(&force).map(|(u, f)| dot(*u, *f)).sum::<f64>();
        u = force.iter().zip(&mass).map(|(f, m)| f.map(|c| c / m)).collect();
    }
    2.0 / square.sqrt()
}

#[test]
fn nodes_find_places_that_leave_half_of_the_step() {
    // Planes that left less than 0.4 of it while nodes stayed where the cut had put them.
    let base = block();
    let without = stable_step(&base);
    for (dip, direction, x) in [(75.0, 15.0, 0.5), (50.0, 200.0, 0.75), (30.0, 75.0, 1.0)] {
        let mut mesh = base.clone();
        let bounds = Bounds { free: [true, true], ..Bounds::default() };
        let done = crate::cut::cut(&mut mesh, &[fault([x, 0.0, -7.0], dip, direction)], &bounds);
        let done = done.unwrap_or_else(|e| panic!("{dip} {direction}: {e}"));
        let left = stable_step(&mesh) / without;
        assert!(left > 0.5 && done.jacobian > 0.18, "{dip} {direction}: {left} {}", done.jacobian);
    }
}

#[test]
fn a_plane_at_an_angle_goes_through_a_lined_hall() {
    use crate::cavern::{Cavern, CavernSpec, Lining};
    let lining = Lining { walls: 0.5, crown: 0.5, floor: 0.0, layers: 1 };
    let hall = Cavern {
        name: "hall".to_owned(),
        width: 12.0,
        height: 14.0,
        arch_rise: 3.0,
        lining,
        ..Cavern::default()
    };
    let spec = CavernSpec {
        overburden: 14.0,
        below: 12.0,
        sides: 14.0,
        length: 32.0,
        near: 4.0,
        far: 6.0,
        along: Some(4.0),
        caverns: vec![Cavern { benches: 2, ..hall }],
        ..CavernSpec::default()
    };
    let base = spec.mesh().unwrap_or_else(|e| panic!("{e}"));
    let of = |what: &str| {
        let groups = base.groups.iter().filter(|(name, _)| name.contains(what));
        groups.flat_map(|(_, list)| list.clone()).collect::<BTreeSet<u32>>().into_iter().collect::<Vec<u32>>()
    };
    let whole = of(".lining");
    let soft: Vec<String> = base.groups.keys().filter(|name| name.contains(".bench")).cloned().collect();
    let mut mesh = base.clone();
    let cut = Cut { whole: whole.clone(), ..fault([1.0, 0.0, -20.0], 65.0, 65.0) };
    let bounds = Bounds { thin: &whole, soft: &soft, free: [true, true] };
    let done =
        crate::cut::cut(&mut mesh, std::slice::from_ref(&cut), &bounds).unwrap_or_else(|e| panic!("{e}"));
    assert!(done.jacobian >= LEAST_JACOBIAN, "{}", done.jacobian);
    let left = stable_step(&mesh) / stable_step(&base);
    assert!(left > 0.4, "{left}");
    // Nothing is lost, of the block; of its parts what nodes that move along the arch cut off: 0.3 % with elements of 4 m.
    assert!((summary(&mesh).volume / summary(&base).volume - 1.0).abs() < 1e-12);
    for group in ["hall.bench1", "hall.bench2", "hall.lining"] {
        let [before, after] = [&base, &mesh].map(|mesh| volume(mesh, group));
        assert!((after / before - 1.0).abs() < 5e-3, "{group}: {before} {after}");
    }
    // The lining belongs to neither side; all the rest does, and meets its neighbours.
    let lined: BTreeSet<u32> = mesh.groups["hall.lining"].iter().copied().collect();
    let sides = ["fault.above", "fault.below"]
        .map(|group| mesh.groups[group].iter().copied().collect::<BTreeSet<u32>>());
    assert!(sides.iter().all(|side| side.is_disjoint(&lined)));
    assert_eq!(sides[0].len() + sides[1].len() + lined.len(), mesh.elements.len());
    let owners = owners(&mesh);
    assert_eq!(owners.values().filter(|faces| faces.len() == 1).count(), exterior_faces(&mesh, None).len());
    assert!(owners.values().all(|faces| faces.len() <= 2));
    // Outside the lining the border is the plane.
    let outside = |e: u32| {
        let [x, _, z] = middle(&mesh, e);
        x.abs() > 6.5 || !(-28.0..-13.5).contains(&z)
    };
    for faces in owners.values().filter(|faces| faces.len() == 2) {
        let [a, b] = [0, 1].map(|k| faces[k].element);
        if sides[0].contains(&a) && sides[1].contains(&b) && outside(a) && outside(b) {
            let far = mesh.face_nodes(faces[0]).map(|n| cut.plane.distance(mesh.nodes[n as usize]).abs());
            assert!(far.fold(0.0, f64::max) < 0.35, "about {:?}", middle(&mesh, a));
        }
    }
}
