//! The straight cantilever of MacNeal and Harder.
//!
//! A beam of 6 × 0.2 × 0.1, E = 10⁷, ν = 0.3, clamped at one end, is divided into six elements: bricks, trapezoids or
//! parallelograms with sides at 45°. Unit forces at the tip give by beam theory 0.1081 in the plane (along the depth
//! 0.2) and 0.4321 out of it, a unit twist 0.03208 (`macneal1985`, with their theoretical value of twist; the
//! series of Saint-Venant gives 0.0341).
//!
//! **What is checked** is what an element that bends and twists without locking does with bricks whose root is held as a
//! beam's, free to contract and to warp. In bending the moment is constant in an element and its curvature exact, so that of
//! PL³/3EI + PL/GA the first term is short of 1/(4n²) with n elements; lateral strains, −ν of the axial ones, do not follow
//! the moment within an element either, with ν² of that. In twist the section warps as yz, which leaves
//! J = 4 I_y I_z/(I_y + I_z), and nothing varies along the beam.
//!
//! **For information** stands the beam as it was set, clamped, beside the published figures of an isoparametric
//! hexahedron with incompatible modes (OptiStruct HEX8, Altair verification problem OS-V: 0720). Other elements need not meet
//! these: elements with slanted sides that pass the patch test are too stiff here (`macneal1987`), each in its way.

use crate::convergence::order;
use crate::models::{LAYERED, QUADRATURES, Solid, nodes_at_level};
use crate::simulation::Simulation;
use crate::stiffness::Assembled;
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::Quadrature;
use tremolite_mesh::Mesh;
use tremolite_mesh::boxes::BoxSpec;

const NAME: &str = "macneal_harder_beam";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "slender cantilever of six elements: bending both ways and twist, regular and skewed",
    source: "beam theory; `macneal1985`",
    from: Effort::Test,
    run,
};

const BEAM: Solid = Solid { young: 1e7, poisson: 0.3, density: 1.0 };
const LENGTH: f64 = 6.0;
/// Along y (in the plane) and along z.
const SECTION: [f64; 2] = [0.2, 0.1];

/// Slope dx/dy of a line of nodes, by its number from the root.
type Lean = fn(u32) -> f64;

const BRICKS: Lean = |_| 0.0;

/// Shapes of the elements.
const SHAPES: [(&str, Lean); 3] = [
    ("bricks", BRICKS),
    ("trapezoids", |line| if line % 2 == 0 { 1.0 } else { -1.0 }),
    ("parallelograms", |_| 1.0),
];

/// What pulls at the tip.
#[derive(Clone, Copy, PartialEq)]
enum Load {
    InPlane,
    OutOfPlane,
    Twist,
}

/// Loads with the theory of `macneal1985` \[m, rad\].
const LOADS: [(Load, &str, f64); 3] = [
    (Load::InPlane, "in-plane", 0.1081),
    (Load::OutOfPlane, "out-of-plane", 0.4321),
    (Load::Twist, "twist", 0.03208),
];

/// OptiStruct HEX8 over theory, by shape and load.
const PUBLISHED: [[f64; 3]; 3] = [[0.978, 0.973, 0.892], [0.047, 0.030, 0.563], [0.624, 0.529, 0.820]];

/// How the root is held.
#[derive(Clone, Copy, PartialEq)]
enum Root {
    /// As a beam's: no restraint of contraction and warping.
    Beam,
    /// Every component of every node.
    Clamped,
}

/// The beam along x in `n` elements, lines of nodes between the ends leaning by 45° in the plane.
fn mesh(n: u32, lean: Lean) -> Result<Mesh, VerifyError> {
    let half = SECTION.map(|s| 0.5 * s);
    let mut mesh =
        BoxSpec::uniform([0.0, -half[0], -half[1]], [LENGTH, half[0], half[1]], [n, 1, 1]).mesh()?;
    for node in &mut mesh.nodes {
        let line = (node[0] / LENGTH * f64::from(n)).round() as u32;
        if (1..n).contains(&line) {
            node[0] += lean(line) * node[1];
        }
    }
    Ok(mesh)
}

