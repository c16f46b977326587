//! depth.csv: peaks along depth, of the free field and of the model's own vertical edge beside it.
//!
//! The free field is the column of ground nearest to the monitors ([`free_field::chosen`]), level by level. Peaks are the largest
//! sizes over all steps: of displacement less that of the column's base, of velocity between two steps, and of the strains of the
//! layer below a level, which is one element. Accelerations are those between rows, as in monitors.csv: single steps ring where
//! rock cracks. Beside them stands one-dimensional theory, as
//! free_field.csv has it at top and base: none where an interface parts the column or its rock has yielded.

use super::free_field::{FreeFieldSeen, REFINEMENT, chosen, layered, levels};
use super::observer::{Event, Observer, Schedule, Setting, Stepped, View, Wants, Which};
use crate::error::RunError;
use crate::layered_column::LayeredColumn;
use crate::plan::Plan;
use levels::Level;
use std::sync::Arc;
use tremolite_engine::model::Model;
use tremolite_engine::state::Memory;
use tremolite_results::{Column, ResultFolder, TableWriter};

/// Key of what this observer remembers: the time of the last row \[s\], then [`EACH`] numbers by level, upwards: of the column,
/// then of the model's edge.
const MEMORY: &str = "depth";
/// Numbers of a level: the velocity of the last row, then the largest displacement, velocity, acceleration, and strains below.
const EACH: usize = 3 + PEAKS;
const PEAKS: usize = 12;

/// What is followed: name behind the dot and unit.
const QUANTITIES: [(&str, &str); PEAKS] = [
    ("ux", "m"),
    ("uy", "m"),
    ("uz", "m"),
    ("vx", "m/s"),
    ("vy", "m/s"),
    ("vz", "m/s"),
    ("ax", "m/s2"),
    ("ay", "m/s2"),
    ("az", "m/s2"),
    ("gxz", "1"),
    ("gyz", "1"),
    ("ezz", "1"),
];
/// Where they begin.
const VELOCITY: usize = 3;
const ACCELERATION: usize = 6;
/// Those that the model's edge has: its strains are not those of one dimension.
const MOTION: usize = 9;

/// Peaks of one level.
type Peaks = [f64; PEAKS];

/// Follows a column and the model's edge beside it.
pub struct DepthPeaks {
    schedule: Schedule,
    folder: ResultFolder,
    model: Arc<Model>,
    /// Time between rows of the histories \[s\].
    row: f64,
    depth: Depth,
}

/// What is followed.
pub struct Depth {
    /// Which of the model's columns.
    column: usize,
    /// Upwards.
    levels: Vec<Level>,
    /// Engine nodes of the model's edge level with them; empty where the mesh has no such edge.
    edge: Vec<usize>,
}

impl Depth {
    /// Finds it: nothing where no wave comes in or no column stands.
    pub fn of(model: &Model, plan: &Plan) -> Option<Self> {
        model.boundaries.incident.as_ref()?;
        let (column, corner) = chosen(model, plan)?;
        let levels = levels::levels(model, &model.outside.columns[column]);
        let edge = levels::beside(model, corner, &levels);
        Some(Depth { column, levels, edge })
    }

    /// What is followed: the levels of the column, then those of the edge.
    fn nodes(&self) -> impl Iterator<Item = usize> {
        self.levels.iter().map(|level| level.node).chain(self.edge.iter().copied())
    }

