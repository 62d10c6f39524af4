//! A routine: pointer code without the spelling of any language.
//!
//! A small imperative language with just what operations need: names that are bound once,
//! pointers that are followed and set, tests that refuse, walks along loops and around
//! vertices. [`build`](super::build) writes it; a printer per language spells it.

use crate::diagram::{Binary, Builtin, FoldFunction, Kind, Pointer, Type, Unary};

/// An operation as a routine.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Routine {
    /// Its name.
    pub name: String,
    /// Its doc comment, a line each.
    pub docs: Vec<String>,
    /// Its parameters.
    pub params: Vec<Parameter>,
    /// The type of its result; without one it tells whether it applied.
    pub result: Option<Type>,
    /// The alternatives, tried in order.
    pub rules: Vec<Alternative>,
}

/// A parameter of a routine.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Parameter {
    pub name: String,
    pub ty: Type,
}

/// One alternative of a routine.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Alternative {
    /// Its name, where it has one.
    pub label: Option<String>,
    /// Its statements.
    pub body: Vec<Statement>,
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Statement {
    /// A line in words.
    Comment(String),
    /// An empty line.
    Blank,
    /// A name for a value.
    Bind { ty: Type, name: String, value: Term },
    /// Tries the halfedges of an element in turn; what is refused in the body goes on with the
    /// next one.
    Attempt {
        kind: Kind,
        element: String,
        halfedge: String,
        body: Vec<Statement>,
    },
    /// Refuses the place.
    Refuse { when: Term, reason: String },
    /// A list that grows.
    List {
        ty: Type,
        name: String,
        items: Vec<Term>,
    },
    /// Adds to a list.
    Push { list: String, item: Term },
    /// A count, or a truth value, that changes.
    Tally { ty: Type, name: String, value: Term },
    /// Gives it another value.
    Change { name: String, value: Term },
    /// One more.
    Raise { name: String },
    /// Only where something holds.
    When {
        condition: Term,
        body: Vec<Statement>,
    },
    /// For each halfedge of a walk.
    Walk { walk: Walk, body: Vec<Statement> },
    /// For each element of a list.
    Each {
        item: String,
        list: String,
        body: Vec<Statement>,
    },
    /// Allocates an element.
    New { kind: Kind, name: String },
    /// `of.pointer = value`
    Set {
        pointer: Pointer,
        of: Term,
        value: Term,
    },
    /// Makes a face a hole, or a hole a face.
    SetHole { face: Term, hole: bool },
    /// `vertex.position = value`
    SetPosition { vertex: Term, value: Term },
    /// Erases an element.
    Erase { kind: Kind, name: String },
    /// Done.
    Return { result: Option<Term> },
}

/// A walk over halfedges. Nothing that it follows is written while it goes on, but the
/// `face` or `vertex` of the halfedges themselves.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Walk {
    /// The name of the halfedge.
    pub halfedge: String,
    /// What follows what.
    pub step: Step,
    /// The first.
    pub from: Term,
    /// What comes behind the last; if it is the first, the walk is empty.
    pub until: Term,
    /// Whether a walk whose end is its start goes all the way around instead.
    pub around: bool,
}

/// How a walk goes on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// `h.next`, along a loop.
    Next,
    /// `h.twin.next`, clockwise around a vertex: no `prev` is needed.
    Clockwise,
}

/// A value.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Term {
    Name(String),
    Bool(bool),
    Int(i64),
    Real(f64),
    /// `h.next`, `v.halfedge`
    Follow(Pointer, Box<Term>),
    /// `v.position`
    Position(Box<Term>),
    /// Whether a face is a hole.
    Hole(Box<Term>),
    Component(u8, Box<Term>),
    Vector(Box<[Term; 3]>),
    Unary(Unary, Box<Term>),
    Binary(Binary, Box<Term>, Box<Term>),
    Call(Function, Vec<Term>),
    If(Box<Term>, Box<Term>, Box<Term>),
    Fold(Box<Fold>),
}

/// An aggregate.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Fold {
    pub function: FoldFunction,
    pub ty: Type,
    pub variable: Parameter,
    pub around: Around,
    pub element: Term,
    pub filter: Option<Term>,
    pub body: Term,
    pub body_type: Type,
}

/// What an aggregate runs over, around one element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Around {
    VertexHalfedges,
    VertexEdges,
    VertexFaces,
    VertexNeighbors,
    FaceHalfedges,
    FaceVertices,
    FaceEdges,
    EdgeVertices,
    EdgeFaces,
}

/// A function that is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Function {
    /// One of the language.
    Builtin(Builtin),
    /// Whether going along a loop from the first halfedge the second comes before the third.
    InOrderAlongLoop,
    /// The same around a vertex, counterclockwise.
    InOrderAroundVertex,
    /// Whether no element stands twice in a list.
    AllDiffer,
    /// Whether a list holds an element.
    Holds,
    /// Whether two lists without repetitions hold the same.
    SameElements,
    /// Whether all parts of a vector are finite.
    IsFinite,
}

impl Term {
    pub fn name(name: impl Into<String>) -> Self {
        Self::Name(name.into())
    }

    pub fn follow(self, pointer: Pointer) -> Self {
        Self::Follow(pointer, Box::new(self))
    }

    pub fn is(self, other: Self) -> Self {
        Self::Binary(Binary::EqualElement, Box::new(self), Box::new(other))
    }

    pub fn differs_from(self, other: Self) -> Self {
        self.is(other).not()
    }

    pub fn not(self) -> Self {
        match self {
            Self::Unary(Unary::Not, term) => *term,
            Self::Bool(value) => Self::Bool(!value),
            term => Self::Unary(Unary::Not, Box::new(term)),
        }
    }

