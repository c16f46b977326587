use std::collections::{BTreeSet, HashMap};

use super::blocks::blocks;
use super::{corners, made};
use crate::mesh::Face;

#[test]
fn shotcrete_lies_between_lining_and_rock_and_is_a_group_beside_each_bench() {
    let mut between = 0;
    for (name, spec) in blocks() {
        let mesh = made(name, &spec);
        let mut at: HashMap<[u32; 4], Vec<u32>> = HashMap::new();
        for element in 0..mesh.elements.len() as u32 {
            for side in 0..6 {
                at.entry(corners(&mesh, Face { element, side })).or_default().push(element);
            }
        }
        for c in &spec.caverns {
            let group = |of: &str| -> BTreeSet<u32> {
                mesh.groups.get(&format!("{}.{of}", c.name)).into_iter().flatten().copied().collect()
            };
            let sprayed = group("shotcrete");
            assert_eq!(sprayed.is_empty(), c.shotcrete.is_none(), "{name} {}", c.name);
            if c.shotcrete.is_none() {
                continue;
            }
            let parts: Vec<BTreeSet<u32>> =
                (1..=c.benches).map(|k| group(&format!("shotcrete{k}"))).collect();
            assert!(parts.iter().all(|part| !part.is_empty()), "{name} {}", c.name);
            assert_eq!(parts.iter().map(BTreeSet::len).sum::<usize>(), sprayed.len(), "{name} {}", c.name);
            assert_eq!(parts.into_iter().flatten().collect::<BTreeSet<_>>(), sprayed, "{name} {}", c.name);
            // Every face of the rock's that walls and crown would have is the shotcrete's; feet of walls stand on rock.
            let rock: BTreeSet<u32> = mesh.groups["rock"].iter().copied().collect();
            let vault = group("lining.crown").into_iter().chain(group("lining.walls"));
            for e in vault {
                for side in [0, 1, 4, 5] {
                    let face = Face { element: e, side };
                    let key = corners(&mesh, face);
                    let level = key.map(|n| mesh.nodes[n as usize][2]);
                    let foot = level.iter().all(|z| (z - level[0]).abs() < 1e-9);
                    let on_rock = at[&key].iter().any(|other| rock.contains(other));
                    assert!(!on_rock || foot, "{name} {}", c.name);
                    between += usize::from(at[&key].iter().any(|other| sprayed.contains(other)));
                }
            }
        }
    }
    assert!(between > 100, "{between}");
}
