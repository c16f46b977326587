use std::collections::BTreeSet;

use super::{blocks, gallery, made, with_galleries};
use crate::cavern::Gallery;
use crate::mesh::Face;
use crate::topology::exterior_faces;
use crate::{Mesh, quality};

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

#[test]
fn galleries_are_exact_boxes_from_lining_to_lining() {
    let (_, spec) = blocks().swap_remove(0);
    let mesh = made("galleries", &spec);
    let groups = quality::by_group(&mesh);
    for g in &spec.galleries {
        // Extrados of the powerhouse at 9 m, of the transformer cavern at 28.9 m; floor at −237.2 m.
        let exact = [[9.0, g.at[0] - 1.5, -237.2 + 14.4], [28.9, g.at[0] + 1.5, -237.2 + 14.4 + 3.4]];
        let got = extent(&mesh, &format!("{}.gallery", g.name));
        for c in 0..3 {
            assert!((got[0][c] - exact[0][c]).abs() < 1e-9, "{got:?}");
            assert!((got[1][c] - exact[1][c]).abs() < 1e-9, "{got:?}");
        }
        let volume = groups[format!("{}.gallery", g.name).as_str()].volume;
        assert!((volume - 19.9 * 3.0 * 3.4).abs() < 1e-8, "{volume}");
        let volume = groups[format!("{}.opening", g.name).as_str()].volume;
        assert!((volume - 2.0 * 0.5 * 3.0 * 3.4).abs() < 1e-9, "{volume}");
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
    let cases: [(&str, Change); 9] = [
        ("bus.width is 0", Box::new(|g| g.width = 0.0)),
        ("bus.height is NaN", Box::new(|g| g.height = f64::NAN)),
        ("bus.at is 7.5", Box::new(|g| g.at[0] = 7.5)),
        ("bus.at is inf", Box::new(|g| g.at[1] = f64::INFINITY)),
        ("that there is not", Box::new(|g| g.between[0] = "hall".to_owned())),
        ("beside one another", Box::new(|g| g.between[0] = "transformer".to_owned())),
        ("no row of elements", Box::new(|g| g.at[1] = 31.0)),
        ("too little or too much room", Box::new(|g| g.at[1] = 16.2)),
        ("be used once", Box::new(|g| g.name = "powerhouse".to_owned())),
    ];
    for (says, change) in cases {
        let error = with(&change);
        assert!(error.contains(says), "{says:?} not in {error}");
    }
}
