//! A routine: pointer code that is independent of the syntax of any language.
//!
//! A small imperative language with just what operations need: names that are bound once, pointers
//! that are followed and set, tests that refuse, walks along loops and around vertices, and
//! repetition for each index of a family. [`build`](super::build) creates it, and
//! [`print`](super::print) spells it in each language.

use super::term::{Attribute, IndexLoop, Parameter, Term};
use super::walks::HalfedgeWalk;
use crate::diagram::{Kind, Pointer, Type};

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Statement {
    /// A comment.
    Comment(String),
    /// An empty line.
    Blank,
    /// A binding of the column of an attribute; a mesh without it is refused.
    Column(Attribute),
    /// A binding of a value of a type, or of a list of such values.
    Bind { ty: Type, name: String, value: Term, is_list: bool },
    /// Attempts with the halfedges of an element in turn; a refusal in the body continues with the
    /// next one.
    Attempt { kind: Kind, element: String, halfedge: String, body: Vec<Statement> },
    /// A refusal if a condition holds.
    Refuse { when: Term, reason: String },
    /// A binding of a list that can grow.
    List { ty: Type, name: String, items: Vec<Term> },
    /// An addition to a list.
    Push { list: String, item: Term },
    /// A binding of the length of a list.
    Size { name: String, list: String },
    /// A binding of the list of the values at each index.
    Gather { ty: Type, name: String, indices: IndexLoop, item: Term },
    /// A loop over the indices.
    IndexLoop { indices: IndexLoop, body: Vec<Statement> },
    /// A loop over the halfedges of a walk.
    Walk { walk: HalfedgeWalk, body: Vec<Statement> },
    /// A preview of the mesh, and a block whose allocations and writes are noted on it.
    Preview { preview: String, body: Vec<Statement> },
    /// The allocation of an element, or of one for each index.
    New { kind: Kind, name: String, indices: Option<IndexLoop> },
    /// `of.field = value`
    Set { field: Field, of: Term, value: Term },
    /// The erasure of an element.
    Erase { kind: Kind, element: Term },
    /// The return from a function, or from an operation that has applied.
    Return { value: Option<Term> },

    // Only steps and functions have the statements that follow.
    /// The value of a variable, the first or another.
    Variable { place: Target, value: Term },
    /// A call that changes the mesh and must succeed.
    MustCall { call: Call, place: Option<Target> },
    /// A call of an operation, and branches for whether it applied.
    Apply { call: Call, place: Option<Parameter>, then: Vec<Self>, otherwise: Vec<Self> },
    /// Branches for whether a condition holds.
    Choose { condition: Term, then: Vec<Self>, otherwise: Vec<Self> },
    /// A loop that runs `count` times.
    Repeat { index: String, count: Term, body: Vec<Self> },
    /// A loop that runs while a condition holds.
    While { condition: Term, body: Vec<Self> },
    /// A loop over the elements around one that exist when it begins.
    For {
        variable: Parameter,
        /// The name of the elements around another that it runs over.
        around: &'static str,
        element: Term,
        /// True if the body may erase some of them; those are skipped.
        may_go: bool,
        filter: Option<Term>,
        body: Vec<Self>,
    },
    /// A loop whose writes are deferred to its end.
    Update { visit: Box<Self>, held: Vec<Held> },
    /// A deferred write.
    Defer { list: String, element: Term, value: Term },
    /// `break`
    Break,
    /// `continue`
    Continue,
    /// `vertex.position = value`, which has to be finite.
    Move {
        vertex: Term,
        value: Term,
        /// True if it is known to be finite.
        is_finite: bool,
    },
    /// The refusal of a mesh without an attribute.
    RequireColumn(Attribute),
    /// A note of the elements that will be written to.
    Journal(Vec<Term>),
    /// A note of the value of an attribute that will be written to.
    JournalAttribute { attribute: Attribute, element: Term },
}

/// What is set of an element.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Field {
    Pointer(Pointer),
    /// Whether a face is a hole.
    Hole,
    Position,
    Attribute(Attribute),
}

/// A call of an operation, or of a function that changes the mesh.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Call {
    /// The name of the called operation or function.
    pub name: String,
    pub args: Vec<Term>,
    pub of: Called,
}

/// The kind of thing that is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Called {
    /// An operation with a result.
    Operation,
    /// An operation without a result.
    Plain,
    /// A function that may refuse.
    Refusing,
    /// A function that cannot refuse.
    Sure,
}

/// The deferred writes to one attribute.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Held {
    /// The name of their list.
    pub list: String,
    /// The type of the elements.
    pub element: Type,
    /// The type of the values.
    pub ty: Type,
    /// The attribute; `None` for positions.
    pub attribute: Option<Attribute>,
}

/// The target of a value.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Target {
    pub name: String,
    pub ty: Type,
    pub form: Form,
}

/// The form of an assignment: to a variable that exists, or to a new one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// A new variable that keeps this value.
    Fixed,
    /// A new variable that will change.
    Changing,
    /// An existing variable.
    Known,
}

/// The statements inside of one; `$of` is the method that returns them.
macro_rules! bodies {
    ($statement:expr, $of:ident) => {
        match $statement {
            Self::Attempt { body, .. }
            | Self::IndexLoop { body, .. }
            | Self::Walk { body, .. }
            | Self::Preview { body, .. }
            | Self::Repeat { body, .. }
            | Self::While { body, .. }
            | Self::For { body, .. } => vec![body],
            Self::Apply { then, otherwise, .. } | Self::Choose { then, otherwise, .. } => {
                vec![then, otherwise]
            }
            Self::Update { visit, .. } => visit.$of(),
            _ => Vec::new(),
        }
    };
}

