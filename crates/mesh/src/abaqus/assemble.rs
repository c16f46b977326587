//! From parts and instances to one mesh: numbers to indices, sets to groups, surfaces to faces.

use std::collections::BTreeMap;

use super::deck::Label;
use super::model::Model;
use super::part::{Instance, Part, Set, Sets};
use super::sets::{Assembly, Of, Picked, Placed};
use crate::Face;
use crate::assembly::{Draft, Facet, Numbering, Stray};
use crate::fault::Fault;
use crate::note::Note;

/// All that a set or surface becomes.
struct Named {
    /// Name of the instance, if it is defined in one.
    instance: Option<String>,
    name: String,
    picked: Picked,
    faces: Vec<Face>,
}

/// The mesh of a model.
pub(super) fn assemble(mut model: Model) -> Result<Draft, Fault> {
    let mut draft = std::mem::take(&mut model.draft);
    draft.stray = Stray::Skipped;
    let Model { root, parts, assembly, instances, .. } = &mut model;
    if instances.is_empty() {
        let solid: Vec<usize> = (0..parts.len()).filter(|&k| !parts[k].solids.is_empty()).collect();
        match solid.as_slice() {
            [] => {}
            // A single part without an assembly is the model.
            &[only] if root.nodes.is_empty() && assembly.nodes.is_empty() => *root = parts.swap_remove(only),
            &[first, ..] => {
                let key = &parts[first].key;
                return Err(Fault::whole(format!("part `{key}` has no instance; put it into the assembly")));
            }
        }
    }
    let mut spots = vec![place(&mut draft, root, None, true)?, place(&mut draft, assembly, None, true)?];
    let mut part_of = Vec::new();
    for instance in instances.iter() {
        let key = &instance.part;
        let Some(part) = parts.iter().position(|p| p.key == *key) else {
            let shown = &instance.label.shown;
            let problem = format!("there is no part `{key}` for the instance `{shown}`; define it before");
            return Err(Fault::at(instance.line, problem));
        };
        part_of.push(part);
    }
    for (k, instance) in instances.iter_mut().enumerate() {
        let last = !part_of[k + 1..].contains(&part_of[k]);
        spots.push(place(&mut draft, &mut parts[part_of[k]], Some(instance), last)?);
        // With a mesh of its own, an instance's part is empty, and the other way round.
        let mut own = std::mem::take(&mut instance.own);
        spots.push(place(&mut draft, &mut own, Some(instance), true)?);
        instance.own = own;
    }
    let model = &model;
    let mut from = vec![(None, &model.root), (None, &model.assembly)];
    for (instance, &part) in model.instances.iter().zip(&part_of) {
        from.extend([(Some(&instance.label), &model.parts[part]), (Some(&instance.label), &instance.own)]);
    }
    let mut placed = Vec::new();
    for (spot, (label, part)) in spots.into_iter().zip(from) {
        placed.push(spot.with_sets_of(label, part)?);
    }
    renumber_if_needed(&mut draft);
    let assembly = Assembly { placed };
    assembly.name(&mut draft)?;
    Ok(draft)
}

/// Where a part's nodes and solids went.
struct Spot {
    first_node: u32,
    nodes: Numbering,
    first_solid: u32,
    solids: Numbering,
    solid_count: u32,
}

