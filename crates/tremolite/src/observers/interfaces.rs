//! interfaces.csv, and interfaces/*.vtu with interfaces.pvd: what opens and slides.

use super::RunTable;
use super::observer::{Event, Observer, Schedule, Setting, View, Wants, Which};
use crate::error::RunError;
use crate::quantities::{Field, INTERFACE};
use std::collections::BTreeMap;
use std::path::Path;
use tremolite_engine::Stage;
use tremolite_engine::assembly::Assembly;
use tremolite_engine::member::Kind;
use tremolite_engine::model::Model;
use tremolite_engine::state::Memory;
use tremolite_kernels::contact::PairSeen;
use tremolite_mesh::pairs::tangents;
use tremolite_mesh::vtu::{Array, Grid, Values};
use tremolite_results::{Column, Pvd, Subject};

/// Key of what this observer remembers: for each interface the largest size of its impact gain \[J\].
const MEMORY: &str = "interfaces";

/// Writes a row for all interfaces.
pub struct Interfaces {
    schedule: Schedule,
    pairs: Which,
    table: RunTable,
}

/// The members that pairs are in.
pub(super) fn pairs(assembly: &Assembly) -> Which {
    Which::members(assembly, |kind| matches!(kind, Kind::Pairs(_)))
}

/// The columns of interfaces.csv.
pub fn columns(model: &Model) -> Vec<Column> {
    let mut columns = vec![Column::new("time", "s")];
    for seam in model.user_seams() {
        let subject = Subject::Interface(seam.name.clone());
        columns.extend(INTERFACE.iter().map(|q| Column::of(subject.clone(), q.name, q.unit)));
    }
    columns
}

impl Interfaces {
    /// Starts the table, or goes on with it where the state left it; nothing without interfaces.
    ///
    /// # Errors
    /// If the file cannot be written, or is shorter than the state remembers.
    pub fn new(setting: &Setting) -> Result<Option<Self>, RunError> {
        if setting.model.user_seams().is_empty() {
            return Ok(None);
        }
        let table = RunTable::new(&setting.folder.interfaces(), &columns(setting.model), setting.memory)?;
        Ok(Some(Interfaces { schedule: setting.rows(), pairs: pairs(setting.assembly), table }))
    }

    /// The largest size \[J\] of what impacts of an interface found or lost, over all rows.
    pub fn largest_gain(memory: &Memory, interface: usize) -> f64 {
        memory.get(MEMORY).and_then(|kept| kept.get(interface)).copied().unwrap_or(f64::NAN)
    }
}

impl Observer for Interfaces {
    fn wants(&self) -> Wants {
        Wants { members: self.pairs.clone(), ..Wants::looks(self.schedule) }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.see(view, memory),
            _ => Ok(()),
        }
    }
}

impl Interfaces {
    fn see(&mut self, view: &View, memory: &mut Memory) -> Result<(), RunError> {
        let View { model, assembly, snapshot, history, .. } = *view;
        let (mut row, mut gains) = (vec![snapshot.time], Vec::new());
        for (seam, contacts) in model.user_seams().iter().zip(&assembly.contacts) {
            let totals = contacts.totals(seam, history.octets);
            row.extend(INTERFACE.iter().map(|q| (q.value)(&totals)));
            gains.push(totals.impact_gain.abs());
        }
        self.table.write(&row, memory)?;
        let mut kept = memory.remove(MEMORY).unwrap_or_else(|| vec![0.0; model.user_seams().len()]);
        for (most, now) in kept.iter_mut().zip(gains) {
            *most = if now.is_nan() { now } else { most.max(now) };
        }
        memory.insert(MEMORY.into(), kept);
        Ok(())
    }
}

/// Writes the pairs of all interfaces at some times.
pub struct InterfaceFields {
    schedule: Schedule,
    pairs: Which,
    folder: std::path::PathBuf,
    list: Pvd,
    grid: InterfaceGrid,
}

