//! Forces of a script's own on nodes, as a part of the model: asked for once a step, with a declared bound for the stable step.

use crate::arrays::rows;
use crate::away::{Asker, asker};
use crate::errors::unusable;
use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::exceptions::PyKeyboardInterrupt;
use pyo3::prelude::*;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use tremolite::parts::{Entry, Motion, Own, Part, Scratch, StateSizes, Tick};
use tremolite::problem::MakePart;
use tremolite::{Life, Line, Lines, Member, Model, Phase, Stage};
use tremolite_laws::Row;
use tremolite_mesh::Mesh;

/// A `tremolite.NodalForce`, read.
pub struct Force {
    pub name: String,
    /// Nodes of the mesh of the model.
    pub nodes: Vec<u32>,
    /// At most so much force a displacement \[N/m\], and a velocity \[N s/m\].
    pub stiffness: f64,
    pub damping: f64,
    /// Numbers that it remembers.
    remembers: usize,
    object: Py<PyAny>,
}

impl Force {
    /// Reads an object with `nodes`, `forces` and its rates.
    ///
    /// # Errors
    /// If one of them is missing or none that can be used: nodes that are not there in the earthquake, no rate.
    pub fn read(
        object: &Bound<'_, PyAny>,
        others: &[Arc<Force>],
        model: &Model,
        phase: &Phase,
    ) -> PyResult<Self> {
        let class = object.get_type().name()?.to_string();
        let given = |name: &str| -> PyResult<Option<Bound<'_, PyAny>>> {
            Ok(object.getattr_opt(name)?.filter(|value| !value.is_none()))
        };
        if !object.hasattr("forces")? || object.is_instance_of::<pyo3::types::PyType>() {
            return Err(unusable(format!(
                "{class} has no method forces(self, t, u, v); forces are objects: forces=[Damper()]"
            )));
        }
        let name: String = given("name")?.map_or(Ok(class.clone()), |name| name.extract())?;
        let taken = |name: &str| others.iter().any(|other| other.name == name);
        if taken(&name) {
            return Err(unusable(format!("two forces are called {name:?}; give one another `name`")));
        }
        let rate = |name: &str, unit: &str| -> PyResult<Option<f64>> {
            let Some(value) = given(name)? else { return Ok(None) };
            match value.extract::<f64>() {
                Ok(rate) if rate >= 0.0 && rate.is_finite() => Ok(Some(rate)),
                _ => Err(unusable(format!("{class}.{name} is a number of {unit}, 0 or more"))),
            }
        };
        let rates = (rate("stiffness", "N/m")?, rate("damping", "N s/m")?);
        let (None, None) = rates else {
            let (stiffness, damping) = (rates.0.unwrap_or(0.0), rates.1.unwrap_or(0.0));
            let remembers = given("remembers")?.map_or(Ok(0), |n| n.extract())?;
            let nodes = nodes_of(given("nodes")?, &class, model, phase)?;
            return Ok(Force { name, nodes, stiffness, damping, remembers, object: object.clone().unbind() });
        };
        Err(unusable(format!(
            "{class} declares no rate, by which the step is chosen; say how much it changes at most: stiffness = … N/m, damping = … N s/m, \
             or stiffness = 0 where it goes by time alone"
        )))
    }

    /// What makes its part.
    pub fn maker(self: &Arc<Self>) -> MakePart {
        let force = self.clone();
        Arc::new(move |_: &Mesh, engine_node: &[u32]| {
            let engine = |&n: &u32| engine_node.get(n as usize).copied().unwrap_or(u32::MAX);
            let nodes = force.nodes.iter().map(engine).collect();
            let part = Box::new(Pushes { force: force.clone(), nodes });
            Member { life: Life::SHAKING, line: Some(Line::Own), ..Member::new(force.name.clone(), part) }
        })
    }

    /// Its bits: nodes and rates.
    pub fn numbers(&self) -> Vec<f64> {
        let nodes = self.nodes.iter().map(|&n| f64::from(n));
        nodes.chain([self.stiffness, self.damping, self.remembers as f64]).collect()
    }

    /// Asks the script: forces (n, 3) \[N\], and what it then remembers.
    fn ask(
        &self,
        py: Python<'_>,
        asker: &Asker,
        time: f64,
        motion: [&[[f64; 3]]; 2],
        memory: &[f64],
    ) -> PyResult<(Vec<[f64; 3]>, Vec<f64>)> {
        let numpy = py.import("numpy")?;
        let call = || -> PyResult<(Bound<'_, PyAny>, Option<Bound<'_, PyAny>>)> {
            let [u, v] = motion;
            let (u, v) = (rows(py, u.to_vec())?, rows(py, v.to_vec())?);
            if self.remembers == 0 {
                return Ok((self.object.bind(py).call_method1("forces", (time, u, v))?, None));
            }
            let own = numpy.call_method1("array", (memory.to_vec(),))?;
            Ok((self.object.bind(py).call_method1("forces", (time, u, v, &own))?, Some(own)))
        };
        let (said, own) = match call() {
            // The step needs its forces all the same, before the run can stop.
            Err(error) if error.is_instance_of::<PyKeyboardInterrupt>(py) => {
                asker.stop.store(true, Ordering::Relaxed);
                asker.desk.raise(error);
                call()?
            }
            called => called?,
        };
        let count = self.nodes.len();
        let said = numpy.call_method1("asarray", (&said, "float64"))?;
        let wrong = |shape: &Bound<'_, PyAny>| {
            unusable(format!(
                "{}.forces gave an array of the shape {shape}; give ({count}, 3): a force [N] a node",
                self.name
            ))
        };
        let shape = said.getattr("shape")?;
        let whole = numpy.call_method1("broadcast_to", (&said, (count, 3))).map_err(|_| wrong(&shape))?;
        let whole: PyReadonlyArray2<f64> = whole.extract().map_err(|_| wrong(&shape))?;
        let forces: Vec<[f64; 3]> =
            whole.as_array().rows().into_iter().map(|row| [row[0], row[1], row[2]]).collect();
        if let Some(k) = forces.iter().position(|force| force.iter().any(|f| !f.is_finite())) {
            return Err(unusable(format!(
                "{}.forces gave what is not finite at node {} and t = {time} s",
                self.name, self.nodes[k]
            )));
        }
        let memory = match own {
            None => Vec::new(),
            Some(own) => own.extract::<PyReadonlyArray1<f64>>()?.as_array().to_vec(),
        };
        Ok((forces, memory))
    }
}

