//! Stages of a case: what stands when, in whose place, under what.

use super::changes::{Version, versions};
use super::initial;
use crate::stages::PlannedStage;
use std::collections::{BTreeMap, HashMap};
use std::ops::Range;
use tremolite_case::{self as case, Case, Fill, Problem, Spanned, pattern};
use tremolite_engine::engine::Release;
use tremolite_engine::outer_faces::OuterFaces;
use tremolite_engine::problem::Traction;
use tremolite_engine::{Body, Life, Problem as Space, Side, Stage};
use tremolite_kernels::Law;
use tremolite_laws::Dimension;
use tremolite_laws::band::Band;
use tremolite_mesh::reach::nearest_through_faces;
use tremolite_mesh::topology::{all_faces, exterior_faces, face_key};
use tremolite_mesh::{Face, Mesh};

/// Motion left over the largest of any stage, over the tolerance of what is out of balance.
const MOTION: f64 = 100.0;

/// The engine's stage of one of a case's, which follow the initial equilibrium.
fn before(index: usize) -> Stage {
    Stage::Before(index as u16 + 1)
}

/// What stands when, by the elements of the mesh as it was read.
pub struct Staged {
    /// Life of each element.
    lives: Vec<Life>,
    /// When something of its own stands in the place of each element, whatever its material.
    pub places: Vec<Life>,
    /// What elements are before their material changes for the last time.
    versions: Vec<Version>,
    /// What stands in the place of an element before it begins: the element, the body, its life.
    stand_ins: Vec<(u32, usize, Life)>,
    /// The body of each element; none for void.
    body_of: Vec<Option<usize>>,
}

impl Staged {
    /// Works out the lives of a case's elements.
    pub fn build(
        case: &Case,
        mesh: &Mesh,
        bodies: &mut Vec<Body>,
        laws: &[Law],
        band: Option<Band>,
        problems: &mut Vec<Problem>,
    ) -> Staged {
        let count = mesh.elements.len();
        let mut body_of: Vec<Option<usize>> = vec![None; count];
        for (b, body) in bodies.iter().enumerate() {
            body.elements.iter().for_each(|&e| body_of[e as usize] = Some(b));
        }
        let mut staged = Staged {
            lives: vec![Life::ALWAYS; count],
            places: vec![Life::ALWAYS; count],
            versions: Vec::new(),
            stand_ins: Vec::new(),
            body_of,
        };
        // Unlike what follows, elements without a region are reported already.
        if case.stages.is_empty() || !problems.is_empty() {
            return staged;
        }
        let installed = staged.installed(case, mesh, problems);
        let excavated = staged.excavated(case, mesh, &installed, problems);
        if problems.is_empty() {
            staged.stand_in(case, mesh, bodies, &installed, &excavated, problems);
        }
        staged.places.clone_from(&staged.lives);
        if problems.is_empty() {
            let Staged { body_of, lives, .. } = &mut staged;
            staged.versions = versions(case, mesh, laws, band, bodies, body_of, lives, problems);
        }
        staged
    }

