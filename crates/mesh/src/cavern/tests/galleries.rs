use std::collections::BTreeSet;

use super::blocks::{blocks, gallery, with_galleries};
use super::made;
use crate::cavern::{CavernSpec, Gallery, Lining};
use crate::mesh::Face;
use crate::topology::exterior_faces;
use crate::{Mesh, Note, quality};

/// Lowest and highest coordinates of a group's nodes.
fn extent(mesh: &Mesh, group: &str) -> [[f64; 3]; 2] {
    let mut range = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
    for &n in mesh.groups[group].iter().flat_map(|&e| mesh.elements[e as usize].nodes()) {
        let x = mesh.nodes[n as usize];
        range[0] = std::array::from_fn(|c| range[0][c].min(x[c]));
        range[1] = std::array::from_fn(|c| range[1][c].max(x[c]));
    }
    range
}

/// Volume, extent and quality of all that a gallery is about, for the paper's caverns.
fn check(name: &str, spec: &CavernSpec) {
    let (mesh, notes) = spec.mesh_with_notes().unwrap_or_else(|e| panic!("{name}: {e}"));
    let groups = quality::by_group(&mesh);
    assert!(quality::summary(&mesh).min_scaled_jacobian >= 0.45, "{name}");
    for (group, summary) in groups.iter().filter(|(g, _)| g.contains("lining") || g.contains("opening")) {
        assert!(summary.min_scaled_jacobian >= 0.85, "{name} {group}: {}", summary.min_scaled_jacobian);
    }
    for g in &spec.galleries {
        // Extrados of the powerhouse at 9 m, of the transformer cavern at 28.9 m; floor at −237.2 m.
        let floor = -237.2 + g.at[1];
        let half = 0.5 * g.width;
        let exact = [[9.0, g.at[0] - half, floor], [28.9, g.at[0] + half, floor + g.height]];
        let got = extent(&mesh, &format!("{}.gallery", g.name));
        for c in 0..3 {
            assert!((got[0][c] - exact[0][c]).abs() < 1e-9, "{name} {got:?}");
            assert!((got[1][c] - exact[1][c]).abs() < 1e-9, "{name} {got:?}");
        }
        let volume = groups[format!("{}.gallery", g.name).as_str()].volume;
        assert!((volume - 19.9 * g.width * g.height).abs() < 1e-7, "{name} {volume}");
        let volume = groups[format!("{}.opening", g.name).as_str()].volume;
        assert!((volume - 2.0 * 0.5 * g.width * g.height).abs() < 1e-8, "{name} {volume}");
    }
    // Benches: equal ones, but for the cuts that the notes say have moved, and that by less than a quarter of `near`.
    for c in &spec.caverns {
        let wall = c.height - c.arch_rise;
        let cut = |below: u32| {
            let equal = wall * f64::from(c.benches - below) / f64::from(c.benches);
            let moved = notes.iter().find_map(|note| match note {
                Note::MovedCut { cavern, bench, from, to } if *cavern == c.name && *bench == below => {
                    assert!((from - equal).abs() < 1e-9 && (to - from).abs() < 0.25 * spec.near, "{name}");
                    Some(*to)
                }
                _ => None,
            });
            moved.unwrap_or(equal)
        };
        for bench in 2..=c.benches {
            let volume = groups[format!("{}.bench{bench}", c.name).as_str()].volume;
            let exact = spec.length * c.width * (cut(bench - 1) - cut(bench));
            assert!((volume / exact - 1.0).abs() < 1e-9, "{name} {} {bench}: {volume} {exact}", c.name);
        }
    }
}

#[test]
fn a_gallery_is_an_exact_box_at_any_level_of_the_paper_s_caverns() {
    // On the floor, at cuts of either cavern (5.45, 6.425, 12.85, 16.35 and 21.8 m), near them and between them.
    for floor in [0.0, 0.7, 2.6, 5.45, 6.1, 9.0, 12.85, 14.4, 16.2, 18.4, 21.6] {
        check(&format!("floor at {floor}"), &with_galleries(vec![gallery("bus", [0.0, floor])]));
    }
    for floor in [0.0, 6.1, 14.4, 21.6] {
        let galleries = vec![gallery("bus", [0.0, floor])];
        check(&format!("fine, floor at {floor}"), &CavernSpec { galleries, ..CavernSpec::yingxiuwan_fine() });
    }
}

#[test]
fn galleries_stand_beside_and_above_one_another() {
    let sized = |name: &str, at: [f64; 2], size: [f64; 2]| Gallery {
        width: size[0],
        height: size[1],
        ..gallery(name, at)
    };
    let sets = [
        (
            "in a row",
            vec![gallery("a", [-12.0, 14.4]), gallery("b", [-2.0, 14.4]), gallery("c", [8.0, 14.4])],
        ),
        ("at unlike levels", vec![gallery("a", [-12.0, 14.4]), sized("b", [15.0, 6.0], [5.0, 6.0])]),
        (
            "one above another",
            vec![gallery("a", [0.0, 2.0]), sized("b", [1.0, 7.0], [4.0, 4.5]), gallery("c", [-1.0, 17.0])],
        ),
        ("wall to wall", vec![gallery("a", [0.0, 9.0]), gallery("b", [3.0, 9.0])]),
    ];
    for (name, galleries) in sets {
        check(name, &with_galleries(galleries.clone()));
        if name == "one above another" {
            check("fine", &CavernSpec { galleries, ..CavernSpec::yingxiuwan_fine() });
        }
    }
}

