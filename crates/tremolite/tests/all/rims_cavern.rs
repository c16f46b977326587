//! A cavern cut by a fault, from the first bench to the end of the earthquake.

use crate::bolts::bolts;
use crate::contact::between;
use crate::rims::{DENSITY, DEPTH, GRAVITY, LATERAL, SIZE, apart, close, lean};
use std::collections::BTreeMap;
use tremolite::hexahedra::centroid;
use tremolite::stages::settle;
use tremolite::{
    Assembly, Base, Body, Bolts, Engine, Incident, Life, Model, Phase, Problem, Quadrature, Side, Stage,
    State, elastic, stable_step,
};
use tremolite_laws::Moduli;
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::{Element, Mesh};
use tremolite_motion::{Motion, ricker_velocity};

const ELEMENTS: [u32; 3] = [16, 1, 16];
/// Of the pulse: peak frequency \[Hz\], centre and end \[s\], peak \[m/s\].
const PULSE: [f64; 4] = [20.0, 0.06, 0.15, 0.3];

/// A cavern of 9 × 6 m cut by a fault of 70°, excavated in four benches, lined in two steps and bolted across the fault; or its
/// mirror image.
pub fn cavern(mirrored: bool) -> Problem {
    let mut mesh = BoxSpec::uniform([0.0; 3], SIZE, ELEMENTS).mesh().unwrap();
    let at: Vec<[u32; 2]> =
        (0..ELEMENTS[0] * ELEMENTS[2]).map(|e| [e % ELEMENTS[0], e / ELEMENTS[0]]).collect();
    mesh.nodes.iter_mut().for_each(lean);
    let inside = |[i, k]: [u32; 2], ring: u32| {
        (5 + ring..11 - ring).contains(&i) && (5 + ring..11 - ring).contains(&k)
    };
    // The uppermost first.
    let bench = |[_, k]: [u32; 2]| (9 - k.clamp(6, 9)) as u16;
    let goes = |place: [u32; 2]| Life { born: Stage::Before(0), gone: Some(Stage::Before(1 + bench(place))) };
    let (mut rock, mut lining) = (Vec::new(), Vec::new());
    let (mut lives, mut stand_ins) = (vec![Life::ALWAYS; at.len()], Vec::new());
    let [mut left, mut right] = [Vec::new(), Vec::new()];
    for (e, &place) in (0u32..).zip(&at) {
        if inside(place, 1) {
            rock.push(e);
            lives[e as usize] = goes(place);
        } else if inside(place, 0) {
            lining.push(e);
            let born = Stage::Before(if place[1] >= 8 { 3 } else { 5 });
            lives[e as usize] = Life { born, gone: None };
            let stand_in = mesh.elements.len() as u32;
            mesh.elements.push(mesh.elements[e as usize]);
            lives.push(goes(place));
            stand_ins.push((stand_in, e));
            rock.push(stand_in);
        } else {
            rock.push(e);
            if place[0] < 8 { left.push(e) } else { right.push(e) }
        }
    }
    let initial = (0..mesh.elements.len() as u32)
        .map(|e| {
            let s = -DENSITY * GRAVITY * (DEPTH - centroid(&mesh, e)[2]) - 1e6;
            [LATERAL * s, LATERAL * s, s, 0.0, 0.0, 0.0]
        })
        .collect();
    let top = mesh.faces["top"].iter().map(|&face| (face, [0.0, 0.0, -1e6, 0.0, 0.0, 0.0])).collect();
    if mirrored {
        reflect(&mut mesh);
    }
    let body = |name: &str, elements, young, quadrature| Body {
        name: name.into(),
        elements,
        material: elastic(Moduli::from_young_poisson(young, 0.2)),
        density: DENSITY,
        quadrature,
        viscosity: 0.06,
    };
    let outside = [left.clone(), right.clone()].concat();
    let bodies = vec![
        body("rock", rock, 2e9, Quadrature::OnePoint),
        body("lining", lining.clone(), 25e9, Quadrature::Full),
    ];
    let mut problem = Problem::new(mesh, bodies);
    problem.lives = lives;
    problem.stand_ins = stand_ins;
    problem.initial = initial;
    problem.gravity = GRAVITY;
    problem.tractions = vec![tremolite::Traction { name: "above".into(), faces: top, life: Life::BEFORE }];
    let mut fault = between(
        &problem,
        [0, 0],
        "coulomb",
        &[("normal_stiffness", 10e9), ("cohesion", 0.0), ("friction_coefficient", 0.5)],
    );
    fault.sides = [left, right];
    fault.name = "fault".into();
    let mut extrados = between(
        &problem,
        [1, 0],
        "bandis",
        &[
            ("normal_stiffness", 20e9),
            ("max_closure", 2e-3),
            ("cohesion", 0.2e6),
            ("friction_coefficient", 0.7),
        ],
    );
    extrados.sides = [lining, outside];
    problem.interfaces = vec![fault, extrados];
    let sense = |[x, y, z]: [f64; 3]| [if mirrored { SIZE[0] - x } else { x }, y, z];
    let bar = |a: [f64; 3], b: [f64; 3]| [sense(a), sense(b)];
    let bars = [
        bar([9.5, 0.9, 11.2], [9.0, 0.9, 14.3]),
        bar([12.1, 1.1, 11.2], [14.9, 1.1, 14.0]),
        bar([15.0, 0.7, 11.2], [12.2, 0.7, 14.6]),
        bar([7.0, 1.2, 8.3], [3.6, 1.2, 8.9]),
    ];
    problem.bolts = vec![Bolts { born: Stage::Before(2), ..bolts(&bars) }];
    problem.base = Base::Viscous;
    problem.sides = [Side::FreeField; 2];
    let [frequency, centre, end, peak] = PULSE;
    let pulse = ricker_velocity(frequency, centre, peak);
    let along = if mirrored { [-0.8, 0.2, 0.5] } else { [0.8, 0.2, 0.5] };
    let motion = Motion::sampled(2e-4, end, |t| pulse(t).along(along)).unwrap();
    problem.incident = Some(Incident { motion, factor: 1.0 });
    problem
}

