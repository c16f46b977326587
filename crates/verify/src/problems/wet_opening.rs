//! A round opening in rock with water, which flows to it.
//!
//! **Exact.** Ring a to b in plane strain, before: total stress −P in the plane and −P_y along the axis, water p₀ throughout. The core is
//! excavated and its wall drained, while the outer edge keeps −P and p₀; between, p = p₀ ln(r/a)/ln(b/a), steady flow. With Δp = p − p₀ and
//! η = (1 − 2ν)/(2(1 − ν)), the elastic change is that of a stress −αΔp (`biot1941`): with I(r) = ∫ₐʳ Δp r dr,
//! 2G u = 2ηα I/r + (1 − 2ν) A r + B/r, and on the wall and the outer edge the total stress is 0 and −P.
//! With Mohr–Coulomb on effective stress the ring was integrated outwards along r with the elastic part joined at the plastic radius, without
//! dilation (residual of equilibrium 3·10⁻⁸ P); those figures are the constants below. Yield by total stress would give 9.52 mm, and
//! without water it is 10.06 mm, so a tolerance of 1 % tells them apart.
//!
//! **Model.** A quarter, its core excavated in a stage, in which the pressure becomes that of the flow. Laws see σ' = σ + p, and grains give way
//! by (1 − α)Δp/3K. The pressure is that of the exact flow, and in one line that of the flow which `tremolite_seepage` finds on the mesh (laid
//! flat, so that heights hardly count).

use crate::convergence::order;
use crate::models::{QUADRATURES, Solid, material};
use crate::staged::{Rested, Rings, SINCE_CHANGE, UNTIL_CHANGE, growing, release};
use crate::{Check, Effort, Verification, VerifyError};
use std::f64::consts::FRAC_PI_2;
use tremolite::hexahedra::{centroid, hex_nodes};
use tremolite::history::History;
use tremolite::water::Spell;
use tremolite::{Life, Quadrature, Stage, Traction, Water};
use tremolite_laws::materials::MohrCoulomb;
use tremolite_laws::shapes::hex8::{gauss_point, shape_values};
use tremolite_laws::{Material, Role, Values};
use tremolite_mesh::Mesh;
use tremolite_seepage::{Ground, Holds, Place, steady};

const NAME: &str = "wet_opening";

pub const PROBLEM: Verification = Verification {
    name: NAME,
    summary: "round opening to which water flows: convergence of the wall, elastic by Biot and plastic by effective stress",
    source: "`biot1941`, `terzaghi1943`, integrated along the radius",
    from: Effort::Verify,
    run,
};

const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2600.0 };
/// a, b \[m\]
const WALL: f64 = 5.0;
const OUTER: f64 = 50.0;
/// P, P_y, p₀ \[Pa\]
const PLANE: f64 = 8e6;
const AXIAL: f64 = 5e6;
const WATER: f64 = 2e6;
/// c \[Pa\], φ \[°\]
const COHESION: f64 = 0.8e6;
const FRICTION: f64 = 35.0;
/// Of the plastic ring with α = 1: convergence of the wall and plastic radius \[m\].
const PLASTIC: [f64; 2] = [0.010631691819534491, 8.374186131557822];
/// The same without water.
const DRY: [f64; 2] = [0.010058322922737357, 7.933468035258864];

fn run(_: Effort) -> Result<Vec<Check>, VerifyError> {
    let mut checks = Vec::new();
    for (quadrature, word) in QUADRATURES {
        for alpha in [1.0, 0.6] {
            let exact = elastic(alpha);
            let [coarse, fine] = [8, 16].map(|n| open(quadrature, Some((alpha, Pressure::Exact)), false, n));
            let [coarse, fine] = [coarse?.wall / exact, fine?.wall / exact];
            let note = "1 %: of order 2 in the angle of an element, 1 % its square";
            let quantity = format!("wall's motion over exact, elastic, α = {alpha}, n = 16, {word}");
            checks.push(Check::new(NAME, quantity, fine, 1.0, 0.01, "1", note));
            let p = order((coarse - 1.0).abs(), (fine - 1.0).abs(), 2.0);
            let note = "order 2 within 0.4";
            let quantity = format!("order of the wall's motion, elastic, α = {alpha}, {word}");
            checks.push(Check::new(NAME, quantity, p, 2.0, 0.4, "1", note).with_order(p));
        }
        let opened = open(quadrature, Some((1.0, Pressure::Found)), false, 16)?;
        let note = "1 %, as with the exact flow";
        let quantity = format!("wall's motion over exact, elastic, α = 1, with the flow found, {word}");
        checks.push(Check::new(NAME, quantity, opened.wall / elastic(1.0), 1.0, 0.01, "1", note));
        // The wall's motion hardly feels a flow that is wrong in one direction.
        let note = "on rings that grow in proportion nodes are exact; a conductivity 30 % less in one direction gives 3.3 %";
        let quantity = format!("largest error of the pressure found over p₀, n = 16, {word}");
        checks.push(Check::new(NAME, quantity, opened.off, 0.0, 1e-9, "1", note));
        // Of several points the even motion is lost on finer meshes, without dilation, with water or without.
        let around = if quadrature == Quadrature::Full { 32 } else { 48 };
        for (water, [wall, radius], what) in [(Some((1.0, Pressure::Exact)), PLASTIC, "wet"), (None, DRY, "dry")] {
            let opened = open(quadrature, water, true, around)?;
            let note = "1 %: yield by total stress gives 0.895, no water 0.946";
            let quantity = format!("wall's motion over exact, Mohr–Coulomb, {what}, {word}");
            checks.push(Check::new(NAME, quantity, opened.wall / wall, 1.0, 0.01, "1", note));
            let ring = radius * FRAC_PI_2 / f64::from(around);
            let note = "an element there: an element yields or not";
            let quantity = format!("plastic radius, {what}, {word}");
            checks.push(Check::new(NAME, quantity, opened.plastic, radius, ring, "m", note));
        }
    }
    Ok(checks)
}

