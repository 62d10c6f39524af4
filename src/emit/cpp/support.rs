//! The support functions of the language in C++, emitted where they are used.
//!
//! `[h.twin.next]` stands for pointers as the style reads them, `[v.position]` and `[f.boundary]`
//! likewise, and `[h.next := n]` for a write; `$Vertex` and the like are types. A line that begins
//! with `?prev` is emitted if halfedges store `prev`.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use super::style::Style;

/// The text of each function follows a line with its name, which ends with `.n` for a template
/// whose first parameter is a size. A function comes after those that it calls.
const TEXTS: &str = concat!(
    include_str!("functions.txt"),
    include_str!("values.txt"),
    include_str!("preview.txt"),
    include_str!("journal.txt")
);

/// The names and texts of all functions, in order.
fn functions() -> impl Iterator<Item = (&'static str, &'static str)> {
    let parts = TEXTS.split("//@ ").skip(1);
    parts.filter_map(|part| part.split_once('\n'))
}

/// The text of a function.
fn text(name: &str) -> Option<&'static str> {
    let found = functions().find(|(known, _)| *known == name);
    found.map(|(_, text)| text.trim_end())
}

/// True if there is a function of that name.
pub(in crate::emit) fn is_written_out(name: &str) -> bool {
    static NAMES: LazyLock<BTreeSet<&str>> =
        LazyLock::new(|| functions().map(|(known, _)| known.trim_end_matches(".n")).collect());
    NAMES.contains(name)
}

/// True if a function follows pointers, or calls one that does.
pub(super) fn looks_at_mesh(name: &str) -> bool {
    let mut opened = text(name).unwrap_or("").split('[').skip(1);
    opened.any(|rest| rest.split(']').next().is_some_and(|inside| inside.contains('.')))
}

/// The functions that these need, themselves included, each after those that it calls.
pub(super) fn needed(names: &[&'static str]) -> Vec<&'static str> {
    let mut order = Vec::new();
    for &name in names {
        need(name, &mut order);
    }
    order
}

fn need(name: &'static str, order: &mut Vec<&'static str>) {
    if order.contains(&name) {
        return;
    }
    let body = text(name).unwrap_or("");
    for (other, _) in functions() {
        if other != name && calls(body, other) {
            need(other, order);
        }
    }
    order.push(name);
}

/// The beginning of a call of a function; `dot.n` is called as `dot<4>(…)`.
fn call_of(name: &str) -> String {
    match name.strip_suffix(".n") {
        Some(name) => format!("{name}<"),
        None => format!("{name}("),
    }
}

/// True if a text calls a function: its name as a whole word, followed by a bracket, and not as an
/// accessor of something.
fn calls(text: &str, name: &str) -> bool {
    let call = call_of(name);
    text.match_indices(&call).any(|(at, _)| {
        let before = text[..at].chars().next_back();
        !before.is_some_and(|c| c.is_ascii_alphanumeric() || "_:.>".contains(c))
    })
}

/// The functions that a text calls, from the innermost call outwards.
pub(super) fn called(text: &str) -> Vec<&'static str> {
    let called = functions().map(|(name, _)| name).filter(|name| calls(text, name));
    let mut called: Vec<_> = called.collect();
    called.sort_by_key(|name| std::cmp::Reverse(text.find(&call_of(name))));
    called
}

/// The text of a function with its pointers and types spelled.
pub(super) fn spelled(name: &str, style: &Style) -> String {
    let lines = text(name).unwrap_or("").split_inclusive('\n');
    let lines = lines.filter_map(|line| match line.strip_prefix("?prev") {
        Some(line) => style.has_prev().then_some(line),
        None => Some(line),
    });
    let text: String = lines.collect();
    qualified(name, &with_pointers(&text, style))
}

/// A text with its pointers and types spelled.
pub(super) fn with_pointers(text: &str, style: &Style) -> String {
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
pub(super) fn qualified(name: &str, text: &str) -> String {
    let mut text = text.to_string();
    for (other, _) in functions().filter(|(other, _)| *other != name) {
        let call = call_of(other);
        let mut from = 0;
        while let Some(found) = text[from..].find(&call) {
            let at = from + found;
            from = at + call.len();
            if calls(&text[at.saturating_sub(1)..from], other) {
                text.insert_str(at, "hedgerow::");
                from += "hedgerow::".len();
            }
        }
    }
    text
}
