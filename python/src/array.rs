//! Arrays of numpy that come in.

use numpy::{Element, PyReadonlyArray1, PyUntypedArrayMethods};
use pyo3::prelude::*;

use super::error::{Kind, saying};

/// The values of an array of one dimension, which must lie one behind the other.
pub fn values<T: Element + Copy>(array: &PyReadonlyArray1<'_, T>) -> PyResult<Vec<T>> {
    array.as_slice().map(<[T]>::to_vec).map_err(|_| {
        let message = format!("an array of {} values does not lie in one piece", array.len());
        saying(array.py(), Kind::Argument, "wrong-argument", message)
    })
}
