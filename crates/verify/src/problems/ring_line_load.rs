//! A ring of plain concrete between two opposite line loads, as pipes are tested: stress, first crack, largest load.
//!
//! Radii 0.5 and 0.6 m, a quarter of the ring, 1 m wide and free across; C30/37 with Model Code's G_f, the exponential law with the
//! compliance split. A thin ring has a moment of PR/π under the loads, 0.18 PR beside.
//!
//! **Exact.** Two opposite radial forces P on the outer edge are a series of tractions −P/(πR)(1 + 2 Σ cos nθ), n = 2, 4, …, for each of
//! which Michell's stress function has four terms; within the ring the sum converges as (r/R)^n. Under the load the fibre's tension is
//! 2.5 % below that of Winkler's curved beam.
//!
//! **First crack.** An element has one mean curvature and points at some depth: along the ring the moment falls by ½π sin θ, so an
//! element beside the load has that of its middle; of 2×2×2 points the outermost lies 0.21 of an element within. Both are in
//! the reference; beside it is the load under which the fibre has f_t.
//!
//! **Largest load.** The ring cracks within under the loads, then without beside them, and bears more until both are worn: as four
//! hinges 4/π times what a section bears beyond its first crack ([`super::modulus_of_rupture`]). With several elements through it the
//! meshes agree. One element through it spreads each crack over its length, and shorter ones bear more: 0.7 depths long 14 % more than
//! four elements through it, 0.4 depths long 20 %.

use crate::models::LAYERED;
use crate::specimen::plate::Plate;
use crate::specimen::{BAND, Grip, Mix, Specimen, Tested, steps};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::{FRAC_PI_2, PI};
use tremolite::Quadrature;
use tremolite_laws::materials::concrete::Grade;

const NAME: &str = "ring_line_load";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "a plain ring between two line loads: load of the first crack and the largest one, by mesh and points",
    source: "Michell's series for two opposite forces",
    from: Effort::Verify,
    run,
};

/// Inner and outer radius, and width \[m\].
const INNER: f64 = 0.5;
const OUTER: f64 = 0.6;
const WIDE: f64 = 1.0;

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let Some(grade) = Grade::named("C30/37") else { return Err(VerifyError::Setup("no C30/37".into())) };
    let mix = Mix {
        young: grade.young,
        poisson: grade.poisson,
        tension: grade.tensile_strength,
        energy: grade.fracture_energy,
        compression: grade.compressive_strength,
    };
    // P \[N/m\] under which the fibre has f_t.
    let first = mix.tension / hoop(INNER, 0.0);
    let note = "3 %: the load's own stress, of the order of the curvature t/R squared";
    checks.push(Check::new(NAME, "hoop stress under the load over Winkler's curved beam", hoop(INNER, 0.0) / winkler(), 1.0, 0.03, "1", note));
    let full = (Quadrature::Full, "2×2×2");
    let mut meshes = vec![([1, 12], LAYERED), ([1, 24], LAYERED), ([2, 24], full), ([4, 48], full)];
    if effort == Effort::Full {
        meshes.push(([8, 96], full));
    }
    let mut largest = Vec::new();
    for ([layers, around], (quadrature, kind)) in meshes {
        let tested = ring(&mix, first, [layers, around], quadrature)?;
        let word = format!("{layers} by {around}, {kind}");
        let cracks = tested.readings.windows(2).find(|pair| pair[1].taken > 1e-9);
        let cracks = cracks.map_or(f64::NAN, |pair| pair[0].force + pair[1].force) / WIDE;
        // Of a point's depth and of the middle of an element beside the load.
        let within = if quadrature == Quadrature::Full { 0.5 * (1.0 - 1.0 / 3f64.sqrt()) / f64::from(layers) } else { 0.0 };
        let middle = 0.5 * FRAC_PI_2 / f64::from(around);
        let seen = hoop(INNER + within * (OUTER - INNER), 0.0) * (1.0 - FRAC_PI_2 * middle.sin());
        let exact = mix.tension / seen;
        let note = "5 %: half a step of the machine, 1 %, and what the load presses on an element";
        checks.push(Check::new(NAME, format!("load of the first crack, {word}"), cracks, exact, 0.05 * exact, "N/m", note));
        let note = "for information: where the fibre has f_t";
        checks.push(Check::beside(NAME, format!("load of the first crack over the exact one, {word}"), cracks / first, 1.0, "1", note));
        let peak = 2.0 * tested.peak() / WIDE / first;
        let note = "for information: of a ring that ends at its first crack";
        checks.push(Check::beside(NAME, format!("largest load over the exact one of the first crack, {word}"), peak, 1.0, "1", note));
        let note = "3 %: trapezes over the steps of the machine, and what cracks at once in a step";
        checks.push(Check::new(NAME, format!("held and taken over the machine's work, {word}"), tested.booked(), 1.0, 0.03, "1", note));
        if layers > 1 {
            largest.push(peak);
        }
    }
    let (least, most) = largest.iter().fold((f64::INFINITY, 0.0_f64), |(a, b), &p| (a.min(p), b.max(p)));
    let note = "6 % to either side of their middle, as for the panel";
    checks.push(Check::new(NAME, "largest over smallest load of the meshes with several elements through the ring", most / least, 1.0, 1.06 / 0.94 - 1.0, "1", note));
    Ok(checks)
}

