//! Meshes as arrays: the list of positions and polygons that other programs know.

use std::fmt;

use glam::DVec3;

use super::build_error::BuildError;
use super::connectivity::Mesh;
use super::id::{ElementKind, FaceId};
use super::polygons::Polygons;
use super::records::HalfedgeRecord;

impl Mesh {
    /// The mesh of a list of triangles by the numbers of their corners, counterclockwise. Vertex
    /// `i` is number `i` of the list, and so are faces.
    ///
    /// # Errors
    /// The list is no mesh: see [`BuildError`].
    pub fn from_triangles(
        positions: &[[f64; 3]],
        triangles: &[[u32; 3]],
    ) -> Result<Self, BuildError> {
        let positions = positions.iter().copied().map(DVec3::from_array).collect();
        Self::from_owned_polygons(positions, &Polygons::from_triangles(triangles))
    }

    /// The positions of all living vertices, and the polygons of all faces that are no holes, in
    /// the order of their ids, by places in the list of positions.
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

    /// The positions of the living vertices and the triangles, as [`Mesh::to_polygons`] has them.
    ///
    /// # Errors
    /// The first face that has not three sides.
    #[allow(clippy::type_complexity)]
    pub fn to_triangles(&self) -> Result<(Vec<[f64; 3]>, Vec<[u32; 3]>), NotATriangle> {
        let (positions, polygons) = self.to_polygons();
        let faces = self.faces().filter(|&face| !self.is_hole(face));
        let triangles = faces.zip(polygons.iter());
        let triangles =
            triangles.map(|(face, corners)| corners.try_into().map_err(|_| NotATriangle(face)));
        let positions = positions.into_iter().map(|p| p.to_array()).collect();
        Ok((positions, triangles.collect::<Result<_, _>>()?))
    }

    /// The positions of all slots of vertices, living or dead: the place is the id.
    pub fn positions(&self) -> &[DVec3] {
        &self.positions
    }

    /// The pointers of all slots of halfedges, living or dead: the place is the id. What is not
    /// alive ([`Mesh::halfedge_alive`]) has no meaning.
    pub fn halfedge_records(&self) -> &[HalfedgeRecord] {
        &self.halfedges
    }
}

/// A face that has not three sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotATriangle(pub FaceId);

impl fmt::Display for NotATriangle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} is no triangle", self.0)
    }
}

impl std::error::Error for NotATriangle {}
