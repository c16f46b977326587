//! Models that come to rest through stages, and rings about an axis for openings.

use crate::VerifyError;
use crate::models::Solid;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::sync::Arc;
use tremolite::engine::Release;
use tremolite::hexahedra::centroid;
use tremolite::point_stress::mean;
use tremolite::stages::{PlannedStage, settle};
use tremolite::{
    Assembly, Body, Engine, Life, Model, Phase, Problem, Quadrature, Snapshot, Stage, State, stable_step,
};
use tremolite_mesh::{Element, Face, Mesh, Shape};

/// From the initial equilibrium on, until the first stage of change.
pub const UNTIL_CHANGE: Life = Life { born: Stage::Before(0), gone: Some(Stage::Before(1)) };
/// From that on.
pub const SINCE_CHANGE: Life = Life { born: Stage::Before(1), gone: None };

/// A share of what is held, let go until far less is out of balance than any mesh errs.
pub fn release(share: f64) -> Release {
    Release { share, tolerance: [1e-9, 1e-7], most: 200_000, ..Release::default() }
}

/// Steps of a shaking that nothing drives.
pub const QUIET_STEPS: u32 = 100;

/// A model in equilibrium that was then stepped on without anything to drive it.
pub struct Quiet {
    pub model: Arc<Model>,
    pub assembly: Arc<Assembly>,
    pub state: State,
    /// Largest component of motion \[m\] on the way to equilibrium, and in [`QUIET_STEPS`] steps after it.
    pub moved: [f64; 2],
}

impl Quiet {
    /// # Errors
    /// If it is no model, or does not come to rest.
    pub fn new(problem: Problem) -> Result<Self, VerifyError> {
        let model = Model::new(problem)?;
        let assembly = Assembly::new(&model)?;
        let stage = PlannedStage { release: release(1.0), ..PlannedStage::new("equilibrium") };
        let (mut state, _) = settle(&model, &assembly, &[stage])
            .map_err(|unsettled| VerifyError::Setup(format!("{unsettled:?}")))?;
        let most = |state: &State, shown: bool| {
            let nodes = 0..state.u.len();
            let all = nodes.flat_map(|n| if shown { state.shown(n).xyz() } else { state.u[n].xyz() });
            all.fold(0.0, |most: f64, x| most.max(x.abs()))
        };
        let before = most(&state, false);
        let phase = Phase::of(&model, &assembly, Stage::Shaking)?;
        let dt = stable_step(&model, &assembly, &phase).to_run(0.9);
        let mut engine = Engine::new(&model, &assembly, &phase);
        engine.hand_over(&mut state, dt);
        let mut after = 0.0_f64;
        for _ in 0..QUIET_STEPS {
            engine.step(&mut state);
            after = after.max(most(&state, true));
        }
        engine.finish(&mut state);
        Ok(Quiet { model, assembly, state, moved: [before, after] })
    }
}

/// A model at rest after its last stage.
pub struct Rested {
    pub model: Arc<Model>,
    pub assembly: Arc<Assembly>,
    pub phase: Arc<Phase>,
    pub state: State,
    /// What is seen there.
    pub snapshot: Snapshot,
}

impl Rested {
    /// Brings a problem to rest: the initial equilibrium first, then a stage for each of the other releases.
    ///
    /// # Errors
    /// If it is no model, or does not come to rest.
    pub fn new(problem: Problem, releases: &[Release]) -> Result<Self, VerifyError> {
        let model = Model::new(problem)?;
        let assembly = Assembly::new(&model)?;
        let stages: Vec<PlannedStage> =
            releases.iter().map(|&release| PlannedStage { release, ..PlannedStage::new("stage") }).collect();
        let (mut state, _) = settle(&model, &assembly, &stages)
            .map_err(|unsettled| VerifyError::Setup(format!("{unsettled:?}")))?;
        let phase = Phase::of(&model, &assembly, Stage::Before(releases.len() as u16 - 1))?;
        let snapshot = Engine::new(&model, &assembly, &phase).finish(&mut state);
        Ok(Rested { model, assembly, phase, state, snapshot })
    }

    /// Displacement \[m\] of a node of the mesh since the initial equilibrium.
    pub fn shown(&self, node: u32) -> [f64; 3] {
        self.state.shown(self.model.engine_node[node as usize] as usize).xyz()
    }

    /// Stresses \[Pa\] of an element's points; none where it is not there.
    pub fn points(&self, element: u32) -> &[[f64; 6]] {
        let slot = self.phase.element_slot[element as usize];
        slot.map_or(&[], |slot| &self.snapshot.stress[slot.point as usize..][..slot.points as usize])
    }

