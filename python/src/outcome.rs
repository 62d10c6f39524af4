//! Results of calls of operations.

use hedgerow::mesh::Element;
use hedgerow::{Reason, Session};
use pyo3::prelude::*;
use pyo3::types::PyType;

use super::element::Elements;
use super::program::Reduced;

/// An operation has been applied. It counts as true.
#[pyclass(frozen, module = "hedgerow")]
pub struct Applied {
    /// The number of the element that the operation returns, if it returns one.
    #[pyo3(get)]
    result: Option<u32>,
    created: Vec<Element>,
    erased: Vec<Element>,
}

impl Applied {
    pub fn new(result: Option<u32>, session: &Session) -> Self {
        Self { result, created: session.created().to_vec(), erased: session.erased().to_vec() }
    }
}

#[pymethods]
impl Applied {
    #[new]
    fn made_of(result: Option<u32>, created: &Elements, erased: &Elements) -> Self {
        Self { result, created: created.all().to_vec(), erased: erased.all().to_vec() }
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> Reduced<'py, (Option<u32>, Elements, Elements)> {
        let class = PyType::new::<Self>(py).into_any();
        Ok((class, (self.result, self.created(), self.erased())))
    }

    #[classattr]
    fn __match_args__() -> (&'static str, &'static str, &'static str) {
        ("result", "created", "erased")
    }

    /// The elements that it created.
    #[getter]
    fn created(&self) -> Elements {
        Elements::new(&self.created)
    }

    /// The elements that it erased.
    #[getter]
    fn erased(&self) -> Elements {
        Elements::new(&self.erased)
    }

    fn __bool__(&self) -> bool {
        true
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| {
            let other = other.get();
            self.result == other.result
                && self.created().is_same(&other.created())
                && self.erased().is_same(&other.erased())
        })
    }

    fn __hash__(&self) -> usize {
        self.created().__hash__().wrapping_add(self.erased().__hash__().wrapping_mul(31))
    }

    fn __repr__(&self) -> String {
        let result = self.result.map_or("None".to_owned(), |result| result.to_string());
        let [created, erased] = [self.created(), self.erased()].map(|all| all.__repr__());
        format!("Applied(result={result}, created={created}, erased={erased})")
    }
}

/// An operation does not apply there, and the mesh is as it was. It counts as false.
#[pyclass(frozen, module = "hedgerow")]
pub struct Refused {
    reason: Reason,
}

impl Refused {
    pub fn new(reason: Reason) -> Self {
        Self { reason }
    }
}

#[pymethods]
impl Refused {
    #[new]
    fn made_of(reason: &str, number: usize) -> Self {
        Self { reason: Reason { number, text: reason.into() } }
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> Reduced<'py, (String, usize)> {
        let class = PyType::new::<Self>(py).into_any();
        Ok((class, (self.reason.text.to_string(), self.reason.number)))
    }

    #[classattr]
    fn __match_args__() -> (&'static str,) {
        ("reason",)
    }

    /// The reason, in words.
    #[getter]
    fn reason(&self) -> &str {
        &self.reason.text
    }

    /// The number of the reason among the `reasons` of the operation.
    #[getter]
    fn number(&self) -> usize {
        self.reason.number
    }

    fn __bool__(&self) -> bool {
        false
    }

    fn __str__(&self) -> &str {
        &self.reason.text
    }

    fn __repr__(&self) -> String {
        format!("Refused({:?})", &*self.reason.text)
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| other.get().reason == self.reason)
    }

    fn __hash__(&self) -> usize {
        self.reason.number
    }
}
