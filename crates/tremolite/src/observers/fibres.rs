//! How far the fibres of linings are beyond what their material bears while their elements are intact.

use super::observer::{Event, Observer, Schedule, Setting, View, Wants, Which};
use crate::error::RunError;
use crate::point_stress::Weights;
use crate::stacks::stacks;
use std::collections::BTreeSet;
use tremolite_engine::hexahedra::{hex, hex_nodes};
use tremolite_engine::model::Model;
use tremolite_engine::phase::{ElementSlot, Phase};
use tremolite_engine::state::Memory;
use tremolite_engine::{Body, Quadrature};
use tremolite_kernels::Points;
use tremolite_laws::Role;
use tremolite_laws::parameter::position;
use tremolite_laws::shapes::hex8::{ElasticPoints, Hex8};

/// An element whose thickness is known.
struct Cell {
    element: u32,
    body: usize,
    /// Which of the ways to its fibres is its own.
    ends: usize,
    /// Its number among those whose stress since the first row is told from motion, with the engine nodes of its corners.
    since: Option<(usize, [usize; 8])>,
}

/// How stresses at the ends of the rows of points through a thickness follow from those at points.
struct Ends {
    places: Points,
    axis: usize,
    all: Vec<End>,
}

/// One of them.
struct End {
    /// The last point there.
    point: usize,
    /// At that point and at the fibre, from the element's points and from 2×2×2; `same` where the point lies at the fibre.
    at_point: [Weights; 2],
    at_fibre: [Weights; 2],
    same: bool,
}

impl Ends {
    fn of(places: Points, axis: usize) -> Self {
        let full = Points { quadrature: Quadrature::Full, axis: 0 };
        let both = |natural: [f64; 3]| [Weights::at(&places, natural), Weights::at(&full, natural)];
        let end = |point: usize| {
            let natural = places.natural(point);
            // Of each row the last point at either end; of Gauss's two each is one.
            if natural[axis].abs() < 0.5 || (places.count() > 8 && natural[axis].abs() < 1.0) {
                return None;
            }
            let mut fibre = natural;
            fibre[axis] = natural[axis].signum();
            Some(End { point, at_point: both(natural), at_fibre: both(fibre), same: fibre == natural })
        };
        Ends { places, axis, all: (0..places.count()).filter_map(end).collect() }
    }
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
    /// Members that they are in.
    members: Vec<u32>,
    ends: Vec<Ends>,
    /// C:Δε with the law's own moduli, by body.
    since: Vec<ElasticPoints>,
    bodies: usize,
}

impl Fibres {
    pub const MEMORY: &'static str = "fibre use";
    /// Stresses \[Pa\] at the points of elements with Maxwell bodies in the first row, element by element.
    const FIRST: &'static str = "stress of the first row at points of linings";

    /// The observer, if a body of several points an element can crack.
    pub fn new(setting: &Setting) -> Option<Self> {
        let Setting { model, phase, .. } = *setting;
        let mut ends: Vec<Ends> = Vec::new();
        let cells = cells(model, phase, &mut ends);
        let slots = cells.iter().filter_map(|cell| phase.element_slot[cell.element as usize]);
        let members: BTreeSet<u32> = slots.map(|slot| slot.member).collect();
        // Only of these is the change since the first row told from motion.
        let banded = cells.iter().filter(|cell| model.bodies[cell.body].material.band().is_some());
        let nodes = Which::corners(model, banded.map(|cell| cell.element));
        let since = |(k, body): (usize, &Body)| {
            let told = cells.iter().filter(|cell| cell.body == k && cell.since.is_some());
            let hexes: Vec<Hex8> =
                told.filter_map(|c| model.elements.shape(&model.mesh, c.element).ok()).collect();
            ElasticPoints::new(&hexes, body.material.relaxed())
        };
        let since = model.user_bodies().iter().enumerate().map(since).collect();
        let bodies = model.user_bodies().len();
        let members = members.into_iter().collect();
        let schedule = setting.rows();
        (!cells.is_empty()).then_some(Fibres { schedule, nodes, cells, members, ends, since, bodies })
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

/// Elements whose thickness is known, and the ways to their fibres.
fn cells(model: &Model, phase: &Phase, ends: &mut Vec<Ends>) -> Vec<Cell> {
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
        let banded = body.material.band().is_some();
        let mut told = 0;
        all.extend(own.into_iter().filter_map(|(element, axis)| {
            let ElementSlot { places, .. } = phase.element_slot[element as usize]?;
            let known = ends.iter().position(|known| known.places == places && known.axis == axis);
            let ends = known.unwrap_or_else(|| {
                ends.push(Ends::of(places, axis));
                ends.len() - 1
            });
            let corners = hex_nodes(&model.mesh, element as usize);
            let since = (banded && hex(&model.mesh, element as usize).is_ok()).then(|| {
                told += 1;
                (told - 1, corners.map(|n| model.engine_node[n as usize] as usize))
            });
            Some(Cell { element, body: k, ends, since })
        }));
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
        let damaged = history.damaged(&self.members);
        for &Cell { element, body, ends, ref since, .. } in &self.cells {
            let Some(slot) = phase.element_slot[element as usize] else { continue };
            let material = &model.bodies[body].material;
            let points = &snapshot.stress[slot.point as usize..][..slot.points as usize];
            let mut before = points;
            if material.band().is_some() {
                (before, rest) = rest.split_at(points.len().min(rest.len()));
            }
            if damaged[slot.element as usize] {
                continue;
            }
            let since = since.map(|(told, corners)| {
                self.since[body].stress(told, &corners.map(|node| snapshot.displacement[node].xyz()))
            });
            // Of the law alone, anywhere in the element.
            let own = |[by_points, by_eight]: &[Weights; 2]| {
                let mut stress = by_points.stress(before);
                if let Some(since) = &since {
                    let more = by_eight.stress(since);
                    (0..6).for_each(|c| stress[c] += more[c]);
                }
                stress
            };
            let most = &mut kept[3 * body..3 * body + 3];
            for End { point, at_point, at_fibre, same } in &self.ends[ends].all {
                let fibre = own(at_fibre);
                if material.uses_at_most(&fibre, most[0]) {
                    continue;
                }
                let at_point = if *same { fibre } else { own(at_point) };
                let remembered: Vec<f64> = (0..history.columns(&slot).len())
                    .map(|c| history.values(&slot, c).nth(*point).unwrap_or(f64::NAN))
                    .collect();
                let Some(used) = material.tension_use(&fibre, &at_point, &remembered) else { continue };
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
