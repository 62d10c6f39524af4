//! A routine: pointer code without the spelling of any language.
//!
//! A small imperative language with just what operations need: names that are bound once,
//! pointers that are followed and set, tests that refuse, walks along loops and around
//! vertices, and what is done for each index of a family. [`build`](super::build) writes it; a
//! printer per language spells it.

use super::action::Action;
use super::term::{Attribute, IndexLoop, Parameter, Term};
use crate::diagram::{Kind, Pointer, Type};

/// An operation as a routine.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Routine {
    /// Its name.
    pub name: String,
    /// Its name in the program.
    pub declared: String,
    /// Its doc comment, a line each.
    pub docs: Vec<String>,
    /// Its parameters.
    pub params: Vec<Parameter>,
    /// The type of its result; without one it tells whether it applied.
    pub result: Option<Type>,
    /// The first parameter that is an element and surely outlives it.
    pub given: Option<Parameter>,
    /// The alternatives, tried in order.
    pub rules: Vec<Alternative>,
}

/// A function that routines call.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Helper {
    /// Its name.
    pub name: String,
    /// Its doc comment, a line each.
    pub docs: Vec<String>,
    /// Its parameters.
    pub params: Vec<Parameter>,
    /// The type of its value, if it gives one.
    pub result: Option<Type>,
    /// True if it changes the mesh.
    pub changes: bool,
    /// True if it may refuse on the way; what it has done then is for its caller to undo.
    pub refuses: bool,
    /// Its statements; every way through them gives the value.
    pub body: Vec<Statement>,
}

/// One alternative of a routine.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Alternative {
    /// Its name, where it has one.
    pub label: Option<String>,
    /// Its statements.
    pub body: Vec<Statement>,
}

impl Routine {
    /// The routine with the element that it was given as its result, if it has none.
    pub fn giving_back(mut self) -> Self {
        if let (None, Some(given)) = (self.result, self.given.clone()) {
            self.result = Some(given.ty);
            for rule in &mut self.rules {
                give_back(&mut rule.body, &given.name);
            }
        }
        self
    }
}

/// Makes every end of statements give a name.
pub(super) fn give_back(body: &mut [Statement], name: &str) {
    for statement in body {
        if let Statement::Return { result: result @ None } = statement {
            *result = Some(Term::name(name));
        }
        for inner in statement.bodies_mut() {
            give_back(inner, name);
        }
    }
}

/// A statement.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Statement {
    /// A line in words.
    Comment(String),
    /// An empty line.
    Blank,
    /// A name for the column of an attribute; refuses a mesh without it.
    Column(Attribute),
    /// A name for a value.
    Bind { ty: Type, name: String, value: Term },
    /// Tries the halfedges of an element in turn; what is refused in the body goes on with the
    /// next one.
    Attempt { kind: Kind, element: String, halfedge: String, body: Vec<Statement> },
    /// Refuses the place.
    Refuse { when: Term, reason: String },
    /// A list that grows.
    List { ty: Type, name: String, items: Vec<Term> },
    /// Adds to a list.
    Push { list: String, item: Term },
    /// A name for a list.
    BindList { ty: Type, name: String, value: Term },
    /// A name for the number of elements of a list.
    Size { name: String, list: String },
    /// A name for the list of what stands for each index.
    Gather { ty: Type, name: String, indices: IndexLoop, item: Term },
    /// Does something for each index.
    IndexLoop { indices: IndexLoop, body: Vec<Statement> },
    /// Gives it another value.
    Change { name: String, value: Term },
    /// Only where something holds.
    When { condition: Term, body: Vec<Statement> },
    /// For each halfedge of a walk.
    Walk { walk: HalfedgeWalk, body: Vec<Statement> },
    /// A preview of the mesh, and a block in which what is new, and what is set, is noted on it.
    Preview { preview: String, body: Vec<Statement> },
    /// Allocates an element.
    New { kind: Kind, name: String },
    /// Allocates an element for each index.
    NewEach { kind: Kind, name: String, indices: IndexLoop },
    /// `of.pointer = value`
    Set { pointer: Pointer, of: Term, value: Term },
    /// Makes a face a hole, or a hole a face.
    SetHole { face: Term, hole: bool },
    /// `vertex.position = value`
    SetPosition { vertex: Term, value: Term },
    /// `element.attribute = value`
    SetAttribute { attribute: Attribute, element: Term, value: Term },
    /// Erases an element.
    Erase { kind: Kind, element: Term },
    /// The value of a function.
    Give(Term),
    /// Done.
    Return { result: Option<Term> },
    /// An action, which only steps and functions have.
    Action(Action),
}

