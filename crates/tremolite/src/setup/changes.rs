//! Materials that change with a stage: what stands in a place is then another element, which takes over.

use super::groups::nothing_fits;
use super::regions;
use std::collections::BTreeMap;
use tremolite_case::{Case, Diagnostic, Fill, Region, Spanned, pattern};
use tremolite_engine::{Body, Life, Stage};
use tremolite_kernels::Law;
use tremolite_laws::band::Band;
use tremolite_laws::{Column, Role};
use tremolite_mesh::Mesh;

/// What an element is before it becomes what it is in the end.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Version {
    /// The element of the mesh as it was read, which is the last version.
    pub element: u32,
    pub body: usize,
    pub life: Life,
}

/// A change of an element's material, with its place in the case.
struct Change<'c> {
    stage: usize,
    material: usize,
    pattern: &'c Spanned<String>,
}

/// The engine's stage of one of a case's, which follow the initial equilibrium.
pub fn before(index: usize) -> Stage {
    Stage::Before(index as u16 + 1)
}

/// Works out all versions but the last of elements whose material changes, in the order of time; the last ones move to bodies of
/// their own, and begin with the last change.
pub fn versions(
    case: &Case,
    mesh: &Mesh,
    laws: &[Law],
    band: Option<Band>,
    bodies: &mut Vec<Body>,
    materials: &mut Vec<usize>,
    body_of: &mut [Option<usize>],
    lives: &mut [Life],
    problems: &mut Vec<Diagnostic>,
) -> Vec<Version> {
    let changes = changes(case, mesh, body_of, lives, problems);
    if !problems.is_empty() || changes.is_empty() {
        return Vec::new();
    }
    let solid: Vec<&Region> = case.regions.iter().filter(|r| matches!(r.fill, Fill::Solid { .. })).collect();
    // By region, and material other than its own.
    let mut made: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    let mut versions = Vec::new();
    for (element, changes) in changes {
        let e = element as usize;
        let Some(own) = body_of[e] else { continue };
        let Fill::Solid { material, .. } = &solid[own].fill else { continue };
        let (mut now, mut body) = (material.value, own);
        let mut born = lives[e].born;
        for change in changes {
            if change.material == now {
                continue;
            }
            let key = (own, change.material);
            let next = if change.material == material.value {
                own
            } else if let Some(&known) = made.get(&key) {
                known
            } else {
                let of = &case.materials[change.material];
                let Some(built) = regions::body(case, mesh, solid[own], of, Vec::new(), laws, band, problems)
                else {
                    return Vec::new();
                };
                let name = format!("{} of {}", built.name, of.name.value);
                bodies.push(Body { name, ..built });
                materials.push(change.material);
                made.insert(key, bodies.len() - 1);
                bodies.len() - 1
            };
            if let Some(lost) = lost(&bodies[body], &bodies[next]) {
                problems.push(Diagnostic::at(
                    change.pattern,
                    format!(
                        "'{}' keeps {lost}, which '{}' does not know: it would heal",
                        case.materials[now].name.value, case.materials[change.material].name.value
                    ),
                    "change to a material of the same law, or of one that keeps it as well",
                ));
                return Vec::new();
            }
            versions.push(Version { element, body, life: Life { born, gone: Some(before(change.stage)) } });
            (now, body, born) = (change.material, next, before(change.stage));
        }
        lives[e].born = born;
        if body != own {
            bodies[own].elements.retain(|&other| other != element);
            bodies[body].elements.push(element);
            body_of[e] = Some(body);
        }
    }
    versions
}

/// The changes of each element, in the order of stages.
fn changes<'c>(
    case: &'c Case,
    mesh: &Mesh,
    body_of: &[Option<usize>],
    lives: &[Life],
    problems: &mut Vec<Diagnostic>,
) -> BTreeMap<u32, Vec<Change<'c>>> {
    let mut all: BTreeMap<u32, Vec<Change>> = BTreeMap::new();
    for (stage, written) in case.stages.iter().enumerate() {
        for (pattern, material) in &written.materials {
            let groups: Vec<&Vec<u32>> = mesh
                .groups
                .iter()
                .filter(|(name, _)| pattern::matches(pattern, name))
                .map(|(_, e)| e)
                .collect();
            if groups.is_empty() {
                problems.push(nothing_fits(mesh, pattern));
                continue;
            }
            for &e in groups.into_iter().flatten() {
                let there = body_of[e as usize].is_some()
                    && lives[e as usize].born < before(stage)
                    && lives[e as usize].gone.is_none_or(|gone| gone > before(stage));
                if !there {
                    problems.push(Diagnostic::at(
                        pattern,
                        format!(
                            "element {} does not stand through '{}'",
                            mesh.element_id(e as usize),
                            written.name.value
                        ),
                        "change the material of what was there before and is not excavated in the same stage",
                    ));
                    break;
                }
                let own = all.entry(e).or_default();
                // Groups may overlap; the last word in a stage counts.
                own.retain(|change| change.stage != stage);
                own.push(Change { stage, material: material.value, pattern });
            }
        }
    }
    all
}

/// What a law keeps of damage and flow that another has nothing for.
fn lost(old: &Body, new: &Body) -> Option<&'static str> {
    let holds = |columns: &[Column], role: Role| columns.iter().any(|c| c.role == role);
    let (old, new) = (old.material.info().history, new.material.info().history);
    let kept = [
        (Role::TensionDamage, "damage in tension"),
        (Role::ShearDamage, "damage in shear"),
        (Role::PlasticShear, "plastic shear strain"),
        (Role::PlasticTension, "plastic tension strain"),
        (Role::PlasticStrain, "plastic strain"),
    ];
    kept.into_iter().find(|(role, _)| holds(old, *role) && !holds(new, *role)).map(|(_, word)| word)
}
