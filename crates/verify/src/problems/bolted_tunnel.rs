//! A round tunnel in rock with radial bolts, against a ring that is stiffer along its radius by what the bolts are spread over.
//!
//! Hydrostatic stress P, plane strain. Bolts of the area A, one to every length s along the tunnel and every angle Δθ, move with
//! the rock from the wall to the depth L. Spread out they carry E_b A/(s r Δθ) u′ per area, so for a < r < a + L
//!
//! σ_r = (λ + 2μ) u′ + λ u/r + (c/r) u′,  σ_θ = λ u′ + (λ + 2μ) u/r,  (r σ_r)′ = σ_θ,  c = E_b A/(s Δθ),
//!
//! with σ_r = P at the wall of what changes as the stress is released there, and σ_r = −2μ u/r beyond, where u falls as 1/r. Both ends
//! of a bolt give their force to the rock, as a plate would. The equations are integrated from the wall outwards (Runge–Kutta of
//! order 4), once with and once without a motion of the wall.
//!
//! **Model.** A quarter out to four radii, with the core; the stress from far away and at the edge the traction of the exact
//! solution. One stage takes out the core, with the bolts in place. Bolts in every sector of the mesh leave nothing but
//! the error of the mesh, of order 2; in every third what lies between them as well.

use crate::bolted::{STEEL, bolts};
use crate::convergence::order;
use crate::models::Solid;
use crate::staged::{Rested, Rings, SINCE_CHANGE, UNTIL_CHANGE, growing, release};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::FRAC_PI_2;
use tremolite::Traction;
use tremolite::{Life, Quadrature, Stage};

const NAME: &str = "bolted_tunnel";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a round tunnel with radial bolts as its stress is released: motion of the wall, forces along a bolt",
    source: "the ring with the bolts spread out, its equation integrated in the problem",
    from: Effort::Test,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2700.0 };
/// P \[Pa\], a, L and the radius of the edge \[m\].
const PRESSURE: f64 = 5e6;
const WALL: f64 = 4.0;
const LENGTH: f64 = 4.0;
const EDGE: f64 = 16.0;
/// c/a over λ + 2μ.
const SHARE: f64 = 1.0;
/// Elements around the quarter, multiples of three.
const MESHES: [u32; 2] = [12, 24];

/// The spread solution for a share: u and u′ at the wall and along the bolts, on even steps.
struct Spread {
    c: f64,
    step: f64,
    /// u \[m\] and r σ_r \[N/m\].
    rows: Vec<[f64; 2]>,
}

impl Spread {
    fn new(share: f64) -> Self {
        let m = ROCK.moduli();
        let c = share * WALL * (m.lambda + 2.0 * m.mu);
        let count = 2000;
        let step = LENGTH / f64::from(count);
        let mut spread = Spread { c, step, rows: Vec::new() };
        let integrate = |spread: &Spread, start: [f64; 2]| {
            let mut rows = vec![start];
            for k in 0..count {
                let (r, y) = (WALL + step * f64::from(k), rows[k as usize]);
                let on = |by: f64, d: [f64; 2]| [0, 1].map(|i| y[i] + by * step * d[i]);
                let a = spread.slopes(r, y);
                let b = spread.slopes(r + 0.5 * step, on(0.5, a));
                let c = spread.slopes(r + 0.5 * step, on(0.5, b));
                let d = spread.slopes(r + step, on(1.0, c));
                rows.push([0, 1].map(|i| y[i] + step / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i])));
            }
            rows
        };
        let loaded = integrate(&spread, [0.0, WALL * PRESSURE]);
        let moved = integrate(&spread, [1.0, 0.0]);
        // r σ_r + 2μu is none where the bolts end.
        let end = |rows: &[[f64; 2]]| rows[rows.len() - 1][1] + 2.0 * m.mu * rows[rows.len() - 1][0];
        let wall = -end(&loaded) / end(&moved);
        let sum = |(a, b): (&[f64; 2], &[f64; 2])| [0, 1].map(|i| a[i] + wall * b[i]);
        spread.rows = loaded.iter().zip(&moved).map(sum).collect();
        spread
    }

    /// u′ and (r σ_r)′.
    fn slopes(&self, r: f64, [u, rs]: [f64; 2]) -> [f64; 2] {
        let m = ROCK.moduli();
        let stiff = m.lambda + 2.0 * m.mu;
        let strain = (rs / r - m.lambda * u / r) / (stiff + self.c / r);
        [strain, m.lambda * strain + stiff * u / r]
    }

    /// u \[m\] and u′ at a radius along the bolts.
    fn at(&self, r: f64) -> [f64; 2] {
        let place = ((r - WALL) / self.step).clamp(0.0, (self.rows.len() - 1) as f64);
        let k = (place as usize).min(self.rows.len() - 2);
        let s = place - k as f64;
        let y = [0, 1].map(|i| (1.0 - s) * self.rows[k][i] + s * self.rows[k + 1][i]);
        [y[0], self.slopes(r, y)[0]]
    }

    /// σ_r \[Pa\] of what changes at the edge.
    fn edge(&self) -> f64 {
        let m = ROCK.moduli();
        -2.0 * m.mu * self.at(WALL + LENGTH)[0] * (WALL + LENGTH) / (EDGE * EDGE)
    }
}

