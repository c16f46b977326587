//! What the parts of the view are called, and which of them are linings.

use tremolite_results::Summary;
use tremolite_results::hexahedron::volume;

use super::manifest::PartKind;
use super::part::Part;
use crate::language::{Language, say};

/// The name of each body: the smallest group that holds all of it. Where none does, a body goes by the groups within it
/// that together do, the largest first.
pub fn bodies(language: Language, parts: &[Part]) -> Vec<String> {
    // A group may reach over bodies: its size is that of all its cells.
    let total = |name: &str| -> usize {
        let own = parts.iter().flat_map(|part| &part.groups).filter(|(known, _)| known == name);
        own.map(|(_, inside)| Part::size(inside)).sum()
    };
    let name = |part: &Part| {
        let count = part.mesh.elements.len();
        let whole = part.groups.iter().filter(|(_, inside)| Part::size(inside) == count);
        if let Some((name, _)) = whole.min_by_key(|(name, _)| total(name)) {
            return name.clone();
        }
        let mut covering = covering(part);
        match covering.len() {
            0 => say!(language, "body {number}", number = part.owner),
            1 | 2 => covering.join(", "),
            number => {
                say!(
                    language,
                    "{name} and {number} more groups",
                    name = covering.remove(0),
                    number = number - 1
                )
            }
        }
    };
    parts.iter().map(name).collect()
}

/// Names of groups that together hold a part: each time that which adds most.
fn covering(part: &Part) -> Vec<String> {
    let mut open = vec![true; part.mesh.elements.len()];
    let mut names = Vec::new();
    loop {
        let adds =
            |inside: &[bool]| inside.iter().zip(&open).filter(|(inside, open)| **inside && **open).count();
        // Of equals the first.
        let best = part.groups.iter().rev().max_by_key(|(_, inside)| adds(inside));
        let Some((name, inside)) = best.filter(|(_, inside)| adds(inside) > 0) else { return names };
        names.push(name.clone());
        inside.iter().zip(&mut open).for_each(|(inside, open)| *open &= !inside);
    }
}

/// Which bodies are linings. The largest body is the ground. Of the others one is a lining if it holds the whole of a group of
/// which section forces were taken (`linings`, of sections.csv), or whose law knows cracks (in the summary). What neither
/// file says anything of is ground as well.
pub fn kinds(parts: &[Part], linings: &[&str], summary: &Summary) -> Vec<PartKind> {
    let volumes: Vec<f64> = parts.iter().map(total_volume).collect();
    let largest = (0..parts.len()).max_by(|&a, &b| volumes[a].total_cmp(&volumes[b]));
    let cracks = |name: &str| summary.parts.damage.get(name).is_some_and(|damage| damage.cracks.is_some());
    let elsewhere = |name: &str, own: usize| {
        let others = parts.iter().enumerate().filter(|(k, _)| *k != own);
        others.flat_map(|(_, part)| &part.groups).any(|(known, _)| known == name)
    };
    let lining = |k: usize| {
        parts[k]
            .groups
            .iter()
            .any(|(name, _)| (linings.contains(&name.as_str()) || cracks(name)) && !elsewhere(name, k))
    };
    let kind = |k| if Some(k) != largest && lining(k) { PartKind::Lining } else { PartKind::Rock };
    (0..parts.len()).map(kind).collect()
}

fn total_volume(part: &Part) -> f64 {
    let mesh = &part.mesh;
    let corners = |cell: usize| std::array::from_fn(|k| mesh.points[mesh.cell(cell)[k] as usize]);
    (0..mesh.elements.len()).map(|cell| volume(&corners(cell))).sum()
}