/// A quarter between a load above and a plane of symmetry beside, pushed down.
fn ring(mix: &Mix, first: f64, [layers, around]: [u32; 2], quadrature: Quadrature) -> Result<Tested, VerifyError> {
    let lines = |from: f64, to: f64, many: u32| -> Vec<f64> {
        (0..=many).map(|i| from + (to - from) * f64::from(i) / f64::from(many)).collect()
    };
    // Angles from the load, then radii.
    let [angles, radii] = [lines(0.0, FRAC_PI_2, around), lines(INNER, OUTER, layers)];
    let clean = |x: f64| if x.abs() < 1e-12 { 0.0 } else { x };
    let plate = Plate::bricks([&angles, &radii], WIDE, |_| true)
        .moved(|[angle, r]| [clean(r * angle.sin()), clean(r * angle.cos())]);
    // How far the load goes at the first crack, of a thin ring: (π/8 − 1/π) PR³/(EI).
    let middle = 0.5 * (INNER + OUTER);
    let inertia = (OUTER - INNER).powi(3) / 12.0;
    let way = (0.125 * PI - 1.0 / PI) * first * middle.powi(3) / (mix.young * inertia);
    Specimen {
        plate: &plate,
        mix: *mix,
        words: BAND,
        quadrature,
        sound: &|_| false,
        grips: vec![
            Grip { nodes: &|x| x[0] == 0.0 && x[1] > OUTER - 1e-9, share: [Some(0.0), None, Some(-1.0)] },
            Grip { nodes: &|x| x[0] == 0.0 && x[1] < OUTER - 1e-9, share: [Some(0.0), None, None] },
            Grip { nodes: &|x| x[1] == 0.0, share: [None, None, Some(0.0)] },
        ],
        bolts: Vec::new(),
        gauge: None,
        ramp: 1000,
        ways: steps(&[(0.8 * way, 0.8 * way), (1.6 * way, 0.02 * way), (4.4 * way, 0.05 * way)]),
    }
    .run()
}

/// Hoop stress \[1/m\] at a radius \[m\] and an angle from one of two opposite forces of 1 N/m on the outer edge.
fn hoop(r: f64, angle: f64) -> f64 {
    // Lamé's part, of the pressure 1/(πR).
    let (a, b) = (INNER, OUTER);
    let mut sum = -b * b / (b * b - a * a) * (1.0 + a * a / (r * r)) / (PI * b);
    for half in 1..400 {
        let n = 2.0 * f64::from(half);
        // φ = Σ c r^p cos nθ, p = n, n + 2, −n, 2 − n, each term over the radius at which it is largest.
        let powers = [n, n + 2.0, -n, 2.0 - n];
        let scale = [b, b, a, a];
        let term = |k: usize, r: f64| (r / scale[k]).powf(powers[k] - 2.0);
        // σ_r = (p − n²) r^(p−2) cos nθ, τ = n (p − 1) r^(p−2) sin nθ, σ_θ = p (p − 1) r^(p−2) cos nθ.
        let rows = |r: f64| {
            let radial: [f64; 4] = std::array::from_fn(|k| (powers[k] - n * n) * term(k, r));
            let shear: [f64; 4] = std::array::from_fn(|k| n * (powers[k] - 1.0) * term(k, r));
            [radial, shear]
        };
        let ([sr_b, t_b], [sr_a, t_a]) = (rows(b), rows(a));
        let c = solve([sr_b, t_b, sr_a, t_a], [-2.0 / (PI * b), 0.0, 0.0, 0.0]);
        let hoop: f64 = (0..4).map(|k| c[k] * powers[k] * (powers[k] - 1.0) * term(k, r)).sum();
        sum += hoop * (n * angle).cos();
    }
    sum
}

/// Four equations, by elimination with the largest pivot.
fn solve(mut a: [[f64; 4]; 4], mut b: [f64; 4]) -> [f64; 4] {
    for i in 0..4 {
        let pivot = (i..4).max_by(|&k, &l| a[k][i].abs().total_cmp(&a[l][i].abs())).unwrap_or(i);
        a.swap(i, pivot);
        b.swap(i, pivot);
        for k in i + 1..4 {
            let factor = a[k][i] / a[i][i];
            (i..4).for_each(|j| a[k][j] -= factor * a[i][j]);
            b[k] -= factor * b[i];
        }
    }
    for i in (0..4).rev() {
        b[i] = (b[i] - (i + 1..4).map(|j| a[i][j] * b[j]).sum::<f64>()) / a[i][i];
    }
    b
}

/// The same under the load by Winkler's curved beam \[1/m\].
fn winkler() -> f64 {
    let (t, middle) = (OUTER - INNER, 0.5 * (INNER + OUTER));
    let neutral = t / (OUTER / INNER).ln();
    let e = middle - neutral;
    let moment = middle / PI * (1.0 - e / middle);
    moment * (neutral - INNER) / (t * e * INNER)
}
