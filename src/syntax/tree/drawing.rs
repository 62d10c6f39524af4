//! Drawings: loops, edges, stars, lists and assignments.

use std::fmt;

use super::{Expr, Ident};
use crate::source::Span;

/// `before { … }` or `after { … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Side {
    pub statements: Vec<Statement>,
    /// From the keyword to the closing brace.
    pub span: Span,
}

/// A name in a drawing, possibly a family: `v0`, `h'`, `v[i+1]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    pub ident: Ident,
    /// The subscript.
    pub index: Option<Index>,
    /// The span of word and subscript.
    pub span: Span,
}

/// Formats the name as written: `v`, `v[i+1]`.
impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.ident.text)?;
        let Some(Index { variable, offset, .. }) = &self.index else { return Ok(()) };
        match variable {
            None => write!(f, "[{offset}]"),
            Some(Ident { text, .. }) if *offset == 0 => write!(f, "[{text}]"),
            Some(Ident { text, .. }) => write!(f, "[{text}{offset:+}]"),
        }
    }
}

/// A subscript: an index variable plus a constant, or a constant alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Index {
    /// The variable, or `None` in `a[0]`.
    pub variable: Option<Ident>,
    pub offset: i64,
    /// The span between the brackets.
    pub span: Span,
}

/// The loops that a loop statement matches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LoopKeyword {
    /// `face`: interior faces.
    Face,
    /// `hole`: boundary loops.
    Hole,
    /// `loop`: both.
    Loop,
}

#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// `face f0: v0 -a-> v1 =P=> v0`
    Loop(Loop),
    /// `edge e: a | d`
    Edge {
        name: Name,
        /// Its two halfedges.
        halfedges: [Name; 2],
        span: Span,
    },
    /// `vertex v: a b *S`
    Vertex(Star),
    /// `new m p q`
    New(Vec<Name>, Span),
    /// `erase v1 e`
    Erase(Vec<Name>, Span),
    /// `keep e1 e2`
    Keep(Vec<Name>, Span),
    /// `v.position = …`
    Assign { target: Name, attribute: Ident, value: Expr, span: Span },
    /// Something that could not be read.
    Broken(Span),
}

impl Statement {
    /// The keyword and the names of a list.
    pub(crate) fn listed(&self) -> Option<(&'static str, &[Name])> {
        match self {
            Statement::New(names, _) => Some(("new", names)),
            Statement::Erase(names, _) => Some(("erase", names)),
            Statement::Keep(names, _) => Some(("keep", names)),
            _ => None,
        }
    }

    /// The span of the whole statement.
    pub(crate) fn span(&self) -> Span {
        match self {
            Statement::Loop(orbit) => orbit.span,
            Statement::Vertex(star) => star.span,
            Statement::Edge { span, .. } | Statement::Assign { span, .. } => *span,
            Statement::New(_, span) | Statement::Erase(_, span) => *span,
            Statement::Keep(_, span) | Statement::Broken(span) => *span,
        }
    }
}

/// `face f0: v0 -a-> v1 =P=> v0` or `face f: each i { v[i] -h[i]-> }`
#[derive(Clone, Debug, PartialEq)]
pub struct Loop {
    pub keyword: LoopKeyword,
    pub name: Name,
    /// The index variable, if the loop is written with `each`.
    pub each: Option<Ident>,
    /// The vertices in order, each with the halfedge or path that leaves it.
    pub items: Vec<LoopItem>,
    /// The vertex after the last item, which should be the first one again; `None` with `each`.
    pub end: Option<Name>,
    pub span: Span,
}

/// A vertex and the halfedge or path that leaves it.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopItem {
    pub from: Name,
    /// `-a->`, `=P=>` or `=>`.
    pub arrow: Arrow,
    /// The arrow's place.
    pub span: Span,
}

/// `-a->`, `=P=>` or `=>`
#[derive(Clone, Debug, PartialEq)]
pub enum Arrow {
    Halfedge(Name),
    /// A run of zero or more halfedges.
    Path(Option<Name>),
}

/// `vertex v: a b *S` or `vertex v: each i { h[i] }`
#[derive(Clone, Debug, PartialEq)]
pub struct Star {
    pub name: Name,
    /// The index variable, if written with `each`.
    pub each: Option<Ident>,
    /// Its spokes, counterclockwise.
    pub spokes: Vec<Spoke>,
    pub span: Span,
}

/// A spoke or a run of spokes.
#[derive(Clone, Debug, PartialEq)]
pub enum Spoke {
    Halfedge(Name),
    /// `*S` or `*`
    Fan(Option<Name>, Span),
}
