//! Pictures of meshes.

use std::path::PathBuf;

use hedgerow::draw::{Picture, TooLarge, View, draw_mesh};
use hedgerow::mesh::glam::DVec3;
use hedgerow::mesh::{FileReason, replace_file};
use numpy::PyArray1;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use super::element::kind;
use super::error::of_file;
use super::mesh::{MeshTables, column_of};

/// The pixels of a picture of a mesh, seen from a direction, with an attribute of its vertices in
/// colour: how many there are in a row, and red, green and blue of all, row by row.
#[pyfunction]
pub fn mesh_pixels<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, MeshTables>,
    size: f64,
    from: [f64; 3],
    attribute: Option<String>,
) -> PyResult<(usize, Bound<'py, PyArray1<u8>>)> {
    let attribute = attribute.map(|name| ("vertex".to_owned(), name));
    let (width, pixels) = draw(mesh, size, from, attribute, |picture| picture.rgb(1.0))?;
    Ok((width, PyArray1::from_vec(py, pixels.into_flattened())))
}

/// The same picture as PNG, with an attribute of any kind, or the colours that the mesh has.
#[pyfunction]
pub fn mesh_png<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, MeshTables>,
    size: f64,
    from: [f64; 3],
    attribute: Option<(String, String)>,
) -> PyResult<Bound<'py, PyBytes>> {
    let png = draw(mesh, size, from, attribute, |picture| picture.png(1.0))?;
    Ok(PyBytes::new(py, &png))
}

/// The least and the greatest size of a picture of a mesh.
#[pyfunction]
pub fn picture_sizes() -> (u32, u32) {
    View::SIZES.into()
}

/// Writes a file completely or not at all.
#[pyfunction]
pub fn write_file(py: Python<'_>, path: PathBuf, bytes: &[u8]) -> PyResult<()> {
    let written =
        py.detach(|| replace_file(&path, |output| output.write_all(bytes).map_err(FileReason::Io)));
    written.map_err(|reason| of_file(py, &reason, format!("{}: {reason}", path.display())))
}

/// Draws a mesh with an attribute, given by the kind of its elements and its name.
fn draw<T: Send>(
    mesh: &Bound<'_, MeshTables>,
    size: f64,
    from: [f64; 3],
    attribute: Option<(String, String)>,
    show: impl FnOnce(&Picture) -> Result<T, TooLarge> + Send,
) -> PyResult<T> {
    let py = mesh.py();
    let state = mesh.get().hold(py)?;
    let mesh = state.session.mesh();
    let column = |(of, name): (String, String)| column_of(py, mesh, kind(&of)?, &name);
    let view =
        View { from: DVec3::from_array(from), size, attribute: attribute.map(column).transpose()? };
    let shown = py.detach(|| show(&draw_mesh(mesh, &view.with_own_colours(mesh))));
    shown.map_err(|error| PyValueError::new_err(error.to_string()))
}
