//! `can flip(e)`, `why flip(e)`: what an op would do, without applying it.

use crate::diagnostic::Diagnostic;
use crate::diagram::{Expr, ExprKind, Type};
use crate::source::Span;
use crate::syntax::tree::{self, Asking};

use super::typed::typed;
use super::typing::{Place, Typing};

impl Asking {
    pub(super) fn word(self) -> &'static str {
        match self {
            Asking::Can => "can",
            Asking::Why => "why",
        }
    }
}

impl Typing<'_> {
    /// `can f(x)`, `why f(x)`
    pub(super) fn asked(&mut self, asking: Asking, inner: &tree::Expr, span: Span) -> Option<Expr> {
        let word = asking.word();
        let tree::ExprKind::Call { function, args } = &inner.kind else {
            if inner.kind == tree::ExprKind::Broken {
                return self.report.fail_silently();
            }
            let message = format!("`{word}` stands before the call of an op");
            return self.report.reject(Diagnostic::error("not-an-op", message, inner.span));
        };
        if !matches!(self.place, Place::Script) {
            let message = format!(
                "`{word}` asks an op, which has no place in the drawings of another or in a default"
            );
            let error = Diagnostic::error("misplaced-can", message, span)
                .note("a script asks, a function, or an op in steps");
            return self.report.reject(error);
        }
        let (op, args) = self.application(function, args, inner.span)?;
        let ty = match asking {
            Asking::Can => Type::Bool,
            Asking::Why => Type::Text,
        };
        Some(typed(ty, ExprKind::Try(op as u32, args), span))
    }
}
