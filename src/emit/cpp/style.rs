//! Styles of C++: reads, writes, allocations and erasures, which differ from one mesh class to the
//! next. Everything is a named [`pattern`](super::pattern).

use std::collections::{BTreeMap, BTreeSet};

use super::pattern::{Form, PATTERNS, StyleError, free_words, is_word, not_a_name, understand};
use crate::diagram::Kind;
use crate::emit::item::Signature;
use crate::emit::language::filled;
use crate::emit::print::Part;

/// The names of the types of elements.
pub(super) const ELEMENTS: [&str; 4] = ["Vertex", "Halfedge", "Edge", "Face"];

/// The parts of C++ code that depend on the mesh class.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Style {
    patterns: Vec<String>,
    /// The C++ names of operations, each with the name in the program first.
    functions: BTreeMap<String, String>,
}

impl Default for Style {
    /// Fields: `h->next`.
    fn default() -> Self {
        let patterns = PATTERNS.iter().map(|pattern| pattern.fields.to_string()).collect();
        Self { patterns, functions: BTreeMap::new() }
    }
}

impl Style {
    /// Changes a style: `fields`, `accessors`, or `NAME=PATTERN`.
    ///
    /// # Errors
    /// [`StyleError`] for a text of another form, for an unknown pattern, and for one that cannot
    /// compile.
    pub fn set(&mut self, text: &str) -> Result<(), StyleError> {
        match (text, text.split_once('=')) {
            ("fields", _) => *self = Self::default(),
            ("accessors", _) => {
                for (pattern, known) in self.patterns.iter_mut().zip(PATTERNS.iter()) {
                    if let Some(accessors) = known.accessors {
                        *pattern = accessors.to_string();
                    }
                }
            }
            (_, Some((name, value))) => self.set_pattern(name, value)?,
            (_, None) => {
                return Err(StyleError(format!(
                    "`{text}` is no style: write fields, accessors, or NAME=PATTERN"
                )));
            }
        }
        Ok(())
    }

    fn set_pattern(&mut self, name: &str, value: &str) -> Result<(), StyleError> {
        if let Some(op) = name.strip_prefix("function.") {
            if !is_word(value) {
                return Err(not_a_name(name, value));
            }
            self.functions.insert(op.to_string(), value.to_string());
            return Ok(());
        }
        let Some(at) = PATTERNS.iter().position(|known| known.name == name) else {
            let names: Vec<_> = PATTERNS.iter().map(|known| known.name).collect();
            let names = names.join(", ");
            return Err(StyleError(format!("a style has no `{name}`; it has {names}")));
        };
        understand(name, &PATTERNS[at].form, value)?;
        self.patterns[at] = value.to_string();
        Ok(())
    }

    /// Changes a style line by line, as the text of a target says; empty lines and lines that begin
    /// with `//` are ignored.
    ///
    /// # Errors
    /// The first line that is not understood, numbered from 1, and the reason.
    pub fn set_lines(&mut self, text: &str) -> Result<(), (usize, StyleError)> {
        for (at, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
            let line = line.trim();
            if !line.is_empty() && !line.starts_with("//") {
                self.set(line).map_err(|error| (at + 1, error))?;
            }
        }
        Ok(())
    }

    /// Checks that all patterns can compile together.
    ///
    /// # Errors
    /// [`StyleError`] for patterns that contradict each other.
    pub fn check(&self) -> Result<(), StyleError> {
        let mut pointers = BTreeMap::new();
        for pointer in ["next", "prev", "twin", "vertex", "edge", "face"] {
            let name = self.name(pointer);
            if let Some(other) = pointers.insert(name, pointer).filter(|_| !name.is_empty()) {
                return Err(StyleError(format!(
                    "`{other}` and `{pointer}` of a halfedge are both `{name}`"
                )));
            }
        }
        let first_of = |name| self.name(name).split("::").next().unwrap_or_default();
        // Inside of `app::std` the name `std` would mean that.
        let hides = |part| ["std", first_of("mesh"), first_of("namespace")].contains(&part);
        for name in ["namespace", "operations"] {
            let space = self.name(name);
            let (first, inner) = space.split_once("::").unwrap_or((space, ""));
            let is_class = [first, space].contains(&self.name("mesh"));
            if first == "std" || is_class || inner.split("::").any(hides) {
                return Err(StyleError(format!("`{name}={space}` is no namespace of its own")));
            }
        }
        if self.is_member() && !self.name("operations").is_empty() {
            let why = "members of a class, as `member=yes` says, stand in no other namespace";
            return Err(StyleError(format!("`operations={}`: {why}", self.name("operations"))));
        }
        let mut code = self.code().filter(|_| self.is_member());
        match code.find(|(_, pattern)| free_words(pattern).iter().any(|(word, _)| *word == "mesh"))
        {
            Some((name, _)) => Err(StyleError(format!(
                "the pattern of `{name}` uses `mesh`, and in a member of the class, as `member=yes` says, there is none"
            ))),
            None => Ok(()),
        }
    }

