use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;

use super::blocks::blocks;
use super::made;
use crate::cavern::profile::Profile;
use crate::cavern::tube::Tube;
use crate::cavern::{Cavern, CavernShape, CavernSpec, Lining};
use crate::mesh::{Face, Mesh};
use crate::quality;

/// Area under a polygon of `n` equal steps inscribed in a roof, over its chord; known for arcs and ellipses of
/// equal steps of angle, and nothing for a flat roof.
fn polygon(shape: CavernShape, half: f64, rise: f64, n: f64) -> f64 {
    match shape {
        CavernShape::Rectangle => 0.0,
        // A circle's polygon, stretched in height.
        CavernShape::Ellipse => 0.5 * half * rise * n * (PI / n).sin(),
        _ => {
            let radius = (half * half + rise * rise) / (2.0 * rise);
            let angle = 2.0 * (2.0 * rise.atan2(half));
            0.5 * radius * radius * (n * (angle / n).sin() - angle.sin())
        }
    }
}

/// Planes across y on which a group has nodes.
fn planes(mesh: &Mesh, group: &str) -> usize {
    let nodes = mesh.groups[group].iter().flat_map(|&e| mesh.elements[e as usize].nodes());
    let levels: BTreeSet<u64> = nodes.map(|&n| mesh.nodes[n as usize][1].to_bits()).collect();
    levels.len()
}

#[test]
fn groups_have_their_exact_volumes() {
    for (name, spec) in blocks() {
        if spec.caverns.iter().any(|c| c.shape.is_closed()) || !spec.galleries.is_empty() {
            continue;
        }
        let mesh = made(name, &spec);
        let volume: BTreeMap<&str, f64> =
            quality::by_group(&mesh).into_iter().map(|(group, s)| (group, s.volume)).collect();
        let (low, high) = mesh.bounds();
        let mut rock = (high[0] - low[0]) * spec.length * (high[2] - low[2]);
        for c in &spec.caverns {
            let length = c.length.unwrap_or(spec.length);
            let equal = |group: &str, area: f64| {
                let got = volume.get(format!("{}.{group}", c.name).as_str()).copied().unwrap_or(0.0);
                assert!(
                    (got - area * length).abs() <= 1e-9 * length * c.width * c.height,
                    "{name} {group}: {got}"
                );
            };
            let profile = Profile::new(c);
            let (inner, lined, outer) = (profile.inner, profile.lined, profile.outer);
            let layers = planes(&mesh, &format!("{}.excavation", c.name)) as f64 - 1.0;
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
            let arch = polygon(c.shape, inner.half, inner.rise, columns);
            let walls = inner.springing;
            let bench = c.width * walls / f64::from(c.benches);
            equal("excavation", c.width * walls + arch);
            equal("bench1", bench + arch);
            for k in 2..=c.benches {
                equal(&format!("bench{k}"), bench);
            }
            equal("lining.floor", profile.floor * 2.0 * lined.half);
            let over = polygon(c.shape, lined.half, lined.rise, columns);
            // The joint of wall and arch runs from the inner springing to the outer one.
            let joint = 2.0 * c.lining.walls * (lined.springing - walls) / 2.0;
            let shell = 2.0 * lined.half * lined.springing + over - c.width * walls - arch;
            let wall = 2.0 * c.lining.walls * walls + joint;
            equal("lining.walls", wall);
            equal("lining.crown", shell - wall);
            equal("lining", shell + profile.floor * 2.0 * lined.half);
            let arch = polygon(c.shape, outer.half, outer.rise, columns);
            let whole = 2.0 * outer.half * (outer.springing + profile.floor) + arch;
            equal("shotcrete", whole - 2.0 * lined.half * (lined.springing + profile.floor) - over);
            rock -= whole * length;
        }
        assert!((volume["rock"] - rock).abs() < 1e-10 * rock, "{name}: {} {rock}", volume["rock"]);
    }
}

#[test]
fn a_circle_s_lining_has_the_volume_of_its_polygons() {
    let lining = Lining { walls: 0.4, crown: 0.4, floor: 0.4, layers: 2 };
    let shape = CavernShape::Circle;
    let cavern =
        Cavern { name: "t".into(), width: 9.0, height: 9.0, shape, benches: 1, lining, ..Cavern::default() };
    let spec = CavernSpec { caverns: vec![cavern], ..blocks().swap_remove(2).1 };
    let mesh = made("circle", &spec);
    let groups = quality::by_group(&mesh);
    // The invert and the crown are divided equally in angle, the walls in height.
    let layers = mesh.elements.len() / mesh.faces["ymin"].len();
    let columns = mesh.groups["t.lining.crown"].len() / (2 * layers);
    let rows = mesh.groups["t.lining.walls"].len() / (4 * layers);
    let step = PI / 2.0 / columns as f64;
    let arcs: f64 = 2.0 * columns as f64 * step.sin();
    let level = |j: usize| (0.5_f64.sqrt() * (2.0 * j as f64 / rows as f64 - 1.0)).asin();
    let walls: f64 = 2.0 * (0..rows).map(|j| (level(j + 1) - level(j)).sin()).sum::<f64>();
    let polygon = |radius: f64| 0.5 * radius * radius * (arcs + walls) * spec.length;
    let opening = groups["t.excavation"].volume;
    assert!((opening / polygon(4.5) - 1.0).abs() < 1e-12, "{opening} {}", polygon(4.5));
    let shell = groups["t.lining"].volume;
    assert!((shell / (polygon(4.9) - polygon(4.5)) - 1.0).abs() < 1e-12, "{shell}");
}

#[test]
fn benches_of_closed_outlines_are_cut_level_where_the_walls_are_divided() {
    for (name, spec) in blocks() {
        for c in spec.caverns.iter().filter(|c| c.shape.is_closed() && c.benches > 1) {
            let mesh = made(name, &spec);
            let [low, high] = Tube::new(c).wall();
            let floor = -spec.overburden - c.height;
            for bench in 1..c.benches {
                let cut = floor + high - f64::from(bench) * (high - low) / f64::from(c.benches);
                let levels = |bench: u32| -> Vec<f64> {
                    let elements = &mesh.groups[&format!("{}.bench{bench}", c.name)];
                    let nodes = elements.iter().flat_map(|&e| mesh.elements[e as usize].nodes());
                    nodes.map(|&n| mesh.nodes[n as usize][2]).collect()
                };
                assert!(levels(bench).iter().all(|&z| z > cut - 1e-9), "{name} {bench}");
                assert!(levels(bench + 1).iter().all(|&z| z < cut + 1e-9), "{name} {bench}");
            }
        }
    }
}