/// A walk over halfedges. Nothing that it follows is written while it goes on, but the
/// `face` or `vertex` of the halfedges themselves.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct HalfedgeWalk {
    /// The name of the halfedge.
    pub halfedge: String,
    /// The step from one to the next.
    pub step: Step,
    /// The first.
    pub from: Term,
    /// The halfedge behind the last; if it is the first, the walk is empty.
    pub until: Term,
    /// True if a walk whose end is its start goes all the way around instead.
    pub around: bool,
}

/// The step of a walk.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Step {
    /// `h.next`, along a loop.
    Next,
    /// `h.twin.next`, clockwise around a vertex: no `prev` is needed.
    Clockwise,
}

impl HalfedgeWalk {
    /// Asks about every name that it begins or ends with.
    pub fn names(&self, see: &mut dyn FnMut(&str)) {
        self.from.names(see);
        self.until.names(see);
    }
}

impl Statement {
    /// The statements inside of it, but for those of steps and functions.
    fn body(&self) -> &[Self] {
        match self {
            Self::Attempt { body, .. }
            | Self::IndexLoop { body, .. }
            | Self::When { body, .. }
            | Self::Walk { body, .. }
            | Self::Preview { body, .. } => body,
            _ => &[],
        }
    }

    /// The statements inside of it, to be changed.
    fn bodies_mut(&mut self) -> Vec<&mut Vec<Self>> {
        match self {
            Self::Attempt { body, .. }
            | Self::IndexLoop { body, .. }
            | Self::When { body, .. }
            | Self::Walk { body, .. }
            | Self::Preview { body, .. } => vec![body],
            Self::Action(action) => action.bodies_mut(),
            _ => Vec::new(),
        }
    }

    /// True if it, or one inside of it, adds to a list.
    pub fn adds_to(&self, name: &str) -> bool {
        match self {
            Self::Push { list, .. } => list == name,
            statement => statement.body().iter().any(|inner| inner.adds_to(name)),
        }
    }

    /// The statement with another body in the place of its own, if it has one that is carried
    /// out on the mesh: what is foreseen is not.
    pub fn with_body(mut self, made: impl FnOnce(Vec<Self>) -> Vec<Self>) -> Self {
        if let Self::Attempt { body, .. }
        | Self::IndexLoop { body, .. }
        | Self::When { body, .. }
        | Self::Walk { body, .. } = &mut self
        {
            *body = made(std::mem::take(body));
        }
        self
    }

    /// True if it, or one inside of it, allocates or erases.
    pub fn changes_the_lists(&self) -> bool {
        match self {
            Self::New { .. } | Self::NewEach { .. } | Self::Erase { .. } => true,
            Self::Attempt { body, .. } | Self::IndexLoop { body, .. } => {
                body.iter().any(Self::changes_the_lists)
            }
            _ => false,
        }
    }

    /// Asks about every name that the statement reads, bodies included.
    pub fn names(&self, see: &mut dyn FnMut(&str)) {
        match self {
            Self::Comment(_) | Self::Blank | Self::Column(_) | Self::New { .. } => {}
            Self::Bind { value, .. } | Self::BindList { value, .. } => {
                value.names(see);
            }
            Self::Size { list, .. } => see(list),
            Self::Gather { indices, item, .. } => {
                indices.names(see);
                item.names(see);
            }
            Self::NewEach { indices, .. } => indices.names(see),
            Self::IndexLoop { indices, body } => {
                indices.names(see);
                body.iter().for_each(|statement| statement.names(see));
            }
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
            Self::Preview { body, .. } => body.iter().for_each(|statement| statement.names(see)),
            Self::Erase { element, .. } => element.names(see),
            Self::When { condition, body } => {
                condition.names(see);
                body.iter().for_each(|statement| statement.names(see));
            }
            Self::Walk { walk, body } => {
                walk.names(see);
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
            Self::SetAttribute { element, value, .. } => {
                element.names(see);
                value.names(see);
            }
            Self::Give(value) => value.names(see),
            Self::Return { result } => result.iter().for_each(|result| result.names(see)),
            Self::Action(action) => action.names(see),
        }
    }
}

/// Leaves out the names that are bound and never read: binding has no effect but its name.
pub(super) fn without_unread(body: Vec<Statement>) -> Vec<Statement> {
    let mut read = std::collections::BTreeSet::new();
    let mut kept = Vec::new();
    for statement in body.into_iter().rev() {
        let statement = match statement {
            Statement::Bind { ref name, .. }
            | Statement::BindList { ref name, .. }
            | Statement::Size { ref name, .. }
            | Statement::Gather { ref name, .. }
                if !read.contains(name) =>
            {
                continue;
            }
            statement @ Statement::Attempt { .. } => statement.with_body(without_unread),
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
