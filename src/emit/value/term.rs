//! Values as text, and where brackets are needed.

use std::collections::BTreeSet;

use Precedence::*;

use crate::diagram::Binary;

/// The precedence of the outermost operator of a text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::emit) enum Precedence {
    #[default]
    Choice,
    Or,
    And,
    Compare,
    Sum,
    Product,
    Prefix,
    Whole,
}

/// A value as text: names, pointers that are followed, entries of lists, conditions.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::emit) struct Term {
    pub text: String,
    /// How tightly it binds.
    pub precedence: Precedence,
    /// The names in it.
    pub names: BTreeSet<String>,
    /// The name that it is, or of the list of which it is an entry; `None` for what is computed.
    pub root: Option<String>,
    /// Whether it is a number without a type: an int literal.
    pub(super) is_literal: bool,
    /// Its negation, if that is not just a `not` in front of it.
    pub(super) negated: Option<(String, Precedence)>,
}

impl Term {
    /// A text in which the names of some parts occur.
    pub fn of<'t>(
        text: impl Into<String>,
        precedence: Precedence,
        parts: impl IntoIterator<Item = &'t Term>,
    ) -> Self {
        let names = parts.into_iter().flat_map(|part| &part.names).cloned().collect();
        Self { text: text.into(), precedence, names, ..Self::default() }
    }

    /// A text that needs no brackets anywhere, and has no names.
    pub fn whole(text: impl Into<String>) -> Self {
        Self::of(text, Whole, [])
    }

    pub fn name(name: impl Into<String>) -> Self {
        let name = name.into();
        let names = BTreeSet::from([name.clone()]);
        Self { names, root: Some(name.clone()), ..Self::whole(name) }
    }

    pub fn bool(value: bool) -> Self {
        let negated = Some(((!value).to_string(), Whole));
        Self { negated, ..Self::whole(value.to_string()) }
    }

    /// The entry of a list at `shift` from the index, modulo its size; without an index, from 0.
    pub fn member(list: &str, index: Option<&str>, shift: i64, size: &str) -> Self {
        let names = [list].into_iter().chain(index).chain((shift != 0).then_some(size));
        let names = names.map(String::from).collect();
        let text = format!("{list}[{}]", place(index, shift, size));
        Self { names, root: Some(list.to_string()), ..Self::whole(text) }
    }

    /// An operator between its sides.
    pub fn infix(operator: Binary, sides: [Self; 2]) -> Self {
        let (symbol, precedence) = symbol(operator);
        let [left, right] = &sides;
        let (text, _) = joined(symbol, precedence, [left, right]);
        let not = |side: &Self| side.clone().not();
        let negated = match operator {
            // Only of ints: reals may be incomparable.
            Binary::LessInt => Some(joined("<=", precedence, [right, left])),
            Binary::LessEqualInt => Some(joined("<", precedence, [right, left])),
            Binary::And => Some(joined("||", Or, [&not(left), &not(right)])),
            Binary::Or => Some(joined("&&", And, [&not(left), &not(right)])),
            Binary::EqualVector => None,
            _ => (symbol == "==").then(|| joined("!=", precedence, [left, right])),
        };
        Self { negated, ..Self::of(text, precedence, [left, right]) }
    }

    pub fn is(self, other: Self) -> Self {
        Self::infix(Binary::EqualElement, [self, other])
    }

    pub fn and(self, other: Self) -> Self {
        Self::infix(Binary::And, [self, other])
    }

    pub fn or(self, other: Self) -> Self {
        Self::infix(Binary::Or, [self, other])
    }

    pub fn not(self) -> Self {
        // In brackets if it has a sign itself.
        let not = || (format!("!{}", self.at(Whole)), Prefix);
        let (text, precedence) = self.negated.clone().unwrap_or_else(not);
        let negated = Some((self.text, self.precedence));
        Self { text, precedence, negated, names: self.names, ..Self::default() }
    }

    /// The text, in brackets if it binds less tightly than `precedence`.
    pub fn at(&self, precedence: Precedence) -> String {
        if self.precedence >= precedence { self.text.clone() } else { format!("({})", self.text) }
    }
}

/// The index at a distance from `index`, or from 0, modulo the size of a list. Intermediate results
/// are never negative, since sizes are unsigned.
fn place(index: Option<&str>, shift: i64, size: &str) -> String {
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

fn symbol(operator: Binary) -> (&'static str, Precedence) {
    match operator {
        Binary::AddInt | Binary::AddReal | Binary::AddVector => ("+", Sum),
        Binary::SubtractInt | Binary::SubtractReal | Binary::SubtractVector => ("-", Sum),
        Binary::MultiplyInt
        | Binary::MultiplyReal
        | Binary::MultiplyVector
        | Binary::ScaleVector
        | Binary::Transform
        | Binary::MultiplyMatrices => ("*", Product),
        Binary::DivideReal | Binary::DivideVector | Binary::Div => ("/", Product),
        Binary::EqualInt
        | Binary::EqualReal
        | Binary::EqualBool
        | Binary::EqualVector
        | Binary::EqualText
        | Binary::EqualElement => ("==", Compare),
        Binary::LessInt | Binary::LessReal => ("<", Compare),
        Binary::LessEqualInt | Binary::LessEqualReal => ("<=", Compare),
        Binary::And => ("&&", And),
        Binary::Or => ("||", Or),
        Binary::Mod => ("%", Product),
    }
}

/// An operator of a precedence between its sides.
fn joined(symbol: &str, precedence: Precedence, [left, right]: [&Term; 2]) -> (String, Precedence) {
    let (left_least, right_least) = match precedence {
        Compare => (Sum, Sum),
        // Mixed `and` and `or` read better in brackets, and C++ warns without them.
        Or if left.precedence == And || right.precedence == And => (Compare, Compare),
        Or | And => (precedence, precedence),
        Sum => (Sum, Product),
        _ => (precedence, Prefix),
    };
    (format!("{} {symbol} {}", left.at(left_least), right.at(right_least)), precedence)
}

/// A value that is used alone, without brackets around all of it.
pub(in crate::emit) fn bare(value: &str) -> &str {
    let inner = value.strip_prefix('(').and_then(|it| it.strip_suffix(')'));
    let Some(inner) = inner else { return value };
    let mut depth = 0;
    let closes = |c: char| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        depth < 0
    };
    if inner.chars().any(closes) { value } else { inner }
}