    /// Mean stress \[Pa\] of an element, radial, hoop and shear about the axis of y.
    pub fn polar(&self, element: u32) -> [f64; 3] {
        let x = centroid(&self.model.mesh, element);
        let slot = self.phase.element_slot[element as usize];
        let stress = slot.map_or([f64::NAN; 6], |slot| mean(&slot.places, self.points(element)));
        turned(&stress, x[2].atan2(x[0]))
    }
}

/// σ_r, σ_θ and τ_rθ at an angle from x to z.
pub fn turned(s: &[f64; 6], angle: f64) -> [f64; 3] {
    let (d, c) = angle.sin_cos();
    let (xx, zz, zx) = (s[0], s[2], s[5]);
    [
        xx * c * c + zz * d * d + 2.0 * zx * c * d,
        xx * d * d + zz * c * c - 2.0 * zx * c * d,
        (zz - xx) * c * d + zx * (c * c - d * d),
    ]
}

/// Radii in geometric progression, each element about as long as wide, the first left out.
pub fn growing(from: f64, to: f64, angle: f64) -> Vec<f64> {
    let rows = ((to / from).ln() / angle).round().max(1.0);
    (1..=rows as u32).map(|i| from * (to / from).powf(f64::from(i) / rows)).collect()
}

/// Rings about the axis of y in the plane of x and z, one element thick; a quarter from x to z, or all round.
///
/// Before the shaking a model stands on its lowest plane and between its outermost vertical ones. A round outer edge has
/// none, so a brick stands apart, below and beyond the rings, and takes these supports with nothing to carry; the rings
/// have the two planes across y.
pub struct Rings {
    pub mesh: Mesh,
    radii: Vec<f64>,
    around: u32,
    whole: bool,
}

impl Rings {
    /// Rings between rising radii \[m\], of wedges where the first is 0, with `around` equal elements in a ring.
    pub fn new(radii: Vec<f64>, around: u32, whole: bool) -> Self {
        let thick = 1.5 * radii[radii.len() - 1] / f64::from(around);
        let mut rings = Rings { mesh: Mesh::default(), radii, around, whole };
        let rows = rings.radii.len() as u32;
        for line in 0..rings.lines() {
            let (sine, cosine) = rings.angle(f64::from(line)).sin_cos();
            // What lies on an axis of symmetry lies there exactly.
            let clean = |x: f64| if x.abs() < 1e-12 { 0.0 } else { x };
            for y in [0.0, thick] {
                rings.mesh.nodes.extend(rings.radii.iter().map(|r| [clean(r * cosine), y, clean(r * sine)]));
            }
        }
        for ring in 0..rows - 1 {
            for sector in 0..around {
                let n = |i: u32, side: u32, line: u32| rings.node(ring + i, sector + line, side);
                let element = if rings.radii[ring as usize] == 0.0 {
                    let triangle = |y| [n(0, y, 0), n(1, y, 0), n(1, y, 1)];
                    Element::new(Shape::Wedge6, &[triangle(1), triangle(0)].concat())
                } else {
                    let face = |line| [n(0, 0, line), n(1, 0, line), n(1, 1, line), n(0, 1, line)];
                    Element::new(Shape::Hex8, &[face(0), face(1)].concat())
                };
                rings.mesh.elements.push(element);
            }
        }
        let (far, first) = (rings.outer_radius(), rings.mesh.nodes.len() as u32);
        let [left, low, high] = [-far - 1.0, -far - 3.0, -far - 2.0];
        for z in [low, high] {
            rings.mesh.nodes.extend([
                [left, 0.0, z],
                [far + 1.0, 0.0, z],
                [far + 1.0, thick, z],
                [left, thick, z],
            ]);
        }
        let brick: Vec<u32> = (first..first + 8).collect();
        rings.mesh.elements.push(Element::new(Shape::Hex8, &brick));
        rings
    }

    fn lines(&self) -> u32 {
        if self.whole { self.around } else { self.around + 1 }
    }

    /// The angle \[rad\] of a line between sectors, counted from x.
    pub fn angle(&self, line: f64) -> f64 {
        (if self.whole { TAU } else { FRAC_PI_2 }) * line / f64::from(self.around)
    }

    fn outer_radius(&self) -> f64 {
        self.radii[self.radii.len() - 1]
    }

    /// A node by its radius, its line and its side across y.
    pub fn node(&self, radius: u32, line: u32, side: u32) -> u32 {
        let line = if self.radii[radius as usize] == 0.0 { 0 } else { line % self.lines() };
        radius + self.radii.len() as u32 * (side + 2 * line)
    }