    /// What is remembered; at the start nothing has moved.
    fn kept<'m>(&self, memory: &'m mut Memory) -> &'m mut Vec<f64> {
        memory.entry(MEMORY.into()).or_insert_with(|| {
            let mut kept = vec![0.0; 1 + EACH * self.nodes().count()];
            kept[0] = f64::NAN;
            kept
        })
    }

    /// How many numbers the file holds, at most.
    pub fn numbers(&self) -> usize {
        self.levels.len() * (2 + 2 * PEAKS + MOTION)
    }

    /// Writes the file whole from what is remembered: from the top down, a row a level.
    ///
    /// # Errors
    /// If it cannot be written.
    fn write(
        &self,
        folder: &ResultFolder,
        model: &Model,
        row: f64,
        time: f64,
        memory: &Memory,
    ) -> Result<(), RunError> {
        let kept = memory.get(MEMORY).map_or(&[][..], |kept| &kept[1..]);
        let peaks =
            |line: usize| kept.chunks_exact(EACH).skip(line * self.levels.len()).map(|kept| &kept[3..]);
        let theory = self.theory(model, row, time, memory);
        let mut columns = vec![Column::new("z", "m"), Column::new("depth", "m")];
        for (name, unit) in QUANTITIES {
            columns.push(Column::new(format!("free_field.{name}"), unit));
            columns.extend(theory.is_some().then(|| Column::new(format!("free_field.{name}_theory"), unit)));
        }
        if !self.edge.is_empty() {
            columns.extend(
                QUANTITIES[..MOTION].iter().map(|(name, u)| Column::new(format!("model.{name}"), *u)),
            );
        }
        let mut table = TableWriter::create(&folder.depth(), &columns)?;
        let (mut own, mut edge) = (peaks(0), peaks(1));
        let top = self.levels.last().map_or(0.0, |level| level.z);
        let mut rows = Vec::new();
        for (k, level) in self.levels.iter().enumerate() {
            let (Some(own), edge) = (own.next(), edge.next()) else { break };
            let mut row = vec![level.z, top - level.z];
            for (q, peak) in own.iter().enumerate() {
                // Under the lowest level is none of the column.
                let known = |peak: f64| if q >= MOTION && k == 0 { f64::NAN } else { peak };
                row.push(known(*peak));
                row.extend(theory.as_ref().map(|theory| known(theory[k][q])));
            }
            row.extend(edge.iter().flat_map(|edge| &edge[..MOTION]));
            rows.push(row);
        }
        rows.reverse();
        table.write(&rows.concat())?;
        Ok(table.sync()?)
    }

    /// Peaks by theory of the time so far, level by level upwards.
    fn theory(&self, model: &Model, row: f64, time: f64, memory: &Memory) -> Option<Vec<Peaks>> {
        let seen = FreeFieldSeen::of(model, memory)?;
        if seen.columns.get(self.column)?.damaged {
            return None;
        }
        let columns = layered(model, &model.outside.columns[self.column])?;
        let incident = model.boundaries.incident.as_ref()?;
        let dt = incident.motion.dt / REFINEMENT;
        let heights: Vec<f64> = self.levels.iter().map(|level| level.z - self.levels[0].z).collect();
        let mut peaks = vec![[0.0; PEAKS]; heights.len()];
        for (axis, column) in columns.iter().enumerate() {
            let wave = |t| incident.factor * incident.motion.at(t).v[axis];
            let found = Predicted::of(column, &heights, wave, dt, time);
            found.fill(&mut peaks, axis, &heights, row);
        }
        Some(peaks)
    }
}

/// Velocities \[m/s\] by theory at some heights, along one axis, every `dt` \[s\].
struct Predicted {
    velocity: Vec<Vec<f64>>,
    dt: f64,
}

impl Predicted {
    fn of(
        column: &LayeredColumn,
        heights: &[f64],
        wave: impl Fn(f64) -> f64,
        dt: f64,
        time: f64,
    ) -> Predicted {
        let mut found = column.velocities_at(heights, wave, dt, time);
        // Behind the run's last instant nothing counts.
        let rows = (time / dt * (1.0 + 1e-12)) as usize + 1;
        found.iter_mut().for_each(|v| v.truncate(rows));
        Predicted { velocity: found, dt }
    }

