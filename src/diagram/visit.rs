//! Traversal of the parts of expressions, to change them, and of the names that a side mentions.

use super::{Collection, Expr, ExprKind, Fold, Ref, Side, Spoke};

/// Calls a function for the parts of an expression, shared or `mut`; for an aggregate, the
/// collection comes last.
macro_rules! for_parts {
    ($kind:expr, $look:expr $(, $mut:tt)?) => {
        match $kind {
            ExprKind::Follow(_, inner)
            | ExprKind::Read(_, inner)
            | ExprKind::Component(_, inner)
            | ExprKind::Unary(_, inner) => $look(inner),
            ExprKind::Binary(_, left, right) | ExprKind::Let(_, left, right) => {
                $look(left);
                $look(right);
            }
            ExprKind::Vector(parts)
            | ExprKind::Call(_, parts)
            | ExprKind::Invoke(_, parts)
            | ExprKind::Try(_, parts) => parts.into_iter().for_each(&mut *$look),
            ExprKind::If(condition, then, otherwise) => {
                $look(condition);
                $look(then);
                $look(otherwise);
            }
            ExprKind::Fold(fold) => {
                let Fold { filter, body, collection, .. } = & $($mut)? **fold;
                filter.into_iter().for_each(&mut *$look);
                $look(body);
                if let Collection::Around(_, base) = collection {
                    $look(base);
                }
            }
            ExprKind::Bool(_)
            | ExprKind::Int(_)
            | ExprKind::Real(_)
            | ExprKind::Text(_)
            | ExprKind::Element(_)
            | ExprKind::Member(..)
            | ExprKind::Local(_) => {}
        }
    };
}

/// The mentions in the loops, edges and stars of a side, shared or `mut`.
macro_rules! mentions {
    ($side:expr, $iter:ident $(, $mut:tt)?) => {{
        let loops = $side.loops.$iter().flat_map(|orbit| {
            let items = orbit.items.$iter();
            let items = items.flat_map(|item| [& $($mut)? item.from, & $($mut)? item.item]);
            items.chain([& $($mut)? orbit.face, & $($mut)? orbit.end])
        });
        let edges = $side.edges.$iter();
        let edges = edges.flat_map(|pair| pair.halfedges.$iter().chain([& $($mut)? pair.edge]));
        let stars = $side.stars.$iter().flat_map(|star| {
            let spokes = star.spokes.$iter().filter_map(|spoke| match spoke {
                Spoke::Halfedge(mention) | Spoke::Fan(mention) => Some(mention),
                Spoke::Rest(_) => None,
            });
            spokes.chain([& $($mut)? star.vertex])
        });
        loops.chain(edges).chain(stars)
    }};
}

impl Expr {
    /// Calls `look` for the expression and all its parts, in no particular order.
    pub fn each<'e>(&'e self, look: &mut impl FnMut(&'e Expr)) {
        let mut open = vec![self];
        while let Some(expr) = open.pop() {
            look(expr);
            expr.parts(&mut |part| open.push(part));
        }
    }

    /// Calls `look` for the parts of the expression; for an aggregate, the collection comes last.
    pub fn parts<'e>(&'e self, look: &mut dyn FnMut(&'e Expr)) {
        for_parts!(&self.kind, look)
    }

    /// Calls `change` for each part of the expression, the whole first.
    pub fn visit_mut(&mut self, change: &mut impl FnMut(&mut ExprKind)) {
        change(&mut self.kind);
        let look = &mut |part: &mut Expr| part.visit_mut(change);
        for_parts!(&mut self.kind, look, mut)
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
        mentions!(self, iter)
    }

    /// The same to be changed, with those of `keep`.
    pub(crate) fn mentions_mut(&mut self) -> impl Iterator<Item = &mut Ref> {
        mentions!(self, iter_mut, mut).chain(&mut self.kept)
    }
}
