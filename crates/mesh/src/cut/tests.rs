use std::collections::{BTreeMap, BTreeSet};

use super::*;
use crate::Face;
use crate::boxes::BoxSpec;
use crate::cavern::{Cavern, CavernSpec, Lining, Shotcrete};
use crate::placement::Placement;
use crate::quality::{summary, summary_of};
use crate::topology::{all_faces, exterior_faces, face_key, plane_faces};

/// A block of 60 × 4 × 40 m in bricks of 2 m.
fn block() -> Mesh {
    let spec = BoxSpec::uniform([-30.0, -2.0, -40.0], [30.0, 2.0, 0.0], [30, 2, 20]);
    let mut mesh = spec.mesh().unwrap_or_else(|e| panic!("{e}"));
    mesh.groups = [("rock".to_owned(), (0..mesh.elements.len() as u32).collect())].into();
    mesh.faces = plane_faces(&mesh, 1e-9);
    mesh
}

/// A lined hall in a block of rock.
fn hall() -> CavernSpec {
    CavernSpec {
        overburden: 40.0,
        below: 25.0,
        sides: 30.0,
        length: 12.0,
        near: 2.0,
        far: 6.0,
        along: Some(4.0),
        caverns: vec![Cavern {
            name: "hall".to_owned(),
            width: 18.0,
            height: 30.0,
            arch_rise: 5.0,
            benches: 3,
            lining: Lining { walls: 0.6, crown: 0.8, floor: 0.0, layers: 1 },
            ..Cavern::default()
        }],
        ..CavernSpec::default()
    }
}

fn lined(mesh: &Mesh) -> Vec<u32> {
    let linings = mesh.groups.iter().filter(|(name, _)| name.contains(".lining"));
    linings.flat_map(|(_, list)| list.iter().copied()).collect::<BTreeSet<_>>().into_iter().collect()
}

fn fault(through: [f64; 3], dip: f64, direction: f64) -> Cut {
    let plane = Plane::dipping(through, f64::to_radians(dip), f64::to_radians(direction));
    Cut::through("fault", plane)
}

/// Dips at which planes are tried, and by how much each is moved: all of an element in eight steps.
const DIPS: [f64; 8] = [20.0, 30.0, 40.0, 45.0, 50.0, 55.0, 65.0, 75.0];

fn cut_of(base: &Mesh, cuts: &[Cut]) -> (Mesh, Done) {
    let mut mesh = base.clone();
    let whole = lined(base);
    let soft: Vec<String> = base.groups.keys().filter(|name| name.contains(".bench")).cloned().collect();
    let cuts: Vec<Cut> = cuts.iter().map(|cut| Cut { whole: whole.clone(), ..cut.clone() }).collect();
    let done = super::cut(&mut mesh, &cuts, &Bounds { thin: &whole, soft: &soft, free: [false; 2] });
    (mesh, done.unwrap_or_else(|e| panic!("{cuts:?}: {e}")))
}

/// Each face with the elements that have it.
fn owners(mesh: &Mesh) -> BTreeMap<[u32; 4], Vec<Face>> {
    let mut owners: BTreeMap<[u32; 4], Vec<Face>> = BTreeMap::new();
    all_faces(mesh, None).for_each(|face| owners.entry(face_key(mesh, face)).or_default().push(face));
    owners
}

/// Faces between the two sides of a plane, and the area of each.
fn border(mesh: &Mesh) -> Vec<(Vec<[f64; 3]>, f64)> {
    let [above, below] = ["fault.above", "fault.below"].map(|g| &mesh.groups[g]);
    let mut found = Vec::new();
    for faces in owners(mesh).values().filter(|faces| faces.len() == 2) {
        let is = |k: usize, group: &Vec<u32>| group.binary_search(&faces[k].element).is_ok();
        if is(0, above) && is(1, below) || is(1, above) && is(0, below) {
            let x: Vec<[f64; 3]> = mesh.face_nodes(faces[0]).map(|n| mesh.nodes[n as usize]).collect();
            let way = |a: usize, b: usize| [0, 1, 2].map(|i| x[b][i] - x[a][i]);
            let cross = |a: [f64; 3], b: [f64; 3]| {
                let c = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
                c.iter().map(|c| c * c).sum::<f64>().sqrt()
            };
            let area = if x.len() == 4 {
                0.5 * cross(way(0, 2), way(1, 3))
            } else {
                0.5 * cross(way(0, 1), way(0, 2))
            };
            found.push((x, area));
        }
    }
    found
}

