//! A round cavity, bare or lined, in a slice of a space without end: mesh, run under a P wave from below, and hoop stresses
//! beside the exact ones of [`crate::scattering`].
//!
//! The cavity's axis lies along y, where the slice is one element thick and periodic; the wave travels along z. Rings about the
//! axis go over into a square four radii wide, and a grid goes on from there to the box: its base brings the wave in, its sides
//! are those of the free field, its top absorbs. On the wave's way, from the base to the square, all rows are as high as those of
//! the square; sideways and upwards elements grow by a tenth from one to the next. Stresses are compared where the elements have
//! them, with what is exact at that radius and angle.

use crate::VerifyError;
use crate::scattering::{Cavity, Place};
use crate::simulation::{Simulation, whole_steps};
use crate::staged::turned;
use std::collections::BTreeMap;
use num_complex::Complex64;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};
use tremolite::{Base, Incident, Problem, Quadrature, Side, Top};
use tremolite_mesh::{Element, Mesh, Shape};
use tremolite_motion::Motion;

/// Incident stress \[Pa\].
const STRESS: f64 = 1e6;
/// Size of the outermost ring beside the innermost, which is about as long as wide.
const RINGS: f64 = 2.5;
/// Size of an element of the grid beside the one before it, outside of the wave's way.
const GROWTH: f64 = 1.1;

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
    /// Up to this size over the radius elements of the grid grow.
    pub coarsest: f64,
    /// Of the rock; the liner has 2×2×2 points.
    pub quadrature: Quadrature,
    pub base: Base,
}

/// What came of a run: σ_θ over the incident stress, by place and time.
pub struct Seen {
    pub places: Vec<Place>,
    /// \[s\], 0 when the front is at the near wall.
    pub times: Vec<f64>,
    pub hoops: Vec<Vec<f64>>,
}

/// The mesh, with the elements of the liner, those of the rock, and those of the rock's first ring.
struct Parts {
    mesh: Mesh,
    liner: Vec<u32>,
    rock: Vec<u32>,
    wall: Vec<u32>,
}

impl Slice {
    /// c_p \[m/s\] of the rock.
    fn speed(&self) -> f64 {
        self.cavity.rock.speeds().0
    }

    /// The time \[s\] in which the wave travels a radius.
    pub fn unit(&self) -> f64 {
        self.cavity.radius / self.speed()
    }

    /// Width \[m\] of the square's elements.
    fn size(&self) -> f64 {
        4.0 * self.cavity.radius / f64::from(self.elements)
    }

    /// Distances \[m\] of the grid's lines from the axis, from 0 to the box, with elements up to a size \[m\].
    fn lines(&self, coarsest: f64) -> Vec<f64> {
        let mut size = self.size();
        let end = self.reach * self.cavity.radius;
        let mut lines: Vec<f64> = (0..=self.elements / 2).map(|i| f64::from(i) * size).collect();
        let mut last = 2.0 * self.cavity.radius;
        // The last one is cut to between half and one and a half of its size.
        while end - last > 0.5 * size {
            size = (size * GROWTH).min(coarsest.max(self.size()));
            last = if end - last < 1.5 * size { end } else { last + size };
            lines.push(last);
        }
        lines
    }

