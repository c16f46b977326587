//! bolts/*.vtu with bolts.pvd: the segments of all bolts as lines.

use super::bolts::bolts;
use super::observer::{Event, Observer, Schedule, Setting, View, Wants, Which};
use crate::error::RunError;
use crate::quantities::over_yield;
use crate::support::{Look, look};
use std::path::{Path, PathBuf};
use tremolite_engine::Stage;
use tremolite_engine::bolts::{BoltPoint, BoltSet, SegmentSeen};
use tremolite_engine::state::Memory;
use tremolite_mesh::vtu::{Array, Grid, Values};
use tremolite_results::Pvd;

/// Writes the bolts when field files are written.
pub struct BoltFields {
    schedule: Schedule,
    nodes: Which,
    bolts: Which,
    folder: PathBuf,
    list: Pvd,
    grid: BoltGrid,
}

impl BoltFields {
    /// Starts the list of files, or goes on with it at the state's time; nothing without bolts or field files.
    ///
    /// # Errors
    /// If the list cannot be written or read.
    pub fn new(setting: &Setting) -> Result<Option<Self>, RunError> {
        let Setting { folder, model, steps, .. } = *setting;
        let grid = BoltGrid::of(&model.bolts, Stage::Shaking);
        let Some(every) = steps.snapshots.filter(|_| !grid.is_empty()) else { return Ok(None) };
        let list = if setting.step == 0 {
            Pvd::create(&folder.bolts_pvd())?
        } else {
            // Files of the state's own time are written again.
            Pvd::resume(&folder.bolts_pvd(), setting.time - 0.5 * setting.dt)?
        };
        let files = folder.bolt_fields();
        tremolite_files::make_folder(&files)
            .map_err(|source| RunError::Io { path: files.clone(), source })?;
        let schedule = Schedule { every, last: Some(steps.total) };
        let points = model.bolts.iter().flat_map(|set| &set.bolts).flat_map(|bolt| &bolt.points);
        let nodes = points.flat_map(|point| &point.weights);
        Ok(Some(BoltFields {
            schedule,
            nodes: Which::some(nodes.map(|(node, _)| model.engine_node[*node as usize] as usize)),
            bolts: bolts(setting.assembly),
            folder: files,
            list,
            grid,
        }))
    }
}

impl Observer for BoltFields {
    fn wants(&self) -> Wants {
        Wants { nodes: self.nodes.clone(), members: self.bolts.clone(), ..Wants::looks(self.schedule) }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.see(view, memory),
            _ => Ok(()),
        }
    }
}

impl BoltFields {
    fn see(&mut self, view: &View, _: &mut Memory) -> Result<(), RunError> {
        let View { snapshot, .. } = *view;
        let name = format!("{:06}.vtu", snapshot.step.div_ceil(self.schedule.every));
        self.grid.write(&self.folder.join(&name), snapshot.time, view)?;
        self.list.add(snapshot.time, &format!("bolts/{name}"))?;
        Ok(())
    }
}

/// The segments of all bolts, to be written with what they do.
pub struct BoltGrid {
    /// A point for each of the bolts', bolt by bolt; a line for each segment.
    grid: Grid,
    /// Which bolts: of a set of the model, of that set.
    bolts: Vec<(usize, usize)>,
}

impl BoltGrid {
    /// Those that are placed up to a stage.
    pub fn of(sets: &[BoltSet], stage: Stage) -> Self {
        let mut all = BoltGrid { grid: Grid::default(), bolts: Vec::new() };
        let (mut from_head, mut group, mut number) = (Vec::new(), Vec::new(), Vec::new());
        for (s, set) in sets.iter().enumerate().filter(|(_, set)| set.kind.born <= stage) {
            for (b, bolt) in set.bolts.iter().enumerate() {
                let first = all.grid.points.len() as u32;
                all.grid.points.extend(bolt.points.iter().map(|point| point.place));
                from_head.extend(bolt.points.iter().map(|point| point.at as f32));
                for segment in &bolt.segments {
                    all.grid.connectivity.extend(segment.points.map(|p| first + p));
                    all.grid.offsets.push(all.grid.connectivity.len() as u32);
                    // VTK's number of a line.
                    all.grid.types.push(3);
                    group.push(s as i32);
                    number.push(bolt.bar as i32 + 1);
                }
                all.bolts.push((s, b));
            }
        }
        // Of every group, so that numbers of groups are those of the model in every file.
        let marks = |(s, set): (i32, &BoltSet)| {
            let marks = group.iter().map(|&of| u8::from(of == s)).collect();
            Array::new(format!("group:{}", set.kind.name), "", 1, Values::UInt8(marks))
        };
        let marks: Vec<Array> = (0i32..).zip(sets).map(marks).collect();
        all.grid.point_data = vec![Array::new("from_head", "m", 1, Values::Float32(from_head))];
        all.grid.cell_data = vec![
            Array::new("group", "", 1, Values::Int32(group)),
            Array::new("bolt", "", 1, Values::Int32(number)),
        ];
        all.grid.cell_data.extend(marks);
        all
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.grid.types.is_empty()
    }

