//! The bounds of the ground in a stage, and the places among them where water comes in or leaves.

use super::drains::along;
use super::names::planes;
use std::collections::{BTreeMap, HashMap, HashSet};
use tremolite_case::{Case, Diagnostic, Drain, Spanned, pattern};
use tremolite_engine::Problem;
use tremolite_engine::outer_faces::OuterFaces;
use tremolite_mesh::topology::all_faces;
use tremolite_mesh::{Face, Mesh};
use tremolite_seepage::{Holds, Place};

/// The nodes of a face, ascending, those at one place being one.
type Key = [u32; 4];

/// What does not change with stages.
pub(super) struct Around<'a> {
    space: &'a Problem,
    joined: &'a [u32],
    /// The elements of the mesh as it was read that have each face.
    read: HashMap<Key, Vec<u32>>,
    /// Each element as the one that the mesh was read with.
    shown: Vec<u32>,
}

impl<'a> Around<'a> {
    pub fn new(space: &'a Problem, joined: &'a [u32]) -> Self {
        let mesh = &space.mesh;
        let mut shown: Vec<u32> = (0..mesh.elements.len() as u32).collect();
        space.stand_ins.iter().for_each(|&(e, of)| shown[e as usize] = of);
        let as_read: Vec<u32> = (0u32..).zip(&shown).filter(|(e, of)| e == *of).map(|(e, _)| e).collect();
        let mut read: HashMap<Key, Vec<u32>> = HashMap::new();
        for face in all_faces(mesh, Some(&as_read)) {
            read.entry(key(mesh, joined, face)).or_default().push(face.element);
        }
        Around { space, joined, read, shown }
    }

    fn key(&self, face: Face) -> Key {
        key(&self.space.mesh, self.joined, face)
    }

    /// The element of the mesh as it was read on the other side of a face.
    fn beside(&self, face: Face) -> Option<u32> {
        let own = self.shown[face.element as usize];
        self.read.get(&self.key(face))?.iter().copied().find(|&e| e != own)
    }

    /// The nodes of a face, those at one place being one.
    fn nodes(&self, face: Face) -> Vec<u32> {
        self.space.mesh.face_nodes(face).map(|n| self.joined[n as usize]).collect()
    }
}

fn key(mesh: &Mesh, joined: &[u32], face: Face) -> Key {
    let mut key = [u32::MAX; 4];
    key.iter_mut().zip(mesh.face_nodes(face)).for_each(|(k, n)| *k = joined[n as usize]);
    key.sort_unstable();
    key
}

/// A face of the ground against something tight that stands.
pub(super) struct Contact {
    pub face: Face,
    pub tight: u32,
    /// The interface between them, by its place in the problem.
    pub across: Option<usize>,
}

/// The faces that bound the ground in a stage.
pub(super) struct Bounds {
    /// On outer planes, by axis and lower or upper.
    outer: [[Vec<Face>; 2]; 3],
    /// Against nothing.
    walls: Vec<Face>,
    pub contacts: Vec<Contact>,
}

/// Where water comes in or leaves: walls and drains, then heads.
pub(super) struct Placed {
    pub places: Vec<Place>,
    pub warnings: Vec<Diagnostic>,
}

impl Bounds {
    pub fn of(around: &Around, standing: &[u32], ground: &[u32]) -> Self {
        let (space, mesh) = (around.space, &around.space.mesh);
        let inside: HashSet<u32> = ground.iter().copied().collect();
        let mut own: HashMap<Key, (Face, u8)> = HashMap::new();
        for face in all_faces(mesh, Some(ground)) {
            own.entry(around.key(face)).or_insert((face, 0)).1 += 1;
        }
        let tight: Vec<u32> = standing.iter().copied().filter(|e| !inside.contains(e)).collect();
        let beside: HashMap<Key, u32> =
            all_faces(mesh, Some(&tight)).map(|face| (around.key(face), face.element)).collect();
        let outer = OuterFaces::of(mesh, mesh.bounds(), ground).planes;
        let on_plane: HashSet<Face> = outer.iter().flatten().flatten().copied().collect();
        let mut faces: Vec<Face> =
            own.into_values().filter(|(_, count)| *count == 1).map(|(face, _)| face).collect();
        faces.sort_unstable();
        let sides: Vec<[HashSet<u32>; 2]> = space
            .interfaces
            .iter()
            .map(|interface| interface.sides.each_ref().map(|side| side.iter().copied().collect()))
            .collect();
        let (mut walls, mut contacts) = (Vec::new(), Vec::new());
        for face in faces {
            if let Some(&tight) = beside.get(&around.key(face)) {
                let [a, b] = [face.element, tight].map(|e| around.shown[e as usize]);
                let parts = |[first, second]: &[HashSet<u32>; 2]| {
                    (first.contains(&a) && second.contains(&b)) || (first.contains(&b) && second.contains(&a))
                };
                contacts.push(Contact { face, tight, across: sides.iter().position(parts) });
            } else if !on_plane.contains(&face) {
                walls.push(face);
            }
        }
        Bounds { outer, walls, contacts }
    }