    fn parts(&self) -> Parts {
        let h = self.size();
        let (n, half) = (self.elements, self.elements as i32 / 2);
        let sideways = self.lines(self.coarsest * self.cavity.radius);
        let downwards = self.lines(h);
        let at = |lines: &[f64], i: i32| lines[i.unsigned_abs() as usize] * f64::from(i.signum());
        let (wide, deep) = (sideways.len() as i32 - 1, downwards.len() as i32 - 1);
        let in_square = |i: i32, k: i32| i.abs() < half && k.abs() < half;
        // Nodes in the plane, each to become one before and one behind.
        let mut plane: Vec<[f64; 2]> = Vec::new();
        let mut lattice: BTreeMap<[i32; 2], u32> = BTreeMap::new();
        for k in -deep..=wide {
            for i in (-wide..=wide).filter(|i| !in_square(*i, k)) {
                lattice.insert([i, k], plane.len() as u32);
                plane.push([at(&sideways, i), at(if k < 0 { &downwards } else { &sideways }, k)]);
            }
        }
        // Radii of the liner, then shares of the way from the wall to the square.
        let radius = self.cavity.radius;
        let inner = self.cavity.liner.map_or(radius, |(_, inner)| inner);
        let layers = self.cavity.liner.map_or(0, |_| self.layers);
        let rows = (f64::from(n) / 2.6).round() as u32;
        let share = |row: u32| (RINGS.powf(f64::from(row) / f64::from(rows)) - 1.0) / (RINGS - 1.0);
        let mut rings: Vec<Vec<u32>> = Vec::new();
        for row in 0..=layers + rows {
            let mut ring = Vec::new();
            for line in 0..4 * n {
                let (side, along) = (line / n, (line % n) as i32 - half);
                // Outwards and along the side, from x to z.
                let [out, turn] = [[[1, 0], [0, 1]], [[0, 1], [-1, 0]], [[-1, 0], [0, -1]], [[0, -1], [1, 0]]][side as usize];
                let place = [0, 1].map(|c| half * out[c] + along * turn[c]);
                if row == layers + rows {
                    ring.push(lattice[&place]);
                    continue;
                }
                let angle = f64::from(side) * FRAC_PI_2 + FRAC_PI_4 * f64::from(along) / f64::from(half);
                let (sine, cosine) = angle.sin_cos();
                let r = if row < layers { inner + (radius - inner) * f64::from(row) / f64::from(layers) } else { radius };
                let s = if row < layers { 0.0 } else { share(row - layers) };
                let mixed = |round: f64, square: i32| r * round * (1.0 - s) + s * h * f64::from(square);
                ring.push(plane.len() as u32);
                plane.push([mixed(cosine, place[0]), mixed(sine, place[1])]);
            }
            rings.push(ring);
        }
        let mut mesh = Mesh::default();
        mesh.nodes = plane.iter().flat_map(|[x, z]| [[*x, 0.0, *z], [*x, h, *z]]).collect();
        let mut add = |[a, b, c, d]: [u32; 4]| {
            // The first natural axis goes from a to b, the second along y, the third from a to c.
            let nodes = [2 * a, 2 * b, 2 * b + 1, 2 * a + 1, 2 * c, 2 * d, 2 * d + 1, 2 * c + 1];
            mesh.elements.push(Element::new(Shape::Hex8, &nodes));
            mesh.elements.len() as u32 - 1
        };
        let (mut liner, mut rock, mut wall) = (Vec::new(), Vec::new(), Vec::new());
        for (row, pair) in (0..).zip(rings.windows(2)) {
            for line in 0..4 * n as usize {
                let next = (line + 1) % (4 * n as usize);
                let element = add([pair[0][line], pair[1][line], pair[0][next], pair[1][next]]);
                if row < layers { &mut liner } else { &mut rock }.push(element);
                if row == layers {
                    wall.push(element);
                }
            }
        }
        let square = -half..half;
        for k in -deep..wide {
            for i in (-wide..wide).filter(|i| !(square.contains(i) && square.contains(&k))) {
                rock.push(add([[i, k], [i + 1, k], [i, k + 1], [i + 1, k + 1]].map(|place| lattice[&place])));
            }
        }
        Parts { mesh, liner, rock, wall }
    }

