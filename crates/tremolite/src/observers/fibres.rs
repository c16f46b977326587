//! How far the fibres of linings are beyond what their material bears while their elements are intact.

use super::observer::{Event, Observer, Schedule, Setting, View, Wants, Which};
use crate::error::RunError;
use crate::point_stress::stress_at;
use crate::stacks::stacks;
use tremolite_engine::Quadrature;
use tremolite_engine::hexahedra::{hex, hex_nodes};
use tremolite_engine::model::Model;
use tremolite_engine::phase::Phase;
use tremolite_engine::state::Memory;
use tremolite_kernels::Points;
use tremolite_laws::Role;
use tremolite_laws::parameter::position;
use tremolite_laws::shapes::hex8::elastic_stress;

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
/// extrapolated to it. Elements of one point have no fibres, and where walls meet nothing is a thickness. Laws crack by their own stress:
/// where Maxwell bodies stand beside one, it is that of the first row, when these carry nothing, and what the strain since then adds.
pub struct Fibres {
    schedule: Schedule,
    nodes: Which,
    cells: Vec<Cell>,
    bodies: usize,
}

impl Fibres {
    pub const MEMORY: &'static str = "fibre use";
    /// Stresses \[Pa\] at the points of elements with Maxwell bodies in the first row, element by element.
    const FIRST: &'static str = "stress of the first row at points of linings";

    /// The observer, if a body of several points an element can crack.
    pub fn new(setting: &Setting) -> Option<Self> {
        let cells = cells(setting.model, setting.phase);
        let bodies = setting.model.user_bodies().len();
        // Only of these is the change since the first row told from motion.
        let banded = cells.iter().filter(|cell| setting.model.bodies[cell.body].material.band().is_some());
        let nodes = Which::corners(setting.model, banded.map(|cell| cell.element));
        (!cells.is_empty()).then(|| Fibres { schedule: setting.rows(), nodes, cells, bodies })
    }

    fn first(&self, view: &View) -> Vec<f64> {
        let View { model, phase, snapshot, .. } = *view;
        let banded = self.cells.iter().filter(|cell| model.bodies[cell.body].material.band().is_some());
        let slots = banded.filter_map(|cell| phase.element_slot[cell.element as usize]);
        slots
            .flat_map(|slot| &snapshot.stress[slot.point as usize..][..slot.points as usize])
            .flatten()
            .copied()
            .collect()
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
                elements.iter().map(|&e| (e, model.elements.thickness[e as usize] as usize)).collect()
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
    fn wants(&self) -> Wants {
        Wants {
            nodes: self.nodes.clone(),
            elements: Which::some(self.cells.iter().map(|cell| cell.element as usize)),
            ..Wants::looks(self.schedule)
        }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.see(view, memory),
            _ => Ok(()),
        }
    }
}

impl Fibres {
    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let View { model, phase, snapshot, history, .. } = *view;
        let mut kept = memory.remove(Self::MEMORY).unwrap_or_else(|| vec![0.0; 3 * self.bodies]);
        let first = memory.remove(Self::FIRST).unwrap_or_else(|| self.first(view));
        let mut rest = first.as_chunks::<6>().0;
        for &Cell { element, axis, body } in &self.cells {
            let Some(slot) = phase.element_slot[element as usize] else { continue };
            let material = &model.bodies[body].material;
            let points = &snapshot.stress[slot.point as usize..][..slot.points as usize];
            let mut before = points;
            if material.band().is_some() {
                (before, rest) = rest.split_at(points.len().min(rest.len()));
            }
            if history.is_damaged(&slot) {
                continue;
            }
            let since = match material.band() {
                Some(_) => since(view, element, body),
                None => None,
            };
            // Of the law alone, anywhere in the element.
            let own = |natural: [f64; 3]| {
                let mut stress = stress_at(&slot.places, before, natural);
                if let Some(since) = &since {
                    let full = Points { quadrature: Quadrature::Full, axis: 0 };
                    let more = stress_at(&full, since, natural);
                    (0..6).for_each(|c| stress[c] += more[c]);
                }
                stress
            };
            let columns = history.columns(&slot).len();
            for p in 0..points.len() {
                let mut natural = slot.places.natural(p);
                // Of each row the last point at either end; of Gauss's two each is one.
                if natural[axis].abs() < 0.5 || (points.len() > 8 && natural[axis].abs() < 1.0) {
                    continue;
                }
                let at_point = own(natural);
                natural[axis] = natural[axis].signum();
                let fibre = own(natural);
                let remembered: Vec<f64> =
                    (0..columns).map(|c| history.values(&slot, c).nth(p).unwrap_or(f64::NAN)).collect();
                let Some(used) = material.tension_use(&fibre, &at_point, &remembered) else { continue };
                let most = &mut kept[3 * body..3 * body + 3];
                if used > most[0] {
                    most.copy_from_slice(&[used, f64::from(element), snapshot.time]);
                }
            }
        }
        memory.insert(Self::MEMORY.into(), kept);
        memory.insert(Self::FIRST.into(), first);
        Ok(())
    }
}

/// C:Δε \[Pa\] at 2×2×2 points, with the strain since the shaking began and the law's own moduli.
fn since(view: &View, element: u32, body: usize) -> Option<Vec<[f64; 6]>> {
    let View { model, snapshot, .. } = *view;
    let body = &model.bodies[body];
    let nodes = hex_nodes(&model.mesh, element as usize);
    let u = nodes.map(|n| snapshot.displacement[model.engine_node[n as usize] as usize].xyz());
    let hex = hex(&model.mesh, element as usize).ok()?;
    Some(elastic_stress(&hex, body.material.relaxed(), body.quadrature, &u))
}