    /// All patterns.
    pub(super) fn patterns(&self) -> impl Iterator<Item = &str> {
        self.patterns.iter().map(String::as_str)
    }

    /// The patterns that are code, with their names.
    fn code(&self) -> impl Iterator<Item = (&'static str, &str)> {
        let all = PATTERNS.iter().zip(&self.patterns);
        let code = all.filter(|(known, _)| matches!(known.form, Form::Code(_)));
        code.map(|(known, pattern)| (known.name, pattern.as_str()))
    }

    /// A pattern that is invalid where no mesh is in scope, as in functions beside the operation,
    /// and the word in it that needs one.
    pub(in crate::emit) fn needs_mesh(&self) -> Option<(&'static str, &str)> {
        let is_member = self.is_member();
        self.code().find_map(|(name, pattern)| {
            let is_call_of_mesh = name.starts_with("new_") || name.starts_with("erase_");
            let words = free_words(pattern).into_iter();
            let mut needing = words.filter(|(word, is_called)| match is_member {
                true => *word == "this" || *is_called && !is_call_of_mesh,
                false => *word == "mesh",
            });
            needing.next().map(|(word, _)| (name, word))
        })
    }

    /// Two kinds of elements that have the same type.
    pub(in crate::emit) fn one_type(&self) -> Option<[&'static str; 2]> {
        let pairs = ELEMENTS.iter().enumerate();
        let mut pairs =
            pairs.flat_map(|(at, one)| ELEMENTS[at + 1..].iter().map(move |other| [*one, *other]));
        pairs.find(|[one, other]| self.name(one) == self.name(other))
    }

    /// Words that the patterns use, which are therefore reserved.
    pub(in crate::emit) fn reserved(&self) -> Vec<String> {
        let mut reserved: Vec<String> = Vec::new();
        // Pointers follow an arrow, where they do not collide with names of the drawing.
        let free = ["next", "prev", "twin", "vertex", "edge", "face", "halfedge", "function"];
        let all = PATTERNS.iter().zip(&self.patterns);
        for (known, pattern) in all.filter(|(known, _)| !free.contains(&known.name)) {
            let words: Vec<&str> = match known.form {
                Form::Code(_) => free_words(pattern).into_iter().map(|(word, _)| word).collect(),
                Form::Name | Form::NameOrNone => pattern.split("::").collect(),
                _ => continue,
            };
            reserved.extend(words.into_iter().map(String::from));
        }
        reserved.retain(|word| is_word(word) && word != "pointer");
        reserved
    }

    /// The words for the members of elements, which attributes cannot have as names.
    pub(in crate::emit) fn members(&self) -> BTreeSet<String> {
        let all = "next prev twin vertex edge face halfedge boundary set_boundary position";
        let words = all.split(' ').flat_map(|name| {
            let text = fill(self.name(name), " ", " ", " ");
            let words = text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_');
            words.map(String::from).collect::<Vec<_>>()
        });
        words.collect()
    }

    /// The name that a target gives to an operation, if any.
    pub fn function(&self, op: &str) -> Option<&str> {
        self.functions.get(op).map(String::as_str)
    }

    /// The name of the function for an operation, or for what one calls.
    pub(in crate::emit) fn name_of<'n>(&'n self, head: &'n Signature, part: Part) -> &'n str {
        let other = self.name("function");
        match self.function(&head.declared) {
            Some(name) if part != Part::Called => name,
            _ if part == Part::Alone && !other.is_empty() => other,
            _ => &head.name,
        }
    }

    /// True if a target names operations, so that others do not belong to it.
    pub fn names_functions(&self) -> bool {
        !self.functions.is_empty()
    }

    /// The lines before everything else that include the mesh class: the first of the files that
    /// exists.
    pub(in crate::emit) fn include(&self) -> String {
        let mut text = if self.is("inline", "yes") { "#pragma once\n" } else { "" }.to_string();
        let files: Vec<_> = self.name("include").split_whitespace().collect();
        for (at, file) in files.iter().enumerate() {
            text += &match at {
                _ if files.len() == 1 => String::new(),
                0 => format!("#if __has_include(\"{file}\")\n"),
                _ if at + 1 == files.len() => "#else\n".into(),
                _ => format!("#elif __has_include(\"{file}\")\n"),
            };
            text += &format!("#include \"{file}\"\n");
        }
        if files.len() > 1 { text + "#endif\n" } else { text }
    }

