//! Traversal of the parts of expressions, to change them, and of the names that a side mentions.

use super::{Collection, Expr, ExprKind, Ref, Side, Spoke};

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

impl Side {
    /// All mentions in its loops, edges and stars.
    pub(crate) fn mentions(&self) -> impl Iterator<Item = &Ref> {
        let loops = self.loops.iter().flat_map(|orbit| {
            let items = orbit.items.iter().flat_map(|item| [&item.from, &item.item]);
            items.chain([&orbit.face, &orbit.end])
        });
        let edges = self.edges.iter().flat_map(|edge| edge.halfedges.iter().chain([&edge.edge]));
        let stars = self.stars.iter().flat_map(|star| {
            let spokes = star.spokes.iter().filter_map(|spoke| match spoke {
                Spoke::Halfedge(mention) | Spoke::Fan(mention) => Some(mention),
                Spoke::Rest(_) => None,
            });
            spokes.chain([&star.vertex])
        });
        loops.chain(edges).chain(stars)
    }

    /// The same to be changed, with those of `keep`.
    pub(crate) fn mentions_mut(&mut self) -> impl Iterator<Item = &mut Ref> {
        let loops = self.loops.iter_mut().flat_map(|orbit| {
            let items = orbit.items.iter_mut().flat_map(|item| [&mut item.from, &mut item.item]);
            items.chain([&mut orbit.face, &mut orbit.end])
        });
        let edges = self.edges.iter_mut().flat_map(|edge| {
            let [one, other] = &mut edge.halfedges;
            [&mut edge.edge, one, other]
        });
        let stars = self.stars.iter_mut().flat_map(|star| {
            let spokes = star.spokes.iter_mut().filter_map(|spoke| match spoke {
                Spoke::Halfedge(mention) | Spoke::Fan(mention) => Some(mention),
                Spoke::Rest(_) => None,
            });
            spokes.chain([&mut star.vertex])
        });
        loops.chain(edges).chain(stars).chain(&mut self.kept)
    }
}
