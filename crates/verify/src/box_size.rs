//! How far sides must stand from a cavern: the same cavern in boxes of several widths, with every kind of sides that lets a wave
//! from below pass.

use crate::VerifyError;
use crate::models::{Solid, material};
use crate::simulation::{Simulation, whole_steps};
use tremolite::hexahedra::centroid;
use tremolite::{Base, Body, Domain, Incident, Problem, Quadrature, Side};
use tremolite_laws::materials::MohrCoulomb;
use tremolite_laws::{Material, Values};
use tremolite_mesh::boxes::BoxSpec;
use tremolite_motion::{Motion, ricker_velocity};

/// Width and height of the cavern, and the size of elements \[m\].
pub const WIDTH: f64 = 20.0;
const ELEMENT: f64 = 2.5;
/// Height of the model, levels of the cavern's floor and roof \[m\].
const HEIGHT: f64 = 120.0;
const FLOOR: f64 = 50.0;
/// Levels between which rock is weak, if it is \[m\].
const WEAK: [f64; 2] = [20.0, 40.0];
const ROCK: Solid = Solid { young: 8e9, poisson: 0.25, density: 2600.0 };
/// Peak of the incident velocity \[m/s\].
const PEAK: f64 = 0.3;
/// Peak frequencies \[Hz\] of the pulses: where strong motion has its energy, and near the upper end of what caverns see.
pub const FREQUENCIES: [f64; 2] = [3.0, 8.0];
/// Centre of the pulse and end of the run, in its periods.
const PERIODS: [f64; 2] = [1.2, 5.0];
/// Shear and some of it vertical.
const ALONG: [f64; 3] = [0.8, 0.0, 0.6];

/// Distances of sides from the cavern's walls, in widths of it, and that of the sides that all are compared with.
pub const DISTANCES: [u32; 4] = [1, 2, 4, 8];
pub const FAR: u32 = 16;

/// The rock mass around the cavern.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum RockMass {
    Elastic,
    /// Elastic but for a layer below the cavern, which yields in the free field as well.
    Yielding,
}

/// Displacements \[m\] at the nodes of the cavern's walls, row by row.
pub struct Seen {
    rows: Vec<Vec<[f64; 3]>>,
}

impl Seen {
    /// Largest displacement of each node.
    fn peaks(&self) -> Vec<f64> {
        let nodes = self.rows.first().map_or(0, Vec::len);
        let square = |u: [f64; 3]| u.iter().map(|x| x * x).sum::<f64>();
        (0..nodes).map(|n| self.rows.iter().map(|row| square(row[n])).fold(0.0, f64::max).sqrt()).collect()
    }

    /// Differences from another run over the largest displacement in that: of the nodes' peaks, and of any component at any time.
    pub fn apart(&self, other: &Seen) -> [f64; 2] {
        let (own, others) = (self.peaks(), other.peaks());
        let peak = others.iter().copied().fold(0.0, f64::max);
        let most = |all: &mut dyn Iterator<Item = f64>| {
            all.fold(0.0, |most: f64, d| if d <= most { most } else { d })
        };
        let of_peaks = most(&mut own.iter().zip(&others).map(|(a, b)| (a - b).abs()));
        let pairs = self.rows.iter().flatten().flatten().zip(other.rows.iter().flatten().flatten());
        [of_peaks / peak, most(&mut pairs.map(|(a, b)| (a - b).abs())) / peak]
    }
}

/// Runs the cavern in a slice, periodic along y, whose sides across x stand so many widths from its walls.
///
/// # Errors
/// If it does not run.
pub fn shake(mass: RockMass, sides: Side, widths: u32, frequency: f64) -> Result<Seen, VerifyError> {
    let half = 0.5 * WIDTH + WIDTH * f64::from(widths);
    let count = |length: f64| (length / ELEMENT).round() as u32;
    let counts = [count(2.0 * half), 1, count(HEIGHT)];
    let mesh = BoxSpec::uniform([-half, 0.0, 0.0], [half, ELEMENT, HEIGHT], counts).mesh()?;
    let inside = |e: &u32| {
        let x = centroid(&mesh, *e);
        x[0].abs() < 0.5 * WIDTH && x[2] > FLOOR && x[2] < FLOOR + WIDTH
    };
    let weak = |e: &u32| mass == RockMass::Yielding && (WEAK[0]..WEAK[1]).contains(&centroid(&mesh, *e)[2]);
    let (soft, rock) = (0..mesh.elements.len() as u32).filter(|e| !inside(e)).partition(weak);
    let mut bodies = vec![ROCK.body("rock", rock, Quadrature::OnePoint)];
    if mass == RockMass::Yielding {
        let values = Values::default()
            .with("young", ROCK.young)
            .with("poisson", ROCK.poisson)
            .with("cohesion", 8e5)
            .with("friction_angle", 0.5)
            .with("tensile_strength", 5e5);
        let weak = material(MohrCoulomb::NAME, &values)?;
        bodies.push(Body { material: weak, ..ROCK.body("weak", soft, Quadrature::OnePoint) });
    }
    let mut problem = Problem::new(mesh, bodies);
    problem.sides = [sides, Side::Periodic];
    problem.base = Base::ViscousSpring { normal: 1.33, tangential: 0.67, distance: None };
    let [centre, end] = PERIODS.map(|periods| periods / frequency);
    let pulse = ricker_velocity(frequency, centre, PEAK);
    let motion = Motion::sampled(1e-3, end, |t| pulse(t).along(ALONG))?;
    problem.incident = Some(Incident { motion, factor: 1.0 });

    let simulation = Simulation::new(problem)?;
    let walls: Vec<usize> = simulation
        .model
        .nodes
        .of(Domain::Model)
        .filter(|&n| {
            let [x, y, z] = simulation.position(n);
            let (x, z) = (x.abs() - 0.5 * WIDTH, (z - FLOOR - 0.5 * WIDTH).abs() - 0.5 * WIDTH);
            y == 0.0 && x.max(z).abs() < 1e-6
        })
        .collect();
    let stable = simulation.bound().to_run(0.9);
    // One step for all boxes, whose bounds differ by round-off.
    let (every, dt) = whole_steps(5e-3, (stable * 1e5).floor() * 1e-5);
    let mut rows = Vec::new();
    simulation.run_from_rest(dt, every * (end / 5e-3).round() as u64, |state| {
        if state.step.is_multiple_of(every) {
            let mut row: Vec<([f64; 3], [f64; 3])> =
                walls.iter().map(|&n| (simulation.position(n), state.u[n].xyz())).collect();
            // Numbers of nodes differ between boxes.
            row.sort_by(|(a, _), (b, _)| a[0].total_cmp(&b[0]).then(a[2].total_cmp(&b[2])));
            rows.push(row.into_iter().map(|(_, u)| u).collect());
        }
    })?;
    Ok(Seen { rows })
}
