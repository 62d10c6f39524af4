//! Trials, which are undone at their end.
//!
//! They begin and end in native code: an interrupt reaches Python code only before or after that, so
//! none leaves a trial open that a `with` statement has begun.

use std::sync::{Mutex, MutexGuard, PoisonError};

use hedgerow::Mark;
use pyo3::prelude::*;
use pyo3::types::PyTuple;

use super::error::{Kind, saying};
use super::mesh::MeshTables;

/// What is done within is undone at the end, unless :meth:`keep` is called.
#[pyclass(frozen, module = "hedgerow")]
pub struct Trial {
    mesh: Py<MeshTables>,
    /// The state of the mesh at the beginning.
    mark: Mutex<Option<Mark>>,
}

#[pymethods]
impl Trial {
    #[new]
    fn new(mesh: Py<MeshTables>) -> Self {
        Self { mesh, mark: Mutex::default() }
    }

    fn __enter__(slf: Bound<'_, Self>) -> PyResult<Bound<'_, Self>> {
        let py = slf.py();
        let this = slf.get();
        if this.state().is_some() {
            return Err(unknown(py, "this trial has begun already"));
        }
        let mark = this.mesh.get().mark(py)?;
        *this.state() = Some(mark);
        Ok(slf)
    }

    #[pyo3(signature = (_error, /, *_others))]
    fn __exit__(
        &self,
        py: Python<'_>,
        _error: &Bound<'_, PyAny>,
        _others: &Bound<'_, PyTuple>,
    ) -> PyResult<bool> {
        self.is_ended_by(py, false)?;
        Ok(false)
    }

    /// Ends the trial, and those within: what was done stays.
    fn keep(&self, py: Python<'_>) -> PyResult<()> {
        self.end(py, true)
    }

    /// Ends the trial, and those within: the mesh is bit for bit what it was before.
    fn undo(&self, py: Python<'_>) -> PyResult<()> {
        self.end(py, false)
    }
}

impl Trial {
    fn state(&self) -> MutexGuard<'_, Option<Mark>> {
        self.mark.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn end(&self, py: Python<'_>, keeps: bool) -> PyResult<()> {
        match self.is_ended_by(py, keeps)? {
            true => Ok(()),
            false => Err(unknown(py, "this trial has not begun, or has ended")),
        }
    }

    /// Ends the trial; false if it has ended before, maybe by one that it is within.
    fn is_ended_by(&self, py: Python<'_>, keeps: bool) -> PyResult<bool> {
        let mark = self.state().take();
        mark.map_or(Ok(false), |mark| self.mesh.get().end_mark(py, mark, keeps))
    }
}

fn unknown(py: Python<'_>, message: &str) -> PyErr {
    saying(py, Kind::Run, "unknown-mark", message.to_owned())
}
