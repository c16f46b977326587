//! A box of hexahedra through the engine that runs use: what `tremolite bench` times.

use crate::assembly::Assembly;
use crate::body::Body;
use crate::boundary::{Base, Side};
use crate::engine::{Engine, Halt, stable_step};
use crate::error::ModelError;
use crate::level_finding::settle_levels;
use crate::life::Stage;
use crate::model::Model;
use crate::phase::Phase;
use crate::problem::{Problem, Rayleigh};
use crate::water::{Spell, Water};
use std::sync::Arc;
use std::time::Instant;
use tremolite_kernels::{AnyMaterial, Line, Quadrature};
use tremolite_laws::band::MEMORY;
use tremolite_laws::shapes::hex8::{
    BrickField, BrickGeometry, FullGeometry, LayeredGeometry, OnePointGeometry,
};
use tremolite_laws::{Isa, Octet, Row};
use tremolite_mesh::boxes::{BoxError, BoxSpec, Distortion};

/// What to time.
#[derive(Clone)]
pub struct BoxBench {
    /// Elements wanted; the nearest cube is run.
    pub elements: usize,
    pub steps: u64,
    pub threads: usize,
    pub quadrature: Quadrature,
    /// Whether corners lie up to a tenth of an element beside their places, or else all elements are bricks.
    pub distorted: bool,
    /// Whether parts of the box make longer steps than others, in the shares of a lined cavern: an eighth of it makes the finest, and an
    /// eighth each twice and four times, the rest eight times as long ones. All elements could run with the longest.
    pub levels: bool,
    /// Whether elements begin with a stress, as the ground of a case does.
    pub stressed: bool,
    /// Whether water that cannot leave is in their pores, at the pressure of that stress.
    pub water: bool,
    /// Speed at which the top is struck \[m/s\].
    pub strike: f64,
    pub material: Arc<dyn AnyMaterial>,
    pub isa: Isa,
}

/// What was measured.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Timing {
    pub elements: usize,
    pub nodes: usize,
    pub steps: u64,
    pub threads: usize,
    /// Wall time of the steps alone \[s\].
    pub seconds: f64,
    /// Evaluations of an element: one a step without levels.
    pub element_updates_per_second: f64,
    /// Evaluations of an element in a step, in the mean.
    pub share: f64,
    /// Bytes that an update must move through memory, and its floating-point operations.
    pub cost_per_element: (f64, f64),
    /// Kinetic energy at the end \[J\]: equal bits mean equal runs.
    pub kinetic: f64,
}

