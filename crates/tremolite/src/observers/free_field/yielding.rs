//! Theory beside ground that yields: the equivalent-linear column of the ground's own laws.
//!
//! Elastic theory ends where ground yields. What engineers then set beside a nonlinear run is the linear column whose layers have the modulus
//! and the damping of the strain that they come to ([`crate::equivalent_linear`]). Here these follow from the laws of the model themselves,
//! each driven under the stress of its depth ([`of_law`]), so that what differs is the method, not the soil. It is another approximation and no
//! measure of the run: it damps away what is high in frequency, keeps one modulus for weak and strong shaking, and knows of no lasting
//! displacement. So nothing is judged by it.
//!
//! For horizontal motion at the surface of the column that stands for the free field. There is none where an interface parts that column, ground
//! goes on above, or water is shut in its pores.

use super::chosen;
use crate::equivalent_linear::{Given, Ground, Search, Unfit, fit_ground, of_law};
use crate::layered_column::Layer;
use crate::observers::observer::Setting;
use crate::quantities::MEASURES;
use rayon::prelude::*;
use tremolite_engine::life::Stage;
use tremolite_engine::state::Memory;
use tremolite_engine::{Top, column};
use tremolite_laws::parameter::position;

/// Key of what the observer remembers.
const MEMORY: &str = "equivalent-linear column";

/// The column beside one of the model's.
pub struct Yielding {
    /// Of the model's columns.
    pub column: usize,
    /// Velocity \[m/s\] of its surface along x and y every `dt` \[s\], and the largest shear strain; or why there is none.
    pub found: Result<Softened, NoColumn>,
}

/// What the column came to.
pub struct Softened {
    velocity: [Vec<f64>; 2],
    dt: f64,
    strain: f64,
}

/// Why there is no equivalent-linear column.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoColumn {
    /// A layer shears by this, beyond what a linear column can stand for.
    Strained(f64),
    /// Moduli do not come to rest.
    Restless,
    /// A law has no curves: it hardens under shear to and fro, cannot be driven, or is a program's own.
    Law,
}

/// What was seen of it in the rows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct YieldingSeen {
    /// Of the model's columns.
    pub column: usize,
    /// The largest shear strain of any layer.
    pub found: Result<f64, NoColumn>,
    /// Largest horizontal velocity of the surface so far \[m/s\], of the run and of the column.
    pub peaks: [f64; 2],
}

impl Yielding {
    /// Beside the column that stands for the free field, if its ground can yield.
    pub fn of(setting: &Setting) -> Option<Yielding> {
        let model = setting.model;
        let incident = model.boundaries.incident.as_ref()?;
        let (number, _) = chosen(model, setting.plan)?;
        let beside = &model.outside.columns[number];
        let yields = |layer: &column::Layer| {
            let history = model.bodies[layer.body].material.info().history;
            MEASURES.iter().any(|measure| position(history, measure.role).is_some())
        };
        let shut_in = |layer: &column::Layer| model.water.undrained(layer.element as usize).is_some();
        let layers = &beside.layers;
        if beside.parted
            || model.boundaries.top != Top::Free
            || !layers.iter().any(yields)
            || layers.iter().any(shut_in)
        {
            return None;
        }
        let motion = &incident.motion;
        let rows =
            ((setting.plan.duration / motion.dt).ceil() as usize + 1).min(motion.acceleration[0].len());
        // Of bare rock, twice the wave that comes up.
        let outcrop = [0, 1].map(|axis| {
            motion.acceleration[axis][..rows].iter().map(|a| 2.0 * incident.factor * a).collect::<Vec<f64>>()
        });
        if outcrop.iter().flatten().all(|a| *a == 0.0) {
            return None;
        }
        let found = Self::fitted(setting, layers, &outcrop);
        Some(Yielding { column: number, found })
    }

