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
    let mut out = String::new();
    let mut rest = text;
    while let Some(at) = rest.find(['[', '$']) {
        out.push_str(&rest[..at]);
        if rest[at..].starts_with('$') {
            let word = &rest[at + 1..];
            let end = word.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(word.len());
            out.push_str(&match &word[..end] {
                "Mesh" => style.name("mesh").to_string(),
                ty => style.qualified(ty),
            });
            rest = &word[end..];
            continue;
        }
        let inside = &rest[at + 1..];
        let end = inside.find(']').unwrap_or(inside.len());
        match inside[..end].split_once('.') {
            // A chain of pointers; a lambda or an index is left alone.
            Some((of, pointers)) => {
                let (pointers, value) = match pointers.split_once(" := ") {
                    Some((pointers, value)) => (pointers, Some(value)),
                    None => (pointers, None),
                };
                let mut term = of.to_string();
                let mut pointers = pointers.split('.').peekable();
                while let Some(pointer) = pointers.next() {
                    term = match value.filter(|_| pointers.peek().is_none()) {
                        Some(value) => style.put(&term, pointer, value),
                        None => style.chained(&term, pointer),
                    };
                }
                out.push_str(&term);
                rest = inside.get(end + 1..).unwrap_or("");
            }
            None => {
                out.push('[');
                rest = inside;
            }
        }
    }
    out + rest
}

/// Qualifies calls of the other functions with their namespace, to prevent argument-dependent
/// lookup.
pub(in crate::emit) fn qualified(name: &str, text: &str) -> String {
    let mut text = text.to_string();
    for other in CPP.names().filter(|other| *other != name) {
        for at in calls(&text, other).into_iter().rev() {
            text.insert_str(at, "hedgerow::");
        }
    }
    text
}
