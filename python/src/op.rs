//! Operations.

use hedgerow::mesh::Element;
use hedgerow::{Argument, Outcome, Verdict};
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList, PyTuple};

use super::argument::Values;
use super::array::values;
use super::error::{Kind, in_call, saying};
use super::item::item;
use super::live::LiveMask;
use super::mesh::MeshTables;
use super::outcome::{Applied, Refused};
use super::parameters::Parameters;
use super::program::{Program, Reduced};

/// The marks of an element at which an operation would be applied, and of one that is none.
const APPLIES: i64 = -1;
const GONE: i64 = -2;

// An operation of a program: applied whole, or not at all. It has no doc comment: `__doc__` is that of the program.
#[pyclass(frozen, module = "hedgerow")]
pub struct Op {
    item: hedgerow::Op,
    program: Py<Program>,
    parameters: Parameters,
}

item! {Op, "op", options [], result |_op| Some("hedgerow.Applied | hedgerow.Refused"), {
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
        let session = &mut state.session;
        session.use_program(self.item.program());
        match session.apply(&self.item, &values) {
            Ok(Outcome::Applied(result)) => {
                let result = result.map(|element| element.index);
                Applied::new(result, session).into_bound_py_any(py)
            }
            Ok(Outcome::Refused(reason)) => Refused::new(reason).into_bound_py_any(py),
            Err(error) => Err(in_call(py, &error)),
        }
    }

    /// Applies the operation at one element after the other: `elements` are numbers for its first
    /// parameter that is an element and not given, or a bool for each number. The answer tells where
    /// it was applied; an element that has gone meanwhile counts as refused. What was applied before
    /// an exception stays: `applied` of the exception is what the answer was until then.
    #[pyo3(signature = (mesh, elements, /, *args, **kwargs))]
    fn each<'py>(
        &self,
        py: Python<'py>,
        mesh: &Bound<'py, MeshTables>,
        elements: &Bound<'py, PyAny>,
        args: &Bound<'py, PyTuple>,
        kwargs: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyArray1<bool>>> {
        let mut given = Values::new(&self.parameters, args, kwargs)?;
        let Some((at, kind)) = self.parameters.first_free(&given) else {
            let message = format!("`{}` has no parameter left that is an element", self.item.name());
            return Err(saying(py, Kind::Argument, "wrong-argument", message));
        };
        let capacity = mesh.get().hold(py)?.session.mesh().capacity(kind) as i64;
        let numbers = py.import("hedgerow._arrays")?.getattr("numbers")?;
        let elements = numbers.call1((elements, kind.name(), capacity))?;
        let elements: PyReadonlyArray1<'_, i64> = elements.extract()?;
        let elements = values(&elements)?;
        if let Some(wrong) = elements.iter().find(|&&one| one < 0 || one >= capacity) {
            let message = format!("there is no {kind} {wrong}");
            return Err(saying(py, Kind::Argument, "wrong-argument", message));
        }
        let mut state = mesh.get().hold(py)?;
        let session = &mut state.session;
        session.use_program(self.item.program());
        let (op, parameters) = (&self.item, &self.parameters);
        let (applied, done) = py.detach(move || {
            let mut applied = vec![false; elements.len()];
            let mut places = elements.iter().zip(&mut applied);
            let done = places.try_for_each(|(&number, applied)| {
                let element = Element { kind, index: number as u32 };
                if session.is_alive(element) {
                    given.put(parameters, at, element.into());
                    *applied = session.apply(op, &given)?.is_applied();
                }
                Ok::<_, hedgerow::Error>(())
            });
            (applied, done)
        });
        let applied = PyArray1::from_vec(py, applied);
        match done {
            Ok(()) => Ok(applied),
            Err(error) => {
                let raised = in_call(py, &error);
                // An exception of someone else, which ended it by a signal, may take no attribute.
                let _ = raised.value(py).setattr("applied", applied);
                Err(raised)
            }
        }
    }

    /// Whether the operation would be applied; nothing is written. Without an element: a bool for
    /// each, by number. With `near=`, which is what an action on the mesh gave, only what may have
    /// changed since the last such question is asked anew; the answer is the same. A parameter of
    /// the operation that is called `near` is meant rather.
    #[pyo3(
        signature = (mesh, /, *args, **kwargs),
        text_signature = "($self, mesh, /, *args, near=None, **kwargs)"
    )]
    fn can<'py>(
        &self,
        py: Python<'py>,
        mesh: &Bound<'py, MeshTables>,
        args: &Bound<'py, PyTuple>,
        kwargs: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let near = self.parameters.option(kwargs, "near")?;
        let values = Values::new(&self.parameters, args, kwargs)?;
        let mut state = mesh.get().hold(py)?;
        state.session.use_program(self.item.program());
        let raised = |error: hedgerow::Error| in_call(py, &error);
        if self.parameters.first_free(&values).is_none() {
            return state.session.can(&self.item, &values).map_err(raised)?.into_bound_py_any(py);
        }
        let is_outcome = |near: &Bound<'py, PyAny>| {
            near.is_instance_of::<Applied>() || near.is_instance_of::<Refused>()
        };
        if near.as_ref().is_some_and(|near| !is_outcome(near)) {
            return Err(PyTypeError::new_err("`near` wants what an action gave: Applied or Refused"));
        }
        if near.is_some() && values.is_empty() {
            let mask = state.near(&self.item).map_err(raised)?;
            let mask = state.session.kept_mask(mask).map_err(raised)?;
            return Ok(PyArray1::from_slice(py, mask).into_any());
        }
        let (session, op) = (&mut state.session, &self.item);
        let mask = py.detach(|| session.mask(op, &values)).map_err(raised)?;
        Ok(PyArray1::from_vec(py, mask).into_any())
    }

    /// The reason why the operation would refuse: a text, or `None` if it would not. Without an
    /// element: for each the number of the reason among `reasons`, -1 where it would be applied,
    /// and -2 where there is no element.
    #[pyo3(signature = (mesh, /, *args, **kwargs))]
    fn why<'py>(
        &self,
        py: Python<'py>,
        mesh: &Bound<'py, MeshTables>,
        args: &Bound<'py, PyTuple>,
        kwargs: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let values = Values::new(&self.parameters, args, kwargs)?;
        let mut state = mesh.get().hold(py)?;
        state.session.use_program(self.item.program());
        let raised = |error: hedgerow::Error| in_call(py, &error);
        let (session, op) = (&mut state.session, &self.item);
        if self.parameters.first_free(&values).is_none() {
            let reason = session.why(op, &values).map_err(raised)?;
            return reason.map(|reason| reason.text.to_string()).into_bound_py_any(py);
        }
        let verdicts = py.detach(|| session.verdicts(op, &values)).map_err(raised)?;
        let number = |verdict: Verdict| match verdict {
            Verdict::Gone => GONE,
            Verdict::Applies => APPLIES,
            Verdict::Refuses(reason) => reason as i64,
        };
        Ok(PyArray1::from_vec(py, verdicts.into_iter().map(number).collect()).into_any())
    }

    /// A mask that is kept current: after an action only what it may have changed is asked anew.
    #[pyo3(signature = (mesh, /, *args, **kwargs))]
    fn live<'py>(
        &self,
        py: Python<'py>,
        mesh: &Bound<'py, MeshTables>,
        args: &Bound<'py, PyTuple>,
        kwargs: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<LiveMask> {
        let values = Values::new(&self.parameters, args, kwargs)?;
        let mut state = mesh.get().hold(py)?;
        let session = &mut state.session;
        session.use_program(self.item.program());
        let kept = session.keep_mask(&self.item, &values).map_err(|error| in_call(py, &error))?;
        Ok(LiveMask::new(mesh.clone().unbind(), kept))
    }

    /// The reason why the operation may refuse; different numbers may have the same text.
    #[getter]
    fn reasons(&self) -> Vec<String> {
        self.item.reasons().iter().map(|reason| reason.to_string()).collect()
    }

    /// The level of the meshes that it is for: `map`, `surface` or `simple`.
    #[getter]
    fn level(&self) -> String {
        self.item.level().to_string()
    }

    /// The kind of the element that it returns, if it does.
    #[getter]
    fn result(&self) -> Option<&'static str> {
        self.item.result().map(|kind| kind.name())
    }

    /// The picture of the operation, before and after.
    fn diagram<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let drawn = py.detach(|| Ok((self.item.svg()?, self.item.drawn()?)));
        let (svg, text) = drawn.map_err(|error: hedgerow::Error| in_call(py, &error))?;
        let class = py.import("hedgerow._pictures")?.getattr("Diagram")?;
        class.call1((self.item.name(), svg, text))
    }

    fn _repr_svg_(&self, py: Python<'_>) -> Option<String> {
        py.detach(|| self.item.svg()).ok()
    }

    /// The proof of the operation: its level, the levels that it keeps, and for each rule what
    /// is kept, how the numbers of elements change, and what it costs.
    fn check<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let verdict = self.item.proved();
        let all = PyDict::new(py);
        all.set_item("op", &verdict.op)?;
        all.set_item("level", self.item.level().to_string())?;
        let keeps: Vec<String> = self.item.keeps().iter().map(ToString::to_string).collect();
        all.set_item("keeps", keeps)?;
        let rules = PyList::empty(py);
        for rule in &verdict.rules {
            let told = PyDict::new(py);
            told.set_item("rule", &rule.rule)?;
            told.set_item("cases", rule.cases)?;
            told.set_item("keeps", &rule.keeps)?;
            let counts = PyDict::new(py);
            for (name, constant, per_index) in rule.counts() {
                counts.set_item(name, (constant, per_index))?;
            }
            told.set_item("changes", counts)?;
            told.set_item("constant_time", rule.constant_time)?;
            told.set_item("grows_with", &rule.grows_with)?;
            let tests = rule.guard.as_ref().map(|guard| guard.tests.clone());
            told.set_item("guard_tests", tests)?;
            rules.append(told)?;
        }
        all.set_item("rules", rules)?;
        let steps = verdict.steps.as_ref().map(|steps| steps.calls.clone());
        all.set_item("calls", steps)?;
        py.import("hedgerow._pictures")?.getattr("Proof")?.call1((all,))
    }
}}

/// A value as an object of Python.
pub fn value<'py>(py: Python<'py>, value: Argument) -> PyResult<Bound<'py, PyAny>> {
    match value {
        Argument::Bool(value) => value.into_bound_py_any(py),
        Argument::Int(value) => value.into_bound_py_any(py),
        Argument::Real(value) => value.into_bound_py_any(py),
        Argument::Text(value) => value.into_bound_py_any(py),
        Argument::Element(_, number) => number.into_bound_py_any(py),
        Argument::Reals(_, numbers) => {
            let width = numbers.len();
            super::function::shaped(py, numbers, width, true)
        }
    }
}
