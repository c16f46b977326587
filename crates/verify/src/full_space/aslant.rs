//! Waves at an angle in the plane across the axis: at a cavity in full space, and at a canyon half round in a free surface.
//!
//! The slice is that of the straight wave; its base, its sides across x and, in full space, its top are driven by the field of the wave
//! ([`tremolite::waves`]), and steady sines are found in amplitude and phase as there.

use super::{Looked, Parts, STRESS, Seen, Slice};
use crate::VerifyError;
use crate::scattering::across::Across;
use crate::scattering::{Incoming, Place};
use crate::simulation::{Simulation, whole_steps};
use num_complex::Complex64;
use std::collections::BTreeMap;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;
use tremolite::waves::{Entering, Frame, Heading, LayeredGround, ObliqueField, Rock, Stratum, WaveType};
use tremolite::{Base, Problem, Quadrature, Rayleigh, Side, Top};
use tremolite_mesh::Mesh;
use tremolite_motion::Motion;

/// A wave: its type, and its angle from the vertical \[rad\], towards x.
pub type Way = (WaveType, f64);

/// Steady sines: a ka = ωa/c of the wave's own speed, the multiples of it that come together, and the times in which an S wave travels a
/// radius until all is steady.
#[derive(Clone, Copy, Debug)]
pub struct Sines<'a> {
    pub fundamental: f64,
    pub multiples: &'a [u32],
    pub settle: f64,
}

impl Slice {
    /// Largest errors of the hoop stress, of σ_θy under SH, over its largest amplitude, by multiple.
    ///
    /// # Errors
    /// If it is no model or becomes unstable.
    pub fn sines_aslant(&self, way: Way, sines: Sines) -> Result<Vec<f64>, VerifyError> {
        let Parts { mesh, liner, rock, wall } = self.parts();
        let mut bodies = vec![self.cavity.rock.body("rock", rock, Quadrature::OnePoint)];
        if let Some((solid, _)) = self.cavity.liner {
            bodies.push(solid.body("liner", liner.clone(), Quadrature::Full));
        }
        let mut problem = Problem::new(mesh, bodies);
        problem.top = Top::Viscous;
        let looked = if liner.is_empty() { wall } else { liner };
        let across = way.0 == WaveType::Sh;
        let seen = self.aslant(problem, way, sines, |simulation| self.fibres(simulation, &looked, across))?;
        let (kind, angle) = way;
        // θ from the way of the wave.
        let places: Vec<Place> = seen.places.iter().map(|[r, from_up]| [*r, angle - from_up]).collect();
        let exact = |omega: f64| match kind {
            WaveType::P => self.cavity.scatter(Incoming::P, omega).hoops(&places),
            WaveType::Sv => self.cavity.scatter(Incoming::Sv, omega).hoops(&places),
            WaveType::Sh => Across::new(self.cavity, omega).hoops(&places),
        };
        Ok(self.compared(&seen, way, sines, &exact))
    }

    /// Largest error of the displacement of a canyon's wall and of the surface within three radii under SH, over the largest amplitude, by
    /// multiple. `reach` is the depth of the box and half its width over the radius.
    ///
    /// # Errors
    /// As [`Slice::sines_aslant`].
    pub fn canyon(&self, angle: f64, sines: Sines) -> Result<Vec<f64>, VerifyError> {
        let Parts { mesh, rock, .. } = self.parts();
        let below: Vec<u32> = rock
            .into_iter()
            .filter(|&e| {
                mesh.elements[e as usize].nodes().iter().map(|&n| mesh.nodes[n as usize][2]).sum::<f64>()
                    < 0.0
            })
            .collect();
        let mesh = part(&mesh, &below);
        let all = (0..mesh.elements.len() as u32).collect();
        let mut problem = Problem::new(mesh, vec![self.cavity.rock.body("rock", all, Quadrature::OnePoint)]);
        problem.top = Top::Free;
        let radius = self.cavity.radius;
        let near = 1e-6 * radius;
        let looked = |simulation: &Simulation| {
            let mut looked = Looked::default();
            for n in 0..simulation.model.mesh_node.len() {
                let [x, y, z] = simulation.position(n);
                let r = x.hypot(z);
                if y.abs() < near && r < 3.0 * radius && (z.abs() < near || (r - radius).abs() < near) {
                    looked.places.push([r, z.atan2(x)]);
                    looked.nodes.push(n);
                }
            }
            looked
        };
        let way = (WaveType::Sh, angle);
        let seen = self.aslant(problem, way, sines, looked)?;
        let towards = FRAC_PI_2 - angle;
        // Seen is a displacement over that of a wave of unit stress, whose w at the axis is 1/(iμκ).
        let (_, speed) = self.cavity.rock.speeds();
        let exact = |omega: f64| {
            let unit = Complex64::I * self.cavity.rock.moduli().mu * omega / speed / STRESS;
            Across::new(self.cavity, omega)
                .canyon(&seen.places, towards)
                .into_iter()
                .map(|w| w / unit)
                .collect()
        };
        Ok(self.compared(&seen, way, sines, &exact))
    }

    /// The time \[s\] in which a wave of this type travels a radius.
    fn own_unit(&self, kind: WaveType) -> f64 {
        let (p, s) = self.cavity.rock.speeds();
        self.cavity.radius / if kind == WaveType::P { p } else { s }
    }