/// Inward motion of the wall \[m\] of elastic rock.
fn elastic(alpha: f64) -> f64 {
    let (nu, shear) = (ROCK.poisson, ROCK.moduli().mu);
    let eta = alpha * (1.0 - 2.0 * nu) / (2.0 * (1.0 - nu));
    // ∫ Δp r dr from a to b, Δp = p₀ (ln(r/a)/ln(b/a) − 1).
    let log = (OUTER / WALL).ln();
    let square = |r: f64| 0.5 * r * r;
    let moment = (square(OUTER) * log - 0.5 * (square(OUTER) - square(WALL))) / log;
    let integral = WATER * (moment - (square(OUTER) - square(WALL)));
    // Change of σ_r: A − B/r² − 2η I/r²; P on the wall, 0 on the outer edge.
    let [a, b] = [WALL, OUTER].map(|r| r.powi(-2));
    let bend = (PLANE - 2.0 * eta * integral * b) / (b - a);
    let even = PLANE + bend * a;
    -((1.0 - 2.0 * nu) * even * WALL + bend / WALL) / (2.0 * shear)
}

/// Where the pressure of the flow comes from.
#[derive(Clone, Copy)]
enum Pressure {
    Exact,
    Found,
}

/// p \[Pa\] at the nodes of the steady flow through the rock, found on the mesh.
fn found(mesh: &Mesh, rock: &[u32]) -> Result<Vec<f64>, VerifyError> {
    // The axis of the opening stands upright, and all of it below the head at the wall.
    let top = mesh.nodes.iter().map(|x| x[1]).fold(f64::NEG_INFINITY, f64::max);
    let nodes: Vec<[f64; 3]> = mesh.nodes.iter().map(|x| [x[2], x[0], x[1] - top]).collect();
    let elements: Vec<[u32; 8]> = rock.iter().map(|&e| hex_nodes(mesh, e as usize)).collect();
    let ground = Ground { nodes: &nodes, elements: &elements, conductivity: &vec![1e-7; elements.len()] };
    let weight = 9810.0;
    let place = |name: &str, radius: f64, head: f64| {
        let at = |x: &[f64; 3]| (x[0].hypot(x[1]) - radius).abs() < 1e-6;
        let nodes = (0u32..).zip(&nodes).filter(|(_, x)| at(x)).map(|(n, _)| (n, 1.0)).collect();
        Place { name: name.to_owned(), holds: Holds::Head(head), nodes }
    };
    let flow = steady(&ground, &[place("wall", WALL, 0.0), place("outer", OUTER, WATER / weight)]);
    let heads = flow.map_err(|e| VerifyError::Setup(e.to_string()))?.heads;
    // Other nodes, of the core and of what stands apart, have none.
    let own: std::collections::BTreeSet<u32> = elements.iter().flatten().copied().collect();
    let pressure = |(n, h): (u32, f64)| if own.contains(&n) { weight * h } else { 0.0 };
    Ok((0u32..).zip(heads).map(pressure).collect())
}

/// p \[Pa\] of the steady flow.
fn flow(x: [f64; 3]) -> f64 {
    let r = x[0].hypot(x[2]);
    WATER * ((r / WALL).ln() / (OUTER / WALL).ln()).max(0.0)
}

