//! The test of Willam, Pramono & Sture: concrete stretched to its strength, then sheared, so that the principal strain turns.
//!
//! Plane stress. The strain grows as (1, −ν, 0) in xx, yy and γ_xy until σ_xx = f_t, then as (0.5, 0.75, 1): its axes turn by 52° in the
//! end. A crack that stays across x would carry shear, and in sum more than f_t, for good: it locks. E 10 GPa, ν 0.2, f_t 1 MPa, G_f/h
//! 150 J/m³.
//!
//! **What is asked.** σ₁ ≤ 1.05 f_t all along; σ₁ past its peak grows nowhere again, and σ₁ and τ go to nothing. Stress and strain keep
//! the same axes in either split, since damage has none of its own: so nothing can lock.
//!
//! **Twice**: a point along 8,000 steps; and an element whose nodes are moved in 130 stages, free across, with each kind of points.

use crate::models::{LAYERED, QUADRATURES, material};
use crate::{Check, Effort, Verification, VerifyError};
use tremolite::engine::Release;
use tremolite::point_stress::mean;
use tremolite::{Assembly, Bed, Body, Engine, Life, Model, Phase, Prescribed, Quadrature, Stage};
use tremolite_laws::materials::Concrete;
use tremolite_laws::path::{Control, Path, drive_named};
use tremolite_laws::{Material, Value, Values};
use tremolite_mesh::boxes::BoxSpec;

const NAME: &str = "willam_rotating_strain";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "concrete whose principal strain turns after it cracks: largest stress, and what is left in the end",
    source: "`willam1987`",
    from: Effort::Verify,
    run,
};

const YOUNG: f64 = 10e9;
const POISSON: f64 = 0.2;
const FT: f64 = 1e6;
/// G_f \[N/m\], and h \[m\].
const ENERGY: f64 = 150.0;
const SIZE: f64 = 1.0;

/// The largest γ over f_t/E, and from where on nothing is to be left.
const END: f64 = 20.0;
const GONE: f64 = 12.0;

/// Evolution, split and driver.
type Words = [&'static str; 3];
const LAWS: [Words; 4] = [
    ["exponential", "compliance", "strain"],
    ["exponential", "compliance", "stress"],
    ["residual", "effective", "strain"],
    ["residual", "effective", "stress"],
];

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for law in LAWS {
        let word = law.join(", ");
        judge(&format!("{word}, point"), &point(law)?, &mut checks);
        if law[2] == "stress" {
            continue;
        }
        for (quadrature, kind) in [QUADRATURES[0], QUADRATURES[1], LAYERED] {
            judge(&format!("{word}, {kind} element"), &element(law, quadrature)?, &mut checks);
        }
    }
    Ok(checks)
}

/// γ over f_t/E since the strength was reached, strain and stress \[Pa\].
struct Row {
    shear: f64,
    strain: [f64; 3],
    stress: [f64; 3],
}

fn judge(word: &str, rows: &[Row], checks: &mut Vec<Check>) {
    let mut check = |what: &str, value: f64, reference: f64, tolerance: f64, note: &str| {
        checks.push(Check::new(NAME, format!("{what}, {word}"), value, reference, tolerance, "1", note));
    };
    let first = |s: &[f64; 3]| (0.5 * (s[0] + s[1]) + (0.5 * (s[0] - s[1])).hypot(s[2])) / FT;
    let largest = rows.iter().map(|row| first(&row.stress)).fold(0.0, f64::max);
    check("largest σ₁ over f_t", largest, 1.0, 0.05, "0.05: what is asked");
    let (mut least, mut rise) = (f64::INFINITY, 0.0_f64);
    for s in rows.iter().skip_while(|row| first(&row.stress) < largest).map(|row| first(&row.stress)) {
        least = least.min(s);
        rise = rise.max(s - least);
    }
    check("largest rise of σ₁ past its peak, over f_t", rise, 0.0, 0.01, "0.01: a fifth of what is asked of the peak");
    let left = rows.iter().filter(|row| row.shear > GONE);
    let left = left.map(|row| first(&row.stress).abs().max(row.stress[2].abs() / FT)).fold(0.0, f64::max);
    check("what is left of σ₁ and τ over f_t in the end", left, 0.0, 1e-3, "1e-3: nothing");
    let axis = |xx: f64, yy: f64, xy: f64| 0.5 * (2.0 * xy).atan2(xx - yy);
    let borne = rows.iter().filter(|row| first(&row.stress) > 1e-3);
    let angle = borne.map(|row| {
        let ([a, b, g], [s, t, u]) = (row.strain, row.stress);
        (axis(a, b, 0.5 * g) - axis(s, t, u)).abs()
    });
    let angle = angle.fold(0.0, f64::max).to_degrees();
    // The first rows have no strain beside uniaxial ones.
    check("angle between the axes of stress and strain in degrees", angle, 0.0, 0.01, "0.01: rest to 1e-4");
}

