//! Random descriptions that are legal by the word of their keys: a sound mesh, or a refusal that names a key.

use std::collections::HashMap;

use super::lengths::{extent, planes};
use super::{corners, is_union};
use crate::cavern::{Cavern, CavernShape, CavernSpec, Gallery, GroundSurface, Lining, RockLayer, Shotcrete};
use crate::coincident::coincident_nodes;
use crate::mesh::{Face, Mesh};
use crate::quality;

/// splitmix64 of Steele, Lea and Flood.
struct Dice(u64);

impl Dice {
    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Evenly between the two.
    fn real(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 / (1u64 << 53) as f64
    }

    fn below(&mut self, n: u64) -> u64 {
        self.bits() % n
    }

    fn often(&mut self, share: f64) -> bool {
        self.real(0.0, 1.0) < share
    }
}

fn cavern(dice: &mut Dice, k: usize, near: f64, x: f64) -> (Cavern, f64) {
    let shapes = [
        CavernShape::Arch,
        CavernShape::Ellipse,
        CavernShape::Rectangle,
        CavernShape::Horseshoe,
        CavernShape::Circle,
    ];
    let shape = shapes[dice.below(5) as usize];
    let width = near * dice.real(1.5, 12.0);
    let (height, arch_rise) = match shape {
        CavernShape::Circle => (width, 0.0),
        CavernShape::Horseshoe => (width * dice.real(0.75, 1.1), 0.0),
        CavernShape::Rectangle => (width * dice.real(0.4, 2.5), 0.0),
        CavernShape::Arch => {
            let rise = width * dice.real(0.02, 0.5);
            (rise + width * dice.real(0.3, 2.0), rise)
        }
        CavernShape::Ellipse => {
            let rise = width * dice.real(0.15, 1.0);
            (rise + width * dice.real(0.3, 2.0), rise)
        }
    };
    let lining = if dice.often(0.25) {
        Lining::NONE
    } else {
        // From thin to thick.
        let walls = near * dice.real(0.05, 0.8);
        let crown = walls * dice.real(0.7, 1.8);
        let floor = if shape.is_closed() || dice.often(0.5) { walls * dice.real(0.6, 1.6) } else { 0.0 };
        Lining { walls, crown, floor, layers: 1 + dice.below(4) as u32 }
    };
    // From a skin to as much as a lining.
    let shotcrete = if dice.often(0.6) {
        Shotcrete::NONE
    } else {
        Shotcrete { thickness: near * dice.real(0.01, 0.4), layers: 1 + dice.below(3) as u32 }
    };
    let half = 0.5 * width + lining.walls + shotcrete.thickness;
    let at = [x + half, if k == 0 { 0.0 } else { dice.real(-0.5, 0.5) * height }];
    let name = format!("c{k}");
    let benches = 1 + dice.below(5) as u32;
    let made =
        Cavern { name, shape, at, width, height, arch_rise, benches, lining, shotcrete, ..Cavern::default() };
    (made, x + 2.0 * half)
}

