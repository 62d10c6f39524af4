//! Parts of a statement or a value: other values, and blocks.
//!
//! For searches in code, independent of the kinds of statements. Code that handles each kind in its
//! own way matches on the [tree](super::tree) instead.

use super::tree::{Action, ActionKind, Block, Expr, ExprKind, Shown};

/// A part of code.
#[derive(Clone, Copy, Debug)]
pub enum Part<'t> {
    /// A value.
    Expr(&'t Expr),
    Block(&'t Block),
}

impl<'t> Part<'t> {
    /// Calls `look` with the direct parts of a value, or of the statements of a block.
    pub fn each_part(self, look: &mut dyn FnMut(Part<'t>)) {
        match self {
            Part::Expr(expr) => expr.each_part(look),
            Part::Block(block) => block.statements.iter().for_each(|action| action.each_part(look)),
        }
    }

    /// Calls `look` with a part and all its parts, at any depth, in no particular order.
    pub fn each_within(self, mut look: impl FnMut(Part<'t>)) {
        let mut open = vec![self];
        while let Some(part) = open.pop() {
            look(part);
            part.each_part(&mut |inner| open.push(inner));
        }
    }
}

impl Expr {
    /// Calls `look` with the direct parts of a value, in the order of the text.
    pub fn each_part<'t>(&'t self, look: &mut dyn FnMut(Part<'t>)) {
        match &self.kind {
            ExprKind::Field(inner, _)
            | ExprKind::Must(inner)
            | ExprKind::Asked(_, inner)
            | ExprKind::Unary(_, inner) => look(Part::Expr(inner)),
            ExprKind::Call { args, .. } => args.iter().for_each(|arg| look(Part::Expr(arg))),
            ExprKind::Binary(_, left, right) | ExprKind::Range(left, right) => {
                look(Part::Expr(left));
                look(Part::Expr(right));
            }
            ExprKind::If { condition, then, otherwise } => {
                look(Part::Expr(condition));
                look(Part::Block(then));
                look(Part::Block(otherwise));
            }
            ExprKind::Aggregate { body, sequence, filter, .. } => {
                look(Part::Expr(body));
                look(Part::Expr(sequence));
                filter.iter().for_each(|filter| look(Part::Expr(filter)));
            }
            ExprKind::Bool(_)
            | ExprKind::Int(_)
            | ExprKind::Real(_)
            | ExprKind::Text(_)
            | ExprKind::Name(_)
            | ExprKind::Broken => {}
        }
    }
}

impl Action {
    /// Calls `look` with the direct parts of a statement, in the order of the text.
    pub fn each_part<'t>(&'t self, look: &mut dyn FnMut(Part<'t>)) {
        match &self.kind {
            ActionKind::Let { value, .. } | ActionKind::Expr(value) => look(Part::Expr(value)),
            ActionKind::Assign { target, value } => {
                look(Part::Expr(target));
                look(Part::Expr(value));
            }
            ActionKind::Repeat { count: head, body }
            | ActionKind::While { condition: head, body } => {
                look(Part::Expr(head));
                look(Part::Block(body));
            }
            ActionKind::For { sequence, filter, body, .. }
            | ActionKind::Update { sequence, filter, body, .. } => {
                look(Part::Expr(sequence));
                filter.iter().for_each(|filter| look(Part::Expr(filter)));
                look(Part::Block(body));
            }
            ActionKind::Drain { sequence, key, condition, body, .. } => {
                look(Part::Expr(sequence));
                look(Part::Expr(key));
                condition.iter().for_each(|inner| look(Part::Expr(inner)));
                look(Part::Block(body));
            }
            ActionKind::If { condition, then, otherwise, .. } => {
                look(Part::Expr(condition));
                look(Part::Block(then));
                otherwise.iter().for_each(|block| look(Part::Block(block)));
            }
            ActionKind::Print(values) => {
                values.iter().flat_map(Shown::values).for_each(|value| look(Part::Expr(value)));
            }
            ActionKind::Assert { condition, .. } | ActionKind::Require { condition, .. } => {
                look(Part::Expr(condition));
            }
            ActionKind::Return(value) => value.iter().for_each(|value| look(Part::Expr(value))),
            ActionKind::Block(block) => look(Part::Block(block)),
            ActionKind::Break | ActionKind::Continue | ActionKind::Broken => {}
        }
    }
}
