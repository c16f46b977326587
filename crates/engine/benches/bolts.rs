//! What bolts add to a step: 2,400 of 6 m around the caverns of the generator's mesh of 98,080 elements.
//!
//! `cargo bench -p tremolite-engine --bench bolts [-- THREADS]`. Steps without and with bolts take turns: the ratio of the
//! smallest times, and the median ratio of neighbours.

use std::sync::Arc;
use std::time::Instant;
use tremolite_engine::bolts::{Bar, Bolts, Bond};
use tremolite_engine::parts::{Scratch, Tick};
use tremolite_engine::{
    Assembly, Base, Body, Engine, Model, Phase, Problem, Quadrature, Side, Stage, State, elastic, stable_step,
};
use tremolite_kernels::{AnyMaterial, laws};
use tremolite_laws::{Moduli, Row, Value, Values};
use tremolite_mesh::cavern::CavernSpec;
use tremolite_mesh::topology::exterior_faces;
use tremolite_mesh::{Face, Mesh};

const BOLTS: usize = 2400;
const ROUNDS: usize = 25;
const STEPS: u32 = 10;
const REPEATS: usize = 200;

fn main() {
    let threads = std::env::args().find_map(|arg| arg.parse().ok()).unwrap_or(2);
    rayon::ThreadPoolBuilder::new().num_threads(threads).build_global().expect("threads");
    let mesh = CavernSpec::yingxiuwan_fine().mesh().expect("the preset");
    // The lining's groups by part are in that of all of it.
    let of = |words: &[&str]| -> Vec<u32> {
        let mut is = vec![false; mesh.elements.len()];
        let groups = mesh.groups.iter().filter(|(name, _)| words.iter().any(|word| name.contains(word)));
        groups.flat_map(|(_, elements)| elements).for_each(|&e| is[e as usize] = true);
        (0..mesh.elements.len() as u32).filter(|&e| is[e as usize]).collect()
    };
    let (void, lining) = (of(&["bench"]), of(&["lining"]));
    let mut gone = vec![false; mesh.elements.len()];
    void.iter().chain(&lining).for_each(|&e| gone[e as usize] = true);
    let standing: Vec<u32> = (0..mesh.elements.len() as u32).filter(|&e| !gone[e as usize]).collect();
    let bars = bars(&mesh, &standing);
    println!(
        "{} elements of rock, {} of linings, {} bolts, {threads} threads",
        standing.len(),
        lining.len(),
        bars.len()
    );
    let bond =
        Bond { stiffness: 1e9, strength: 200e3, friction: 0.0, perimeter: 0.0785, segment: f64::INFINITY };
    for (law, material) in
        [("elastic", elastic(Moduli::from_young_poisson(10e9, 0.25))), ("mohr-coulomb", rock())]
    {
        for (what, bond) in [("following", None), ("bonded", Some(bond))] {
            let [bare, bolted] = [Vec::new(), bars.clone()].map(|bars| {
                let mut problem = Problem::new(
                    mesh.clone(),
                    vec![body("rock", &standing, material.clone()), concrete(&lining)],
                );
                problem.base = Base::Fixed;
                problem.sides = [Side::Free; 2];
                if !bars.is_empty() {
                    problem.bolts = vec![kind(bars, bond)];
                }
                problem
            });
            let times = race(bare, bolted);
            println!(
                "{law}, {what}: {:.2} and {:.2} ms a step, {:+.1} %, median of rounds {:+.1} %; {:.2} ms of bolts on one thread; stable step {:.4} of that without",
                1e3 * times.seconds[0],
                1e3 * times.seconds[1],
                100.0 * (times.seconds[1] / times.seconds[0] - 1.0),
                100.0 * (times.ratio - 1.0),
                1e3 * times.parts,
                times.steps[1] / times.steps[0],
            );
        }
    }
}

fn rock() -> Arc<dyn AnyMaterial> {
    let law = laws().into_iter().find(|law| law.info.name == "mohr-coulomb").expect("the law");
    let mut values = Values::default();
    for (name, value) in [
        ("young", 10e9),
        ("poisson", 0.25),
        ("cohesion", 2.18e6),
        ("friction_angle", 0.733),
        ("tensile_strength", 2.4e6),
    ] {
        values.0.insert(name.into(), Value::Number(value));
    }
    (law.build)(&values).expect("rock")
}

/// Elastic, which costs least.
fn concrete(elements: &[u32]) -> Body {
    let material = elastic(Moduli::from_young_poisson(25e9, 0.17));
    Body { quadrature: Quadrature::Full, ..body("lining", elements, material) }
}

fn body(name: &str, elements: &[u32], material: Arc<dyn AnyMaterial>) -> Body {
    Body {
        name: name.into(),
        elements: elements.to_vec(),
        material,
        density: 2700.0,
        quadrature: Quadrature::OnePoint,
        viscosity: 0.0,
    }
}

fn kind(bars: Vec<Bar>, bond: Option<Bond>) -> Bolts {
    Bolts {
        name: "bolts".into(),
        bars,
        young: 200e9,
        yields: 400e6,
        breaks: f64::INFINITY,
        bond,
        pretension: 0.0,
        free_length: 0.0,
        plates: [false; 2],
        born: Stage::Before(0),
    }
}