/// Shares of the tip's motion by theory: by bending, and by shear or twist \[m, rad\].
fn theory(load: Load) -> [f64; 2] {
    let [b, c] = SECTION;
    let [y, z] = [c * b.powi(3) / 12.0, b * c.powi(3) / 12.0];
    let shear = BEAM.moduli().mu;
    let bending = |inertia: f64| [LENGTH.powi(3) / (3.0 * BEAM.young * inertia), LENGTH / (shear * b * c)];
    match load {
        Load::InPlane => bending(y),
        Load::OutOfPlane => bending(z),
        Load::Twist => [0.0, LENGTH * (y + z) / (4.0 * shear * y * z)],
    }
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for (quadrature, word) in QUADRATURES.into_iter().chain([LAYERED]) {
        for (load, what, _) in LOADS {
            let of = |n| tip(mesh(n, BRICKS)?, quadrature, Root::Beam, load);
            let (six, [bent, other]) = (of(6)?, theory(load));
            let unit = if load == Load::Twist { "rad" } else { "m" };
            let quantity = format!("{what}, six bricks, root held as a beam's, {word}");
            if load == Load::Twist {
                let note = "1e-9: exact but for round-off";
                checks.push(Check::new(NAME, quantity, six, other, 1e-9 * other, unit, note));
                continue;
            }
            let short = bent / (4.0 * 36.0);
            let p = order((six - bent - other).abs(), (of(12)? - bent - other).abs(), 2.0);
            let note = "ν² of the 1/(4n²) that a moment constant in an element leaves: lateral strains";
            let tolerance = BEAM.poisson.powi(2) * short;
            let check = Check::new(NAME, quantity, six, bent + other - short, tolerance, unit, note);
            checks.push(check.with_order(p));
            let quantity = format!("order of the error of beam theory, {what}, 6 and 12 bricks, {word}");
            let note = "2 within 0.05: the next term is 1/n² of the leading one, 0.03";
            checks.push(Check::new(NAME, quantity, p, 2.0, 0.05, "1", note).with_order(p));
        }
    }
    for ((shape, lean), published) in SHAPES.into_iter().zip(PUBLISHED) {
        for (quadrature, word) in QUADRATURES.into_iter().chain([LAYERED]) {
            for ((load, what, theory), other) in LOADS.into_iter().zip(published) {
                let found = tip(mesh(6, lean)?, quadrature, Root::Clamped, load)?;
                let quantity = format!("{what} over theory {theory}, {shape}, {word}, beside OptiStruct HEX8");
                let note = "for information: another element; theory is 1";
                checks.push(Check::beside(NAME, quantity, found / theory, other, "1", note));
            }
        }
    }
    Ok(checks)
}

/// Motion of the tip along its unit load \[m, rad\].
fn tip(mesh: Mesh, quadrature: Quadrature, root: Root, load: Load) -> Result<f64, VerifyError> {
    let [held, tip] = [0.0, LENGTH].map(|x| nodes_at_level(&mesh, 0, x));
    // Half the couple by forces along z, half by forces along y.
    let [b, c] = SECTION.map(|s| 0.5 * s);
    let force = |[_, y, z]: [f64; 3]| match load {
        Load::InPlane => [0.0, 0.25, 0.0],
        Load::OutOfPlane => [0.0, 0.0, 0.25],
        Load::Twist => [0.0, -0.125 * z.signum() / c, 0.125 * y.signum() / b],
    };
    let forces: Vec<(u32, [f64; 3])> =
        tip.into_iter().map(|n| (n, force(mesh.nodes[n as usize]))).collect();
    let mut problem = BEAM.fill(mesh, quadrature);
    // No more than holds the beam: contraction moves corners across the bending, warping along the beam.
    let components = |k: usize| match (root, load) {
        (Root::Clamped, _) => [true; 3],
        (Root::Beam, Load::InPlane) => [true, true, k == 0],
        (Root::Beam, Load::OutOfPlane) => [true, k == 0, true],
        (Root::Beam, Load::Twist) => [k < 3, true, true],
    };
    problem.held = held.into_iter().enumerate().map(|(k, n)| (n, components(k))).collect();
    let simulation = Simulation::new(problem)?;
    let u = Assembled::new(&simulation).solve(&simulation, &forces)?;
    // Unit loads: their work is the motion along them.
    let work = forces.iter().map(|(n, f)| {
        let u = u[simulation.model.engine_node[*n as usize] as usize];
        (0..3).map(|i| f[i] * u[i]).sum::<f64>()
    });
    Ok(work.sum())
}
