//! Attributes as arrays.

use hedgerow::mesh::glam::{DMat3, DMat4, DVec2, DVec3, DVec4};
use hedgerow::mesh::{AttributeType, ColumnData};
use numpy::{PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;

use super::array::values;

/// The values of a column, flat, matrices column by column; and the name of their type.
pub fn flat<'py>(py: Python<'py>, data: &ColumnData) -> (Bound<'py, PyAny>, &'static str) {
    fn reals<'py, T: Copy, const WIDTH: usize>(
        py: Python<'py>,
        all: &[T],
        parts: impl Fn(T) -> [f64; WIDTH],
    ) -> Bound<'py, PyAny> {
        let all = all.iter().flat_map(|&one| parts(one)).collect();
        PyArray1::from_vec(py, all).into_any()
    }
    let name = data.attribute_type().name();
    let array = match data {
        ColumnData::Bool(all) => PyArray1::from_slice(py, all).into_any(),
        ColumnData::Int(all) => PyArray1::from_slice(py, all).into_any(),
        ColumnData::Real(all) => PyArray1::from_slice(py, all).into_any(),
        ColumnData::Vec2(all) => reals(py, all, |v: DVec2| v.to_array()),
        ColumnData::Vec3(all) => reals(py, all, |v: DVec3| v.to_array()),
        ColumnData::Vec4(all) => reals(py, all, |v: DVec4| v.to_array()),
        ColumnData::Mat3(all) => reals(py, all, |m: DMat3| m.to_cols_array()),
        ColumnData::Mat4(all) => reals(py, all, |m: DMat4| m.to_cols_array()),
    };
    (array, name)
}

/// The column of a flat array, of the type of a name.
pub fn column(array: &Bound<'_, PyAny>, ty: &str) -> PyResult<ColumnData> {
    fn parts<T, const WIDTH: usize>(
        array: &Bound<'_, PyAny>,
        make: impl Fn([f64; WIDTH]) -> T,
    ) -> PyResult<Vec<T>> {
        let flat = values(&array.extract::<PyReadonlyArray1<'_, f64>>()?)?;
        let (all, rest) = flat.as_chunks::<WIDTH>();
        match rest.is_empty() {
            true => Ok(all.iter().map(|&one| make(one)).collect()),
            false => Err(PyTypeError::new_err("the array ends within a value")),
        }
    }
    let known = AttributeType::ALL.iter().find(|known| known.name() == ty);
    Ok(match known {
        Some(AttributeType::Bool) => {
            // The byte of a bool of numpy may be any, that of one here is 0 or 1.
            let bytes = array.call_method1("view", ("uint8",))?;
            let bytes = values(&bytes.extract::<PyReadonlyArray1<'_, u8>>()?)?;
            ColumnData::Bool(bytes.into_iter().map(|byte| byte != 0).collect())
        }
        Some(AttributeType::Int) => {
            ColumnData::Int(values(&array.extract::<PyReadonlyArray1<'_, i64>>()?)?)
        }
        Some(AttributeType::Real) => {
            ColumnData::Real(values(&array.extract::<PyReadonlyArray1<'_, f64>>()?)?)
        }
        Some(AttributeType::Vec2) => ColumnData::Vec2(parts(array, DVec2::from_array)?),
        Some(AttributeType::Vec3) => ColumnData::Vec3(parts(array, DVec3::from_array)?),
        Some(AttributeType::Vec4) => ColumnData::Vec4(parts(array, DVec4::from_array)?),
        Some(AttributeType::Mat3) => {
            ColumnData::Mat3(parts::<_, 9>(array, |m| DMat3::from_cols_array(&m))?)
        }
        Some(AttributeType::Mat4) => {
            ColumnData::Mat4(parts::<_, 16>(array, |m| DMat4::from_cols_array(&m))?)
        }
        None => {
            return Err(PyTypeError::new_err(format!("there are no attributes of type `{ty}`")));
        }
    })
}
