//! Operators as text, and where brackets are needed.

use crate::diagram::{Binary, Pointer, Unary};
use crate::emit::term::Term;

/// The precedence of the outermost operator of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Level {
    Choice,
    Or,
    And,
    Compare,
    Sum,
    Product,
    Prefix,
    Whole,
}

/// A text and how tightly it binds.
#[derive(Clone, Debug)]
pub(super) struct Spelled {
    pub text: String,
    pub level: Level,
}

impl Spelled {
    pub fn new(text: impl Into<String>, level: Level) -> Self {
        Self { text: text.into(), level }
    }

    /// A text that needs no brackets anywhere.
    pub fn whole(text: impl Into<String>) -> Self {
        Self::new(text, Level::Whole)
    }

    /// The text, in brackets if it binds less tightly than `level`.
    pub fn at(self, level: Level) -> String {
        match self.level >= level {
            true => self.text,
            false => format!("({})", self.text),
        }
    }
}

/// The name of a pointer where it has to be unique among the pointers of all kinds of elements.
pub(super) fn unique(pointer: Pointer) -> &'static str {
    match pointer {
        Pointer::VertexHalfedge => "vertex_halfedge",
        Pointer::EdgeHalfedge => "edge_halfedge",
        Pointer::FaceHalfedge => "face_halfedge",
        pointer => pointer.word(),
    }
}

/// The index at a distance from `index`, or from 0, modulo the size of a list. Intermediate results
/// are never negative, since sizes are unsigned.
pub(super) fn place(index: Option<&str>, shift: i64, size: &str) -> String {
    let far = shift.unsigned_abs();
    match (index, shift) {
        (None, 0) => "0".to_string(),
        (Some(index), 0) => index.to_string(),
        (None, 1..) => format!("{far} % {size}"),
        (Some(index), 1..) => format!("({index} + {far}) % {size}"),
        (None, -1) => format!("{size} - 1"),
        (Some(index), -1) => format!("({index} + {size} - 1) % {size}"),
        (None, _) => format!("({far} * {size} - {far}) % {size}"),
        (Some(index), _) => format!("({index} + {far} * {size} - {far}) % {size}"),
    }
}

/// The negation of a comparison or of joined conditions, without a `not` in front of it.
pub(super) fn negated(term: &Term) -> Option<Term> {
    let (operator, left, right) = match term {
        Term::Binary(operator, left, right) => (*operator, left, right),
        Term::Unary(Unary::Not, of) => return Some((**of).clone()),
        _ => return None,
    };
    let not = |term: &Term| Box::new(term.clone().not());
    Some(match operator {
        // Only of ints: reals may be incomparable.
        Binary::LessInt => Term::Binary(Binary::LessEqualInt, right.clone(), left.clone()),
        Binary::LessEqualInt => Term::Binary(Binary::LessInt, right.clone(), left.clone()),
        Binary::And => Term::Binary(Binary::Or, not(left), not(right)),
        Binary::Or => Term::Binary(Binary::And, not(left), not(right)),
        _ => return None,
    })
}

pub(super) fn symbol(operator: Binary) -> (&'static str, Level) {
    match operator {
        Binary::AddInt | Binary::AddReal | Binary::AddVector => ("+", Level::Sum),
        Binary::SubtractInt | Binary::SubtractReal | Binary::SubtractVector => ("-", Level::Sum),
        Binary::MultiplyInt
        | Binary::MultiplyReal
        | Binary::MultiplyVector
        | Binary::ScaleVector
        | Binary::Transform
        | Binary::MultiplyMatrices => ("*", Level::Product),
        Binary::DivideReal | Binary::DivideVector => ("/", Level::Product),
        Binary::EqualInt
        | Binary::EqualReal
        | Binary::EqualBool
        | Binary::EqualVector
        | Binary::EqualText
        | Binary::EqualElement => ("==", Level::Compare),
        Binary::LessInt | Binary::LessReal => ("<", Level::Compare),
        Binary::LessEqualInt | Binary::LessEqualReal => ("<=", Level::Compare),
        Binary::And => ("&&", Level::And),
        Binary::Or => ("||", Level::Or),
        Binary::Div => ("/", Level::Product),
        Binary::Mod => ("%", Level::Product),
    }
}

/// The text of an operator between its sides.
pub(super) fn infix(operator: Binary, sides: [Spelled; 2]) -> Spelled {
    let (symbol, level) = symbol(operator);
    joined(symbol, level, sides)
}

/// The text of an operator of a level between its sides.
pub(super) fn joined(symbol: &str, level: Level, [left, right]: [Spelled; 2]) -> Spelled {
    let (left_level, right_level) = match level {
        Level::Compare => (Level::Sum, Level::Sum),
        // Mixed `and` and `or` read better in brackets, and C++ warns without them.
        Level::Or if left.level == Level::And || right.level == Level::And => {
            (Level::Compare, Level::Compare)
        }
        Level::Or | Level::And => (level, level),
        Level::Sum => (Level::Sum, Level::Product),
        _ => (level, Level::Prefix),
    };
    let (left, right) = (left.at(left_level), right.at(right_level));
    Spelled::new(format!("{left} {symbol} {right}"), level)
}

/// A number whose size has the given digits; `infinite` stands for infinity, and `none` for NaN.
pub(super) fn number(value: f64, digits: String, [infinite, none]: [&str; 2]) -> Spelled {
    let text = match value.abs() {
        size if size.is_nan() => return Spelled::whole(none),
        size if size.is_infinite() => infinite.to_string(),
        _ => digits,
    };
    match value.is_sign_negative() {
        true => Spelled::new(format!("-{text}"), Level::Prefix),
        false => Spelled::whole(text),
    }
}