/// Puts a part's nodes and solids into the mesh; if it is the last time, they are moved there.
fn place(draft: &mut Draft, part: &mut Part, instance: Option<&Instance>, last: bool) -> Result<Spot, Fault> {
    let of = instance.map_or(String::new(), |i| format!(" in instance `{}`", i.label.shown));
    let nodes = numbering(&part.node_numbers, "nodes", &of)?;
    let solids = numbering(&part.solid_numbers, "elements", &of)?;
    let (first_node, first_solid) = (draft.mesh.nodes.len() as u32, draft.mesh.elements.len() as u32);
    let solid_count = part.solids.len() as u32;
    let fits = |here: usize, more: usize| here + more < u32::MAX as usize;
    if !fits(draft.mesh.nodes.len(), part.nodes.len()) || !fits(draft.mesh.elements.len(), part.solids.len())
    {
        return Err(Fault::whole("the instances have more nodes or elements than 32 bits can number"));
    }
    let mesh = &mut draft.mesh;
    hand_over(&mut mesh.node_ids, &mut part.node_numbers, last);
    hand_over(&mut mesh.nodes, &mut part.nodes, last);
    hand_over(&mut mesh.element_ids, &mut part.solid_numbers, last);
    hand_over(&mut mesh.elements, &mut part.solids, last);
    if let Some(instance) = instance {
        for x in &mut mesh.nodes[first_node as usize..] {
            *x = instance.place(*x);
        }
    }
    draft.resolve(first_solid as usize, &nodes).map_err(|(e, node)| {
        let element = draft.mesh.element_ids[e];
        let problem = format!("element {element}{of} uses node {node}, which is not there");
        Fault::whole(format!("{problem}; write the whole mesh again"))
    })?;
    for node in draft.mesh.elements[first_solid as usize..].iter_mut().flat_map(|e| &mut e.nodes) {
        *node += first_node;
    }
    Ok(Spot { first_node, nodes, first_solid, solids, solid_count })
}

/// Adds a part's list to the mesh's, without copying where that can be.
fn hand_over<T: Copy>(all: &mut Vec<T>, more: &mut Vec<T>, last: bool) {
    match (all.is_empty(), last) {
        (true, true) => *all = std::mem::take(more),
        (_, true) => all.append(&mut std::mem::take(more)),
        _ => all.extend_from_slice(more),
    }
}

fn numbering(numbers: &[u64], what: &str, of: &str) -> Result<Numbering, Fault> {
    Numbering::new(numbers)
        .map_err(|number| Fault::whole(format!("there are two {what} {number}{of}; renumber them")))
}

impl Spot {
    fn with_sets_of<'m>(self, label: Option<&Label>, part: &'m Part) -> Result<Placed<'m>, Fault> {
        let Spot { first_node, nodes, first_solid, solids, solid_count } = self;
        let (key, shown) = label.map_or_else(Default::default, |l| (l.key.clone(), l.shown.clone()));
        let of = if shown.is_empty() { String::new() } else { format!(" in instance `{shown}`") };
        let flat_numbers: Vec<u64> = part.flats.iter().map(|f| f.number).collect();
        let mut others = part.others.clone();
        others.sort_unstable();
        others.dedup();
        let (flats, others) =
            (numbering(&flat_numbers, "elements", &of)?, numbering(&others, "elements", &of)?);
        Ok(Placed { key, shown, part, first_node, nodes, first_solid, solid_count, solids, flats, others })
    }
}

/// Gives up the numbers of nodes and elements if instances share them.
fn renumber_if_needed(draft: &mut Draft) {
    let mesh = &mut draft.mesh;
    let mut renumbered = false;
    for numbers in [&mut mesh.node_ids, &mut mesh.element_ids] {
        if Numbering::new(numbers).is_err() {
            *numbers = (1..=numbers.len() as u64).collect();
            renumbered = true;
        }
    }
    if renumbered {
        draft.notes.push(Note::Renumbered);
    }
}