    /// The places of a stage, by what it and those before say.
    ///
    /// # Errors
    /// What means no face or node of the ground.
    pub fn places(
        &self,
        case: &Case,
        stage: usize,
        around: &Around,
        ground: &[u32],
    ) -> Result<Placed, Diagnostic> {
        let said = Said::of(case, stage);
        let mesh = &around.space.mesh;
        let groups = Groups::of(mesh);
        let mut warnings = Vec::new();
        // Each wall has one word: full of water, else a head, else drained.
        let mut drained: BTreeMap<String, Vec<Face>> = BTreeMap::new();
        let mut filled: BTreeMap<usize, Vec<Face>> = BTreeMap::new();
        let mut heads: Vec<Vec<Face>> =
            said.heads.iter().map(|(name, _)| self.head(name, around, &groups)).collect();
        let has_head: HashSet<Face> = heads.iter().flatten().copied().collect();
        let mut does: HashSet<&str> = HashSet::new();
        let mut bare: HashSet<Face> = HashSet::new();
        for &face in &self.walls {
            let (own, beside) = (around.shown[face.element as usize], around.beside(face));
            let is_at = |name: &str| groups.has(name, own) || beside.is_some_and(|e| groups.has(name, e));
            let at = said.drained.into_iter().flatten().filter(|name| is_at(name));
            let named: Vec<&str> = at.map(|name| name.value.as_str()).collect();
            let open = said.drained.is_none() || !named.is_empty();
            does.extend(named);
            if let Some(full) = said.filled.iter().rposition(|(name, _)| is_at(name)) {
                filled.entry(full).or_default().push(face);
            } else if has_head.contains(&face) {
                bare.insert(face);
            } else if open {
                drained.entry(wall_name(case, stage, &groups, beside)).or_default().push(face);
            }
        }
        let full: HashSet<Face> = filled.values().flatten().copied().collect();
        let given = heads.clone();
        heads.iter_mut().for_each(|faces| faces.retain(|face| !full.contains(face)));
        warnings.extend(pressed(case, stage, &said, &heads, &bare, mesh));
        for contact in &self.contacts {
            let tight = around.shown[contact.tight as usize];
            let named = said.drained.and_then(|names| names.iter().find(|name| groups.has(name, tight)));
            let across = contact.across.map(|i| &around.space.interfaces[i]).filter(|i| i.water == Some(0.0));
            let name =
                across.map(|interface| interface.name.clone()).or(named.map(|name| name.value.clone()));
            if let Some(name) = name {
                drained.entry(name).or_default().push(contact.face);
            }
        }
        warnings.extend(self.idle(case, stage, &does, around, &groups));
        let place = |name: &str, holds: Holds, faces: &[Face]| {
            Place::of_faces(name, holds, faces.iter().map(|&face| around.nodes(face)), &mesh.nodes)
        };
        let mut places: Vec<Place> =
            drained.iter().map(|(name, faces)| place(name, Holds::Open(None), faces)).collect();
        for (full, faces) in &filled {
            let (name, level) = said.filled[*full];
            places.push(place(name, Holds::Open(Some(level)), faces));
        }
        for (k, drain) in said.drains.into_iter().flatten().enumerate() {
            places.push(self.drain(k, drain, around, ground, &groups)?);
        }
        for (((name, head), faces), given) in said.heads.into_iter().zip(&heads).zip(&given) {
            if faces.is_empty() && !given.is_empty() {
                // All of it is full of water that a stage gives.
                continue;
            }
            let held = place(name, Holds::Head(head.value), faces);
            let reaches = |&(n, _): &(u32, f64)| mesh.nodes[n as usize][2] <= head.value;
            if faces.is_empty() {
                warnings.push(Diagnostic::at(
                    head,
                    format!(
                        "the head at '{}' does nothing in stage '{}': the ground has no open face there",
                        name.value, case.stages[stage - 1].name.value
                    ),
                    "give it where ground ends at a void or at an outer plane; behind what is tight there is none",
                ));
            } else if !held.nodes.iter().any(reaches) {
                warnings.push(Diagnostic::at(
                    head,
                    format!(
                        "the head at '{}' lies below all of its ground: no water comes in there",
                        name.value
                    ),
                    "heads are heights z, upwards, like the `level`",
                ));
            }
            let open: HashSet<u32> = places
                .iter()
                .filter(|place| matches!(place.holds, Holds::Open(_)))
                .flat_map(|place| place.nodes.iter().map(|(n, _)| *n))
                .collect();
            if held.nodes.iter().any(|one| reaches(one) && open.contains(&one.0)) {
                warnings.push(Diagnostic::at(
                    name,
                    format!(
                        "a drained wall reaches '{}', where the head holds: water comes in right beside it",
                        name.value
                    ),
                    "give the head at sides that no void reaches, such as heads = { xmin = …, xmax = … }",
                ));
            }
            places.push(held);
        }
        if said.lake.is_some_and(|level| level > mesh.bounds().1[2]) {
            let level = said.lake.unwrap_or_default();
            places.push(place("top", Holds::Head(level), &self.outer[2][1]));
        }
        Ok(Placed { places, warnings })
    }