    /// True if a pattern that is one of some words is this one.
    pub(in crate::emit) fn is(&self, name: &str, word: &str) -> bool {
        self.name(name) == word
    }

    /// A pattern or a name, as the mesh class spells it.
    pub(in crate::emit) fn name(&self, name: &str) -> &str {
        let at = PATTERNS.iter().position(|known| known.name == name);
        at.map_or("", |at| &self.patterns[at])
    }

    /// A type of values; where the mesh class has none, an array, for matrices column by column.
    pub(in crate::emit) fn value(&self, ty: &str) -> String {
        let name = self.name(ty);
        if !name.is_empty() {
            return name.to_string();
        }
        let (kind, size) = ty.split_at(ty.len().saturating_sub(1));
        let array = |of: &str| format!("std::array<{of}, {size}>");
        let one = array(self.name("real"));
        if kind == "Matrix" { array(&one) } else { one }
    }

    /// True if operations are members of the mesh class.
    pub(in crate::emit) fn is_member(&self) -> bool {
        self.is("member", "yes")
    }

    /// True if halfedges store `prev`.
    pub(in crate::emit) fn has_prev(&self) -> bool {
        !self.name("prev").is_empty()
    }

    /// `of.pointer` for a pointer by its usual name, and also for `position` and `boundary`; of a
    /// mesh, `new_vertex` and the like.
    pub(in crate::emit) fn chained(&self, of: &str, pointer: &str) -> String {
        match pointer {
            "boundary" | "position" => operand(self.name(pointer), of, ""),
            _ if pointer.starts_with("new_") => format!("{of}.{}", self.name(pointer)),
            _ => operand(self.name("read"), of, self.name(pointer)),
        }
    }

    /// `of.pointer = value` for the same; of a mesh, the call that erases the value.
    pub(in crate::emit) fn put(&self, of: &str, pointer: &str, value: &str) -> String {
        match pointer {
            "boundary" => fill(self.name("set_boundary"), of, "", value),
            "position" => format!("{} = {value}", self.chained(of, pointer)),
            _ if pointer.starts_with("erase_") => {
                format!("{of}.{}", fill(self.name(pointer), value, "", ""))
            }
            _ => fill(self.name("write"), of, self.name(pointer), value),
        }
    }

    /// A type where the names of the mesh class are not in scope: `Mesh::VertexRef`.
    pub(in crate::emit) fn qualified(&self, ty: &str) -> String {
        match self.is_nested(ty) {
            true => format!("{}::{}", self.name("mesh"), self.name(ty)),
            false => self.value(ty),
        }
    }

    /// True if a type is nested in the mesh class.
    pub(in crate::emit) fn is_nested(&self, ty: &str) -> bool {
        ELEMENTS.contains(&ty) && self.is("nested", "yes")
    }

    /// An attribute of the program, to be read or set.
    pub(in crate::emit) fn attribute(&self, of: &str, name: &str) -> String {
        operand(self.name("attribute"), of, name)
    }

    /// A call that allocates.
    pub(in crate::emit) fn allocate(&self, kind: Kind) -> String {
        let name = format!("new_{}", kind.word());
        if self.is_member() { self.name(&name).into() } else { self.chained("mesh", &name) }
    }

    /// A call that erases.
    pub(in crate::emit) fn erase(&self, kind: Kind, of: &str) -> String {
        let name = format!("erase_{}", kind.word());
        match self.is_member() {
            true => fill(self.name(&name), of, "", ""),
            false => self.put("mesh", &name, of),
        }
    }
}

/// A value that any operator may stand before or behind.
fn operand(pattern: &str, of: &str, pointer: &str) -> String {
    let text = fill(pattern, of, pointer, "");
    let mut depth = 0;
    let outside = pattern.replace("->", ".");
    let has_operator = outside.chars().any(|sign| {
        match sign {
            '(' | '[' | '{' => depth += 1,
            ')' | ']' | '}' => depth -= 1,
            _ => {}
        }
        depth == 0 && !(sign.is_alphanumeric() || "_.:)]}".contains(sign))
    });
    if has_operator { format!("({text})") } else { text }
}

/// A pattern with its parts filled in.
fn fill(pattern: &str, of: &str, pointer: &str, value: &str) -> String {
    filled(pattern, |part, _, _| match part {
        "of" => Some(of.to_string()),
        "pointer" => Some(pointer.to_string()),
        "value" => Some(value.to_string()),
        _ => None,
    })
}
