//! The words of the language, each explained in a sentence.

use std::sync::LazyLock;

use crate::resolve::{function_words, signatures};

/// A word of the language.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Word {
    /// The ways to write it: `degree(vertex) -> int`, a line for each way.
    pub forms: Vec<String>,
    pub meaning: &'static str,
}

/// The meaning of each keyword, kind, property, pointer, aggregate and function, a line each.
pub static MEANINGS: LazyLock<Vec<(&str, &str)>> = LazyLock::new(|| {
    include_str!("words.txt").lines().filter_map(|line| line.split_once(": ")).collect()
});

/// The functions of the language, in the order in which they are explained.
pub fn functions() -> Vec<&'static str> {
    function_words().collect()
}

/// The explanation of a word of the language.
pub fn word(text: &str) -> Option<Word> {
    let forms = forms(text);
    let meaning = meaning(text);
    if meaning.is_none() && forms.is_empty() {
        return None;
    }
    Some(Word { forms, meaning: meaning.unwrap_or("") })
}

/// The meaning of a word, in a sentence.
pub fn meaning(text: &str) -> Option<&'static str> {
    MEANINGS.iter().find(|(word, _)| *word == text).map(|(_, meaning)| *meaning)
}

/// The ways to call a function of the language.
fn forms(text: &str) -> Vec<String> {
    let ways = signatures(text).into_iter().map(|way| {
        let takes = way.takes.join(", ");
        match way.gives {
            Some(ty) => format!("{text}({takes}) -> {}", ty.word()),
            None => format!("{text}({takes})"),
        }
    });
    ways.collect()
}