    /// The number of the radius that is nearest to a length \[m\].
    pub fn nearest(&self, radius: f64) -> u32 {
        let far = |i: &u32| (self.radii[*i as usize] - radius).abs();
        (0..self.radii.len() as u32).min_by(|a, b| far(a).total_cmp(&far(b))).unwrap_or(0)
    }

    /// The elements between two radii \[m\], by ring from within and then around.
    pub fn between(&self, inner: f64, outer: f64) -> Vec<u32> {
        (self.nearest(inner) * self.around..self.nearest(outer) * self.around).collect()
    }

    /// The brick that takes the supports.
    pub fn brick(&self) -> Body {
        let solid = Solid { young: 1e9, poisson: 0.25, density: 2500.0 };
        solid.body("apart", vec![(self.radii.len() as u32 - 1) * self.around], Quadrature::OnePoint)
    }

    /// The outer edge, each face with a stress \[Pa\] by its angle.
    pub fn edge(&self, stress: impl Fn(f64) -> [f64; 6]) -> Vec<(Face, [f64; 6])> {
        let last = self.radii.len() as u32 - 2;
        let face = |sector: u32| Face { element: last * self.around + sector, side: 1 };
        (0..self.around).map(|k| (face(k), stress(self.angle(f64::from(k) + 0.5)))).collect()
    }

    /// The planes of symmetry of a quarter: x = 0 and z = 0.
    pub fn symmetry(&self) -> Vec<(u32, [bool; 3])> {
        let own = self.mesh.nodes.len() as u32 - 8;
        (0..own)
            .map(|n| (n, self.mesh.nodes[n as usize]))
            .filter(|(_, x)| x[0] == 0.0 || x[2] == 0.0)
            .map(|(n, x)| (n, [x[0] == 0.0, false, x[2] == 0.0]))
            .collect()
    }

    /// Of elements in rings between two radii \[m\], as [`Rings::between`] lists them: thrust \[N/m\] on the mean and in cos 2θ,
    /// compression positive, and moment \[N\] in cos 2θ, tension outside positive; sums over the points of each sector.
    pub fn section(&self, rested: &Rested, elements: &[u32], [inner, outer]: [f64; 2]) -> [f64; 3] {
        let layers = elements.len() as u32 / self.around;
        let layer = (outer - inner) / f64::from(layers);
        let mut found = [0.0; 3];
        for sector in 0..self.around {
            let angle = self.angle(f64::from(sector) + 0.5);
            let (mut thrust, mut moment) = (0.0, 0.0);
            for ring in 0..layers {
                let centre = layer * (f64::from(ring) + 0.5) - 0.5 * (outer - inner);
                let element = elements[(ring * self.around + sector) as usize];
                let Some(slot) = rested.phase.element_slot[element as usize] else { continue };
                let points = rested.points(element).iter().zip(slot.places.quadrature.shares());
                for (p, (stress, share)) in points.enumerate() {
                    let hoop = turned(stress, angle)[1];
                    let area = layer * share;
                    thrust -= area * hoop;
                    // ξ is along the radius.
                    moment += area * hoop * (centre + 0.5 * layer * slot.places.natural(p)[0]);
                }
            }
            let (cosine, weight) = ((2.0 * angle).cos(), 1.0 / f64::from(self.around));
            found[0] += weight * thrust;
            found[1] += 2.0 * weight * cosine * thrust;
            found[2] += 2.0 * weight * cosine * moment;
        }
        found
    }

    /// Mean motion \[m\] towards the axis of the nodes at a radius, weighted for a quarter's ends, and the largest and the
    /// smallest.
    pub fn inwards(&self, rested: &Rested, radius: f64) -> [f64; 3] {
        let at = self.nearest(radius);
        let lines = self.lines();
        let all = (0..lines).map(|line| {
            let u = rested.shown(self.node(at, line, 0));
            let (sine, cosine) = self.angle(f64::from(line)).sin_cos();
            let end = !self.whole && (line == 0 || line == lines - 1);
            (-(u[0] * cosine + u[2] * sine), if end { 0.5 } else { 1.0 })
        });
        let all: Vec<(f64, f64)> = all.collect();
        let mean = all.iter().map(|(u, w)| u * w).sum::<f64>() / f64::from(self.around);
        let of = |pick: fn(f64, f64) -> f64| all.iter().fold(mean, |found, (u, _)| pick(found, *u));
        [mean, of(f64::max), of(f64::min)]
    }
}
