//! What of a case's ground stands in water: what may not, what weighs more for it, and what is unusual.

use super::stages::Staged;
use super::undrained;
use super::water::{levels, mean, pores};
use std::collections::{BTreeMap, BTreeSet};
use tremolite_case::{Case, Diagnostic, MaterialWater, Pressure, Spanned};
use tremolite_engine::{Body, Life, Problem, Stage};
use tremolite_mesh::Mesh;
use tremolite_mesh::topology::{all_faces, face_key};

/// Looks at what has water in its pores, and gives it its weight.
pub fn soak(
    case: &Case,
    mesh: &Mesh,
    bodies: &mut Vec<Body>,
    staged: &mut Staged,
    problems: &mut Vec<Diagnostic>,
) {
    if case.water.is_some() && problems.is_empty() {
        check(case, mesh, bodies, staged, problems);
        undrained::check(case, bodies, &staged.materials, problems);
        saturate(case, mesh, bodies, staged);
    }
}

/// Refuses pores where none can be, and rock below the water that does not say whether it has some.
fn check(case: &Case, mesh: &Mesh, bodies: &[Body], staged: &Staged, problems: &mut Vec<Diagnostic>) {
    let levels = levels(case);
    let Some(highest) = levels.iter().copied().reduce(f64::max) else { return };
    let mut told = vec![false; case.materials.len()];
    for (b, body) in bodies.iter().enumerate() {
        let Some(&of) = staged.materials.get(b) else { continue };
        let material = &case.materials[of];
        if std::mem::replace(&mut told[of], true) {
            continue;
        }
        let damages = body.material.info().damages;
        match &material.water {
            Some(MaterialWater::Pores(pores)) if damages => problems.push(Diagnostic::at(
                &pores.biot,
                format!("'{}' cracks by damage, which does not know water in pores", material.name.value),
                "write water = \"none\", or leave it out: water presses on its faces alone",
            )),
            None if !damages => {
                let of_material = |b: usize| staged.materials[b] == of;
                let wet = staged
                    .standing()
                    .find(|&(e, body, _)| of_material(body) && mean(case, mesh, e as usize, highest) > 0.0);
                if let Some((e, ..)) = wet {
                    problems.push(Diagnostic::at(
                        &material.name,
                        format!(
                            "element {} of '{}' lies below the water level, and nothing is said of its pores",
                            mesh.element_id(e as usize),
                            material.name.value
                        ),
                        "give it `water = { biot = 1 }`, or `water = \"none\"` if it has no pores",
                    ));
                }
            }
            _ => {}
        }
    }
}

/// Gives what stands in water from where it begins the weight of its material with water: such elements are bodies of their own, or their
/// body is all of them.
fn saturate(case: &Case, mesh: &Mesh, bodies: &mut Vec<Body>, staged: &mut Staged) {
    let levels = levels(case);
    let gravity = case.initial.gravity.value;
    for b in 0..if levels.is_empty() { 0 } else { bodies.len() } {
        let Some(weight) = pores(case, staged.materials[b]).and_then(|p| p.saturated_unit_weight.as_ref())
        else {
            continue;
        };
        let all: Vec<(u32, bool)> = staged
            .standing()
            .filter(|(_, body, _)| *body == b)
            .map(|(e, _, life)| (e, mean(case, mesh, e as usize, levels[stage_of(life)]) > 0.0))
            .collect();
        if !all.iter().any(|(_, wet)| *wet) {
            continue;
        }
        let density = weight.value / gravity;
        if all.iter().all(|(_, wet)| *wet) {
            bodies[b].density = density;
            continue;
        }
        let wet: BTreeSet<u32> = all.iter().filter(|(_, wet)| *wet).map(|(e, _)| *e).collect();
        let name = format!("{}, saturated", bodies[b].name);
        let (under, above) = bodies[b].elements.iter().partition(|e| wet.contains(e));
        bodies[b].elements = above;
        let soaked = Body { name, elements: under, density, ..bodies[b].clone() };
        bodies.push(soaked);
        staged.materials.push(staged.materials[b]);
        staged.saturated.push(bodies.len() - 1);
        staged.move_to(b, bodies.len() - 1, |e| wet.contains(&e));
    }
}

/// The number of the stage with which a life begins.
fn stage_of(life: Life) -> usize {
    match life.born {
        Stage::Before(k) => k.into(),
        Stage::Shaking => 0,
    }
}

/// Heads of the case and its stages, with their places.
fn heads(case: &Case) -> impl Iterator<Item = &(Spanned<String>, Spanned<f64>)> {
    let first = case.water.iter().flat_map(|water| &water.heads);
    first.chain(case.stages.iter().flat_map(|stage| &stage.water.heads))
}

