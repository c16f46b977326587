//! What the entries of sets and surfaces stand for, across parts and instances.

use std::collections::{HashMap, HashSet};

use super::kinds::face_numbers;
use super::part::{Entry, Part, Set, Target};
use crate::assembly::{Draft, Numbering};
use crate::fault::Fault;
use crate::topology::exterior_faces;
use crate::{Face, Shape};

/// A part at its place in the mesh.
pub(super) struct Placed<'m> {
    /// Key and name of the instance; empty for what stands outside of instances.
    pub key: String,
    pub shown: String,
    pub part: &'m Part,
    pub first_node: u32,
    pub nodes: Numbering,
    pub first_solid: u32,
    pub solid_count: u32,
    pub solids: Numbering,
    pub flats: Numbering,
    pub others: Numbering,
}

/// What a set or an entry of one stands for.
#[derive(Default)]
pub(super) struct Picked {
    /// Indices of solids in the mesh.
    pub solids: Vec<u32>,
    /// Surface elements: which part, and the index there.
    pub flats: Vec<(usize, u32)>,
    /// Indices of nodes in the mesh.
    pub nodes: Vec<u32>,
    /// Numbers of nodes that the file does not define.
    pub absent: Vec<u64>,
}

impl Picked {
    /// Notes a node that is not there.
    ///
    /// # Errors
    /// If it is an element.
    fn absent(&mut self, of: Of, number: u64, line: usize) -> Result<(), Fault> {
        if of == Of::Nodes {
            self.absent.push(number);
            return Ok(());
        }
        let problem =
            format!("element {number} is not there; take it out of the set, or write the whole mesh");
        Err(Fault::at(line, problem))
    }
}

/// All parts at their places.
pub(super) struct Assembly<'m> {
    pub placed: Vec<Placed<'m>>,
}

/// Which kind of set.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Of {
    Elements,
    Nodes,
}

