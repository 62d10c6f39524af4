//! The tree: a file as it is written, before anything is known about its names.
//!
//! Every node carries its span. What could not be read stands as `Broken`, so that
//! one mistake never hides what follows.

use crate::source::Span;
use std::fmt;

/// A word with its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Ident {
    /// The word, with its primes.
    pub text: String,
    /// Where it stands.
    pub span: Span,
}

/// A file.
#[derive(Clone, Debug, PartialEq)]
pub struct File {
    /// Doc comments at the head of the file (`//!`), a line each.
    pub docs: Vec<String>,
    /// Its items, in order.
    pub items: Vec<Item>,
}

/// What stands at the top level.
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

/// `use "path"`
#[derive(Clone, Debug, PartialEq)]
pub struct Use {
    /// The path, without quotes.
    pub path: String,
    /// Where the path stands, with its quotes.
    pub path_span: Span,
    /// The whole item.
    pub span: Span,
}

/// `attr name: vertex real = 0`, perhaps `private`.
#[derive(Clone, Debug, PartialEq)]
pub struct Attr {
    /// Its doc comment, a line each.
    pub docs: Vec<String>,
    /// Whether it is a scratch attribute, never saved.
    pub private: bool,
    /// Its name.
    pub name: Ident,
    /// The kind of element that has it, as written.
    pub kind: Ident,
    /// The type of its values, as written.
    pub ty: Ident,
    /// The value it begins with.
    pub default: Option<Expr>,
    /// The whole item.
    pub span: Span,
}

/// A parameter: `e: edge`, `a[0]: halfedge`, `t: real = 0.5`.
#[derive(Clone, Debug, PartialEq)]
pub struct Param {
    /// Its name, perhaps with the index where a family begins.
    pub name: Name,
    /// Its type, as written; an empty word where there is none, which is a mistake.
    pub ty: Ident,
    /// Its default.
    pub default: Option<Expr>,
    /// The whole parameter.
    pub span: Span,
}

/// `fn name(…) -> type { … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Fn {
    /// Its doc comment.
    pub docs: Vec<String>,
    /// Its name.
    pub name: Ident,
    /// Its parameters.
    pub params: Vec<Param>,
    /// The type of its result, as written.
    pub result: Option<Ident>,
    /// Its body.
    pub body: Block,
    /// The whole item.
    pub span: Span,
}

/// `script name(…) { … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Script {
    /// Its doc comment.
    pub docs: Vec<String>,
    /// Its name.
    pub name: Ident,
    /// Its parameters.
    pub params: Vec<Param>,
    /// Its body.
    pub body: Block,
    /// The whole item.
    pub span: Span,
}

/// `test "…" { … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Test {
    /// What it is called.
    pub name: String,
    /// Its body.
    pub body: Block,
    /// The whole item.
    pub span: Span,
}

/// `op name(…) -> result keeps … { … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Op {
    /// Its doc comment, a line each, without `///`.
    pub docs: Vec<String>,
    /// Its name.
    pub name: Ident,
    /// Its parameters.
    pub params: Vec<Param>,
    /// What it returns: a name that it draws; of an op in steps, a type.
    pub result: Option<Ident>,
    /// The properties it must keep.
    pub keeps: Vec<Ident>,
    /// Its alternatives; an op without `rule` has one, unnamed, and one in steps has none.
    pub rules: Vec<Rule>,
    /// What it does instead of drawing.
    pub steps: Option<Steps>,
    /// The whole item, from `op` to the closing brace.
    pub span: Span,
}

/// `steps { … }`: an op that calls others, all or nothing.
#[derive(Clone, Debug, PartialEq)]
pub struct Steps {
    /// What is asked before.
    pub conditions: Vec<Condition>,
    /// What is done.
    pub body: Block,
}

/// One alternative of an op.
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    /// Its name, if it is written `rule name { … }`.
    pub name: Option<Ident>,
    /// The drawing before.
    pub before: Option<Side>,
    /// What is asked between the drawings.
    pub conditions: Vec<Condition>,
    /// The drawing after.
    pub after: Option<Side>,
    /// The whole rule; without `rule`, the braces of the op.
    pub span: Span,
}

