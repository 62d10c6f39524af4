//! The headers that a text needs.

use std::collections::BTreeSet;

/// The headers of the names that follow `std::` in a text.
pub fn headers(text: &str) -> BTreeSet<&'static str> {
    let table = || include_str!("headers.txt").lines().filter_map(|line| line.split_once(": "));
    let header =
        |name: &str| Some(table().find(|(_, words)| words.split(' ').any(|word| word == name))?.0);
    names(text).filter_map(header).collect()
}

/// The names that follow `std::`.
pub fn names(text: &str) -> impl Iterator<Item = &str> {
    let is_letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
    text.split("std::").skip(1).map(move |rest| {
        let end = rest.find(|c| !is_letter(c)).unwrap_or(rest.len());
        &rest[..end]
    })
}