impl InterfaceFields {
    /// Starts the list of files, or goes on with it at the state's time; nothing if the plan wants none.
    ///
    /// # Errors
    /// If the list cannot be written or read.
    pub fn new(setting: &Setting) -> Result<Option<Self>, RunError> {
        let Setting { folder, model, plan, steps, .. } = *setting;
        let wanted = plan.fields.contains(&Field::Interface) && !model.user_seams().is_empty();
        let Some(every) = steps.snapshots.filter(|_| wanted) else { return Ok(None) };
        let list = if setting.step == 0 {
            Pvd::create(&folder.interfaces_pvd())?
        } else {
            // Files of the state's own time are written again.
            Pvd::resume(&folder.interfaces_pvd(), setting.time - 0.5 * setting.dt)?
        };
        let files = folder.interface_fields();
        tremolite_files::make_folder(&files)
            .map_err(|source| RunError::Io { path: files.clone(), source })?;
        let schedule = Schedule { every, last: Some(steps.total) };
        Ok(Some(InterfaceFields {
            schedule,
            pairs: pairs(setting.assembly),
            folder: files,
            list,
            grid: InterfaceGrid::of(model, Stage::Shaking),
        }))
    }
}

/// The faces of all interfaces, to be written with what their pairs do.
pub struct InterfaceGrid {
    /// A point for each pair, interface by interface, and for each closed end; a cell for each face.
    grid: Grid,
    /// Number of closed ends.
    ends: usize,
}

impl InterfaceGrid {
    /// Those that are there in a stage.
    pub fn of(model: &Model, stage: Stage) -> Self {
        let (grid, ends) = grid(model, stage);
        InterfaceGrid { grid, ends }
    }

    /// Writes a file.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write(&self, path: &Path, time: f64, view: &View) -> Result<(), RunError> {
        let View { model, assembly, history, .. } = *view;
        let mut seen: Vec<PairSeen> = Vec::new();
        let mut axes: Vec<[[f64; 3]; 2]> = Vec::new();
        for (seam, contacts) in model.user_seams().iter().zip(&assembly.contacts) {
            seen.extend((0..seam.pairs.len()).map(|k| contacts.seen(history.octets, k)));
            axes.extend(seam.pairs.iter().map(|pair| tangents(pair.normal)));
        }
        seen.resize(seen.len() + self.ends, PairSeen::default());
        axes.resize(seen.len(), [[0.0; 3]; 2]);
        let scalar = |name: &str, unit: &str, value: &dyn Fn(&PairSeen) -> f64| {
            Array::new(name, unit, 1, Values::Float32(seen.iter().map(|s| value(s) as f32).collect()))
        };
        let flags = |name: &str, value: &dyn Fn(&PairSeen) -> u8| {
            Array::new(name, "", 1, Values::UInt8(seen.iter().map(value).collect()))
        };
        let vector = |name: &str, unit: &str, value: &dyn Fn(&PairSeen) -> [f64; 2]| {
            let along = |(s, [e1, e2]): (&PairSeen, &[[f64; 3]; 2])| {
                let [a, b] = value(s);
                [0, 1, 2].map(|i| (a * e1[i] + b * e2[i]) as f32)
            };
            Array::new(name, unit, 3, Values::Float32(seen.iter().zip(&axes).flat_map(along).collect()))
        };
        let mut grid = self.grid.clone();
        grid.time = Some(time);
        grid.point_data.extend([
            scalar("gap", "m", &|s| s.gap),
            vector("slip", "m", &|s| s.slip),
            scalar("pressure", "Pa", &|s| s.pressure),
            vector("shear", "Pa", &|s| s.shear.map(|t| -t)),
            flags("state", &|s| s.state),
            flags("slid", &|s| u8::from(s.has_slid)),
            flags("opened", &|s| u8::from(s.has_opened)),
            scalar("gap_max", "m", &|s| s.largest_gap),
            scalar("slip_max", "m", &|s| s.largest_slip),
            scalar("pressure_max", "Pa", &|s| s.largest_pressure),
        ]);
        Ok(grid.write(path)?)
    }
}

