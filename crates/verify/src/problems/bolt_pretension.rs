//! A pretensioned bar that holds the rock at its ends alone, against two forces of Kelvin's.
//!
//! A bar of 3 m without bond pulls its ends together with P; the same tension in every segment leaves the rock between alone. A
//! force P along d in a space without end moves it by
//! u_i = P/(16πG(1 − ν)r) \[(3 − 4ν)d_i + r_i (r·d)/r²\]
//! (`kelvin1848`). The body is a cube of 8 m whose outer nodes have the displacements of the two forces: so it is not cut off.
//! Forces on nodes with shape functions have the right sum and the right centre in each element, so the error at a fixed
//! distance is of order 2; near to the ends it goes by distances in elements.
//!
//! A bar oblique to all axes must do the same in its own axes. Compared is what is left beside Kelvin's solution, at the same
//! points as the bar sees them, so that what is interpolated between nodes is small.

use crate::bolted::{AREA, bolts};
use crate::convergence::order;
use crate::models::Solid;
use crate::staged::release;
use crate::{Check, Effort, Problem, VerifyError};
use std::f64::consts::PI;
use tremolite::engine::Release;
use tremolite::{Assembly, Engine, Model, Phase, Quadrature, Side, Stage, State};
use tremolite_laws::Row;
use tremolite_mesh::boxes::BoxSpec;
use tremolite_mesh::locate::Locator;

const NAME: &str = "bolt_pretension";

pub const PROBLEM: Problem = Problem {
    name: NAME,
    summary: "a pretensioned bar against two forces in a space without end; straight and oblique to the mesh",
    source: "`kelvin1848`",
    from: Effort::Verify,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
/// Half the cube, half the bar, its middle \[m\], and P \[N\].
const HALF: f64 = 4.0;
const REACH: f64 = 1.5;
const MIDDLE: [f64; 3] = [0.11, 0.06, -0.07];
const TENSION: f64 = 100e3;
/// Elements along an edge.
const MESHES: [u32; 2] = [12, 24];
/// Distance from the ends at which the order is found \[m\].
const FAR: f64 = 1.0;

/// Axes of bars, the third along them.
const STRAIGHT: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

fn oblique() -> [[f64; 3]; 3] {
    let unit = |v: [f64; 3]| v.map(|x| x / dot(v, v).sqrt());
    let along = unit([2.0, -1.0, 2.5]);
    let across = unit([1.0, 2.0, 0.0]);
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    };
    [across, cross(along, across), along]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

fn along(from: [f64; 3], by: f64, direction: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| from[i] + by * direction[i])
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let d = along(a, -1.0, b);
    dot(d, d).sqrt()
}

/// A body with its bar pulled.
struct Pulled {
    model: Model,
    state: State,
    ends: [[f64; 3]; 2],
    axes: [[f64; 3]; 3],
    element: f64,
}

impl Pulled {
    fn new(axes: [[f64; 3]; 3], elements: u32) -> Result<Self, VerifyError> {
        let mesh = BoxSpec::uniform([-HALF; 3], [2.0 * HALF; 3], [elements; 3]).mesh()?;
        let ends = [-REACH, REACH].map(|by| along(MIDDLE, by, axes[2]));
        let mut problem = ROCK.fill(mesh, Quadrature::OnePoint);
        let outer = |x: [f64; 3]| x.iter().any(|x| x.abs() > HALF - 1e-9);
        let nodes = problem.mesh.nodes.iter().enumerate().filter(|(_, x)| outer(**x));
        problem.held = nodes.map(|(n, _)| (n as u32, [true; 3])).collect();
        problem.sides = [Side::Roller; 2];
        let mut kind = bolts(&[ends], AREA);
        kind.pretension = TENSION;
        problem.bolts = vec![kind];
        let model = Model::new(problem)?;
        let assembly = Assembly::new(&model)?;
        let phase = Phase::of(&model, &assembly, Stage::Before(0))?;
        let mut state = assembly.rest();
        for (row, &node) in state.u.iter_mut().zip(&model.mesh_node) {
            let x = model.mesh.nodes[node as usize];
            if outer(x) {
                *row = Row::new(kelvin(ends, axes[2], x));
            }
        }
        let release = Release { tolerance: [1e-7, 1e-5], ..release(1.0) };
        let rest = Engine::new(&model, &assembly, &phase).relax(&mut state, &release);
        rest.map_err(|rest| VerifyError::Setup(format!("not at rest: {rest:?}")))?;
        let element = 2.0 * HALF / f64::from(elements);
        Ok(Pulled { model, state, ends, axes, element })
    }

    /// What a node has beyond Kelvin's displacement \[m\].
    fn beyond(&self, node: u32) -> [f64; 3] {
        let exact = kelvin(self.ends, self.axes[2], self.model.mesh.nodes[node as usize]);
        along(self.state.u[self.model.engine_node[node as usize] as usize].xyz(), -1.0, exact)
    }

