//! Statements that belong together although they are read as several.
//!
//! `lete x = 1`, a mistake for `let x = 1`, is read as the value `lete` and an assignment. A value
//! that does nothing is never a statement where another follows, so that an item with one in front
//! of another on its line has an error, and would be torn apart.

use crate::source::Span;
use crate::syntax::Part;
use crate::syntax::tree::{Action, ActionKind, Block, Expr, ExprKind, Item};

/// True if an item has a statement that does nothing in front of another on its line.
pub(super) fn would_be_torn(source: &str, item: &Item) -> bool {
    match item {
        Item::Fn(function) => is_torn(source, &function.body),
        Item::Script(script) => is_torn(source, &script.body),
        Item::Test(test) => is_torn(source, &test.body),
        Item::Op(op) => op.steps.as_ref().is_some_and(|steps| is_torn(source, &steps.body)),
        Item::Use(_) | Item::Attr(_) | Item::Broken(_) => false,
    }
}

fn is_torn(source: &str, block: &Block) -> bool {
    let on_one_line = |one: Span, other: Span| {
        let between = source.get(one.end as usize..other.start as usize);
        between.is_some_and(|between| !between.contains('\n'))
    };
    let mut found = false;
    Part::Block(block).each_within(|part| {
        let Part::Block(block) = part else { return };
        let mut pairs = block.statements.windows(2);
        found |=
            pairs.any(|pair| does_nothing(&pair[0]) && on_one_line(pair[0].span, pair[1].span));
    });
    found
}

fn does_nothing(action: &Action) -> bool {
    let acts = |value: &Expr| {
        matches!(value.kind, ExprKind::Call { .. } | ExprKind::Must(_) | ExprKind::If { .. })
    };
    matches!(&action.kind, ActionKind::Expr(value) if !acts(value))
}
