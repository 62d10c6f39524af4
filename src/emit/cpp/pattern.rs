//! Patterns of a style: their names, and which texts are valid.
//!
//! A pattern may use `{of}`, the element; `{pointer}`, the name of the pointer or attribute; and
//! `{value}`.

use std::fmt;

use super::super::reserved::is_keyword_of_cpp;
use crate::diagnostic::all_of;

/// The form of a pattern.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// Code that uses all of these parts.
    Code(&'static [&'static str]),
    /// A name, optionally with a namespace.
    Name,
    /// A name, or nothing.
    NameOrNone,
    /// One of some words.
    Word(&'static [&'static str]),
    /// Names of files, of which the first that exists is used; or nothing.
    Files,
}

use Form::{Code, Files, Name, NameOrNone, Word};

const OF: Form = Code(&["{of}"]);
const ATTRIBUTE: Form = Code(&["{of}", "{pointer}"]);

/// The patterns and names, each with its form, its default, and its value for meshes with accessors
/// if that differs.
pub(super) const PATTERNS: &[(&str, Form, &str, Option<&str>)] = &[
    ("read", ATTRIBUTE, "{of}->{pointer}", Some("{of}->{pointer}()")),
    (
        "write",
        Code(&["{of}", "{pointer}", "{value}"]),
        "{of}->{pointer} = {value}",
        Some("{of}->{pointer}() = {value}"),
    ),
    ("next", Name, "next", None),
    ("prev", NameOrNone, "", None),
    ("twin", Name, "twin", None),
    ("vertex", Name, "vertex", None),
    ("edge", Name, "edge", None),
    ("face", Name, "face", None),
    ("halfedge", Name, "halfedge", None),
    ("boundary", OF, "{of}->boundary", Some("{of}->is_boundary()")),
    ("set_boundary", Code(&["{of}", "{value}"]), "{of}->boundary = {value}", None),
    ("position", OF, "{of}->position", Some("{of}->pos")),
    ("attribute", ATTRIBUTE, "{of}->{pointer}", None),
    ("mesh", Name, "Mesh", Some("Halfedge_Mesh")),
    ("include", Files, "", None),
    ("nested", Word(&["yes", "no"]), "yes", None),
    ("member", Word(&["yes", "no"]), "no", None),
    ("inline", Word(&["yes", "no"]), "no", None),
    ("result", Word(&["bool", "given"]), "bool", None),
    ("defaults", Word(&["kept", "fixed"]), "kept", None),
    ("function", NameOrNone, "", None),
    ("Vertex", Name, "VertexRef", None),
    ("Halfedge", Name, "HalfedgeRef", None),
    ("Edge", Name, "EdgeRef", None),
    ("Face", Name, "FaceRef", None),
    ("Vector", Name, "Vec3", None),
    ("Vector2", NameOrNone, "", None),
    ("Vector4", NameOrNone, "", None),
    ("Matrix3", NameOrNone, "", None),
    ("Matrix4", NameOrNone, "", None),
    ("real", Name, "double", Some("float")),
    ("new_vertex", Code(&[]), "new_vertex()", None),
    ("new_halfedge", Code(&[]), "new_halfedge()", None),
    ("new_edge", Code(&[]), "new_edge()", None),
    ("new_face", Code(&[]), "new_face()", None),
    ("erase_vertex", OF, "erase({of})", None),
    ("erase_halfedge", OF, "erase({of})", None),
    ("erase_edge", OF, "erase({of})", None),
    ("erase_face", OF, "erase({of})", None),
];

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
pub(super) fn understand(name: &str, form: Form, value: &str) -> Result<(), StyleError> {
    let fits = match form {
        Code(parts) => return understand_code(name, parts, value),
        Word(words) if words.contains(&value) => true,
        Word(words) => {
            return Err(StyleError(format!("`{name}` is one of {}", quoted(words))));
        }
        Files if value.contains(['"', '<', '>', '\\']) || value.contains(char::is_control) => {
            let why = "is not the bare name of a file, as `mesh.h`, as `include` must be";
            return Err(StyleError(format!("`{value}` {why}")));
        }
        Files => true,
        NameOrNone if value.is_empty() => true,
        Name | NameOrNone => {
            let is_number = name == "real" && ["float", "double"].contains(&value);
            is_number || value.split("::").all(is_word)
        }
    };
    if fits { Ok(()) } else { Err(not_a_name(name, value)) }
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
    StyleError(format!("`{value}` is not a C++ name, as `{name}` must be"))
}

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
            ')' | ']' | '}' if open.pop() != Some(c) => {
                return wrong("has a bracket that does not match another");
            }
            ';' | '#' | '\\' => {
                return wrong("is an expression: no `;`, no `#` and no `\\` stands in it");
            }
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
        (false, _) => wrong("has a bracket that does not match another"),
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
