//! Stages of a case: what stands when, in whose place, under what.

mod exposed;
mod faces;
mod lives;
mod moved;
mod pressures;

pub use moved::{bed, check_moved};
pub use pressures::check_pressures;

use super::changes::{Version, before, versions};
use super::groups::nothing_fits;
use super::{initial, interfaces, seepage, water};
use crate::stages::PlannedStage;
use faces::Faces;
use pressures::{Around, loads, sides};
use std::collections::HashMap;
use std::ops::Range;
use tremolite_case::{self as case, Case, Diagnostic, Spanned, pattern};
use tremolite_engine::Traction;
use tremolite_engine::engine::Release;
use tremolite_engine::outer_faces::OuterFaces;
use tremolite_engine::{Base, Bed, Body, Life, Problem, Stage};
use tremolite_kernels::Law;
use tremolite_laws::Dimension;
use tremolite_laws::band::Band;
use tremolite_mesh::Mesh;
use tremolite_results::{Said, said};

/// Motion left over that of the stage, over the tolerance of what is out of balance.
const MOTION: f64 = 100.0;

/// How many times as long nodes are moved as forces are let go: they pull all that hangs on them along.
const SLOWER: u64 = 5;

/// How much nearer to rest a stage comes behind which something is installed: a lining carries a hundredth of what an excavation
/// let go.
const BEFORE_INSTALLATION: f64 = 0.1;

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
    /// The material of each body, a place in the case's list; of more than these nothing is known.
    pub materials: Vec<usize>,
    /// Bodies that were made of what weighs more for its water.
    pub saturated: Vec<usize>,
    /// What is unusual about it.
    warnings: Vec<Diagnostic>,
}