/// `require …` or `guard …`
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    /// `require CONDITION else "REASON"`
    Require {
        /// What must hold.
        condition: Expr,
        /// The reason for a refusal.
        reason: Option<(String, Span)>,
        /// The whole statement.
        span: Span,
    },
    /// `guard LEVEL`
    Guard {
        /// The level.
        level: Ident,
        /// The whole statement.
        span: Span,
    },
    /// `alias v2 v3`
    Alias {
        /// The names that may stand for one element.
        names: Vec<Name>,
        /// The whole statement.
        span: Span,
    },
}

impl Condition {
    /// The whole statement.
    pub fn span(&self) -> Span {
        match self {
            Self::Require { span, .. } | Self::Guard { span, .. } | Self::Alias { span, .. } => {
                *span
            }
        }
    }
}

/// `before { … }` or `after { … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Side {
    /// Its statements.
    pub statements: Vec<Statement>,
    /// From the keyword to the closing brace.
    pub span: Span,
}

/// A name of a diagram, perhaps a family: `v0`, `h'`, `v[i+1]`.
#[derive(Clone, Debug, PartialEq)]
pub struct Name {
    /// The word.
    pub ident: Ident,
    /// The subscript.
    pub index: Option<Index>,
    /// Word and subscript.
    pub span: Span,
}

/// As it is written: `v`, `v[i+1]`.
impl fmt::Display for Name {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.ident.text)?;
        let Some(Index {
            variable, offset, ..
        }) = &self.index
        else {
            return Ok(());
        };
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
    /// What is added to it.
    pub offset: i64,
    /// What stands between the brackets.
    pub span: Span,
}

/// Which loops a loop statement matches.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LoopKeyword {
    /// `face`: interior faces.
    Face,
    /// `hole`: boundary loops.
    Hole,
    /// `loop`: both.
    Loop,
}

/// A statement of a drawing.
#[derive(Clone, Debug, PartialEq)]
pub enum Statement {
    /// `face f0: v0 -a-> v1 =P=> v0`
    Loop(Loop),
    /// `edge e: a | d`
    Edge {
        /// The edge.
        name: Name,
        /// Its two halfedges.
        halfedges: [Name; 2],
        /// The whole statement.
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
    Assign {
        /// The element.
        target: Name,
        /// The attribute.
        attribute: Ident,
        /// The value.
        value: Expr,
        /// The whole statement.
        span: Span,
    },
    /// Something that could not be read.
    Broken(Span),
}

/// `face f0: v0 -a-> v1 =P=> v0` or `face f: each i { v[i] -h[i]-> }`
#[derive(Clone, Debug, PartialEq)]
pub struct Loop {
    /// Its keyword.
    pub keyword: LoopKeyword,
    /// The face.
    pub name: Name,
    /// The index variable, if the loop is written with `each`.
    pub each: Option<Ident>,
    /// From each vertex, the halfedge or path that leaves it.
    pub items: Vec<LoopItem>,
    /// The vertex after the last item; `None` with `each`. It should be the first again.
    pub end: Option<Name>,
    /// The whole statement.
    pub span: Span,
}

/// A vertex and what leaves it.
#[derive(Clone, Debug, PartialEq)]
pub struct LoopItem {
    /// The vertex.
    pub from: Name,
    /// `-a->`, `=P=>` or `=>`.
    pub arrow: Arrow,
    /// The arrow's place.
    pub span: Span,
}

/// `-a->`, `=P=>` or `=>`
#[derive(Clone, Debug, PartialEq)]
pub enum Arrow {
    /// One halfedge.
    Halfedge(Name),
    /// A run of zero or more halfedges.
    Path(Option<Name>),
}

/// `vertex v: a b *S` or `vertex v: each i { h[i] }`
#[derive(Clone, Debug, PartialEq)]
pub struct Star {
    /// The vertex.
    pub name: Name,
    /// The index variable, if written with `each`.
    pub each: Option<Ident>,
    /// Its spokes, counterclockwise.
    pub spokes: Vec<Spoke>,
    /// The whole statement.
    pub span: Span,
}

/// A spoke or a run of spokes.
#[derive(Clone, Debug, PartialEq)]
pub enum Spoke {
    /// One halfedge.
    Halfedge(Name),
    /// `*S` or `*`
    Fan(Option<Name>, Span),
}

/// `{ … }`
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Its statements.
    pub statements: Vec<Action>,
    /// With its braces.
    pub span: Span,
}