    /// Words of a stage that are to drain walls and drain none, where what is tight hides the ground that they name.
    fn idle(
        &self,
        case: &Case,
        stage: usize,
        does: &HashSet<&str>,
        around: &Around,
        groups: &Groups,
    ) -> Vec<Diagnostic> {
        let drained = case.stages[stage - 1].water.drained.iter().flatten();
        let idle = drained.filter_map(|name| {
            let is_tight = |contact: &Contact| groups.has(name, around.shown[contact.tight as usize]);
            if does.contains(name.value.as_str()) || self.contacts.iter().any(is_tight) {
                return None;
            }
            let hides = |contact: &&Contact| groups.has(name, around.shown[contact.face.element as usize]);
            let hidden = self.contacts.iter().find(hides)?;
            let lining = groups.smallest(around.shown[hidden.tight as usize]).unwrap_or_default();
            Some(Diagnostic::at(
                name,
                format!(
                    "'{}' drains no wall here: what is tight stands before its ground, and closes it",
                    name.value
                ),
                format!(
                    "name the group of the lining, such as '{lining}': the ground behind it is then drained"
                ),
            ))
        });
        idle.collect()
    }

    /// The faces at which a head is given.
    fn head(&self, name: &str, around: &Around, groups: &Groups) -> Vec<Face> {
        let planes = planes(name);
        if !planes.is_empty() {
            return planes.iter().flat_map(|&(axis, upper)| &self.outer[axis][upper]).copied().collect();
        }
        let all = || self.outer.iter().flatten().flatten().chain(&self.walls).copied();
        match around.space.mesh.faces.get(name) {
            Some(faces) => {
                let named: HashSet<Key> = faces.iter().map(|&face| around.key(face)).collect();
                all().filter(|&face| named.contains(&around.key(face))).collect()
            }
            None => all()
                .filter(|&face| {
                    let beside = around.beside(face);
                    groups.has(name, around.shown[face.element as usize])
                        || beside.is_some_and(|e| groups.has(name, e))
                })
                .collect(),
        }
    }

    /// The nodes of a drain.
    fn drain(
        &self,
        k: usize,
        drain: &Drain,
        around: &Around,
        ground: &[u32],
        groups: &Groups,
    ) -> Result<Place, Diagnostic> {
        let mesh = &around.space.mesh;
        let (nodes, at, what) = match drain {
            Drain::Line(from, to) => {
                let what = format!("drain {}", k + 1);
                (along(mesh, ground, from.value, to.value), from.span.clone(), what)
            }
            Drain::Group(group) => {
                let own = ground.iter().filter(|&&e| groups.has(group, around.shown[e as usize]));
                let nodes = own.flat_map(|&e| mesh.elements[e as usize].nodes()).copied().collect();
                (nodes, group.span.clone(), group.value.clone())
            }
        };
        let mut nodes: Vec<u32> = nodes.into_iter().map(|n| around.joined[n as usize]).collect();
        nodes.sort_unstable();
        nodes.dedup();
        if nodes.is_empty() {
            return Err(Diagnostic::new(
                at,
                "this drain passes no ground with pores in a stage in which it drains",
                "give a line within the rock that stands then, or end it by `drains` of the stage that takes its ground",
            ));
        }
        let nodes = nodes.into_iter().map(|n| (n, 1.0)).collect();
        Ok(Place { name: what, holds: Holds::Open(None), nodes })
    }
}

