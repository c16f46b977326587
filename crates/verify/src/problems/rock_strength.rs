//! Rock laws beside closed forms: triaxial compression and extension, plane strain, dilation.
//!
//! Compression positive, k = (1 + sin φ)/(1 − sin φ), f_c = 2c√k, M = (1 + sin ψ)/(1 − sin ψ), pressure p.
//!
//! - Mohr–Coulomb: compression ends at kp + f_c, extension at (p − f_c)/k or at the cut-off −f_t; in plane strain the
//!   face does not flow along the held direction, whose stress stays ν(σ_x + σ_z). Once all change of strain is plastic,
//!   the volume grows by M − 1 for a shortening of 1.
//! - Drucker–Prager: `outer` meets Mohr–Coulomb in compression, `inner` in extension, `plane-strain` where flow is in a
//!   plane (`drucker1952`), reached as the elastic strains die out; there volume over shear is sin ψ.
//! - Hoek–Brown (`hoek2002`): σ₁ = σ₃ + σ_ci(m_b σ₃/σ_ci + s)^a with m_b, s, a of GSI, m_i and D, written out here again.

use crate::rock::{Across, POISSON, axial, rock, slope};
use crate::{Check, Effort, Verification, VerifyError};
use tremolite_laws::Material;
use tremolite_laws::materials::{DruckerPrager, HoekBrown, MohrCoulomb};

const NAME: &str = "rock_strength";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "Mohr–Coulomb, Drucker–Prager and Hoek–Brown rock: triaxial, extension, plane strain, dilation",
    source: "closed forms; `drucker1952` for plane strain, `hoek2002` for the rock mass",
    from: Effort::Test,
    run,
};

/// c \[Pa\], φ \[°\], f_t \[Pa\]: the paper's rock with a lower cut-off.
const COHESION: f64 = 2.18e6;
const FRICTION: f64 = 42.0;
const CUT_OFF: f64 = 1e6;
/// σ_ci \[Pa\] and m_i of the Hoek–Brown rock.
const UCS: f64 = 80e6;
const M_I: f64 = 12.0;

const DRIVEN: &str = "1e-9: the driver meets the pressure to 1e-13 of the modulus times strains of some percent, 1e-10 of the strength";

fn fc() -> f64 {
    2.0 * COHESION * slope(FRICTION).sqrt()
}