impl Statement {
    /// `of.pointer = value`
    pub fn set(pointer: Pointer, of: Term, value: Term) -> Self {
        Self::Set { field: Field::Pointer(pointer), of, value }
    }

    /// A statement that runs only if a condition holds.
    pub fn when(condition: Term, then: Vec<Self>) -> Self {
        Self::Choose { condition, then, otherwise: Vec::new() }
    }

    /// The statements inside of it.
    pub fn bodies(&self) -> Vec<&[Self]> {
        bodies!(self, bodies)
    }

    /// The statements inside of it, mutably.
    pub fn bodies_mut(&mut self) -> Vec<&mut Vec<Self>> {
        bodies!(self, bodies_mut)
    }

    /// The name of a value or list that it only binds.
    pub fn bound(&self) -> Option<&String> {
        match self {
            Self::Bind { name, .. } | Self::Size { name, .. } | Self::Gather { name, .. } => {
                Some(name)
            }
            _ => None,
        }
    }

    /// The statement with its bodies replaced, if they run on the mesh: those of a preview do not.
    pub fn with_bodies(mut self, mut made: impl FnMut(Vec<Self>) -> Vec<Self>) -> Self {
        if !matches!(self, Self::Preview { .. }) {
            for body in self.bodies_mut() {
                *body = made(std::mem::take(body));
            }
        }
        self
    }

    /// Reports every name that it reads, bodies included.
    pub fn names(&self, see: &mut dyn FnMut(&str)) {
        self.terms(&mut |term| term.names(see));
        match self {
            Self::Size { list: name, .. }
            | Self::Push { list: name, .. }
            | Self::Attempt { element: name, .. }
            | Self::Variable { place: Target { name, form: Form::Known, .. }, .. }
            | Self::MustCall { place: Some(Target { name, form: Form::Known, .. }), .. } => {
                see(name)
            }
            Self::Gather { indices, .. }
            | Self::New { indices: Some(indices), .. }
            | Self::IndexLoop { indices, .. } => see(&indices.size),
            _ => {}
        }
        self.bodies().into_iter().flatten().for_each(|inner| inner.names(see));
    }

    /// Reports every attribute that it reads or sets, bodies included.
    pub fn attributes(&self, see: &mut dyn FnMut(&Attribute)) {
        self.terms(&mut |term| term.attributes(see));
        if let Self::Set { field: Field::Attribute(attribute), .. } = self {
            see(attribute);
        }
        self.bodies().into_iter().flatten().for_each(|inner| inner.attributes(see));
    }

    /// Reports its own terms, without those of its bodies.
    fn terms(&self, see: &mut dyn FnMut(&Term)) {
        match self {
            Self::Bind { value: term, .. }
            | Self::Gather { item: term, .. }
            | Self::Refuse { when: term, .. }
            | Self::Push { item: term, .. }
            | Self::Erase { element: term, .. }
            | Self::Return { value: Some(term) }
            | Self::Variable { value: term, .. }
            | Self::Choose { condition: term, .. }
            | Self::While { condition: term, .. }
            | Self::Repeat { count: term, .. }
            | Self::JournalAttribute { element: term, .. } => see(term),
            Self::Walk { walk: HalfedgeWalk { from: one, until: other, .. }, .. }
            | Self::Set { of: one, value: other, .. }
            | Self::Move { vertex: one, value: other, .. }
            | Self::Defer { element: one, value: other, .. } => {
                [one, other].into_iter().for_each(see)
            }
            Self::List { items: terms, .. } | Self::Journal(terms) => terms.iter().for_each(see),
            Self::MustCall { call, .. } | Self::Apply { call, .. } => {
                call.args.iter().for_each(see);
            }
            Self::For { element, filter, .. } => {
                see(element);
                filter.iter().for_each(see);
            }
            Self::Update { visit, .. } => visit.terms(see),
            Self::Comment(_)
            | Self::Blank
            | Self::Column(_)
            | Self::Attempt { .. }
            | Self::Size { .. }
            | Self::IndexLoop { .. }
            | Self::Preview { .. }
            | Self::New { .. }
            | Self::Return { value: None }
            | Self::Break
            | Self::Continue
            | Self::RequireColumn(_) => {}
        }
    }
}

/// The type of the elements of a kind; of a path or fan, that of its halfedges.
pub(super) fn type_of(kind: Kind) -> Type {
    kind.element_type().unwrap_or(Type::Halfedge)
}

/// Removes bindings of names that are never read: a binding has no other effect. `bound` gives the
/// name that a statement only binds.
pub(super) fn without_unread(
    body: Vec<Statement>,
    bound: fn(&Statement) -> Option<&String>,
) -> Vec<Statement> {
    let mut read = std::collections::BTreeSet::new();
    let mut kept = Vec::new();
    for mut statement in body.into_iter().rev() {
        if bound(&statement).is_some_and(|name| !read.contains(name)) {
            continue;
        }
        if let Statement::Attempt { .. } = statement {
            statement = statement.with_bodies(|body| without_unread(body, bound));
        }
        statement.names(&mut |name| _ = read.insert(name.to_string()));
        kept.push(statement);
    }
    kept.reverse();
    kept
}
