//! Scripts of a program.

use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use super::argument::Values;
use super::error::{in_call, report_dict};
use super::item::item;
use super::mesh::MeshTables;
use super::parameters::Parameters;
use super::program::{Program, Reduced};
use super::watch::Watcher;

/// The arguments of a script besides its parameters.
const OPTIONS: [&str; 2] = ["seed", "progress"];

// A script of a program. It has no doc comment: `__doc__` is that of the program.
#[pyclass(frozen, module = "hedgerow")]
pub struct Script {
    item: hedgerow::Script,
    program: Py<Program>,
    parameters: Parameters,
}

item! {Script, "script", options OPTIONS, result |_script| Some("hedgerow.Report"), {
    #[pyo3(signature = (mesh, /, *args, **kwargs))]
    fn __call__<'py>(
        &self,
        py: Python<'py>,
        mesh: &Bound<'py, MeshTables>,
        args: &Bound<'py, PyTuple>,
        kwargs: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (mut seed, mut progress) = (None, None);
        let [wanted, shown] = OPTIONS.map(|name| self.parameters.option(kwargs, name));
        if let Some(wanted) = wanted? {
            let wanted: i128 = wanted
                .extract()
                .map_err(|_| PyTypeError::new_err("`seed` wants a whole number"))?;
            let wanted = u64::try_from(wanted)
                .map_err(|_| PyValueError::new_err("`seed` is from 0 to 2**64 - 1"))?;
            seed = Some(wanted);
        }
        if let Some(shown) = shown? {
            let made = py.import("hedgerow._progress")?.getattr("progress")?;
            let made = made.call1((shown, self.item.name()))?;
            progress = (!made.is_none()).then(|| made.unbind());
        }
        let values = Values::new(&self.parameters, args, kwargs)?;
        let mut state = mesh.get().hold(py)?;
        let (session, script) = (&mut state.session, &self.item);
        session.use_program(script.program());
        if let Some(seed) = seed {
            session.seed(seed);
        }
        let mut watcher = Watcher::new(progress.as_ref().map(|progress| progress.clone_ref(py)));
        let looks_on = &mut watcher;
        let done = py.detach(move || session.run_watched(script, &values, looks_on));
        drop(state);
        if let Some(progress) =
            progress.filter(|made| made.bind(py).hasattr("close").unwrap_or(false))
        {
            progress.call_method0(py, "close")?;
        }
        match (watcher.raised(), done) {
            (Some(raised), _) => Err(raised),
            (None, Ok(report)) => report_dict(py, &report),
            (None, Err(error)) => Err(in_call(py, &error)),
        }
    }
}}
