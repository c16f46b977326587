//! A round cavity, bare or lined, in a slice of a space without end: mesh, run under a P wave from below, and hoop stresses
//! beside the exact ones of [`crate::scattering`].
//!
//! The cavity's axis lies along y, where the slice is one element thick and periodic; the wave travels along z. Rings about the
//! axis go over into a square four radii wide, and a grid goes on from there to the box: its base of dashpots brings the wave
//! in, its sides are those of the free field, its top absorbs. On the wave's way, from the base to the square, all rows are as
//! high as those of the square; sideways and upwards elements grow by a tenth from one to the next.
//!
//! Stresses are compared with what is exact at the same radius and angle: those of the first ring's centres, or of a liner's
//! points, taken together along a fibre at its middle, since the strain along a fibre is even in these elements.

pub mod aslant;
mod mesh;

use crate::VerifyError;
use crate::models::Solid;
use crate::scattering::{Cavity, Incoming, Place};
use crate::simulation::{Simulation, whole_steps};
use crate::staged::turned;
use mesh::Parts;
use num_complex::Complex64;
use std::f64::consts::{FRAC_PI_2, TAU};
use tremolite::{Base, Incident, Problem, Quadrature, Side, Snapshot, Top};
use tremolite_mesh::Mesh;
use tremolite_motion::Motion;

/// Rock, and the liner of concrete; densities are equal.
pub const ROCK: Solid = Solid { young: 10e9, poisson: 0.25, density: 2752.293577981651 };
const LINER: Solid = Solid { young: 25e9, poisson: 0.17, density: 2752.293577981651 };
/// Radius \[m\] of the rock's wall, and within a liner.
const RADII: [f64; 2] = [8.5, 8.0];
pub const BARE: Cavity = Cavity { rock: ROCK, radius: RADII[0], liner: None };
pub const LINED: Cavity = Cavity { rock: ROCK, radius: RADII[0], liner: Some((LINER, RADII[1])) };

/// Incident stress \[Pa\].
const STRESS: f64 = 1e6;

/// A model of a cavity.
#[derive(Clone, Copy, Debug)]
pub struct Slice {
    pub cavity: Cavity,
    /// Elements along each side of the square, even: a quarter of those around. They are 4/n of the radius wide.
    pub elements: u32,
    /// Rings of the liner.
    pub layers: u32,
    /// Half the width and height of the box over the radius, from 2 on.
    pub reach: f64,
    /// Up to this size over the radius elements of the grid grow. What is scattered in waves of four of them or less never
    /// reaches the box: it turns back where elements grow.
    pub coarsest: f64,
}

/// What came of a run: σ_θ over the incident stress, by place and time.
struct Seen {
    places: Vec<Place>,
    /// \[s\], 0 when the front is at the near wall.
    times: Vec<f64>,
    hoops: Vec<Vec<f64>>,
}

impl Slice {
    /// c_p \[m/s\] of the rock.
    fn speed(&self) -> f64 {
        self.cavity.rock.speeds().0
    }

    /// The time \[s\] in which the wave travels a radius.
    fn unit(&self) -> f64 {
        self.cavity.radius / self.speed()
    }

    /// The largest errors of σ_θ over its peak under a step of stress with a rise, in times of a radius: while nothing can have
    /// come back from the box, and until `end`.
    ///
    /// # Errors
    /// As [`Slice::run`].
    pub fn step(&self, rise: f64, end: f64) -> Result<[f64; 2], VerifyError> {
        let unit = self.unit();
        let (rise, end) = (rise * unit, end * unit);
        let rate =
            |t: f64| if (0.0..rise).contains(&t) { (1.0 - (TAU * t / rise).cos()) / rise } else { 0.0 };
        let seen = self.run(rate, [end, end], 100)?;
        // The series' period is long enough but for 1e-4, as its own tests say.
        let exact = self.cavity.step(rise, 200.0 * unit, &seen.places, &seen.times);
        let echo = 2.0 * (self.reach - 1.0) * unit;
        Ok([echo, end].map(|until| seen.error(&exact, until)))
    }

