//! What a script gives beside a case: stress by element, loads, and forces of its own.

use crate::errors::unusable;
use crate::force::Force;
use indexmap::IndexMap;
use numpy::{PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use sha2::{Digest, Sha256};
use std::sync::Arc;
use tremolite::parts::loads::Load;
use tremolite::setup::Setup;
use tremolite_results::Input;

/// Stress before anything moves (elements, 6) [Pa] in place of the case's, and forces on nodes.
#[derive(Clone, Default)]
pub struct Fields {
    pub initial: Option<Vec<[f64; 6]>>,
    pub loads: Vec<History>,
    pub forces: Vec<Arc<Force>>,
    /// By material and parameter, `rock.young`.
    pub parameters: IndexMap<String, ByElement>,
}

/// A parameter of a material by element of the mesh, in SI; not a number where the case's own value stays.
#[derive(Clone)]
pub struct ByElement {
    pub values: Arc<[f64]>,
    /// Classes that it is sorted into at most.
    pub classes: usize,
}

/// Forces [N] on nodes, times a factor over time that is linear between its times [s] and goes on as it begins and ends.
#[derive(Clone)]
pub struct History {
    forces: Vec<(u32, [f64; 3])>,
    times: Arc<[f64]>,
    factors: Arc<[f64]>,
}

impl History {
    fn load(&self) -> Load {
        let (times, factors) = (self.times.clone(), self.factors.clone());
        Load { forces: self.forces.clone(), factor: Arc::new(move |t| interpolated(&times, &factors, t)) }
    }
}

fn interpolated(times: &[f64], factors: &[f64], t: f64) -> f64 {
    let next = times.partition_point(|&time| time <= t);
    if next == 0 || next == times.len() {
        return factors[next.min(times.len() - 1)];
    }
    let share = (t - times[next - 1]) / (times[next] - times[next - 1]);
    factors[next - 1] + share * (factors[next] - factors[next - 1])
}

impl Fields {
    /// Puts them into what a case asks for. They are named among its inputs by their bits.
    ///
    /// # Errors
    /// In words: where the case has no stress, or the mesh other elements or nodes.
    pub fn put(&self, setup: &mut Setup) -> Result<(), String> {
        if let Some(initial) = &self.initial {
            let elements = setup.problem.mesh.elements.len();
            if setup.plan.stages.is_empty() {
                return Err(
                    "the case seeks no equilibrium, so there is no initial stress; write [initial]".into()
                );
            }
            if initial.len() != elements {
                return Err(format!(
                    "initial_stress has {} rows, where the mesh has {elements} elements; begin with job.initial_stress",
                    initial.len()
                ));
            }
            setup.problem.initial.clone_from(initial);
            setup.inputs.push(named("initial stress", initial.iter().flatten()));
        }
        let nodes = setup.problem.mesh.nodes.len();
        for History { forces, times, factors } in &self.loads {
            if let Some((node, _)) = forces.iter().find(|(node, _)| *node as usize >= nodes) {
                return Err(format!(
                    "a load is on the node {node}, where the mesh has {nodes} before interfaces part it; name the node of the second side"
                ));
            }
            let numbers =
                forces.iter().flat_map(|(_, force)| force).chain(times.iter()).chain(factors.iter());
            setup.inputs.push(named("load", numbers));
        }
        setup.problem.loads.extend(self.loads.iter().map(History::load));
        for (name, ByElement { values, .. }) in &self.parameters {
            setup.inputs.push(named(&format!("{name} by element"), values.iter()));
        }
        for force in &self.forces {
            setup.inputs.push(named(&format!("force {}", force.name), force.numbers().iter()));
            setup.problem.parts.push(force.maker());
        }
        Ok(())
    }
}

fn named<'x>(name: &str, numbers: impl Iterator<Item = &'x f64>) -> Input {
    let mut bits = Sha256::new();
    numbers.for_each(|x| bits.update(x.to_bits().to_le_bytes()));
    let hash = bits.finalize().iter().map(|byte| format!("{byte:02x}")).collect();
    Input { name: name.to_owned(), path: String::new(), hash }
}

