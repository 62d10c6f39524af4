//! Signatures: what a call has to know about its callee.

use crate::diagram::{self, Expr, Param, Type};
use crate::source::Span;

use super::program;

/// A parameter, as far as it could be resolved.
#[derive(Clone, Debug)]
pub(super) struct Parameter {
    pub(super) name: String,
    /// The span of its name.
    pub(super) span: Span,
    pub(super) ty: Option<Type>,
    /// True if a call may leave it out.
    pub(super) optional: bool,
    /// Its default, if it could be resolved.
    pub(super) default: Option<Expr>,
}

impl Parameter {
    /// The parameter in the resolved program. One of unknown type counts as a real: its item cannot
    /// be used, but the number of arguments of its calls can still be checked.
    pub(super) fn param(&self) -> Param {
        Param {
            name: self.name.clone(),
            span: self.span,
            ty: self.ty.unwrap_or(Type::Real),
            default: self.default.clone(),
        }
    }
}

/// The signature of an op, for its calls.
#[derive(Clone, Debug)]
pub(super) struct Signature {
    pub(super) name: String,
    pub(super) params: Vec<Parameter>,
    pub(super) result: Value,
}

impl Signature {
    /// The op with this name span and diagram; an op in steps has none, and gets its steps later.
    pub(super) fn op(&self, name: Span, diagram: Option<diagram::Op>) -> program::Op {
        program::Op {
            misread: false,
            name: self.name.clone(),
            span: name,
            params: self.params.iter().map(Parameter::param).collect(),
            result: self.result.ty(),
            diagram,
            still: None,
            open: None,
            steps: None,
        }
    }
}

/// The signature of a function, for its calls.
#[derive(Clone, Debug)]
pub(super) struct FunctionSignature {
    pub(super) name: String,
    /// The span of its name.
    pub(super) span: Span,
    pub(super) params: Vec<Parameter>,
    /// The type of its value.
    pub(super) result: Value,
    pub(super) effects: Effects,
}

/// The result type of a function or an op.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Value {
    Nothing,
    Of(Type),
    /// To be determined by the body of the function.
    Open,
    /// It could not be determined.
    Unknown,
}

impl Value {
    /// The type, if there is a value and it is known.
    pub(super) fn ty(self) -> Option<Type> {
        match self {
            Value::Of(ty) => Some(ty),
            Value::Nothing | Value::Open | Value::Unknown => None,
        }
    }
}

/// The side effects of a function, each with the place of one occurrence.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) struct Effects {
    /// It calls an op, or sets attributes.
    pub(super) changes: Option<Span>,
    /// It prints.
    pub(super) prints: Option<Span>,
    /// It looks at the whole mesh.
    pub(super) looks: Option<Span>,
    /// It asks an op.
    pub(super) asks: Option<Span>,
    /// It draws random numbers.
    pub(super) draws: Option<Span>,
}

impl Effects {
    /// All effects at once, for a script that is called here.
    pub(super) fn all(here: Span) -> Self {
        let here = Some(here);
        Self { changes: here, prints: here, looks: here, asks: here, draws: here }
    }

    pub(super) fn take_in(&mut self, other: Effects) -> bool {
        let before = *self;
        self.changes = self.changes.or(other.changes);
        self.prints = self.prints.or(other.prints);
        self.looks = self.looks.or(other.looks);
        self.asks = self.asks.or(other.asks);
        self.draws = self.draws.or(other.draws);
        *self != before
    }
}
