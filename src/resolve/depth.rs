//! Limits of nesting, so that walking a tree cannot overflow the stack.
//!
//! Two depths are bounded. Anything built from an expression is as deep as its tree. Chains like
//! `a + b + c` and `h.next.next` are deep on their left side only, and are walked here without
//! recursion; everything else recurses once per level.

use std::ptr;

use crate::diagnostic::Diagnostic;
use crate::syntax::Part;
use crate::syntax::tree::{Block, Expr, ExprKind};

use super::report::Report;

/// The maximum depth of a tree.
const DEEPEST: u32 = 2000;
/// The maximum nesting of a tree, not counting the left sides of chains.
const MOST_NESTED: u32 = 400;

/// True if an expression is shallow enough to walk; otherwise reports an error.
pub(super) fn shallow_expr(expr: &Expr, report: &mut Report) -> bool {
    shallow(Part::Expr(expr), report)
}

/// True if a block is shallow enough to walk; otherwise reports an error.
pub(super) fn shallow_block(block: &Block, report: &mut Report) -> bool {
    shallow(Part::Block(block), report)
}

fn shallow(root: Part, report: &mut Report) -> bool {
    let mut open = vec![(root, 0, 0)];
    while let Some((part, depth, nested)) = open.pop() {
        if depth > DEEPEST || nested > MOST_NESTED {
            report.add(too_deep(part));
            return false;
        }
        let left = match part {
            Part::Expr(expr) => left_side(expr),
            Part::Block(_) => None,
        };
        part.each_part(&mut |inner| {
            let is_left =
                matches!((inner, left), (Part::Expr(inner), Some(left)) if ptr::eq(inner, left));
            open.push((inner, depth + 1, nested + u32::from(!is_left)));
        });
    }
    true
}

fn too_deep(part: Part) -> Diagnostic {
    match part {
        Part::Expr(expr) => Diagnostic::error(
            "expression-too-long",
            "this expression is too long to be understood as one",
            expr.span,
        )
        .note("give parts of it a name of their own with `let`"),
        Part::Block(block) => Diagnostic::error(
            "expression-too-long",
            "these blocks are nested too deeply",
            block.span,
        ),
    }
}

/// The left side of a chain.
pub(super) fn left_side(expr: &Expr) -> Option<&Expr> {
    match &expr.kind {
        ExprKind::Binary(_, left, _) | ExprKind::Field(left, _) => Some(left),
        _ => None,
    }
}
