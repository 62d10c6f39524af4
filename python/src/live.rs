//! Masks that are kept current.

use hedgerow::KeptMask;
use numpy::PyArray1;
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;

use super::error::in_call;
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
}

/// The number of true ones.
fn count(mask: &[bool]) -> usize {
    mask.iter().map(|&can| usize::from(can)).sum()
}

/// The place of the true one that so many come before.
fn nth(mask: &[bool], mut before: usize) -> Option<usize> {
    const SIZE: usize = 64;
    for (chunk, part) in mask.chunks(SIZE).enumerate() {
        let there = count(part);
        if before < there {
            let mut places = part.iter().enumerate().filter(|&(_, &can)| can);
            return places.nth(before).map(|(place, _)| chunk * SIZE + place);
        }
        before -= there;
    }
    None
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
        self.with(py, count)
    }

    /// The number of one of these elements: the one at `share` of the way through them, 0 the
    /// first, below 1; `None` if there are none. With a random number it is a random one.
    fn pick(&self, py: Python<'_>, share: f64) -> PyResult<Option<usize>> {
        self.with(py, |mask| {
            let all = count(mask);
            nth(mask, ((share.clamp(0.0, 1.0) * all as f64) as usize).min(all.max(1) - 1))
        })
    }

    /// At how many elements it would be applied, as an array tells.
    fn sum(&self, py: Python<'_>) -> PyResult<usize> {
        self.count(py)
    }

    /// Whether there is an element at which it would be applied.
    fn any(&self, py: Python<'_>) -> PyResult<bool> {
        self.with(py, |mask| mask.contains(&true))
    }

    /// Whether it would be applied at all elements; it is not at numbers of erased ones.
    fn all(&self, py: Python<'_>) -> PyResult<bool> {
        self.with(py, |mask| !mask.contains(&false))
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

    fn __invert__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.array(py)?.bitnot()
    }

    fn __getitem__(&self, py: Python<'_>, number: usize) -> PyResult<bool> {
        let found = self.with(py, |mask| mask.get(number).copied())?;
        found.ok_or_else(|| PyIndexError::new_err(format!("there is no element {number}")))
    }

    fn __len__(&self, py: Python<'_>) -> PyResult<usize> {
        self.with(py, <[bool]>::len)
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        self.with(py, |mask| format!("<live mask, {} of {}>", count(mask), mask.len()))
    }
}

impl Drop for LiveMask {
    fn drop(&mut self) {
        Python::attach(|py| {
            if let Ok(mut state) = self.mesh.get().hold(py) {
                state.session.drop_mask(self.kept);
            }
        });
    }
}