fn random(seed: u64) -> CavernSpec {
    let dice = &mut Dice(seed);
    let near = dice.real(0.8, 4.0);
    let mut caverns = Vec::new();
    let mut x = 0.0;
    for k in 0..1 + dice.below(3) as usize {
        let (made, end) = cavern(dice, k, near, x);
        caverns.push(made);
        x = end + near * dice.real(1.5, 12.0);
    }
    let highest = caverns.iter().map(|c: &Cavern| c.height).fold(0.0, f64::max);
    let depth = highest + near * dice.real(3.0, 20.0);
    let mut galleries = Vec::new();
    if caverns.len() > 1 && dice.often(0.5) {
        for g in 0..1 + dice.below(2) as usize {
            let pair = dice.below(caverns.len() as u64 - 1) as usize;
            let floor =
                if dice.often(0.3) { caverns[pair].at[1] } else { dice.real(0.0, 0.5) * caverns[0].height };
            galleries.push(Gallery {
                name: format!("g{g}"),
                between: [caverns[pair].name.clone(), caverns[pair + 1].name.clone()],
                at: [near * (5.0 * g as f64 - 2.0), floor],
                width: near * dice.real(0.5, 3.0),
                height: near * dice.real(0.5, 3.0),
            });
        }
    }
    let mut layers = Vec::new();
    if dice.often(0.4) {
        layers.push(RockLayer { name: "upper".to_owned(), ..RockLayer::default() });
        let depth = depth * dice.real(0.1, 1.2);
        let dip = if dice.often(0.5) { dice.real(0.0, 0.7) } else { 0.0 };
        layers.push(RockLayer { name: "lower".to_owned(), depth, dip, dip_direction: dice.real(-3.0, 3.0) });
    }
    let ground = match dice.below(4) {
        0 => GroundSurface::Inclined { x: dice.real(-0.3, 0.3), y: dice.real(-0.1, 0.1) },
        1 => GroundSurface::Table {
            x: vec![-30.0, 0.0, 40.0],
            y: vec![0.0],
            heights: (0..3).map(|_| dice.real(-4.0, 15.0)).collect(),
        },
        _ => GroundSurface::Level,
    };
    let mut spec = CavernSpec {
        overburden: depth,
        below: near * dice.real(3.0, 20.0),
        sides: near * dice.real(3.0, 20.0),
        length: near * if galleries.is_empty() { 4.0 } else { dice.real(14.0, 20.0) },
        near,
        far: if dice.often(0.2) { near } else { near * dice.real(1.0, 6.0) },
        along: dice.often(0.7).then(|| near * dice.real(1.0, 5.0)),
        caverns,
        layers,
        ground,
        galleries,
    };
    if dice.often(0.4) {
        spec.length = near * 30.0;
        for cavern in &mut spec.caverns {
            if dice.often(0.2) {
                continue;
            }
            cavern.length = Some(spec.length * dice.real(0.2, 0.6));
            cavern.middle = if dice.often(0.5) { 0.0 } else { spec.length * dice.real(-0.1, 0.1) };
        }
    }
    spec
}

