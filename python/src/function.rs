//! Functions of a program.

use hedgerow::Values as Found;
use numpy::PyArray1;
use pyo3::IntoPyObjectExt;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use super::argument::Values;
use super::error::in_call;
use super::item::item;
use super::mesh::MeshTables;
use super::op::value;
use super::parameters::Parameters;
use super::program::{Program, Reduced};
use super::watch::Watcher;

// A function of a program: of one element a value, of all an array by their numbers. It has no doc comment: `__doc__` is that of the program.
#[pyclass(frozen, module = "hedgerow")]
pub struct Function {
    item: hedgerow::Function,
    program: Py<Program>,
    parameters: Parameters,
}

/// Numbers as an array of rows, or of matrices; of a single value without the first dimension.
pub fn shaped<'py>(
    py: Python<'py>,
    numbers: Vec<f64>,
    width: usize,
    single: bool,
) -> PyResult<Bound<'py, PyAny>> {
    let array = PyArray1::from_vec(py, numbers).into_any();
    py.import("hedgerow._arrays")?.getattr("shaped")?.call1((array, width, single))
}

item! {Function, "fn", options [], result |function| function.item.result(), {
    #[pyo3(signature = (mesh, /, *args, **kwargs))]
    fn __call__<'py>(
        &self,
        py: Python<'py>,
        mesh: &Bound<'py, MeshTables>,
        args: &Bound<'py, PyTuple>,
        kwargs: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let values = Values::new(&self.parameters, args, kwargs)?;
        let mut state = mesh.get().hold(py)?;
        let (session, function) = (&mut state.session, &self.item);
        session.use_program(function.program());
        let mut watcher = Watcher::new(None);
        if self.parameters.first_free(&values).is_none() {
            let looks_on = &mut watcher;
            let done = py.detach(move || session.call_watched(function, &values, looks_on));
            return match (watcher.raised(), done) {
                (Some(raised), _) => Err(raised),
                (None, Err(error)) => Err(in_call(py, &error)),
                (None, Ok(Some(found))) => value(py, found),
                (None, Ok(None)) => Ok(py.None().into_bound(py)),
            };
        }
        let looks_on = &mut watcher;
        let found = py.detach(move || session.values(function, &values, looks_on));
        let found = match (watcher.raised(), found) {
            (Some(raised), _) => return Err(raised),
            (None, Err(error)) => return Err(in_call(py, &error)),
            (None, Ok(found)) => found,
        };
        Ok(match found {
            Found::Bool(all) => PyArray1::from_vec(py, all).into_any(),
            Found::Int(all) => PyArray1::from_vec(py, all).into_any(),
            Found::Real(all) => PyArray1::from_vec(py, all).into_any(),
            Found::Reals(width, all) => shaped(py, all, width, false)?,
            Found::Text(all) => all.into_bound_py_any(py)?,
            Found::Element(_, all) => {
                let numbers = all.into_iter().map(|one| one.map_or(-1, i64::from)).collect();
                PyArray1::from_vec(py, numbers).into_any()
            }
        })
    }
}}