impl Assembly<'_> {
    /// What a set stands for, each once.
    pub(super) fn set(&self, at: usize, set: &Set, of: Of) -> Result<Picked, Fault> {
        let mut picked = Picked::default();
        for entry in &set.entries {
            self.pick(at, entry, of, &mut picked)?;
        }
        for list in [&mut picked.solids, &mut picked.nodes] {
            list.sort_unstable();
            list.dedup();
        }
        picked.flats.sort_unstable();
        picked.flats.dedup();
        Ok(picked)
    }

    /// The parts that an entry of a set in part `at` may refer to.
    fn scope(&self, at: usize, instance: Option<&str>) -> Vec<usize> {
        let key = instance.unwrap_or(&self.placed[at].key);
        (0..self.placed.len()).filter(|&i| self.placed[i].key == key).collect()
    }

    /// Adds what an entry stands for. A set is added once, so sets may even refer to one another.
    fn pick(&self, at: usize, entry: &Entry, of: Of, picked: &mut Picked) -> Result<(), Fault> {
        let mut open = vec![(at, entry)];
        let mut seen: HashSet<(usize, &str)> = HashSet::new();
        while let Some((at, entry)) = open.pop() {
            let scope = self.scope(at, entry.instance.as_deref());
            let key = match &entry.target {
                Target::Set(key) => key,
                &Target::Range(first, last, step) => {
                    if !self.pick_range(&scope, [first, last, step], of, picked) {
                        picked.absent(of, first, entry.line)?;
                    }
                    continue;
                }
                Target::Runs(runs) => {
                    for run in runs {
                        let found = self.pick_range(&scope, [run.first, run.last, 1], of, picked);
                        let is_there = |n| scope.iter().any(|&i| self.placed[i].nodes.index(n).is_some());
                        if of == Of::Nodes {
                            picked.absent.extend((run.first..=run.last).filter(|&n| !is_there(n)));
                        } else if !found {
                            picked.absent(of, run.first, run.line as usize)?;
                        }
                    }
                    continue;
                }
            };
            let sets = |i: usize| {
                if of == Of::Nodes { &self.placed[i].part.nsets } else { &self.placed[i].part.elsets }
            };
            let mut found: Vec<(usize, &Set, &str)> = Vec::new();
            found.extend(scope.iter().filter_map(|&i| Some((i, sets(i).get(key)?, key.as_str()))));
            if let (Some(instance), true) = (&entry.instance, found.is_empty()) {
                // A name may hold a dot without being one of an instance.
                let dotted = format!("{instance}.{key}");
                let here = self.scope(at, None);
                let known = here
                    .iter()
                    .filter_map(|&i| sets(i).get_key_value(&dotted).map(|(k, set)| (i, set, k.as_str())));
                found.extend(known);
            }
            if found.is_empty() {
                let problem = format!("there is no set `{key}`; define it, or remove this entry");
                return Err(Fault::at(entry.line, problem));
            }
            for (i, set, key) in found {
                if seen.insert((i, key)) {
                    open.extend(set.entries.iter().map(|entry| (i, entry)));
                }
            }
        }
        Ok(())
    }

    /// Adds nodes or elements by number; whether there is any.
    fn pick_range(
        &self,
        scope: &[usize],
        [first, last, step]: [u64; 3],
        of: Of,
        picked: &mut Picked,
    ) -> bool {
        let mut found = false;
        for &i in scope {
            let placed = &self.placed[i];
            if of == Of::Nodes {
                let nodes = placed.nodes.indices(first, last, step);
                found |= !nodes.is_empty();
                picked.nodes.extend(nodes.iter().map(|n| placed.first_node + n));
                continue;
            }
            let solids = placed.solids.indices(first, last, step);
            let flats = placed.flats.indices(first, last, step);
            found |= !solids.is_empty() || !flats.is_empty();
            found = found || !placed.others.indices(first, last, step).is_empty();
            picked.solids.extend(solids.iter().map(|s| placed.first_solid + s));
            picked.flats.extend(flats.iter().map(|&f| (i, f)));
        }
        found
    }

    /// The faces of a surface, and the surface elements in it. `exterior` is filled when first needed.
    pub(super) fn surface(
        &self,
        at: usize,
        set: &Set,
        draft: &Draft,
        exterior: &mut Option<HashMap<u32, Vec<Face>>>,
    ) -> Result<(Picked, Vec<Face>), Fault> {
        let (mut all, mut faces) = (Picked::default(), Vec::new());
        for entry in &set.entries {
            let mut picked = Picked::default();
            self.pick(at, entry, Of::Elements, &mut picked)?;
            all.flats.append(&mut picked.flats);
            if picked.solids.is_empty() {
                continue;
            }
            if entry.face.is_empty() {
                let exterior = exterior.get_or_insert_with(|| {
                    let mut of: HashMap<u32, Vec<Face>> = HashMap::new();
                    for face in exterior_faces(&draft.mesh, None) {
                        of.entry(face.element).or_default().push(face);
                    }
                    of
                });
                faces.extend(picked.solids.iter().filter_map(|e| exterior.get(e)).flatten());
                continue;
            }
            for element in picked.solids {
                let shape = draft.mesh.elements[element as usize].shape;
                let Some(side) = side(shape, &entry.face) else {
                    return Err(Fault::at(
                        entry.line,
                        format!(
                            "`{}` is no face of a {}; faces are S1 to S{}",
                            entry.face,
                            shape.name(),
                            shape.faces().len()
                        ),
                    ));
                };
                faces.push(Face { element, side });
            }
        }
        Ok((all, faces))
    }
}

/// The side that Abaqus calls `face`.
fn side(shape: Shape, face: &str) -> Option<u8> {
    let number: u8 = face.strip_prefix('S')?.parse().ok()?;
    face_numbers(shape).iter().position(|&n| n == number).map(|side| side as u8)
}
