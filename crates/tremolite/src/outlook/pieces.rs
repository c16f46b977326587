//! Pieces of what stands that nothing holds up.

use super::pulls::{Pull, pulls_of};
use super::smallest_groups;
use std::collections::{BTreeMap, BTreeSet};
use tremolite_engine::hexahedra::hex;
use tremolite_engine::{Model, Phase};

/// What holds a piece that is not joined to what is held.
#[derive(Clone, Debug, PartialEq)]
pub enum Hold {
    /// Nothing: it comes down.
    Nothing,
    /// Bond and friction of these interfaces, none of which it rests on, and these groups of bolts, which at their strength lift this
    /// share of its weight: less than all.
    Hangs { interfaces: Vec<String>, bolts: Vec<String>, lifted: f64 },
}

/// Connected elements that neither the base nor a fixed side holds up.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// The smallest group of most of its elements.
    pub group: String,
    /// Ascending, by their numbers in the mesh.
    pub elements: Vec<u32>,
    /// m³
    pub volume: f64,
    /// Smallest and largest coordinates \[m\].
    pub bounds: ([f64; 3], [f64; 3]),
    pub held: Hold,
}

/// Share of the area of a piece's interfaces that faces up into it from below, from which on it rests there: more than
/// round-off of what is vertical.
const RESTS: f64 = 1e-6;

/// Two pieces with pairs of an interface between them.
#[derive(Default)]
struct Contact {
    interfaces: BTreeSet<usize>,
    /// m², and of it what carries the first on the second, and the second on the first.
    area: f64,
    first_rests: f64,
    second_rests: f64,
}

/// Pieces that stand in a phase and are not held up: joined through shared or tied nodes to the base or a side that is fixed.
/// What rests on a piece that is held up, through an interface, is so too, and so is what bolts carry at their strength.
pub(super) fn pieces(model: &Model, phase: &Phase, standing: &[u32]) -> Vec<Piece> {
    let mut parent: Vec<u32> = (0..phase.master.len() as u32).collect();
    let of = |node: u32| phase.master[model.engine_node[node as usize] as usize];
    for &e in standing {
        let nodes = model.mesh.elements[e as usize].nodes();
        for &node in &nodes[1..] {
            let (a, b) = (root(&mut parent, of(nodes[0])), root(&mut parent, of(node)));
            parent[a.max(b) as usize] = a.min(b);
        }
    }
    let mut parts: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    for &e in standing {
        let piece = root(&mut parent, of(model.mesh.elements[e as usize].nodes()[0]));
        parts.entry(piece).or_default().push(e);
    }
    let mut held: BTreeSet<u32> = BTreeSet::new();
    for n in 0..phase.master.len() as u32 {
        let master = phase.master[n as usize] as usize;
        if phase.mass[master] > 0.0 && phase.inverse_mass[master].0[2] == 0.0 {
            held.insert(root(&mut parent, master as u32));
        }
    }
    if parts.keys().all(|piece| held.contains(piece)) {
        return Vec::new();
    }
    let mut contacts: BTreeMap<[u32; 2], Contact> = BTreeMap::new();
    for (i, seam) in model.user_seams().iter().enumerate() {
        for (pair, life) in seam.pairs.iter().zip(&seam.lives) {
            let [a, b] = pair.nodes.map(|node| root(&mut parent, of(node)));
            if a == b || !life.holds(phase.stage) {
                continue;
            }
            let contact = contacts.entry([a, b]).or_default();
            contact.interfaces.insert(i);
            contact.area += pair.area;
            // The normal points out of the first into the second: where it points up the second rests on the first.
            contact.second_rests += pair.area * pair.normal[2].max(0.0);
            contact.first_rests += pair.area * (-pair.normal[2]).max(0.0);
        }
    }
    loop {
        let before = held.len();
        for ([a, b], contact) in &contacts {
            let least = RESTS * contact.area;
            if held.contains(b) && contact.first_rests > least {
                held.insert(*a);
            }
            if held.contains(a) && contact.second_rests > least {
                held.insert(*b);
            }
        }
        if held.len() == before {
            break;
        }
    }
    let smallest = smallest_groups(model);
    let piece_of = |element: u32, parent: &mut Vec<u32>| {
        root(parent, of(model.mesh.elements[element as usize].nodes()[0]))
    };
    let mut pulls: BTreeMap<u32, BTreeMap<usize, f64>> = BTreeMap::new();
    for (s, set) in model.bolts.iter().enumerate().filter(|(_, set)| set.kind.born <= phase.stage) {
        for bolt in &set.bolts {
            for Pull { hangs, upwards } in
                pulls_of(set, bolt, phase.stage, &held, |e| piece_of(e, &mut parent))
            {
                *pulls.entry(hangs).or_default().entry(s).or_default() += upwards;
            }
        }
    }
    parts
        .into_iter()
        .filter(|(piece, _)| !held.contains(piece))
        .filter_map(|(piece, elements)| {
            let bolts = pulls.remove(&piece).unwrap_or_default();
            let lifted = bolts.values().sum::<f64>() / weight(model, &elements);
            if lifted >= 1.0 {
                return None;
            }
            let bolts: Vec<String> = bolts.into_keys().map(|s| model.bolts[s].kind.name.clone()).collect();
            let touching = contacts.iter().filter(|(sides, _)| sides.contains(&piece));
            let interfaces: BTreeSet<usize> =
                touching.flat_map(|(_, contact)| contact.interfaces.iter().copied()).collect();
            let names = interfaces.into_iter().map(|i| model.seams[i].name.clone()).collect::<Vec<_>>();
            let held = match names.is_empty() && bolts.is_empty() {
                true => Hold::Nothing,
                false => Hold::Hangs { interfaces: names, bolts, lifted },
            };
            Some(describe(model, &smallest, elements, held))
        })
        .collect()
}