    pub fn and(self, other: Self) -> Self {
        Self::Binary(Binary::And, Box::new(self), Box::new(other))
    }

    pub fn or(self, other: Self) -> Self {
        Self::Binary(Binary::Or, Box::new(self), Box::new(other))
    }

    pub fn hole(self) -> Self {
        Self::Hole(Box::new(self))
    }

    pub fn then(self, then: Self, otherwise: Self) -> Self {
        Self::If(Box::new(self), Box::new(then), Box::new(otherwise))
    }

    /// Shows every aggregate in it.
    pub fn folds(&self, see: &mut dyn FnMut(&Fold)) {
        match self {
            Self::Name(_) | Self::Bool(_) | Self::Int(_) | Self::Real(_) => {}
            Self::Follow(_, of)
            | Self::Position(of)
            | Self::Hole(of)
            | Self::Component(_, of)
            | Self::Unary(_, of) => of.folds(see),
            Self::Vector(parts) => parts.iter().for_each(|part| part.folds(see)),
            Self::Binary(_, left, right) => {
                left.folds(see);
                right.folds(see);
            }
            Self::Call(_, args) => args.iter().for_each(|arg| arg.folds(see)),
            Self::If(condition, then, otherwise) => {
                condition.folds(see);
                then.folds(see);
                otherwise.folds(see);
            }
            Self::Fold(fold) => {
                see(fold);
                fold.element.folds(see);
                fold.filter.iter().for_each(|filter| filter.folds(see));
                fold.body.folds(see);
            }
        }
    }

    /// Asks about every name in it.
    pub fn names(&self, see: &mut dyn FnMut(&str)) {
        match self {
            Self::Name(name) => see(name),
            Self::Bool(_) | Self::Int(_) | Self::Real(_) => {}
            Self::Follow(_, of)
            | Self::Position(of)
            | Self::Hole(of)
            | Self::Component(_, of)
            | Self::Unary(_, of) => of.names(see),
            Self::Vector(parts) => parts.iter().for_each(|part| part.names(see)),
            Self::Binary(_, left, right) => {
                left.names(see);
                right.names(see);
            }
            Self::Call(_, args) => args.iter().for_each(|arg| arg.names(see)),
            Self::If(condition, then, otherwise) => {
                condition.names(see);
                then.names(see);
                otherwise.names(see);
            }
            Self::Fold(fold) => {
                fold.element.names(see);
                fold.filter.iter().for_each(|filter| filter.names(see));
                fold.body.names(see);
            }
        }
    }
}

impl Walk {
    /// Asks about every name that it begins or ends with.
    pub fn names(&self, see: &mut dyn FnMut(&str)) {
        self.from.names(see);
        self.until.names(see);
    }
}

impl Statement {
    /// Statements where something holds; if they are one that asks too, both are asked at once.
    pub fn only_where(condition: Term, mut body: Vec<Statement>) -> Self {
        match (body.pop(), body.is_empty()) {
            (
                Some(Self::When {
                    condition: second,
                    body: inner,
                }),
                true,
            ) => Self::When {
                condition: condition.and(second),
                body: inner,
            },
            (last, _) => {
                body.extend(last);
                Self::When { condition, body }
            }
        }
    }

    /// Whether it, or one inside of it, allocates or erases.
    pub fn changes_the_lists(&self) -> bool {
        match self {
            Self::New { .. } | Self::Erase { .. } => true,
            Self::Attempt { body, .. } => body.iter().any(Self::changes_the_lists),
            _ => false,
        }
    }

    /// Asks about every name that the statement reads, bodies included.
    pub fn names(&self, see: &mut dyn FnMut(&str)) {
        match self {
            Self::Comment(_) | Self::Blank | Self::New { .. } => {}
            Self::Bind { value, .. } | Self::Tally { value, .. } => value.names(see),
            Self::Attempt { element, body, .. } => {
                see(element);
                body.iter().for_each(|statement| statement.names(see));
            }
            Self::Refuse { when, .. } => when.names(see),
            Self::List { items, .. } => items.iter().for_each(|item| item.names(see)),
            Self::Push { list, item } => {
                see(list);
                item.names(see);
            }
            Self::Change { name, value } => {
                see(name);
                value.names(see);
            }
            Self::Raise { name } | Self::Erase { name, .. } => see(name),
            Self::When { condition, body } => {
                condition.names(see);
                body.iter().for_each(|statement| statement.names(see));
            }
            Self::Walk { walk, body } => {
                walk.names(see);
                body.iter().for_each(|statement| statement.names(see));
            }
            Self::Each { list, body, .. } => {
                see(list);
                body.iter().for_each(|statement| statement.names(see));
            }
            Self::Set { of, value, .. } => {
                of.names(see);
                value.names(see);
            }
            Self::SetHole { face, .. } => face.names(see),
            Self::SetPosition { vertex, value } => {
                vertex.names(see);
                value.names(see);
            }
            Self::Return { result } => result.iter().for_each(|result| result.names(see)),
        }
    }
}

/// Leaves out the names that are bound and never read: binding has no effect but its name.
pub(super) fn without_unread(body: Vec<Statement>) -> Vec<Statement> {
    let mut read = std::collections::BTreeSet::new();
    let mut kept = Vec::new();
    for statement in body.into_iter().rev() {
        let statement = match statement {
            Statement::Bind { ref name, .. } if !read.contains(name) => continue,
            Statement::Attempt {
                kind,
                element,
                halfedge,
                body,
            } => Statement::Attempt {
                kind,
                element,
                halfedge,
                body: without_unread(body),
            },
            statement => statement,
        };
        statement.names(&mut |name| {
            read.insert(name.to_string());
        });
        kept.push(statement);
    }
    kept.reverse();
    kept
}
