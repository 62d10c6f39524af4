//! Meshes as arrays: lists of positions and polygons, as other programs use them.

use std::fmt;

use glam::DVec3;

use super::build_error::BuildError;
use super::connectivity::Mesh;
use super::id::{ElementKind, FaceId};
use super::polygons::Polygons;
use super::records::HalfedgeRecord;

impl Mesh {
    /// The mesh of a list of triangles, each the indices of its corners, counterclockwise. Vertices
    /// and faces are numbered as in the lists.
    ///
    /// # Errors
    /// The list is not a mesh: see [`BuildError`].
    pub fn from_triangles(
        positions: &[[f64; 3]],
        triangles: &[[u32; 3]],
    ) -> Result<Self, BuildError> {
        let positions = positions.iter().copied().map(DVec3::from_array).collect();
        Self::from_owned_polygons(positions, &Polygons::from_triangles(triangles))
    }

    /// The positions of all living vertices, and the polygons of all faces that are not holes, in
    /// the order of their ids. Corners are indices into the list of positions.
    pub fn to_polygons(&self) -> (Vec<DVec3>, Polygons) {
        let mut numbers = vec![0; self.capacity(ElementKind::Vertex)];
        let mut positions = Vec::with_capacity(self.vertex_count());
        for vertex in self.vertices() {
            numbers[vertex.index()] = positions.len() as u32;
            positions.push(self.position(vertex));
        }
        let faces = self.faces().filter(|&face| !self.is_hole(face));
        let mut polygons = Polygons::with_capacity(self.face_count(), self.halfedge_count());
        let mut corners = Vec::new();
        for face in faces {
            corners.clear();
            corners.extend(self.face_vertices(face).map(|v| numbers[v.index()]));
            polygons.push(&corners);
        }
        (positions, polygons)
    }

    /// The positions of the living vertices and the triangles, as in [`Mesh::to_polygons`].
    ///
    /// # Errors
    /// The first face that does not have three sides.
    #[allow(clippy::type_complexity)]
    pub fn to_triangles(&self) -> Result<(Vec<[f64; 3]>, Vec<[u32; 3]>), NotATriangle> {
        let (positions, polygons) = self.to_polygons();
        let triangles = self.faces().filter(|&face| !self.is_hole(face)).zip(polygons.iter());
        let triangles =
            triangles.map(|(face, corners)| corners.try_into().map_err(|_| NotATriangle(face)));
        let positions = positions.into_iter().map(|p| p.to_array()).collect();
        Ok((positions, triangles.collect::<Result<_, _>>()?))
    }

    /// The positions of all vertex slots, living or dead, indexed by id.
    pub fn positions(&self) -> &[DVec3] {
        &self.positions
    }

    /// As [`Mesh::positions`], for writing; no journal notes what is written.
    pub(crate) fn positions_mut(&mut self) -> &mut [DVec3] {
        &mut self.positions
    }

    /// The records of all halfedge slots, living or dead, indexed by id. Those that are not alive
    /// ([`Mesh::halfedge_alive`]) have no meaning.
    pub fn halfedge_records(&self) -> &[HalfedgeRecord] {
        &self.halfedges
    }
}

/// A face that does not have three sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotATriangle(pub FaceId);

impl fmt::Display for NotATriangle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} is not a triangle", self.0)
    }
}

impl std::error::Error for NotATriangle {}
