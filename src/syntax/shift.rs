//! The span of an item, and moving an item to another place.

use super::tree::{
    Action, ActionKind, Arrow, Attr, Block, Condition, Expr, ExprKind, Fn, Ident, Index, Item,
    Loop, LoopItem, Name, Op, Param, Piece, Rule, Script, Shown, Side, Spoke, Star, Statement,
    Steps, Test, Use,
};
use crate::source::Span;

impl Item {
    /// The span of the whole item.
    pub fn span(&self) -> Span {
        match self {
            Item::Use(item) => item.span,
            Item::Attr(item) => item.span,
            Item::Fn(item) => item.span,
            Item::Op(item) => item.span,
            Item::Script(item) => item.span,
            Item::Test(item) => item.span,
            Item::Broken(span) => *span,
        }
    }
}

/// The item with all its spans moved by `by` bytes.
pub(super) fn moved(item: &Item, by: i32) -> Item {
    let mut item = item.clone();
    if by != 0 {
        item.shift(by);
    }
    item
}

/// Something with spans that can be moved.
trait Shift {
    fn shift(&mut self, by: i32);
}

impl<T: Shift> Shift for Vec<T> {
    fn shift(&mut self, by: i32) {
        self.iter_mut().for_each(|part| part.shift(by));
    }
}

impl<T: Shift> Shift for [T; 2] {
    fn shift(&mut self, by: i32) {
        self.iter_mut().for_each(|part| part.shift(by));
    }
}

impl<T: Shift> Shift for Option<T> {
    fn shift(&mut self, by: i32) {
        self.iter_mut().for_each(|part| part.shift(by));
    }
}

impl<T: Shift> Shift for Box<T> {
    fn shift(&mut self, by: i32) {
        self.as_mut().shift(by);
    }
}

impl Shift for (String, Span) {
    fn shift(&mut self, by: i32) {
        self.1.shift(by);
    }
}

impl Shift for Span {
    fn shift(&mut self, by: i32) {
        self.start = self.start.saturating_add_signed(by);
        self.end = self.end.saturating_add_signed(by);
    }
}

/// Implements `Shift` for nodes by shifting these fields.
macro_rules! shift {
    ($($node:ty: $($field:ident)*;)*) => {
        $(impl Shift for $node {
            fn shift(&mut self, by: i32) {
                $(self.$field.shift(by);)*
            }
        })*
    };
}

shift! {
    Ident: span;
    Use: path_span span;
    Attr: name kind ty default span;
    Param: name ty default span;
    Fn: name params result body span;
    Script: name params body span;
    Test: name_span body span;
    Op: name params result keeps rules steps span;
    Steps: conditions body;
    Rule: name before conditions after span;
    Side: statements span;
    Name: ident index span;
    Index: variable span;
    Loop: name each items end span;
    LoopItem: from arrow span;
    Star: name each spokes span;
    Block: statements span;
    Action: kind span;
    Expr: kind span;
}

impl Shift for Item {
    fn shift(&mut self, by: i32) {
        match self {
            Item::Use(item) => item.shift(by),
            Item::Attr(item) => item.shift(by),
            Item::Fn(item) => item.shift(by),
            Item::Op(item) => item.shift(by),
            Item::Script(item) => item.shift(by),
            Item::Test(item) => item.shift(by),
            Item::Broken(span) => span.shift(by),
        }
    }
}

impl Shift for Condition {
    fn shift(&mut self, by: i32) {
        match self {
            Condition::Require { condition, reason, span } => {
                condition.shift(by);
                reason.shift(by);
                span.shift(by);
            }
            Condition::Guard { level, span } => {
                level.shift(by);
                span.shift(by);
            }
            Condition::Alias { names, span } => {
                names.shift(by);
                span.shift(by);
            }
        }
    }
}

