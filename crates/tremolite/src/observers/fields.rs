//! fields/*.vtu and fields.pvd: the whole model at some times.

use super::observer::{Event, Observer, Schedule, Setting, View, Wants, Which};
use super::{Cracks, Envelopes};
use crate::error::RunError;
use crate::point_stress::{extremes, mean};
use crate::quantities::{Field, field_name, of_element};
use crate::stages::flow_in;
use std::path::Path;
use tremolite_engine::Stage;
use tremolite_engine::model::Model;
use tremolite_engine::phase::{ElementSlot, Phase};
use tremolite_engine::state::Memory;
use tremolite_laws::Row;
use tremolite_mesh::vtu::{Array, Grid, Values, VtuError};
use tremolite_results::Pvd;

/// Writes the chosen fields of the active elements.
pub struct Fields {
    schedule: Schedule,
    folder: std::path::PathBuf,
    list: Pvd,
    grid: FieldGrid,
}

/// The active elements of a phase, to be written with what they show.
pub struct FieldGrid {
    grid: Grid,
    /// Engine node of each point of the grid.
    nodes: Vec<u32>,
    /// Element of the mesh of each cell, and where its results lie.
    elements: Vec<u32>,
    slots: Vec<ElementSlot>,
}

impl Fields {
    /// Starts the list of files, or goes on with it at the state's time; nothing if the plan wants no fields.
    ///
    /// # Errors
    /// If the list cannot be written or read.
    pub fn new(setting: &Setting) -> Result<Option<Self>, RunError> {
        let Setting { folder, model, phase, steps, .. } = *setting;
        let Some(every) = steps.snapshots else { return Ok(None) };
        let list = if setting.step == 0 {
            Pvd::create(&folder.pvd())?
        } else {
            // Files of the state's own time are written again.
            Pvd::resume(&folder.pvd(), setting.time - 0.5 * setting.dt)?
        };
        tremolite_files::make_folder(&folder.fields())
            .map_err(|source| RunError::Io { path: folder.fields(), source })?;
        let schedule = Schedule { every, last: Some(steps.total) };
        Ok(Some(Fields { schedule, folder: folder.fields(), list, grid: FieldGrid::of(model, phase) }))
    }
}

impl FieldGrid {
    /// The elements that are there in a phase.
    pub fn of(model: &Model, phase: &Phase) -> Self {
        let active: Vec<u32> =
            (0u32..).zip(&phase.element_slot).filter(|(_, slot)| slot.is_some()).map(|(e, _)| e).collect();
        let (mut grid, mesh_nodes) = Grid::from_mesh(&model.mesh, Some(&active));
        let slots: Vec<ElementSlot> = active.iter().filter_map(|&e| phase.element_slot[e as usize]).collect();
        let bodies: Vec<i32> = slots.iter().map(|s| model.patches[s.patch as usize].body as i32).collect();
        let numbers = active.iter().map(|&e| model.mesh.element_id(e as usize) as i64).collect();
        grid.cell_data = vec![
            Array::new("element", "", 1, Values::Int64(numbers)),
            Array::new("body", "", 1, Values::Int32(bodies)),
        ];
        grid.cell_data.extend(groups(model, &active));
        let nodes = mesh_nodes.iter().map(|&n| model.engine_node[n as usize]).collect();
        FieldGrid { grid, nodes, elements: active, slots }
    }