/// A hall and a block cut by each dip at each offset.
fn each(mut check: impl FnMut(&str, &Mesh, &Mesh, &Done, &Cut)) {
    let hall = hall().mesh().unwrap_or_else(|e| panic!("{e}"));
    for (name, base, middle) in [("block", block(), -20.0), ("hall", hall, -55.0)] {
        for dip in DIPS {
            for k in 0..8 {
                let cut =
                    fault([0.25 * f64::from(k), 0.0, middle], dip, if k % 2 == 0 { 90.0 } else { 270.0 });
                let (mesh, done) = cut_of(&base, std::slice::from_ref(&cut));
                check(name, &base, &mesh, &done, &cut);
            }
        }
    }
}

#[test]
fn every_dip_at_eight_offsets_is_cut_with_good_elements() {
    let mut least = BTreeMap::new();
    each(|name, base, mesh, done, cut| {
        assert!(done.jacobian >= LEAST_JACOBIAN, "{name} {cut:?}: {}", done.jacobian);
        let worst: &mut f64 = least.entry(name.to_owned()).or_insert(1.0);
        *worst = worst.min(done.jacobian);
        // What did not change is as it was.
        let changed: BTreeSet<u32> = done.changed.iter().copied().collect();
        for e in (0..base.elements.len() as u32).filter(|e| !changed.contains(e)) {
            assert_eq!(mesh.elements[e as usize], base.elements[e as usize]);
            assert!(
                base.elements[e as usize]
                    .nodes()
                    .iter()
                    .all(|&n| base.nodes[n as usize] == mesh.nodes[n as usize])
            );
        }
        assert!(done.changed.len() < mesh.elements.len());
        // All of it fills the block as before, and the linings are whole.
        let volumes = [summary(base), summary(mesh)].map(|s| s.volume);
        assert!((volumes[0] / volumes[1] - 1.0).abs() < 1e-12);
        assert_eq!(mesh.nodes.len(), base.nodes.len());
        for (group, list) in base.groups.iter().filter(|(name, _)| name.contains(".lining")) {
            assert_eq!(&mesh.groups[group], list);
        }
    });
    // Bricks keep more than half; the foot of a wall without a slab is the poorest place of the hall.
    assert!(least["block"] > 0.5, "{least:?}");
}

#[test]
fn the_border_is_the_plane_from_side_to_side() {
    each(|name, _, mesh, _, cut| {
        let (low, high) = mesh.bounds();
        let border = border(mesh);
        let far =
            border.iter().flat_map(|(x, _)| x).map(|x| cut.plane.distance(*x).abs()).fold(0.0, f64::max);
        let area: f64 = border.iter().map(|(_, area)| area).sum();
        // The length of the line in the block's rectangle.
        let [a, _, c] = cut.plane.normal;
        let along = [c, -a];
        let mut ends = [f64::NEG_INFINITY, f64::INFINITY];
        for (i, axis) in [0, 2].into_iter().enumerate() {
            let at = |side: f64| (side - cut.plane.through[axis]) / along[i];
            let (p, q) = (at(low[axis]).min(at(high[axis])), at(low[axis]).max(at(high[axis])));
            ends = [ends[0].max(p), ends[1].min(q)];
        }
        let exact = (ends[1] - ends[0]) * (high[1] - low[1]);
        if name == "block" {
            assert!((area / exact - 1.0).abs() < 1e-9, "{cut:?}: {area} {exact}");
            assert!(far < 1e-9, "{cut:?}: {far}");
            // And so the volumes on both sides are exact: the block's middle is a point of the first offset's plane.
        } else {
            // The lining interrupts it, and corners may bend it by less than half an element.
            assert!(far < 1.5, "{cut:?}: {far}");
            assert!(area > 0.9 * exact && area < 1.01 * exact, "{cut:?}: {area} {exact}");
        }
    });
    // The middle of a block halves it whatever the dip; what goes by middles of elements of a mesh that is not cut does not.
    for dip in DIPS {
        let (mesh, _) = cut_of(&block(), &[fault([0.0, 0.0, -20.0], dip, 90.0)]);
        let half = summary_of(&mesh, mesh.groups["fault.above"].iter().copied()).volume;
        assert!((half / (30.0 * 4.0 * 40.0) - 1.0).abs() < 1e-12, "{dip}: {half}");
    }
}

