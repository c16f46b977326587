//! Caverns that end in rock.

use std::collections::BTreeSet;

use super::blocks::{blocks, ending, finite, gallery, with_galleries};
use super::made;
use crate::cavern::{CavernSpec, GroundSurface, RockLayer};
use crate::mesh::Mesh;
use crate::quality;
use crate::topology::exterior_faces;

/// Planes across y, rising.
pub fn planes(mesh: &Mesh) -> Vec<f64> {
    let mut planes: Vec<f64> = mesh.nodes.iter().map(|x| x[1]).collect();
    planes.sort_by(f64::total_cmp);
    planes.dedup();
    planes
}

fn sizes(planes: &[f64]) -> Vec<f64> {
    planes.windows(2).map(|p| p[1] - p[0]).collect()
}

/// Lowest and highest y of a group.
pub fn extent(mesh: &Mesh, group: &str) -> [f64; 2] {
    let nodes = mesh.groups[group].iter().flat_map(|&e| mesh.elements[e as usize].nodes());
    nodes
        .map(|&n| mesh.nodes[n as usize][1])
        .fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], y| [a.min(y), b.max(y)])
}

/// The description without lengths.
fn through(spec: &CavernSpec) -> CavernSpec {
    ending(spec.clone(), spec.length, &vec![None; spec.caverns.len()])
}

#[test]
fn a_length_equal_to_the_block_s_changes_no_bit() {
    for (name, spec) in blocks().into_iter().step_by(3) {
        let spec = through(&spec);
        let own = ending(spec.clone(), spec.length, &vec![Some(spec.length); spec.caverns.len()]);
        assert!(made(name, &own) == made(name, &spec), "{name}");
    }
}

#[test]
fn groups_keep_their_names_and_lie_between_the_ends() {
    for (name, spec) in blocks().into_iter().filter(|(name, _)| name.starts_with("ends")) {
        let (mesh, whole) = (made(name, &spec), made(name, &through(&spec)));
        assert!(mesh.groups.keys().eq(whole.groups.keys()), "{name}");
        let ended = spec.caverns.iter().filter(|c| c.length.is_some());
        let ends: BTreeSet<String> = ended.map(|c| format!("{}.ends", c.name)).collect();
        let own: BTreeSet<String> = mesh.faces.keys().cloned().collect();
        assert_eq!(own, whole.faces.keys().cloned().chain(ends).collect(), "{name}");
        for c in &spec.caverns {
            let half = 0.5 * c.length.unwrap_or(spec.length);
            for group in mesh.groups.keys().filter(|group| group.starts_with(&format!("{}.", c.name))) {
                let [from, to] = extent(&mesh, group);
                let exact = [c.middle - half, c.middle + half];
                assert!((from - exact[0]).abs() < 1e-9 && (to - exact[1]).abs() < 1e-9, "{name} {group}");
            }
            let crown = mesh.points[&format!("{}.crown", c.name)];
            assert_eq!(crown[1], if c.length.is_some() { c.middle } else { 0.0 }, "{name}");
        }
    }
}

#[test]
fn the_faces_of_openings_are_intrados_and_end_walls() {
    for (name, spec) in blocks().into_iter().filter(|(_, s)| s.galleries.is_empty()) {
        let mesh = made(name, &spec);
        for c in &spec.caverns {
            let key = |face| super::corners(&mesh, face);
            let opening = &mesh.groups[&format!("{}.excavation", c.name)];
            let skin: BTreeSet<[u32; 4]> =
                exterior_faces(&mesh, Some(opening)).into_iter().map(key).collect();
            let set = |set: &str| mesh.faces.get(&format!("{}.{set}", c.name)).into_iter().flatten().copied();
            // Of the floor, where there is no slab, faces are in no set unless the cavern is bare.
            let listed: BTreeSet<[u32; 4]> = set("intrados").chain(set("ends")).map(key).collect();
            let across =
                |k: &&[u32; 4]| k.iter().all(|&n| mesh.nodes[n as usize][1] == mesh.nodes[k[0] as usize][1]);
            let block = [-0.5 * spec.length, 0.5 * spec.length];
            let inside = |k: &&[u32; 4]| !block.contains(&mesh.nodes[k[0] as usize][1]);
            let walls: BTreeSet<[u32; 4]> = skin.iter().filter(across).filter(inside).copied().collect();
            assert!(listed.is_subset(&skin), "{name}");
            let ends: BTreeSet<[u32; 4]> = set("ends").map(key).collect();
            assert_eq!(ends, walls, "{name}");
            let rock = &mesh.groups["rock"];
            assert!(set("ends").all(|face| rock.binary_search(&face.element).is_ok()), "{name}");
        }
    }
}

