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
            ExprKind::Binary(_, left, right) | ExprKind::Let(_, left, right) => {
                [left, right].into_iter().for_each(|part| part.visit_mut(change));
            }
            ExprKind::Vector(parts)
            | ExprKind::Call(_, parts)
            | ExprKind::Invoke(_, parts)
            | ExprKind::Try(_, parts) => parts.iter_mut().for_each(|part| part.visit_mut(change)),
            ExprKind::If(condition, then, otherwise) => {
                [condition, then, otherwise].into_iter().for_each(|part| part.visit_mut(change));
            }
            ExprKind::Fold(fold) => {
                if let Collection::Around(_, base) = &mut fold.collection {
                    base.visit_mut(change);
                }
                fold.filter
                    .iter_mut()
                    .chain([&mut fold.body])
                    .for_each(|part| part.visit_mut(change));
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
