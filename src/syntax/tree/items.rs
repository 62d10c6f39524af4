//! Items: the top level of a file.

use super::{Block, Expr, Ident, Name, Side};
use crate::source::Span;

#[derive(Clone, Debug, PartialEq)]
pub struct File {
    /// The doc comment at the head of the file (`//!`), one entry per line.
    pub docs: Vec<String>,
    /// Its items, in order.
    pub items: Vec<Item>,
    /// The spans of what could not be read as it is written, in order: what the tree has of the
    /// items there may not be what was meant.
    pub misread: Vec<Span>,
}

impl File {
    /// True if some part of an item could not be read as it is written.
    pub fn is_misread(&self, item: Span) -> bool {
        let first = self.misread.partition_point(|misread| misread.end <= item.start);
        self.misread.get(first).is_some_and(|misread| misread.start < item.end)
    }
}

/// An item at the top level.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// `use "path"`
    Use(Use),
    /// `attr name: vertex real = 0`
    Attr(Attr),
    /// `fn name(…) -> type { … }`
    Fn(Fn),
    /// `op name(…) { … }`
    Op(Op),
    /// `script name(…) { … }`
    Script(Script),
    /// `test "…" { … }`
    Test(Test),
    /// Something that could not be read.
    Broken(Span),
}

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

    pub(crate) fn op(&self) -> Option<&Op> {
        match self {
            Item::Op(op) => Some(op),
            _ => None,
        }
    }

    /// Its name, if others can call it by one, and whether it is `private`.
    fn declared(&self) -> Option<(&Ident, bool)> {
        Some(match self {
            Self::Attr(attr) => (&attr.name, attr.private),
            Self::Fn(function) => (&function.name, function.private),
            Self::Op(op) => (&op.name, op.private),
            Self::Script(script) => (&script.name, script.private),
            Self::Use(_) | Self::Test(_) | Self::Broken(_) => return None,
        })
    }

    /// Its name, if others can call it by one.
    pub fn name(&self) -> Option<&Ident> {
        Some(self.declared()?.0)
    }

    /// Its name, if it is `private`.
    pub fn private_name(&self) -> Option<&Ident> {
        self.declared().filter(|&(_, private)| private).map(|(name, _)| name)
    }
}

/// `use "path"`
#[derive(Clone, Debug, PartialEq)]
pub struct Use {
    /// The path, without quotes.
    pub path: String,
    /// The span of the path, with its quotes.
    pub path_span: Span,
    pub span: Span,
}

/// `attr name: vertex real = 0`, optionally `private`.
#[derive(Clone, Debug, PartialEq)]
pub struct Attr {
    /// Its doc comment, one entry per line.
    pub docs: Vec<String>,
    /// True if it is `private`: visible only in its file, and never saved.
    pub private: bool,
    pub name: Ident,
    /// The kind of element that has it, as written.
    pub kind: Ident,
    /// The type of its values, as written.
    pub ty: Ident,
    pub default: Option<Expr>,
    pub span: Span,
}

/// A parameter: `e: edge`, `a[0]: halfedge`, `t: real = 0.5`.
#[derive(Clone, Debug, PartialEq)]
pub struct Param {
    /// Its name, optionally with the index where a family begins.
    pub name: Name,
    /// Its type, as written; empty if it is missing, which is a mistake.
    pub ty: Ident,
    pub default: Option<Expr>,
    pub span: Span,
}

/// `fn name(…) -> type { … }`, optionally `private`.
#[derive(Clone, Debug, PartialEq)]
pub struct Fn {
    pub docs: Vec<String>,
    /// True if it is `private`: visible only in its file.
    pub private: bool,
    pub name: Ident,
    pub params: Vec<Param>,
    /// The type of its result, as written.
    pub result: Option<Ident>,
    pub body: Block,
    pub span: Span,
}

/// `script name(…) { … }`, optionally `private`.
#[derive(Clone, Debug, PartialEq)]
pub struct Script {
    pub docs: Vec<String>,
    /// True if it is `private`: visible only in its file.
    pub private: bool,
    pub name: Ident,
    pub params: Vec<Param>,
    pub body: Block,
    pub span: Span,
}

/// `test "…" { … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Test {
    pub name: String,
    /// The span of its name, with the quotes.
    pub name_span: Span,
    pub body: Block,
    pub span: Span,
}

/// `op name(…) -> result keeps … { … }`, optionally `private`.
#[derive(Clone, Debug, PartialEq)]
pub struct Op {
    /// Its doc comment, one entry per line, without `///`.
    pub docs: Vec<String>,
    /// True if it is `private`: visible only in its file.
    pub private: bool,
    pub name: Ident,
    pub params: Vec<Param>,
    /// The result: a name that it draws, or, for an op in steps, a type.
    pub result: Option<Ident>,
    /// The properties it must keep.
    pub keeps: Vec<Ident>,
    /// Its alternatives: one without a name if there is no `rule`, none for an op in steps.
    pub rules: Vec<Rule>,
    /// The steps, for an op in steps.
    pub steps: Option<Steps>,
    /// The span of the whole item, to the closing brace.
    pub span: Span,
}

/// `steps { … }`: calls of other ops as one transaction (all or nothing).
#[derive(Clone, Debug, PartialEq)]
pub struct Steps {
    /// The conditions that are tested first.
    pub conditions: Vec<Condition>,
    pub body: Block,
}

/// One alternative of an op.
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    /// Its name, if it is written `rule name { … }`.
    pub name: Option<Ident>,
    pub before: Option<Side>,
    /// The conditions between the drawings.
    pub conditions: Vec<Condition>,
    pub after: Option<Side>,
    /// The span of the whole rule; without `rule`, of the braces of the op.
    pub span: Span,
}

/// `require …`, `guard …` or `alias …`
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    /// `require CONDITION else "REASON"`
    Require { condition: Expr, reason: Option<(String, Span)>, span: Span },
    /// `guard LEVEL`
    Guard { level: Ident, span: Span },
    /// `alias v2 v3`
    Alias { names: Vec<Name>, span: Span },
}

impl Condition {
    /// The span of the whole statement.
    pub fn span(&self) -> Span {
        match self {
            Self::Require { span, .. } | Self::Guard { span, .. } | Self::Alias { span, .. } => {
                *span
            }
        }
    }
}