#[test]
fn caverns_at_unlike_levels_lined_or_not_can_be_joined() {
    for (drop, floors, lined) in
        [(3.0_f64, [0.6, 0.0], true), (-4.0, [0.0, 0.5], true), (2.2, [0.0, 0.0], false)]
    {
        for level in [drop.max(0.0), 8.0, 15.0] {
            let mut spec = with_galleries(vec![gallery("bus", [0.0, level])]);
            spec.caverns[1].at[1] = drop;
            for (cavern, floor) in spec.caverns.iter_mut().zip(floors) {
                cavern.lining.floor = floor;
                if !lined {
                    cavern.lining = Lining::NONE;
                }
            }
            let mesh = made(&format!("{drop} {level}"), &spec);
            let volume = quality::by_group(&mesh)["bus.gallery"].volume;
            let length = if lined { 19.9 } else { 20.9 };
            assert!((volume - length * 3.0 * 3.4).abs() < 1e-8, "{drop} {level}: {volume}");
            assert_eq!(mesh.groups.contains_key("bus.opening"), lined);
        }
    }
}

#[test]
fn a_gallery_s_surface_is_all_that_bounds_it_but_the_caverns() {
    let (_, spec) = blocks().swap_remove(0);
    let mesh = made("galleries", &spec);
    for g in &spec.galleries {
        let mut void: Vec<u32> = ["gallery", "opening"]
            .iter()
            .flat_map(|part| &mesh.groups[&format!("{}.{part}", g.name)])
            .copied()
            .collect();
        void.sort_unstable();
        let skin = exterior_faces(&mesh, Some(&void));
        let key = |f: &Face| {
            let mut nodes: Vec<u32> = mesh.face_nodes(*f).collect();
            nodes.sort_unstable();
            nodes
        };
        // All outer faces but those at either end, against the caverns' benches.
        let ends: BTreeSet<Vec<u32>> = spec
            .caverns
            .iter()
            .flat_map(|c| exterior_faces(&mesh, Some(&mesh.groups[&format!("{}.excavation", c.name)])))
            .map(|f| key(&f))
            .collect();
        let sides: BTreeSet<Vec<u32>> = skin.iter().map(key).filter(|k| !ends.contains(k)).collect();
        let surface: BTreeSet<Vec<u32>> =
            mesh.faces[&format!("{}.surface", g.name)].iter().map(key).collect();
        assert_eq!(sides, surface);
        assert!(skin.len() > sides.len());
    }
}

#[test]
fn galleries_that_cannot_be_made_are_refused_with_the_reason() {
    let with = |change: &dyn Fn(&mut Gallery)| {
        let mut one = gallery("bus", [0.0, 14.4]);
        change(&mut one);
        with_galleries(vec![one]).mesh().unwrap_err().to_string()
    };
    type Change = Box<dyn Fn(&mut Gallery)>;
    let cases: [(&str, Change); 10] = [
        ("bus.width is 0", Box::new(|g| g.width = 0.0)),
        ("bus.height is NaN", Box::new(|g| g.height = f64::NAN)),
        ("bus.at is 25", Box::new(|g| g.at[0] = 25.0)),
        ("bus.at is inf", Box::new(|g| g.at[1] = f64::INFINITY)),
        ("that there is not", Box::new(|g| g.between[0] = "hall".to_owned())),
        ("beside one another", Box::new(|g| g.between[0] = "transformer".to_owned())),
        ("its roof, 26.400 m, at most at 25.380 m", Box::new(|g| g.at[1] = 23.0)),
        ("floor must be at 0.000 m or from 0.320 m up", Box::new(|g| g.at[1] = 0.2)),
        ("bus.height is 0.3; it must be at least 0.320 m", Box::new(|g| g.height = 0.3)),
        ("the name is used twice", Box::new(|g| g.name = "powerhouse".to_owned())),
    ];
    for (says, change) in cases {
        let error = with(&change);
        assert!(error.contains(says), "{says:?} not in {error}");
    }
}

#[test]
fn galleries_that_meet_or_nearly_meet_are_refused() {
    for (at, says) in [
        ([1.0, 16.0], "overlaps gallery \"one\""),
        ([20.0, 17.9], "has a floor or roof 0.100 m from one of gallery \"one\""),
        ([3.2, 5.0], "has a wall in y 0.200 m from one of gallery \"one\""),
    ] {
        let galleries = vec![gallery("one", [0.0, 14.4]), gallery("two", at)];
        let error = with_galleries(galleries).mesh().unwrap_err().to_string();
        assert!(error.contains(says), "{says:?} not in {error}");
    }
}