/// A statement of a script, function or test.
#[derive(Clone, Debug, PartialEq)]
pub struct Action {
    /// What it is.
    pub kind: ActionKind,
    /// The whole statement.
    pub span: Span,
}

/// What a statement does.
#[derive(Clone, Debug, PartialEq)]
pub enum ActionKind {
    /// `let x = …` or `var x = …`, perhaps with a type
    Let {
        mutable: bool,
        name: Ident,
        ty: Option<Ident>,
        value: Expr,
    },
    /// `x = …`, `v.position = …`
    Assign { target: Expr, value: Expr },
    /// `repeat n { … }`
    Repeat { count: Expr, body: Block },
    /// `for x in xs where c { … }`
    For {
        variable: Ident,
        sequence: Expr,
        filter: Option<Expr>,
        body: Block,
    },
    /// `while c { … }`
    While { condition: Expr, body: Block },
    /// `drain x in xs by key while c { … }`
    Drain {
        variable: Ident,
        sequence: Expr,
        key: Expr,
        condition: Option<Expr>,
        body: Block,
    },
    /// `update x in xs where c { … }`
    Update {
        variable: Ident,
        sequence: Expr,
        filter: Option<Expr>,
        body: Block,
    },
    /// `if c { … } else { … }`, `if let m = split(e) { … }`
    If {
        binding: Option<Ident>,
        condition: Expr,
        then: Block,
        otherwise: Option<Block>,
    },
    /// `print a, b`, `print "a {b:.3}"`
    Print(Vec<Shown>),
    /// `assert c else "…"`
    Assert {
        condition: Expr,
        reason: Option<(String, Span)>,
    },
    /// `require c else "…"`, in the steps of an op
    Require {
        condition: Expr,
        reason: Option<(String, Span)>,
    },
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

/// What is printed between two commas.
#[derive(Clone, Debug, PartialEq)]
pub enum Shown {
    /// A value.
    Value(Expr),
    /// `"mean {mean(len):.3} of {n}"`, and where it stands.
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

/// A piece of a text with values in it.
#[derive(Clone, Debug, PartialEq)]
pub enum Piece {
    /// What stands between the values, escapes undone.
    Text(String),
    /// `{x}`, `{x:.3}`
    Value(Expr, Digits),
}

/// How many digits of a real are printed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Digits {
    /// `{x}`: as many as a reader wants, six significant ones
    Few,
    /// `{x:full}`: as many as read back as the same number
    All,
    /// `{x:.3}`: so many behind the point
    Behind(u8),
}

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Where it stands.
    pub span: Span,
}

/// An operator with one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnaryOp {
    /// `-x`
    Negate,
    /// `not x`
    Not,
}

/// An operator with two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
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

/// What an expression is.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// `true`, `false`
    Bool(bool),
    /// `3`
    Int(i64),
    /// `0.5`, `1e-3`
    Real(f64),
    /// `"text"`, escapes undone
    Text(String),
    /// `x`, `v[i+1]`
    Name(Name),
    /// `x.field`
    Field(Box<Expr>, Ident),
    /// `f(x, y)`
    Call { function: Ident, args: Vec<Expr> },
    /// `must f(x)`
    Must(Box<Expr>),
    /// `-x`, `not x`
    Unary(UnaryOp, Box<Expr>),
    /// `x + y`
    Binary(BinaryOp, Box<Expr>, Box<Expr>),
    /// `if c { x } else { y }`
    If {
        condition: Box<Expr>,
        then: Box<Block>,
        otherwise: Box<Block>,
    },
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
