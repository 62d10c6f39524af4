//! Counts of the elements of a mesh, before and after.

use serde::Serialize;

use crate::mesh::Mesh;

/// The numbers of elements of a mesh.
#[derive(Clone, Copy, Debug, Serialize)]
pub(super) struct Counts {
    pub vertices: usize,
    pub edges: usize,
    pub faces: usize,
    pub holes: usize,
}

impl Counts {
    /// Counts the elements of a mesh.
    pub fn of(mesh: &Mesh) -> Self {
        Self {
            vertices: mesh.vertex_count(),
            edges: mesh.edge_count(),
            faces: mesh.face_count(),
            holes: mesh.hole_count(),
        }
    }

    /// The numbers with their names.
    pub fn rows(self) -> [(&'static str, usize); 4] {
        [
            ("vertices", self.vertices),
            ("edges", self.edges),
            ("faces", self.faces),
            ("holes", self.holes),
        ]
    }
}
