//! A case with all that is made of it, to be checked and run.

use crate::arrays::{column, rows};
use crate::away::{Desk, away, pool};
use crate::case::{Case, changed};
use crate::errors::{Problem, failed, unusable};
use crate::fields::{ByElement, Fields, load_of, stress_of};
use crate::force::Force;
use crate::made::Made;
use crate::mesh;
use crate::motion;
use crate::simulation::{Simulation, Wish};
use crate::watch::Every;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, PoisonError};
use tremolite::job::{Given, Remark};
use tremolite_case as case;

/// A case with its mesh, its records and its model, ready to be checked and run.
///
/// `case` is a `Case` or a path. What the case names comes from files, or from memory under the name that stands in the case:
/// `meshes={"site.msh": mesh}`, `records={"quake": motion}`, `bolts={"heads.csv": array (n, 6) of head and end [m]}`. Where it names
/// one mesh or one record alone, `mesh=` and `motion=` do without the name.
///
/// Everything that is wrong is said here, by `CaseError`; what is unusual is warned of by `CaseWarning`.
#[pyclass(frozen, module = "tremolite")]
pub struct Job {
    made: Mutex<Arc<Made>>,
}

impl Job {
    fn of(made: Made) -> Self {
        Job { made: Mutex::new(Arc::new(made)) }
    }

    fn made(&self) -> Arc<Made> {
        // Nothing panics while it holds this lock.
        self.made.lock().unwrap_or_else(PoisonError::into_inner).clone()
    }
}

#[pymethods]
impl Job {
    #[new]
    #[pyo3(signature = (case, *, mesh = None, motion = None, meshes = None, records = None, bolts = None, set = None, threads = None))]
    fn new(
        case: &Bound<'_, PyAny>,
        mesh: Option<&Bound<'_, PyAny>>,
        motion: Option<&Bound<'_, PyAny>>,
        meshes: Option<&Bound<'_, PyDict>>,
        records: Option<&Bound<'_, PyDict>>,
        bolts: Option<&Bound<'_, PyDict>>,
        set: Option<&Bound<'_, PyDict>>,
        threads: Option<usize>,
    ) -> PyResult<Self> {
        let py = case.py();
        let case = Case::given(case)?;
        let mut given = changed(set)?;
        let inputs = &mut given.inputs;
        for (name, mesh) in meshes.into_iter().flatten() {
            inputs.meshes.insert(name.extract()?, mesh::of_python(&mesh)?);
        }
        for (name, motion) in records.into_iter().flatten() {
            inputs.records.insert(name.extract()?, motion::of_python(&motion)?);
        }
        for (name, ends) in bolts.into_iter().flatten() {
            inputs.bolts.insert(name.extract()?, mesh::lines_of(&ends)?);
        }
        if let Some(mesh) = mesh {
            let case::Mesh::File(file) = &case.mesh else {
                return Err(unusable(
                    "the case makes its own mesh; for mesh= write [mesh.file] with path = \"memory\"",
                ));
            };
            inputs.meshes.insert(file.path.value.display().to_string(), mesh::of_python(mesh)?);
        }
        if let Some(motion) = motion {
            inputs.records.insert(only_record(&case)?, motion::of_python(motion)?);
        }
        Ok(Job::of(Made::build(py, &case, &given, Fields::default(), threads)?))
    }

    /// What the results are called where no folder is given.
    #[getter]
    fn name(&self) -> String {
        self.made().job.name()
    }

    /// The case that is run, with its changes.
    #[getter]
    fn case(&self) -> Case {
        Case { case: self.made().job.case.clone() }
    }

    /// All that is unusual: a list of `Problem`.
    #[getter]
    fn warnings(&self) -> Vec<Problem> {
        let job = &self.made().job;
        Problem::all(&job.case.report(job.warnings().cloned().collect()))
    }

    /// The text of what is unusual, as the command prints it.
    #[getter]
    fn remarks(&self) -> Vec<String> {
        self.made().job.remarks().iter().map(|remark: &Remark| remark.render(false)).collect()
    }