#[test]
fn elements_are_even_along_the_caverns_and_grow_beyond_their_ends() {
    let spec = finite();
    let planes = planes(&made("ends", &spec));
    for end in [26.4, 29.7, 80.0] {
        assert!(planes.iter().any(|y| (y - end).abs() < 1e-12), "{end}: {planes:?}");
    }
    let sizes = sizes(&planes);
    let along: Vec<f64> =
        planes.windows(2).filter(|p| p[0].abs() < 29.7 && p[1].abs() < 29.7).map(|p| p[1] - p[0]).collect();
    assert!(along.iter().all(|s| (3.0..=4.4).contains(s)), "{along:?}");
    let largest = sizes.iter().copied().fold(0.0, f64::max);
    assert!(largest > 0.8 * spec.far && largest <= spec.far * (1.0 + 1e-9), "{sizes:?}");
    // At the size along the caverns throughout there would be 36 or more.
    assert!(sizes.len() <= 30, "{sizes:?}");
    assert!(sizes.windows(2).all(|p| p[0].max(p[1]) <= 1.3 * p[0].min(p[1])), "{sizes:?}");
}

#[test]
fn shapes_are_as_good_as_those_of_the_extruded_section() {
    for (name, spec) in blocks().into_iter().filter(|(name, _)| name.starts_with("ends")) {
        let (own, whole) = (made(name, &spec), made(name, &through(&spec)));
        let [own, whole] = [&own, &whole].map(|mesh| quality::summary(mesh).min_scaled_jacobian);
        assert!((own - whole).abs() < 1e-12, "{name}: {own} {whole}");
    }
}

#[test]
fn centred_caverns_have_a_mesh_that_is_its_own_mirror_image_to_the_last_bit() {
    for spec in [finite(), ending(finite(), 111.0, &[Some(53.2), Some(52.4)])] {
        let mesh = made("ends", &spec);
        let count = mesh.faces["ymin"].len();
        let layers = mesh.elements.len() / count;
        let planes = planes(&mesh);
        assert!(planes.iter().zip(planes.iter().rev()).all(|(a, b)| *a == -*b), "{planes:?}");
        for (name, group) in &mesh.groups {
            let mirror = |&e: &u32| (layers - 1 - e as usize / count) * count + e as usize % count;
            let mut mirrored: Vec<u32> = group.iter().map(|e| mirror(e) as u32).collect();
            mirrored.sort_unstable();
            assert_eq!(&mirrored, group, "{name}");
        }
    }
}

#[test]
fn unlike_ends_are_met_exactly_down_to_a_tenth_of_an_element() {
    for more in [0.9, 2.0, 30.0] {
        let spec = ending(finite(), 160.0, &[Some(52.8), Some(52.8 + more)]);
        let sizes = sizes(&planes(&made("ends", &spec)));
        let least = sizes.iter().copied().fold(f64::INFINITY, f64::min);
        assert!(least >= 0.5 * more.min(3.0) - 1e-9, "{more}: {sizes:?}");
        assert!(sizes.windows(2).all(|p| p[0].max(p[1]) <= 1.3 * p[0].min(p[1])), "{more}: {sizes:?}");
    }
    // Round-off makes no plane.
    let spec = ending(finite(), 160.0, &[Some(52.8), Some(52.8 + 1e-7)]);
    assert_eq!(
        sizes(&planes(&made("ends", &spec))).len(),
        sizes(&planes(&made("ends", &ending(finite(), 160.0, &[Some(52.8); 2])))).len()
    );
}

