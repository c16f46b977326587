//! A reinforced strip: what its sections carry, and how stiff it is.

use tremolite::engine::Release;
use tremolite::history::History;
use tremolite::observers::{SectionForces, View};
use tremolite::plan::Plan;
use tremolite::stages::{PlannedStage, settle};
use tremolite::{
    Assembly, Bar, Body, Bolts, Engine, Life, Model, Phase, Problem, Quadrature, Side, Stage, Traction,
    elastic,
};
use tremolite_laws::Moduli;
use tremolite_mesh::boxes::{Axis, BoxSpec};
use tremolite_mesh::{Element, Face, Shape};

/// Length, width along y and thickness \[m\] of the strip; its elements along.
const LENGTH: f64 = 6.0;
const WIDTH: f64 = 0.5;
const THICK: f64 = 0.4;
const ALONG: u32 = 48;
const CONCRETE: [f64; 2] = [30e9, 0.2];
const STEEL: f64 = 200e9;
/// Of each face \[m²/m\], and from that to the axis \[m\].
const AREA: f64 = 3e-3;
const COVER: f64 = 0.06;
/// Pressure on top, or pull at the end \[Pa\].
const LOAD: f64 = 1e4;
/// The strip is placed, and loaded, in this stage.
const PLACED: Stage = Stage::Before(1);

/// The concrete's modulus in plane strain \[Pa\].
fn plane() -> f64 {
    CONCRETE[0] / (1.0 - CONCRETE[1] * CONCRETE[1])
}

struct Strip {
    /// N, M, Q \[N/m, N, N/m\] with the place along of each station.
    forces: Vec<(f64, [f64; 3])>,
    /// Motion \[m\] of the nodes of the lower face: place along, and motion along and up.
    motion: Vec<(f64, [f64; 2])>,
}

impl Strip {
    fn moved(&self, at: f64) -> [f64; 2] {
        self.motion.iter().find(|(x, _)| (x - at).abs() < 1e-9).unwrap().1
    }
}

/// A strip between rollers across y that is clamped at x = 0, under a pressure on its upper face, or pulled at its end.
fn strip(layers: u32, reinforced: bool, pulled: bool) -> Strip {
    let along = Axis::Coordinates((0..=ALONG).map(|i| LENGTH * f64::from(i) / f64::from(ALONG)).collect());
    let spec = BoxSpec { x: along, ..BoxSpec::uniform([0.0; 3], [LENGTH, WIDTH, THICK], [1, 1, layers]) };
    let mut mesh = spec.mesh().unwrap();
    let own: Vec<u32> = (0..mesh.elements.len() as u32).collect();
    mesh.groups = [("strip".to_owned(), own.clone())].into();
    let held = (0..mesh.nodes.len() as u32).filter(|&n| mesh.nodes[n as usize][0] == 0.0);
    let held: Vec<(u32, [bool; 3])> = held.map(|n| (n, [true; 3])).collect();
    let (axis, side, stress) = if pulled {
        (0, LENGTH, [LOAD, 0.0, 0.0, 0.0, 0.0, 0.0])
    } else {
        (2, THICK, [0.0, 0.0, -LOAD, 0.0, 0.0, 0.0])
    };
    let on = |face: &Face| mesh.face_nodes(*face).all(|n| (mesh.nodes[n as usize][axis] - side).abs() < 1e-9);
    let faces = own.iter().flat_map(|&element| (0..6).map(move |side| Face { element, side }));
    let faces = faces.filter(on).map(|face| (face, stress)).collect();
    // A block apart, below and beyond, takes the supports that any model has before the shaking.
    let first = mesh.nodes.len() as u32;
    for z in [-3.0, -2.0] {
        let [low, high] = [-2.0, LENGTH + 2.0];
        mesh.nodes.extend([[low, 0.0, z], [high, 0.0, z], [high, WIDTH, z], [low, WIDTH, z]]);
    }
    let block: Vec<u32> = (first..first + 8).collect();
    mesh.elements.push(Element::new(Shape::Hex8, &block));
    let body = |name: &str, elements: Vec<u32>| Body {
        name: name.into(),
        elements,
        material: elastic(Moduli::from_young_poisson(CONCRETE[0], CONCRETE[1])),
        density: 2500.0,
        quadrature: Quadrature::Full,
        viscosity: 0.0,
    };
    let bodies = vec![body("strip", own.clone()), body("block", vec![own.len() as u32])];
    let life = Life { born: PLACED, gone: None };
    let mut problem = Problem::new(mesh, bodies);
    problem.lives = vec![life; own.len()];
    problem.lives.push(Life::ALWAYS);
    problem.held = held;
    problem.sides = [Side::Roller; 2];
    problem.tractions = vec![Traction { name: "load".into(), faces, life }];
    if reinforced {
        let bar = |z: f64| Bar {
            points: (0..=ALONG).map(|i| [LENGTH * f64::from(i) / f64::from(ALONG), 0.5 * WIDTH, z]).collect(),
            areas: vec![AREA * WIDTH; ALONG as usize],
        };
        problem.bolts = vec![Bolts {
            name: "bars".into(),
            bars: vec![bar(COVER), bar(THICK - COVER)],
            young: STEEL,
            yields: f64::INFINITY,
            breaks: f64::INFINITY,
            bond: None,
            pretension: 0.0,
            free_length: 0.0,
            plates: [false; 2],
            born: PLACED,
        }];
    }
    let model = Model::new(problem).unwrap();
    let assembly = Assembly::new(&model).unwrap();
    let release = Release { tolerance: [1e-9, 1e-7], most: 200_000, ..Release::default() };
    let stages = vec![PlannedStage { release, ..PlannedStage::new("stage") }; 2];
    let (mut state, _) = settle(&model, &assembly, &stages).unwrap();
    let phase = Phase::of(&model, &assembly, PLACED).unwrap();
    let snapshot = Engine::new(&model, &assembly, &phase).finish(&mut state);
    let plan = Plan {
        page: tremolite_results::PageWish::default(),
        boundaries: Default::default(),
        target: None,
        title: String::new(),
        stages,
        duration: 0.0,
        recorded: None,
        waves: None,
        histories: 1.0,
        snapshots: None,
        fields: Vec::new(),
        field_elements: 250_000,
        checkpoint: None,
        monitors: Vec::new(),
        pairs: Vec::new(),
        bolts: Vec::new(),
        bars: 0,
        water: false,
        relatives: Vec::new(),
        sections: Vec::new(),
    };
    let view = View {
        model: &model,
        assembly: &assembly,
        phase: &phase,
        plan: &plan,
        snapshot: &snapshot,
        history: History::new(&assembly, &state.history),
        numbers: &state.numbers,
    };
    let sections = SectionForces::of(&model);
    let found = sections.at(&view);
    assert_eq!(found.len(), ALONG as usize);
    let lower = (0..first).filter(|&n| model.mesh.nodes[n as usize][1..] == [0.0, 0.0]);
    let motion = lower.map(|n| {
        let u = state.shown(model.engine_node[n as usize] as usize).xyz();
        (model.mesh.nodes[n as usize][0], [u[0], u[2]])
    });
    Strip { forces: sections.places().map(|x| x[0]).zip(found).collect(), motion: motion.collect() }
}