    /// Under sines of ka = ωr/c_p together, once all is steady: the largest error of σ_θ in amplitude and phase, as a complex
    /// number, over the largest amplitude, by ka. All ka are multiples of the first argument, in whose period they are seen.
    ///
    /// # Errors
    /// As [`Slice::run`].
    pub fn sines(&self, fundamental: f64, times: &[u32], settle: f64) -> Result<Vec<f64>, VerifyError> {
        let unit = self.unit();
        let omegas: Vec<f64> = times.iter().map(|k| f64::from(*k) * fundamental / unit).collect();
        let (ramp, period) = (20.0 * unit, TAU * unit / fundamental);
        let rate = |t: f64| {
            let x = (t / ramp).min(1.0);
            let (size, slope) = (x - (TAU * x).sin() / TAU, (1.0 - (TAU * x).cos()) / ramp);
            omegas.iter().map(|omega| slope * (omega * t).sin() + size * omega * (omega * t).cos()).sum()
        };
        let rows = 16 * times.iter().max().copied().unwrap_or(1);
        let seen = self.run(rate, [period, period + settle * unit], rows)?;
        let mut errors = Vec::new();
        for omega in omegas {
            let exact = self.cavity.scatter(Incoming::P, omega).hoops(&seen.places);
            let largest = exact.iter().fold(0.0, |most: f64, x| most.max(x.norm()));
            let error = seen.hoops.iter().zip(exact).map(|(hoops, exact)| {
                // i e^(−iωt) is a sine at the axis, a radius behind the wall.
                let turn = |t: f64| Complex64::from_polar(2.0 / f64::from(rows), omega * (t - unit));
                let found: Complex64 =
                    hoops.iter().zip(&seen.times).map(|(hoop, t)| -Complex64::I * turn(*t) * hoop).sum();
                (found - exact).norm() / largest
            });
            errors.push(error.fold(0.0, f64::max));
        }
        Ok(errors)
    }

    /// Runs until `end` \[s\] after the front is at the near wall and looks `rows` times in the last `span` \[s\], equally
    /// spaced; `rate` \[1/s\] is that of the incident stress over [`STRESS`].
    ///
    /// # Errors
    /// If it is no model or becomes unstable.
    fn run(&self, rate: impl Fn(f64) -> f64, [span, end]: [f64; 2], rows: u32) -> Result<Seen, VerifyError> {
        let Parts { mesh, liner, rock, wall } = self.parts();
        let mut bodies = vec![self.cavity.rock.body("rock", rock, Quadrature::OnePoint)];
        if let Some((solid, _)) = self.cavity.liner {
            bodies.push(solid.body("liner", liner.clone(), Quadrature::Full));
        }
        let mut problem = Problem::new(mesh, bodies);
        problem.base = Base::Viscous;
        problem.sides = [Side::FreeField, Side::Periodic];
        problem.top = Top::Viscous;
        // From the base to the near wall.
        let delay = (self.reach - 1.0) * self.unit();
        let until = delay + end;
        // σ_zz = −ρc_p v of a wave that travels up.
        let factor = -STRESS / (self.cavity.rock.density * self.speed());
        let sample = 0.01 * self.unit();
        let samples = (until / sample).ceil() as u32 + 2;
        let up: Vec<f64> = (0..samples).map(|k| factor * rate(f64::from(k) * sample)).collect();
        let motion = Motion::from_acceleration(sample, [vec![0.0; up.len()], vec![0.0; up.len()], up])?;
        problem.incident = Some(Incident { motion, factor: 1.0 });
        let simulation = Simulation::new(problem)?;

        let elements: Vec<u32> = if liner.is_empty() { wall } else { liner };
        let looked = self.fibres(&simulation, &elements, false);
        let (between, dt) = whole_steps(span / f64::from(rows), 0.9 * simulation.stable());
        // So many steps before the first look that the last one is at the end.
        let steps = (until / dt).round() as u64;
        let first = steps - between * u64::from(rows - 1);
        let mut engine = simulation.engine();
        let mut state = simulation.start(&mut engine, dt, |_| [[0.0; 3]; 2]);
        let mut seen = Seen {
            hoops: vec![Vec::new(); looked.places.len()],
            places: looked.places.clone(),
            times: Vec::new(),
        };
        for step in 1..=steps {
            engine.step(&mut state);
            if step >= first && (step - first).is_multiple_of(between) {
                let snapshot = engine.look(&state).snapshot;
                seen.times.push(state.time() - delay);
                looked.hoops(&snapshot, &mut seen.hoops);
            }
        }
        Ok(seen)
    }