    /// Enters the peaks along an axis: displacements from velocities by the trapezoidal rule, accelerations between `rows` \[s\].
    fn fill(&self, peaks: &mut [Peaks], axis: usize, heights: &[f64], rows: f64) {
        let Predicted { velocity, dt } = self;
        let largest =
            |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, |most: f64, x| most.max(x.abs()));
        let way = |from: usize, to: usize| {
            let rate = move |k: usize| velocity[to][k] - velocity[from][k];
            (1..velocity[to].len()).scan(0.0, move |u, k| {
                *u += 0.5 * dt * (rate(k - 1) + rate(k));
                Some(*u)
            })
        };
        for (k, v) in velocity.iter().enumerate() {
            let at_row = |row: usize| {
                let place = row as f64 * rows / dt;
                let (before, part) = (place as usize, place.fract());
                Some((1.0 - part) * v.get(before)? + part * v.get(before + 1)?)
            };
            let between = |row: usize| Some((at_row(row)? - at_row(row - 1)?) / rows);
            let at = &mut peaks[k];
            at[axis] = largest(&mut way(0, k));
            at[VELOCITY + axis] = largest(&mut v.iter().copied());
            at[ACCELERATION + axis] = largest(&mut (1..).map_while(between));
            if k > 0 {
                at[MOTION + axis] = largest(&mut way(k - 1, k)) / (heights[k] - heights[k - 1]);
            }
        }
    }
}

impl DepthPeaks {
    /// Nothing where nothing is to be followed.
    pub fn new(setting: &Setting) -> Option<Self> {
        let Setting { model, plan, folder, steps, dt, .. } = *setting;
        let (model, folder) = (model.clone(), folder.clone());
        let depth = Depth::of(&model, plan)?;
        let row = steps.histories as f64 * dt;
        Some(DepthPeaks { schedule: setting.rows(), folder, model, row, depth })
    }
}

impl Observer for DepthPeaks {
    fn wants(&self) -> Wants {
        let nodes = Which::some(self.depth.nodes());
        Wants { steps: nodes.clone(), nodes, ..Wants::looks(self.schedule) }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.see(view, memory),
            Event::Step(step) => {
                self.stepped(step, memory);
                Ok(())
            }
            Event::End { time } => self.depth.write(&self.folder, &self.model, self.row, *time, memory),
            _ => Ok(()),
        }
    }
}

impl DepthPeaks {
    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let (time, last) = (view.snapshot.time, self.depth.kept(memory)[0]);
        // A last row that comes early says less of an acceleration than the others.
        let whole = view.snapshot.step.is_multiple_of(self.schedule.every);
        let nodes: Vec<usize> = self.depth.nodes().collect();
        for (node, kept) in nodes.into_iter().zip(self.depth.kept(memory)[1..].chunks_exact_mut(EACH)) {
            let v = view.snapshot.velocity[node].xyz();
            for i in 0..3 {
                // Before the first row there is none.
                let a = (v[i] - kept[i]) / (time - last);
                let peak = &mut kept[3 + ACCELERATION + i];
                *peak = match (last.is_nan(), whole) {
                    (true, _) => 0.0,
                    (false, true) => peak.max(a.abs()),
                    (false, false) => *peak,
                };
                kept[i] = v[i];
            }
        }
        self.depth.kept(memory)[0] = time;
        Ok(())
    }

    fn stepped(&mut self, step: &Stepped, memory: &mut Memory) {
        let moved = |node: usize| {
            let u = step.u[node].xyz();
            if step.datum.is_empty() { u } else { less(u, step.datum[node].xyz()) }
        };
        let count = self.depth.levels.len();
        let nodes: Vec<usize> = self.depth.nodes().collect();
        for (k, kept) in self.depth.kept(memory)[1..].chunks_exact_mut(EACH).enumerate() {
            let (node, level) = (nodes[k], k % count);
            // At times that the node, that below and the lowest have in common.
            if step.own([node, nodes[k - level.min(1)], nodes[k - level]]).is_none() {
                continue;
            }
            let u = moved(node);
            let v = step.du[node].xyz().map(|d| d / step.dt);
            let strain = match level {
                0 => [0.0; 3],
                _ => {
                    let height = self.depth.levels[level].z - self.depth.levels[level - 1].z;
                    less(u, moved(nodes[k - 1])).map(|d| d / height)
                }
            };
            for (at, values) in [(0, less(u, moved(nodes[k - level]))), (VELOCITY, v), (MOTION, strain)] {
                for (peak, value) in kept[3 + at..].iter_mut().zip(values) {
                    *peak = peak.max(value.abs());
                }
            }
        }
    }
}

fn less(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| a[i] - b[i])
}
