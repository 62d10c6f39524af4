//! Traversal of an expression, to change its parts.

use super::{Collection, Expr, ExprKind};

impl Expr {
    /// Calls `change` for each part of the expression, the whole first.
    pub fn visit_mut(&mut self, change: &mut impl FnMut(&mut ExprKind)) {
        change(&mut self.kind);
        match &mut self.kind {
            ExprKind::Bool(_)
            | ExprKind::Int(_)
            | ExprKind::Real(_)
            | ExprKind::Text(_)
            | ExprKind::Element(_)
            | ExprKind::Member(..)
            | ExprKind::Local(_) => {}
            ExprKind::Follow(_, of)
            | ExprKind::Read(_, of)
            | ExprKind::Component(_, of)
            | ExprKind::Unary(_, of) => of.visit_mut(change),
            ExprKind::Vector(parts) => {
                parts.iter_mut().for_each(|part| part.visit_mut(change));
            }
            ExprKind::Binary(_, left, right) | ExprKind::Let(_, left, right) => {
                left.visit_mut(change);
                right.visit_mut(change);
            }
            ExprKind::Call(_, arguments)
            | ExprKind::Invoke(_, arguments)
            | ExprKind::Try(_, arguments) => {
                arguments.iter_mut().for_each(|argument| argument.visit_mut(change));
            }
            ExprKind::If(condition, then, otherwise) => {
                condition.visit_mut(change);
                then.visit_mut(change);
                otherwise.visit_mut(change);
            }
            ExprKind::Fold(fold) => {
                if let Some(base) = base(&mut fold.collection) {
                    base.visit_mut(change);
                }
                if let Some(filter) = &mut fold.filter {
                    filter.visit_mut(change);
                }
                fold.body.visit_mut(change);
            }
        }
    }

    /// True if the expression has a free index.
    pub fn has_members(&self) -> bool {
        let mut found = false;
        self.each(&mut |expr| found |= matches!(expr.kind, ExprKind::Member(..)));
        found
    }
}

/// The element that a collection lies around.
fn base(collection: &mut Collection) -> Option<&mut Expr> {
    use Collection::*;
    match collection {
        Vertices | Halfedges | Edges | Faces | Holes => None,
        VertexHalfedges(of) | VertexEdges(of) | VertexFaces(of) | VertexNeighbors(of)
        | FaceHalfedges(of) | FaceVertices(of) | FaceEdges(of) | FaceEars(of) | FacePatch(of)
        | EdgeVertices(of) | EdgeFaces(of) => Some(of),
    }
}
