//! How far the fibres of linings are beyond what their material bears while their elements are intact.

use super::{Observer, Schedule, Setting, View};
use crate::error::RunError;
use crate::point_stress::stress_at;
use crate::stacks::stacks;
use tremolite_engine::Quadrature;
use tremolite_engine::model::Model;
use tremolite_engine::phase::Phase;
use tremolite_engine::state::Memory;
use tremolite_laws::Role;
use tremolite_laws::parameter::position;

/// An element whose thickness is known, with the natural axis through it.
struct Cell {
    element: u32,
    axis: usize,
    body: usize,
}

/// Keeps by body the largest use of the tensile strength at a fibre of an intact element, the element and when
/// ([`Fibres::MEMORY`], three numbers each; nothing seen is zero).
///
/// A fibre lies at the end of a row of points through the thickness; layered elements have a point there, 2×2×2 points are
/// extrapolated to it. Elements of one point have no fibres, and where walls meet nothing is a thickness.
pub struct Fibres {
    schedule: Schedule,
    cells: Vec<Cell>,
    bodies: usize,
}

impl Fibres {
    pub const MEMORY: &'static str = "fibre use";

    /// The observer, if a body of several points an element can crack.
    pub fn new(setting: &Setting) -> Option<Self> {
        let cells = cells(setting.model, setting.phase);
        let bodies = setting.model.user_bodies().len();
        (!cells.is_empty()).then(|| Fibres { schedule: setting.rows(), cells, bodies })
    }
}

fn cells(model: &Model, phase: &Phase) -> Vec<Cell> {
    let mut all = Vec::new();
    for (k, body) in model.user_bodies().iter().enumerate() {
        let cracks = position(body.material.info().history, Role::TensionDamage).is_some();
        if !cracks || body.quadrature == Quadrature::OnePoint {
            continue;
        }
        let there = |e: &u32| phase.element_slot[*e as usize].is_some();
        let elements: Vec<u32> = body.elements.iter().copied().filter(there).collect();
        let mut own: Vec<(u32, usize)> = match body.quadrature {
            Quadrature::Layered(_) => {
                elements.iter().map(|&e| (e, model.thickness[e as usize] as usize)).collect()
            }
            _ => stacks(&model.mesh, &elements).into_iter().flatten().collect(),
        };
        own.sort_unstable();
        own.dedup_by_key(|(element, _)| *element);
        all.extend(own.into_iter().map(|(element, axis)| Cell { element, axis, body: k }));
    }
    all
}

impl Observer for Fibres {
    fn schedule(&self) -> Schedule {
        self.schedule
    }

    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let View { model, phase, snapshot, history, .. } = *view;
        let mut kept = memory.remove(Self::MEMORY).unwrap_or_else(|| vec![0.0; 3 * self.bodies]);
        for &Cell { element, axis, body } in &self.cells {
            let Some(slot) = phase.element_slot[element as usize] else { continue };
            if history.is_damaged(&slot) {
                continue;
            }
            let material = &model.bodies[body].material;
            let first = slot.point as usize;
            let points = &snapshot.stress[first..first + slot.points as usize];
            let columns = history.columns(&slot).len();
            for p in 0..points.len() {
                let mut natural = slot.places.natural(p);
                // Of each row the last point at either end; of Gauss's two each is one.
                if natural[axis].abs() < 0.5 || (points.len() > 8 && natural[axis].abs() < 1.0) {
                    continue;
                }
                natural[axis] = natural[axis].signum();
                let fibre = match slot.places.quadrature {
                    Quadrature::Layered(_) => points[p],
                    _ => stress_at(&slot.places, points, natural),
                };
                let remembered: Vec<f64> =
                    (0..columns).map(|c| history.values(&slot, c).nth(p).unwrap_or(f64::NAN)).collect();
                let Some(used) = material.tension_use(&fibre, &points[p], &remembered) else { continue };
                let most = &mut kept[3 * body..3 * body + 3];
                if used > most[0] {
                    most.copy_from_slice(&[used, f64::from(element), snapshot.time]);
                }
            }
        }
        memory.insert(Self::MEMORY.into(), kept);
        Ok(())
    }
}