/// Faces as polygons of their pairs. Where an interface ends, closed, or something holds its sides together, a corner has none:
/// there its node stands for one that does not move, behind all pairs; the second value is how many such points there are.
/// Faces of which a side does not stand are left out.
fn grid(model: &Model, stage: Stage) -> (Grid, usize) {
    let mut grid = Grid::default();
    let (mut interface, mut element, mut other) = (Vec::new(), Vec::new(), Vec::new());
    let (mut normals, mut areas) = (Vec::<f32>::new(), Vec::<f32>::new());
    let mut ends: BTreeMap<(usize, u32), u32> = BTreeMap::new();
    let pairs: usize = model.user_seams().iter().map(|seam| seam.pairs.len()).sum();
    for (s, seam) in model.user_seams().iter().enumerate() {
        let first = grid.points.len() as u32;
        let mut corners: Vec<Vec<(u8, u32)>> = vec![Vec::new(); seam.faces.len()];
        for (k, pair) in (0u32..).zip(&seam.pairs) {
            grid.points.push(seam.place(&model.mesh, k as usize));
            normals.extend(pair.normal.map(|x| x as f32));
            areas.push(pair.area as f32);
            for &(face, corner) in pair.corners.iter().filter(|_| seam.lives[k as usize].holds(stage)) {
                corners[face as usize].push((corner, first + k));
            }
        }
        let faces = seam.faces.iter().zip(&mut corners).zip(&seam.standing);
        let faces = faces.filter(|(_, standing)| standing.holds(stage));
        for (([a, b], corners), _) in faces {
            for (corner, node) in (0u8..).zip(model.mesh.face_nodes(*a)) {
                if corners.iter().all(|(known, _)| *known != corner) {
                    let next = (pairs + ends.len()) as u32;
                    corners.push((corner, *ends.entry((s, node)).or_insert(next)));
                }
            }
            corners.sort_unstable();
            grid.connectivity.extend(corners.iter().map(|(_, point)| point));
            grid.offsets.push(grid.connectivity.len() as u32);
            // VTK's numbers of a triangle and a quadrilateral.
            grid.types.push(if corners.len() == 3 { 5 } else { 9 });
            interface.push(s as i32);
            element.push(model.mesh.element_id(a.element as usize) as i64);
            other.push(model.mesh.element_id(b.element as usize) as i64);
        }
    }
    let mut closed: Vec<(u32, u32)> = ends.into_iter().map(|((_, node), point)| (point, node)).collect();
    closed.sort_unstable();
    grid.points.extend(closed.iter().map(|&(_, node)| model.mesh.nodes[node as usize]));
    normals.resize(3 * grid.points.len(), 0.0);
    areas.resize(grid.points.len(), 0.0);
    grid.point_data = vec![
        Array::new("normal", "", 3, Values::Float32(normals)),
        Array::new("area", "m2", 1, Values::Float32(areas)),
    ];
    let names = (0i32..).zip(model.user_seams()).map(|(s, seam)| {
        let marks = interface.iter().map(|&of| u8::from(of == s)).collect();
        Array::new(format!("interface:{}", seam.name), "", 1, Values::UInt8(marks))
    });
    let names: Vec<Array> = names.collect();
    grid.cell_data = vec![
        Array::new("interface", "", 1, Values::Int32(interface)),
        Array::new("element", "", 1, Values::Int64(element)),
        Array::new("other_element", "", 1, Values::Int64(other)),
    ];
    grid.cell_data.extend(names);
    (grid, closed.len())
}

impl Observer for InterfaceFields {
    fn wants(&self) -> Wants {
        Wants { members: self.pairs.clone(), ..Wants::looks(self.schedule) }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::Look(view) => self.see(view, memory),
            _ => Ok(()),
        }
    }
}

impl InterfaceFields {
    fn see(&mut self, view: &View, _: &mut Memory) -> Result<(), RunError> {
        let View { snapshot, .. } = *view;
        let name = format!("{:06}.vtu", snapshot.step.div_ceil(self.schedule.every));
        self.grid.write(&self.folder.join(&name), snapshot.time, view)?;
        self.list.add(snapshot.time, &format!("interfaces/{name}"))?;
        Ok(())
    }
}
