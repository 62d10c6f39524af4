//! The support functions of the language in C++, emitted where they are used.
//!
//! `[h.twin.next]` stands for pointers as the style reads them, `[v.position]` and `[f.boundary]`
//! likewise, and `[h.next := n]` for a write; `$Vertex` and the like are types. A line that begins
//! with `?prev` is emitted if halfedges store `prev`.

use super::style::Style;
use crate::emit::print::support::{CPP, calls};

/// True if the text of a function follows pointers.
pub(in crate::emit) fn looks_at_mesh(text: &str) -> bool {
    let mut opened = text.split('[').skip(1);
    opened.any(|rest| rest.split(']').next().is_some_and(|inside| inside.contains('.')))
}

/// The text of a function with its pointers and types spelled.
pub(in crate::emit) fn spelled(name: &str, text: &str, style: &Style) -> String {
    let lines = text.trim_end().split_inclusive('\n');
    let lines = lines.filter_map(|line| match line.strip_prefix("?prev") {
        Some(line) => style.has_prev().then_some(line),
        None => Some(line),
    });
    let text: String = lines.collect();
    qualified(name, &with_pointers(&text, style))
}

/// A text with its pointers and types spelled.
pub(in crate::emit) fn with_pointers(text: &str, style: &Style) -> String {
    let mut parts = text.split('$');
    let mut typed = parts.next().unwrap_or_default().to_string();
    for part in parts {
        let end = part.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(part.len());
        typed += &match &part[..end] {
            "Mesh" => style.name("mesh").to_string(),
            ty => style.qualified(ty),
        };
        typed += &part[end..];
    }
    let mut parts = typed.split('[');
    let mut out = parts.next().unwrap_or_default().to_string();
    for part in parts {
        // A lambda or an index is left alone.
        match part.split_once(']').filter(|(inside, _)| inside.contains('.')) {
            Some((inside, rest)) => out.extend([&chain(inside, style), rest]),
            None => out.extend(["[", part]),
        }
    }
    out
}

/// A chain of pointers, `h.twin.next`, or a write at its end, `h.twin.next := n`.
fn chain(text: &str, style: &Style) -> String {
    if let Some((chain_of, value)) = text.split_once(" := ")
        && let Some((of, last)) = chain_of.rsplit_once('.')
    {
        return style.put(&chain(of, style), last, value);
    }
    let mut parts = text.split('.');
    let of = parts.next().unwrap_or_default().to_string();
    parts.fold(of, |of, pointer| style.chained(&of, pointer))
}

/// Qualifies calls of the other functions with their namespace, to prevent argument-dependent
/// lookup.
pub(in crate::emit) fn qualified(name: &str, text: &str) -> String {
    let mut text = text.to_string();
    let is_other = |other: &&str| other.trim_end_matches(".n") != name.trim_end_matches(".n");
    for other in CPP.names().filter(is_other) {
        for at in calls(&text, other).into_iter().rev() {
            text.insert_str(at, "hedgerow::");
        }
    }
    text
}
