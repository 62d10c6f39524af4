//! The values that statements may return.

use crate::source::Span;

use super::signature::{FunctionSignature, Value};

/// The values that the statements at hand may return.
#[derive(Clone, Debug)]
pub(super) struct Returns {
    /// The name of the function; `None` in a script.
    pub(super) function: Option<String>,
    pub(super) value: Value,
    /// The first `return`, which decides where no type is written.
    pub(super) first: Option<Span>,
    /// True if the type must be written for a value to be returned.
    pub(super) cycles: bool,
    /// The place for the type, if it is not.
    pub(super) head: Option<Span>,
}

impl Returns {
    /// Nothing: the statements of a script.
    pub(super) fn nothing() -> Self {
        Self { function: None, value: Value::Nothing, first: None, cycles: false, head: None }
    }

    /// The result by the signature of a function.
    pub(super) fn of_function(signature: &FunctionSignature, cycles: bool) -> Self {
        Self {
            function: Some(signature.name.clone()),
            value: match signature.result {
                Value::Open if cycles => Value::Nothing,
                value => value,
            },
            first: None,
            head: None,
            cycles,
        }
    }

    /// The result of the function, now that all of it has been seen.
    pub(super) fn value(&self) -> Value {
        match self.value {
            Value::Open => Value::Nothing,
            value => value,
        }
    }
}
