//! Operations and functions, as they are emitted.

use std::collections::BTreeSet;

use super::NotEmitted;
use super::names::{Attribute, Names};
use super::routine::{Statement, names_of};
use super::value::{Term, is_spelled};
use crate::diagram::{Level, Param, Type};

/// An operation, or a function that operations call.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Item {
    pub signature: Signature,
    /// The attributes that it reads or sets.
    pub attributes: Vec<Attribute>,
    /// The functions and operations that it calls.
    pub needs: BTreeSet<Need>,
    pub body: ItemBody,
}

/// A function or operation that is called, by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Need {
    Function(u32),
    Op(usize),
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
    Function(Vec<Statement>),
}

/// One alternative of a drawn operation.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Alternative {
    pub label: Option<String>,
    pub body: Vec<Statement>,
}

impl Item {
    /// The names that its statements read.
    pub fn names(&self) -> BTreeSet<String> {
        match &self.body {
            ItemBody::Drawn(rules) => names_of(rules.iter().flat_map(|rule| &rule.body)),
            ItemBody::Steps { requires, steps, .. } => names_of(requires.iter().chain(steps)),
            ItemBody::Function(body) => names_of(body),
        }
    }
}

/// A parameter of a routine.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Parameter {
    pub name: String,
    pub ty: Type,
    /// The value if a call gives none; it may refer to earlier parameters.
    pub default: Option<Term>,
}

impl Parameter {
    /// True if its default is the same for all calls.
    pub fn has_constant(&self) -> bool {
        self.default.as_ref().is_some_and(|default| default.names.is_empty())
    }
}

/// The parameters of an operation or a function, with their defaults.
pub(super) fn parameters(
    params: &[Param],
    names: &mut Names,
) -> Result<Vec<Parameter>, NotEmitted> {
    if let Some(param) = params.iter().find(|param| !is_spelled(param.ty)) {
        let what = format!("a parameter of type `{}`", param.ty.word());
        return Err(NotEmitted::new(what, param.span));
    }
    let words = names.params.clone();
    let parameter = |(param, name): (&Param, String)| {
        let default = param.default.as_ref().map(|value| names.value(value)).transpose()?;
        Ok(Parameter { name, ty: param.ty, default })
    };
    params.iter().zip(words).map(parameter).collect()
}

/// The signature of an operation or function.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Signature {
    pub name: String,
    /// Its name in the program.
    pub declared: String,
    pub docs: Vec<String>,
    pub params: Vec<Parameter>,
    /// The type of its result; an operation without one returns whether it applied.
    pub result: Option<Type>,
    /// The first parameter that is an element and certainly outlives the operation: it can be
    /// returned where there is no result.
    pub given: Option<Parameter>,
    /// True for a function that changes the mesh.
    pub changes: bool,
    /// True for a function that may refuse midway; its caller then undoes what it has done.
    pub refuses: bool,
}

impl Signature {
    /// A signature with its name in code, and what the program says, without parameters.
    pub fn new(name: &str, declared: &str, docs: &[String], result: Option<Type>) -> Self {
        let (name, declared) = (name.to_string(), declared.to_string());
        Self { name, declared, docs: docs.to_vec(), result, ..Self::default() }
    }
}
