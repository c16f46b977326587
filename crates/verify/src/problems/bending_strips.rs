//! Strips one element thick whose elements are no bricks: wedges, plans that zigzag, edges that lean.
//!
//! A cantilever of ν = 0 is bent by a force F at its tip. Timoshenko's beam gives FL³/(3EI) + FL/(κGA), κ = 5/6.
//!
//! **Errors.** Moments are constant in an element and leave 1/(4n²) with n elements along the strip. The shear strain of a layer is uniform through the
//! thickness, which leaves a sixth of the deflection by shear. Hexahedra whose plan is a trapezoid, and wedges, add an
//! error of order 2.
//!
//! **Edges that lean** to and fro by an angle φ/2 make trapezoids through the thickness. They bend too stiffly, as they must in an element that passes the patch
//! test (`macneal1987`): by about ½ (Lφ/t)², L the element's length, with order 2. `tremolite check` warns of them.

use crate::convergence::order;
use crate::models::Solid;
use crate::sheet::{Cell, Node, Sheet};
use crate::{Check, Effort, Verification, VerifyError};

const NAME: &str = "bending_strips";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "strips one element thick: wedges, hexahedra whose plan zigzags, edges that lean",
    source: "Timoshenko's beam; `macneal1987`",
    from: Effort::Test,
    run,
};

const CONCRETE: Solid = Solid { young: 25e9, poisson: 0.0, density: 2500.0 };

/// Length, width and thickness \[m\].
type Sides = [f64; 3];

const THICK: Sides = [3.0, 1.2, 0.5];
const SLENDER: Sides = [12.0, 1.2, 0.25];

/// How the elements differ from bricks.
#[derive(Clone, Copy)]
struct Shape {
    cell: Cell,
    /// Shift of every other line of nodes along the strip, to and fro, over an element's length.
    zigzag: f64,
    /// Slope of the edges through the thickness, to and fro.
    lean: f64,
}

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let plain = |cell| Shape { cell, zigzag: 0.0, lean: 0.0 };
    let mut checks = Vec::new();
    let note = "1 % with 16: 0.3 % for a layer's uniform shear, 0.7 % for moments constant in an element and for its plan; with 8 \
                four times the latter by order 2, and so 3 %";
    for (what, shape, sides) in [
        ("bricks", plain(Cell::Hexahedra), THICK),
        ("plan that zigzags by 0.3", Shape { zigzag: 0.3, ..plain(Cell::Hexahedra) }, THICK),
        ("wedges", plain(Cell::Wedges), THICK),
        ("slender wedges", plain(Cell::Wedges), SLENDER),
    ] {
        for (n, tolerance) in [(8, 0.03), (16, 0.01)] {
            let quantity = format!("deflection over theory, {what}, {n} elements");
            checks.push(Check::new(NAME, quantity, deflection(n, shape, sides)?, 1.0, tolerance, "1", note));
        }
    }
    for degrees in [5.0_f64, 10.0] {
        let shape = Shape { lean: degrees.to_radians().tan(), ..plain(Cell::Hexahedra) };
        let mut excess = Vec::new();
        for n in [10, 20, 40] {
            let found = deflection(n, shape, SLENDER)?;
            excess.push(1.0 / found - 1.0);
            let quantity = format!("deflection over theory, edges that lean by {degrees}°, {n} elements");
            let note = "for information: 1/(1 + ½ (Lφ/t)²) by the sides that are trapezoids";
            checks.push(Check::beside(NAME, quantity, found, 1.0, "1", note));
        }
        let p = order(excess[1], excess[2], 2.0).after(excess[0], 2.0);
        let quantity = format!("order of the stiffness over theory, less 1, edges that lean by {degrees}°");
        let note = "2 within 0.1: (Lφ/t)² at a fixed angle";
        checks.push(Check::new(NAME, quantity, p, 2.0, 0.1, "1", note).with_order(p));
    }
    Ok(checks)
}

/// Deflection of the tip over that of theory.
fn deflection(n: usize, shape: Shape, [length, width, thickness]: Sides) -> Result<f64, VerifyError> {
    let across = (n / 2).min(8);
    let step = length / n as f64;
    let sheet = Sheet::new([n, across, 1], shape.cell, |[i, j], k| {
        let sign = |number: usize| if number.is_multiple_of(2) { 1.0 } else { -1.0 };
        let (zigzag, lean) = match i {
            i if i == 0 || i == n => (0.0, 0.0),
            _ => (0.5 * shape.zigzag * step * sign(j), shape.lean * thickness * k * sign(i)),
        };
        [step * i as f64 - zigzag + lean, width * j as f64 / across as f64, thickness * k]
    });
    let held = |node: Node| [node.number[0] == 0; 3];
    let force = |node: Node| if node.number[0] == n { sheet.share(node, &[1]) } else { 0.0 };
    let found = sheet.work(CONCRETE, held, |node| [0.0, 0.0, force(node)])?;
    let second = width * thickness.powi(3) / 12.0;
    let shear = 5.0 / 6.0 * CONCRETE.moduli().mu * width * thickness;
    Ok(found / (length.powi(3) / (3.0 * CONCRETE.young * second) + length / shear))
}
