//! The languages that are emitted.

use super::cpp::Style;
use super::value::spelling;
use crate::diagram::{Kind, Type};

/// A text in a language: the first in Rust, the second in C++.
macro_rules! say {
    ($language:expr, $rust:literal, $cpp:literal) => {
        match $language.style {
            None => format!($rust),
            Some(_) => format!($cpp),
        }
    };
}

/// The maximum length of a line in C++.
pub(super) const WIDTH: usize = 92;

/// The language of emitted text: C++ in the style of a mesh class, or Rust.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Language<'s> {
    /// The style of C++; `None` in Rust.
    pub style: Option<&'s Style>,
    /// True where the names of the mesh class are not in scope.
    pub is_outside: bool,
    /// Words that the mesh class reserves.
    pub reserved: &'s [String],
}

impl Language<'_> {
    /// True for Rust. Its mesh has isolated vertices, stores attributes in columns that have to be
    /// looked up first, and records changes and can undo them. A call that changes it borrows it, so
    /// that nothing else in the same call can read it.
    pub fn is_rust(self) -> bool {
        self.style.is_none()
    }

    /// True if halfedges store `prev`; if not, it is found by a walk.
    pub fn has_prev(self) -> bool {
        self.style.is_none_or(Style::has_prev)
    }

    /// The name of a type.
    pub fn ty(self, ty: Type) -> String {
        let spelled = spelling(self, "type", ty);
        match (self.style, spelled.strip_prefix('$')) {
            (Some(style), Some(name)) if self.is_outside => style.qualified(name),
            (Some(style), Some(name)) => style.value(name),
            _ => spelled.to_string(),
        }
    }

    /// The type that an operation returns.
    pub fn outcome(self, result: Option<Type>) -> String {
        match result.map(|ty| self.ty(ty)) {
            None => "bool".into(),
            Some(ty) => say!(self, "Option<{ty}>", "std::optional<{ty}>"),
        }
    }

    /// A head and the lines that it holds: in C++ on one line if these are a single short one.
    pub fn held(self, head: &str, text: &str) -> String {
        let mut lines = text.lines();
        match (lines.next(), lines.next()) {
            (Some(only), None) if !self.is_rust() && head.len() + only.len() < WIDTH => {
                format!("{head} {only}")
            }
            (None, _) if !self.is_rust() => String::new(),
            _ => {
                let unit = if self.is_rust() { "    " } else { "  " };
                let indented = |line| match line {
                    "" => "\n".to_string(),
                    line => format!("{unit}{line}\n"),
                };
                let inner: String = text.lines().map(indented).collect();
                format!("{head} {{\n{inner}}}")
            }
        }
    }
}

/// The type of the elements of a kind; of a path or fan, that of its halfedges.
pub(super) fn type_of(kind: Kind) -> Type {
    kind.element_type().unwrap_or(Type::Halfedge)
}

/// A text whose parts in braces are filled in, in one pass: inserted text is not searched again.
/// `with` gets the name of a part, the text before it, and what follows; unknown parts stay.
pub(super) fn filled(pattern: &str, with: impl Fn(&str, &str, &str) -> Option<String>) -> String {
    let mut parts = pattern.split('{');
    let mut text = parts.next().unwrap_or_default().to_string();
    for part in parts {
        match part.split_once('}').and_then(|(name, rest)| Some((with(name, &text, rest)?, rest))) {
            Some((inserted, rest)) => text.extend([inserted.as_str(), rest]),
            None => text.extend(["{", part]),
        }
    }
    text
}
