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

/// Implements `Shift` for enums by shifting these bindings of each variant.
macro_rules! shift_variants {
    ($($node:ident { $($($pattern:pat_param)|+ => $($field:ident)*;)* })*) => {
        $(impl Shift for $node {
            fn shift(&mut self, by: i32) {
                use $node::*;
                match self {
                    $($($pattern)|+ => { $($field.shift(by);)* })*
                }
            }
        })*
    };
}

shift_variants! {
    Item {
        Use(item) => item;
        Attr(item) => item;
        Fn(item) => item;
        Op(item) => item;
        Script(item) => item;
        Test(item) => item;
        Broken(span) => span;
    }
    Condition {
        Require { condition, reason, span } => condition reason span;
        Guard { level, span } => level span;
        Alias { names, span } => names span;
    }
    Statement {
        Loop(orbit) => orbit;
        Vertex(star) => star;
        Edge { name, halfedges, span } => name halfedges span;
        New(names, span) | Erase(names, span) | Keep(names, span) => names span;
        Assign { target, attribute, value, span } => target attribute value span;
        Broken(span) => span;
    }
    Arrow {
        Halfedge(name) => name;
        Path(name) => name;
    }
    Spoke {
        Halfedge(name) => name;
        Fan(name, span) => name span;
    }
    ActionKind {
        Let { name, ty, value, .. } => name ty value;
        Assign { target, value } => target value;
        Repeat { count: head, body } | While { condition: head, body } => head body;
        For { parallel, variable, sequence, filter, body } =>
            parallel variable sequence filter body;
        Update { variable, sequence, filter, body } => variable sequence filter body;
        Drain { variable, sequence, key, condition, body } =>
            variable sequence key condition body;
        If { binding, condition, then, otherwise } => binding condition then otherwise;
        Print(values) => values;
        Assert { condition, reason } | Require { condition, reason } => condition reason;
        Return(value) => value;
        Block(block) => block;
        Expr(value) => value;
        Break | Continue | Broken =>;
    }
    ExprKind {
        Name(name) => name;
        Field(base, field) => base field;
        Call { function, args } => function args;
        Must(inner) | Asked(_, inner) | Unary(_, inner) => inner;
        Binary(_, left, right) | Range(left, right) => left right;
        If { condition, then, otherwise } => condition then otherwise;
        Aggregate { function, body, variable, sequence, filter } =>
            function body variable sequence filter;
        Bool(_) | Int(_) | Real(_) | Text(_) | Broken =>;
    }
    Shown {
        Value(value) => value;
        Text(pieces, span) => pieces span;
    }
    Piece {
        Value(value, _) => value;
        Text(_) =>;
    }
}
