//! A case: read, changed, shown.

use crate::changes;
use crate::errors::{CaseError, Problem, refused};
use crate::mesh;
use crate::toml_dict;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use std::path::{Path, PathBuf};
use tremolite::job::Given;
use tremolite::setup::{Inputs, original_folder};
use tremolite_case as case;
use tremolite_laws::materials::MATERIALS;

/// A case file, checked. It is never changed: `with_` gives another.
///
/// `Case(path)` reads a file, `Case.from_text` and `Case.from_dict` take what a program holds. Files that the case names are looked
/// for by `Job`, so that they may be given in memory.
///
/// Raises `CaseError` with all problems at once.
#[pyclass(frozen, module = "tremolite")]
pub struct Case {
    pub case: case::Case,
}

impl Case {
    fn parse(py: Python<'_>, path: &Path, directory: &Path, text: &str) -> PyResult<Self> {
        match case::Case::parse_in(path, directory, text, &[], MATERIALS) {
            Ok(case) => Ok(Case { case }),
            Err(report) => Err(refused(py, &report)),
        }
    }

    /// What is given as a case: a case or the path of one.
    pub fn given(given: &Bound<'_, PyAny>) -> PyResult<case::Case> {
        if let Ok(case) = given.cast::<Case>() {
            return Ok(case.get().case.clone());
        }
        Ok(Case::new(given.py(), given.extract()?)?.case)
    }
}

#[pymethods]
impl Case {
    #[new]
    fn new(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let text = case::Case::text_of(&path).map_err(|report| refused(py, &report))?;
        let original = original_folder(&path);
        let directory = original.as_deref().or(path.parent()).unwrap_or(Path::new(""));
        Case::parse(py, &path, directory, &text)
    }

    /// A case from its text. Files that it names are looked for from `directory`.
    #[staticmethod]
    #[pyo3(signature = (text, directory = PathBuf::new()))]
    fn from_text(py: Python<'_>, text: &str, directory: PathBuf) -> PyResult<Self> {
        Case::parse(py, &directory.join("case.toml"), &directory, text)
    }

    /// A case from a dict with the keys of a case file. Numbers with a dimension are texts with their unit, `"10 GPa"`; with
    /// `units="SI"` bare ones are in SI, angles excepted.
    #[staticmethod]
    #[pyo3(signature = (case, directory = PathBuf::new(), *, units = None))]
    fn from_dict(case: &Bound<'_, PyDict>, directory: PathBuf, units: Option<&str>) -> PyResult<Self> {
        let py = case.py();
        let case = case.copy()?;
        if let Some(units) = units {
            case.set_item("units", units)?;
        }
        let text: String = py.import("tremolite._toml")?.call_method1("document", (case,))?.extract()?;
        Case::from_text(py, &text, directory)
    }

    /// The same case with other values by the paths of their keys: `{"material.rock.young": "25 GPa", "stage[*].release": 0.4}`.
    /// Entries of lists go by number, by name or all together: `stage[0]`, `stage[bench 1]`, `stage[*]`. A text is a text; lists and
    /// dicts are what they are in a case.
    fn with_(&self, changes: &Bound<'_, PyDict>) -> PyResult<Self> {
        let py = changes.py();
        match self.case.parse_with(&changes::of_dict(changes)?, MATERIALS) {
            Ok(case) => Ok(Case { case }),
            Err(report) => Err(refused(py, &report)),
        }
    }

    /// What the case is about.
    #[getter]
    fn title(&self) -> &str {
        &self.case.title.value
    }

    /// The case's text with its changes: what a run keeps as case.toml.
    #[getter]
    fn text(&self) -> &str {
        &self.case.source
    }

    /// The file as it was named.
    #[getter]
    fn path(&self) -> &Path {
        &self.case.path
    }

    /// The folder from which it names files.
    #[getter]
    fn directory(&self) -> &Path {
        &self.case.directory
    }

    /// What is allowed but hardly meant: a list of `Problem`.
    #[getter]
    fn warnings(&self) -> Vec<Problem> {
        Problem::all(&self.case.report(self.case.warnings.clone()))
    }

    /// Keys that were left out, with what is used in their place.
    #[getter]
    fn defaults<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let made = PyDict::new(py);
        for left_out in &self.case.defaulted {
            made.set_item(&left_out.key, &left_out.value)?;
        }
        Ok(made)
    }

    /// The files that it names, as they are written.
    #[getter]
    fn files(&self) -> Vec<&Path> {
        self.case.files().into_iter().map(|file| file.value.as_path()).collect()
    }

    /// The case as a dict of its keys, with its changes.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        match toml::de::DeTable::parse(&self.case.source) {
            Ok(table) => toml_dict::dict(py, table.get_ref()),
            Err(error) => Err(CaseError::new_err(error.to_string())),
        }
    }

    fn __repr__(&self) -> String {
        format!("Case({:?})", self.case.title.value)
    }

    fn _repr_html_(slf: &Bound<'_, Self>) -> PyResult<String> {
        slf.py().import("tremolite._notebook")?.call_method1("case", (slf,))?.extract()
    }

    fn __eq__(&self, other: &Self) -> bool {
        (&self.case.source, &self.case.directory) == (&other.case.source, &other.case.directory)
    }

    fn __hash__(&self) -> u64 {
        use std::hash::{DefaultHasher, Hash, Hasher};
        let mut hasher = DefaultHasher::new();
        self.case.source.hash(&mut hasher);
        hasher.finish()
    }

    /// So that it can be sent to another process.
    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let Case { case } = slf.get();
        let make = slf.get_type().getattr("_of")?;
        Ok((make, (&case.source, case.path.as_os_str(), case.directory.as_os_str()).into_pyobject(slf.py())?))
    }

    #[staticmethod]
    fn _of(py: Python<'_>, text: &str, path: PathBuf, directory: PathBuf) -> PyResult<Self> {
        Case::parse(py, &path, &directory, text)
    }

    /// The mesh that the case makes or reads, a `Mesh` in m, before its stages and interfaces are put into it.
    fn mesh<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        mesh::of_case(py, &self.case, &Inputs::default())
    }

    /// Its text with files by absolute paths, so that it can stand anywhere.
    fn _placed(&self) -> String {
        self.case.placed()
    }

    /// A number of a material in SI; none where the material has no such number.
    fn _number(&self, material: &str, key: &str) -> Option<f64> {
        let material = self.case.materials.iter().find(|one| one.name.value == material)?;
        match key {
            "density" => Some(material.density.value),
            key => material.parameters.optional(key),
        }
    }

    /// The JSON schema of case files, as a dict: for completion in editors.
    #[staticmethod]
    fn schema(py: Python<'_>) -> PyResult<Bound<'_, PyAny>> {
        let schema = case::schema(MATERIALS);
        py.import("json")?.call_method1("loads", (schema.to_string(),))
    }
}

/// What a program gives beside a case: nothing but other values at some keys.
pub fn changed(changes: Option<&Bound<'_, PyDict>>) -> PyResult<Given> {
    let changes = changes.map_or_else(|| Ok(Vec::new()), changes::of_dict)?;
    Ok(Given { changes, ..Given::default() })
}
