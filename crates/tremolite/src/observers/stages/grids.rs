//! stages/*.vtu, interfaces/stage-*.vtu and bolts/stage-*.vtu: the whole model at the end of each stage, with their lists.

use super::super::bolt_fields::BoltGrid;
use super::super::fields::FieldGrids;
use super::super::interfaces::InterfaceGrid;
use super::super::observer::{Event, Observer, Setting, StageSeen, Wants, Which};
use crate::error::RunError;
use crate::quantities::Field;
use std::path::Path;
use tremolite_engine::member::Kind;
use tremolite_engine::state::Memory;
use tremolite_laws::Row;
use tremolite_results::{Pvd, ResultFolder};

/// Motion to the initial equilibrium, in the file of that stage.
const INITIAL_MOTION: &str = "initial_motion";

/// Writes what stands at the end of a stage, with the motion of the last cycle where it was given up, which shows what falls.
pub struct StageGrids {
    /// Members that pairs and bolts are in.
    beside_elements: Which,
    folder: ResultFolder,
}

impl StageGrids {
    pub fn new(setting: &Setting) -> Self {
        let linked = |kind| matches!(kind, Kind::Pairs(_) | Kind::Bolts(_));
        StageGrids {
            beside_elements: Which::members(setting.assembly, linked),
            folder: setting.folder.clone(),
        }
    }

    fn write(&self, seen: &StageSeen, memory: &Memory) -> Result<(), RunError> {
        let StageSeen { stage, at_rest, ref view, u, start, last, .. } = *seen;
        let folder = make(self.folder.stage_fields())?;
        let grids = FieldGrids::of(view.model, view.phase, view.plan);
        // Displacements count from the initial equilibrium; what it took to get there is told beside them.
        let since_start = |(now, before): (&Row, &Row)| Row([0, 1, 2, 3].map(|i| now.0[i] - before.0[i]));
        let motion: Vec<Row> = u.iter().zip(start).map(since_start).collect();
        let more: &[(&str, &str, &[Row])] = match (at_rest, stage) {
            (true, 0) => &[(INITIAL_MOTION, "m", &motion)],
            (true, _) => &[],
            (false, _) => &[("motion_of_last_cycle", "m", last)],
        };
        let name = grids.write((&folder, &format!("{stage:03}")), stage as f64, (view, memory), more)?;
        list(&self.folder.stages_pvd(), stage, &format!("stages/{name}"))?;
        let name = format!("stage-{stage:03}.vtu");
        if view.plan.fields.contains(&Field::Interface) && !view.model.user_seams().is_empty() {
            let path = make(self.folder.interface_fields())?.join(&name);
            InterfaceGrid::of(view.model, view.phase.stage).write(&path, stage as f64, view)?;
            // The list begins anew with the earthquake.
            list(&self.folder.interfaces_pvd(), stage, &format!("interfaces/{name}"))?;
        }
        let bolts = BoltGrid::of(&view.model.bolts, view.phase.stage);
        if !bolts.is_empty() {
            bolts.write(&make(self.folder.bolt_fields())?.join(&name), stage as f64, view)?;
            list(&self.folder.bolts_pvd(), stage, &format!("bolts/{name}"))?;
        }
        Ok(())
    }
}

impl Observer for StageGrids {
    fn wants(&self) -> Wants {
        Wants {
            nodes: Which::All,
            elements: Which::All,
            members: self.beside_elements.clone(),
            ..Wants::default()
        }
    }

    fn told(&mut self, event: &Event, memory: &mut Memory) -> Result<(), RunError> {
        match event {
            Event::StageEnds(seen) => self.write(seen, memory),
            _ => Ok(()),
        }
    }
}

/// Makes a folder.
fn make(folder: std::path::PathBuf) -> Result<std::path::PathBuf, RunError> {
    match tremolite_files::make_folder(&folder) {
        Ok(()) => Ok(folder),
        Err(source) => Err(RunError::Io { path: folder, source }),
    }
}

/// Adds a stage's file to a list; one that a stopped run had written already is written again.
fn list(path: &Path, stage: usize, file: &str) -> Result<(), RunError> {
    let mut list = match path.exists() && stage > 0 {
        true => Pvd::resume(path, stage as f64 - 0.5)?,
        false => Pvd::create(path)?,
    };
    Ok(list.add(stage as f64, file)?)
}
