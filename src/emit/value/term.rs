//! Values as text, and where brackets are needed.

use std::collections::BTreeSet;

use crate::diagram::Binary;

/// The precedence of the outermost operator of a text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::emit) enum Level {
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
    pub level: Level,
    /// The names in it.
    pub names: BTreeSet<String>,
    /// The name that it is, or of the list of which it is an entry; `None` for what is computed.
    pub root: Option<String>,
    /// Its negation, if that is not just a `not` in front of it.
    negated: Option<(String, Level)>,
}

impl Term {
    /// A text in which the names of some parts occur.
    pub fn of<'t>(
        text: impl Into<String>,
        level: Level,
        parts: impl IntoIterator<Item = &'t Term>,
    ) -> Self {
        let names = parts.into_iter().flat_map(|part| &part.names).cloned().collect();
        Self { text: text.into(), level, names, root: None, negated: None }
    }

    /// A text that needs no brackets anywhere, and has no names.
    pub fn whole(text: impl Into<String>) -> Self {
        Self::of(text, Level::Whole, [])
    }

    pub fn name(name: impl Into<String>) -> Self {
        let name = name.into();
        let names = BTreeSet::from([name.clone()]);
        Self { names, root: Some(name.clone()), ..Self::whole(name) }
    }

    pub fn bool(value: bool) -> Self {
        let negated = Some(((!value).to_string(), Level::Whole));
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
        let (symbol, level) = symbol(operator);
        let [left, right] = &sides;
        let (text, _) = joined(symbol, level, [left, right]);
        let not = |side: &Self| side.clone().not();
        let negated = match operator {
            // Only of ints: reals may be incomparable.
            Binary::LessInt => Some(joined("<=", level, [right, left])),
            Binary::LessEqualInt => Some(joined("<", level, [right, left])),
            Binary::And => Some(joined("||", Level::Or, [&not(left), &not(right)])),
            Binary::Or => Some(joined("&&", Level::And, [&not(left), &not(right)])),
            Binary::EqualVector => None,
            _ => (symbol == "==").then(|| joined("!=", level, [left, right])),
        };
        Self { negated, ..Self::of(text, level, [left, right]) }
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
        let not = || (format!("!{}", self.at(Level::Whole)), Level::Prefix);
        let (text, level) = self.negated.clone().unwrap_or_else(not);
        let negated = Some((self.text, self.level));
        Self { text, level, negated, names: self.names, root: None }
    }

    /// The text, in brackets if it binds less tightly than `level`.
    pub fn at(&self, level: Level) -> String {
        match self.level >= level {
            true => self.text.clone(),
            false => format!("({})", self.text),
        }
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

fn symbol(operator: Binary) -> (&'static str, Level) {
    match operator {
        Binary::AddInt | Binary::AddReal | Binary::AddVector => ("+", Level::Sum),
        Binary::SubtractInt | Binary::SubtractReal | Binary::SubtractVector => ("-", Level::Sum),
        Binary::MultiplyInt
        | Binary::MultiplyReal
        | Binary::MultiplyVector
        | Binary::ScaleVector
        | Binary::Transform
        | Binary::MultiplyMatrices => ("*", Level::Product),
        Binary::DivideReal | Binary::DivideVector | Binary::Div => ("/", Level::Product),
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
        Binary::Mod => ("%", Level::Product),
    }
}

/// An operator of a level between its sides.
fn joined(symbol: &str, level: Level, [left, right]: [&Term; 2]) -> (String, Level) {
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
    (format!("{} {symbol} {}", left.at(left_level), right.at(right_level)), level)
}

/// A value that is used alone, without brackets around all of it.
pub(in crate::emit) fn bare(value: &str) -> &str {
    let inner = value.strip_prefix('(').and_then(|it| it.strip_suffix(')'));
    let Some(inner) = inner else {
        return value;
    };
    let mut depth = 0;
    let closes = |c: char| {
        depth += i32::from(c == '(') - i32::from(c == ')');
        depth < 0
    };
    match inner.chars().any(closes) {
        true => value,
        false => inner,
    }
}