impl Shift for Statement {
    fn shift(&mut self, by: i32) {
        match self {
            Statement::Loop(orbit) => orbit.shift(by),
            Statement::Vertex(star) => star.shift(by),
            Statement::Edge { name, halfedges, span } => {
                name.shift(by);
                halfedges.shift(by);
                span.shift(by);
            }
            Statement::New(names, span)
            | Statement::Erase(names, span)
            | Statement::Keep(names, span) => {
                names.shift(by);
                span.shift(by);
            }
            Statement::Assign { target, attribute, value, span } => {
                target.shift(by);
                attribute.shift(by);
                value.shift(by);
                span.shift(by);
            }
            Statement::Broken(span) => span.shift(by),
        }
    }
}

impl Shift for Arrow {
    fn shift(&mut self, by: i32) {
        match self {
            Arrow::Halfedge(name) => name.shift(by),
            Arrow::Path(name) => name.shift(by),
        }
    }
}

impl Shift for Spoke {
    fn shift(&mut self, by: i32) {
        match self {
            Spoke::Halfedge(name) => name.shift(by),
            Spoke::Fan(name, span) => {
                name.shift(by);
                span.shift(by);
            }
        }
    }
}

impl Shift for ActionKind {
    fn shift(&mut self, by: i32) {
        match self {
            ActionKind::Let { name, ty, value, .. } => {
                name.shift(by);
                ty.shift(by);
                value.shift(by);
            }
            ActionKind::Assign { target, value } => {
                target.shift(by);
                value.shift(by);
            }
            ActionKind::Repeat { count: head, body }
            | ActionKind::While { condition: head, body } => {
                head.shift(by);
                body.shift(by);
            }
            ActionKind::For { parallel, variable, sequence, filter, body } => {
                parallel.shift(by);
                variable.shift(by);
                sequence.shift(by);
                filter.shift(by);
                body.shift(by);
            }
            ActionKind::Update { variable, sequence, filter, body } => {
                variable.shift(by);
                sequence.shift(by);
                filter.shift(by);
                body.shift(by);
            }
            ActionKind::Drain { variable, sequence, key, condition, body } => {
                variable.shift(by);
                sequence.shift(by);
                key.shift(by);
                condition.shift(by);
                body.shift(by);
            }
            ActionKind::If { binding, condition, then, otherwise } => {
                binding.shift(by);
                condition.shift(by);
                then.shift(by);
                otherwise.shift(by);
            }
            ActionKind::Print(values) => values.shift(by),
            ActionKind::Assert { condition, reason }
            | ActionKind::Require { condition, reason } => {
                condition.shift(by);
                reason.shift(by);
            }
            ActionKind::Return(value) => value.shift(by),
            ActionKind::Block(block) => block.shift(by),
            ActionKind::Expr(value) => value.shift(by),
            ActionKind::Break | ActionKind::Continue | ActionKind::Broken => {}
        }
    }
}

impl Shift for ExprKind {
    fn shift(&mut self, by: i32) {
        match self {
            ExprKind::Name(name) => name.shift(by),
            ExprKind::Field(base, field) => {
                base.shift(by);
                field.shift(by);
            }
            ExprKind::Call { function, args } => {
                function.shift(by);
                args.shift(by);
            }
            ExprKind::Must(inner) | ExprKind::Asked(_, inner) | ExprKind::Unary(_, inner) => {
                inner.shift(by);
            }
            ExprKind::Binary(_, left, right) | ExprKind::Range(left, right) => {
                left.shift(by);
                right.shift(by);
            }
            ExprKind::If { condition, then, otherwise } => {
                condition.shift(by);
                then.shift(by);
                otherwise.shift(by);
            }
            ExprKind::Aggregate { function, body, variable, sequence, filter } => {
                function.shift(by);
                body.shift(by);
                variable.shift(by);
                sequence.shift(by);
                filter.shift(by);
            }
            ExprKind::Bool(_)
            | ExprKind::Int(_)
            | ExprKind::Real(_)
            | ExprKind::Text(_)
            | ExprKind::Broken => {}
        }
    }
}

impl Shift for Shown {
    fn shift(&mut self, by: i32) {
        match self {
            Shown::Value(value) => value.shift(by),
            Shown::Text(pieces, span) => {
                pieces.shift(by);
                span.shift(by);
            }
        }
    }
}

impl Shift for Piece {
    fn shift(&mut self, by: i32) {
        if let Piece::Value(value, _) = self {
            value.shift(by);
        }
    }
}