    /// The stage that installs each element, with the place of the pattern.
    fn installed(&mut self, case: &Case, mesh: &Mesh, problems: &mut Vec<Problem>) -> Vec<Option<usize>> {
        let mut installed: Vec<Option<usize>> = vec![None; mesh.elements.len()];
        for (k, stage) in case.stages.iter().enumerate() {
            for written in &stage.install {
                let Some(elements) = fitting(written, mesh, problems) else { continue };
                let void = elements.iter().find(|&&e| self.body_of[e as usize].is_none());
                if let Some(&e) = void {
                    problems.push(Problem::at(
                        written,
                        format!(
                            "element {} is void: nothing can be installed there",
                            mesh.element_id(e as usize)
                        ),
                        "give its group a [[region]] with a material",
                    ));
                    continue;
                }
                let twice = |e: &u32| installed[*e as usize].filter(|&first| first != k);
                if let Some((e, first)) = elements.iter().find_map(|e| Some((*e, twice(e)?))) {
                    problems.push(Problem::at(
                        written,
                        format!(
                            "element {} is installed in '{}' already",
                            mesh.element_id(e as usize),
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
    fn excavated(
        &mut self,
        case: &Case,
        mesh: &Mesh,
        installed: &[Option<usize>],
        problems: &mut Vec<Problem>,
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
                        Problem::at(written, format!("element {} {what}", mesh.element_id(e)), remedy)
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
                of_stage[k].extend(elements);
            }
        }
        for (life, k) in self.lives.iter_mut().zip(&own) {
            life.gone = k.map(before);
        }
        of_stage
    }

    /// Finds what stands in the place of what is installed, until when.
    fn stand_in(
        &mut self,
        case: &Case,
        mesh: &Mesh,
        bodies: &[Body],
        installed: &[Option<usize>],
        excavated: &[Vec<u32>],
        problems: &mut Vec<Problem>,
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
                problems.push(Problem::at(
                    before,
                    format!(
                        "no region is made of '{}', so nothing says which elements stand there before",
                        case.materials[before.value].name.value
                    ),
                    "name the material of a [[region]], as that of the rock around",
                ));
            }
        }
        let targets: Vec<u32> =
            (0u32..).zip(installed).filter(|(_, k)| k.is_some()).map(|(e, _)| e).collect();
        let void = (0u32..).zip(&self.body_of).filter(|(_, b)| b.is_none()).map(|(e, _)| e).collect();
        let seeds: Vec<Vec<u32>> = std::iter::once(void).chain(excavated.iter().cloned()).collect();
        let nearest = nearest_through_faces(mesh, &targets, &seeds);
        let beside = Beside::of(mesh, &self.body_of, installed);
        let mut refused: Vec<usize> = Vec::new();
        for (&e, nearest) in targets.iter().zip(nearest) {
            let Some(born) = installed[e as usize] else { continue };
            // Void from the start: nothing stands in.
            if nearest == Some(0) {
                continue;
            }
            let gone = nearest.map(|k| k - 1).filter(|&k| k <= born);
            let Some(gone) = gone else {
                if !refused.contains(&born) {
                    refused.push(born);
                    let stage = &case.stages[born];
                    let when = nearest.map_or("for good".to_owned(), |k| {
                        format!("until '{}'", case.stages[k - 1].name.value)
                    });
                    problems.push(Problem::at(
                        &stage.name,
                        format!(
                            "'{}' installs element {}, but rock stands in its place {when}",
                            stage.name.value,
                            mesh.element_id(e as usize)
                        ),
                        "excavate what is beside it first, or in the same stage",
                    ));
                }
                continue;
            };
            let own = self.body_of[e as usize];
            let Some(body) = before_of(case, bodies, own).or_else(|| beside.body(mesh, e)) else {
                problems.push(Problem::at(
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

    /// Bodies with the elements that are there in the end alone.
    pub fn lasting(&self, bodies: &[Body]) -> Vec<Body> {
        let lasts = |e: &u32| self.lives[*e as usize].holds(Stage::Shaking);
        let keep = |body: &Body| Body {
            elements: body.elements.iter().copied().filter(lasts).collect(),
            ..body.clone()
        };
        bodies.iter().map(keep).collect()
    }

    /// The stages of the plan; none if nothing comes before the earthquake.
    pub fn plan(case: &Case) -> Vec<PlannedStage> {
        if case.stages.is_empty() && case.initial.stress.is_none() {
            return Vec::new();
        }
        let initial = &case.initial;
        let tolerance = initial.tolerance.value;
        let release = |share: f64| Release {
            share,
            cycles: u64::from(initial.release_cycles.value),
            tolerance: [tolerance, MOTION * tolerance],
            most: u64::from(initial.max_cycles.value),
        };
        let first = PlannedStage { release: release(1.0), ..PlannedStage::new(EQUILIBRIUM) };
        let names = |patterns: &[Spanned<String>]| patterns.iter().map(|p| p.value.clone()).collect();
        let more = case.stages.iter().map(|stage| PlannedStage {
            release: release(stage.release.value),
            excavated: names(&stage.excavate),
            installed: names(&stage.install),
            changed: changes(case, stage),
            ..PlannedStage::new(stage.name.value.clone())
        });
        std::iter::once(first).chain(more).collect()
    }

    /// Puts lives, stand-ins, initial stress and what presses into a problem whose mesh is as it was read.
    pub fn fill(self, case: &Case, space: &mut Space) {
        if let Some(stress) = &case.initial.stress {
            let weight =
                |b: Option<usize>| b.map_or(0.0, |b| space.bodies[b].density * case.initial.gravity.value);
            let unit_weight: Vec<f64> = self.at_start().into_iter().map(weight).collect();
            space.initial = initial::stresses(case, stress, &space.mesh, &unit_weight);
            space.gravity = case.initial.gravity.value;
        }
        let stages = if case.initial.stress.is_some() {
            case.stages.len() + 1
        } else {
            case.stages.len() + usize::from(!case.stages.is_empty())
        };
        let faces = Walls::of(&space.mesh);
        let plain = space.mesh.elements.len();
        let mut shown: Vec<u32> = (0..plain as u32).collect();
        if !self.stand_ins.is_empty() {
            space.mesh.element_ids = (0..plain).map(|e| space.mesh.element_id(e)).collect();
        }
        space.lives = self.lives;
        for (of, body, life) in self.stand_ins {
            let e = space.mesh.elements.len() as u32;
            space.mesh.elements.push(space.mesh.elements[of as usize]);
            space.mesh.element_ids.push(space.mesh.element_id(of as usize));
            space.bodies[body].elements.push(e);
            space.lives.push(life);
            space.stand_ins.push((e, of));
            shown.push(of);
            if let Some(&stress) = space.initial.get(of as usize) {
                space.initial.push(stress);
            }
        }
        let mut last: HashMap<u32, u32> = HashMap::new();
        for Version { element: of, body, life } in self.versions {
            let e = space.mesh.elements.len() as u32;
            if space.mesh.element_ids.is_empty() {
                space.mesh.element_ids = (0..plain).map(|e| space.mesh.element_id(e)).collect();
            }
            space.mesh.elements.push(space.mesh.elements[of as usize].clone());
            space.mesh.element_ids.push(space.mesh.element_id(of as usize));
            space.bodies[body].elements.push(e);
            space.lives.push(life);
            space.stand_ins.push((e, of));
            shown.push(of);
            if let Some(&stress) = space.initial.get(of as usize) {
                space.initial.push(stress);
            }
            if let Some(earlier) = last.insert(of, e) {
                space.successors.push((e, earlier));
            }
        }
        space.successors.extend(last);
        space.successors.sort_unstable();
        let mut solid = vec![false; space.mesh.elements.len()];
        space.bodies.iter().flat_map(|b| &b.elements).for_each(|&e| solid[e as usize] = true);
        let bounds = space.mesh.bounds();
        for k in 0..stages {
            let stage = Stage::Before(k as u16);
            let standing: Vec<u32> = (0..solid.len() as u32)
                .filter(|&e| solid[e as usize] && space.lives[e as usize].holds(stage))
                .collect();
            let life = Life {
                born: stage,
                gone: Some(if k + 1 < stages { Stage::Before(k as u16 + 1) } else { Stage::Shaking }),
            };
            let outer = OuterFaces::of(&space.mesh, bounds, &standing);
            let mut acting = loads(case, k, &space.mesh, &standing, &shown, &faces, &outer);
            acting.extend(sides(&space.initial, space.sides, &self.places, &shown, &outer));
            if !acting.is_empty() {
                space.tractions.push(Traction {
                    name: format!("pressures in stage {k}"),
                    faces: acting,
                    life,
                });
            }
        }
    }

    /// The body of what is there at the start in each place.
    fn at_start(&self) -> Vec<Option<usize>> {
        let mut all: Vec<Option<usize>> = self
            .body_of
            .iter()
            .zip(&self.lives)
            .map(|(body, life)| body.filter(|_| !life.is_later()))
            .collect();
        self.stand_ins.iter().for_each(|&(e, body, _)| all[e as usize] = Some(body));
        let from_start = self.versions.iter().filter(|version| !version.life.is_later());
        from_start.for_each(|version| all[version.element as usize] = Some(version.body));
        all
    }
}

/// What a stage changes besides what stands, a phrase each.
fn changes(case: &Case, stage: &case::Stage) -> Vec<String> {
    let materials = stage.materials.iter().map(|(groups, material)| {
        format!("{} becomes {}", groups.value, case.materials[material.value].name.value)
    });
    let pressure = |p: f64| case::units::format(p, Dimension::PRESSURE);
    let pressures =
        stage.pressures.iter().map(|(face, p)| format!("{} on {}", pressure(p.value), face.value));
    materials.chain(pressures).collect()
}

/// Name of what comes before all stages of a case.
pub const EQUILIBRIUM: &str = "initial equilibrium";

/// The elements of the groups that a pattern fits.
fn fitting(written: &Spanned<String>, mesh: &Mesh, problems: &mut Vec<Problem>) -> Option<Vec<u32>> {
    let groups = mesh.groups.iter().filter(|(name, _)| pattern::matches(written, name));
    let mut elements: Vec<u32> = groups.flat_map(|(_, elements)| elements).copied().collect();
    elements.sort_unstable();
    elements.dedup();
    if elements.is_empty() {
        let known: Vec<&str> = mesh.groups.keys().map(String::as_str).collect();
        problems.push(Problem::at(
            written,
            format!("no group of the mesh fits '{}'", written.value),
            format!("the mesh has the groups {}", known.join(", ")),
        ));
        return None;
    }
    Some(elements)
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
    faces: HashMap<[u32; 4], Vec<u32>>,
    /// The body of what stands from the start.
    body_of: Vec<Option<usize>>,
}

impl Beside {
    fn of(mesh: &Mesh, body_of: &[Option<usize>], installed: &[Option<usize>]) -> Beside {
        let mut faces: HashMap<[u32; 4], Vec<u32>> = HashMap::new();
        all_faces(mesh, None)
            .for_each(|face| faces.entry(face_key(mesh, face)).or_default().push(face.element));
        let own = body_of.iter().zip(installed).map(|(body, k)| body.filter(|_| k.is_none())).collect();
        Beside { faces, body_of: own }
    }

    /// The body that shares most faces with an element, or with the elements nearest to it that have such a neighbour.
    fn body(&self, mesh: &Mesh, element: u32) -> Option<usize> {
        let mut ring = vec![element];
        let mut seen: std::collections::HashSet<u32> = ring.iter().copied().collect();
        while !ring.is_empty() {
            let mut shared: BTreeMap<usize, usize> = BTreeMap::new();
            let mut next = Vec::new();
            for face in all_faces(mesh, Some(&ring)) {
                for &other in &self.faces[&face_key(mesh, face)] {
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

/// Faces by their nodes, with the elements on both sides.
struct Walls(HashMap<[u32; 4], Vec<u32>>);

impl Walls {
    fn of(mesh: &Mesh) -> Walls {
        let mut faces: HashMap<[u32; 4], Vec<u32>> = HashMap::new();
        all_faces(mesh, None)
            .for_each(|face| faces.entry(face_key(mesh, face)).or_default().push(face.element));
        Walls(faces)
    }
}

/// Pressures that act in a stage: on the top plane, and between the void and groups on either side.
fn loads(
    case: &Case,
    stage: usize,
    mesh: &Mesh,
    standing: &[u32],
    shown: &[u32],
    walls: &Walls,
    outer: &OuterFaces,
) -> Vec<(Face, [f64; 6])> {
    let tensor = |p: f64| [-p, -p, -p, 0.0, 0.0, 0.0];
    let mut acting = Vec::new();
    let top = &outer.planes[2][1];
    let overburden = case.initial.overburden.as_ref().map_or(0.0, |p| p.value);
    // The last word of each pattern so far.
    let mut pressures: BTreeMap<&str, f64> = BTreeMap::new();
    for written in case.stages.iter().take(stage) {
        written.pressures.iter().for_each(|(pattern, p)| {
            pressures.insert(pattern.value.as_str(), p.value);
        });
    }
    let on_top = overburden + pressures.remove(TOP).unwrap_or(0.0);
    if on_top > 0.0 {
        acting.extend(top.iter().map(|&face| (face, tensor(on_top))));
    }
    if pressures.is_empty() {
        return acting;
    }
    let on_side: std::collections::HashSet<Face> = outer.planes.iter().flatten().flatten().copied().collect();
    for (pattern, p) in pressures {
        let mut inside = vec![false; mesh.elements.len()];
        mesh.groups
            .iter()
            .filter(|(name, _)| pattern::matches(pattern, name))
            .flat_map(|(_, elements)| elements)
            .for_each(|&e| inside[e as usize] = true);
        for face in exterior_faces(mesh, Some(standing)) {
            let own = shown[face.element as usize];
            let key = face_key(mesh, face);
            let beside = || walls.0.get(&key).into_iter().flatten().filter(|&&e| e != own);
            if !on_side.contains(&face) && (inside[own as usize] || beside().any(|&e| inside[e as usize])) {
                acting.push((face, tensor(p)));
            }
        }
    }
    acting
}

/// The word for the top plane where groups stand.
const TOP: &str = "top";

/// Shear of the initial stress on side planes that rollers will hold, which these cannot carry.
fn sides(
    initial: &[[f64; 6]],
    sides: [Side; 2],
    places: &[Life],
    shown: &[u32],
    outer: &OuterFaces,
) -> Vec<(Face, [f64; 6])> {
    let mut acting = Vec::new();
    if initial.is_empty() {
        return acting;
    }
    for axis in 0..2 {
        if matches!(sides[axis], Side::Periodic | Side::Fixed) {
            continue;
        }
        for &face in outer.planes[axis].iter().flatten() {
            // What is installed later is free of stress; what stood there before is not.
            let of = shown[face.element as usize];
            if of == face.element && places[of as usize].is_later() {
                continue;
            }
            let [.., xy, yz, zx] = initial[face.element as usize];
            let shear = if axis == 0 { [0.0, 0.0, 0.0, xy, 0.0, zx] } else { [0.0, 0.0, 0.0, xy, yz, 0.0] };
            if shear.iter().any(|s| *s != 0.0) {
                acting.push((face, shear));
            }
        }
    }
    acting
}

/// The patterns of pressures that no group fits.
pub fn check_pressures(case: &Case, mesh: &Mesh, problems: &mut Vec<Problem>) {
    let written = case.stages.iter().flat_map(|stage| &stage.pressures);
    for (pattern, _) in written.filter(|(pattern, _)| pattern.value != TOP) {
        let _ = fitting(pattern, mesh, problems);
    }
}

/// Materials that stages would change, which is not computed yet.
pub fn check_materials(case: &Case, problems: &mut Vec<Problem>) {
    let written = case.stages.iter().flat_map(|stage| &stage.materials);
    problems.extend(written.map(|(pattern, _)| {
        Problem::at(
            pattern,
            "a stage does not change what stands there yet",
            "leave `material` out of the stage",
        )
    }));
}

/// What is unusual about a case's stages.
pub fn warnings(case: &Case) -> Vec<Problem> {
    let mut warnings = Vec::new();
    if let Some(last) = case.stages.last().filter(|stage| stage.release.value < 1.0) {
        warnings.push(Problem::at(
            &last.release,
            format!(
                "{:.0} % of what is held is never let go: it stays held in the shaking",
                100.0 * (1.0 - last.release.value)
            ),
            "add a stage with release = 1, or give this one",
        ));
    }
    if let (Some(first), None) = (case.stages.first(), &case.initial.stress) {
        warnings.push(Problem::at(
            &first.name,
            "there is no initial stress, so what is excavated lets nothing go",
            "give [initial] lateral, stress or measured",
        ));
    }
    if let Some(case::InitialStress::Measured(measured)) = &case.initial.stress {
        let left = initial::residuals(measured);
        let largest = left.iter().copied().fold(0.0, f64::max);
        let mean = measured.iter().flat_map(|m| m.stress).map(f64::abs).fold(0.0, f64::max);
        if largest > SCATTER * mean {
            let span: Range<usize> = measured.first().map_or(0..0, |m| m.span.clone());
            let left: Vec<String> = left.iter().map(|x| format!("{:.2}", x / 1e6)).collect();
            warnings.push(Problem::new(
                span,
                format!(
                    "measured stresses lie off a straight line over depth by {} MPa (xx, yy, zz, xy, yz, zx)",
                    left.join(", ")
                ),
                "look for those that are far off, or give the field with `stress`",
            ));
        }
    }
    warnings
}

/// Scatter of measured stresses over the largest that goes without saying.
const SCATTER: f64 = 0.2;