    /// Writes a file of the fields that the plan wants, and of more vectors by engine node with their names and units.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write(
        &self,
        path: &Path,
        time: f64,
        view: &View,
        memory: &Memory,
        more: &[(&str, &str, &[Row])],
    ) -> Result<(), VtuError> {
        let mut grid = self.grid.clone();
        grid.time = Some(time);
        for &field in &view.plan.fields {
            self.add(&mut grid, field, view, memory);
        }
        self.add_histories(&mut grid, view);
        grid.point_data.extend(more.iter().map(|(name, unit, rows)| self.nodal(name, unit, rows)));
        grid.write(path)
    }

    fn nodal(&self, name: &str, unit: &str, rows: &[Row]) -> Array {
        let values = self.nodes.iter().flat_map(|&n| rows[n as usize].xyz()).map(|x| x as f32).collect();
        Array::new(name, unit, 3, Values::Float32(values))
    }

    fn cells(&self, name: &str, unit: &str, value: impl Fn(&ElementSlot) -> f64) -> Array {
        let values = self.slots.iter().map(|slot| value(slot) as f32).collect();
        Array::new(name, unit, 1, Values::Float32(values))
    }

    fn add(&self, grid: &mut Grid, field: Field, view: &View, memory: &Memory) {
        let points = |slot: &ElementSlot| {
            &view.snapshot.stress[slot.point as usize..slot.point as usize + slot.points as usize]
        };
        match field {
            Field::Displacement => {
                grid.point_data.push(self.nodal("displacement", "m", &view.snapshot.displacement))
            }
            Field::Velocity => grid.point_data.push(self.nodal("velocity", "m/s", &view.snapshot.velocity)),
            Field::Acceleration => {
                grid.point_data.push(self.nodal("acceleration", "m/s2", &view.snapshot.acceleration));
            }
            Field::Stress => {
                let values =
                    self.slots.iter().flat_map(|s| mean(&s.places, points(s))).map(|x| x as f32).collect();
                grid.cell_data.push(Array::new("stress", "Pa", 6, Values::Float32(values)));
            }
            Field::Principal => {
                grid.cell_data.push(self.cells("s1", "Pa", |s| extremes(points(s))[0]));
                grid.cell_data.push(self.cells("s3", "Pa", |s| extremes(points(s))[1]));
                let pore = &view.snapshot.pore;
                if !pore.is_empty() {
                    let p = |s: &ElementSlot| pore[s.element as usize];
                    grid.cell_data.push(self.cells("p", "Pa", p));
                    grid.cell_data.push(self.cells("s1_eff", "Pa", |s| extremes(points(s))[0] + p(s)));
                    grid.cell_data.push(self.cells("s3_eff", "Pa", |s| extremes(points(s))[1] + p(s)));
                }
            }
            Field::Envelope => {
                let Some(most) = memory.get(Envelopes::DISPLACEMENT) else { return };
                let values = self.nodes.iter().map(|&n| most[n as usize] as f32).collect();
                grid.point_data.push(Array::new("displacement_max", "m", 1, Values::Float32(values)));
                for name in [Envelopes::S1, Envelopes::S3] {
                    if let Some(column) = memory.get(name) {
                        grid.cell_data.push(self.cells(name, "Pa", |s| column[s.element as usize]));
                    }
                }
            }
            // Several of these may hold the same column: they are written together.
            Field::Damage => {
                if let Some(widest) = memory.get(Cracks::OPENING) {
                    grid.cell_data.push(self.cells(Cracks::OPENING, "m", |s| widest[s.element as usize]));
                }
            }
            Field::Seepage => {
                let stage = match view.phase.stage {
                    Stage::Before(k) => k.into(),
                    Stage::Shaking => usize::MAX,
                };
                let Some(flow) = flow_in(&view.plan.stages, stage) else { return };
                // Slabs of the ground outside have no flow of their own.
                let of = |&e: &u32| flow.velocities.get(e as usize).copied().unwrap_or_default();
                let values = self.elements.iter().flat_map(of).map(|x| x as f32).collect();
                grid.cell_data.push(Array::new("seepage", "m/s", 3, Values::Float32(values)));
            }
            Field::Plastic | Field::History | Field::Interface => {}
        }
    }

    /// The laws' columns that the fields ask for, zero in elements whose law has none of that name.
    fn add_histories(&self, grid: &mut Grid, view: &View) {
        let View { model, plan, history, .. } = *view;
        let mut written: Vec<&str> = Vec::new();
        let all = model.user_bodies().iter().flat_map(|b| b.material.info().history);
        for column in all.filter(|c| plan.fields.iter().any(|f| f.holds(c))) {
            if written.contains(&column.name) {
                continue;
            }
            written.push(column.name);
            let unit = if column.unit == "1" { "" } else { column.unit };
            grid.cell_data.push(self.cells(field_name(column), unit, |slot| {
                history
                    .named(slot, column.name)
                    .map_or(0.0, |at| of_element(column, slot.places.quadrature, history.values(slot, at)))
            }));
        }
    }
}

/// An array `group:NAME`, 1 in the group and 0 outside, for each group with an active element.
fn groups(model: &Model, active: &[u32]) -> Vec<Array> {
    let array = |(name, elements): (&String, &Vec<u32>)| {
        let mut inside = vec![0; model.mesh.elements.len()];
        elements.iter().for_each(|&e| inside[e as usize] = 1);
        let values: Vec<u8> = active.iter().map(|&e| inside[e as usize]).collect();
        values.contains(&1).then(|| Array::new(format!("group:{name}"), "", 1, Values::UInt8(values)))
    };
    model.mesh.groups.iter().filter_map(array).collect()
}

impl Observer for Fields {
    fn wants(&self) -> Wants {
        Wants { nodes: Which::All, elements: Which::All, reads_kept: true, ..Wants::looks(self.schedule) }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.see(view, memory),
            _ => Ok(()),
        }
    }
}

impl Fields {
    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let name = format!("{:06}.vtu", view.snapshot.step.div_ceil(self.schedule.every));
        self.grid.write(&self.folder.join(&name), view.snapshot.time, view, memory, &[])?;
        self.list.add(view.snapshot.time, &format!("fields/{name}"))?;
        Ok(())
    }
}
