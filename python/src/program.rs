//! Programs.

use std::path::{Path, PathBuf};

use hedgerow::mesh::FileFormat;
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::{PyAttributeError, PyKeyError};
use pyo3::gc::{PyTraverseError, PyVisit};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};

use super::error::{Kind, diagnostics, in_program, saying};
use super::function::Function;
use super::op::Op;
use super::script::Script;

/// The form that `pickle` takes: a maker, and its arguments.
pub type Reduced<'py, A> = PyResult<(Bound<'py, PyAny>, A)>;

// A program that is proved and compiled: its operations, scripts and functions are attributes. It
// has no doc comment: `__doc__` is that of its file and of what it has.
#[pyclass(frozen, module = "hedgerow")]
pub struct Program {
    program: hedgerow::Program,
    /// The items that have been asked for, by name.
    known: Py<PyDict>,
}

impl Program {
    fn of(
        py: Python<'_>,
        program: Result<hedgerow::Program, hedgerow::Error>,
        path: Option<&Path>,
    ) -> PyResult<Self> {
        let program = program.map_err(|error| in_program(py, &error, path))?;
        Ok(Self { program, known: PyDict::new(py).unbind() })
    }

    /// The item of a name: a script before an operation before a function.
    fn find<'py>(this: &Bound<'py, Self>, name: &str) -> PyResult<Option<Bound<'py, PyAny>>> {
        let py = this.py();
        let me = this.get();
        let known = me.known.bind(py);
        if let Some(found) = known.get_item(name)? {
            return Ok(Some(found));
        }
        let owner = || this.clone().unbind();
        let found = if let Ok(script) = me.program.script(name) {
            Script::new(script, owner()).into_bound_py_any(py)?
        } else if let Ok(op) = me.program.op(name) {
            Op::new(op, owner()).into_bound_py_any(py)?
        } else if let Ok(function) = me.program.function(name) {
            Function::new(function, owner()).into_bound_py_any(py)?
        } else {
            return Ok(None);
        };
        known.set_item(name, &found)?;
        Ok(Some(found))
    }

    fn names(&self) -> Vec<String> {
        let ops = self.program.ops().map(|op| op.name().to_owned());
        let scripts = self.program.scripts().map(|script| script.name().to_owned());
        let functions = self.program.functions().map(|function| function.name().to_owned());
        let mut names: Vec<_> = ops.chain(scripts).chain(functions).collect();
        names.sort();
        names.dedup();
        names
    }

    fn told(&self, name: &str) -> String {
        let error = self.program.op(name).map(drop).err();
        let message = error.map(|error| error.message().to_owned()).unwrap_or_default();
        message.replace("operation", "operation, script or function")
    }
}

#[pymethods]
impl Program {
    /// The program of a text, or of files: names and texts, the program itself first.
    #[staticmethod]
    #[pyo3(name = "_parse")]
    fn parse(py: Python<'_>, name: &str, text: &str) -> PyResult<Self> {
        let program = py.detach(|| hedgerow::Program::parse(name, text));
        Self::of(py, program, None)
    }

    #[staticmethod]
    #[pyo3(name = "_read")]
    fn read(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        if path.extension().is_some() && FileFormat::of(&path).is_ok() {
            let path = path.display();
            let message = format!("`{path}` is a mesh, not a program: `Mesh.load` reads meshes");
            return Err(saying(py, Kind::File, "bad-file", message));
        }
        let program = py.detach(|| hedgerow::Program::load(&path));
        Self::of(py, program, Some(&path))
    }

    /// The program of texts that were those of another one.
    #[staticmethod]
    #[pyo3(name = "_rebuild")]
    fn rebuild(py: Python<'_>, texts: Vec<(String, String)>) -> PyResult<Self> {
        let program = py.detach(|| hedgerow::Program::from_texts(&texts));
        Self::of(py, program, None)
    }

    /// Names and texts of all its files, the program itself first.
    fn texts(&self) -> Vec<(String, String)> {
        self.program.texts()
    }

    /// The name of its file, or the one that it was given.
    #[getter]
    fn name(&self) -> String {
        self.program.texts().swap_remove(0).0
    }

    /// The warnings about it, as dictionaries.
    #[getter]
    fn warnings<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        diagnostics(py, self.program.warnings(), self.program.sources())
    }

    /// The names of its operations, in order.
    #[getter]
    fn ops(&self) -> Vec<String> {
        self.program.ops().map(|op| op.name().to_owned()).collect()
    }

    /// The names of its scripts, in order.
    #[getter]
    fn scripts(&self) -> Vec<String> {
        self.program.scripts().map(|script| script.name().to_owned()).collect()
    }

    /// The names of its functions, in order.
    #[getter]
    fn functions(&self) -> Vec<String> {
        self.program.functions().map(|function| function.name().to_owned()).collect()
    }

    fn __getattr__<'py>(this: &Bound<'py, Self>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let found = Self::find(this, name)?;
        found.ok_or_else(|| PyAttributeError::new_err(this.get().told(name)))
    }

    fn __getitem__<'py>(this: &Bound<'py, Self>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let found = Self::find(this, name)?;
        found.ok_or_else(|| PyKeyError::new_err(this.get().told(name)))
    }

    fn __contains__(this: &Bound<'_, Self>, name: &str) -> PyResult<bool> {
        Ok(Self::find(this, name)?.is_some())
    }

    fn __dir__(this: &Bound<'_, Self>) -> PyResult<Vec<String>> {
        let own = this.get_type().dir()?;
        let mut names: Vec<String> = own.extract()?;
        names.extend(this.get().names());
        Ok(names)
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> Reduced<'py, (Vec<(String, String)>,)> {
        let rebuild = py.import("hedgerow._programs")?.getattr("rebuild")?;
        Ok((rebuild, (self.program.texts(),)))
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| {
            let other = other.get();
            std::ptr::eq(self, other) || self.program.texts() == other.program.texts()
        })
    }

    fn __hash__(&self) -> usize {
        self.program.texts().iter().map(|(_, text)| text.len()).sum()
    }

    fn __traverse__(&self, visit: PyVisit<'_>) -> Result<(), PyTraverseError> {
        visit.call(&self.known)
    }

    /// What the file says of itself, then its scripts and operations, each with its comment.
    #[getter]
    fn __doc__(this: &Bound<'_, Self>) -> PyResult<String> {
        let me = this.get();
        let text = me.program.texts().swap_remove(0).1;
        let lines = text.lines().map_while(|line| line.strip_prefix("//!"));
        let mut told = vec![lines.map(str::trim_start).collect::<Vec<_>>().join("\n")];
        for name in me.scripts().into_iter().chain(me.ops()) {
            if let Some(item) = Self::find(this, &name)? {
                told.push(item.getattr("__doc__")?.extract()?);
            }
        }
        if let functions @ [_, ..] = &*me.functions() {
            told.push(format!("Functions: {}", functions.join(", ")));
        }
        told.retain(|part| !part.is_empty());
        Ok(told.join("\n\n"))
    }

    fn __repr__(&self) -> String {
        format!("<program {}>", self.name())
    }
}

/// The errors and warnings of a text, as dictionaries; none if it is sound and proved.
#[pyfunction]
pub fn check_text<'py>(py: Python<'py>, name: &str, text: &str) -> PyResult<Bound<'py, PyList>> {
    match py.detach(|| hedgerow::Program::parse(name, text)) {
        Ok(program) => diagnostics(py, program.warnings(), program.sources()),
        Err(error) => diagnostics(py, error.diagnostics(), error.sources()),
    }
}
