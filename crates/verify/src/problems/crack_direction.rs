//! Which way the cracks of a slab run that is stretched and bent.
//!
//! A slab of 4 × 3 × 0.4 m, turned at will, is led everywhere: stretched by 2 mm a metre along its ring, along its axis and through its
//! thickness, and bent round its axis until its fibres are stretched as much. So the strain is known everywhere, and which faces go apart:
//! the first cracks are longitudinal, the second go round the ring, the third lie parallel to the wall, the last are longitudinal and on one
//! side. A crack is as wide as its element is stretched (bent: at its outermost point, less what the stress explains that keeps fibres from
//! contracting), less at most f_t/E of it, which may be elastic: that is the tolerance. In halved elements it is half as wide. No other direction has more than that elastic part. In the direction between ring and
//! thickness, at 46° to the latter, the crack still crosses bars, and at 44° it is parallel to the wall.

use crate::concrete::{POISSON, THRESHOLD, YOUNG, values};
use crate::models::material;
use crate::simulation::Simulation;
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::history::History;
use tremolite::observers::{CrackDirection, Cracks};
use tremolite::{Body, Quadrature};
use tremolite_laws::Material;
use tremolite_laws::materials::Concrete;
use tremolite_mesh::boxes::BoxSpec;

const NAME: &str = "crack_direction";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "cracks of a slab turned at will, stretched along its ring, its axis and through its thickness, and bent",
    source: "the way of its nodes",
    from: Effort::Verify,
    run,
};

/// Ring, axis, thickness \[m\].
const SLAB: [f64; 3] = [4.0, 3.0, 0.4];
const STRETCH: f64 = 2e-3;
const DENSITY: f64 = 2752.0;
/// Steps of the way.
const STEPS: u32 = 400;

/// How the slab is strained: a strain along a direction in its axes, or bent.
#[derive(Clone, Copy)]
enum Strained {
    Along([f64; 3]),
    Bent,
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let oblique = |degrees: f64| {
        let (sine, cosine) = degrees.to_radians().sin_cos();
        Strained::Along([sine, 0.0, cosine])
    };
    use CrackDirection::{Longitudinal, Parallel, Ring};
    let ways = [
        ("stretched along the ring", Strained::Along([1.0, 0.0, 0.0]), Longitudinal),
        ("stretched along the axis", Strained::Along([0.0, 1.0, 0.0]), Ring),
        ("stretched through the thickness", Strained::Along([0.0, 0.0, 1.0]), Parallel),
        ("stretched at 46° to the thickness", oblique(46.0), Longitudinal),
        ("stretched at 44° to the thickness", oblique(44.0), Parallel),
        ("bent", Strained::Bent, Longitudinal),
    ];
    let mut checks = Vec::new();
    for (turn, turned) in [(0.0, "as it lies"), (0.3, "turned")] {
        for (what, strained, expected) in ways {
            for parts in [1u32, 2] {
                let (widths, exact, elastic) = widths(parts, turn, strained)?;
                let words = format!("{what}, {turned}, elements of 1/{parts}");
                let note = "f_t/E of the element: more of its stretch cannot be elastic";
                let found = widths[expected as usize];
                checks.push(Check::new(NAME, format!("width, {words}"), found, exact, elastic, "m", note));
                let others = CrackDirection::ALL.into_iter().filter(|d| *d != expected);
                let most = others.map(|d| widths[d as usize]).fold(0.0, f64::max);
                checks.push(Check::new(NAME, format!("other directions, {words}"), most, 0.0, elastic, "m", note));
            }
        }
    }
    Ok(checks)
}

/// A rotation by the same angle round z, x and z.
fn rotation(angle: f64) -> [[f64; 3]; 3] {
    let (s, c) = angle.sin_cos();
    let z = [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]];
    let x = [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]];
    let times = |a: [[f64; 3]; 3], b: [[f64; 3]; 3]| -> [[f64; 3]; 3] {
        std::array::from_fn(|i| std::array::from_fn(|k| (0..3).map(|j| a[i][j] * b[j][k]).sum()))
    };
    times(z, times(x, z))
}

