//! Questions about an element that take a walk or a measurement to answer.
//!
//! The mesh answers each question and documents its meaning; this file only says which registers
//! hold the elements and which one gets the answer.

use glam::DVec3;

use super::window::Window;
use super::{Fault, Reg, access};
use crate::mesh::{ElementKind, Mesh};

/// A question to the mesh about one element; [`Question::Adjacent`] is about two.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Question {
    // Of a vertex.
    Degree,
    BoundaryVertex,
    NormalVertex,
    Adjacent,
    // Of an edge.
    BoundaryEdge,
    LengthEdge,
    LinkCondition,
    StarShaped,
    KernelCentroid,
    // Of a face.
    FaceSize,
    Area,
    NormalFace,
    CentroidFace,
}

impl Question {
    /// The kind of the elements that the question is about.
    pub(super) fn kind(self) -> ElementKind {
        match self {
            Self::Degree | Self::BoundaryVertex | Self::NormalVertex | Self::Adjacent => {
                ElementKind::Vertex
            }
            Self::BoundaryEdge
            | Self::LengthEdge
            | Self::LinkCondition
            | Self::StarShaped
            | Self::KernelCentroid => ElementKind::Edge,
            Self::FaceSize | Self::Area | Self::NormalFace | Self::CentroidFace => {
                ElementKind::Face
            }
        }
    }
}

/// Answers a question about the first element, or about both.
pub(super) fn ask(
    mesh: &Mesh,
    question: Question,
    w: &mut Window,
    [to, first, second]: [Reg; 3],
) -> Result<(), Fault> {
    let id = w.id(first);
    let vertex = || access::vertex(mesh, id);
    let edge = || access::edge(mesh, id);
    let face = || access::face(mesh, id);
    match question {
        Question::Degree => w.set_int(to, mesh.degree(vertex()?) as i64),
        Question::BoundaryVertex => w.set_truth(to, mesh.is_boundary_vertex(vertex()?)),
        Question::NormalVertex => w.set_vector(to, mesh.vertex_normal(vertex()?)),
        Question::Adjacent => {
            let other = access::vertex(mesh, w.id(second))?;
            w.set_truth(to, mesh.adjacent(vertex()?, other));
        }
        Question::BoundaryEdge => w.set_truth(to, mesh.is_boundary_edge(edge()?)),
        Question::LengthEdge => w.set_real(to, mesh.length(edge()?)),
        Question::LinkCondition => w.set_truth(to, mesh.link_condition(edge()?)),
        Question::StarShaped => w.set_truth(to, mesh.kernel_centroid(edge()?).is_some()),
        Question::KernelCentroid => {
            let centroid = mesh.kernel_centroid(edge()?);
            w.set_vector(to, centroid.unwrap_or(DVec3::NAN));
        }
        Question::FaceSize => w.set_int(to, mesh.face_size(face()?) as i64),
        Question::Area => w.set_real(to, mesh.area(face()?)),
        Question::NormalFace => w.set_vector(to, mesh.normal(face()?)),
        Question::CentroidFace => w.set_vector(to, mesh.centroid(face()?)),
    }
    Ok(())
}