impl Staged {
    /// Works out the lives of a case's elements.
    pub fn build(
        case: &Case,
        mesh: &Mesh,
        bodies: &mut Vec<Body>,
        laws: &[Law],
        band: Option<Band>,
        problems: &mut Vec<Diagnostic>,
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
            materials: case.regions.iter().filter_map(material_of).collect(),
            saturated: Vec::new(),
            warnings: Vec::new(),
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
            let Staged { body_of, lives, materials, .. } = &mut staged;
            staged.versions = versions(case, mesh, laws, band, bodies, materials, body_of, lives, problems);
        }
        staged
    }

    /// What each element is made of in the end: the element, its body and its life as that.
    pub fn own(&self) -> impl Iterator<Item = (u32, usize, Life)> + '_ {
        let all = (0u32..).zip(self.body_of.iter().zip(&self.lives));
        all.filter_map(|(e, (body, life))| Some((e, (*body)?, *life)))
    }

    /// All that stands at some time: the element of the mesh in whose place, its body, and from when on there is something of its kind
    /// there and until when.
    pub fn standing(&self) -> impl Iterator<Item = (u32, usize, Life)> + '_ {
        let versions = self.versions.iter().map(|version| (version.element, version.body, version.life));
        let placed = self
            .own()
            .chain(versions)
            .map(|(e, body, life)| (e, body, Life { born: self.places[e as usize].born, ..life }));
        placed.chain(self.stand_ins.iter().copied())
    }

    /// Puts what stands in some places from one body into another, beside the bodies' own lists.
    pub fn move_to(&mut self, from: usize, to: usize, which: impl Fn(u32) -> bool) {
        let own = (0u32..).zip(self.body_of.iter_mut().flatten());
        let stand_ins = self.stand_ins.iter_mut().map(|(e, body, _)| (*e, body));
        let versions = self.versions.iter_mut().map(|version| (version.element, &mut version.body));
        for (_, body) in own.chain(stand_ins).chain(versions).filter(|(e, body)| **body == from && which(*e))
        {
            *body = to;
        }
    }

    /// Life of each element of the mesh as it was read.
    pub fn lives(&self) -> &[Life] {
        &self.lives
    }

    /// Whether each element is made of something.
    pub fn solid(&self) -> Vec<bool> {
        self.body_of.iter().map(Option::is_some).collect()
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

    /// The stages of the plan; none if there are no stages before the earthquake.
    pub fn plan(case: &Case) -> Vec<PlannedStage> {
        if !case.seeks_equilibrium() {
            return Vec::new();
        }
        let initial = &case.initial;
        let tolerance = initial.tolerance.value;
        // What is left before something is installed would load it.
        let installs = |k: usize| case.stages.get(k).is_some_and(|stage| !stage.install.is_empty());
        let release = |share: f64, next: usize, longer: u64| Release {
            share,
            cycles: longer * u64::from(initial.release_cycles.value),
            tolerance: [
                tolerance,
                MOTION * tolerance * if installs(next) { BEFORE_INSTALLATION } else { 1.0 },
            ],
            most: longer * u64::from(initial.max_cycles.value),
        };
        let first = PlannedStage { release: release(1.0, 0, 1), ..PlannedStage::new(EQUILIBRIUM) };
        let names = |patterns: &[Spanned<String>]| patterns.iter().map(|p| p.value.clone()).collect();
        let more = case.stages.iter().enumerate().map(|(k, stage)| PlannedStage {
            release: release(stage.release.value, k + 1, if stage.moves { SLOWER } else { 1 }),
            excavated: names(&stage.excavate),
            installed: names(&stage.install),
            changed: changes(case, stage),
            ..PlannedStage::new(stage.name.value.clone())
        });
        std::iter::once(first).chain(more).collect()
    }

    /// Puts lives, stand-ins, initial stress and what presses into a problem whose mesh is as it was read. Says what is unusual.
    pub fn fill(mut self, case: &Case, space: &mut Problem) -> Vec<Diagnostic> {
        let mut warnings = std::mem::take(&mut self.warnings);
        if let Some(stress) = &case.initial.stress {
            let weight =
                |b: Option<usize>| b.map_or(0.0, |b| space.bodies[b].density * case.initial.gravity.value);
            let at_start = self.at_start();
            let pore = water::beside_lateral(case, &space.mesh, &self.materials, &at_start);
            let unit_weight: Vec<f64> = at_start.into_iter().map(weight).collect();
            space.initial = initial::stresses(case, stress, &space.mesh, &unit_weight, &pore);
            space.gravity = case.initial.gravity.value;
        }
        let stages = if case.seeks_equilibrium() { case.stages.len() + 1 } else { 0 };
        let walls = Faces::of(&space.mesh);
        let mut shown: Vec<u32> = (0..space.mesh.elements.len() as u32).collect();
        space.lives = self.lives;
        let mut stand_ins = Vec::new();
        for (of, body, life) in self.stand_ins {
            shown.push(of);
            stand_ins.push(interfaces::StandIn { element: add(space, of, body, life), of, body });
        }
        interfaces::part_stand_ins(case, space, &self.places, &stand_ins);
        let mut last: HashMap<u32, u32> = HashMap::new();
        for Version { element: of, body, life } in self.versions {
            shown.push(of);
            let e = add(space, of, body, life);
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
            let around = Around {
                mesh: &space.mesh,
                standing: &standing,
                shown: &shown,
                places: &self.places,
                walls: &walls,
            };
            // Each step of a stage has its place.
            let first = k < 2 || case.stages[k - 1].span != case.stages[k - 2].span;
            if first {
                warnings.extend(moved::gone(case, k, &space.mesh, &standing, &shown));
            }
            let mut acting = loads(case, k, &around, &outer, &mut warnings);
            acting.extend(sides(
                &space.initial,
                space.sides,
                bed(case).rollers,
                &self.places,
                &shown,
                &outer,
            ));
            if !acting.is_empty() {
                space.tractions.push(Traction {
                    name: format!("pressures in stage {k}"),
                    faces: acting,
                    life,
                });
            }
        }
        space.bed = bed(case);
        // Nothing comes in and nothing leaves: a specimen stands on no ground, and beside none.
        if case.motion.is_none() && space.bed != Bed::default() {
            space.base = Base::Free;
        }
        space.prescribed = moved::prescribed(case, &space.mesh, &shown);
        warnings
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

/// The material of a solid region.
fn material_of(region: &case::Region) -> Option<usize> {
    match &region.fill {
        case::Fill::Solid { material, .. } => Some(material.value),
        case::Fill::Void => None,
    }
}

/// Puts an element into a body that stands in the place of another, under that one's number and initial stress.
fn add(space: &mut Problem, of: u32, body: usize, life: Life) -> u32 {
    let e = space.mesh.elements.len();
    if space.mesh.element_ids.is_empty() {
        space.mesh.element_ids = (0..e).map(|e| space.mesh.element_id(e)).collect();
    }
    space.mesh.elements.push(space.mesh.elements[of as usize]);
    space.mesh.element_ids.push(space.mesh.element_id(of as usize));
    space.bodies[body].elements.push(e as u32);
    space.lives.push(life);
    space.stand_ins.push((e as u32, of));
    if let Some(&stress) = space.initial.get(of as usize) {
        space.initial.push(stress);
    }
    e as u32
}

/// What a stage changes besides what stands, a phrase each.
fn changes(case: &Case, stage: &case::Stage) -> Vec<Said> {
    let materials = stage.materials.iter().map(|(groups, material)| {
        let material = &case.materials[material.value].name.value;
        said!("{groups} becomes {material}", groups = &groups.value, material = material)
    });
    let pressure = |p: f64| case::units::format(p, Dimension::PRESSURE);
    let pressures = stage
        .pressures
        .iter()
        .map(|(face, p)| said!("{pressure} on {face}", pressure = pressure(p.value), face = &face.value));
    let bolts = stage.bolts.iter().map(|bolts| said!("bolts '{name}' placed", name = &bolts.name.value));
    let moved = stage.displacements.iter().filter(|_| stage.moves).flat_map(|one| {
        let ways = ["ux", "uy", "uz"].into_iter().zip(one.to);
        ways.filter_map(|(way, to)| to.filter(|to| *to != 0.0).map(|to| (way, to))).map(|(way, to)| {
            let to = case::units::format(to, Dimension::LENGTH);
            said!("{name} moved to {way} = {to}", name = &one.name, way = way, to = to)
        })
    });
    let level = stage.water.level.iter();
    let level = level.map(|level| said!("water level at {level}", level = water::shown(level.value)));
    let filled = stage.water.filled.iter().map(|(face, level)| {
        said!("{face} full of water to {level}", face = &face.value, level = water::shown(level.value))
    });
    materials
        .chain(pressures)
        .chain(level)
        .chain(filled)
        .chain(seepage::changes(stage))
        .chain(moved)
        .chain(bolts)
        .collect()
}

/// Name of what comes before all stages of a case.
pub const EQUILIBRIUM: &str = "initial equilibrium";

/// The elements of the groups that a pattern fits.
fn fitting(written: &Spanned<String>, mesh: &Mesh, problems: &mut Vec<Diagnostic>) -> Option<Vec<u32>> {
    let groups = mesh.groups.iter().filter(|(name, _)| pattern::matches(written, name));
    let mut elements: Vec<u32> = groups.flat_map(|(_, elements)| elements).copied().collect();
    elements.sort_unstable();
    elements.dedup();
    if elements.is_empty() {
        problems.push(nothing_fits(mesh, written));
        return None;
    }
    Some(elements)
}

/// Benches that no stage takes out though others of their cavern go: of a generated mesh their names say what is to be dug.
pub fn forgotten(case: &Case, mesh: &Mesh) -> Option<Diagnostic> {
    if !matches!(case.mesh, case::Mesh::Caverns(_)) {
        return None;
    }
    let dug = |name: &str| {
        let mut patterns = case.stages.iter().flat_map(|stage| &stage.excavate);
        patterns.any(|written| pattern::matches(written, name))
    };
    let cavern_of = |name: &str| {
        let (cavern, number) = name.rsplit_once(".bench")?;
        number.parse::<u32>().ok().map(|_| cavern.to_owned())
    };
    let benches: Vec<(String, &String)> =
        mesh.groups.keys().filter_map(|name| Some((cavern_of(name)?, name))).collect();
    // What a region leaves out from the beginning need not be taken out.
    let void = |name: &str| {
        let empty = case.regions.iter().filter(|region| region.fill == case::Fill::Void);
        empty.flat_map(|region| &region.groups).any(|written| pattern::matches(written, name))
    };
    let begun = |cavern: &str| benches.iter().any(|(of, name)| of == cavern && dug(name));
    let left = benches.iter().filter(|(cavern, name)| !dug(name) && !void(name) && begun(cavern));
    let left: Vec<&str> = left.map(|(_, name)| name.as_str()).collect();
    let last = case.stages.iter().rev().find(|stage| !stage.excavate.is_empty())?;
    (!left.is_empty()).then(|| {
        Diagnostic::at(
            &last.name,
            format!("no stage takes out {}, though other benches of the cavern go", left.join(", ")),
            "excavate it in a stage, this one or another",
        )
    })
}

/// What is unusual about a case's stages.
pub fn warnings(case: &Case) -> Vec<Diagnostic> {
    let mut warnings = Vec::new();
    if let Some(last) = case.stages.last().filter(|stage| stage.release.value < 1.0) {
        warnings.push(Diagnostic::at(
            &last.release,
            format!(
                "{:.0} % of what is held is never let go: it stays held in the shaking",
                100.0 * (1.0 - last.release.value)
            ),
            "add a stage with release = 1, or give this one",
        ));
    }
    let moves = case.stages.iter().any(|stage| !stage.displacements.is_empty());
    let excavates = case.stages.iter().any(|stage| !stage.excavate.is_empty());
    if let (Some(first), None) = (case.stages.first(), &case.initial.stress)
        && (excavates || !moves)
    {
        warnings.push(Diagnostic::at(
            &first.name,
            "there is no initial stress, so excavation releases nothing",
            "give [initial] lateral, stress or measured",
        ));
    }
    if let Some(case::InitialStress::Lateral { x, y, .. }) = &case.initial.stress
        && let Some(large) = [x, y].into_iter().find(|k| k.value > MOST_LATERAL)
    {
        warnings.push(Diagnostic::at(
            large,
            format!("the horizontal stress would be {} times the weight above", large.value),
            "give a ratio, 0.3 to 3 is usual; 60 % is 0.6",
        ));
    }
    if let Some(case::InitialStress::Measured(measured)) = &case.initial.stress {
        let left = initial::residuals(measured);
        let largest = left.iter().copied().fold(0.0, f64::max);
        let mean = measured.iter().flat_map(|m| m.stress).map(f64::abs).fold(0.0, f64::max);
        if largest > SCATTER * mean {
            let span: Range<usize> = measured.first().map_or(0..0, |m| m.span.clone());
            let left: Vec<String> = left.iter().map(|x| format!("{:.2}", x / 1e6)).collect();
            warnings.push(Diagnostic::new(
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

/// Horizontal over vertical stress beyond any that was measured at depth.
const MOST_LATERAL: f64 = 5.0;
/// Scatter of measured stresses over the largest that goes without saying.
const SCATTER: f64 = 0.2;