/// What a tunnel came to.
struct Outcome {
    /// Motion of the wall into the opening over the exact one of the spread bolts.
    wall: f64,
    /// Largest error of a bolt's force over the largest force.
    force: f64,
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let (bare, bolted) = (Spread::new(0.0), Spread::new(SHARE));
    let exact = -PRESSURE * WALL / (2.0 * ROCK.moduli().mu);
    let note = "1e-9: u = −Pa/(2μ)";
    checks.push(Check::new(
        NAME,
        "the integrated equation without bolts",
        bare.at(WALL)[0] / exact,
        1.0,
        1e-9,
        "1",
        note,
    ));
    let effect = bolted.at(WALL)[0] / bare.at(WALL)[0];
    let note = "at most 0.9: so much of an effect there is to be met";
    checks.push(Check::new(
        NAME,
        "motion of the wall over that without bolts, exact, 0.9 at most",
        effect.max(0.9),
        0.9,
        0.0,
        "1",
        note,
    ));
    checks.push(Check::beside(
        NAME,
        "motion of the wall over that without bolts",
        effect,
        1.0,
        "1",
        "what the bolts do",
    ));

    let [coarse, last] = MESHES.map(|around| tunnel(around, 1, &bolted));
    let (coarse, last) = (coarse?, last?);
    let orders = |of: fn(&Outcome) -> f64| order(of(&coarse), of(&last), 2.0);
    let p = orders(|o| (o.wall - 1.0).abs());
    let note = "3 %; of order 2 in the size of elements, which are as many as bolts";
    let quantity = "motion of the wall over that of spread bolts";
    checks.push(Check::new(NAME, quantity, last.wall, 1.0, 0.03, "1", note).with_order(p));
    let quantity = "order in h of the motion of the wall";
    checks.push(Check::new(NAME, quantity, p, 2.0, 0.3, "1", "order 2: a bolt in every sector").with_order(p));
    let p = orders(|o| o.force);
    let note = "3 % of the largest, which is at the wall; forces are of the middle of segments";
    checks.push(
        Check::new(NAME, "force along a bolt, error over the largest", last.force, 0.0, 0.03, "1", note)
            .with_order(p),
    );
    let [a, b] = MESHES.map(|around| Ok::<_, VerifyError>((tunnel(around, 3, &bolted)?.wall - 1.0).abs()));
    let (a, b) = (a?, b?);
    let note =
        "3 %; bolts in every third sector: the rock between them moves more, the less the nearer they are";
    let check =
        Check::new(NAME, "motion of the wall, bolts in every third sector, error", b, 0.0, 0.03, "1", note);
    checks.push(check.with_order(order(a, b, 2.0)));
    let note = "0.65 at most: of order 1 in the distance of bolts, half of which is far from enough for the next order to be gone";
    let quantity = "error with eight bolts in the quarter over that with four, 0.65 at most";
    checks.push(Check::new(NAME, quantity, (b / a).max(0.65), 0.65, 0.0, "1", note));
    Ok(checks)
}

