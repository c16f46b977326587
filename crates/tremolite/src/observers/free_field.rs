//! The free field: the reference column against one-dimensional theory, and the model's own corners against the column. Is the
//! motion that comes out the one that was put in?

mod theory;

use super::{Observer, Schedule, Setting, Stepped, View};
use crate::error::RunError;
use crate::quantities::MEASURES;
use theory::{Layer, surface_velocity};
use tremolite_engine::column::Column;
use tremolite_engine::model::Model;
use tremolite_engine::state::Memory;
use tremolite_laws::parameter::position;

/// Key of what this observer remembers: the numbers of [`FreeFieldSeen`].
const MEMORY: &str = "free field";

/// What was seen of the free field \[m/s\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FreeFieldSeen {
    /// At the column's top, where there is theory for it.
    pub theory: Option<Theory>,
    /// Whether the column has yielded or cracked.
    pub damaged: bool,
    /// Largest difference of the model's corners from the column in any step, at the surface and at the base.
    pub corners: [f64; 2],
    /// Largest velocity of the column, at its top or bottom.
    pub peak: f64,
}

/// The column's top against theory \[m/s\].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Theory {
    pub difference: f64,
    /// Largest predicted velocity in the rows, and over the run.
    pub seen: f64,
    pub peak: f64,
}

impl FreeFieldSeen {
    /// What the state remembers.
    pub fn of(memory: &Memory) -> Option<Self> {
        let &[known, difference, seen, most, damaged, surface, base, peak] = memory.get(MEMORY)?.as_slice()
        else {
            return None;
        };
        let theory = (known > 0.0).then_some(Theory { difference, seen, peak: most });
        Some(FreeFieldSeen { theory, damaged: damaged > 0.0, corners: [surface, base], peak })
    }

    fn keep(&self, memory: &mut Memory) {
        let Theory { difference, seen, peak } = self.theory.unwrap_or_default();
        let known = f64::from(u8::from(self.theory.is_some()));
        let damaged = f64::from(u8::from(self.damaged));
        let [surface, base] = self.corners;
        memory.insert(MEMORY.into(), vec![known, difference, seen, peak, damaged, surface, base, self.peak]);
    }
}

/// Compares velocities at the rows of the histories.
pub struct FreeField {
    schedule: Schedule,
    /// Engine nodes at the column's top and bottom.
    column: [usize; 2],
    /// Engine nodes of the model at its four corners, at the surface and at the base.
    corners: [[usize; 4]; 2],
    /// Of a homogeneous column.
    predicted: Option<Predicted>,
}

/// Theory for the column's top, exact for a homogeneous damped column on its dashpots.
struct Predicted {
    /// Velocity \[m/s\] along x, y, z, every `dt` \[s\].
    velocity: [Vec<f64>; 3],
    dt: f64,
    /// Its largest value over the run \[m/s\].
    peak: f64,
}

/// Samples of the prediction between two of the motion: between them it is linear.
const REFINEMENT: f64 = 8.0;

impl FreeField {
    /// The observer, if the model has a column and an incident wave.
    pub fn new(setting: &Setting) -> Option<Self> {
        let model = setting.model;
        let (column, _) = (model.columns.first()?, model.incident.as_ref()?);
        let engine = |n: u32| model.engine_node[n as usize] as usize;
        let height = |node: u32| model.mesh.nodes[node as usize][2];
        let corners = [column.top, column.bottom].map(|n| corners(model, height(n)));
        Some(FreeField {
            schedule: setting.rows(),
            column: [column.top, column.bottom].map(engine),
            corners,
            predicted: predicted(setting, column),
        })
    }
}