    fn fitted(
        setting: &Setting,
        layers: &[column::Layer],
        outcrop: &[Vec<f64>; 2],
    ) -> Result<Softened, NoColumn> {
        let model = setting.model;
        let of = |layer: &column::Layer| {
            let (body, e) = (&model.bodies[layer.body], layer.element as usize);
            let thickness = layer.top - layer.bottom;
            // Laws see effective stress.
            let mut stress = model.elements.initial.get(e).copied().unwrap_or_default();
            let pressure = model.water.pressure(e, Stage::Shaking);
            stress[..3].iter_mut().for_each(|s| *s += pressure);
            let curves = of_law(body.material.as_ref(), stress, thickness).ok_or(NoColumn::Law)?;
            let rayleigh = model.scheme.rayleigh;
            Ok((Layer::of(body, layer.element, &model.water, thickness, 0, rayleigh), curves))
        };
        let all: Vec<_> = layers.par_iter().rev().map(of).collect::<Result<_, _>>()?;
        let lowest = &all.last().ok_or(NoColumn::Law)?.0;
        // What a dashpot of the lowest layer's own moduli stands for.
        let rock = Layer { thickness: 0.0, band: None, rayleigh: Default::default(), ..*lowest };
        let (layers, curves) = all.into_iter().unzip();
        let ground = Ground { layers, curves, rock };
        let incident = model.boundaries.incident.as_ref().ok_or(NoColumn::Law)?;
        let along: Vec<&[f64]> = outcrop.iter().map(Vec::as_slice).collect();
        let fitted =
            fit_ground(&ground, &along, incident.motion.dt, Given::Outcrop, Search::default(), &|_| 1.0)
                .map_err(|unfit| match unfit {
                    Unfit::Strained { strain, .. } => NoColumn::Strained(strain),
                    Unfit::Restless { .. } => NoColumn::Restless,
                    Unfit::Nothing => NoColumn::Law,
                })?;
        let dt = incident.motion.dt / super::REFINEMENT;
        let velocity = [0, 1].map(|axis| {
            let wave = |t| incident.factor * incident.motion.at(t).v[axis];
            let [top, _] = fitted.column.velocities(wave, dt, setting.plan.duration);
            top
        });
        let strain = fitted.layers.iter().map(|layer| layer.strain).fold(0.0, f64::max);
        Ok(Softened { velocity, dt, strain })
    }

    /// Horizontal velocity of its surface \[m/s\] at a time.
    pub fn at(&self, time: f64) -> Option<[f64; 2]> {
        let Softened { velocity, dt, .. } = self.found.as_ref().ok()?;
        Some([0, 1].map(|axis| super::linear(&velocity[axis], time / dt)))
    }

    /// Notes a row: the velocity of the model's column and its own.
    pub fn see(&self, memory: &mut Memory, time: f64, surface: [f64; 3]) {
        let before = YieldingSeen::of(memory).map_or([0.0; 2], |seen| seen.peaks);
        let largest = |of: [f64; 2]| of.into_iter().map(f64::abs).fold(0.0, f64::max);
        let own = self.at(time).map_or(0.0, largest);
        let peaks = [before[0].max(largest([surface[0], surface[1]])), before[1].max(own)];
        let (code, strain) = match &self.found {
            Ok(found) => (0.0, found.strain),
            Err(NoColumn::Strained(strain)) => (1.0, *strain),
            Err(NoColumn::Restless) => (2.0, 0.0),
            Err(NoColumn::Law) => (3.0, 0.0),
        };
        memory.insert(MEMORY.into(), vec![self.column as f64, code, strain, peaks[0], peaks[1]]);
    }
}

impl YieldingSeen {
    /// What the state remembers.
    pub fn of(memory: &Memory) -> Option<Self> {
        let &[column, code, strain, run, own] = &memory.get(MEMORY)?[..] else { return None };
        let found = match code as u8 {
            0 => Ok(strain),
            1 => Err(NoColumn::Strained(strain)),
            2 => Err(NoColumn::Restless),
            _ => Err(NoColumn::Law),
        };
        Some(YieldingSeen { column: column as usize, found, peaks: [run, own] })
    }
}