/// Why a benchmark could not run.
#[derive(Debug, thiserror::Error)]
pub enum BenchError {
    #[error(transparent)]
    Box(#[from] BoxError),
    #[error(transparent)]
    Model(#[from] ModelError),
    #[error("threads could not be started: {0}")]
    Threads(#[from] rayon::ThreadPoolBuildError),
    #[error("the box became unstable by {} s: it moves with {:.3e} J, and {:.3e} J were put in", .0.time, .0.found, .0.supplied)]
    Halt(Halt),
}

/// Height \[m\] of the box; layered elements, which are thinner than they are wide, are half as high as others.
fn height(n: u32, bench: &BoxBench) -> f64 {
    let layered = matches!(bench.quadrature, Quadrature::Layered(_));
    f64::from(n) * if layered { 0.5 } else { 1.0 }
}

/// Stress of a box that begins with one, equal in all directions \[Pa\]: so small that the free top hardly feels it.
const STRESS: f64 = -1e4;

/// α, and M \[Pa\], of a box with water.
const BIOT: f64 = 0.85;
const MODULUS: f64 = 43e9;

/// The box: `n`³ elements of 1 m, its base fixed, its top struck.
///
/// # Errors
/// If the box cannot be made.
pub fn box_problem(n: u32, bench: &BoxBench) -> Result<Problem, BoxError> {
    let side = f64::from(n);
    let mut spec = BoxSpec::uniform([0.0; 3], [side, side, height(n, bench)], [n; 3]);
    if bench.distorted {
        spec.distortion = Some(Distortion { fraction: 0.1, seed: 1, periodic: [false; 2] });
    }
    let mesh = spec.mesh()?;
    let elements: Vec<u32> = (0..mesh.elements.len() as u32).collect();
    let initial =
        vec![[STRESS, STRESS, STRESS, 0.0, 0.0, 0.0]; if bench.stressed { elements.len() } else { 0 }];
    let body = Body {
        name: "box".into(),
        elements,
        material: bench.material.clone(),
        density: 2700.0,
        quadrature: bench.quadrature,
        viscosity: 0.0,
    };
    let mut problem = Problem::new(mesh, vec![body]);
    problem.base = Base::Fixed;
    problem.sides = [Side::Free; 2];
    problem.rayleigh = Rayleigh { mass: 0.5, stiffness: 0.0 };
    problem.initial = initial;
    if bench.water {
        let count = problem.mesh.elements.len();
        problem.initial = vec![[STRESS, STRESS, STRESS, 0.0, 0.0, 0.0]; count];
        let (elements, nodes) = (vec![-STRESS; count], vec![-STRESS; problem.mesh.nodes.len()]);
        problem.water = Water {
            biot: vec![BIOT; count],
            modulus: vec![MODULUS; count],
            spells: vec![Spell { from: Stage::Before(0), elements, nodes }],
        };
    }
    problem.isa = bench.isa;
    Ok(problem)
}

/// Runs the benchmark.
///
/// # Errors
/// If the box cannot be built or run.
pub fn run(bench: &BoxBench) -> Result<Timing, BenchError> {
    let n = (bench.elements as f64).cbrt().round().max(1.0) as u32;
    let pool = rayon::ThreadPoolBuilder::new().num_threads(bench.threads).build()?;
    pool.install(|| {
        let model = Model::new(box_problem(n, bench)?)?;
        let assembly = Assembly::new(&model)?;
        let phase = Phase::of(&model, &assembly, Stage::Shaking)?;
        let stable = stable_step(&model, &assembly, &phase).dt;
        let (model, assembly, phase) = match bench.levels {
            false => (model, assembly, phase),
            true => {
                let eighth = 0.125 * height(n, bench);
                let of_node = |x: &[f64; 3]| (x[2] / eighth).clamp(0.0, 3.0) as u8;
                let wished = model.mesh.nodes.iter().map(of_node).collect();
                let model = model.at_levels(&settle_levels(&model, &phase, wished));
                let assembly = assembly.again(&model)?;
                let phase = Phase::of(&model, &assembly, Stage::Shaking)?;
                (model, assembly, phase)
            }
        };
        let span = phase.span();
        let mut state = assembly.rest();
        state.dt = if bench.levels { 0.75 * stable / span as f64 } else { 0.9 * stable };
        let mut engine = Engine::new(&model, &assembly, &phase);
        let top = height(n, bench) - 0.2;
        let velocity: Vec<Row> = model
            .mesh_node
            .iter()
            .map(|&m| {
                if model.mesh.nodes[m as usize][2] > top {
                    Row::new([0.5 * bench.strike, 0.0, -bench.strike])
                } else {
                    Row::ZERO
                }
            })
            .collect();
        let u = state.u.clone();
        engine.start(&mut state, u, &velocity);
        engine.step(&mut state);
        let begin = Instant::now();
        let calls = bench.steps.div_ceil(span);
        for _ in 0..calls {
            engine.step(&mut state);
        }
        let seconds = begin.elapsed().as_secs_f64();
        let elements = model.user.elements;
        // The box begins with a jump of velocity, of which the scheme's own part is as large as what is put in; where concrete cracks
        // in the first step that part stays in no line of the balance, so the motion alone is judged.
        engine.watch(&state).map_err(BenchError::Halt)?;
        let seen = engine.finish(&mut state);
        let kinetic = seen.balance[Line::Kinetic];
        Ok(Timing {
            elements,
            nodes: model.user.nodes,
            steps: calls * span,
            threads: bench.threads,
            seconds,
            element_updates_per_second: phase.evaluated_elements * (calls * span) as f64 / seconds,
            share: phase.evaluated_elements / elements as f64,
            cost_per_element: cost_per_element(&assembly, model.mesh_node.len(), bench, elements),
            kinetic,
        })
    })
}

/// Bytes and operations of an element update, at least. Bytes: the geometry and corner numbers once, what laws remember read and
/// written (of a law that damages two columns read, since sound material asks for no more), of a band's memory what is read in every
/// step, the initial strain, contributions written and read, and the nodes' rows read and written. Operations: counted in the elastic kernels, a
/// fused multiply–add as two; what a law or a band takes beyond that is not in them.
fn cost_per_element(assembly: &Assembly, nodes: usize, bench: &BoxBench, elements: usize) -> (f64, f64) {
    let totals = assembly.totals();
    let row = size_of::<Row>() as f64;
    let per = |x: usize| x as f64 / elements as f64;
    // Contributions are written, read, and their slots read; a patch's nodes are gathered.
    let contribution_bytes = per(totals.contributions.end) * (3.0 * row + 8.0);
    let octet = size_of::<Octet>() as f64;
    let law = bench.material.info();
    let touched = match law.damages {
        true => 2.0 / law.history.len() as f64,
        false => 2.0,
    };
    let of_band = 6.0 / MEMORY as f64;
    let state_bytes = octet
        * (touched * per(totals.history.end)
            + of_band * per(totals.overstress.end)
            + per(totals.initial.end));
    // u and du read and written, mass and its inverse read.
    let node_bytes = per(nodes) * (5.0 * row + 12.0);
    let bricks = !bench.distorted && (law.damages || law.history.is_empty());
    let (geometry, operations) = match bench.quadrature {
        Quadrature::OnePoint if bench.distorted => (size_of::<OnePointGeometry>() / 8, ONE_POINT_OPERATIONS),
        Quadrature::OnePoint => (size_of::<BrickGeometry>() / 8, BRICK_OPERATIONS),
        Quadrature::Full if bricks => (size_of::<BrickField>() / 8, FULL_BRICK_OPERATIONS),
        Quadrature::Full => (size_of::<FullGeometry>() / 8, FULL_OPERATIONS),
        Quadrature::Layered(layers) => {
            let layers = layers.count() as f64 * LAYER_OPERATIONS;
            match bricks {
                true => (size_of::<BrickField>() / 8, FIELD_BRICK_OPERATIONS + layers),
                false => {
                    (size_of::<LayeredGeometry>() / 8, FULL_OPERATIONS + layers - FULL_POINTS_OPERATIONS)
                }
            }
        }
    };
    (geometry as f64 + 16.0 + state_bytes + contribution_bytes + node_bytes, operations)
}

/// Transforms 2×72, gradient and amplitudes 2×(63 + 36) less 9, law 15, axes 2×36, stabilisation 33, and back
/// 2×36 + 2×36 + 9 + 2×63 less 9, scatter 24.
const ONE_POINT_OPERATIONS: f64 = 144.0 + 189.0 + 15.0 + 72.0 + 33.0 + 72.0 + 81.0 + 117.0 + 24.0;
/// Transforms 2×72, gradient 12, law 15, stabilisation 5 + 9 + 3×21, resultants 6, forces 9, scatter 24.
const BRICK_OPERATIONS: f64 = 144.0 + 12.0 + 15.0 + 77.0 + 6.0 + 9.0 + 24.0;
/// As above in the frame (turning 2×63 each way), strain modes and back 2×(6×24 + 72 + 40), eight points of 15 + 6.
const FULL_OPERATIONS: f64 = 144.0 + 126.0 + 189.0 + 512.0 + FULL_POINTS_OPERATIONS + 126.0 + 189.0 + 24.0;
const FULL_POINTS_OPERATIONS: f64 = 168.0;
/// In bricks transforms 2×72, turning 2×105, strain and back 2×57, scatter 24.
const FIELD_BRICK_OPERATIONS: f64 = 144.0 + 210.0 + 114.0 + 24.0;
/// The same, to points and back 78 + 96, and the points.
const FULL_BRICK_OPERATIONS: f64 = FIELD_BRICK_OPERATIONS + 174.0 + FULL_POINTS_OPERATIONS;
/// Strains and resultants of a layer 6×(14 + 18), four points of 15 + 6 + 5.
const LAYER_OPERATIONS: f64 = 192.0 + 104.0;
