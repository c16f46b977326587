//! What stands when, and what stands in the place of what is installed later.

use super::faces::Faces;
use super::{Staged, before, fitting};
use std::collections::{BTreeMap, HashSet};
use tremolite_case::{Case, Diagnostic, Fill};
use tremolite_engine::{Body, Life, Stage};
use tremolite_mesh::Mesh;
use tremolite_mesh::hole::walls;
use tremolite_mesh::reach::nearest_with_holes;
use tremolite_mesh::topology::all_faces;

impl Staged {
    /// The stage that installs each element, with the place of the pattern.
    pub(super) fn installed(
        &mut self,
        case: &Case,
        mesh: &Mesh,
        problems: &mut Vec<Diagnostic>,
    ) -> Vec<Option<usize>> {
        let mut installed: Vec<Option<usize>> = vec![None; mesh.elements.len()];
        for (k, stage) in case.stages.iter().enumerate() {
            for written in &stage.install {
                let Some(elements) = fitting(written, mesh, problems) else { continue };
                let void = elements.iter().find(|&&e| self.body_of[e as usize].is_none());
                if let Some(&e) = void {
                    problems.push(Diagnostic::at(
                        written,
                        format!("{} is void: nothing can be installed there", name(mesh, e)),
                        "give its group a [[region]] with a material",
                    ));
                    continue;
                }
                let twice = |e: &u32| installed[*e as usize].filter(|&first| first != k);
                if let Some((e, first)) = elements.iter().find_map(|e| Some((*e, twice(e)?))) {
                    problems.push(Diagnostic::at(
                        written,
                        format!(
                            "{} is installed in '{}' already",
                            name(mesh, e),
                            case.stages[first].name.value
                        ),
                        "install each group once",
                    ));
                    continue;
                }
                elements.iter().for_each(|&e| installed[e as usize] = Some(k));
            }
        }
        for (life, k) in self.lives.iter_mut().zip(&installed) {
            if let Some(k) = *k {
                life.born = before(k);
            }
        }
        installed
    }

    /// Elements that each stage takes out: of what stands by itself, and of what stands in the place of an element that is
    /// installed later.
    pub(super) fn excavated(
        &mut self,
        case: &Case,
        mesh: &Mesh,
        installed: &[Option<usize>],
        problems: &mut Vec<Diagnostic>,
    ) -> Vec<Vec<u32>> {
        let mut of_stage = vec![Vec::new(); case.stages.len()];
        // The stage that takes out what an element is, or what stands in its place.
        let mut own: Vec<Option<usize>> = vec![None; mesh.elements.len()];
        let mut in_place: Vec<Option<usize>> = vec![None; mesh.elements.len()];
        for (k, stage) in case.stages.iter().enumerate() {
            for written in &stage.excavate {
                let Some(elements) = fitting(written, mesh, problems) else { continue };
                let before = problems.len();
                for &e in &elements {
                    let e = e as usize;
                    let taken =
                        if installed[e].is_some_and(|born| k <= born) { &mut in_place } else { &mut own };
                    let refuse = |what: String, remedy: &str| {
                        Diagnostic::at(written, format!("{} {what}", name(mesh, e as u32)), remedy)
                    };
                    if self.body_of[e].is_none() {
                        problems.push(refuse(
                            "is void from the start".into(),
                            "give its group a [[region]] with the material that is there until it is excavated",
                        ));
                    } else if let Some(first) = taken[e].filter(|&first| first != k) {
                        let name = &case.stages[first].name.value;
                        problems.push(refuse(format!("is gone since '{name}'"), "excavate each group once"));
                    } else {
                        taken[e] = Some(k);
                    }
                    if problems.len() > before {
                        break;
                    }
                }
                // A lining that is taken out again takes no rock along.
                of_stage[k].extend(
                    elements.into_iter().filter(|&e| installed[e as usize].is_none_or(|born| k <= born)),
                );
            }
        }
        for (life, k) in self.lives.iter_mut().zip(&own) {
            life.gone = k.map(before);
        }
        of_stage
    }

    /// Elements that no stage installs though others of their region, or its `before`, say that they come later.
    fn forgotten(
        &mut self,
        case: &Case,
        mesh: &Mesh,
        installed: &[Option<usize>],
        problems: &mut Vec<Diagnostic>,
    ) {
        let solid = case.regions.iter().filter_map(|region| match &region.fill {
            Fill::Solid { before, .. } => Some((region, before)),
            Fill::Void => None,
        });
        // Bodies are made region by region.
        for (b, (region, before)) in solid.enumerate() {
            let own = (0u32..).zip(&self.body_of).filter(|(_, of)| **of == Some(b)).map(|(e, _)| e);
            let (later, from_start): (Vec<u32>, Vec<u32>) =
                own.partition(|&e| installed[e as usize].is_some());
            let Some(&first) = from_start.first() else { continue };
            let message = format!(
                "{} elements are installed in no stage, {} for one, so they stand from the start",
                from_start.len(),
                name(mesh, first)
            );
            let remedy = "name their groups in the `install` of a stage";
            if let Some(before) = before {
                problems.push(Diagnostic::at(before, message, remedy));
            } else if !later.is_empty() {
                let remedy = format!("{remedy}, or give them a [[region]] of their own if that is meant");
                self.warnings.push(Diagnostic::new(region.span.clone(), message, remedy));
            }
        }
    }

