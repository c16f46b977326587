//! The curves of a law of the model: what it makes of a strain that goes to and fro.
//!
//! A point of level ground under the stress that it has there is sheared on a level plane, with its sides held and the stress on that plane
//! as it was, between ±γ until the loop closes on itself. G is the chord of the loop, D = ΔW/(2πGγ²) its area over 4π times the energy at
//! its tip (`kramer1996`, section 6.4.2). A body that is elastic up to γ_y and then yields at one stress has G/G_max = γ_y/γ and
//! D = (2/π)(1 − γ_y/γ). Time stands still meanwhile: rates count for nothing, as in a stage.

use super::MOST_STRAIN;
use super::curves::Curves;
use super::table::CurveTable;
use tremolite_kernels::AnyMaterial;
use tremolite_laws::path::{Control, Path, drive_named};

/// Strains a decade.
const A_DECADE: i32 = 16;
/// Decades below [`MOST_STRAIN`] in which curves begin at the latest.
const DECADES: i32 = 4;
/// Rows a quarter of a cycle, and cycles before the one that counts.
const QUARTER: usize = 32;
const BEFORE: usize = 1;
/// Departure from elasticity that counts.
const ELASTIC: f64 = 1e-6;

/// What a law shows of a point under a stress \[Pa\] that it begins with (effective where water is in the pores), in an element of some height
/// \[m\]. Nothing for a law that is not of the list, or that cannot be driven so.
pub fn of_law(material: &dyn AnyMaterial, stress: [f64; 6], extent: f64) -> Option<Curves> {
    let mut points = Vec::new();
    // From the largest strain down, until the law is elastic.
    for step in 0..=A_DECADE * DECADES {
        let strain = MOST_STRAIN * 10f64.powf(-f64::from(step) / f64::from(A_DECADE));
        let [modulus, damping] = loop_of(material, stress, extent, strain)?;
        if 1.0 - modulus < ELASTIC && damping < ELASTIC {
            points.push([strain, 1.0, 0.0]);
            break;
        }
        points.push([strain, modulus, damping]);
    }
    points.reverse();
    // What hardens as it is sheared has no place in such curves.
    let falls = points.windows(2).all(|pair| pair[1][1] <= pair[0][1] + ELASTIC);
    let sound = points.iter().all(|[_, modulus, damping]| *modulus > 0.0 && *damping >= -ELASTIC);
    match points[..] {
        _ if !(falls && sound) => None,
        [_] => Some(Curves::Linear(0.0)),
        _ => Some(Curves::Table(CurveTable::measured(points))),
    }
}

/// G/G_max and D of a closed loop between ±γ.
fn loop_of(material: &dyn AnyMaterial, stress: [f64; 6], extent: f64, strain: f64) -> Option<[f64; 2]> {
    let (moduli, quarter) = (material.moduli(), QUARTER as f64);
    let start = moduli.strain(&stress);
    // Up, down and up again between −1 and 1, from 0 on.
    let wave = |k: usize| {
        let place = (k as f64 / quarter) % 4.0;
        if place < 1.0 {
            place
        } else if place < 3.0 {
            2.0 - place
        } else {
            place - 4.0
        }
    };
    let (first, rows) = ((4 * BEFORE + 1) * QUARTER, (4 * (BEFORE + 1) + 1) * QUARTER);
    let row = |k: usize| {
        let mut values = start;
        values[2] = stress[2];
        values[5] += strain * wave(k);
        values
    };
    let mut control = [Control::Strain; 6];
    control[2] = Control::Stress;
    let path = Path {
        time: vec![0.0; rows + 1],
        values: (0..=rows).map(row).collect(),
        control,
        size: Some(extent),
    };
    let found = drive_named(material.info().name, material.values(), &path).ok()?;
    let shear = |k: usize| found.stress[k][5];
    // The loop goes from +γ to −γ and back.
    let chord = (shear(rows) - shear(first + 2 * QUARTER)) / (2.0 * strain);
    let pairs = (first..rows).map(|k| {
        let turned = strain * (wave(k + 1) - wave(k));
        0.5 * (shear(k) + shear(k + 1)) * turned
    });
    let area: f64 = pairs.sum();
    Some([chord / moduli.mu, area / (std::f64::consts::TAU * chord * strain * strain)])
}
