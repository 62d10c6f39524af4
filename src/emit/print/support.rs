//! Support functions: what emitted code calls and no library has, emitted where it is used.

use std::sync::LazyLock;

/// The support functions of a language, each with its name, after those that it calls.
///
/// In the files, the text of each follows a line with its name. The name of a template whose first
/// parameter is a size ends with `.n`: `dot.n` is called as `dot<4>(…)`.
pub(in crate::emit) struct Support(Vec<(&'static str, &'static str)>);

/// Those in C++.
pub(in crate::emit) static CPP: LazyLock<Support> = LazyLock::new(|| {
    Support::of(concat!(
        include_str!("../cpp/functions.txt"),
        include_str!("../cpp/values.txt"),
        include_str!("../cpp/preview.txt"),
        include_str!("../cpp/journal.txt")
    ))
});

/// Those in Rust.
pub(in crate::emit) static RUST: LazyLock<Support> = LazyLock::new(|| {
    Support::of(concat!(
        include_str!("../rust/functions.txt"),
        include_str!("../rust/values.txt"),
        include_str!("../rust/preview.txt")
    ))
});

impl Support {
    fn of(texts: &'static str) -> Self {
        let parts = texts.split("//@ ").skip(1);
        Self(parts.filter_map(|part| part.split_once('\n')).collect())
    }

    /// All functions, each with its name.
    pub fn all(&self) -> impl Iterator<Item = (&'static str, &'static str)> {
        self.0.iter().copied()
    }

    /// The names of all functions.
    pub fn names(&self) -> impl Iterator<Item = &'static str> {
        self.all().map(|(name, _)| name)
    }

    /// The functions that a text uses, and those that these call, with their texts. Names in the
    /// text are qualified with a namespace, except for those of classes.
    pub fn needed(&self, text: &str, namespace: &str) -> Vec<(&'static str, &'static str)> {
        let code = code(text);
        let is_used = |name: &str| match name.starts_with(char::is_uppercase) {
            true => names(&code, name),
            false => {
                let is_called =
                    |name: &str| !calls(&code, &format!("{namespace}{name}")).is_empty();
                // Another template can be called with its arguments, too.
                let other = format!("{name}.n");
                is_called(name) || is_called(&other) && self.names().all(|known| known != other)
            }
        };
        let mut needed: Vec<(&str, &str)> = Vec::new();
        for &(name, text) in self.0.iter().rev() {
            let mut texts = needed.iter().map(|(_, text)| *text);
            if is_used(name) || texts.any(|text| !calls(text, name).is_empty()) {
                needed.push((name, text));
            }
        }
        needed.reverse();
        needed
    }
}

/// A text without its comments.
pub(in crate::emit) fn code(text: &str) -> String {
    let lines: Vec<_> = text.lines().filter_map(|line| line.split("//").next()).collect();
    lines.join("\n")
}

/// The places where a text calls a function: its name as a whole word, followed by a bracket, and
/// not as an accessor of something.
pub(in crate::emit) fn calls(text: &str, name: &str) -> Vec<usize> {
    let (word, signs): (_, &[&str]) = match name.strip_suffix(".n") {
        Some(word) => (word, &["<"]),
        None => (name, &["(", "::<"]),
    };
    let is_part = |c: char| c.is_ascii_alphanumeric() || "_:.>".contains(c);
    let places = text.match_indices(word).map(|(at, _)| at);
    let is_call = |&at: &usize| {
        let behind = &text[at + word.len()..];
        signs.iter().any(|sign| behind.starts_with(sign)) && !text[..at].ends_with(is_part)
    };
    places.filter(is_call).collect()
}

/// True if a text contains a word.
pub(in crate::emit) fn names(text: &str, word: &str) -> bool {
    text.split(|c: char| !c.is_ascii_alphanumeric() && c != '_').any(|part| part == word)
}