    /// The fibres of elements, with σ_θ or, `across`, with σ_θy.
    fn fibres(&self, simulation: &Simulation, elements: &[u32], across: bool) -> Looked {
        let mut looked = Looked { across, ..Looked::default() };
        for &element in elements {
            let Some(slot) = simulation.phase.element_slot[element as usize] else { continue };
            let (first, count) = (slot.point as usize, usize::from(slot.points));
            // Of 2×2×2 points those with the same bit 0 lie at one radius.
            let sides: &[f64] = if count == 1 { &[0.0] } else { &[-1.0, 1.0] };
            for (side, bit) in sides.iter().zip(0..) {
                let x = fibre(&simulation.model.mesh, element, side / 3f64.sqrt());
                let points: Vec<usize> = (first..first + count).filter(|p| (p - first) & 1 == bit).collect();
                looked.places.push([x[0].hypot(x[1]), FRAC_PI_2 - x[1].atan2(x[0])]);
                looked.fibres.push((points, x[1].atan2(x[0])));
            }
        }
        looked
    }
}

/// What is looked at: fibres, or nodes.
#[derive(Default)]
struct Looked {
    /// σ_θy in place of σ_θ.
    across: bool,
    /// r \[m\], and of fibres the angle from z towards x \[rad\].
    places: Vec<Place>,
    /// Points, and the angle from x towards z \[rad\].
    fibres: Vec<(Vec<usize>, f64)>,
    nodes: Vec<usize>,
}

impl Looked {
    /// Adds the stress along each fibre over the incident one.
    fn hoops(&self, snapshot: &Snapshot, hoops: &mut [Vec<f64>]) {
        for (hoops, (points, angle)) in hoops.iter_mut().zip(&self.fibres) {
            let (sine, cosine) = angle.sin_cos();
            let of =
                |s: &[f64; 6]| if self.across { cosine * s[4] - sine * s[3] } else { turned(s, *angle)[1] };
            let hoop: f64 = points.iter().map(|p| of(&snapshot.stress[*p])).sum();
            hoops.push(hoop / points.len() as f64 / STRESS);
        }
    }
}

/// x and z of the middle of an element's fibre at ξ along the radius.
fn fibre(mesh: &Mesh, element: u32, xi: f64) -> [f64; 2] {
    let nodes = mesh.elements[element as usize].nodes;
    let mut x = [0.0; 2];
    for (node, side) in [(0, -1.0), (1, 1.0), (4, -1.0), (5, 1.0)] {
        let at = mesh.nodes[nodes[node] as usize];
        let share = 0.25 * (1.0 + side * xi);
        x = [x[0] + share * at[0], x[1] + share * at[2]];
    }
    x
}

impl Seen {
    /// Largest difference until a time \[s\] from σ_θ over the incident stress by place and time, over the largest of these.
    fn error(&self, exact: &[Vec<f64>], until: f64) -> f64 {
        let largest = exact.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
        let mut worst = 0.0_f64;
        for (hoops, exact) in self.hoops.iter().zip(exact) {
            let rows = self.times.iter().zip(hoops.iter().zip(exact)).filter(|(t, _)| **t <= until);
            worst = rows.fold(worst, |most, (_, (found, exact))| most.max((found - exact).abs()));
        }
        worst / largest
    }
}
