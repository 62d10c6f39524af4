//! The tree: a file as it is written, before anything is known about its names.
//!
//! Every node carries its span. What could not be read stands as `Broken`, so that
//! one mistake never hides what follows.

mod items;

mod drawing;

mod action;
mod expression;

pub use action::{Action, ActionKind, Block, Digits, Piece, Shown};
pub use drawing::{Arrow, Index, Loop, LoopItem, LoopKeyword, Name, Side, Spoke, Star, Statement};
pub use expression::{Asking, BinaryOp, Expr, ExprKind, Ident, UnaryOp};
pub use items::{Attr, Condition, File, Fn, Item, Op, Param, Rule, Script, Steps, Test, Use};
