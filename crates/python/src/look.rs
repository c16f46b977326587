//! What is seen of a run at one time.

use crate::arrays::{column, rows};
use crate::errors::unusable;
use crate::record;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::sync::{Arc, Mutex, PoisonError};
use tremolite::history::History;
use tremolite::phase::ElementSlot;
use tremolite::point_stress::mean;
use tremolite::{Assembly, Model, Phase, Snapshot};
use tremolite_case::pattern::matches;
use tremolite_laws::{Octet, Row};
use tremolite_results::own_table::OwnRow;

/// What is there to be seen: shared, and the same for all looks of a stage or of the shaking.
#[derive(Clone)]
pub struct Scene {
    pub model: Arc<Model>,
    pub assembly: Arc<Assembly>,
    pub phase: Arc<Phase>,
}

/// What is seen of a run at one time. It is a copy: it stays as it is while the run goes on, and its arrays live as long as
/// anybody holds them. They are float64 and read-only.
///
/// Nodes and elements are those of `Job.mesh`, in its order. Stress is positive in tension, with the components xx, yy, zz, xy, yz, zx.
#[pyclass(frozen, module = "tremolite")]
pub struct Look {
    scene: Scene,
    snapshot: Snapshot,
    history: Vec<Octet>,
    stage: Option<String>,
    memory: Option<Py<PyDict>>,
    /// Rows of tables of the script's own.
    rows: Mutex<Vec<OwnRow>>,
}

impl Look {
    /// `stage` is none while the ground shakes; `memory` that of a callback.
    pub fn new(
        scene: Scene,
        snapshot: Snapshot,
        history: Vec<Octet>,
        stage: Option<String>,
        memory: Option<Py<PyDict>>,
    ) -> Self {
        Look { scene, snapshot, history, stage, memory, rows: Mutex::default() }
    }

    /// The rows that were recorded with it; none are left.
    pub fn take_rows(&self) -> Vec<OwnRow> {
        // Nothing panics while it holds this lock.
        std::mem::take(&mut *self.rows.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// An array (nodes, 3) in the order of the user's mesh, of one in that of the engine; NaN at nodes of void elements alone.
    fn nodal<'py>(&self, py: Python<'py>, values: &[Row]) -> PyResult<Bound<'py, PyAny>> {
        let model = &self.scene.model;
        let of = |&node: &u32| values.get(node as usize).map_or([f64::NAN; 3], Row::xyz);
        rows(py, model.engine_node[..model.user.nodes].iter().map(of).collect())
    }

    /// The elements of some groups that are there, each once, in the order of the mesh, with the places of their points.
    fn slots(&self, groups: &Groups) -> PyResult<Vec<(u32, ElementSlot)>> {
        let Scene { model, phase, .. } = &self.scene;
        let wanted = groups.elements(&model.mesh)?;
        let own = wanted.into_iter().take_while(|&e| (e as usize) < model.user.elements);
        Ok(own.filter_map(|e| Some((e, phase.element_slot[e as usize]?))).collect())
    }

    fn points(&self, slot: &ElementSlot) -> &[[f64; 6]] {
        &self.snapshot.stress[slot.point as usize..][..slot.points as usize]
    }
}

/// Groups as a script gives them: a pattern or several; all elements where it gives none.
#[derive(FromPyObject)]
pub enum Groups {
    One(String),
    Several(Vec<String>),
}

impl Groups {
    /// Elements of the mesh that are in one of the groups, ascending.
    ///
    /// # Errors
    /// Where a pattern fits no group.
    pub fn elements(&self, mesh: &tremolite_mesh::Mesh) -> PyResult<Vec<u32>> {
        let patterns = match self {
            Groups::One(pattern) => std::slice::from_ref(pattern),
            Groups::Several(patterns) => patterns,
        };
        let mut elements = Vec::new();
        for pattern in patterns {
            let found = mesh.groups.iter().filter(|(name, _)| matches(pattern, name));
            let before = elements.len();
            found.for_each(|(_, group)| elements.extend(group));
            if elements.len() == before {
                let names: Vec<&str> = mesh.groups.keys().map(String::as_str).collect();
                return Err(unusable(format!(
                    "no group is called {pattern:?}; there are {}",
                    names.join(", ")
                )));
            }
        }
        elements.sort_unstable();
        elements.dedup();
        Ok(elements)
    }
}

impl Default for Groups {
    fn default() -> Self {
        Groups::One("*".into())
    }
}

#[pymethods]
impl Look {
    /// Time since the earthquake began [s].
    #[getter]
    fn time(&self) -> f64 {
        self.snapshot.time
    }

    /// Steps since then.
    #[getter]
    fn step(&self) -> u64 {
        self.snapshot.step
    }

    /// The stage before the earthquake that has ended or goes on; None while the ground shakes.
    #[getter]
    fn stage(&self) -> Option<&str> {
        self.stage.as_deref()
    }