/// Everything that [`CavernSpec::mesh`] promises of a mesh.
fn check(seed: u64, spec: &CavernSpec, mesh: &Mesh) {
    let whole = quality::summary(mesh);
    assert!(whole.min_scaled_jacobian >= 0.3 - 1e-9, "{seed}: {}", whole.min_scaled_jacobian);
    let groups = quality::by_group(mesh);
    for (group, summary) in groups.iter().filter(|(g, _)| g.contains("lining") || g.contains("shotcrete")) {
        assert!(summary.min_scaled_jacobian >= 0.6 - 1e-9, "{seed} {group}: {}", summary.min_scaled_jacobian);
    }
    let tolerance = 1e-6 * whole.shortest_edge;
    assert!(coincident_nodes(mesh, tolerance).is_empty(), "{seed}: duplicate nodes");

    // Face to face: each inner face twice, each outer one in one set.
    let mut owners: HashMap<[u32; 4], usize> = HashMap::new();
    for element in 0..mesh.elements.len() as u32 {
        for side in 0..6 {
            *owners.entry(corners(mesh, Face { element, side })).or_default() += 1;
        }
    }
    assert!(owners.values().all(|n| *n <= 2), "{seed}");
    let sets = ["xmin", "xmax", "ymin", "ymax", "base", "top"];
    let outer: Vec<[u32; 4]> = sets.iter().flat_map(|s| &mesh.faces[*s]).map(|f| corners(mesh, *f)).collect();
    assert!(outer.iter().all(|key| owners[key] == 1), "{seed}");
    assert_eq!(outer.len(), owners.values().filter(|n| **n == 1).count(), "{seed}");

    // The block's volume, and that of its parts; under level ground exact.
    let parts: f64 =
        groups.iter().filter(|(g, _)| !is_union(g) && !g.starts_with("rock.")).map(|(_, s)| s.volume).sum();
    assert!((parts / whole.volume - 1.0).abs() < 1e-9, "{seed}: {parts} {}", whole.volume);
    if spec.ground == GroundSurface::Level {
        let (low, high) = mesh.bounds();
        let block: f64 = (0..3).map(|c| high[c] - low[c]).product();
        assert!((whole.volume / block - 1.0).abs() < 1e-9, "{seed}: {} {block}", whole.volume);
        assert!(high[2] == 0.0 && (high[1] - low[1] - spec.length).abs() < 1e-9 * spec.length, "{seed}");
    }

    // All groups, and galleries as large as they should be.
    let mut wanted = vec!["rock".to_owned()];
    for c in &spec.caverns {
        wanted.extend((1..=c.benches).map(|bench| format!("{}.bench{bench}", c.name)));
        wanted.push(format!("{}.excavation", c.name));
        assert!(!mesh.faces[&format!("{}.intrados", c.name)].is_empty(), "{seed}");
        if c.shotcrete != Shotcrete::NONE {
            wanted.push(format!("{}.shotcrete", c.name));
            wanted.extend((1..=c.benches).map(|bench| format!("{}.shotcrete{bench}", c.name)));
        }
        if c.lining != Lining::NONE {
            wanted.extend(["", ".crown", ".walls"].map(|part| format!("{}.lining{part}", c.name)));
            assert!(!mesh.faces[&format!("{}.extrados", c.name)].is_empty(), "{seed}");
            if c.lining.floor > 0.0 {
                wanted.push(format!("{}.lining.floor", c.name));
            }
        }
    }
    for (c, length) in spec.caverns.iter().filter_map(|c| Some((c, c.length?))) {
        let [from, to] = extent(mesh, &format!("{}.excavation", c.name));
        let exact = [c.middle - 0.5 * length, c.middle + 0.5 * length];
        assert!(
            (from - exact[0]).abs() < 1e-9 && (to - exact[1]).abs() < 1e-9,
            "{seed}: {from} {to} {exact:?}"
        );
        assert!(!mesh.faces[&format!("{}.ends", c.name)].is_empty(), "{seed}");
        let planes = planes(mesh);
        let sizes: Vec<f64> = planes.windows(2).map(|p| p[1] - p[0]).collect();
        let worst = sizes.windows(2).map(|p| (p[0] / p[1]).max(p[1] / p[0])).fold(1.0, f64::max);
        assert!(worst <= 1.3, "{seed}: {worst} {sizes:?}");
    }
    wanted.extend(spec.galleries.iter().map(|g| format!("{}.gallery", g.name)));
    for group in wanted {
        assert!(mesh.groups.get(&group).is_some_and(|list| !list.is_empty()), "{seed}: no {group}");
    }
    for g in &spec.galleries {
        let [a, b] = g.between.each_ref().map(|name| spec.caverns.iter().find(|c| c.name == *name).unwrap());
        let half = |c: &Cavern| 0.5 * c.width + c.lining.walls + c.shotcrete.thickness;
        let exact = ((b.at[0] - a.at[0]).abs() - half(a) - half(b)) * g.width * g.height;
        let volume = groups[format!("{}.gallery", g.name).as_str()].volume;
        assert!((volume / exact - 1.0).abs() < 1e-6, "{seed} {}: {volume} {exact}", g.name);
        assert!(!mesh.faces[&format!("{}.surface", g.name)].is_empty(), "{seed}");
    }
}

#[test]
fn a_legal_description_gives_a_sound_mesh_or_a_refusal_that_names_a_key() {
    sound_or_refused((0..75).map(|k| 2 * k));
}

#[test]
fn further_legal_descriptions_give_a_sound_mesh_or_a_refusal_that_names_a_key() {
    sound_or_refused((0..75).map(|k| 2 * k + 1));
}

fn sound_or_refused(seeds: impl Iterator<Item = u64>) {
    let keys = [
        "size_near",
        "size_far",
        "between",
        "size_along",
        "overburden",
        "below",
        "sides",
        "`at`",
        ".at",
        "height",
        "width",
        "benches",
        "arch_rise",
        "lining.",
        "ground",
        ".length",
        ".middle",
        "table of heights",
    ];
    let (mut made, mut refused) = (0, Vec::new());

    for seed in seeds {
        let spec = random(seed);
        match spec.mesh() {
            Ok(mesh) => {
                check(seed, &spec, &mesh);
                made += 1;
            }
            Err(error) => {
                let text = error.to_string();
                assert!(keys.iter().any(|key| text.contains(key)), "{seed}: {text}");
                refused.push(text);
            }
        }
    }
    // Most are meshed; among the rest are galleries between circles, or beside a wall.
    assert!(made > refused.len(), "{made} made, {refused:#?}");
}