/// Heads above walls of voids that are not full: the water stands in the rock, and presses on nothing.
fn pressed(
    case: &Case,
    stage: usize,
    said: &Said,
    heads: &[Vec<Face>],
    bare: &HashSet<Face>,
    mesh: &Mesh,
) -> Vec<Diagnostic> {
    let each = said.heads.iter().zip(heads);
    let stands = each.filter(|((_, head), faces)| {
        let below = |face: &&Face| mesh.face_nodes(**face).any(|n| mesh.nodes[n as usize][2] < head.value);
        faces.iter().filter(|face| bare.contains(face)).any(|face| below(&face))
    });
    let name = &case.stages[stage - 1].name.value;
    stands
        .map(|((place, _), _)| {
            Diagnostic::at(
                place,
                format!(
                    "the head at '{}' holds on walls of a void that is empty in stage '{name}': it lets water in there, and nothing presses on them",
                    place.value
                ),
                format!("fill the void in that stage, water = {{ filled = {{ \"{}\" = … }} }}, or give the head at an outer plane", place.value),
            )
        })
        .collect()
}

/// What holds in a stage: the last words of it and of those before.
struct Said<'c> {
    heads: Vec<(&'c Spanned<String>, &'c Spanned<f64>)>,
    drained: Option<&'c [Spanned<String>]>,
    drains: Option<&'c [Drain]>,
    /// Patterns of groups, and the level of the water in the void beside them.
    filled: Vec<(&'c str, f64)>,
    /// Level of the water on the top.
    lake: Option<f64>,
}

impl<'c> Said<'c> {
    fn of(case: &'c Case, stage: usize) -> Self {
        let mut said =
            Said { heads: Vec::new(), drained: None, drains: None, filled: Vec::new(), lake: None };
        let first = case.water.as_ref().map_or(&[][..], |water| &water.heads);
        let of_stages = case.stages[..stage].iter().map(|stage| &stage.water);
        for heads in std::iter::once(first).chain(of_stages.clone().map(|water| &water.heads[..])) {
            for (name, head) in heads {
                said.heads.retain(|(other, _)| other.value != name.value);
                said.heads.push((name, head));
            }
        }
        for water in of_stages {
            said.drained = water.drained.as_deref().or(said.drained);
            said.drains = water.drains.as_deref().or(said.drains);
            for (name, level) in &water.filled {
                if name.value == "top" {
                    said.lake = Some(level.value);
                    continue;
                }
                said.filled.retain(|(other, _)| *other != name.value);
                said.filled.push((&name.value, level.value));
            }
        }
        said
    }
}

/// Which elements groups have.
struct Groups<'m> {
    mesh: &'m Mesh,
}

impl<'m> Groups<'m> {
    fn of(mesh: &'m Mesh) -> Self {
        Groups { mesh }
    }

    /// Whether an element is in a group that a pattern fits.
    fn has(&self, name: &str, element: u32) -> bool {
        let fitting = self.mesh.groups.iter().filter(|(group, _)| pattern::matches(name, group));
        fitting.into_iter().any(|(_, elements)| elements.binary_search(&element).is_ok())
    }

    /// The smallest group that an element is in.
    fn smallest(&self, element: u32) -> Option<String> {
        let own = self.mesh.groups.iter().filter(|(_, elements)| elements.binary_search(&element).is_ok());
        own.min_by_key(|(_, elements)| elements.len()).map(|(name, _)| name.clone())
    }
}

/// What a wall is called: by the words with which what stood there was taken out, else by the smallest group of it.
fn wall_name(case: &Case, stage: usize, groups: &Groups, beside: Option<u32>) -> String {
    let Some(beside) = beside else { return "other walls".into() };
    let words = case.stages[..stage].iter().flat_map(|stage| &stage.excavate);
    let word = words.into_iter().find(|word| groups.has(word, beside)).map(|word| word.value.clone());
    word.or_else(|| groups.smallest(beside)).unwrap_or_else(|| "other walls".into())
}
