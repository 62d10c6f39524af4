//! Words that cannot be names in emitted code.
//!
//! Names are the same in C++ and Rust, so words that either language reserves are avoided in both.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use super::print::support;
use super::value::rows;

/// The words of a row of `reserved.txt`, or of all rows without its name.
fn words(group: Option<&str>) -> impl Iterator<Item = &'static str> {
    let all = rows(include_str!("reserved.txt")).into_iter();
    let all = all.filter(move |row| group.is_none_or(|group| row[0] == group));
    all.flat_map(|row| row[1..].to_vec()).flat_map(str::split_whitespace)
}

static RESERVED: LazyLock<BTreeSet<&str>> =
    LazyLock::new(|| words(None).chain(support::RUST.names()).collect());

/// True if a word is reserved by a language, a macro, or emitted code itself.
pub(super) fn is_reserved(word: &str) -> bool {
    RESERVED.contains(word) || is_like_a_macro(word)
}

/// True if a word is a keyword of C++.
pub(super) fn is_keyword_of_cpp(word: &str) -> bool {
    words(Some("CPP")).any(|known| known == word)
}

/// True if a word looks like a macro: all capitals, at least two of them.
fn is_like_a_macro(word: &str) -> bool {
    let capitals = word.chars().filter(char::is_ascii_uppercase).count();
    capitals > 1 && !word.contains(|c: char| c.is_lowercase()) && !word.ends_with('_')
}

/// A word that is not reserved, as close as possible to the one that is wanted; `reserved` are the
/// words that the mesh class reserves.
pub fn unreserved(word: &str, reserved: &[String]) -> String {
    match is_reserved(word) || reserved.iter().any(|known| known == word) {
        true => format!("{word}_"),
        false => word.to_owned(),
    }
}

/// A name of the program as one word, without primes, spaces (of a result without a name), and the
/// underscores that are reserved for compilers.
pub fn plain(name: &str) -> String {
    let primes = name.chars().rev().take_while(|c| *c == '\'').count();
    let stem = name.trim_end_matches('\'').replace(['\'', ' '], "_");
    let mut word = match primes {
        0 => stem,
        1 => format!("{stem}_"),
        _ => format!("{stem}_{primes}"),
    };
    // In C++, double underscores and a leading one are reserved for the compiler.
    while word.contains("__") {
        word = word.replace("__", "_");
    }
    if word.starts_with('_') { format!("x{word}") } else { word }
}
