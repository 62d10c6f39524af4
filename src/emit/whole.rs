//! Operations in steps, and what their statements use: calls that change the mesh, variables that
//! change, and deferred writes.

use super::routine::{Signature, Statement};
use super::term::{Attribute, Term};
use crate::diagram::{Level, Type};

/// An operation that calls others, and applies whole or not at all.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Whole {
    pub signature: Signature,
    /// The tests before anything is done.
    pub asks: Vec<Statement>,
    /// The level that the mesh must have in the end.
    pub level: Level,
    /// The statements that do it.
    pub body: Vec<Statement>,
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
