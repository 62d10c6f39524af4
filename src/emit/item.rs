//! Operations and functions, as they are emitted.

use super::routine::Statement;
use super::term::{Attribute, Parameter};
use crate::diagram::{Level, Type};

/// An operation, or a function that operations call.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Item {
    pub signature: Signature,
    pub body: ItemBody,
}

/// The statements of an item.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum ItemBody {
    /// The alternatives of a drawn operation, tried in order.
    Drawn(Vec<Alternative>),
    /// An operation in steps, which calls others, and applies whole or not at all.
    Steps {
        /// The tests before anything is done.
        requires: Vec<Statement>,
        /// The level that the mesh must have in the end.
        level: Level,
        steps: Vec<Statement>,
    },
    /// A function; every path through it returns its value.
    Function {
        /// True if it changes the mesh.
        changes: bool,
        /// True if it may refuse midway; its caller then undoes what it has done.
        refuses: bool,
        body: Vec<Statement>,
    },
}

/// One alternative of a drawn operation.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Alternative {
    /// Its name, if it has one.
    pub label: Option<String>,
    /// Its statements.
    pub body: Vec<Statement>,
}

impl Item {
    /// Its statements.
    pub fn statements(&self) -> Vec<&Statement> {
        match &self.body {
            ItemBody::Drawn(rules) => rules.iter().flat_map(|rule| &rule.body).collect(),
            ItemBody::Steps { requires, steps, .. } => requires.iter().chain(steps).collect(),
            ItemBody::Function { body, .. } => body.iter().collect(),
        }
    }

    /// Reports the attributes that it reads or sets.
    pub fn attributes(&self, see: &mut dyn FnMut(&Attribute)) {
        let defaults = self.signature.params.iter().filter_map(|param| param.default.as_ref());
        defaults.for_each(|default| default.attributes(see));
        self.statements().into_iter().for_each(|statement| statement.attributes(see));
    }
}

/// The signature of an operation or function.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Signature {
    /// Its name.
    pub name: String,
    /// Its name in the program.
    pub declared: String,
    /// The lines of its doc comment.
    pub docs: Vec<String>,
    /// Its parameters.
    pub params: Vec<Parameter>,
    /// The type of its result; an operation without one returns whether it applied.
    pub result: Option<Type>,
    /// The first parameter that is an element and certainly outlives the operation: it can be
    /// returned where there is no result.
    pub given: Option<Parameter>,
}