/// Still water, then the flow: its mean over the points of an element, and at nodes; by its values at nodes where it is found on the mesh.
fn spells(mesh: &Mesh, apart: u32, found: Option<Vec<f64>>) -> Vec<Spell> {
    let mean = |e: usize| {
        let corners = hex_nodes(mesh, e);
        let at = |p: usize| {
            let n = shape_values(gauss_point(p));
            let sum = |of: &dyn Fn(usize) -> f64| (0..8).map(|k| n[k] * of(corners[k] as usize)).sum::<f64>();
            match &found {
                Some(nodes) => sum(&|node| nodes[node]),
                None => flow([0, 1, 2].map(|i| sum(&|node| mesh.nodes[node][i]))),
            }
        };
        (0..8).map(at).sum::<f64>() / 8.0
    };
    let own = |e: usize, p: f64| if e == apart as usize { 0.0 } else { p };
    let count = mesh.elements.len();
    vec![
        Spell {
            from: Stage::Before(0),
            elements: (0..count).map(|e| own(e, WATER)).collect(),
            nodes: vec![WATER; mesh.nodes.len()],
        },
        Spell {
            from: Stage::Before(1),
            elements: (0..count).map(|e| own(e, mean(e))).collect(),
            nodes: found.unwrap_or_else(|| mesh.nodes.iter().map(|&x| flow(x)).collect()),
        },
    ]
}

struct Opened {
    /// Mean motion of the wall inwards \[m\].
    wall: f64,
    /// Outer radius of the elements that yielded \[m\].
    plastic: f64,
    /// Largest difference from p of the steady flow at a node, over p₀; 0 where that is what is given.
    off: f64,
}

/// Excavates with `around` elements around the quarter, in rock with α and water of that pressure, or without.
fn open(quadrature: Quadrature, water: Option<(f64, Pressure)>, yields: bool, around: u32) -> Result<Opened, VerifyError> {
    let mut radii: Vec<f64> = (0..=4).map(|i| WALL * f64::from(i) / 4.0).collect();
    let grown = growing(WALL, OUTER, FRAC_PI_2 / f64::from(around));
    let half = (OUTER / WALL).powf(0.5 / grown.len() as f64);
    radii.extend(grown);
    let rings = Rings::new(radii, around, false);
    let (core, rock) = (rings.between(0.0, WALL), rings.between(WALL, OUTER));
    let brick = rings.brick();
    let apart = brick.elements[0];
    let mut body = ROCK.body("rock", core.iter().chain(&rock).copied().collect(), quadrature);
    if yields {
        let values = Values::default()
            .with("young", ROCK.young)
            .with("poisson", ROCK.poisson)
            .with("cohesion", COHESION)
            .with("friction_angle", FRICTION.to_radians())
            .with("dilation_angle", 0.0)
            .with("tensile_strength", COHESION / FRICTION.to_radians().tan());
        body.material = material(MohrCoulomb::NAME, &values)?;
    }
    let mut problem = tremolite::Problem::new(rings.mesh.clone(), vec![body, brick]);
    let count = problem.mesh.elements.len();
    problem.lives = vec![Life::ALWAYS; count];
    core.iter().for_each(|&e| problem.lives[e as usize] = UNTIL_CHANGE);
    let stress = [-PLANE, -AXIAL, -PLANE, 0.0, 0.0, 0.0];
    problem.initial = vec![stress; count];
    problem.initial[apart as usize] = [0.0; 6];
    problem.held = rings.symmetry();
    problem.tractions = [UNTIL_CHANGE, SINCE_CHANGE]
        .map(|life| Traction { name: "outer".into(), faces: rings.edge(|_| stress), life })
        .into();
    let mut off = 0.0_f64;
    if let Some((alpha, pressure)) = water {
        let mut biot = vec![alpha; count];
        biot[apart as usize] = 0.0;
        let found = match pressure {
            Pressure::Exact => None,
            Pressure::Found => Some(found(&problem.mesh, &rock)?),
        };
        if let Some(found) = &found {
            let nodes = rock.iter().flat_map(|&e| hex_nodes(&problem.mesh, e as usize));
            off = nodes.map(|n| n as usize).fold(0.0, |most, n| {
                most.max((found[n] - flow(problem.mesh.nodes[n])).abs() / WATER)
            });
        }
        problem.water = Water { biot, spells: spells(&problem.mesh, apart, found), ..Water::default() };
    }
    let opened = Rested::new(problem, &[release(1.0), release(1.0)])?;
    let [wall, ..] = rings.inwards(&opened, WALL);
    let history = History::new(&opened.assembly, &opened.state.history);
    let mut plastic = 0.0_f64;
    for &element in &rock {
        let Some(slot) = opened.phase.element_slot[element as usize] else { continue };
        let column = history.with_role(&slot, Role::PlasticShear);
        let strain = column.map_or(0.0, |column| history.values(&slot, column).fold(0.0, f64::max));
        if strain > 0.0 {
            let x = centroid(&opened.model.mesh, element);
            plastic = plastic.max(x[0].hypot(x[2]) * half);
        }
    }
    Ok(Opened { wall, plastic, off })
}

#[cfg(test)]
mod tests {
    use super::elastic;

    /// The ring integrated numerically by others.
    #[test]
    fn the_closed_form_is_that_of_the_integration() {
        for (alpha, wall) in [(1.0, 0.005205161470039211), (0.6, 0.005153399912326556)] {
            let own = elastic(alpha);
            assert!((own / wall - 1.0).abs() < 1e-9, "{own} {wall}");
        }
    }
}
