//! A lined tunnel in elastic rock whose stress is released with the lining in place, and after a part of it has gone.
//!
//! Thick ring in a plane, bonded or sliding freely (`michell`); for a thin one `einstein1979` have closed forms, which are
//! beside. Horizontal stress is half the vertical, P. Thrust is of a mean and of a part in cos 2θ (θ from the springline), and
//! so is the moment; the mean of the moment comes of the curvature of a thick ring alone.
//!
//! **Model.** A quarter out to four radii, core and rock in the lining's place included, with the stress from far away. The first
//! stage takes out both and lets go a share λ of what is held; the second installs the lining, and lets go the rest. With λ = 0 it
//! stands when the stress is released. The edge gets the tractions of the exact solution, in the same two parts; so only the
//! mesh errs. The lining has two rings of elements with 2×2×2 points; thrust and moment are sums over their points. Where it
//! slides, its joint has a stiffness that the exact solution has as well.
//!
//! With λ the rest of what is held is the (1 − λ)th part, so thrust and moment are that part of those of λ = 0.

use crate::convergence::order;
use crate::joints::joint;
use crate::michell::{Lining, Opening};
use crate::models::{LAYERED, Solid};
use crate::staged::{Rested, Rings, SINCE_CHANGE, UNTIL_CHANGE, growing, release};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::FRAC_PI_2;
use tremolite::Traction;
use tremolite::{Life, Quadrature, Stage};

const NAME: &str = "lined_tunnel";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a lined tunnel, bonded and sliding freely: thrust and moment as the stress is released, wholly and in part",
    source: "Michell's solution for a thick ring; `einstein1979` beside",
    from: Effort::Verify,
    run,
};

/// P \[Pa\], and the horizontal stress over it.
const PRESSURE: f64 = 5e6;
const LATERAL: f64 = 0.5;
/// Radius of the edge over that of the opening.
const EDGE: f64 = 4.0;
/// Elements around the quarter, and rings of them through the lining: coarse and fine.
const MESHES: [[u32; 2]; 2] = [[24, 2], [48, 4]];
/// Stiffness of a sliding joint \[Pa/m\].
const JOINT: f64 = 5e10;

/// A tunnel, and what the thin ring of `einstein1979` has of T/(P R) on the mean and in cos 2θ, and of M/(P R²) in cos 2θ.
struct Tunnel {
    word: &'static str,
    rock: Solid,
    lining: Solid,
    middle: f64,
    thick: f64,
    slides: bool,
    thin: [f64; 3],
}

const TUNNELS: [Tunnel; 2] = [
    Tunnel {
        word: "bonded",
        rock: Solid { young: 10e9, poisson: 0.25, density: 2700.0 },
        lining: Solid { young: 25e9, poisson: 0.17, density: 2500.0 },
        middle: 8.5,
        thick: 0.5,
        slides: false,
        thin: [0.11940277321492762, 0.06430617695528624, 7.657196376170683e-05],
    },
    Tunnel {
        word: "sliding",
        rock: Solid { young: 1e9, poisson: 0.3, density: 2700.0 },
        lining: Solid { young: 25e9, poisson: 0.2, density: 2500.0 },
        middle: 5.0,
        thick: 0.05,
        slides: true,
        thin: [0.1896898968922407, 3.808490603334e-06, 3.8084906033575283e-06],
    },
];

impl Tunnel {
    fn radii(&self) -> [f64; 2] {
        [self.middle - 0.5 * self.thick, self.middle + 0.5 * self.thick]
    }

    fn opening(&self) -> Opening {
        let [inner, radius] = self.radii();
        let joint = self.slides.then_some(JOINT);
        let lining = Some(Lining { solid: self.lining, inner, joint });
        Opening { rock: self.rock, radius, far: [-LATERAL * PRESSURE, -PRESSURE], lining }
    }

