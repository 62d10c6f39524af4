//! Pictures of meshes.

use hedgerow::draw::{View, draw_mesh};
use hedgerow::mesh::ElementKind;
use hedgerow::mesh::glam::DVec3;
use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use super::mesh::{MeshTables, column_of};

/// The pixels of a picture of a mesh, seen from a direction, with an attribute of its vertices in
/// colour: how many there are in a row, and red, green and blue of all, row by row.
#[pyfunction]
pub fn mesh_pixels<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, MeshTables>,
    size: f64,
    from: [f64; 3],
    attribute: Option<&str>,
) -> PyResult<(usize, Bound<'py, PyArray1<u8>>)> {
    let state = mesh.get().hold(py)?;
    let mesh = state.session.mesh();
    let column =
        attribute.map(|name| column_of(py, mesh, ElementKind::Vertex, name)).transpose()?;
    let view = View { from: DVec3::from_array(from), size, attribute: column };
    let drawn = py.detach(|| draw_mesh(mesh, &view).rgb(1.0));
    let (width, pixels) = drawn.map_err(|error| PyValueError::new_err(error.to_string()))?;
    Ok((width, PyArray1::from_vec(py, pixels.into_flattened())))
}