/// Engine nodes of the user's model nearest the four vertical edges at a height.
fn corners(model: &Model, z: f64) -> [usize; 4] {
    let (low, high) = model.faces.bounds;
    [0, 1, 2, 3].map(|k| {
        let at = [if k & 1 == 0 { low[0] } else { high[0] }, if k & 2 == 0 { low[1] } else { high[1] }, z];
        let distance = |n: usize| {
            let x = model.mesh.nodes[model.mesh_node[n] as usize];
            (0..3).map(|i| (x[i] - at[i]).powi(2)).sum::<f64>()
        };
        model.counted.clone().min_by(|a, b| distance(*a).total_cmp(&distance(*b))).unwrap_or(0)
    })
}

fn predicted(setting: &Setting, column: &Column) -> Option<Predicted> {
    let Setting { model, plan, .. } = *setting;
    let ([body], Some(incident)) = (&model.bodies[column.bodies.clone()], &model.incident) else {
        return None;
    };
    let height = |node: u32| model.mesh.nodes[node as usize][2];
    let (p, s) = body.material.moduli().wave_speeds(body.density);
    let dt = incident.motion.dt / REFINEMENT;
    let tall = height(column.top) - height(column.bottom);
    let velocity = [0, 1, 2].map(|i| {
        let layer = Layer {
            height: tall,
            speed: if i == 2 { p } else { s },
            band: body.material.band(),
            rayleigh: model.rayleigh,
        };
        surface_velocity(&layer, |t| incident.factor * incident.motion.at(t).v[i], dt, plan.duration)
    });
    let peak = velocity.iter().flatten().fold(0.0_f64, |most, v| most.max(v.abs()));
    (peak > 0.0).then_some(Predicted { velocity, dt, peak })
}

/// Whether the material of the reference column has yielded or cracked anywhere.
fn is_damaged(view: &View) -> bool {
    let View { model, assembly, history, .. } = *view;
    (model.user_patches..model.patches.len()).any(|p| {
        let columns = assembly.members[p].part.columns();
        let own = &history.octets[assembly.slices[p].history.clone()];
        MEASURES.iter().any(|measure| {
            position(columns, measure.role).is_some_and(|at| {
                own.iter()
                    .skip(at)
                    .step_by(columns.len())
                    .any(|octet| octet.0.iter().any(|x| *x > measure.onset))
            })
        })
    })
}

/// The larger of two, and what is no number if either is.
fn most(a: f64, b: f64) -> f64 {
    if a.is_nan() || b.is_nan() { f64::NAN } else { a.max(b) }
}

impl Observer for FreeField {
    fn schedule(&self) -> Schedule {
        self.schedule
    }

    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let mut seen = FreeFieldSeen::of(memory).unwrap_or_default();
        let velocity = |node: usize| view.snapshot.velocity[node].xyz();
        if let Some(predicted) = &self.predicted {
            let mut theory = seen.theory.unwrap_or(Theory { peak: predicted.peak, ..Theory::default() });
            let place = view.snapshot.time / predicted.dt;
            let (before, part) = (place as usize, place.fract());
            for (found, predicted) in velocity(self.column[0]).iter().zip(&predicted.velocity) {
                let at = |i: usize| predicted.get(i).copied().unwrap_or(0.0);
                let exact = (1.0 - part) * at(before) + part * at(before + 1);
                theory.difference = most(theory.difference, (found - exact).abs());
                theory.seen = theory.seen.max(exact.abs());
            }
            seen.theory = Some(theory);
        }
        seen.damaged |= is_damaged(view);
        seen.keep(memory);
        Ok(())
    }

    /// The corners in every step: rows may be too few to show the wave.
    fn stepped(&mut self, step: &Stepped, memory: &mut Memory) {
        let Some([.., surface, base, peak]) = memory.get_mut(MEMORY).map(Vec::as_mut_slice) else { return };
        let velocity = |node: usize| step.du[node].xyz().map(|d| d / step.dt);
        for ((&column, corners), difference) in self.column.iter().zip(&self.corners).zip([surface, base]) {
            let free = velocity(column);
            for i in 0..3 {
                *peak = peak.max(free[i].abs());
                for &corner in corners {
                    *difference = most(*difference, (velocity(corner)[i] - free[i]).abs());
                }
            }
        }
    }
}
