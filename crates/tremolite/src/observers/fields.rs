//! fields/*.vtu and fields.pvd: the whole model at some times. A model of many elements is written in pieces, each in a file, which a file
//! `.pvtu` lists; which elements are a piece goes by the mesh alone, so that the files are the same however many ranks there are.

use super::observer::{Event, Observer, Schedule, Setting, View, Wants, Which};
use super::{Cracks, Envelopes};
use crate::error::RunError;
use crate::plan::Plan;
use crate::point_stress::{extremes, mean};
use crate::quantities::{Field, field_name, of_element};
use crate::stages::flow_in;
use std::path::Path;
use tremolite_engine::Stage;
use tremolite_engine::model::Model;
use tremolite_engine::phase::{ElementSlot, Phase};
use tremolite_engine::state::Memory;
use tremolite_laws::Row;
use tremolite_mesh::vtu::{Array, Grid, NODE, Values, VtuError, write_list};
use tremolite_results::{CrackDirection, Pvd};

/// Writes the chosen fields of the active elements.
pub struct Fields {
    schedule: Schedule,
    folder: std::path::PathBuf,
    list: Pvd,
    grids: FieldGrids,
}

/// The active elements of a phase in the files that they are written in: one, or pieces of a fixed number of the mesh's elements.
pub struct FieldGrids {
    pieces: Vec<FieldGrid>,
    /// Elements of the mesh.
    elements: usize,
}

/// Active elements of a phase, to be written to one file with what they show.
struct FieldGrid {
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
        let Setting { folder, model, phase, plan, steps, .. } = *setting;
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
        let grids = FieldGrids::of(model, phase, plan);
        Ok(Some(Fields { schedule, folder: folder.fields(), list, grids }))
    }
}

impl FieldGrids {
    /// The elements that are there in a phase; where the mesh has more than a file may have, each so many of the mesh's elements are a piece.
    pub fn of(model: &Model, phase: &Phase, plan: &Plan) -> Self {
        let active: Vec<u32> =
            (0u32..).zip(&phase.element_slot).filter(|(_, slot)| slot.is_some()).map(|(e, _)| e).collect();
        let elements = model.mesh.elements.len();
        let in_pieces = plan.in_pieces(elements);
        let most = if in_pieces { plan.field_elements.max(1) as u32 } else { u32::MAX };
        let lots: Vec<&[u32]> = match active.is_empty() {
            true => vec![&active[..]],
            false => active.chunk_by(|a, b| a / most == b / most).collect(),
        };
        let mut pieces: Vec<FieldGrid> =
            lots.into_iter().map(|lot| FieldGrid::of(model, phase, lot, in_pieces)).collect();
        // All pieces have the same arrays.
        for (name, elements) in &model.mesh.groups {
            let mut inside = vec![0; model.mesh.elements.len()];
            elements.iter().for_each(|&e| inside[e as usize] = 1);
            if active.iter().any(|&e| inside[e as usize] == 1) {
                pieces.iter_mut().for_each(|piece| piece.add_group(name, &inside));
            }
        }
        FieldGrids { pieces, elements }
    }

    /// Writes the fields that the plan wants, and more vectors by engine node with their names and units, to a file of this name in a folder, or
    /// to pieces of which it is a list; the name with its ending comes back.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn write(
        &self,
        (folder, name): (&Path, &str),
        time: f64,
        (view, memory): (&View, &Memory),
        more: &[(&str, &str, &[Row])],
    ) -> Result<String, VtuError> {
        let of = |piece: &FieldGrid| piece.filled(time, view, memory, more);
        let whole = view.plan.field_file(name, self.elements);
        if !view.plan.in_pieces(self.elements) {
            self.pieces.iter().try_for_each(|piece| of(piece).write(&folder.join(&whole)))?;
            return Ok(whole);
        }
        let mut files = Vec::new();
        let mut like = Grid::default();
        for (k, piece) in self.pieces.iter().enumerate() {
            let file = format!("{name}-{k:04}.vtu");
            like = of(piece);
            like.write(&folder.join(&file))?;
            files.push(file);
        }
        // Behind its pieces, so that whoever sees it finds them.
        write_list(&folder.join(&whole), &like, &files)?;
        Ok(whole)
    }
}