/// The lining's ring goes on as rock beyond the ends of a cavern: it belongs to a side there, so that each region finds its material.
#[test]
fn rock_beyond_the_ends_of_a_lined_cavern_belongs_to_a_side() {
    let mut spec = hall();
    spec.caverns[0].length = Some(4.0);
    let base = spec.mesh().unwrap_or_else(|e| panic!("{e}"));
    let (mesh, _) = cut_of(&base, &[fault([0.5, 0.0, -55.0], 50.0, 90.0)]);
    let lined: BTreeSet<u32> = lined(&mesh).into_iter().collect();
    assert_eq!(lined, self::lined(&base).into_iter().collect());
    let [above, below] = ["fault.above", "fault.below"].map(|g| &mesh.groups[g]);
    assert_eq!(above.len() + below.len() + lined.len(), mesh.elements.len());
    assert!(above.iter().all(|e| below.binary_search(e).is_err() && !lined.contains(e)));
}

#[test]
fn faces_meet_sides_match_and_face_sets_are_complete() {
    each(|name, _, mesh, _, cut| {
        let outer: Vec<Face> = exterior_faces(mesh, None);
        assert!(owners(mesh).values().all(|faces| faces.len() <= 2), "{name} {cut:?}");
        let planes = plane_faces(mesh, 1e-9);
        let listed: BTreeSet<Face> = planes.values().flatten().copied().collect();
        assert_eq!(listed.len(), outer.len(), "{name} {cut:?}");
        for side in ["xmin", "xmax", "ymin", "ymax", "base", "top"] {
            let (set, found) = (mesh.faces[side].clone(), &planes[side]);
            assert_eq!(&set, found, "{name} {side} {cut:?}");
        }
        for (sides, axis) in [(["xmin", "xmax"], 0), (["ymin", "ymax"], 1)] {
            let outlines = sides.map(|side| {
                let nodes = planes[side].iter().flat_map(|&f| mesh.face_nodes(f));
                let places = nodes.map(|n| {
                    let x = mesh.nodes[n as usize];
                    [(axis + 1) % 3, (axis + 2) % 3].map(|i| (x[i] * 1e6).round() as i64)
                });
                places.collect::<BTreeSet<_>>()
            });
            assert_eq!(outlines[0], outlines[1], "{name} {cut:?}");
        }
    });
}

#[test]
fn a_mirrored_mesh_is_cut_as_well_by_the_mirrored_plane() {
    let base = block();
    let mut mirrored = base.clone();
    Placement { scale: [-1.0, 1.0, 1.0], ..Placement::AS_IT_IS }.apply(&mut mirrored);
    for (dip, x) in [(25.0, 0.3), (58.0, 0.7), (70.0, -1.1)] {
        let (one, done) = cut_of(&base, &[fault([x, 0.0, -20.0], dip, 90.0)]);
        let (other, again) = cut_of(&mirrored, &[fault([-x, 0.0, -20.0], dip, 270.0)]);
        assert!((done.jacobian - again.jacobian).abs() < 0.1, "{done:?} {again:?}");
        for group in ["fault.above", "fault.below"] {
            let volume = |mesh: &Mesh| summary_of(mesh, mesh.groups[group].iter().copied()).volume;
            assert!((volume(&one) / volume(&other) - 1.0).abs() < 1e-9, "{dip} {group}");
        }
    }
}

#[test]
fn two_planes_cross_and_a_third_ends_in_the_rock() {
    let plane = |name: &str, x: f64, dip: f64, to: f64| Cut {
        name: name.to_owned(),
        ..fault([x, 0.0, -20.0], dip, to)
    };
    let cuts = [plane("one", 0.4, 60.0, 90.0), plane("two", 3.1, 40.0, 270.0)];
    let (mesh, done) = cut_of(&block(), &cuts);
    assert!(done.jacobian >= LEAST_JACOBIAN);
    let sum = |groups: [&str; 2]| -> f64 {
        let both = mesh.groups[groups[0]].iter().filter(|e| mesh.groups[groups[1]].binary_search(e).is_ok());
        summary_of(&mesh, both.copied()).volume
    };
    let mut all = 0.0;
    for one in ["one.above", "one.below"] {
        for two in ["two.above", "two.below"] {
            all += sum([one, two]);
            assert!(sum([one, two]) > 100.0);
        }
    }
    assert!((all / (60.0 * 4.0 * 40.0) - 1.0).abs() < 1e-12);
    let short = Cut { extent: Some(8.0), ..fault([0.0, 0.0, -20.0], 50.0, 90.0) };
    let (mesh, _) = cut_of(&block(), std::slice::from_ref(&short));
    let border = border(&mesh);
    let area: f64 = border.iter().map(|(_, area)| area).sum();
    // It ends at nodes, up to half an element before or beyond.
    assert!((area / 4.0 - 16.0).abs() < 2.9, "{area}");
    assert!(border.iter().flat_map(|(x, _)| x).all(|x| short.plane.distance(*x).abs() < 1e-9));
    assert!(mesh.groups["fault.above"].len() + mesh.groups["fault.below"].len() < mesh.elements.len() / 4);
}

