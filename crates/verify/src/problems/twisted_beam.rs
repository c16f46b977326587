//! The twisted cantilever of MacNeal and Harder.
//!
//! A strip of 12 × 1.1 × 0.32, E = 29·10⁶, ν = 0.22, turns by 90° from its clamped root to its tip, so that its elements are warped. Unit forces at
//! the tip move it by 5.424·10⁻³ along its width, and by 1.754·10⁻³ along its thickness (`macneal1985`). The strip is one element thick, of 12 × 2
//! elements as published, and of 24 × 4. It is solved directly.
//!
//! The force along the thickness of the tip bends the root in the plane of the strip. There wedges have the constant membrane strain of triangles, and two of
//! them across the width reach 0.85 of the motion, four 0.93.

use crate::models::Solid;
use crate::sheet::{CELLS, Cell, Node, Sheet};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::FRAC_PI_2;

const NAME: &str = "twisted_beam";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "cantilever twisted by 90°, one element thick: hexahedra and wedges under forces both ways",
    source: "`macneal1985`",
    from: Effort::Test,
    run,
};

const STEEL: Solid = Solid { young: 29e6, poisson: 0.22, density: 1.0 };
const LENGTH: f64 = 12.0;
const WIDTH: f64 = 1.1;
const THICKNESS: f64 = 0.32;

/// Component of the force, the word for it, and the motion along it.
const LOADS: [(usize, &str, f64); 2] = [(2, "along the width", 5.424e-3), (1, "along the thickness", 1.754e-3)];

fn run(effort: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    let counts: &[usize] = if effort == Effort::Full { &[12, 24, 48] } else { &[12, 24] };
    for (cell, word) in CELLS {
        for (component, way, published) in LOADS {
            for &n in counts {
                let found = motion(n, cell, component)? / published;
                let quantity = format!("motion {way} over the published one, {word}, {n} × {}", n / 6);
                let check = match (cell, component) {
                    (Cell::Wedges, 1) => {
                        let note = "for information: at the root the force bends the strip in its plane, where \
                                    triangles have a constant strain";
                        Check::beside(NAME, quantity, found, 1.0, "1", note)
                    }
                    _ => {
                        let note = "3 % of 12 × 2, a quarter of it and the published digits of finer meshes: moments \
                                    constant in an element, and warped elements, with order 2";
                        let tolerance = if n == 12 { 0.03 } else { 0.0075 + 0.0005 };
                        Check::new(NAME, quantity, found, 1.0, tolerance, "1", note)
                    }
                };
                checks.push(check);
            }
        }
    }
    Ok(checks)
}

/// Motion of the tip along a unit force.
fn motion(n: usize, cell: Cell, component: usize) -> Result<f64, VerifyError> {
    let across = n / 6;
    let sheet = Sheet::new([n, across, 1], cell, |[i, j], k| {
        let along = i as f64 / n as f64;
        let (sin, cos) = (FRAC_PI_2 * along).sin_cos();
        let [y, z] = [WIDTH * (j as f64 / across as f64 - 0.5), THICKNESS * k];
        [LENGTH * along, cos * y - sin * z, sin * y + cos * z]
    });
    let force = |node: Node| {
        let share = if node.number[0] == n { sheet.share(node, &[1]) } else { 0.0 };
        [0, 1, 2].map(|i| if i == component { share } else { 0.0 })
    };
    sheet.work(STEEL, |node| [node.number[0] == 0; 3], force)
}
