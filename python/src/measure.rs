//! Measures of meshes.

use hedgerow::mesh::{ElementKind, Mesh, Summary};
use numpy::PyArray1;
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;

use super::element::kind;
use super::mesh::MeshTables;

/// A summary of a mesh, as JSON.
#[pyfunction]
pub fn mesh_summary(py: Python<'_>, mesh: &Bound<'_, MeshTables>) -> PyResult<String> {
    let state = mesh.get().hold(py)?;
    let mesh = state.session.mesh();
    let summary = py.detach(|| serde_json::to_string(&Summary::of(mesh)));
    summary.map_err(|error| PyRuntimeError::new_err(error.to_string()))
}

/// One measure of a mesh.
#[pyfunction]
pub fn mesh_measure<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, MeshTables>,
    name: &str,
) -> PyResult<Bound<'py, PyAny>> {
    let state = mesh.get().hold(py)?;
    let mesh = state.session.mesh();
    match name {
        "area" => py.detach(|| mesh.surface_area()).into_bound_py_any(py),
        "volume" => py.detach(|| mesh.volume()).into_bound_py_any(py),
        "bounds" => {
            let bounds = py.detach(|| mesh.bounds());
            bounds.map(|corners| corners.map(|corner| corner.to_array())).into_bound_py_any(py)
        }
        "euler" => py.detach(|| mesh.euler_characteristic()).into_bound_py_any(py),
        "components" => py.detach(|| mesh.component_count()).into_bound_py_any(py),
        _ => Err(PyValueError::new_err(format!("there is no measure `{name}`"))),
    }
}

/// The unit normals of the living vertices, or of the faces that are no holes, flat.
#[pyfunction]
pub fn mesh_normals<'py>(
    py: Python<'py>,
    mesh: &Bound<'py, MeshTables>,
    of: &str,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let state = mesh.get().hold(py)?;
    let (mesh, kind) = (state.session.mesh(), kind(of)?);
    let normals = py.detach(|| match kind {
        ElementKind::Face => face_normals(mesh),
        _ => mesh.vertices().flat_map(|v| mesh.vertex_normal(v).to_array()).collect(),
    });
    Ok(PyArray1::from_vec(py, normals))
}

fn face_normals(mesh: &Mesh) -> Vec<f64> {
    let faces = mesh.faces().filter(|&face| !mesh.is_hole(face));
    faces.flat_map(|face| mesh.normal(face).to_array()).collect()
}