/// What is unusual about a case's water. The problem has its mesh as it was read, bodies and interfaces.
pub fn warnings(case: &Case, space: &Problem, staged: &Staged) -> Vec<Diagnostic> {
    let (levels, Some(water)) = (levels(case), &case.water) else { return Vec::new() };
    let mesh = &space.mesh;
    let mut all = tied(case, space, staged);
    // What is taken out below the level leaves its walls under the pressure of still water.
    let flows = water.pressure.value == Pressure::Seepage;
    let below = staged.standing().filter(|_| !flows).find(|&(e, body, life)| {
        let Some(Stage::Before(gone)) = life.gone else { return false };
        // Another material takes over, or something is placed in the same stage.
        if staged.places[e as usize].holds(Stage::Before(gone)) {
            return false;
        }
        let porous = pores(case, staged.materials[body]).is_some();
        porous && mean(case, mesh, e as usize, levels[usize::from(gone)]) > 0.0
    });
    if let Some((e, _, life)) = below {
        let stage = match life.gone {
            Some(Stage::Before(k)) => k,
            _ => 0,
        };
        let name =
            case.stages.get(usize::from(stage).saturating_sub(1)).map_or("", |s| s.name.value.as_str());
        all.push(Diagnostic::at(
            &water.level,
            format!(
                "'{name}' takes out ground below the water level (element {}), while pressures in the rock stay those of still water: its \
                 walls are pushed in by all of it",
                mesh.element_id(e as usize)
            ),
            "let the water flow to it: pressure = \"seepage\" with heads, and `hydraulic_conductivity` of the rock; or lower the `level` of that stage below \
             the opening",
        ));
    }
    let (low, high) = mesh.bounds();
    if !levels.iter().any(|level| *level > low[2]) {
        all.push(Diagnostic::at(
            &water.level,
            format!("the water level lies below the model, which ends at z = {} m", low[2]),
            "heights are along z, upwards; leave [water] out if the ground is dry",
        ));
    }
    if let Some((place, head)) = heads(case).find(|(_, head)| head.value > high[2]) {
        all.push(Diagnostic::at(
            head,
            format!(
                "the head at '{}' lies {:.1} m above the highest ground, on which that water would press, and does not",
                place.value,
                head.value - high[2]
            ),
            "for a lake give filled = { top = … } in the stage, which presses and is a head; else give heads below the ground's surface",
        ));
    }
    if levels[0] > high[2] {
        all.push(Diagnostic::at(
            &water.level,
            format!(
                "the water level lies above the model, which ends at z = {} m: nothing presses on its top",
                high[2]
            ),
            "give the water above by [initial] overburden, or lower the level",
        ));
    }
    all
}

/// Tight bodies that share faces with ground whose pressure changes after both stand: no water comes between them.
fn tied(case: &Case, space: &Problem, staged: &Staged) -> Vec<Diagnostic> {
    let (levels, mesh) = (levels(case), &space.mesh);
    let mut of_element: Vec<Option<(usize, Life)>> = vec![None; mesh.elements.len()];
    // From when on something of its own stands there, whatever its material.
    let since = |e: u32, life: Life| Life { born: staged.places[e as usize].born, ..life };
    staged.own().for_each(|(e, body, life)| of_element[e as usize] = Some((body, since(e, life))));
    let mut faces: BTreeMap<[u32; 4], Vec<u32>> = BTreeMap::new();
    all_faces(mesh, None).for_each(|face| faces.entry(face_key(mesh, face)).or_default().push(face.element));
    let parted = |a: u32, b: u32| {
        let across = |[first, second]: &[Vec<u32>; 2]| {
            let has = |side: &Vec<u32>, e: u32| side.binary_search(&e).is_ok();
            (has(first, a) && has(second, b)) || (has(first, b) && has(second, a))
        };
        space.interfaces.iter().any(|interface| across(&interface.sides))
    };
    let mut told: BTreeMap<[usize; 2], Diagnostic> = BTreeMap::new();
    for pair in faces.values().filter(|both| both.len() == 2) {
        for [tight, rock] in [[pair[0], pair[1]], [pair[1], pair[0]]] {
            let both = [tight, rock].map(|e| of_element[e as usize]);
            let [Some((own, life)), Some((beside, of_rock))] = both else { continue };
            let porous = [own, beside].map(|body| pores(case, staged.materials[body]).is_some());
            if porous != [false, true] || told.contains_key(&[own, beside]) || parted(tight, rock) {
                continue;
            }
            let from = stage_of(life).max(stage_of(of_rock));
            let stand = |k: usize| [life, of_rock].iter().all(|life| life.holds(Stage::Before(k as u16)));
            let p = |k: usize| mean(case, mesh, rock as usize, levels[k]);
            let Some(k) = (from + 1..levels.len()).find(|&k| stand(k) && p(k) != p(k - 1)) else { continue };
            let Some(level) = &case.stages[k - 1].water.level else { continue };
            let [tight, rock] = [own, beside].map(|body| &space.bodies[body].name);
            let told_of = Diagnostic::at(
                level,
                format!(
                    "'{tight}' is watertight and bonded to '{rock}': it does not feel the water behind it"
                ),
                "if it holds water, give it an unbonded [[interface]]: it then carries the head",
            );
            told.insert([own, beside], told_of);
        }
    }
    told.into_values().collect()
}
