use std::collections::BTreeMap;

use super::{blocks, made};
use crate::cavern::profile::Profile;
use crate::mesh::Face;
use crate::quality;

/// Area under a polygon of `n` equal steps of angle inscribed in an arc, over its chord.
fn polygon(half: f64, rise: f64, n: f64) -> f64 {
    let radius = (half * half + rise * rise) / (2.0 * rise);
    let angle = 2.0 * (2.0 * rise.atan2(half));
    0.5 * radius * radius * (n * (angle / n).sin() - angle.sin())
}

#[test]
fn groups_have_their_exact_volumes() {
    for (name, spec) in blocks() {
        let mesh = made(name, &spec);
        let volume: BTreeMap<&str, f64> =
            quality::by_group(&mesh).into_iter().map(|(group, s)| (group, s.volume)).collect();
        let (low, high) = mesh.bounds();
        let mut rock = (high[0] - low[0]) * spec.length * (high[2] - low[2]);
        for c in &spec.caverns {
            let equal = |group: &str, area: f64| {
                let got = volume.get(format!("{}.{group}", c.name).as_str()).copied().unwrap_or(0.0);
                assert!(
                    (got - area * spec.length).abs() <= 1e-9 * spec.length * c.width * c.height,
                    "{name} {group}: {got}"
                );
            };
            let profile = Profile::new(c);
            let (inner, outer) = (profile.inner, profile.outer);
            let layers = (mesh.faces["ymin"].len() as f64 / mesh.elements.len() as f64).recip();
            let columns = if c.lining.is_none() {
                // All faces of the intrados less those of the walls and the floor.
                let on_arch = |f: &&Face| {
                    let x: Vec<f64> = mesh.face_nodes(**f).map(|n| mesh.nodes[n as usize][2]).collect();
                    x.iter().all(|z| *z >= -spec.overburden - c.arch_rise - 1e-9)
                };
                mesh.faces[&format!("{}.intrados", c.name)].iter().filter(on_arch).count() as f64 / layers
            } else {
                mesh.groups[&format!("{}.lining.crown", c.name)].len() as f64
                    / (layers * f64::from(c.lining.layers))
            };
            // Measured against the polygon that the mesh has for the arch, not a wider tolerance.
            let arch = polygon(inner.half, inner.rise, columns);
            let walls = inner.springing;
            let bench = c.width * walls / f64::from(c.benches);
            equal("excavation", c.width * walls + arch);
            equal("bench1", bench + arch);
            for k in 2..=c.benches {
                equal(&format!("bench{k}"), bench);
            }
            equal("lining.floor", profile.floor * 2.0 * outer.half);
            let over = polygon(outer.half, outer.rise, columns);
            // The joint of wall and arch runs from the inner springing to the outer one.
            let joint = 2.0 * c.lining.walls * (outer.springing - walls) / 2.0;
            let shell = 2.0 * outer.half * outer.springing + over - c.width * walls - arch;
            let wall = 2.0 * c.lining.walls * walls + joint;
            equal("lining.walls", wall);
            equal("lining.crown", shell - wall);
            equal("lining", shell + profile.floor * 2.0 * outer.half);
            rock -=
                (2.0 * outer.half * outer.springing + over + profile.floor * 2.0 * outer.half) * spec.length;
        }
        assert!((volume["rock"] - rock).abs() < 1e-10 * rock, "{name}: {} {rock}", volume["rock"]);
    }
}