/// Strains xx, yy and γ: to the strength in so many rows, and beyond.
fn strains(rows: [u32; 2]) -> Vec<(f64, [f64; 3])> {
    let threshold = FT / YOUNG;
    let up = (0..=rows[0]).map(|i| {
        let e = threshold * f64::from(i) / f64::from(rows[0]);
        (0.0, [e, -POISSON * e, 0.0])
    });
    let turning = (1..=rows[1]).map(|i| {
        let shear = END * f64::from(i) / f64::from(rows[1]);
        let g = shear * threshold;
        (shear, [threshold + 0.5 * g, -POISSON * threshold + 0.75 * g, g])
    });
    up.chain(turning).collect()
}

fn values([evolution, split, driver]: Words) -> Values {
    let mut values = Values::default()
        .with("young", YOUNG)
        .with("poisson", POISSON)
        .with("tensile_strength", FT)
        .with("fracture_energy", ENERGY)
        .with("compressive_strength", 10.0 * FT)
        .with("friction_angle", 37f64.to_radians());
    for (name, word) in [("rate", "none"), ("evolution", evolution), ("split", split), ("driver", driver)] {
        values.0.insert(name.to_owned(), Value::Word(word.to_owned()));
    }
    values
}

fn point(law: Words) -> Result<Vec<Row>, VerifyError> {
    let rows = strains([200, 7800]);
    let (own, free) = (Control::Strain, Control::Stress);
    let path = Path {
        time: vec![0.0; rows.len()],
        values: rows.iter().map(|(_, [a, b, g])| [*a, *b, 0.0, *g, 0.0, 0.0]).collect(),
        control: [own, own, free, own, free, free],
        size: Some(SIZE),
    };
    let response = drive_named(Concrete::NAME, &values(law), &path);
    let response = response.map_err(|error| VerifyError::Setup(error.to_string()))?;
    let rows = rows.into_iter().zip(response.stress);
    Ok(rows.map(|((shear, strain), s)| Row { shear, strain, stress: [s[0], s[1], s[3]] }).collect())
}

/// A brick whose upright edges are moved; stress is the mean of its points.
fn element(law: Words, quadrature: Quadrature) -> Result<Vec<Row>, VerifyError> {
    let rows = strains([50, 80]);
    let mesh = BoxSpec::uniform([0.0; 3], [SIZE, SIZE, 0.5 * SIZE], [1; 3]).mesh()?;
    let body = Body {
        name: "brick".into(),
        elements: vec![0],
        material: material(Concrete::NAME, &values(law))?,
        density: 2400.0,
        quadrature,
        viscosity: 0.0,
    };
    let mut problem = tremolite::Problem::new(mesh, vec![body]);
    problem.bed = Bed::NONE;
    for (k, (_, [a, b, g])) in (0u16..).zip(&rows) {
        let life = Life { born: Stage::Before(k), gone: Some(Stage::Before(k + 1)) };
        for [x, y] in [[0.0, 0.0], [SIZE, 0.0], [0.0, SIZE], [SIZE, SIZE]] {
            let nodes = problem.mesh.elements[0].nodes().iter().enumerate();
            let mask = nodes.fold(0u8, |mask, (bit, &n)| {
                let at = problem.mesh.nodes[n as usize];
                if at[0] == x && at[1] == y { mask | 1 << bit } else { mask }
            });
            let to = [Some(a * x + 0.5 * g * y), Some(b * y + 0.5 * g * x), None];
            problem.prescribed.push(Prescribed { name: "edge".into(), corners: vec![(0, mask)], to, life });
        }
    }
    let model = Model::new(problem)?;
    let assembly = Assembly::new(&model)?;
    let mut state = assembly.rest();
    let release = Release { cycles: 50, tolerance: [1e-4, 2e-2], most: 2_000, ..Release::default() };
    let mut found = Vec::new();
    for (k, (shear, strain)) in (0u16..).zip(rows) {
        let phase = Phase::of(&model, &assembly, Stage::Before(k))?;
        let mut engine = Engine::new(&model, &assembly, &phase);
        // Where nothing is left that could be out of balance, it is at rest.
        if let Err(rest) = engine.relax(&mut state, &release)
            && rest.left > 1e-6 * FT * SIZE * SIZE
        {
            return Err(VerifyError::Setup(format!("stage {k} does not come to rest: {rest:?}")));
        }
        let stress = engine.look(&state).snapshot.stress;
        let Some(slot) = phase.element_slot[0] else { continue };
        let s = mean(&slot.places, &stress[slot.point as usize..][..slot.points as usize]);
        found.push(Row { shear, strain, stress: [s[0], s[1], s[3]] });
    }
    Ok(found)
}
