//! Operations in steps, and what their statements speak of: calls of what changes the mesh,
//! variables that change, and writes that are put off.

use super::routine::{Signature, Statement};
use super::term::{Attribute, Term};
use crate::diagram::{Level, Type};

/// An operation that calls others, all or nothing.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Whole {
    pub signature: Signature,
    /// The tests before anything is done.
    pub asks: Vec<Statement>,
    /// The level that the mesh has to have in the end.
    pub level: Level,
    /// The statements that do it.
    pub body: Vec<Statement>,
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
