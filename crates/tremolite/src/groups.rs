//! Groups of elements for which stress and damage are reported.

use crate::quantities::MEASURES;
use tremolite_engine::Body;
use tremolite_engine::model::Model;
use tremolite_laws::parameter::position;

/// Elements with a name.
pub(crate) struct Group<'a> {
    pub name: &'a str,
    pub body: &'a Body,
    /// Those that are there in the shaking.
    pub elements: Vec<u32>,
    /// Whether it is no part of another group of the same body.
    pub whole: bool,
}

/// The groups of [`all_groups`] whose law has a measure of damage.
pub(crate) fn groups(model: &Model) -> Vec<Group<'_>> {
    let measured = |group: &Group| {
        let columns = group.body.material.info().history;
        MEASURES.iter().any(|m| position(columns, m.role).is_some())
    };
    all_groups(model).into_iter().filter(measured).collect()
}

/// Groups of the mesh that lie in one body each, and bodies that such groups do not make up.
pub(crate) fn all_groups(model: &Model) -> Vec<Group<'_>> {
    let mut all = Vec::new();
    for body in model.user_bodies() {
        let lasting = model.lasting(body);
        let mut inside = vec![false; model.mesh.elements.len()];
        lasting.iter().for_each(|&e| inside[e as usize] = true);
        let within = |elements: &[u32]| !elements.is_empty() && elements.iter().all(|&e| inside[e as usize]);
        let own: Vec<(&str, &[u32])> = model
            .mesh
            .groups
            .iter()
            .filter(|(_, elements)| within(elements))
            .map(|(name, elements)| (name.as_str(), elements.as_slice()))
            .collect();
        let mut named = vec![false; model.mesh.elements.len()];
        own.iter().flat_map(|(_, elements)| *elements).for_each(|&e| named[e as usize] = true);
        if !lasting.iter().all(|&e| named[e as usize]) {
            all.push(Group { name: &body.name, body, elements: lasting, whole: own.is_empty() });
        }
        // A group is whole unless a larger one (or, of two equal ones, the first) holds all of it.
        let mut whole = vec![true; own.len()];
        for (k, (_, outer)) in own.iter().enumerate() {
            let mut inside = vec![false; model.mesh.elements.len()];
            outer.iter().for_each(|&e| inside[e as usize] = true);
            for (i, (_, inner)) in own.iter().enumerate() {
                let smaller = inner.len() < outer.len() || (inner.len() == outer.len() && k < i);
                whole[i] &= !(smaller && inner.iter().all(|&e| inside[e as usize]));
            }
        }
        all.extend(own.iter().zip(whole).map(|((name, elements), whole)| Group {
            name,
            body,
            elements: elements.to_vec(),
            whole,
        }));
    }
    all
}