    /// T/(P R) on the mean and in cos 2θ, M/(P R²) in cos 2θ, of the thick ring.
    fn thick_ring(&self) -> [f64; 3] {
        let solved = self.opening().solve();
        let [beside, above] = [0.0, FRAC_PI_2].map(|angle| solved.section(angle));
        let r = PRESSURE * self.middle;
        let half = |i: usize| 0.5 * (beside[i] - above[i]);
        [0.5 * (beside[0] + above[0]) / r, half(0) / r, half(1) / (r * self.middle)]
    }
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for tunnel in &TUNNELS {
        let word = tunnel.word;
        let exact = tunnel.thick_ring();
        let [coarse, fine] = MESHES.map(|mesh| release_with(tunnel, mesh, 0.0, Quadrature::Full));
        let (coarse, fine) = (coarse?, fine?);
        let what = ["mean thrust over P R", "thrust in cos 2θ over P R", "moment in cos 2θ over P R²"];
        for k in 0..3 {
            // Where the lining slides, its thrust varies by no more than bending makes it: no figure of its own.
            let share = if k == 2 { 0.01 } else { 0.005 };
            let p = order((coarse[k] - exact[k]).abs(), (fine[k] - exact[k]).abs(), 2.0);
            let quantity = format!("{}, {word}", what[k]);
            let note = "0.5 % of thrust, 1 % of the moment: of order 2, (h/r)² being 0.1 %; a moment of 1 % is 2e-4 of thrust times thickness";
            if !(tunnel.slides && k == 1) {
                let tolerance = share * exact[k];
                checks.push(Check::new(NAME, &*quantity, fine[k], exact[k], tolerance, "1", note).with_order(p));
                let note = "order 2 of displacements and of mean stresses";
                let quantity = format!("order in h of {quantity}");
                checks.push(Check::new(NAME, quantity, p, 2.0, 0.2, "1", note).with_order(p));
            }
            let note = "for information: the ring of `einstein1979` is thin";
            checks.push(Check::beside(NAME, format!("{quantity}, beside a thin ring"), fine[k], tunnel.thin[k], "1", note));
        }
    }
    // One element through the thickness: layers show in the section what 2×2×2 points do.
    let [full, layered] = [Quadrature::Full, LAYERED.0]
        .map(|lined_by| release_with(&TUNNELS[0], [MESHES[0][0], 1], 0.0, lined_by));
    let (full, layered) = (full?, layered?);
    for (k, what) in [(0, "mean thrust"), (2, "moment in cos 2θ")] {
        let quantity = format!("{what} of one layer of layered elements over that of 2×2×2 points");
        let note = "1e-3: elements are sectors, in which det J is not even through the thickness";
        checks.push(Check::new(NAME, quantity, layered[k] / full[k], 1.0, 1e-3, "1", note));
    }
    let whole = release_with(&TUNNELS[0], MESHES[0], 0.0, Quadrature::Full)?;
    for share in [0.4, 0.7] {
        let part = release_with(&TUNNELS[0], MESHES[0], share, Quadrature::Full)?;
        let note = "1e-5: all is linear, what is out of balance at rest is 1e-9 of all contributions";
        for (k, what) in [(0, "mean thrust"), (2, "moment in cos 2θ")] {
            let quantity = format!("{what} over that of a lining before, released before it: {share}");
            checks.push(Check::new(NAME, quantity, part[k] / whole[k], 1.0 - share, 1e-5, "1", note));
        }
    }
    Ok(checks)
}

/// T/(P R) on the mean and in cos 2θ, M/(P R²) in cos 2θ, with a share released before the lining comes.
fn release_with(
    tunnel: &Tunnel,
    [around, layers]: [u32; 2],
    share: f64,
    lined_by: Quadrature,
) -> Result<[f64; 3], VerifyError> {
    let [inner, outer] = tunnel.radii();
    let exact = tunnel.opening().solve();
    let mut radii: Vec<f64> = (0..=4).map(|i| inner * f64::from(i) / 4.0).collect();
    radii.extend((1..=layers).map(|i| inner + tunnel.thick * f64::from(i) / f64::from(layers)));
    radii.extend(growing(outer, EDGE * outer, FRAC_PI_2 / f64::from(around)));
    let rings = Rings::new(radii, around, false);
    let lining = rings.between(inner, outer);
    let mut rock: Vec<u32> = rings.between(outer, EDGE * outer);
    let core = rings.between(0.0, inner);

    let mut mesh = rings.mesh.clone();
    let mut lives = vec![Life::ALWAYS; mesh.elements.len()];
    core.iter().for_each(|&e| lives[e as usize] = UNTIL_CHANGE);
    let mut stand_ins = Vec::new();
    for &e in &lining {
        lives[e as usize] = Life { born: Stage::Before(2), gone: None };
        stand_ins.push((mesh.elements.len() as u32, e));
        rock.push(mesh.elements.len() as u32);
        mesh.elements.push(mesh.elements[e as usize]);
        lives.push(UNTIL_CHANGE);
    }
    rock.extend(&core);
    let far = [-LATERAL * PRESSURE, -tunnel.rock.poisson * (1.0 + LATERAL) * PRESSURE, -PRESSURE, 0.0, 0.0, 0.0];
    let mut initial = vec![far; mesh.elements.len()];
    let brick = rings.brick();
    lining.iter().chain(&brick.elements).for_each(|&e| initial[e as usize] = [0.0; 6]);
    let bodies = vec![
        tunnel.rock.body("rock", rock, Quadrature::OnePoint),
        tunnel.lining.body("lining", lining.clone(), lined_by),
        brick,
    ];
    let mut problem = tremolite::Problem::new(mesh, bodies);
    if tunnel.slides {
        let sides = [lining.clone(), problem.bodies[0].elements.clone()];
        let numbers = [("normal_stiffness", JOINT), ("friction_coefficient", 0.0), ("cohesion", 0.0)];
        problem.interfaces = vec![joint(sides, "coulomb", &numbers, &[])?];
    }
    problem.lives = lives;
    problem.stand_ins = stand_ins;
    problem.initial = initial;
    problem.held = rings.symmetry();
    let change = |angle: f64| exact.change(EDGE * outer, angle);
    problem.tractions = vec![
        Traction { name: "far".into(), faces: rings.edge(|_| far), life: Life::BEFORE },
        Traction { name: "change".into(), faces: rings.edge(change), life: SINCE_CHANGE },
    ];
    let rested = Rested::new(problem, &[release(1.0), release(share), release(1.0)])?;

    let found = rings.section(&rested, &lining, [inner, outer]);
    let per_radius = PRESSURE * tunnel.middle;
    Ok([found[0] / per_radius, found[1] / per_radius, found[2] / (per_radius * tunnel.middle)])
}
