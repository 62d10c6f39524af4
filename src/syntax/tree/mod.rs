//! The syntax tree: a file as written, before names are resolved.
//!
//! Every node has its span. Parts that could not be read become `Broken`, so that one mistake never
//! hides what follows.

mod items;

mod drawing;

mod action;
mod expression;

pub use action::{Action, ActionKind, Block, Digits, Piece, Shown};
pub use drawing::{Arrow, Index, Loop, LoopItem, LoopKeyword, Name, Side, Spoke, Star, Statement};
pub use expression::{
    Asking, BinaryOp, Expr, ExprKind, Ident, UnaryOp, qualified, split_qualified,
};
pub use items::{Attr, Condition, File, Fn, Item, Op, Param, Rule, Script, Steps, Test, Use};