    /// Finds what stands in the place of what is installed, until when.
    pub(super) fn stand_in(
        &mut self,
        case: &Case,
        mesh: &Mesh,
        bodies: &[Body],
        installed: &[Option<usize>],
        excavated: &[Vec<u32>],
        problems: &mut Vec<Diagnostic>,
    ) {
        let made = |material: usize| {
            case.regions.iter().any(|region| match &region.fill {
                Fill::Solid { material: own, .. } => own.value == material,
                Fill::Void => false,
            })
        };
        for region in &case.regions {
            if let Fill::Solid { before: Some(before), .. } = &region.fill
                && !made(before.value)
            {
                problems.push(Diagnostic::at(
                    before,
                    format!(
                        "no region is made of '{}', so nothing says which elements stand there before",
                        case.materials[before.value].name.value
                    ),
                    "name the material of a [[region]], as that of the rock around",
                ));
            }
        }
        self.forgotten(case, mesh, installed, problems);
        let targets: Vec<u32> =
            (0u32..).zip(installed).filter(|(_, k)| k.is_some()).map(|(e, _)| e).collect();
        let void = (0u32..).zip(&self.body_of).filter(|(_, b)| b.is_none()).map(|(e, _)| e).collect();
        let seeds: Vec<Vec<u32>> = std::iter::once(void).chain(excavated.iter().cloned()).collect();
        let holes: Vec<u32> = if targets.is_empty() {
            Vec::new()
        } else {
            walls(mesh).into_iter().map(|face| face.element).collect()
        };
        let nearest = nearest_with_holes(mesh, &targets, &seeds, &holes);
        let beside = Beside::of(mesh, &self.body_of, installed);
        let mut refused: Vec<usize> = Vec::new();
        for (&e, nearest) in targets.iter().zip(nearest) {
            let Some(born) = installed[e as usize] else { continue };
            // Void, or a hole, from the start: nothing stands in.
            if nearest == Some(0) {
                continue;
            }
            let gone = nearest.map(|k| k - 1).filter(|&k| k <= born);
            let Some(gone) = gone else {
                if !refused.contains(&born) {
                    refused.push(born);
                    let stage = &case.stages[born];
                    let when = match nearest {
                        Some(k) => format!("leaves only in '{}'", case.stages[k - 1].name.value),
                        None => "never leaves".to_owned(),
                    };
                    let (what, group) = (name(mesh, e), smallest_group(mesh, e));
                    problems.push(Diagnostic::at(
                        &stage.name,
                        format!("'{}' installs {what}, but the rock in its place {when}", stage.name.value),
                        match group {
                            Some(group) => {
                                format!(
                                    "add '{group}' to the `excavate` of '{}' or of an earlier stage",
                                    stage.name.value
                                )
                            }
                            None => "excavate it in that stage or earlier".to_owned(),
                        },
                    ));
                }
                continue;
            };
            let own = self.body_of[e as usize];
            let Some(body) = before_of(case, bodies, own).or_else(|| beside.body(mesh, e)) else {
                problems.push(Diagnostic::at(
                    &case.stages[born].name,
                    format!(
                        "nothing says what is in the place of element {} before",
                        mesh.element_id(e as usize)
                    ),
                    "write before = \"MATERIAL\" in its [[region]]",
                ));
                return;
            };
            self.stand_ins.push((e, body, Life { born: Stage::Before(0), gone: Some(before(gone)) }));
        }
    }
}

/// An element for messages, with the smallest group that holds it.
fn name(mesh: &Mesh, element: u32) -> String {
    let number = mesh.element_id(element as usize);
    match smallest_group(mesh, element) {
        Some(group) => format!("element {number} of '{group}'"),
        None => format!("element {number}"),
    }
}

/// The smallest group that contains an element.
fn smallest_group(mesh: &Mesh, element: u32) -> Option<&str> {
    let groups = mesh.groups.iter().filter(|(_, elements)| elements.binary_search(&element).is_ok());
    groups.min_by_key(|(_, elements)| elements.len()).map(|(group, _)| group.as_str())
}

/// The body that a region's `before` names.
fn before_of(case: &Case, bodies: &[Body], own: Option<usize>) -> Option<usize> {
    let solid: Vec<(usize, Option<usize>)> = case
        .regions
        .iter()
        .filter_map(|region| match &region.fill {
            Fill::Solid { material, before, .. } => Some((material.value, before.as_ref().map(|b| b.value))),
            Fill::Void => None,
        })
        .collect();
    let (_, before) = *solid.get(own?)?;
    let wanted = before?;
    // Bodies are made region by region.
    solid.iter().take(bodies.len()).position(|(material, _)| *material == wanted)
}

/// What lies beside elements that are installed later.
struct Beside {
    faces: Faces,
    /// The body of what stands from the start.
    body_of: Vec<Option<usize>>,
}

impl Beside {
    fn of(mesh: &Mesh, body_of: &[Option<usize>], installed: &[Option<usize>]) -> Beside {
        let own = body_of.iter().zip(installed).map(|(body, k)| body.filter(|_| k.is_none())).collect();
        Beside { faces: Faces::of(mesh), body_of: own }
    }

    /// The body that shares most faces with an element, or with the elements nearest to it that have such a neighbour.
    fn body(&self, mesh: &Mesh, element: u32) -> Option<usize> {
        let mut ring = vec![element];
        let mut seen: HashSet<u32> = ring.iter().copied().collect();
        while !ring.is_empty() {
            let mut shared: BTreeMap<usize, usize> = BTreeMap::new();
            let mut next = Vec::new();
            for face in all_faces(mesh, Some(&ring)) {
                for other in self.faces.elements(mesh, face) {
                    if let Some(body) = self.body_of[other as usize] {
                        *shared.entry(body).or_default() += 1;
                    } else if seen.insert(other) {
                        next.push(other);
                    }
                }
            }
            // Of two that share as many, the first.
            let most = shared.iter().max_by_key(|(body, count)| (**count, std::cmp::Reverse(**body)));
            if let Some((&body, _)) = most {
                return Some(body);
            }
            ring = next;
        }
        None
    }
}