    /// Largest error over the largest amplitude, by multiple.
    fn compared(
        &self,
        seen: &Seen,
        (kind, _): Way,
        sines: Sines,
        exact: &dyn Fn(f64) -> Vec<Complex64>,
    ) -> Vec<f64> {
        let unit = self.own_unit(kind);
        let one = |multiple: &u32| {
            let omega = f64::from(*multiple) * sines.fundamental / unit;
            let exact = exact(omega);
            let largest = exact.iter().fold(0.0, |most: f64, x| most.max(x.norm()));
            let errors = seen.hoops.iter().zip(exact).map(|(values, exact)| {
                // i e^(−iωt) is a sine at the axis.
                let share = 2.0 / values.len() as f64;
                let turn = |t: f64| Complex64::from_polar(share, omega * t);
                let found: Complex64 =
                    values.iter().zip(&seen.times).map(|(x, t)| -Complex64::I * turn(*t) * x).sum();
                (found - exact).norm() / largest
            });
            errors.fold(0.0, |most: f64, error| if error > most || error.is_nan() { error } else { most })
        };
        sines.multiples.iter().map(one).collect()
    }

    /// Runs until all is steady and one period more, and looks through that; times are those at the axis.
    fn aslant(
        &self,
        mut problem: Problem,
        (kind, angle): Way,
        sines: Sines,
        looked: impl Fn(&Simulation) -> Looked,
    ) -> Result<Seen, VerifyError> {
        let unit = self.own_unit(kind);
        let (p, s) = self.cavity.rock.speeds();
        let speed = if kind == WaveType::P { p } else { s };
        let period = TAU * unit / sines.fundamental;
        let ramp = 20.0 * unit;
        let rate = |t: f64| -> f64 {
            let x = (t / ramp).min(1.0);
            let (size, slope) = (x - (TAU * x).sin() / TAU, (1.0 - (TAU * x).cos()) / ramp);
            let sine = |k: &u32| {
                let omega = f64::from(*k) * sines.fundamental / unit;
                slope * (omega * t).sin() + size * omega * (omega * t).cos()
            };
            sines.multiples.iter().map(sine).sum()
        };
        let (low, high) = problem.mesh.bounds();
        // The stress along and across the way is −ρc v; that of SV has its axis across against its motion.
        let sign = if kind == WaveType::Sv { 1.0 } else { -1.0 };
        let factor = sign * STRESS / (self.cavity.rock.density * speed);
        let until = period + sines.settle * self.own_unit(WaveType::Sv) + self.reach * unit;
        let sample = 0.01 * unit;
        let samples = (until / sample).ceil() as u32 + 2;
        let carried: Vec<f64> = (0..samples).map(|k| factor * rate(f64::from(k) * sample)).collect();
        let motion = Motion::from_acceleration(
            sample,
            [carried.clone(), vec![0.0; carried.len()], vec![0.0; carried.len()]],
        )?;
        let most = sines.multiples.iter().max().copied().unwrap_or(1);
        let rock = Rock::of(&problem.bodies[0], Rayleigh::default());
        let ground = LayeredGround::new([Stratum { thickness: high[2] - low[2], rock }], problem.top)
            .ok_or_else(|| VerifyError::Setup("no layers".into()))?;
        let frame = Frame {
            ground,
            bounds: [low, high],
            at: [0.0, 0.0],
            frequency: 1.5 * f64::from(most) * sines.fundamental / unit / TAU,
            duration: Some(until),
        };
        let heading = Heading { kind, angle, along: [1.0, 0.0] };
        let wave = Entering::of(heading, Arc::new(motion), 0, Complex64::from(1.0));
        let field = ObliqueField::new(&frame, &[wave]).map_err(|e| VerifyError::Setup(format!("{e:?}")))?;
        let lead = field.lead();
        problem.base = Base::Viscous;
        problem.sides = [Side::FreeField, Side::Periodic];
        problem.free_field = Some(Arc::new(field));
        let simulation = Simulation::new(problem)?;

        let looked = looked(&simulation);
        let rows = 16 * most;
        let (between, dt) = whole_steps(period / f64::from(rows), 0.9 * simulation.stable());
        let steps = ((until + lead) / dt).round() as u64;
        let first = steps - between * u64::from(rows - 1);
        // From the base at the reference place to the axis.
        let late = lead - low[2] * angle.cos() / speed;
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
                seen.times.push(state.time() - late);
                if looked.nodes.is_empty() {
                    looked.hoops(&engine.look(&state).snapshot, &mut seen.hoops);
                }
                for (values, n) in seen.hoops.iter_mut().zip(&looked.nodes) {
                    values.push(state.u[*n].xyz()[1]);
                }
            }
        }
        Ok(seen)
    }
}

/// Some elements of a mesh with their nodes alone.
fn part(mesh: &Mesh, elements: &[u32]) -> Mesh {
    let mut known: BTreeMap<u32, u32> = BTreeMap::new();
    let mut part = Mesh::default();
    for &e in elements {
        let mut element = mesh.elements[e as usize];
        for node in &mut element.nodes {
            *node = *known.entry(*node).or_insert_with(|| {
                part.nodes.push(mesh.nodes[*node as usize]);
                part.nodes.len() as u32 - 1
            });
        }
        part.elements.push(element);
    }
    part
}
