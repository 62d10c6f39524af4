//! Patterns of a style: their names, and which texts are valid.
//!
//! A pattern may use `{of}`, the element; `{pointer}`, the name of the pointer or attribute; and
//! `{value}`.

use std::fmt;
use std::sync::LazyLock;

use super::super::reserved::is_keyword_of_cpp;
use crate::diagnostic::all_of;
use crate::emit::value::rows;

/// The form of a pattern.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// Code that uses all of these parts.
    Code(Vec<&'static str>),
    /// A name, optionally with a namespace.
    Name,
    /// A name, or nothing.
    NameOrNone,
    /// One of some words.
    Word(Vec<&'static str>),
    /// Names of files, of which the first that exists is used; or nothing.
    Files,
}

use Form::{Code, Files, Name, NameOrNone, Word};

/// A pattern or a name.
pub(super) struct Pattern {
    pub name: &'static str,
    pub form: Form,
    /// Its default.
    pub fields: &'static str,
    /// Its value for meshes with accessors, if that differs.
    pub accessors: Option<&'static str>,
}

/// The patterns and names of `patterns.txt`.
pub(super) static PATTERNS: LazyLock<Vec<Pattern>> = LazyLock::new(|| {
    let patterns = rows(include_str!("patterns.txt")).into_iter().filter_map(|row| {
        let [name, form, fields, ref accessors @ ..] = row[..] else { return None };
        let form = match form {
            "name" => Name,
            "name?" => NameOrNone,
            "files" => Files,
            "code" => Code(Vec::new()),
            words if words.contains('|') => Word(words.split('|').collect()),
            parts => Code(parts.split(' ').collect()),
        };
        Some(Pattern { name, form, fields, accessors: accessors.first().copied() })
    });
    patterns.collect()
});

/// The patterns of a style: the name of each, its default, and its value with `accessors` where that
/// differs.
pub fn style_patterns() -> impl Iterator<Item = [&'static str; 3]> {
    PATTERNS.iter().map(|known| [known.name, known.fields, known.accessors.unwrap_or_default()])
}

/// The reason why a style is not understood, or cannot compile.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StyleError(pub(super) String);

impl fmt::Display for StyleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

fn quoted(words: &[&str]) -> String {
    all_of(words.iter().map(|word| format!("`{word}`")))
}

/// Checks that a text has the form of its pattern.
pub(super) fn understand(name: &str, form: &Form, value: &str) -> Result<(), StyleError> {
    let is_number = name == "real" && ["float", "double"].contains(&value);
    let is_name = || is_number || value.split("::").all(is_word);
    match form {
        Code(parts) => understand_code(name, parts, value),
        Word(words) if !words.contains(&value) => {
            Err(StyleError(format!("`{name}` is one of {}", quoted(words))))
        }
        Files if value.contains(['"', '<', '>', '\\']) || value.contains(char::is_control) => {
            let why = "is not the bare name of a file, as `mesh.h`, as `include` must be";
            Err(StyleError(format!("`{value}` {why}")))
        }
        NameOrNone if value.is_empty() => Ok(()),
        Name | NameOrNone if !is_name() => Err(not_a_name(name, value)),
        _ => Ok(()),
    }
}

/// True if a text is one identifier and not a keyword of C++.
pub(super) fn is_word(text: &str) -> bool {
    let mut letters = text.chars();
    letters.next().is_some_and(|c| c.is_ascii_alphabetic() || c == '_')
        && letters.all(|c| c.is_ascii_alphanumeric() || c == '_')
        && !is_keyword_of_cpp(text)
}

/// The refusal of a value that has to be a name.
pub(super) fn not_a_name(name: &str, value: &str) -> StyleError {
    let alias = match name {
        _ if value.ends_with('*') => ": an alias is one, `using T = V*;`",
        "prev" => ": `prev=prev` names the pointer, which is then set like `next`",
        _ => "",
    };
    StyleError(format!("`{value}` is not a C++ name, as `{name}` must be{alias}"))
}

const UNMATCHED: &str = "has a bracket that does not match another";

fn understand_code(name: &str, parts: &[&str], value: &str) -> Result<(), StyleError> {
    let wrong = |why: &str| Err(StyleError(format!("the pattern of `{name}` {why}")));
    if let Some(part) = parts.iter().find(|part| !value.contains(**part)) {
        return wrong(&format!("must use `{part}`"));
    }
    let mut open = Vec::new();
    let mut rest = value;
    while let Some(c) = rest.chars().next() {
        if let Some(part) = parts.iter().find(|part| rest.starts_with(**part)) {
            rest = &rest[part.len()..];
            continue;
        }
        if let Some(end) = rest.find('}').filter(|&end| c == '{' && is_word(&rest[1..end])) {
            let known = match parts {
                [] => String::new(),
                parts => format!(", only {}", quoted(parts)),
            };
            return wrong(&format!("has no placeholder `{}`{known}", &rest[..=end]));
        }
        match c {
            '(' => open.push(')'),
            '[' => open.push(']'),
            '{' => open.push('}'),
            ')' | ']' | '}' if open.pop() != Some(c) => return wrong(UNMATCHED),
            ';' | '#' | '\\' => return wrong("is an expression without `;`, `#` and `\\`"),
            '"' | '\'' => return wrong("is an expression without quotes"),
            c if c.is_control() => return wrong("stands on one line"),
            _ if rest.starts_with("//") || rest.starts_with("/*") => {
                return wrong("has no comment in it");
            }
            _ => {}
        }
        rest = &rest[c.len_utf8()..];
    }
    match (open.is_empty(), value.trim().is_empty()) {
        (false, _) => wrong(UNMATCHED),
        (_, true) => wrong("is empty"),
        _ => Ok(()),
    }
}

/// The words of a pattern that refer to its context, each with whether it is called; words behind a
/// dot, an arrow or a namespace are not among them.
pub(super) fn free_words(pattern: &str) -> Vec<(&str, bool)> {
    let is_letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
    let mut words = Vec::new();
    let mut at = 0;
    while let Some(begin) = pattern[at..].find(is_letter).map(|found| at + found) {
        let rest = &pattern[begin..];
        let length = rest.find(|c| !is_letter(c)).unwrap_or(rest.len());
        let (word, behind) = rest.split_at(length);
        let mut before = &pattern[..begin];
        let is_filled = before.ends_with('{') && behind.starts_with('}');
        let mut behind = behind.trim_start_matches("{pointer}");
        if is_filled {
            (before, behind) = (&pattern[..begin - 1], behind.trim_start_matches('}'));
        }
        let is_called = behind.trim_start().starts_with('(');
        let is_part = [".", "->", "::"].iter().any(|sign| before.ends_with(sign));
        let is_word = is_word(word) && !behind.starts_with("::") && (!is_filled || is_called);
        let is_glued = is_filled && before.ends_with(is_letter);
        if !is_part && !is_glued && is_word || word == "this" {
            words.push((word, is_called));
        }
        at = begin + length;
    }
    words
}
