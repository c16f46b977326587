//! What is said of a mesh, as one JSON object.

use super::Info;
use crate::commands::mesh::steps::{FEW, Limits};
use serde_json::{Map, Value, json};
use std::collections::BTreeMap;
use tremolite::hexahedra::centroid;
use tremolite_mesh::{Face, quality};

impl Info<'_> {
    pub(super) fn json(&self) -> Value {
        let mesh = self.mesh;
        let (low, high) = mesh.bounds();
        let counts = |sets: &BTreeMap<String, Vec<Face>>| -> BTreeMap<String, usize> {
            sets.iter().map(|(name, faces)| (name.clone(), faces.len())).collect()
        };
        let groups: BTreeMap<&str, usize> = mesh.groups.iter().map(|(n, e)| (n.as_str(), e.len())).collect();
        let types: BTreeMap<&str, _> =
            mesh.groups.iter().map(|(n, e)| (n.as_str(), self.types(e.iter().copied()))).collect();
        let (whole, by_group) = self.limits();
        let worst = self.steps.worst(FEW).into_iter().map(|e| mesh.element_id(e as usize));
        let made = self.made.iter().map(|m| {
            json!({
                "name": m.name, "elements": m.elements.len(), "young": m.moduli.young(),
                "poisson": m.moduli.poisson(), "density": m.density, "p_wave": m.p_wave(),
            })
        });
        json!({
            "nodes": mesh.nodes.len(),
            "elements": self.types(self.all()),
            "groups": groups,
            "types_by_group": types,
            "volume": self.whole.volume,
            "min_scaled_jacobian": self.whole.min_scaled_jacobian,
            "max_aspect": self.whole.max_aspect,
            "bounds": [low, high],
            "shortest_edge": self.whole.shortest_edge,
            "longest_edge": self.whole.longest_edge,
            "materials_assumed": self.assumed,
            "materials": made.collect::<Vec<_>>(),
            "elements_without_step": self.steps.unknown(),
            "worst_elements": worst.collect::<Vec<_>>(),
            "stable_step": whole.map(|l| self.step_json(&l)),
            "stable_step_by_group":
                by_group.iter().map(|(name, l)| ((*name).to_owned(), self.step_json(l))).collect::<Map<_, _>>(),
            "sides_turned": self.turned,
            "side_faces": counts(&self.sides),
            "named_faces": counts(&mesh.faces),
            "other_outer_faces": self.elsewhere,
            "crowded_faces": self.crowded.len(),
            "parts": self.parts,
            "coincident_nodes": self.coincident.1,
            "coincidence_tolerance": self.coincident.0,
        })
    }

    fn step_json(&self, limits: &Limits) -> Value {
        let quality = quality::of(self.mesh, limits.element as usize);
        json!({
            "step": limits.step,
            "element": self.mesh.element_id(limits.element as usize),
            "at": centroid(self.mesh, limits.element),
            "edges": [quality.shortest_edge, quality.longest_edge],
            "scaled_jacobian": quality.scaled_jacobian,
            "step_without_worst_10": limits.without_few,
            "step_of_99_percent": limits.percentile,
            "step_of_half": limits.median,
            "elements_within_1.25": limits.near,
        })
    }
}