/// What the load makes of a section is known without any stiffness: concrete and bars together carry it, and the concrete alone
/// less. The mean over an element of 125 mm is not the value in its middle, and near the clamp sections do not stay plane.
#[test]
fn concrete_and_bars_together_carry_what_the_load_asks_of_a_section() {
    for reinforced in [false, true] {
        let bent = strip(2, reinforced, false);
        for (x, [n, m, q]) in bent.forces.iter().filter(|(x, _)| (1.0..4.5).contains(x)) {
            let (moment, shear) = (0.5 * LOAD * (LENGTH - x).powi(2), LOAD * (LENGTH - x));
            assert!((m / moment - 1.0).abs() < 3e-3, "{reinforced} {x}: {m} {moment}");
            assert!((q.abs() / shear - 1.0).abs() < 0.02, "{reinforced} {x}: {q} {shear}");
            assert!(n.abs() < 1e-3 * moment / THICK, "{reinforced} {x}: {n}");
        }
        let pulled = strip(2, reinforced, true);
        for (x, [n, m, _]) in pulled.forces.iter().filter(|(x, _)| (1.0..4.5).contains(x)) {
            assert!((n / (LOAD * THICK) - 1.0).abs() < 1e-4, "{reinforced} {x}: {n}");
            assert!(m.abs() < 1e-4 * LOAD * THICK * THICK, "{reinforced} {x}: {m}");
        }
    }
}

/// Bars add what plane sections give: E_s A_s to the stiffness in tension, E_s A_s y² to that in bending.
#[test]
fn bars_stiffen_a_strip_as_a_transformed_section_does() {
    let bars = 2.0 * STEEL * AREA;
    let lever = 0.5 * THICK - COVER;
    let strain = |s: &Strip| (s.moved(4.5)[0] - s.moved(1.5)[0]) / 3.0;
    let stretched = [false, true].map(|reinforced| strain(&strip(1, reinforced, true)));
    let exact = [0.0, bars].map(|bars| LOAD * THICK / (plane() * THICK + bars));
    for (found, exact) in stretched.iter().zip(exact) {
        assert!((found / exact - 1.0).abs() < 1e-4, "{found} {exact}");
    }
    // Curvature by what is left of the motion of three places when that of a beam with the same moments is of fourth degree:
    // the change of deflection beyond shear, which bars hardly change.
    let inertia = THICK.powi(3) / 12.0;
    let shear = CONCRETE[0] / (2.0 * (1.0 + CONCRETE[1]));
    let by_shear = LOAD * LENGTH * LENGTH / (2.0 * shear * THICK * 5.0 / 6.0);
    let mut errors = Vec::new();
    for layers in [1, 2, 4] {
        let [plain, stiff] =
            [false, true].map(|reinforced| -strip(layers, reinforced, false).moved(LENGTH)[1]);
        let added = (plain - by_shear) / (stiff - by_shear) - 1.0;
        let exact = bars * lever * lever / (plane() * inertia);
        println!(
            "{layers} layers: bars add {added:.5}, plane sections {exact:.5}; plain {:.5} of a beam's",
            (plain - by_shear) / (LOAD * LENGTH.powi(4) / (8.0 * plane() * inertia))
        );
        errors.push((added / exact - 1.0).abs());
    }
    assert!(errors.iter().all(|e| *e < 0.02), "{errors:?}");
}
