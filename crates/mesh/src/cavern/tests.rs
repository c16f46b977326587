use std::collections::{BTreeSet, HashMap};

use super::CavernSpec;
use crate::mesh::{Face, Mesh};
use crate::quality;

mod blocks;
mod galleries;
mod growth;
mod lengths;
mod random;
mod refusals;
mod rock;
mod shotcrete;
mod volumes;

use blocks::{block, blocks, cavern, lining};

fn made(name: &str, spec: &CavernSpec) -> Mesh {
    spec.mesh().unwrap_or_else(|e| panic!("{name}: {e}"))
}

fn corners(mesh: &Mesh, face: Face) -> [u32; 4] {
    let mut nodes: Vec<u32> = mesh.face_nodes(face).collect();
    nodes.sort_unstable();
    [nodes[0], nodes[1], nodes[2], nodes[3]]
}

/// Nodes of a face set without their coordinate along `axis`, as bits.
fn outline(mesh: &Mesh, set: &str, axis: usize) -> BTreeSet<[u64; 2]> {
    let nodes = mesh.faces[set].iter().flat_map(|&f| mesh.face_nodes(f));
    nodes
        .map(|n| {
            let x = mesh.nodes[n as usize];
            [x[(axis + 1) % 3].to_bits(), x[(axis + 2) % 3].to_bits()]
        })
        .collect()
}

#[test]
fn every_inner_face_belongs_to_two_elements_and_every_outer_one_to_a_set() {
    for (name, spec) in blocks() {
        let mesh = made(name, &spec);
        let mut owners: HashMap<[u32; 4], Vec<Face>> = HashMap::new();
        for element in 0..mesh.elements.len() as u32 {
            for side in 0..6 {
                let face = Face { element, side };
                owners.entry(corners(&mesh, face)).or_default().push(face);
            }
        }
        assert!(owners.values().all(|o| o.len() <= 2), "{name}");
        let outer: BTreeSet<Face> = owners.values().filter(|o| o.len() == 1).map(|o| o[0]).collect();
        let sets = ["xmin", "xmax", "ymin", "ymax", "base", "top"];
        let listed: Vec<Face> = sets.iter().flat_map(|s| mesh.faces[*s].iter().copied()).collect();
        assert_eq!(listed.len(), outer.len(), "{name}");
        assert_eq!(listed.into_iter().collect::<BTreeSet<_>>(), outer, "{name}");
        // A crack between two nodes at one place would leave outer faces inside the block.
        let used: BTreeSet<u32> = mesh.elements.iter().flat_map(|e| e.nodes().to_vec()).collect();
        assert_eq!(used.len(), mesh.nodes.len(), "{name}");
    }
}

#[test]
fn no_element_is_badly_shaped() {
    for (name, spec) in blocks() {
        let mesh = made(name, &spec);
        let all = quality::summary(&mesh);
        assert!(all.min_scaled_jacobian >= 0.3, "{name}: {}", all.min_scaled_jacobian);
        for (group, summary) in
            quality::by_group(&mesh).iter().filter(|(g, _)| g.contains("lining") || g.contains("shotcrete"))
        {
            assert!(summary.min_scaled_jacobian >= 0.6, "{name} {group}: {}", summary.min_scaled_jacobian);
        }
    }
}

#[test]
fn opposite_sides_match_node_by_node() {
    for (name, spec) in blocks() {
        let mesh = made(name, &spec);
        assert_eq!(outline(&mesh, "xmin", 0), outline(&mesh, "xmax", 0), "{name}");
        assert_eq!(outline(&mesh, "ymin", 1), outline(&mesh, "ymax", 1), "{name}");
        assert_eq!(mesh.faces["xmin"].len(), mesh.faces["xmax"].len(), "{name}");
        assert_eq!(mesh.faces["ymin"].len(), mesh.faces["ymax"].len(), "{name}");
        assert!(mesh.nodes.iter().any(|x| x[1] == 0.0), "{name}");
    }
}

/// Whether a cavern's group repeats elements of its parts: all its lining, that or the shotcrete beside a bench, or its whole
/// opening.
fn is_union(group: &str) -> bool {
    let lining = group.trim_end_matches(|c: char| c.is_ascii_digit());
    lining.ends_with(".lining")
        || lining.ends_with(".shotcrete") && lining != group
        || group.ends_with(".excavation")
}

#[test]
fn the_parts_tile_the_block() {
    for (name, spec) in blocks() {
        let mesh = made(name, &spec);
        let mut times = vec![0; mesh.elements.len()];
        for (group, list) in &mesh.groups {
            assert!(list.windows(2).all(|p| p[0] < p[1]), "{name} {group}");
            if !is_union(group) {
                list.iter().for_each(|&e| times[e as usize] += 1);
            }
        }
        assert!(times.iter().all(|&t| t == 1), "{name}");
    }
}

