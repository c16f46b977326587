//! The free field: how the ground would move without the works. It is the seam between boundaries and what knows that.
//!
//! A boundary pushes the model with σ_ff·n A + C (v̄_ff − v̄) + K (u_ff − u) at each of its nodes, and asks here for the three that
//! bear the index, at the node's place and at the time of the step. One of two answers:
//!
//! - **Ground beside the model**, which the scheme advances with it: [slabs](crate::model::Outside::slabs) outside the sides, and
//!   [columns](crate::column). Displacement is that of the columns' bottoms, velocity that of the nodes that
//!   [lead](Leader::Node), traction what the slabs' elements [pass on](crate::parts::passed_on). At the base one wave rises, of which
//!   no more need be known than σ_ff·n + C v_ff = 2 C v_i: its dashpots act on v alone.
//! - **A field given in advance** ([`GivenField`]), a formula of place and time, such as waves at an angle. All three are its own,
//!   at the base, at free-field sides and at a viscous top. No slabs or columns are made.

use crate::boundary::matrix::times;
use std::sync::Arc;
use tremolite_kernels::Line;
use tremolite_laws::Row;
use tremolite_motion::Motion;

/// A free field that is known in advance, at every place of the boundaries and at all times. It does not move at time 0.
pub trait GivenField: Send + Sync {
    /// u_ff \[m\].
    fn displacement(&self, at: [f64; 3], time: f64) -> [f64; 3];

    /// σ_ff \[Pa\] beyond what is there at rest: xx, yy, zz, xy, yz, zx, tension positive.
    fn stress(&self, at: [f64; 3], time: f64) -> [f64; 6];

    /// v̄_ff \[m/s\] at the middle of two steps of `dt` \[s\]: the mean of what the scheme takes for velocities in them. With one of
    /// half a step before the model would err with order 1.
    fn velocity(&self, at: [f64; 3], time: f64, dt: f64) -> [f64; 3] {
        let [before, after] = [time - dt, time + dt].map(|time| self.displacement(at, time));
        [0, 1, 2].map(|i| (after[i] - before[i]) / (2.0 * dt))
    }

    /// Says at which places boundaries of a model will ask, in every step. It may keep at hand what is needed there; elsewhere its answers
    /// are as good.
    fn prepare(&self, places: &[&Place]) {
        let _ = places;
    }

    /// A place with what the field knows of it, once it is [prepared](GivenField::prepare).
    fn spot(&self, at: [f64; 3]) -> Spot {
        Spot::anywhere(at)
    }

    /// What it pushes some places with, of those that it is prepared for, if it has a quicker way to that than stresses at all their points.
    fn pushes(&self, places: &[&Place]) -> Option<Box<dyn Pushes>> {
        let _ = places;
        None
    }

    /// u_ff \[m\] at spots, as many as there is room for.
    fn displacements(&self, spots: &[Spot], time: f64, out: &mut [[f64; 3]]) {
        out.iter_mut().zip(spots).for_each(|(u, spot)| *u = self.displacement(spot.at, time));
    }

    /// v̄_ff \[m/s\] there.
    fn velocities(&self, spots: &[Spot], time: f64, dt: f64, out: &mut [[f64; 3]]) {
        out.iter_mut().zip(spots).for_each(|(v, spot)| *v = self.velocity(spot.at, time, dt));
    }

    /// The largest velocity that any place has at any time, or a bound on it \[m/s\]: the guard goes by it before energy comes in.
    fn peak_velocity(&self) -> f64;
}

/// What a given field pushes some places with.
pub trait Pushes: Send + Sync {
    /// ∫ N σ_ff·n dA \[N\] of each place at a time \[s\], with what it takes beside at its [ends](Place::ends).
    fn forces(&self, time: f64, out: &mut [[f64; 3]]);

    /// What it takes of memory, beside what the field has.
    fn bytes(&self) -> usize;
}

/// A place at which a boundary asks for motion in every step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// m
    pub at: [f64; 3],
    /// The number of its height among those that a field has prepared; [`Spot::UNKNOWN`] where it has none.
    pub height: u32,
}

impl Spot {
    pub const UNKNOWN: u32 = u32::MAX;

    /// Of which nothing is known beforehand.
    pub fn anywhere(at: [f64; 3]) -> Self {
        Spot { at, height: Spot::UNKNOWN }
    }
}

/// An incident wave, travelling up through the base.
#[derive(Clone)]
pub struct Incident {
    /// Motion in the model's axes.
    pub motion: Motion,
    /// Factor from that motion to the incident wave: ½ for an outcrop's.
    pub factor: f64,
}

/// What knows the free field of a model.
#[derive(Clone)]
pub enum FreeField {
    /// Ground beside it, in which a wave may rise: its motion, and the factor from that to the up-going wave.
    Beside(Option<(Arc<Motion>, f64)>),
    Given(Arc<dyn GivenField>),
}

/// What velocity a dashpot of a boundary follows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Leader {
    /// That of the given field, at the place of an engine node.
    Given(u32),
    /// That of an engine node, which the scheme advances before.
    Node(u32),
}

/// Where a node of a boundary asks.
#[derive(Clone, Debug, Default)]
pub struct Place {
    /// m
    pub at: [f64; 3],
    /// Points of the node's faces, each with its share N n dA, outwards \[m²\]. Tractions at nodes alone would err by h² at edges of
    /// the model, where a share lies on one side of its node.
    pub shares: Vec<([f64; 3], [f64; 3])>,
    /// What it takes beside that at edges of the model.
    pub ends: Vec<End>,
    /// Bottoms of columns with their weights in the mean that is u_ff; none where no springs act.
    pub bottoms: Vec<(u32, f64)>,
}