impl Assembly<'_> {
    /// Names groups, faces and points.
    fn name(&self, draft: &mut Draft) -> Result<(), Fault> {
        let elsets = self.all(|part| &part.elsets, |at, set| self.set(at, set, Of::Elements))?;
        let nsets = self.all(|part| &part.nsets, |at, set| self.set(at, set, Of::Nodes))?;
        draft.notes.extend(nsets.iter().filter_map(|Named { name, picked, .. }| {
            let &first = picked.absent.first()?;
            Some(Note::AbsentNodes { set: name.clone(), count: picked.absent.len(), first })
        }));
        let mut exterior = None;
        let mut surfaces = Vec::new();
        for (at, placed) in self.placed.iter().enumerate() {
            for set in placed.part.surfaces.values().filter(|s| !s.internal) {
                let (picked, faces) = self.surface(at, set, draft, &mut exterior)?;
                surfaces.push(self.named(at, set, picked, faces));
            }
        }
        self.group_the_rest(draft, &elsets);
        // Surface elements in a set lie on the solids, or are skipped.
        let mut named_flats = 0;
        for (name, Named { picked, faces, .. }) in
            plain_names(elsets).into_iter().chain(plain_names(surfaces))
        {
            if !picked.solids.is_empty() {
                draft.mesh.groups.entry(name.clone()).or_default().extend(picked.solids);
            }
            if !faces.is_empty() {
                draft.mesh.faces.entry(name.clone()).or_default().extend(faces);
            }
            if !picked.flats.is_empty() {
                let list = draft.names.len() as u32;
                draft.names.push(vec![name]);
                for (at, index) in picked.flats {
                    draft.facets.push(self.facet(at, index, list)?);
                }
                named_flats += 1;
            }
        }
        let flats: usize = self.placed.iter().map(|p| p.part.flats.len()).sum();
        if named_flats == 0 {
            draft.skip("surface elements", flats);
        }
        let mut several = 0;
        for (name, Named { picked, .. }) in plain_names(nsets) {
            match picked.nodes.as_slice() {
                [] => {}
                [node] => drop(draft.mesh.points.insert(name, draft.mesh.nodes[*node as usize])),
                _ => several += 1,
            }
        }
        if several > 0 {
            draft.notes.push(Note::NotTaken { what: "sets of several nodes".into(), count: several });
        }
        Ok(())
    }

    fn all(
        &self,
        sets: impl Fn(&Part) -> &Sets,
        pick: impl Fn(usize, &Set) -> Result<Picked, Fault>,
    ) -> Result<Vec<Named>, Fault> {
        let mut all = Vec::new();
        for (at, placed) in self.placed.iter().enumerate() {
            for set in sets(placed.part).values().filter(|s| !s.internal) {
                all.push(self.named(at, set, pick(at, set)?, Vec::new()));
            }
        }
        Ok(all)
    }

    fn named(&self, at: usize, set: &Set, picked: Picked, faces: Vec<Face>) -> Named {
        let shown = &self.placed[at].shown;
        let instance = (!shown.is_empty()).then(|| shown.clone());
        Named { instance, name: set.shown.clone(), picked, faces }
    }

    /// Elements of no set are in the group of their instance.
    fn group_the_rest(&self, draft: &mut Draft, elsets: &[Named]) {
        let mut grouped = vec![false; draft.mesh.elements.len()];
        for &element in elsets.iter().flat_map(|n| &n.picked.solids) {
            grouped[element as usize] = true;
        }
        for placed in self.placed.iter().filter(|p| !p.shown.is_empty()) {
            let solids = placed.first_solid..placed.first_solid + placed.solid_count;
            let rest: Vec<u32> = solids.filter(|&e| !grouped[e as usize]).collect();
            if !rest.is_empty() {
                draft.mesh.groups.entry(placed.shown.clone()).or_default().extend(rest);
            }
        }
    }

    fn facet(&self, at: usize, index: u32, list: u32) -> Result<Facet, Fault> {
        let placed = &self.placed[at];
        let flat = &placed.part.flats[index as usize];
        let mut corners = [0; 4];
        for (corner, &number) in corners.iter_mut().zip(&flat.corners) {
            let Some(node) = placed.nodes.index(number) else {
                let problem = format!("element {} uses node {number}, which is not there", flat.number);
                return Err(Fault::whole(format!("{problem}; write the whole mesh again")));
            };
            *corner = placed.first_node + node;
        }
        Ok(Facet::new(&corners[..flat.corners.len()], flat.number, list))
    }
}

/// Names as in the file where they are unique; those that several instances use get the instance's in front.
fn plain_names(all: Vec<Named>) -> Vec<(String, Named)> {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for named in &all {
        *counts.entry(named.name.clone()).or_default() += 1;
    }
    let name = |named: &Named| match &named.instance {
        Some(instance) if counts[&named.name] > 1 => format!("{instance}.{}", named.name),
        _ => named.name.clone(),
    };
    all.into_iter().map(|named| (name(&named), named)).collect()
}