/// Bolts of 6 m from walls inside the model into the rock, straight in.
fn bars(mesh: &Mesh, standing: &[u32]) -> Vec<Bar> {
    let (low, high) = mesh.bounds();
    let inside = |x: [f64; 3]| (0..3).all(|i| x[i] > low[i] + 0.1 && x[i] < high[i] - 0.1);
    let walls: Vec<([f64; 3], [f64; 3])> = exterior_faces(mesh, Some(standing))
        .into_iter()
        .map(|face| middle_and_normal(mesh, face))
        .filter(|(x, _)| inside(*x))
        .collect();
    // Walls have fewer faces than that: several bolts a face, apart.
    let each = BOLTS.div_ceil(walls.len());
    let all = walls.iter().flat_map(|&(x, n)| {
        (0..each).map(move |k| {
            let head = [x[0] - 1e-6 * n[0], x[1] + 0.2 * k as f64, x[2] - 1e-6 * n[2]];
            let tail = [0, 1, 2].map(|i| head[i] - 6.0 * n[i]);
            Bar { points: vec![head, tail], areas: vec![4.909e-4] }
        })
    });
    all.take(BOLTS).collect()
}

fn middle_and_normal(mesh: &Mesh, face: Face) -> ([f64; 3], [f64; 3]) {
    let nodes: Vec<[f64; 3]> = mesh.face_nodes(face).map(|n| mesh.nodes[n as usize]).collect();
    let count = nodes.len() as f64;
    let middle = [0, 1, 2].map(|i| nodes.iter().map(|x| x[i]).sum::<f64>() / count);
    let [a, b] =
        [[0, 2], [1, 3]].map(|[p, q]| [0, 1, 2].map(|i| nodes[q.min(nodes.len() - 1)][i] - nodes[p][i]));
    let n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let size = n.iter().map(|x| x * x).sum::<f64>().sqrt();
    (middle, n.map(|x| x / size))
}

/// Smallest seconds a step and the stable steps, without and with; the median of the rounds' ratios.
struct Times {
    seconds: [f64; 2],
    ratio: f64,
    parts: f64,
    steps: [f64; 2],
}

fn race(bare: Problem, bolted: Problem) -> Times {
    let runs = [bare, bolted].map(|problem| {
        let model = Model::new(problem).expect("a model");
        let assembly = Assembly::new(&model).expect("its parts");
        (model, assembly)
    });
    for (model, _) in &runs {
        for set in &model.bolts {
            let segments: usize = set.bolts.iter().map(|bolt| bolt.segments.len()).sum();
            println!("  {:?}, {segments} segments", set.cuts);
        }
    }
    let phases =
        runs.each_ref().map(|(model, assembly)| Phase::of(model, assembly, Stage::Shaking).expect("a phase"));
    let steps = [0, 1].map(|k| stable_step(&runs[k].0, &runs[k].1, &phases[k]).dt);
    let mut racers: Vec<(Engine, State)> = (0..2)
        .map(|k| {
            let (model, assembly) = &runs[k];
            let mut engine = Engine::new(model, assembly, &phases[k]);
            let mut state = assembly.rest();
            state.dt = 0.9 * steps[1];
            let velocity: Vec<Row> = model
                .mesh_node
                .iter()
                .map(|&n| Row::new([0.05 * model.mesh.nodes[n as usize][2].sin(), 0.0, -0.1]))
                .collect();
            let u = state.u.clone();
            engine.start(&mut state, u, &velocity);
            (engine, state)
        })
        .collect();
    let mut seconds = [f64::INFINITY; 2];
    let mut ratios = Vec::new();
    for _ in 0..ROUNDS {
        let mut round = [0.0; 2];
        for (k, (engine, state)) in racers.iter_mut().enumerate() {
            let begin = Instant::now();
            for _ in 0..STEPS {
                engine.step(state);
            }
            round[k] = begin.elapsed().as_secs_f64() / f64::from(STEPS);
            seconds[k] = seconds[k].min(round[k]);
        }
        ratios.push(round[1] / round[0]);
    }
    ratios.sort_by(f64::total_cmp);
    let ratio = ratios[ROUNDS / 2];
    Times { seconds, ratio, parts: parts(&runs[1].1, &racers[1].1), steps }
}

/// Seconds that the bolts' own evaluation takes, on one thread.
fn parts(assembly: &Assembly, state: &State) -> f64 {
    let mut state = state.clone();
    let mut scratch = Scratch::default();
    let tick = Tick { time: 0.0, dt: state.dt, step: 0 };
    let mut best = f64::INFINITY;
    for _ in 0..REPEATS {
        let mut seconds = 0.0;
        for (member, slices) in assembly.members.iter().zip(&assembly.slices) {
            if member.name != "bolts" {
                continue;
            }
            let mut out = vec![Row::ZERO; member.part.nodes().len()];
            let (motion, own) = slices.own(&mut state);
            let begin = Instant::now();
            member.part.forces(&tick, &motion, own, &mut out, &mut scratch);
            seconds += begin.elapsed().as_secs_f64();
        }
        best = best.min(seconds);
    }
    best
}
