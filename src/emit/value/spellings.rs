//! Types and functions in Rust and C++, side by side, as `spellings.txt` spells them.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use super::term::{Precedence, Term};
use crate::diagram::Type;
use crate::emit::language::{Language, filled};

/// The text in Rust and in C++ by name; empty for none.
static SPELLINGS: LazyLock<BTreeMap<&str, [&str; 2]>> = LazyLock::new(|| {
    let rows = rows(include_str!("spellings.txt")).into_iter();
    rows.filter_map(|row| Some((*row.first()?, [*row.get(1)?, *row.get(2)?]))).collect()
});

/// The rows of a table. Columns are apart by at least two spaces, or on lines of their own; `-`
/// stands for nothing, and lines that begin with `#` are comments.
pub(in crate::emit) fn rows(table: &'static str) -> Vec<Vec<&'static str>> {
    let mut rows: Vec<Vec<&str>> = Vec::new();
    for line in table.lines().filter(|line| !line.starts_with('#') && !line.is_empty()) {
        let parts = line.split("  ").map(str::trim).filter(|part| !part.is_empty());
        let parts = parts.map(|part| if part == "-" { "" } else { part });
        match (line.starts_with(' '), rows.last_mut()) {
            (true, Some(row)) => row.extend(parts),
            _ => rows.push(parts.collect()),
        }
    }
    rows
}

/// The spelling of a type or a call, by its name and, if there is a row for it, the type of its
/// operands. Empty for an operator that stands between its sides.
pub(in crate::emit) fn spelling(language: Language<'_>, name: &str, ty: Type) -> &'static str {
    let exact = SPELLINGS.get(format!("{name}.{ty:?}").as_str());
    let [rust, cpp] = exact.or_else(|| SPELLINGS.get(name)).copied().unwrap_or_default();
    if language.is_rust() { rust } else { cpp }
}

/// A call with the names of types, sizes and parts filled in.
pub(super) fn with_types(language: Language<'_>, call: &str, (ty, part): (Type, u8)) -> String {
    let part = part.min(3);
    filled(call, |name, _, _| {
        Some(match name {
            "T" => language.ty(ty),
            "N" => ty.size().to_string(),
            "M" => language.ty(if ty.size() == 3 { Type::Mat3 } else { Type::Mat4 }),
            "P" => part.to_string(),
            "X" => ["x", "y", "z", "w"][usize::from(part)].to_string(),
            _ => return None,
        })
    })
}

/// A call with its arguments filled in. They bind as tightly as `precedence`, or as their place
/// requires.
pub(super) fn with_arguments(call: &str, args: &[&Term], precedence: Precedence) -> String {
    filled(call, |number, before, rest| {
        let precedence = match () {
            () if rest.starts_with(['.', '[']) || before.ends_with('-') => Precedence::Whole,
            () if before.ends_with("- ") => Precedence::Product,
            () if rest.starts_with(" -") => precedence.max(Precedence::Sum),
            () => precedence,
        };
        Some(args.get(number.parse::<usize>().ok()?)?.at(precedence))
    })
}
