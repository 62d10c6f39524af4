//! Operations in steps, and what their statements speak of: calls of what changes the mesh,
//! variables that change, and writes that are put off.

use super::routine::{Statement, give_back};
use super::term::{Attribute, Parameter, Term};
use crate::diagram::{Level, Type};

/// An operation that calls others, all or nothing.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Whole {
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
    /// The tests before anything is done.
    pub asks: Vec<Statement>,
    /// The level that the mesh has to have in the end.
    pub level: Level,
    /// The statements that do it.
    pub body: Vec<Statement>,
}

impl Whole {
    /// The operation with the element that it was given as its result, if it has none.
    pub fn giving_back(mut self) -> Self {
        if let (None, Some(given)) = (self.result, self.given.clone()) {
            self.result = Some(given.ty);
            give_back(&mut self.body, &given.name);
        }
        self
    }
}

/// A call of an operation, or of a function that changes the mesh.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Call {
    /// The name of what is called.
    pub name: String,
    pub args: Vec<Term>,
    pub of: Called,
}

/// The kind of thing that is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Called {
    /// An operation with a result.
    Operation,
    /// One without.
    Plain,
    /// A function that may refuse.
    Refusing,
    /// A function that does not.
    Sure,
}

/// The writes to one attribute that are put off.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Held {
    /// The list of them.
    pub list: String,
    /// The type of the elements.
    pub element: Type,
    /// The type of the values.
    pub ty: Type,
    /// The attribute; none for positions.
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
    /// It is new, and keeps this value.
    Fixed,
    /// It is new, and will change.
    Changing,
    /// It is there.
    Known,
}
