//! Types, operators and expressions in words, for messages.

use crate::diagnostic::counted;
use crate::diagram::Type;
use crate::syntax::tree::{BinaryOp, Expr, ExprKind};

/// The elements of a type, in the plural.
pub(super) fn plural(ty: Type) -> String {
    match ty {
        Type::Vertex => "vertices".to_owned(),
        ty => format!("{}s", ty.word()),
    }
}

/// `1 argument`, `2 arguments`
pub(super) fn arguments(count: usize) -> String {
    match count {
        0 => "no arguments".to_owned(),
        _ => counted(count, "argument", "arguments"),
    }
}

/// `none are given`, `1 is given`, `2 are given`
pub(super) fn are_given(count: usize) -> String {
    match count {
        0 => "none are given".to_owned(),
        1 => "1 is given".to_owned(),
        _ => format!("{count} are given"),
    }
}

/// The spelling of an operator.
pub(super) fn operator(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::Add => "+",
        BinaryOp::Subtract => "-",
        BinaryOp::Multiply => "*",
        BinaryOp::Divide => "/",
        BinaryOp::Div => "div",
        BinaryOp::Mod => "mod",
        BinaryOp::Equal => "==",
        BinaryOp::NotEqual => "!=",
        BinaryOp::Less => "<",
        BinaryOp::LessEqual => "<=",
        BinaryOp::Greater => ">",
        BinaryOp::GreaterEqual => ">=",
        BinaryOp::And => "and",
        BinaryOp::Or => "or",
    }
}

/// An expression as the subject of a sentence: its text if that is short, otherwise "this".
pub(super) fn subject(expr: &Expr) -> String {
    short(expr, 3).map_or_else(|| "this".to_owned(), |text| format!("`{text}`"))
}

/// The text of a name, a call, or a chain of at most `fields` fields; `None` for anything else.
pub(super) fn short(expr: &Expr, fields: usize) -> Option<String> {
    match &expr.kind {
        ExprKind::Name(name) if name.index.is_none() => Some(name.ident.text.clone()),
        ExprKind::Field(base, field) if fields > 0 => {
            Some(format!("{}.{}", short(base, fields - 1)?, field.text))
        }
        ExprKind::Call { function, .. } => Some(format!("{}(…)", function.text)),
        _ => None,
    }
}

/// The reason of a `require` without one.
pub(super) fn not_held(op: &str) -> String {
    format!("the require of `{op}` does not hold")
}
