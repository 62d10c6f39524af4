//! A function of the program as a value, for those that cannot run statements.

use super::{Expr, Type};

/// A function of the program whose value is an expression: blocks are `let`, `return` and
/// `if`.
#[derive(Clone, Debug)]
pub struct Callee {
    /// Its name.
    pub name: String,
    /// Its doc comment, a line each.
    pub docs: Vec<String>,
    /// The types of its parameters: the first of its variables.
    pub params: Vec<Type>,
    /// The names of all its variables.
    pub variables: Vec<String>,
    /// The type of its value.
    pub result: Type,
    /// Its value; what it is called with are the locals.
    pub value: Expr,
}