fn envelope(dilation: f64) -> [(&'static str, f64); 4] {
    [
        ("cohesion", COHESION),
        ("friction_angle", FRICTION.to_radians()),
        ("dilation_angle", dilation.to_radians()),
        ("tensile_strength", CUT_OFF),
    ]
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    mohr_coulomb(&mut checks)?;
    drucker_prager(&mut checks)?;
    hoek_brown(&mut checks)?;
    Ok(checks)
}

/// A stress \[Pa\] of the last row, compression positive.
fn strength(quantity: String, found: f64, exact: f64, relative: f64, note: &str) -> Check {
    Check::new(NAME, quantity, found, exact, relative * exact.abs(), "Pa", note)
}

fn mohr_coulomb(checks: &mut Vec<Check>) -> Result<(), VerifyError> {
    for psi in [0.0, 10.0, FRICTION] {
        let law = rock(MohrCoulomb::NAME, &envelope(psi), &[]);
        for pressure in [0.0, 1e6, 10e6, 40e6] {
            let path = axial(&law, pressure, Across::Pressed, -0.08, 40)?;
            let quantity =
                format!("Mohr–Coulomb, ψ = {psi}°: strength in compression at {} MPa", pressure / 1e6);
            let exact = slope(FRICTION) * pressure + fc();
            checks.push(strength(quantity, -path.stress[40][2], exact, 1e-9, DRIVEN));
            if pressure == 10e6 {
                let volume = |row: usize| path.strain[row][..3].iter().sum::<f64>();
                let growth = (volume(30) - volume(40)) / (path.strain[40][2] - path.strain[30][2]);
                let quantity = format!("Mohr–Coulomb, ψ = {psi}°: growth of volume per shortening");
                let note = "1e-6: differences of strain that the driver meets to 1e-10";
                checks.push(Check::new(NAME, quantity, growth, slope(psi) - 1.0, 1e-6, "1", note));
            }
        }
    }
    let law = rock(MohrCoulomb::NAME, &envelope(10.0), &[]);
    for pressure in [4e6, 15e6, 40e6] {
        let path = axial(&law, pressure, Across::Pressed, 0.05, 40)?;
        let exact = ((pressure - fc()) / slope(FRICTION)).max(-CUT_OFF);
        let quantity = format!("Mohr–Coulomb: pressure left in extension at {} MPa", pressure / 1e6);
        checks.push(strength(quantity, -path.stress[40][2], exact, 1e-9, DRIVEN));
    }
    for pressure in [1e6, 5e6] {
        let path = axial(&law, pressure, Across::Plane, -0.03, 30)?;
        let exact = slope(FRICTION) * pressure + fc();
        let at = format!("at {} MPa", pressure / 1e6);
        let found = path.stress[30];
        let quantity = format!("Mohr–Coulomb: strength in plane strain {at}");
        checks.push(strength(quantity, -found[2], exact, 1e-9, DRIVEN));
        let quantity = format!("Mohr–Coulomb: stress across the plane {at}");
        checks.push(strength(quantity, -found[1], POISSON * (pressure + exact), 1e-9, DRIVEN));
    }
    Ok(())
}

fn drucker_prager(checks: &mut Vec<Check>) -> Result<(), VerifyError> {
    let law = |fit, psi| rock(DruckerPrager::NAME, &envelope(psi), &[("fit", fit)]);
    let pressure = 20e6;
    let exact = slope(FRICTION) * pressure + fc();
    let compressed = axial(&law("outer", 5.0), pressure, Across::Pressed, -0.15, 50)?;
    let quantity = "Drucker–Prager, outer: strength in compression at 20 MPa".to_owned();
    checks.push(strength(quantity, -compressed.stress[50][2], exact, 1e-9, DRIVEN));
    let extended = axial(&law("inner", 5.0), pressure, Across::Pressed, 0.1, 50)?;
    let quantity = "Drucker–Prager, inner: pressure left in extension at 20 MPa".to_owned();
    checks.push(strength(
        quantity,
        -extended.stress[50][2],
        (pressure - fc()) / slope(FRICTION),
        1e-9,
        DRIVEN,
    ));
    for psi in [0.0, 10.0, FRICTION] {
        let path = axial(&law("plane-strain", psi), pressure, Across::Plane, -0.4, 400)?;
        let quantity = format!("Drucker–Prager, ψ = {psi}°: strength in plane strain at 20 MPa");
        let note = "1e-6: the stress across the plane nears its limit as e^(−strain/elastic strain)";
        checks.push(strength(quantity, -path.stress[400][2], exact, 1e-6, note));
        let change: Vec<f64> = (0..3).map(|c| path.strain[400][c] - path.strain[390][c]).collect();
        let ratio = (change[0] + change[2]) / (change[0] - change[2]);
        let quantity = format!("Drucker–Prager, ψ = {psi}°: volume over shear in plane strain");
        let sine = psi.to_radians().sin();
        checks.push(Check::new(NAME, quantity, ratio, sine, 1e-5, "1", note));
    }
    Ok(())
}

fn hoek_brown(checks: &mut Vec<Check>) -> Result<(), VerifyError> {
    for (gsi, disturbance, psi) in [(100.0, 0.0, 0.0), (55.0, 0.0, 8.0), (55.0, 0.7, 0.0), (20.0, 0.0, 5.0)] {
        let numbers = [
            ("compressive_strength", UCS),
            ("gsi", gsi),
            ("m_i", M_I),
            ("disturbance", disturbance),
            ("dilation_angle", f64::to_radians(psi)),
        ];
        let law = rock(HoekBrown::NAME, &numbers, &[]);
        let curve = |least: f64| most(gsi, disturbance, least);
        let who = format!("Hoek–Brown, GSI {gsi}, D {disturbance}");
        let note = "1e-8: the driver, and the return to a curve, whose root is met to 1e-13 of its own scale";
        for pressure in [0.0, 1e6, 10e6, 50e6] {
            let path = axial(&law, pressure, Across::Pressed, -0.1, 50)?;
            let quantity = format!("{who}: strength in compression at {} MPa", pressure / 1e6);
            checks.push(strength(quantity, -path.stress[50][2], curve(pressure), 1e-8, note));
        }
        let extended = axial(&law, 60e6, Across::Pressed, 0.1, 50)?.stress[50];
        if curve(0.0) < 60e6 {
            let quantity = format!("{who}: extension at 60 MPa, curve at the pressure left");
            checks.push(strength(quantity, curve(-extended[2]), 60e6, 1e-8, note));
        }
        let plane = axial(&law, 2e6, Across::Plane, -0.05, 50)?.stress[50];
        let quantity = format!("{who}: strength in plane strain at 2 MPa");
        checks.push(strength(quantity, -plane[2], curve(2e6), 1e-8, note));
    }
    Ok(())
}

/// Largest pressure that goes with the least one \[Pa\].
pub fn most(gsi: f64, disturbance: f64, least: f64) -> f64 {
    let mb = M_I * ((gsi - 100.0) / (28.0 - 14.0 * disturbance)).exp();
    let s = ((gsi - 100.0) / (9.0 - 3.0 * disturbance)).exp();
    let a = 0.5 + ((-gsi / 15.0).exp() - (-20.0f64 / 3.0).exp()) / 6.0;
    least + UCS * (mb * least / UCS + s).powf(a)
}
