//! Statements of scripts, functions and tests.

use super::{Expr, Ident};
use crate::source::Span;

/// `{ … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    pub statements: Vec<Action>,
    /// Its span, braces included.
    pub span: Span,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Action {
    pub kind: ActionKind,
    pub span: Span,
}

#[derive(Clone, Debug, PartialEq)]
pub enum ActionKind {
    /// `let x = …` or `var x = …`, optionally with a type.
    Let { mutable: bool, name: Ident, ty: Option<Ident>, value: Expr },
    /// `x = …`, `v.position = …`
    Assign { target: Expr, value: Expr },
    /// `repeat n { … }`
    Repeat { count: Expr, body: Block },
    /// `for x in xs where c { … }`, `for i in 0..n { … }`, `parallel for x in xs where c { … }` with
    /// the place of `parallel for`.
    For {
        parallel: Option<Span>,
        variable: Ident,
        sequence: Expr,
        filter: Option<Expr>,
        body: Block,
    },
    /// `while c { … }`
    While { condition: Expr, body: Block },
    /// `drain x in xs by key while c { … }`
    Drain { variable: Ident, sequence: Expr, key: Expr, condition: Option<Expr>, body: Block },
    /// `update x in xs where c { … }`
    Update { variable: Ident, sequence: Expr, filter: Option<Expr>, body: Block },
    /// `if c { … } else { … }`, `if let m = split(e) { … }`
    If { binding: Option<Ident>, condition: Expr, then: Block, otherwise: Option<Block> },
    /// `print a, b`, `print "a {b:.3}"`
    Print(Vec<Shown>),
    /// `assert c else "…"`
    Assert { condition: Expr, reason: Option<(String, Span)> },
    /// `require c else "…"`, in the steps of an op.
    Require { condition: Expr, reason: Option<(String, Span)> },
    /// `return`, `return x`
    Return(Option<Expr>),
    /// `break`
    Break,
    /// `continue`
    Continue,
    /// `{ … }`
    Block(Block),
    /// A call, or the value of a block.
    Expr(Expr),
    /// Something that could not be read.
    Broken,
}

/// A part of `print` between two commas.
#[derive(Clone, Debug, PartialEq)]
pub enum Shown {
    Value(Expr),
    /// `"mean {mean(len):.3} of {n}"`, with its span.
    Text(Vec<Piece>, Span),
}

impl Shown {
    /// The values in it, in order.
    pub fn values(&self) -> impl Iterator<Item = &Expr> {
        let (alone, pieces) = match self {
            Self::Value(value) => (Some(value), [].as_slice()),
            Self::Text(pieces, _) => (None, pieces.as_slice()),
        };
        let inside = pieces.iter().filter_map(|piece| match piece {
            Piece::Text(_) => None,
            Piece::Value(value, _) => Some(value),
        });
        alone.into_iter().chain(inside)
    }
}

/// A piece of a text with embedded values.
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// The text between values, with escapes decoded.
    Text(String),
    /// `{x}`, `{x:.3}`
    Value(Expr, Digits),
}

/// The number of digits of a real that are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Digits {
    /// `{x}`: six significant digits.
    Few,
    /// `{x:full}`: as many as needed to read back the same number.
    All,
    /// `{x:.3}`: this many after the point.
    Behind(u8),
}