#[test]
fn what_cannot_be_cut_says_the_way_out_and_stays() {
    let base = block();
    let at = [0.0, 0.0, -20.0];
    let known = {
        let mut mesh = base.clone();
        mesh.groups.insert("fault.below".to_owned(), vec![3]);
        mesh
    };
    for (mesh, cut, says) in [
        (&base, fault([0.0, 0.0, 20.0], 20.0, 90.0), "move `through`"),
        (&known, fault(at, 50.0, 90.0), "another name"),
    ] {
        let mut tried = mesh.clone();
        let refused = super::cut(&mut tried, &[cut], &Bounds::default()).map_err(|e| e.to_string());
        assert!(refused.as_ref().is_err_and(|e| e.contains(says)), "{refused:?}");
        assert_eq!(&tried, mesh);
    }
}

/// Shotcrete on the rock of the hall, and a lining of half a metre inside it.
fn sprayed() -> CavernSpec {
    let mut spec = hall();
    spec.caverns[0].shotcrete = Shotcrete { thickness: 0.2, layers: 1 };
    spec
}

/// Shotcrete belongs to the sides of a plane, whose border goes through it to the lining; the plane keeps its place at the wall.
#[test]
fn shotcrete_on_the_rock_is_cut_with_it_and_the_plane_keeps_its_place() {
    let base = sprayed().mesh().unwrap_or_else(|e| panic!("{e}"));
    let sprayed: BTreeSet<u32> = {
        let groups = base.groups.iter().filter(|(name, _)| name.contains(".shotcrete"));
        groups.flat_map(|(_, list)| list.iter().copied()).collect()
    };
    let numbered = |name: &str| {
        [".bench", ".lining", ".shotcrete"].iter().any(|part| name.contains(part))
            && name.ends_with(|c: char| c.is_ascii_digit())
    };
    let soft: Vec<String> = base.groups.keys().filter(|name| numbered(name)).cloned().collect();
    let whole = lined(&base);
    let thin: Vec<u32> =
        whole.iter().copied().chain(sprayed.iter().copied()).collect::<BTreeSet<_>>().into_iter().collect();
    let (mut kept, mut tried, mut worst) = (0, 0, 0.0_f64);
    for dip in DIPS {
        for k in 0..8 {
            let mut mesh = base.clone();
            let cut = Cut { whole: whole.clone(), ..fault([0.25 * f64::from(k), 0.0, -55.0], dip, 90.0) };
            let bounds = Bounds { thin: &thin, soft: &soft, free: [true; 2] };
            let done = super::cut(&mut mesh, std::slice::from_ref(&cut), &bounds)
                .unwrap_or_else(|e| panic!("{cut:?}: {e}"));
            assert!(done.jacobian >= LEAST_JACOBIAN, "{cut:?}: {}", done.jacobian);
            let [above, below] = ["fault.above", "fault.below"].map(|g| &mesh.groups[g]);
            let all: BTreeSet<u32> = above.iter().chain(below).copied().collect();
            assert!(mesh.groups["hall.shotcrete"].iter().all(|e| all.contains(e)), "{cut:?}");
            // The border has faces through the shotcrete, on both walls or on a wall and in the crown.
            let is_sprayed = |e: u32| mesh.groups["hall.shotcrete"].binary_search(&e).is_ok();
            let owners = owners(&mesh);
            let through = owners.values().filter(|faces| {
                faces.len() == 2
                    && faces.iter().all(|face| is_sprayed(face.element))
                    && faces.iter().any(|face| above.binary_search(&face.element).is_ok())
                    && faces.iter().any(|face| below.binary_search(&face.element).is_ok())
            });
            // At one or two places, four elements along y.
            let count = through.count();
            assert!(count >= 4 && count % 4 == 0, "{cut:?}: {count}");
            tried += 1;
            // At the walls, away from the springing and the foot.
            let at_walls = |x: &&[f64; 3]| (x[0].abs() - 9.8).abs() < 0.01 && (-67.0..-47.0).contains(&x[2]);
            let border = border(&mesh);
            let off =
                border.iter().flat_map(|(x, _)| x).filter(at_walls).map(|x| cut.plane.distance(*x).abs());
            let off = off.fold(0.0, f64::max);
            kept += usize::from(off < 1e-9);
            if off > worst {
                println!("{dip} {k}: {off:.3} m off");
            }
            worst = worst.max(off);
        }
    }
    println!("{kept} of {tried} keep their place, the others bend by up to {worst:.3} m");
    assert_eq!(kept, tried);
}