/// N
fn weight(model: &Model, elements: &[u32]) -> f64 {
    let of = |&e: &u32| {
        let body = model.elements.body_of[e as usize]?;
        Some(hex(&model.mesh, e as usize).ok()?.volume * model.bodies[body].density * model.loading.gravity)
    };
    elements.iter().filter_map(of).sum()
}

fn describe(model: &Model, smallest: &[&str], elements: Vec<u32>, held: Hold) -> Piece {
    let mut groups: BTreeMap<&str, usize> = BTreeMap::new();
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    let mut volume = 0.0;
    for &e in &elements {
        *groups.entry(smallest[e as usize]).or_default() += 1;
        // The model has checked every element.
        volume += hex(&model.mesh, e as usize).map_or(0.0, |hex| hex.volume);
        for &node in model.mesh.elements[e as usize].nodes() {
            for (i, x) in model.mesh.nodes[node as usize].into_iter().enumerate() {
                (low[i], high[i]) = (low[i].min(x), high[i].max(x));
            }
        }
    }
    let most = groups.into_iter().max_by_key(|(name, count)| (*count, std::cmp::Reverse(*name)));
    let group = most.map_or(String::new(), |(name, _)| name.to_owned());
    Piece { group, elements, volume, bounds: (low, high), held }
}

/// The root of a node's tree, halving the path on the way.
fn root(parent: &mut [u32], mut node: u32) -> u32 {
    while parent[node as usize] != node {
        parent[node as usize] = parent[parent[node as usize] as usize];
        node = parent[node as usize];
    }
    node
}

#[cfg(test)]
mod tests {
    use super::*;
    use tremolite_engine::hexahedra::centroid;
    use tremolite_engine::{
        Assembly, Bar, Base, Body, Bolts, Bond, Interface, Problem, Quadrature, Stage, elastic,
    };
    use tremolite_laws::{Moduli, Values};
    use tremolite_mesh::boxes::BoxSpec;