    /// Largest error of a component, and the largest displacement, of nodes at least so far from both ends \[m\].
    fn off(&self, far: f64) -> [f64; 2] {
        let mut most = [0.0_f64; 2];
        for (n, &x) in self.model.mesh.nodes.iter().enumerate() {
            if self.ends.iter().all(|&end| distance(x, end) >= far) {
                let exact = kelvin(self.ends, self.axes[2], x);
                let largest = |v: [f64; 3]| v.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
                most = [most[0].max(largest(self.beyond(n as u32))), most[1].max(dot(exact, exact).sqrt())];
            }
        }
        most
    }

    /// The same between nodes, in the bar's axes, at a point given in them.
    fn beyond_at(&self, locator: &Locator, at: [f64; 3]) -> Result<[f64; 3], VerifyError> {
        let x = (0..3).fold(MIDDLE, |x, i| along(x, at[i], self.axes[i]));
        let missing = || VerifyError::NoNode(x[0], x[1], x[2]);
        let location = locator.locate(x, 1e-6).ok_or_else(missing)?;
        let nodes = self.model.mesh.elements[location.element as usize].nodes();
        let sum = nodes.iter().zip(location.weights).fold([0.0; 3], |sum, (&n, w)| along(sum, w, self.beyond(n)));
        Ok(self.axes.map(|axis| dot(axis, sum)))
    }
}

/// Displacement \[m\] by P at the first end along the bar and at the second against it.
fn kelvin(ends: [[f64; 3]; 2], d: [f64; 3], x: [f64; 3]) -> [f64; 3] {
    let nu = ROCK.poisson;
    let scale = TENSION / (16.0 * PI * ROCK.moduli().mu * (1.0 - nu));
    let of = |end: [f64; 3], sign: f64| {
        let r = along(x, -1.0, end);
        let length = dot(r, r).sqrt();
        [0, 1, 2].map(|i| sign * scale / length * ((3.0 - 4.0 * nu) * d[i] + r[i] * dot(r, d) / (length * length)))
    };
    along(of(ends[0], 1.0), 1.0, of(ends[1], -1.0))
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let mut fine = Vec::new();
    for (axes, word) in [(STRAIGHT, "straight"), (oblique(), "oblique")] {
        let (mut near, mut far) = (Vec::new(), Vec::new());
        for elements in MESHES {
            let pulled = Pulled::new(axes, elements)?;
            let [error, largest] = pulled.off(1.0 * pulled.element);
            near.push(error / largest);
            let [error, largest] = pulled.off(FAR);
            far.push(error / largest);
            fine.push(pulled);
        }
        let p = order(far[0], far[1], 2.0);
        let note = "2 %: over the largest displacement there, beyond one element from the ends";
        let quantity = format!("error of displacement beyond one element, {word}");
        checks.push(Check::new(NAME, quantity, near[1], 0.0, 0.02, "1", note));
        let note = "2 %, of order 2: an element is a third of that";
        let quantity = format!("error of displacement beyond {FAR} m, {word}");
        checks.push(Check::new(NAME, quantity, far[1], 0.0, 0.02, "1", note).with_order(p));
        let note = "order 2; the nearest nodes at that distance are not the same in both meshes";
        let quantity = format!("order in h beyond {FAR} m, {word}, 2 or 1.5 at least");
        checks.push(Check::new(NAME, quantity, p.min(2.0), 2.0, 0.5, "1", note));
    }
    let [_, straight, _, oblique] = &fine[..] else { return Ok(checks) };
    let locators = [straight, oblique].map(|pulled| Locator::new(&pulled.model.mesh, None));
    let (mut apart, mut largest) = (0.0_f64, 0.0_f64);
    for i in -2..=2 {
        for j in -2..=2 {
            for k in -4..=4 {
                let at = [0.5, 0.5, 0.6].iter().zip([i, j, k]).map(|(h, n)| h * f64::from(n));
                let at: [f64; 3] = at.collect::<Vec<_>>().try_into().unwrap_or_default();
                let ends = [[0.0, 0.0, -REACH], [0.0, 0.0, REACH]];
                if ends.iter().any(|&end| distance(at, end) < straight.element) {
                    continue;
                }
                let [a, b] = [straight.beyond_at(&locators[0], at)?, oblique.beyond_at(&locators[1], at)?];
                let exact = kelvin(ends, STRAIGHT[2], at);
                largest = largest.max(dot(exact, exact).sqrt());
                apart = (0..3).map(|i| (a[i] - b[i]).abs()).fold(apart, f64::max);
            }
        }
    }
    let note = "2 %: over the largest displacement there, at points beyond one element from the ends in the bars' own axes";
    checks.push(Check::new(NAME, "oblique against straight, same mesh", apart / largest, 0.0, 0.02, "1", note));
    Ok(checks)
}