/// The widest crack \[m\] of each direction, how wide that of the stretch must be, and how much of it may be elastic.
fn widths(parts: u32, turn: f64, strained: Strained) -> Result<([f64; 4], f64, f64), VerifyError> {
    let cells = [2 * parts, 2 * parts, parts];
    let mut mesh = BoxSpec::uniform([-2.0, -1.5, -0.2], [2.0, 1.5, 0.2], cells).mesh()?;
    let r = rotation(turn);
    let out = |v: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| (0..3).map(|k| r[i][k] * v[k]).sum()) };
    mesh.nodes.iter_mut().for_each(|x| *x = out(*x));
    let all: Vec<u32> = (0..mesh.elements.len() as u32).collect();
    mesh.groups.clear();
    mesh.groups.insert("slab".into(), all.clone());
    let values = values(&[("fracture_energy", 130.0)], &[("evolution", "exponential"), ("split", "compliance")]);
    let body = Body {
        name: "slab".into(),
        elements: all,
        material: material(Concrete::NAME, &values)?,
        density: DENSITY,
        quadrature: Quadrature::Full,
        viscosity: 0.0,
    };
    let mut problem = tremolite::Problem::new(mesh, vec![body]);
    problem.held = (0u32..).zip(&problem.mesh.nodes).map(|(n, _)| (n, [true; 3])).collect();
    let simulation = Simulation::new(problem)?;
    let duration = 200.0 * SLAB[0] / (YOUNG / DENSITY).sqrt();
    let dt = duration / f64::from(STEPS);
    let mut engine = simulation.engine();
    let mut state = simulation.start(&mut engine, dt, |_| [[0.0; 3]; 2]);
    let curvature = 2.0 * STRETCH / SLAB[2];
    let displaced = |[x, y, z]: [f64; 3]| match strained {
        Strained::Along(d) => {
            let along = STRETCH * (x * d[0] + y * d[1] + z * d[2]);
            d.map(|d| along * d)
        }
        Strained::Bent => [curvature * x * z, 0.0, -0.5 * curvature * x * x],
    };
    for (n, du) in state.du.iter_mut().enumerate() {
        let at = simulation.position(n);
        let own: [f64; 3] = std::array::from_fn(|k| (0..3).map(|i| r[i][k] * at[i]).sum());
        let way = out(displaced(own));
        (0..3).for_each(|i| du.0[i] = way[i] / f64::from(STEPS));
    }
    for _ in 0..STEPS {
        engine.step(&mut state);
    }
    let seen = engine.look(&state);
    let history = History::new(&simulation.assembly, &seen.history);
    let each = Cracks::now(&simulation.model, &simulation.phase, &history);
    let mut widest = [0.0_f64; 4];
    for widths in each.values() {
        widest.iter_mut().zip(widths).for_each(|(most, width)| *most = most.max(*width));
    }
    let edges: [f64; 3] = std::array::from_fn(|k| SLAB[k] / f64::from(cells[k]));
    let (extent, stretch) = match strained {
        Strained::Along(d) => ((0..3).map(|k| (edges[k] * d[k]).powi(2)).sum::<f64>().sqrt(), STRETCH),
        // The outermost of 2×2×2 points. Within an element bent fibres contract across the thickness by ν/(1 − ν) of their strain from its
        // middle; the stress of that explains ν of it.
        Strained::Bent => {
            let within = 0.5 * edges[2] / 3f64.sqrt();
            let outermost = 0.5 * (SLAB[2] - edges[2]) + within;
            (edges[0], curvature * (outermost - POISSON * POISSON / (1.0 - POISSON) * within))
        }
    };
    Ok((widest, extent * stretch, THRESHOLD * edges[0].max(extent)))
}