/// Stress of an array (elements, 6).
///
/// # Errors
/// If it has another shape, or is not finite.
pub fn stress_of(array: &Bound<'_, PyAny>) -> PyResult<Vec<[f64; 6]>> {
    let array = array.py().import("numpy")?.call_method1("asarray", (array, "float64"))?;
    let none = || {
        unusable("initial_stress is an array (elements, 6): xx, yy, zz, xy, yz, zx in Pa, tension positive")
    };
    let rows: PyReadonlyArray2<f64> = array.extract().map_err(|_| none())?;
    if rows.as_array().ncols() != 6 {
        return Err(none());
    }
    if let Some(e) = rows.as_array().rows().into_iter().position(|row| row.iter().any(|x| !x.is_finite())) {
        return Err(unusable(format!("initial_stress of element {e} is not finite; mend it")));
    }
    Ok(rows.as_array().rows().into_iter().map(|x| [x[0], x[1], x[2], x[3], x[4], x[5]]).collect())
}

/// A load, on a mesh of `count` nodes: nodes (n,), force (3,) or (n, 3) [N], times (m,) [s] and factors (m,).
///
/// # Errors
/// If a shape does not fit, a node is none, times do not grow, or a number is not finite.
pub fn load_of(given: &Bound<'_, PyAny>, count: usize) -> PyResult<History> {
    let form = "a load is (nodes (n,), force (3,) or (n, 3) in N, times (m,) in s, factors (m,))";
    let numpy = given.py().import("numpy")?;
    let parts: Vec<Bound<'_, PyAny>> = given.extract().map_err(|_| unusable(form))?;
    let [nodes, force, times, factors] = parts.as_slice() else { return Err(unusable(form)) };
    let nodes = array(&numpy, nodes, "int64")?;
    let shape = (nodes.len().map_err(|_| unusable(form))?, 3);
    let force = numpy
        .call_method1("broadcast_to", (array(&numpy, force, "float64")?, shape))
        .map_err(|_| unusable(form))?;
    let read = |of: Bound<'_, PyAny>| -> PyResult<Vec<f64>> {
        let column: PyReadonlyArray1<f64> = of.extract().map_err(|_| unusable(form))?;
        Ok(column.as_array().to_vec())
    };
    let (times, factors) =
        (read(array(&numpy, times, "float64")?)?, read(array(&numpy, factors, "float64")?)?);
    let nodes: PyReadonlyArray1<i64> = nodes.extract().map_err(|_| unusable(form))?;
    let force: PyReadonlyArray2<f64> = force.extract().map_err(|_| unusable(form))?;
    if times.is_empty() || times.len() != factors.len() {
        return Err(unusable(form));
    }
    if !times.is_sorted_by(|a, b| a < b) {
        return Err(unusable("the times of a load do not grow; sort them, each once"));
    }
    let mut forces = Vec::new();
    for (&node, force) in nodes.as_array().iter().zip(force.as_array().rows()) {
        match u32::try_from(node) {
            Ok(n) if (n as usize) < count => forces.push((n, [force[0], force[1], force[2]])),
            _ => return Err(unusable(format!("there is no node {node}: the mesh has {count}, from 0"))),
        }
    }
    let numbers = forces.iter().flat_map(|(_, force)| force).chain(&times).chain(&factors);
    if numbers.into_iter().any(|x| !x.is_finite()) {
        return Err(unusable("a load has numbers that are not finite; mend them"));
    }
    Ok(History { forces, times: times.into(), factors: factors.into() })
}

fn array<'py>(
    numpy: &Bound<'py, PyModule>,
    of: &Bound<'py, PyAny>,
    kind: &str,
) -> PyResult<Bound<'py, PyAny>> {
    numpy.call_method1("asarray", (of, kind))
}