    /// Bytes of a file before compression: of what has a pattern, and of what has none.
    pub fn bytes(&self) -> (u64, u64) {
        let (points, lines) = (self.grid.points.len() as u64, self.grid.types.len() as u64);
        let groups = self.grid.cell_data.len() as u64 - 2;
        // Distances from the head; ends, where they end, type, group, bolt, marks. Places, which go round a cavern, and
        // displacements; seven numbers and the state.
        let pattern = 4 * points + (16 + 8 + 1 + 4 + 4 + groups) * lines;
        (pattern, (24 + 12) * points + (7 * 4 + 1) * lines)
    }

    /// Arrays of a file, those of its cells and points included.
    pub fn arrays(&self) -> u64 {
        // Places, ends of cells, their offsets and types; displacements and eight of what segments do.
        (self.grid.point_data.len() + self.grid.cell_data.len()) as u64 + 4 + 9
    }

    /// Writes a file.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write(&self, path: &Path, time: f64, view: &View) -> Result<(), RunError> {
        let View { model, assembly, snapshot, numbers, .. } = *view;
        let displacement = |point: &BoltPoint| {
            let mut u = [0.0; 3];
            for &(node, weight) in &point.weights {
                let row = snapshot.displacement[model.engine_node[node as usize] as usize].xyz();
                (0..3).for_each(|i| u[i] += weight * row[i]);
            }
            u
        };
        let grid = self.filled(&model.bolts, &look(assembly, numbers), displacement);
        Ok(Grid { time: Some(time), ..grid }.write(path)?)
    }

    /// With what segments do, and the displacements \[m\] of their ends.
    pub(crate) fn filled(
        &self,
        sets: &[BoltSet],
        look: &Look,
        displacement: impl Fn(&BoltPoint) -> [f64; 3],
    ) -> Grid {
        let (mut seen, mut moved) = (Vec::with_capacity(self.grid.types.len()), Vec::new());
        for &(s, b) in &self.bolts {
            let bolt = &sets[s].bolts[b];
            moved.extend(bolt.points.iter().flat_map(&displacement).map(|x| x as f32));
            let of_bolt = look(s, b);
            debug_assert_eq!(of_bolt.len(), bolt.segments.len());
            seen.extend(of_bolt);
        }
        seen.resize(self.grid.types.len(), SegmentSeen::default());
        let scalar = |name: &str, unit: &str, value: &dyn Fn(&SegmentSeen) -> f64| {
            Array::new(name, unit, 1, Values::Float32(seen.iter().map(|s| value(s) as f32).collect()))
        };
        let mut grid = self.grid.clone();
        grid.point_data.push(Array::new("displacement", "m", 3, Values::Float32(moved)));
        grid.cell_data.extend([
            scalar("force", "N", &|s| s.force),
            scalar("force_over_yield", "", &|s| over_yield(s.force, s)),
            scalar("slip", "m", &|s| s.slip),
            scalar("plastic_strain", "", &|s| s.plastic_strain),
            Array::new("state", "", 1, Values::UInt8(seen.iter().map(|s| s.state as u8).collect())),
            scalar("force_max", "N", &|s| s.largest_force),
            scalar("force_over_yield_max", "", &|s| over_yield(s.largest_force, s)),
            scalar("slip_max", "m", &|s| s.largest_slip),
        ]);
        grid
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantities::BOLT_LINES;
    use crate::support::tests::{set, under};
    use tremolite_engine::bolts::SegmentState;
    use tremolite_results::BoltLines;

    #[test]
    fn segments_are_lines_with_what_they_do_and_come_back_as_they_were_written() {
        let sets = [
            set("later", 1, Stage::Shaking, 4e8),
            set("empty", 0, Stage::Before(0), 4e8),
            set("crown", 2, Stage::Before(1), 4e8),
        ];
        assert!(BoltGrid::of(&sets, Stage::Before(0)).is_empty());
        let lines = BoltGrid::of(&sets, Stage::Before(1));
        let look = |set: usize, bolt: usize| {
            assert_eq!(set, 2, "the others are not there");
            let mut all = vec![under(-1e5 * bolt as f64); 3];
            all[2].state = SegmentState::CutOff;
            all[1].largest_slip = 1e-3;
            all
        };
        let displacement = |point: &BoltPoint| {
            point.weights.iter().fold([0.0; 3], |u, (n, w)| [u[0] + w * f64::from(*n), 0.0, 1.0])
        };
        let grid = lines.filled(&sets, &look, displacement);
        grid.check().unwrap();
        assert!(grid.types.iter().all(|kind| *kind == 3) && grid.types.len() == 6);
        assert_eq!(grid.point_array("displacement").unwrap().values.get(3), 0.75);
        for quantity in BOLT_LINES {
            let array = grid.cell_array(quantity.name).or_else(|| grid.point_array(quantity.name));
            assert_eq!(array.map(|a| a.unit.as_str()), Some(quantity.unit), "{}", quantity.name);
        }
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.vtu");
        grid.write(&path).unwrap();
        let read = BoltLines::read(&path).unwrap();
        assert_eq!(read.groups, ["later", "empty", "crown"]);
        let line = &read.lines[4];
        assert_eq!((line.group, line.bolt, line.ends), (2, 2, [[1.0, 0.0, 1.0], [1.0, 0.0, 2.0]]));
        assert_eq!((line.force, line.force_over_yield, line.force_over_yield_max), (-1e5, 0.5, 0.5));
        assert!((line.slip_max - 1e-3).abs() < 1e-9 && line.at == [1.0, 2.0] && line.state == 0);
        assert_eq!(read.lines[5].state, 4);
    }
}