/// What a node at an edge of the model, where a plane's faces end, takes of a point of one of them beside its share.
///
/// On a face across x the stress of an [element](tremolite_laws::shapes::hex8) varies so: τ_xy along z alone, τ_xz along y alone, and
/// σ_xx along y as in plane stress across y, by σ_xx − ν/(1 − ν) σ_yy, along z likewise. What of the field's traction
/// varies otherwise no element takes up. Where two faces meet in a plane that cancels; where one ends it would leave a force of
/// ∂σ h²/12 a length, an error of h² ln 1/h. A node there has what τ_xy and (ν/(1 − ν)) σ_yy are in the mean along y instead,
/// where faces end along y, and so along z.
#[derive(Clone, Debug)]
pub struct End {
    /// m, a point of its shares.
    pub at: [f64; 3],
    /// Out of the face.
    pub normal: [f64; 3],
    /// Along its sides, of unit length.
    pub along: [[f64; 3]; 2],
    /// ν/(1 − ν), and in [water](crate::water) that cannot leave its pores, whose pressure is one for all of an element, a share of tr σ.
    pub lacking: [f64; 2],
    /// N dA in the mean with the point across along the first axis, less that of the point; and along the second \[m²\].
    pub beside: [f64; 2],
}

impl End {
    /// From the stress at the point \[N\].
    pub fn force(&self, stress: &[f64; 6]) -> [f64; 3] {
        let End { normal, along, lacking, beside, .. } = self;
        let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        let trace = lacking[1] * (stress[0] + stress[1] + stress[2]);
        let traction = times(stress, *normal);
        // In the plane of the face it is Σ t_k along_k.
        let cosine = dot(&along[0], &along[1]);
        let [first, second] = along.map(|axis| dot(&axis, &traction));
        let shear = [first - cosine * second, second - cosine * first].map(|t| t / (1.0 - cosine * cosine));
        let mut force = [0.0; 3];
        for ((axis, shear), area) in along.iter().zip(shear).zip(beside) {
            let out = lacking[0] * dot(axis, &times(stress, *axis)) + trace;
            (0..3).for_each(|i| force[i] += area * (shear * axis[i] + out * normal[i]));
        }
        force
    }
}

impl Leader {
    /// The engine node that it is or whose place it has.
    pub fn node(self) -> u32 {
        match self {
            Leader::Given(node) | Leader::Node(node) => node,
        }
    }
}

impl FreeField {
    /// That of a model.
    pub fn of(given: Option<&Arc<dyn GivenField>>, incident: Option<&Incident>) -> Self {
        match given {
            Some(field) => FreeField::Given(field.clone()),
            None => FreeField::Beside(incident.map(|i| (Arc::new(i.motion.clone()), i.factor))),
        }
    }

    /// At an instant \[s\].
    pub fn now(&self, time: f64) -> Now<'_> {
        match self {
            FreeField::Beside(None) => Now::Rising([0.0; 3]),
            FreeField::Beside(Some((wave, factor))) => Now::Rising(wave.at(time).v.map(|v| v * factor)),
            FreeField::Given(field) => Now::Given(field.as_ref(), time),
        }
    }

    /// The square of the largest velocity with which a wave may come \[m²/s²\]; nothing where none does.
    pub fn peak_square(&self) -> f64 {
        let largest = |v: &Vec<f64>| v.iter().fold(0.0_f64, |most, v| most.max(v.abs()));
        match self {
            FreeField::Beside(None) => 0.0,
            FreeField::Beside(Some((wave, factor))) => {
                wave.velocity.iter().map(|v| (factor * largest(v)).powi(2)).sum()
            }
            FreeField::Given(field) => field.peak_velocity().powi(2),
        }
    }

    /// The line of the balance that has the work of its traction.
    pub fn line(&self) -> Line {
        match self {
            FreeField::Beside(_) => Line::Input,
            FreeField::Given(_) => Line::FreeField,
        }
    }
}

/// The free field at an instant.
pub enum Now<'a> {
    /// v_i of the wave that rises \[m/s\].
    Rising([f64; 3]),
    /// At a time \[s\].
    Given(&'a dyn GivenField, f64),
}

impl Now<'_> {
    /// u_ff \[m\] of a given field at some spots; rest of a wave that rises, which knows of its columns alone.
    pub fn displacements(&self, spots: &[Spot]) -> Vec<[f64; 3]> {
        let mut out = vec![[0.0; 3]; spots.len()];
        if let Now::Given(field, time) = self {
            field.displacements(spots, *time, &mut out);
        }
        out
    }

    /// u − u_ff \[m\] at a place above [bottoms](Place::bottoms) that has moved by `u`; `given` is u_ff of a given field there, `all` are
    /// the displacements of the engine's nodes.
    pub fn scattered(
        &self,
        bottoms: &[(u32, f64)],
        mut u: [f64; 3],
        given: [f64; 3],
        all: &[Row],
    ) -> [f64; 3] {
        match self {
            Now::Given(..) => (0..3).for_each(|i| u[i] -= given[i]),
            Now::Rising(_) => {
                for &(node, weight) in bottoms {
                    let bottom = all[node as usize].xyz();
                    (0..3).for_each(|i| u[i] -= weight * bottom[i]);
                }
            }
        }
        u
    }
}
