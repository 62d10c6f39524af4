//! Identifiers and expressions.

use super::{Block, Name};
use crate::source::Span;

/// The mark between a qualifier and a name.
const QUALIFIES: &str = "::";

/// A word with its place, or the qualified name of what is called.
#[derive(Clone, Debug, PartialEq)]
pub struct Ident {
    /// The word, with its primes.
    pub text: String,
    pub span: Span,
}

impl Ident {
    /// The place of the name alone: of `flip` in `triangle::flip`.
    pub fn name_span(&self) -> Span {
        match split_qualified(&self.text) {
            (None, _) => self.span,
            (Some(_), name) => {
                let start = self.span.end.saturating_sub(name.len() as u32);
                Span { start, ..self.span }
            }
        }
    }
}

/// A qualified name: the qualifier stands for the file that declares it.
pub fn qualified(qualifier: &str, name: &str) -> String {
    format!("{qualifier}{QUALIFIES}{name}")
}

/// The qualifier of a name, if it has one, and the name alone.
pub fn split_qualified(name: &str) -> (Option<&str>, &str) {
    name.split_once(QUALIFIES).map_or((None, name), |(file, name)| (Some(file), name))
}

#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    pub kind: ExprKind,
    pub span: Span,
}

impl Expr {
    /// The identifier, if the expression is only a name.
    pub fn plain_name(&self) -> Option<&Ident> {
        match &self.kind {
            ExprKind::Name(name) if name.index.is_none() => Some(&name.ident),
            _ => None,
        }
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnaryOp {
    /// `-x`
    Negate,
    /// `not x`
    Not,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BinaryOp {
    Add,
    Subtract,
    Multiply,
    Divide,
    Div,
    Mod,
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    And,
    Or,
}

/// A query about an op that does not apply it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Asking {
    /// `can flip(e)`: whether it would apply.
    Can,
    /// `why flip(e)`: why it would refuse.
    Why,
}

#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// `true`, `false`
    Bool(bool),
    /// `3`
    Int(i64),
    /// `0.5`, `1e-3`
    Real(f64),
    /// `"text"`, with escapes decoded.
    Text(String),
    /// `x`, `v[i+1]`
    Name(Name),
    /// `x.field`
    Field(Box<Expr>, Ident),
    /// `f(x, y)`, `file::f(x, y)`
    Call { function: Ident, args: Vec<Expr> },
    /// `must f(x)`
    Must(Box<Expr>),
    /// `can f(x)`, `why f(x)`
    Asked(Asking, Box<Expr>),
    /// `-x`, `not x`
    Unary(UnaryOp, Box<Expr>),
    /// `x + y`
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// `x..y`: the ints from x up to, but without, y; only where a sequence is wanted.
    Range(Box<Expr>, Box<Expr>),
    /// `if c { x } else { y }`
    If { condition: Box<Expr>, then: Box<Block>, otherwise: Box<Block> },
    /// `mean(x for e in edges where c)`
    Aggregate {
        function: Ident,
        body: Box<Expr>,
        variable: Ident,
        sequence: Box<Expr>,
        filter: Option<Box<Expr>>,
    },
    /// Something that could not be read.
    Broken,
}