/// With bolts in the middle of every `every`th sector.
fn tunnel(around: u32, every: u32, exact: &Spread) -> Result<Outcome, VerifyError> {
    let step = FRAC_PI_2 / f64::from(around);
    let mut radii: Vec<f64> = (0..=4).map(|i| WALL * f64::from(i) / 4.0).collect();
    radii.extend(growing(WALL, WALL + LENGTH, step));
    radii.extend(growing(WALL + LENGTH, EDGE, step));
    let rings = Rings::new(radii, around, false);
    let core = rings.between(0.0, WALL);
    let rock = rings.between(WALL, EDGE);
    let thick = rings.mesh.bounds().1[1];
    let angle = step * f64::from(every);
    let area = exact.c * thick * angle / STEEL;
    let sectors = (0..around).filter(|k| k % every == every / 2);
    let bars: Vec<[[f64; 3]; 2]> = sectors
        .map(|k| {
            let (sine, cosine) = rings.angle(f64::from(k) + 0.5).sin_cos();
            // A polygon has the middle of its side nearer to the axis.
            let near = (0.5 * step).cos();
            [WALL, WALL + LENGTH].map(|r| [near * r * cosine, 0.5 * thick, near * r * sine])
        })
        .collect();
    let mut kind = bolts(&bars, area);
    kind.born = Stage::Before(1);

    let mesh = rings.mesh.clone();
    let mut lives = vec![Life::ALWAYS; mesh.elements.len()];
    core.iter().for_each(|&e| lives[e as usize] = UNTIL_CHANGE);
    let far = [-PRESSURE, -2.0 * ROCK.poisson * PRESSURE, -PRESSURE, 0.0, 0.0, 0.0];
    let mut initial = vec![far; mesh.elements.len()];
    let brick = rings.brick();
    brick.elements.iter().for_each(|&e| initial[e as usize] = [0.0; 6]);
    let all = core.iter().chain(&rock).copied().collect();
    let mut problem =
        tremolite::Problem::new(mesh, vec![ROCK.body("rock", all, Quadrature::OnePoint), brick]);
    problem.lives = lives;
    problem.initial = initial;
    problem.held = rings.symmetry();
    problem.bolts = vec![kind];
    // Along the radius σ, around −σ: beyond the bolts u falls as 1/r.
    let change = |angle: f64| {
        let (d, c) = angle.sin_cos();
        let s = exact.edge();
        [s * (c * c - d * d), 0.0, s * (d * d - c * c), 0.0, 0.0, 2.0 * s * c * d]
    };
    problem.tractions = vec![
        Traction { name: "far".into(), faces: rings.edge(|_| far), life: Life::BEFORE },
        Traction { name: "change".into(), faces: rings.edge(change), life: SINCE_CHANGE },
    ];
    let rested = Rested::new(problem, &[release(1.0), release(1.0)])?;
    let set = &rested.model.bolts[0];
    if set.bolts.len() != bars.len() || set.cuts.shortened > 0 {
        return Err(VerifyError::Setup(format!("{:?}", set.cuts)));
    }
    let [mean, ..] = rings.inwards(&rested, WALL);
    let wall = -mean / exact.at(WALL)[0];
    let largest = STEEL * area * exact.at(WALL)[1].abs();
    let mut force = 0.0_f64;
    for (b, bolt) in set.bolts.iter().enumerate() {
        for (segment, seen) in
            bolt.segments.iter().zip(rested.assembly.bolts[0].seen(&rested.state.numbers, b))
        {
            let [from, to] = segment.points.map(|p| bolt.points[p as usize].at);
            let strain = exact.at(WALL + 0.5 * (from + to))[1];
            force = force.max((seen.force - STEEL * area * strain).abs() / largest);
        }
    }
    Ok(Outcome { wall, force })
}