#[test]
fn rock_beyond_the_ends_belongs_to_the_layer_of_its_place() {
    let layer =
        |name: &str, depth: f64, dip: f64| RockLayer { name: name.into(), depth, dip, dip_direction: 0.0 };
    let layers = vec![layer("upper", 0.0, 0.0), layer("lower", 215.0, 0.1)];
    let spec = CavernSpec { layers, ground: GroundSurface::Inclined { x: 0.1, y: -0.08 }, ..finite() };
    let mesh = made("ends", &spec);
    let mut both = [&mesh.groups["rock.upper"][..], &mesh.groups["rock.lower"]].concat();
    both.sort_unstable();
    assert_eq!(both, mesh.groups["rock"]);
    let holds = |group: &str, e: u32| mesh.groups[group].binary_search(&e).is_ok();
    let mut beyond = [0; 2];
    for (e, element) in (0..).zip(&mesh.elements) {
        let [x, y, z] =
            [0, 1, 2].map(|c| element.nodes().iter().map(|&n| mesh.nodes[n as usize][c]).sum::<f64>() / 8.0);
        if x.abs() > 8.0 || !(-236.0..-205.0).contains(&z) {
            continue;
        }
        // Within the powerhouse's outline.
        let rock = y.abs() > 26.4;
        assert_eq!((holds("rock", e), holds("powerhouse.excavation", e)), (rock, !rock));
        if rock {
            let lower = z < -215.0 - 0.1_f64.tan() * x;
            assert_eq!((holds("rock.upper", e), holds("rock.lower", e)), (!lower, lower));
            beyond[usize::from(lower)] += 1;
        }
    }
    assert!(beyond[0] > 50 && beyond[1] > 50, "{beyond:?}");
}

#[test]
fn lengths_that_cannot_be_made_are_refused_with_the_key() {
    type Change = fn(&mut CavernSpec);
    let cases: [(&str, Change); 12] = [
        ("powerhouse.length is 0", |s| s.caverns[0].length = Some(0.0)),
        ("powerhouse.length is NaN", |s| s.caverns[0].length = Some(f64::NAN)),
        ("powerhouse.length is inf", |s| s.caverns[0].length = Some(f64::INFINITY)),
        ("transformer.length is 161; it must be above 0 and at most the block's, 160 m", |s| {
            s.caverns[1].length = Some(161.0)
        }),
        ("powerhouse.length is 4; it must be at least an element's along", |s| {
            s.caverns[0].length = Some(4.0)
        }),
        ("powerhouse.length is 152; it must be such that the cavern ends at", |s| {
            s.caverns[0].length = Some(152.0)
        }),
        ("powerhouse.middle is NaN", |s| s.caverns[0].middle = f64::NAN),
        ("powerhouse.middle is 54; it must be such that the cavern ends at", |s| s.caverns[0].middle = 54.0),
        ("powerhouse.middle is -50; it must be such that the cavern ends at", |s| {
            s.caverns[0].middle = -50.0
        }),
        ("transformer.length is 53; it must be such that its ends, y = -26.500 and 26.500 m", |s| {
            s.caverns[1].length = Some(53.0)
        }),
        (
            "bus.at is 26; it must be such that the gallery, 3 m wide, lies between the ends of cavern \"powerhouse\"",
            |s| s.galleries = vec![gallery("bus", [26.0, 14.4])],
        ),
        ("bus.at is 24.8; it must be such that its walls, y = 23.300 and 26.300 m, are in the planes", |s| {
            s.galleries = vec![gallery("bus", [24.8, 14.4])]
        }),
    ];
    for (expected, change) in cases {
        let mut spec = finite();
        change(&mut spec);
        let message = spec.mesh().map(|_| ()).expect_err(expected).to_string();
        assert!(message.contains(expected), "{expected:?} not in {message:?}");
    }
    // A gallery flush with an end, and one near the face of a block that the caverns go through.
    let mut spec = finite();
    spec.galleries = vec![gallery("bus", [24.9, 14.4])];
    assert!(made("flush", &spec).groups["bus.gallery"].len() > 1);
    made("near the face", &with_galleries(vec![gallery("bus", [24.7, 14.4])]));
}
