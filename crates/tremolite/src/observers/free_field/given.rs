//! free_field.csv where waves come at angles: the field by theory at the model's corners and at monitors, and the model beside it.
//!
//! `xmin-ymin.top.vx` … are the free field at the upper and the lower end of the model's four vertical edges, `model.xmin-ymin` … the
//! model itself there, and `A.free_field.vx` the field at the monitor A.

use super::columns::edges;
use super::levels;
use super::seen::{ColumnSeen, FreeFieldSeen, most};
use super::{AXES, ENDS};
use crate::error::RunError;
use crate::observers::RunTable;
use crate::observers::observer::{Event, Observer, Setting, Stepped, View, Wants, Which};
use crate::waves::ObliqueField;
use std::sync::Arc;
use tremolite_engine::column::corner_name;
use tremolite_engine::free_field::GivenField;
use tremolite_engine::state::Memory;
use tremolite_results::{Column, Subject};

/// Compares and writes velocities at the rows of the histories, and compares them in every step.
pub struct AtCorners {
    wants: Wants,
    table: RunTable,
    field: Arc<ObliqueField>,
    /// Engine nodes of the model itself, by end and corner, and where they are \[m\].
    edges: [[usize; 4]; 2],
    at: [[[f64; 3]; 4]; 2],
    /// Monitors \[m\].
    monitors: Vec<[f64; 3]>,
}

impl AtCorners {
    /// The observer, if waves come at angles.
    ///
    /// # Errors
    /// If the file cannot be written, or is shorter than the state remembers.
    pub fn new(setting: &Setting) -> Result<Option<Self>, RunError> {
        let Setting { model, plan, .. } = *setting;
        let Some(waves) = &plan.waves else { return Ok(None) };
        let edges = edges(model, &[]);
        let at = edges.map(|ends| ends.map(|n| model.mesh.nodes[model.mesh_node[n] as usize]));
        let mut header = vec![Column::new("time", "s")];
        let mut add = |subject: Subject, place: &str| {
            header.extend(AXES.map(|axis| Column::of(subject.clone(), format!("{place}.v{axis}"), "m/s")));
        };
        for corner in 0..4 {
            ENDS.iter().for_each(|end| add(Subject::Column(corner_name(corner)), end));
            ["surface", "base"].iter().for_each(|end| add(Subject::Edge(corner_name(corner)), end));
        }
        plan.monitors.iter().for_each(|monitor| add(Subject::Monitor(monitor.name.clone()), "free_field"));
        let table = RunTable::new(&setting.folder.free_field(), &header, setting.memory)?;
        let nodes = || edges.iter().flatten().copied();
        let wants = Wants {
            nodes: Which::some(nodes()),
            steps: Which::some(nodes()),
            ..Wants::looks(setting.rows())
        };
        let monitors = plan.monitors.iter().map(|monitor| levels::place(model, &monitor.location)).collect();
        Ok(Some(AtCorners { wants, table, field: waves.field.clone(), edges, at, monitors }))
    }

    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let seen = FreeFieldSeen::at_corners(memory).unwrap_or_else(|| FreeFieldSeen {
            columns: (0..4).map(|k| ColumnSeen { name: corner_name(k), ..ColumnSeen::default() }).collect(),
        });
        let time = view.snapshot.time;
        let free = |at: [f64; 3]| self.field.velocity(at, time, INSTANT);
        let mut row = vec![time];
        for corner in 0..4 {
            self.at.iter().for_each(|at| row.extend(free(at[corner])));
            self.edges.iter().for_each(|nodes| row.extend(view.snapshot.velocity[nodes[corner]].xyz()));
        }
        self.monitors.iter().for_each(|&at| row.extend(free(at)));
        self.table.write(&row, memory)?;
        seen.keep(memory);
        Ok(())
    }

    /// In every step of their own: rows may be too few to show the wave.
    fn stepped(&self, step: &Stepped, memory: &mut Memory) {
        for (corner, [surface, base, peak]) in FreeFieldSeen::every_step(memory).enumerate().take(4) {
            for (end, difference) in [surface, base].into_iter().enumerate() {
                let node = self.edges[end][corner];
                let Some(span) = step.own([node]) else { continue };
                let now = step.steps as f64 * step.dt;
                let free = self.field.velocity(self.at[end][corner], now - 0.5 * span, 0.5 * span);
                let found = step.du[node].xyz().map(|d| d / step.dt);
                for i in 0..3 {
                    *peak = peak.max(free[i].abs());
                    *difference = most(*difference, (found[i] - free[i]).abs());
                }
            }
        }
    }
}

/// Over which velocities of the field are taken \[s\]: little against any period, much against round-off.
const INSTANT: f64 = 1e-4;

impl Observer for AtCorners {
    fn wants(&self) -> Wants {
        self.wants.clone()
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.see(view, memory),
            Event::Step(step) => {
                self.stepped(step, memory);
                Ok(())
            }
            _ => Ok(()),
        }
    }
}