/// Nodes of a force, each there in the earthquake.
fn nodes_of(
    given: Option<Bound<'_, PyAny>>,
    class: &str,
    model: &Model,
    phase: &Phase,
) -> PyResult<Vec<u32>> {
    let form = || unusable(format!("{class}.nodes is an array (n,) of nodes of job.mesh, each once"));
    let given = given.ok_or_else(form)?;
    let numpy = given.py().import("numpy")?;
    let nodes = numpy.call_method1("asarray", (given, "int64")).map_err(|_| form())?;
    let nodes: PyReadonlyArray1<i64> = nodes.extract().map_err(|_| form())?;
    let count = model.user.nodes;
    let mut all = Vec::new();
    for &node in nodes.as_array() {
        let n = u32::try_from(node).ok().filter(|&n| (n as usize) < count);
        let n =
            n.ok_or_else(|| unusable(format!("there is no node {node}: the mesh has {count}, from 0")))?;
        let engine = model.engine_node[n as usize];
        let moves = engine != u32::MAX && phase.mass[phase.master[engine as usize] as usize] > 0.0;
        if !moves {
            return Err(unusable(format!(
                "node {node} of {class} belongs to nothing that is there in the earthquake"
            )));
        }
        all.push(n);
    }
    let mut sorted = all.clone();
    sorted.sort_unstable();
    sorted.dedup();
    if all.is_empty() || sorted.len() < all.len() {
        return Err(form());
    }
    Ok(all)
}

/// A force as a part. It remembers where its nodes were as the earthquake began, its last forces, for the work between two steps, and what
/// the script has it remember.
struct Pushes {
    force: Arc<Force>,
    nodes: Vec<u32>,
}

impl Pushes {
    fn scaled(&self, by: f64, w: &[Row], out: &mut [Row]) {
        for (&node, out) in self.nodes.iter().zip(out) {
            *out = Row(w[node as usize].0.map(|w| by * w));
        }
    }
}

impl Part for Pushes {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    fn state_sizes(&self) -> StateSizes {
        StateSizes { numbers: 6 * self.nodes.len() + self.force.remembers, ..StateSizes::default() }
    }

    fn enter(&self, entry: &Entry, own: Own) {
        if entry.stage == Stage::Shaking {
            for (&node, began) in self.nodes.iter().zip(own.numbers.chunks_exact_mut(3)) {
                began.copy_from_slice(&entry.u[node as usize].xyz());
            }
        }
    }

    fn forces(&self, tick: &Tick, x: &Motion, own: Own, out: &mut [Row], _: &mut Scratch) -> Lines {
        // At rest before the earthquake there is none, and nobody to ask where a step is only timed.
        let asker = asker().filter(|_| tick.dt > 0.0 && tick.time >= 0.0);
        let Some(asker) = asker else {
            out.fill(Row::ZERO);
            return Lines::default();
        };
        let (began, rest) = own.numbers.split_at_mut(3 * self.nodes.len());
        let (last, memory) = rest.split_at_mut(3 * self.nodes.len());
        let mut u = Vec::with_capacity(self.nodes.len());
        let mut du = Vec::with_capacity(self.nodes.len());
        for (&node, began) in self.nodes.iter().zip(began.chunks_exact(3)) {
            let now = x.u[node as usize].xyz();
            u.push([0, 1, 2].map(|i| now[i] - began[i]));
            du.push(x.increment(node).xyz());
        }
        let v: Vec<[f64; 3]> = du.iter().map(|du| du.map(|d| d / tick.dt)).collect();
        let (force, time, before, here) = (self.force.clone(), tick.time, memory.to_vec(), asker.clone());
        let said = asker.desk.ask(move |py| {
            force.ask(py, &here, time, [&u, &v], &before).map_err(|raised| {
                here.stop.store(true, Ordering::Relaxed);
                here.desk.raise(raised);
            })
        });
        let Some(Ok((forces, after))) = said else {
            // What follows is no motion: the guard lets nothing of it into a checkpoint.
            out.fill(Row([f64::NAN; 4]));
            return Lines::default();
        };
        let mut work = Lines::default();
        for (((force, last), du), out) in forces.iter().zip(last.chunks_exact_mut(3)).zip(&du).zip(out) {
            for i in 0..3 {
                work[Line::Own] -= 0.5 * (force[i] + last[i]) * du[i];
            }
            last.copy_from_slice(force);
            *out = Row::new(force.map(|f| -f));
        }
        memory.copy_from_slice(&after);
        work
    }

    fn stiffness_times(&self, w: &[Row], out: &mut [Row], _: &mut Scratch) {
        self.scaled(self.force.stiffness, w, out);
    }

    fn viscosity_times(&self, w: &[Row], out: &mut [Row], _: &mut Scratch) -> bool {
        if self.force.damping > 0.0 {
            self.scaled(self.force.damping, w, out);
        }
        self.force.damping > 0.0
    }
}