#[test]
fn the_lining_beside_each_bench_is_a_group_and_they_make_up_the_lining() {
    for (name, spec) in blocks() {
        let mesh = made(name, &spec);
        let mut at: HashMap<[u32; 4], Vec<u32>> = HashMap::new();
        for element in 0..mesh.elements.len() as u32 {
            for side in 0..6 {
                at.entry(corners(&mesh, Face { element, side })).or_default().push(element);
            }
        }
        for c in &spec.caverns {
            let groups: Vec<&Vec<u32>> =
                (1..).map_while(|k| mesh.groups.get(&format!("{}.lining{k}", c.name))).collect();
            if c.lining.is_none() {
                assert!(
                    groups.is_empty() && !mesh.groups.contains_key(&format!("{}.lining", c.name)),
                    "{name}"
                );
                continue;
            }
            assert_eq!(groups.len(), c.benches as usize, "{name} {}", c.name);
            let mut all: Vec<u32> = groups.iter().flat_map(|g| g.iter().copied()).collect();
            all.sort_unstable();
            assert_eq!(all, mesh.groups[&format!("{}.lining", c.name)], "{name} {}", c.name);
            let holds = |group: &str, e: u32| {
                mesh.groups.get(&format!("{}.{group}", c.name)).is_some_and(|g| g.binary_search(&e).is_ok())
            };
            for (number, group) in (1..=c.benches).zip(&groups) {
                // All layers go with the first; under the walls a slab goes farther than the intrados.
                if c.lining.floor == 0.0 && spec.galleries.is_empty() {
                    let intrados = &mesh.faces[&format!("{}.intrados", c.name)];
                    let first = intrados.iter().filter(|f| group.contains(&f.element)).count();
                    assert_eq!(group.len(), first * c.lining.layers as usize, "{name} {number}");
                }
                for &e in group.iter() {
                    assert!(number == 1 || !holds("lining.crown", e), "{name} {number}");
                    assert!(number == c.benches || !holds("lining.floor", e), "{name} {number}");
                    for side in 0..6 {
                        for &other in &at[&corners(&mesh, Face { element: e, side })] {
                            let bench = (1..=c.benches).find(|b| holds(&format!("bench{b}"), other));
                            assert!(bench.is_none_or(|b| b == number), "{name} {number}");
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn the_lining_s_faces_are_intrados_and_extrados_and_look_outwards() {
    for (name, spec) in blocks().into_iter().filter(|(_, spec)| spec.galleries.is_empty()) {
        let mesh = made(name, &spec);
        for c in spec.caverns.iter().filter(|c| !c.lining.is_none()) {
            let lining: BTreeSet<u32> = mesh.groups[&format!("{}.lining", c.name)].iter().copied().collect();
            let mut count: HashMap<[u32; 4], (usize, Face)> = HashMap::new();
            for &element in &lining {
                for side in 0..6 {
                    let face = Face { element, side };
                    count.entry(corners(&mesh, face)).or_insert((0, face)).0 += 1;
                }
            }
            let mut skin: BTreeSet<Face> = count.values().filter(|c| c.0 == 1).map(|c| c.1).collect();
            ["ymin", "ymax"].iter().flat_map(|s| &mesh.faces[*s]).for_each(|face| _ = skin.remove(face));
            let (inner, outer) =
                (&mesh.faces[&format!("{}.intrados", c.name)], &mesh.faces[&format!("{}.extrados", c.name)]);
            assert_eq!(inner.iter().chain(outer).copied().collect::<BTreeSet<_>>(), skin, "{name}");
            assert_eq!(inner.len() + outer.len(), skin.len(), "{name}");
            let x0 = c.at[0] - spec.caverns[0].at[0];
            let middle = c.at[1] - spec.overburden - spec.caverns[0].height + c.height / 2.0;
            // From the middle of the opening the intrados is seen from its front, the crown of the extrados
            // from its back.
            for (set, sign) in [(inner, -1.0), (outer, 1.0)] {
                // The ends of a lining that stops in rock look along y.
                for &face in set.iter().filter(|f| !matches!(f.side, 2 | 3)) {
                    let p: Vec<[f64; 3]> = mesh.face_nodes(face).map(|n| mesh.nodes[n as usize]).collect();
                    let centre: [f64; 3] = std::array::from_fn(|i| p.iter().map(|q| q[i]).sum::<f64>() / 4.0);
                    let d: [[f64; 3]; 2] = [0, 1].map(|k| std::array::from_fn(|i| p[k + 2][i] - p[k][i]));
                    let normal = [
                        d[0][1] * d[1][2] - d[0][2] * d[1][1],
                        d[0][2] * d[1][0] - d[0][0] * d[1][2],
                        d[0][0] * d[1][1] - d[0][1] * d[1][0],
                    ];
                    let away = normal[0] * (centre[0] - x0) + normal[2] * (centre[2] - middle);
                    assert!(sign * away > 0.0, "{name} {centre:?} {normal:?}");
                }
            }
        }
    }
}

#[test]
fn named_points_lie_on_the_intrados() {
    let spec = CavernSpec::yingxiuwan();
    let mesh = made("yingxiuwan", &spec);
    let exact = [
        ("powerhouse.crown", [0.0, 0.0, -200.0]),
        ("powerhouse.floor", [0.0, 0.0, -237.2]),
        ("powerhouse.wall.left", [-8.5, 0.0, -218.6]),
        ("powerhouse.wall.right", [8.5, 0.0, -218.6]),
        ("transformer.crown", [33.0, 0.0, -209.3]),
        ("transformer.floor", [33.0, 0.0, -237.2]),
        ("transformer.wall.left", [29.4, 0.0, -223.25]),
        ("transformer.wall.right", [36.6, 0.0, -223.25]),
    ];
    assert_eq!(mesh.points.len(), exact.len());
    for (name, x) in exact {
        let p = mesh.points[name];
        assert!((0..3).all(|i| (p[i] - x[i]).abs() < 1e-9), "{name} {p:?}");
    }
    // The crowns and floors are nodes, the walls' points lie between the intrados' nodes.
    let distance = |x: [f64; 3], n: u32| -> f64 {
        let y = mesh.nodes[n as usize];
        (0..3).map(|i| (x[i] - y[i]).powi(2)).sum::<f64>().sqrt()
    };
    for c in ["powerhouse", "transformer"] {
        let nodes: Vec<u32> =
            mesh.faces[&format!("{c}.intrados")].iter().flat_map(|&f| mesh.face_nodes(f)).collect();
        let crown = mesh.points[&format!("{c}.crown")];
        assert!(nodes.iter().any(|&n| distance(crown, n) < 1e-9));
        let wall = mesh.points[&format!("{c}.wall.left")];
        let same = |n: &&u32| {
            let x = mesh.nodes[**n as usize];
            (x[0] - wall[0]).abs() < 1e-9 && x[1] == 0.0
        };
        let levels: Vec<f64> = nodes.iter().filter(same).map(|&n| mesh.nodes[n as usize][2]).collect();
        assert!(levels.iter().any(|&z| z < wall[2]) && levels.iter().any(|&z| z > wall[2]));
    }
}

#[test]
fn the_fine_yingxiuwan_is_as_large_as_the_paper_s_mesh() {
    let mesh = made("fine", &CavernSpec::yingxiuwan_fine());
    assert!((mesh.elements.len() as f64 / 97_652.0 - 1.0).abs() < 0.02, "{}", mesh.elements.len());
    let lining: usize =
        ["powerhouse", "transformer"].iter().map(|c| mesh.groups[&format!("{c}.lining")].len()).sum();
    assert!((lining as f64 / 7_300.0 - 1.0).abs() < 0.02, "{lining}");
    let groups = quality::by_group(&mesh);
    assert!(quality::summary(&mesh).min_scaled_jacobian > 0.5);
    assert!(groups["transformer.lining"].min_scaled_jacobian > 0.8);
}

#[test]
fn sizes_in_the_grid_grow_slowly() {
    // A gallery's floor and roof are transitions.
    for (name, spec) in blocks().into_iter().filter(|(_, spec)| spec.galleries.is_empty()) {
        sizes_grow_slowly(name, &spec);
    }
}

fn sizes_grow_slowly(name: &str, spec: &CavernSpec) {
    let mesh = made(name, spec);
    for (set, axis) in [("top", 0), ("xmin", 2)] {
        let mut line: Vec<f64> = mesh.faces[set]
            .iter()
            .flat_map(|&f| mesh.face_nodes(f))
            .map(|n| mesh.nodes[n as usize][axis])
            .collect();
        line.sort_by(f64::total_cmp);
        line.dedup();
        let sizes: Vec<f64> = line.windows(2).map(|p| p[1] - p[0]).collect();
        assert!(sizes.iter().all(|&s| s <= spec.far * (1.0 + 1e-9)), "{name}: {sizes:?}");
        for pair in sizes.windows(2) {
            assert!((pair[0] / pair[1]).max(pair[1] / pair[0]) <= 1.3 + 1e-9, "{name}: {sizes:?}");
        }
    }
}

#[test]
fn the_coarse_yingxiuwan_is_cheap_to_run() {
    let mesh = made("yingxiuwan", &CavernSpec::yingxiuwan());
    assert!((7800..8400).contains(&mesh.elements.len()), "{}", mesh.elements.len());
    // The lining's thickness is the smallest length, so that it alone sets the time step.
    assert!(quality::summary(&mesh).shortest_edge > 0.5 - 1e-9);
}

#[test]
fn a_symmetric_cavern_has_a_symmetric_mesh() {
    let mesh = made(
        "alone",
        &block(1.2, vec![cavern("t", [12.0, 18.0, 4.0], 3, [0.0; 2], lining(0.5, 0.8, 0.0, 1))]),
    );
    let key = |x: f64, z: f64| ((x * 1e4).round() as i64, (z * 1e4).round() as i64);
    let plane: Vec<[f64; 3]> = mesh.nodes.iter().filter(|x| x[1] == 0.0).copied().collect();
    let near: BTreeSet<(i64, i64)> = plane
        .iter()
        .flat_map(|x| {
            let (i, k) = key(x[0], x[2]);
            (-1..=1).flat_map(move |a| (-1..=1).map(move |b| (i + a, k + b)))
        })
        .collect();
    for x in &plane {
        assert!(near.contains(&key(-x[0], x[2])), "{x:?}");
    }
}
