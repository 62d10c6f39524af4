//! The type of value that statements may return.

use crate::source::Span;

use super::signature::{FunctionSignature, Value};

/// The type of value that the current statements may return.
#[derive(Clone, Debug)]
pub(super) struct Returns {
    /// The name of the function; `None` in a script.
    pub(super) function: Option<String>,
    /// The span of that name.
    pub(super) declared: Span,
    pub(super) value: Value,
    /// The first `return`, which determines the type if none is written.
    pub(super) first: Option<Span>,
    /// True if the function is in a call cycle, so that it can return a value only if the type is
    /// written.
    pub(super) cycles: bool,
    /// The place to insert the result type, if it is not written.
    pub(super) head: Option<Span>,
}

impl Returns {
    /// No value: the statements of a script.
    pub(super) fn nothing() -> Self {
        Self {
            function: None,
            declared: Span::default(),
            value: Value::Nothing,
            first: None,
            cycles: false,
            head: None,
        }
    }

    /// The value given by the signature of a function.
    pub(super) fn of_function(signature: &FunctionSignature, cycles: bool) -> Self {
        Self {
            function: Some(signature.name.clone()),
            declared: signature.span,
            value: match signature.result {
                Value::Open if cycles => Value::Nothing,
                value => value,
            },
            first: None,
            head: None,
            cycles,
        }
    }

    /// The result of the function, after all of it has been resolved.
    pub(super) fn value(&self) -> Value {
        match self.value {
            Value::Open => Value::Nothing,
            value => value,
        }
    }
}
