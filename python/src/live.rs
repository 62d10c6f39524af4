//! Masks that are kept current.

use hedgerow::KeptMask;
use numpy::PyArray1;
use pyo3::IntoPyObjectExt;
use pyo3::basic::CompareOp;
use pyo3::exceptions::{PyIndexError, PyOverflowError, PyValueError};
use pyo3::gc::{PyTraverseError, PyVisit};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

use super::error::{Kind, in_call, saying};
use super::mesh::MeshTables;

/// A mask of the places where an operation would be applied, kept current while the mesh changes.
#[pyclass(frozen, module = "hedgerow")]
pub struct LiveMask {
    mesh: Py<MeshTables>,
    kept: KeptMask,
}

impl LiveMask {
    pub fn new(mesh: Py<MeshTables>, kept: KeptMask) -> Self {
        Self { mesh, kept }
    }

    /// Does something with the mask as it is now.
    fn with<T>(&self, py: Python<'_>, look: impl FnOnce(&[bool]) -> T) -> PyResult<T> {
        let mut state = self.mesh.get().hold(py)?;
        let mask = state.session.kept_mask(self.kept);
        mask.map(look).map_err(|error| in_call(py, &error))
    }

    /// What a method of the array gives for arguments, as numpy hands them on; `bare` if they say
    /// nothing.
    fn reduced<'py, T: IntoPyObject<'py>>(
        &self,
        py: Python<'py>,
        method: &str,
        (args, kwargs): (&Bound<'py, PyTuple>, Option<&Bound<'py, PyDict>>),
        bare: impl FnOnce() -> PyResult<T>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let mut named = kwargs.into_iter().flatten();
        if args.iter().all(|one| one.is_none()) && named.all(|(_, one)| one.is_none()) {
            return bare()?.into_bound_py_any(py);
        }
        self.array(py)?.call_method(method, args, kwargs)
    }
}

#[pymethods]
impl LiveMask {
    /// The mask now: a bool for each element, by number. It is a copy, which stays as it is.
    #[getter]
    fn array<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<bool>>> {
        self.with(py, |mask| PyArray1::from_slice(py, mask))
    }

    #[pyo3(signature = (dtype=None, copy=None))]
    fn __array__<'py>(
        &self,
        py: Python<'py>,
        dtype: Option<&Bound<'py, PyAny>>,
        copy: Option<bool>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let _ = copy;
        let array = self.array(py)?.into_any();
        match dtype {
            Some(dtype) => array.call_method1("astype", (dtype,)),
            None => Ok(array),
        }
    }

    /// The numbers of the elements at which the operation would be applied.
    fn numbers<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<i64>>> {
        self.with(py, |mask| {
            let numbers = (0..).zip(mask).filter(|&(_, &can)| can).map(|(number, _)| number);
            PyArray1::from_vec(py, numbers.collect())
        })
    }

    /// At how many elements it would be applied.
    fn count(&self, py: Python<'_>) -> PyResult<usize> {
        let mut state = self.mesh.get().hold(py)?;
        state.session.kept_count(self.kept).map_err(|error| in_call(py, &error))
    }

    /// The number of one of these elements: the one at `share` of the way through them, 0 the
    /// first, below 1; `None` if there are none. With a random number it is a random one.
    fn pick(&self, py: Python<'_>, share: f64) -> PyResult<Option<usize>> {
        if !(0.0..1.0).contains(&share) {
            let message = format!("`share` is a number from 0 and below 1, not {share}");
            return Err(saying(py, Kind::Argument, "wrong-argument", message));
        }
        let mut state = self.mesh.get().hold(py)?;
        state.session.pick_kept(self.kept, share).map_err(|error| in_call(py, &error))
    }

    /// At how many elements it would be applied, as an array tells; with arguments, what `sum` of
    /// the array gives.
    #[pyo3(signature = (*args, **kwargs))]
    fn sum<'py>(
        &self,
        py: Python<'py>,
        args: &Bound<'py, PyTuple>,
        kwargs: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.reduced(py, "sum", (args, kwargs), || self.count(py))
    }

    /// Whether there is an element at which it would be applied; with arguments, what `any` of the
    /// array gives.
    #[pyo3(signature = (*args, **kwargs))]
    fn any<'py>(
        &self,
        py: Python<'py>,
        args: &Bound<'py, PyTuple>,
        kwargs: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.reduced(py, "any", (args, kwargs), || Ok(self.count(py)? > 0))
    }

    /// Whether it would be applied at all elements; it is not at numbers of erased ones. With
    /// arguments, what `all` of the array gives.
    #[pyo3(signature = (*args, **kwargs))]
    fn all<'py>(
        &self,
        py: Python<'py>,
        args: &Bound<'py, PyTuple>,
        kwargs: Option<&Bound<'py, PyDict>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.reduced(py, "all", (args, kwargs), || self.with(py, |mask| !mask.contains(&false)))
    }

    fn __and__<'py>(
        &self,
        py: Python<'py>,
        other: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.array(py)?.bitand(other)
    }

    fn __rand__<'py>(
        &self,
        py: Python<'py>,
        other: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.array(py)?.bitand(other)
    }

    fn __or__<'py>(
        &self,
        py: Python<'py>,
        other: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.array(py)?.bitor(other)
    }

    fn __ror__<'py>(
        &self,
        py: Python<'py>,
        other: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.array(py)?.bitor(other)
    }

    fn __xor__<'py>(
        &self,
        py: Python<'py>,
        other: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.array(py)?.bitxor(other)
    }

    fn __rxor__<'py>(
        &self,
        py: Python<'py>,
        other: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.array(py)?.bitxor(other)
    }

    fn __invert__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.array(py)?.bitnot()
    }

    /// Compares element by element, as an array does; so it has no hash.
    fn __richcmp__<'py>(
        &self,
        py: Python<'py>,
        other: &Bound<'py, PyAny>,
        how: CompareOp,
    ) -> PyResult<Bound<'py, PyAny>> {
        match how {
            CompareOp::Eq | CompareOp::Ne => self.array(py)?.rich_compare(other, how),
            _ => Ok(py.NotImplemented().into_bound(py)),
        }
    }

    fn __bool__(&self) -> PyResult<bool> {
        let message = "the truth of a live mask is ambiguous: use `.any()` or `.all()`";
        Err(PyValueError::new_err(message))
    }

    fn __getitem__(&self, py: Python<'_>, number: &Bound<'_, PyAny>) -> PyResult<bool> {
        let place = match number.extract::<usize>() {
            Err(error) if error.is_instance_of::<PyOverflowError>(py) => usize::MAX,
            place => place?,
        };
        let found = self.with(py, |mask| mask.get(place).copied())?;
        found.ok_or_else(|| PyIndexError::new_err(format!("there is no element {number}")))
    }

    fn __len__(&self, py: Python<'_>) -> PyResult<usize> {
        self.with(py, <[bool]>::len)
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        Ok(format!("<live mask, {} of {}>", self.count(py)?, self.__len__(py)?))
    }

    fn __traverse__(&self, visit: PyVisit<'_>) -> Result<(), PyTraverseError> {
        visit.call(&self.mesh)
    }
}

impl Drop for LiveMask {
    fn drop(&mut self) {
        Python::attach(|py| self.mesh.get().drop_mask(py, self.kept));
    }
}