    /// A block of 2 × 4 × 2 m, 424 kN, in the roof of a drift of 2 m, cut off by an interface all round, with bolts of 200 kN that
    /// go 1.5 m into the rock above.
    fn hanging(count: usize, bond: Option<f64>) -> Option<Hold> {
        let mesh = BoxSpec::uniform([0.0; 3], [4.0, 4.0, 6.0], [4, 4, 6]).mesh().unwrap();
        let part = |e: &u32| {
            let [x, _, z] = centroid(&mesh, *e);
            match (1.0..3.0).contains(&x) {
                true if z < 2.0 => 0,
                true if z < 4.0 => 1,
                _ => 2,
            }
        };
        let of =
            |wanted: i32| (0..mesh.elements.len() as u32).filter(|e| part(e) == wanted).collect::<Vec<u32>>();
        let body = |name: &str, elements: Vec<u32>| Body {
            name: name.into(),
            elements,
            material: elastic(Moduli::from_young_poisson(1e10, 0.25)),
            density: 2700.0,
            quadrature: Quadrature::OnePoint,
            viscosity: 0.0,
        };
        let (block, rock) = (of(1), of(2));
        let coulomb =
            tremolite_kernels::interface_laws().into_iter().find(|l| l.info.name == "coulomb").unwrap();
        let values = Values::default()
            .with("normal_stiffness", 1e10)
            .with("cohesion", 1e5)
            .with("friction_coefficient", 0.5);
        let cut = Interface::new("cut", [block.clone(), rock.clone()], coulomb, values);
        let bar = |k: usize| Bar {
            points: vec![[2.0, 0.6 + k as f64, 2.0], [2.0, 0.6 + k as f64, 5.5]],
            areas: vec![5e-4],
        };
        let mut problem = Problem::new(mesh, vec![body("block", block), body("rock", rock)]);
        problem.interfaces = vec![cut];
        problem.base = Base::Fixed;
        problem.gravity = 9.81;
        problem.bolts = vec![Bolts {
            name: "anchors".into(),
            bars: (0..count).map(bar).collect(),
            young: 2e11,
            yields: 4e8,
            breaks: f64::INFINITY,
            bond: bond.map(|strength| Bond {
                stiffness: 1e9,
                strength,
                friction: 0.0,
                perimeter: 0.1,
                segment: 0.5,
            }),
            pretension: 0.0,
            free_length: 0.0,
            plates: [true, false],
            born: Stage::Before(0),
        }];
        let model = Model::new(problem).unwrap();
        let assembly = Assembly::new(&model).unwrap();
        let stage = Stage::Before(0);
        let phase = Phase::of(&model, &assembly, stage).unwrap();
        let found = pieces(&model, &phase, &model.standing(stage));
        assert!(found.len() <= 1, "{found:?}");
        found.into_iter().next().map(|piece| piece.held)
    }

    #[test]
    fn a_block_that_anchors_carry_does_not_hang_by_its_joint() {
        let cut = vec!["cut".to_owned()];
        let alone = Hold::Hangs { interfaces: cut.clone(), bolts: Vec::new(), lifted: 0.0 };
        assert_eq!(hanging(0, None), Some(alone));
        assert_eq!(hanging(3, None), None);
        let lifted = |held: Option<Hold>| match held {
            Some(Hold::Hangs { interfaces, bolts, lifted }) => {
                assert_eq!((interfaces, bolts), (cut.clone(), vec!["anchors".to_owned()]));
                lifted
            }
            other => panic!("{other:?}"),
        };
        let weight = 16.0 * 2700.0 * 9.81;
        assert!((lifted(hanging(1, None)) - 200e3 / weight).abs() < 1e-9);
        // 1.5 m of bond above, at 60 kN/m.
        assert!((lifted(hanging(3, Some(60e3))) - 3.0 * 90e3 / weight).abs() < 1e-9);
        assert_eq!(hanging(3, Some(1e6)), None);
    }
}