    /// Displacement (nodes, 3) [m]: since the initial equilibrium, or since the earthquake began.
    #[getter]
    fn displacement<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.nodal(py, &self.snapshot.displacement)
    }

    /// Velocity (nodes, 3) [m/s].
    #[getter]
    fn velocity<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.nodal(py, &self.snapshot.velocity)
    }

    /// Acceleration (nodes, 3) [m/s²].
    #[getter]
    fn acceleration<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.nodal(py, &self.snapshot.acceleration)
    }

    /// Elements (n,) of some groups that are there now, ascending: indices into the mesh. `groups` is a pattern such as
    /// `"*.lining"` or several; left out, all elements.
    #[pyo3(signature = (groups = Groups::default()), text_signature = "($self, groups='*')")]
    fn elements<'py>(&self, py: Python<'py>, groups: Groups) -> PyResult<Bound<'py, PyAny>> {
        column(py, self.slots(&groups)?.into_iter().map(|(e, _)| i64::from(e)).collect())
    }

    /// The element (points,) of each point at which `stress` and `history` give values.
    #[pyo3(signature = (groups = Groups::default()), text_signature = "($self, groups='*')")]
    fn points_of<'py>(&self, py: Python<'py>, groups: Groups) -> PyResult<Bound<'py, PyAny>> {
        let slots = self.slots(&groups)?;
        let of =
            |&(e, ref slot): &(u32, ElementSlot)| std::iter::repeat_n(i64::from(e), slot.points as usize);
        column(py, slots.iter().flat_map(of).collect())
    }

    /// Stress (points, 6) [Pa] at the points of the elements of some groups, element after element.
    #[pyo3(signature = (groups = Groups::default()), text_signature = "($self, groups='*')")]
    fn stress<'py>(&self, py: Python<'py>, groups: Groups) -> PyResult<Bound<'py, PyAny>> {
        let slots = self.slots(&groups)?;
        rows(py, slots.iter().flat_map(|(_, slot)| self.points(slot)).copied().collect())
    }

    /// Mean stress (elements, 6) [Pa] over each element of some groups, in the order of `elements`.
    #[pyo3(signature = (groups = Groups::default()), text_signature = "($self, groups='*')")]
    fn mean_stress<'py>(&self, py: Python<'py>, groups: Groups) -> PyResult<Bound<'py, PyAny>> {
        let slots = self.slots(&groups)?;
        rows(py, slots.iter().map(|(_, slot)| mean(&slot.places, self.points(slot))).collect())
    }

    /// What the laws of some groups remember, by name, with the unit.
    #[pyo3(signature = (groups = Groups::default()), text_signature = "($self, groups='*')")]
    fn columns<'py>(&self, py: Python<'py>, groups: Groups) -> PyResult<Bound<'py, PyDict>> {
        let history = History::new(&self.scene.assembly, &self.history);
        let columns = PyDict::new(py);
        for (_, slot) in self.slots(&groups)? {
            for column in history.columns(&slot) {
                columns.set_item(column.name, column.unit)?;
            }
        }
        Ok(columns)
    }

    /// What laws remember (points,) under a name of `columns`, in the order of `points_of`; NaN in elements whose law has no such
    /// column.
    #[pyo3(signature = (groups, name))]
    fn history<'py>(&self, py: Python<'py>, groups: Groups, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let history = History::new(&self.scene.assembly, &self.history);
        let slots = self.slots(&groups)?;
        // Of what is not there yet nothing is remembered.
        let mut found = slots.is_empty();
        let mut values = Vec::new();
        for (_, slot) in slots {
            match history.named(&slot, name) {
                Some(at) => {
                    found = true;
                    values.extend(history.values(&slot, at));
                }
                None => values.extend(std::iter::repeat_n(f64::NAN, slot.points as usize)),
            }
        }
        if found {
            return column(py, values);
        }
        let there = self.columns(py, groups)?.keys();
        Err(unusable(format!("no law there remembers {name:?}; there are {there}")))
    }

    /// The energy balance [J], a value for each line of energy.csv.
    #[getter]
    fn energy<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let lines = PyDict::new(py);
        for (line, value) in self.snapshot.balance.iter() {
            lines.set_item(line.name(), value)?;
        }
        Ok(lines)
    }

    /// Of a callback: a dict of its own, from name to array (n,) of float64, that it may fill and that is part of the checkpoint.
    /// None of a look of `Simulation.look`.
    #[getter]
    fn memory<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyDict>> {
        self.memory.as_ref().map(|memory| memory.bind(py).clone())
    }

    /// Adds a row to a table of the script's own, `own/NAME.csv` among the results: `now.record("roof", {"u [m]": u, "cracked": n})`. The
    /// keys head its columns, with their units, behind the time [s], which comes by itself (0 in the stages); an array (n,) makes n
    /// columns, `u0 [m]` and so on. All rows of a table have the same columns. A resumed run goes on behind its checkpoint, so no row is
    /// twice or missing. `Result.own` reads them.
    fn record(&self, name: &str, values: &Bound<'_, PyDict>) -> PyResult<()> {
        if self.memory.is_none() {
            return Err(unusable(
                "a look of Simulation.look is no part of the run, whose checkpoint would not know of it; record in a callback or an observer",
            ));
        }
        let row = record::row(name, self.snapshot.time, values)?;
        self.rows.lock().unwrap_or_else(PoisonError::into_inner).push(row);
        Ok(())
    }

    fn __repr__(&self) -> String {
        match &self.stage {
            Some(stage) => format!("<look at the stage {stage:?}>"),
            None => format!("<look at t = {} s, step {}>", self.snapshot.time, self.snapshot.step),
        }
    }
}