    /// The mesh of the model, a `Mesh`: nodes, elements and groups to which the arrays of looks belong. Where bodies touch by an
    /// interface, each side has nodes of its own.
    #[getter]
    fn mesh<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        mesh::to_python(py, &mesh::of_user(&self.made().job.model))
    }

    /// Stress (elements, 6) [Pa] of each element before anything moves, read-only; zeros where the case has none.
    #[getter]
    fn initial_stress<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let model = self.made().job.model.clone();
        let initial = &model.elements.initial;
        let own = model.user.elements;
        rows(py, if initial.is_empty() { vec![[0.0; 6]; own] } else { initial[..own].to_vec() })
    }

    /// The same job with other stress before anything moves, an array (elements, 6) [Pa] in the order of `mesh`, and with loads in the
    /// earthquake: each (nodes (n,), force (3,) or (n, 3) [N], times (m,) [s], factors (m,)), the force times a factor that is linear
    /// between its times. `forces` are `NodalForce`s, asked for in every step. What is left out stays as it is. The summary names all by their
    /// bits among the inputs.
    ///
    /// The case must seek equilibrium ([initial] or stages) for a stress; what is not in balance moves the ground in the first stage, as
    /// the checks of the run say.
    #[pyo3(signature = (*, initial_stress = None, loads = None, forces = None, threads = None))]
    fn with_fields(
        &self,
        py: Python<'_>,
        initial_stress: Option<&Bound<'_, PyAny>>,
        loads: Option<Vec<Bound<'_, PyAny>>>,
        forces: Option<Vec<Bound<'_, PyAny>>>,
        threads: Option<usize>,
    ) -> PyResult<Self> {
        let made = self.made();
        let mut fields = made.fields.clone();
        if let Some(stress) = initial_stress {
            fields.initial = Some(stress_of(stress)?);
        }
        if let Some(loads) = loads {
            let nodes = made.job.model.user.nodes;
            fields.loads = loads.iter().map(|load| load_of(load, nodes)).collect::<PyResult<_>>()?;
        }
        if let Some(forces) = forces {
            let job = &made.job;
            fields.forces = Vec::new();
            for force in &forces {
                let force = Force::read(force, &fields.forces, &job.model, &job.phase)?;
                fields.forces.push(Arc::new(force));
            }
        }
        Ok(Job::of(Made::build(py, &made.case, &made.given(), fields, threads)?))
    }

    /// A parameter of a material by element, `job.field("rock.young")`: `field[:]` gives its values in SI, `field[:] = values` sets them, in the
    /// order of `field.elements`. What is set divides the material into `classes` at most, equal in the logarithm; a field that has no more
    /// values than that is exact. See `by_element`.
    #[pyo3(signature = (name, *, classes = 16))]
    fn field<'py>(slf: &Bound<'py, Self>, name: &str, classes: usize) -> PyResult<Bound<'py, PyAny>> {
        let field = slf.py().import("tremolite._by_element")?.getattr("Field")?;
        field.call1((slf, name, classes))
    }

    /// The case before materials are divided, its mesh, without what stages make others of, and what is given of a parameter by element, if anything is.
    fn _field<'py>(
        &self,
        py: Python<'py>,
        name: &str,
    ) -> PyResult<(Case, Bound<'py, PyAny>, Option<Bound<'py, PyAny>>)> {
        let made = self.made();
        let given = made.fields.parameters.get(name).map(|given| column(py, given.values.to_vec()));
        let mesh = mesh::of_case(py, &made.case, &made.inputs)?;
        Ok((Case { case: made.case.clone() }, mesh, given.transpose()?))
    }

    /// Sets a parameter by element, and builds the job again.
    fn _set_field(&self, py: Python<'_>, name: String, values: Vec<f64>, classes: usize) -> PyResult<()> {
        let made = self.made();
        let mut fields = made.fields.clone();
        fields.parameters.insert(name, ByElement { values: values.into(), classes });
        let new = Made::build(py, &made.case, &made.given(), fields, None)?;
        *self.made.lock().unwrap_or_else(PoisonError::into_inner) = Arc::new(new);
        Ok(())
    }

    /// The step of the finest level [s].
    #[getter]
    fn dt(&self) -> f64 {
        self.made().job.dt
    }

    /// Steps of the finest level in the whole earthquake.
    #[getter]
    fn steps(&self) -> u64 {
        self.made().job.steps.total
    }

    /// What a run will take, as `tremolite check --json` gives it: a dict, numbers in SI. Times a step on `threads` threads.
    #[pyo3(signature = (*, threads = None))]
    fn check<'py>(&self, py: Python<'py>, threads: Option<usize>) -> PyResult<Bound<'py, PyAny>> {
        let pool = pool(threads)?;
        let made = self.made();
        let work = || serde_json::to_string(&made.job.check());
        let back = away(py, &pool, &Desk::default(), &AtomicBool::new(false), work)?;
        if let Some(interrupt) = back.interrupt {
            return Err(interrupt);
        }
        let text = back.result.map_err(failed)?;
        py.import("json")?.call_method1("loads", (text,))
    }

    /// Runs the case to its end in the folder `out` (`results/<name>`) and returns a `Result`.
    ///
    /// `resume` goes on from the folder's checkpoint, bit for bit; `overwrite` replaces results; `from_` begins with what another run
    /// had come to before its earthquake; `set` changes keys first, as `Case.with_`. `callback(look)` is called with a `Look` at the
    /// end of each stage and every `every` steps or `"0.05 s"` of the earthquake, by default with the rows of the histories; what it
    /// returns as False stops the run in good order. `progress(now)` is called with a dict some five times a second. Both run on the
    /// thread that called. A run that ends for a physical or numerical reason has results as well, of `status` "failed", and is warned of by
    /// `RunWarning`.
    ///
    /// Ctrl-C writes a checkpoint and raises `Stopped`. What a callback raises comes through once a checkpoint is written. Results do
    /// not depend on `threads`, nor on a callback that looks.
    #[pyo3(signature = (out = None, *, resume = false, overwrite = false, from_ = None, threads = None, set = None, callback = None,
        every = None, observers = Vec::new(), progress = None))]
    fn run<'py>(
        &self,
        py: Python<'py>,
        out: Option<PathBuf>,
        resume: bool,
        overwrite: bool,
        from_: Option<PathBuf>,
        threads: Option<usize>,
        set: Option<&Bound<'py, PyDict>>,
        callback: Option<Py<PyAny>>,
        every: Option<Every>,
        observers: Vec<Py<PyAny>>,
        progress: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let mut made = self.made();
        if set.is_some() {
            let Made { case, inputs, fields, .. } = &*made;
            let given = Given { inputs: inputs.clone(), ..changed(set)? };
            made = Arc::new(Made::build(py, case, &given, fields.clone(), threads)?);
        }
        let wish = Wish { out, resume, overwrite, from: from_, threads, callback, every, observers };
        Simulation::begin(py, &made, wish)?.run(py, progress)
    }

    /// A run that a script drives: see `Simulation`. What is given is as of `run`.
    #[pyo3(signature = (out = None, *, resume = false, overwrite = false, from_ = None, threads = None, callback = None, every = None,
        observers = Vec::new()))]
    fn start(
        &self,
        py: Python<'_>,
        out: Option<PathBuf>,
        resume: bool,
        overwrite: bool,
        from_: Option<PathBuf>,
        threads: Option<usize>,
        callback: Option<Py<PyAny>>,
        every: Option<Every>,
        observers: Vec<Py<PyAny>>,
    ) -> PyResult<Simulation> {
        let wish = Wish { out, resume, overwrite, from: from_, threads, callback, every, observers };
        let simulation = Simulation::begin(py, &self.made(), wish)?;
        if simulation.is_to_stop() {
            // Nobody holds it yet who could finish it. This raises what stopped it.
            simulation.finish(py)?;
        }
        Ok(simulation)
    }

    fn __repr__(&self) -> String {
        let made = self.made();
        format!(
            "Job({:?}, {} elements, {} steps)",
            made.case.title.value, made.job.model.user.elements, made.job.steps.total
        )
    }
}

/// The one name by which a case calls its records.
fn only_record(case: &case::Case) -> PyResult<String> {
    let Some(motion) = &case.motion else {
        return Err(unusable(
            "the case has no earthquake; for motion= write [motion] with kind and file = \"memory\"",
        ));
    };
    let mut names: Vec<String> = motion.files().iter().map(|file| file.value.display().to_string()).collect();
    names.sort_unstable();
    names.dedup();
    match names.as_slice() {
        [name] => Ok(name.clone()),
        names => Err(unusable(format!(
            "the case names the records {}; give records={{name: motion}} in place of motion=",
            names.join(", ")
        ))),
    }
}
