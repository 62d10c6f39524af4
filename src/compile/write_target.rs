//! Targets of the writes of phase 3: the mesh, or first on a preview over it, for a guard to look
//! at.

use crate::check::guard::Statement;
use crate::rewrite::{ElementField, HalfedgeField, Inst};

/// The target on which pointers are set.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Onto {
    /// On the mesh.
    Mesh,
    /// On the preview of the mesh that guards look at, as far as they do.
    Preview(Looks),
}

/// The fields that the tests of a guard look at. None looks at edges.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Looks {
    /// Walks around vertices.
    pub stars: bool,
    /// Walks around loops.
    pub loops: bool,
    /// The vertices where halfedges start.
    pub origins: bool,
    /// In which loops they lie, and which of these are holes.
    pub faces: bool,
}

impl Looks {
    /// Those of one test.
    fn of(statement: &Statement) -> Self {
        let none = Self::default();
        match statement {
            Statement::ThreeSides(_) => Self { loops: true, ..none },
            Statement::MeetsOnce(_) => Self { loops: true, origins: true, ..none },
            Statement::TwoSpokes(_) => Self { stars: true, ..none },
            Statement::CornerOnce { .. }
            | Statement::FacesDiffer { .. }
            | Statement::OneHole { .. } => Self { stars: true, faces: true, ..none },
            Statement::NeighborsDiffer { .. } | Statement::SingleEdge { .. } => {
                Self { stars: true, origins: true, ..none }
            }
            Statement::OneHoleAlong(_)
            | Statement::CornersDiffer(_)
            | Statement::CornersOwn { .. } => {
                Self { stars: true, loops: true, origins: true, faces: true }
            }
        }
    }

    /// Those of some tests together.
    pub fn of_all<'s>(statements: impl IntoIterator<Item = &'s Statement>) -> Self {
        statements.into_iter().map(Self::of).fold(Self::default(), |all, one| Self {
            stars: all.stars | one.stars,
            loops: all.loops | one.loops,
            origins: all.origins | one.origins,
            faces: all.faces | one.faces,
        })
    }

    fn at(self, field: HalfedgeField) -> bool {
        match field {
            HalfedgeField::Next => self.loops,
            // A walk around a vertex tells where a spoke ends by the halfedge before the last.
            HalfedgeField::Prev => self.stars | self.loops,
            HalfedgeField::Twin => self.stars | self.origins,
            HalfedgeField::Vertex => self.origins,
            HalfedgeField::Edge => false,
            HalfedgeField::Face => self.faces,
        }
    }
}

impl Onto {
    /// The same store, there; none if nobody looks.
    pub fn aim(self, inst: Inst) -> Option<Inst> {
        let Onto::Preview(looks) = self else {
            return Some(inst);
        };
        match inst {
            Inst::Store { field, halfedge, value } => {
                looks.at(field).then_some(Inst::PreviewStore { field, halfedge, value })
            }
            Inst::StoreHalfedge { of, element, value } => {
                let is_seen = match of {
                    ElementField::Vertex => looks.stars,
                    ElementField::Face => looks.loops,
                    ElementField::Edge => false,
                };
                is_seen.then_some(Inst::PreviewStoreHalfedge { of, element, value })
            }
            Inst::StoreHole { face, hole } => {
                looks.faces.then_some(Inst::PreviewStoreHole { face, hole })
            }
            Inst::StoreAll { field, buffer, value } => {
                looks.at(field).then_some(Inst::PreviewStoreAll { field, buffer, value })
            }
            Inst::StoreSpan { field, span, index, value } => {
                looks.at(field).then_some(Inst::PreviewStoreSpan { field, span, index, value })
            }
            inst => Some(inst),
        }
    }
}
