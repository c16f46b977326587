//! A ring one element thick under two forces across it.
//!
//! A ring of radius R = 5 m and thickness t in plane strain bears two opposite line loads P. The centroid of its section and the neutral axis are
//! e = R − t/ln(R_o/R_i) apart. Castigliano's theorem for a curved bar, with thrust and shear, gives the shortening
//!
//! δ = P R²/(E' t e) (¼π (1 − e/R + β) − (2/π)(1 − e/R)²), β = 2·(6/5)(1 + ν') e/R, E' = E/(1 − ν²), ν' = ν/(1 − ν).
//!
//! One quarter is modelled and solved directly.
//!
//! **Errors.** Moments are constant in an element, which leaves an error of order 2. Edges that fan out make trapezoids of the sides, which bend too stiffly
//! in an element that passes the patch test (`macneal1987`). They raise the stiffness by about 0.15 (L²/(tR))², with order 4, L being the element's length.
//! `tremolite check` warns where L²/(tR) exceeds 0.6.

use crate::models::Solid;
use crate::sheet::{CELLS, Cell, Node, Ratios, Sheet};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::{FRAC_PI_2, PI};

const NAME: &str = "pinched_ring";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "ring one element thick under two forces: hexahedra and wedges, R/t of 10, 20 and 50",
    source: "Castigliano's theorem of the curved bar; `macneal1987`",
    from: Effort::Test,
    run,
};

const CONCRETE: Solid = Solid { young: 25e9, poisson: 0.2, density: 2500.0 };
const RADIUS: f64 = 5.0;

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for (cell, word) in CELLS {
        for slenderness in [10.0, 20.0, 50.0] {
            let thickness = RADIUS / slenderness;
            let what = format!("R/t = {slenderness}, {word}");
            let of = |n| shortening(n, cell, thickness);
            let ratios = Ratios::new(8, theory(thickness), of)?;
            let quantity = format!("shortening over theory, {what}, 8 a quarter");
            let note = "for information: fanned edges add 0.15 (L²/(tR))² to the stiffness";
            checks.push(Check::beside(NAME, quantity, ratios.coarse, 1.0, "1", note));
            let note = "3 %: moments constant in an element leave 0.4 %, fanned edges 0.15 (L²/(tR))², at most 3.5 %";
            let quantity = format!("shortening over theory, {what}, 16 a quarter");
            checks.push(Check::new(NAME, quantity, ratios.fine, 1.0, 0.03, "1", note));
            checks.push(ratios.order(NAME, &what));
        }
    }
    Ok(checks)
}

/// Shortening \[m\] by 1 N/m.
fn theory(thickness: f64) -> f64 {
    let nu = CONCRETE.poisson / (1.0 - CONCRETE.poisson);
    let young = CONCRETE.young / (1.0 - CONCRETE.poisson * CONCRETE.poisson);
    let half = 0.5 * thickness;
    let eccentricity = (RADIUS - thickness / ((RADIUS + half) / (RADIUS - half)).ln()) / RADIUS;
    let shear = 2.0 * 1.2 * (1.0 + nu) * eccentricity;
    let shape = 0.25 * PI * (1.0 - eccentricity + shear) - 2.0 / PI * (1.0 - eccentricity).powi(2);
    RADIUS * shape / (young * thickness * eccentricity)
}

/// Shortening \[m\] by 1 N/m of `n` elements a quarter.
fn shortening(n: usize, cell: Cell, thickness: f64) -> Result<f64, VerifyError> {
    let step = FRAC_PI_2 / n as f64;
    let width = RADIUS * step;
    let sheet = Sheet::new([n, 1, 1], cell, |[i, j], k| {
        let (sin, cos) = (step * i as f64).sin_cos();
        let r = RADIUS + thickness * k;
        [r * sin, width * j as f64, r * cos]
    });
    let held = |Node { number: [i, ..], .. }: Node| [i == 0, true, i == n];
    // Half of the load on the quarter.
    let share = |node: Node| if node.number[0] == 0 { 0.5 * width * sheet.share(node, &[1]) } else { 0.0 };
    let work = sheet.work(CONCRETE, held, |node| [0.0, 0.0, -share(node)])?;
    // Four quarters, under 1 N/m over the width.
    Ok(4.0 * work / width)
}