impl FieldGrid {
    /// Some elements that are there in a phase, as one of several pieces or by themselves.
    fn of(model: &Model, phase: &Phase, active: &[u32], is_piece: bool) -> Self {
        let (mut grid, mesh_nodes) = Grid::from_mesh(&model.mesh, Some(active));
        let slots: Vec<ElementSlot> = active.iter().filter_map(|&e| phase.element_slot[e as usize]).collect();
        let bodies: Vec<i32> = slots.iter().map(|s| model.patches[s.patch as usize].body as i32).collect();
        let numbers = active.iter().map(|&e| model.mesh.element_id(e as usize) as i64).collect();
        grid.cell_data = vec![
            Array::new("element", "", 1, Values::Int64(numbers)),
            Array::new("body", "", 1, Values::Int32(bodies)),
        ];
        if is_piece {
            let numbers = mesh_nodes.iter().map(|&n| i64::from(n)).collect();
            grid.point_data = vec![Array::new(NODE, "", 1, Values::Int64(numbers))];
        }
        let nodes = mesh_nodes.iter().map(|&n| model.engine_node[n as usize]).collect();
        FieldGrid { grid, nodes, elements: active.to_vec(), slots }
    }

    /// Adds an array `group:NAME`, 1 in a group and 0 outside.
    fn add_group(&mut self, name: &str, inside: &[u8]) {
        let values: Vec<u8> = self.elements.iter().map(|&e| inside[e as usize]).collect();
        self.grid.cell_data.push(Array::new(format!("group:{name}"), "", 1, Values::UInt8(values)));
    }

    /// With the fields that the plan wants, and more vectors by engine node with their names and units.
    fn filled(&self, time: f64, view: &View, memory: &Memory, more: &[(&str, &str, &[Row])]) -> Grid {
        let mut grid = self.grid.clone();
        grid.time = Some(time);
        for &field in &view.plan.fields {
            self.add(&mut grid, field, view, memory);
        }
        self.add_histories(&mut grid, view);
        grid.point_data.extend(more.iter().map(|(name, unit, rows)| self.nodal(name, unit, rows)));
        grid
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
                    self.add_directions(grid, view, memory);
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

    /// The widest crack so far of those that cross bars, and which way the widest of all runs: a number of [`CrackDirection`], 0 without a crack.
    fn add_directions(&self, grid: &mut Grid, view: &View, memory: &Memory) {
        let rows = Cracks::rows(view.assembly, view.phase);
        let remembered = Cracks::remembered(memory);
        let each = self.elements.iter().map(|e| {
            let opened = rows.get(e).map(|&row| Cracks::opened(remembered, row)).unwrap_or_default();
            let all = CrackDirection::ALL.into_iter().zip(opened.map(|of| of.widest));
            let across = all.clone().filter(|(way, _)| way.crosses_bars()).map(|(_, width)| width);
            // Of equal ones the first.
            let widest = all.filter(|(_, width)| *width > 0.0).reduce(|a, b| if b.1 > a.1 { b } else { a });
            (across.fold(0.0, f64::max) as f32, widest.map_or(0, |(way, _)| way.number()))
        });
        let (across, ways) = each.unzip();
        grid.cell_data.push(Array::new("crack_across", "m", 1, Values::Float32(across)));
        grid.cell_data.push(Array::new("crack_direction", "", 1, Values::UInt8(ways)));
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
        let name = format!("{:06}", view.snapshot.step.div_ceil(self.schedule.every));
        let name = self.grids.write((&self.folder, &name), view.snapshot.time, (view, memory), &[])?;
        self.list.add(view.snapshot.time, &format!("fields/{name}"))?;
        Ok(())
    }
}