fn reflect(mesh: &mut Mesh) {
    mesh.nodes.iter_mut().for_each(|x| x[0] = SIZE[0] - x[0]);
    for element in &mut mesh.elements {
        let n = element.nodes();
        *element = Element::new(element.shape, &[1, 0, 3, 2, 5, 4, 7, 6].map(|k| n[k]));
    }
}

/// The corners of elements, by element and by place with x counted along `sense`: displacement in the stages and in the shaking.
fn shaken(problem: Problem, sense: f64) -> (BTreeMap<(u32, u32), Vec<f64>>, f64) {
    let corners: Vec<Vec<u32>> = problem.mesh.elements.iter().map(|e| e.nodes().to_vec()).collect();
    let model = Model::new(problem).unwrap();
    let assembly = Assembly::new(&model).unwrap();
    assert!(!model.parted.joints.is_empty() && model.seams[0].freed.iter().any(|freed| *freed));
    let stages = vec![close(1e-11); 6];
    let mut rows: BTreeMap<(u32, u32), Vec<f64>> = BTreeMap::new();
    let mut look = |state: &State| {
        for (e, corners) in (0u32..).zip(&corners) {
            for (&node, now) in corners.iter().zip(model.mesh.elements[e as usize].nodes()) {
                let [x, y, z] = state.shown(model.engine_node[*now as usize] as usize).xyz();
                rows.entry((e, node)).or_default().extend([sense * x, y, z]);
            }
        }
    };
    let (mut state, _) = settle(&model, &assembly, &stages).unwrap();
    look(&state);
    let phase = Phase::of(&model, &assembly, Stage::Shaking).unwrap();
    // The same for both: estimates of the stable step agree to a thousandth alone.
    let dt = 0.4 * PULSE[2] / 1000.0;
    assert!(dt < 0.8 * stable_step(&model, &assembly, &phase).dt);
    let mut engine = Engine::new(&model, &assembly, &phase);
    engine.hand_over(&mut state, dt);
    let drift = engine.quiet_run(&state, 50);
    assert!(drift < 1e-12, "{drift}");
    let steps = (PULSE[2] / dt) as u64;
    for step in 1..=steps {
        engine.step(&mut state);
        if step.is_multiple_of(50) {
            look(&state);
        }
    }
    let slid = assembly.contacts[0].totals(&model.seams[0], &state.history).ever_slid;
    (rows, slid)
}

#[test]
fn a_lined_and_bolted_cavern_cut_by_a_fault_moves_as_its_mirror_image() {
    let [(plain, slid), (mirrored, _)] =
        [(false, 1.0), (true, -1.0)].map(|(m, sense)| shaken(cavern(m), sense));
    assert!(slid > 0.0, "the fault slides");
    let peak = plain.values().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
    let worst = plain.iter().map(|(key, rows)| apart(rows, &mirrored[key])).fold(0.0, f64::max);
    // Round-off, with which pairs slide a little earlier or later.
    assert!(worst < 1e-9 * peak, "{worst} of {peak}");
}