    /// The largest error of σ_θ over its peak under a step of stress with a rise, until `end`, both in times of a radius, over
    /// all points and times.
    ///
    /// # Errors
    /// As [`Slice::run`].
    pub fn step(&self, rise: f64, end: f64) -> Result<f64, VerifyError> {
        let unit = self.unit();
        let (rise, end) = (rise * unit, end * unit);
        let rate = |t: f64| if (0.0..rise).contains(&t) { (1.0 - (TAU * t / rise).cos()) / rise } else { 0.0 };
        let seen = self.run(rate, [end, end], 100)?;
        // Answers are over in 50 times of a radius but for 1e-4 (tests of the exact solution).
        Ok(seen.error(&self.cavity.step(rise, 200.0 * unit, &seen.places, &seen.times)))
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
            let exact = self.cavity.scatter(omega).hoops(&seen.places);
            let largest = exact.iter().fold(0.0, |most: f64, x| most.max(x.norm()));
            let error = seen.hoops.iter().zip(exact).map(|(hoops, exact)| {
                // i e^(−iωt) is a sine at the axis, a radius behind the wall.
                let turn = |t: f64| Complex64::from_polar(2.0 / f64::from(rows), omega * (t - unit));
                let found: Complex64 = hoops.iter().zip(&seen.times).map(|(hoop, t)| -Complex64::I * turn(*t) * hoop).sum();
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
    pub fn run(&self, rate: impl Fn(f64) -> f64, [span, end]: [f64; 2], rows: u32) -> Result<Seen, VerifyError> {
        let Parts { mesh, liner, rock, wall } = self.parts();
        let mut bodies = vec![self.cavity.rock.body("rock", rock, self.quadrature)];
        if let Some((solid, _)) = self.cavity.liner {
            bodies.push(solid.body("liner", liner.clone(), Quadrature::Full));
        }
        let mut problem = Problem::new(mesh, bodies);
        problem.base = self.base;
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

        let looked: Vec<u32> = if liner.is_empty() { wall } else { liner };
        let (mut places, mut points) = (Vec::new(), Vec::new());
        for element in looked {
            let Some(slot) = simulation.phase.element_slot[element as usize] else { continue };
            for p in 0..u32::from(slot.points) {
                let x = self.point(&simulation.model.mesh, element, slot.points, p);
                let angle = x[1].atan2(x[0]);
                places.push([x[0].hypot(x[1]), FRAC_PI_2 - angle]);
                points.push(((slot.point + p) as usize, angle));
            }
        }
        let (between, dt) = whole_steps(span / f64::from(rows), 0.9 * simulation.stable());
        // So many steps before the first look that the last one is at the end.
        let steps = (until / dt).round() as u64;
        let first = steps - between * u64::from(rows - 1);
        let mut engine = simulation.engine();
        let mut state = simulation.start(&mut engine, dt, |_| [[0.0; 3]; 2]);
        let mut seen = Seen { hoops: vec![Vec::new(); places.len()], places, times: Vec::new() };
        for step in 1..=steps {
            engine.step(&mut state)?;
            if step >= first && (step - first) % between == 0 {
                let snapshot = engine.observe(&mut state);
                seen.times.push(state.time() - delay);
                for (hoops, (point, angle)) in seen.hoops.iter_mut().zip(&points) {
                    hoops.push(turned(&snapshot.stress[*point], *angle)[1] / STRESS);
                }
            }
        }
        Ok(seen)
    }

    /// x and z of a point of an element: its centre, or one of the 2×2×2, whose number has the side along the first natural axis
    /// in bit 0 and along the third in bit 2.
    fn point(&self, mesh: &Mesh, element: u32, points: u8, p: u32) -> [f64; 2] {
        let g = if points == 1 { 0.0 } else { 1.0 / 3f64.sqrt() };
        let side = |bit: u32| if p >> bit & 1 == 1 { g } else { -g };
        let shares = |bit: u32| [0.5 * (1.0 - side(bit)), 0.5 * (1.0 + side(bit))];
        let (first, third) = (shares(0), shares(2));
        let nodes = mesh.elements[element as usize].nodes;
        let mut x = [0.0; 2];
        for (node, share) in [(0, first[0] * third[0]), (1, first[1] * third[0]), (4, first[0] * third[1]), (5, first[1] * third[1])] {
            let at = mesh.nodes[nodes[node] as usize];
            x[0] += share * at[0];
            x[1] += share * at[2];
        }
        x
    }
}

impl Seen {
    /// Largest difference from σ_θ over the incident stress by place and time, over the largest of these.
    pub fn error(&self, exact: &[Vec<f64>]) -> f64 {
        let largest = exact.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
        for k in [0, self.places.len()/8, self.places.len()/4, self.places.len()/2, 5*self.places.len()/8, 3*self.places.len()/4] {
            let worst = self.hoops[k].iter().zip(&exact[k]).zip(&self.times).map(|((a, b), t)| ((a - b), t, a)).max_by(|a, b| a.0.abs().total_cmp(&b.0.abs())).unwrap();
            println!("  {:?} {:?}", self.places[k], worst);
        }
        let pairs = self.hoops.iter().flatten().zip(exact.iter().flatten());
        pairs.fold(0.0, |most: f64, (found, exact)| most.max((found - exact).abs())) / largest
    }
}

