//! Questions about an element that take a walk or a measurement to answer.
//!
//! The mesh answers each question and documents its meaning; this file only says which registers
//! hold the elements and which one gets the answer.

use glam::DVec3;

use super::window::Window;
use super::{Fault, Reg, access};
use crate::mesh::{ElementKind, Mesh};

/// Declares the questions: the kind of the element that each is about, and the number of reals of
/// the answer; it is a bool or an int that is not negative if there are none.
macro_rules! questions {
    ($($question:ident($kind:ident) $reals:literal;)*) => {
        /// A question to the mesh about one element; [`Question::Adjacent`] is about two.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Question { $($question),* }

        impl Question {
            /// All questions.
            #[cfg(feature = "native")]
            pub(super) const ALL: &'static [Self] = &[$(Self::$question),*];

            /// The kind of the elements that the question is about.
            pub(super) fn kind(self) -> ElementKind {
                match self { $(Self::$question => ElementKind::$kind),* }
            }

            /// The number of reals of the answer.
            #[cfg(feature = "native")]
            pub(super) fn reals(self) -> u16 {
                match self { $(Self::$question => $reals),* }
            }
        }
    };
}

questions! {
    Degree(Vertex) 0;
    BoundaryVertex(Vertex) 0;
    NormalVertex(Vertex) 3;
    Adjacent(Vertex) 0;
    BoundaryEdge(Edge) 0;
    LengthEdge(Edge) 1;
    LinkCondition(Edge) 0;
    StarShaped(Edge) 0;
    KernelCentroid(Edge) 3;
    FaceSize(Face) 0;
    Area(Face) 1;
    NormalFace(Face) 3;
    CentroidFace(Face) 3;
}

/// The answer to a question.
pub(super) enum Answered {
    Whole(i64),
    Real(f64),
    Vector(DVec3),
}

impl Question {
    /// The answer for the first element, or for both.
    #[inline]
    pub(super) fn answer(self, mesh: &Mesh, [first, second]: [u32; 2]) -> Result<Answered, Fault> {
        let vertex = || access::vertex(mesh, first);
        let edge = || access::edge(mesh, first);
        let face = || access::face(mesh, first);
        Ok(match self {
            Self::Degree => Answered::Whole(mesh.degree(vertex()?) as i64),
            Self::BoundaryVertex => Answered::Whole(mesh.is_boundary_vertex(vertex()?).into()),
            Self::NormalVertex => Answered::Vector(mesh.vertex_normal(vertex()?)),
            Self::Adjacent => {
                let other = access::vertex(mesh, second)?;
                Answered::Whole(mesh.adjacent(vertex()?, other).into())
            }
            Self::BoundaryEdge => Answered::Whole(mesh.is_boundary_edge(edge()?).into()),
            Self::LengthEdge => Answered::Real(mesh.length(edge()?)),
            Self::LinkCondition => Answered::Whole(mesh.link_condition(edge()?).into()),
            Self::StarShaped => Answered::Whole(mesh.kernel_centroid(edge()?).is_some().into()),
            Self::KernelCentroid => {
                Answered::Vector(mesh.kernel_centroid(edge()?).unwrap_or(DVec3::NAN))
            }
            Self::FaceSize => Answered::Whole(mesh.face_size(face()?) as i64),
            Self::Area => Answered::Real(mesh.area(face()?)),
            Self::NormalFace => Answered::Vector(mesh.normal(face()?)),
            Self::CentroidFace => Answered::Vector(mesh.centroid(face()?)),
        })
    }
}

/// Answers a question about the first element, or about both.
pub(super) fn ask(
    mesh: &Mesh,
    question: Question,
    w: &mut Window,
    [to, first, second]: [Reg; 3],
) -> Result<(), Fault> {
    match question.answer(mesh, [first, second].map(|reg| w.id(reg)))? {
        Answered::Whole(whole) => w.set_int(to, whole),
        Answered::Real(real) => w.set_real(to, real),
        Answered::Vector(vector) => w.set_vector(to, vector),
    }
    Ok(())
}
