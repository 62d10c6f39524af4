//! Which headers a text needs.

use std::collections::BTreeSet;

/// The headers, each with what emitted code takes from it.
const HEADERS: &[(&str, &str)] = &[
    (
        "algorithm",
        "all_of any_of count_if find is_permutation max max_element min min_element none_of \
         reverse rotate sort",
    ),
    ("array", "array"),
    (
        "cmath",
        "abs acos asin atan atan2 ceil cos exp fabs floor fmax fmin isfinite isnan log nearbyint \
         pow sin sqrt tan",
    ),
    ("cstddef", "ptrdiff_t size_t"),
    ("cstdlib", "llabs"),
    ("functional", "function hash"),
    ("limits", "numeric_limits"),
    ("optional", "nullopt optional"),
    ("stdexcept", "domain_error"),
    ("tuple", "get tuple"),
    (
        "type_traits",
        "common_type_t decay_t enable_if_t is_arithmetic_v is_constructible_v is_same_v",
    ),
    ("utility", "forward move pair swap"),
    ("vector", "vector"),
];

/// The headers of what stands in a text behind `std::`.
pub(super) fn headers(text: &str) -> BTreeSet<&'static str> {
    let mut found = BTreeSet::new();
    for name in names(text) {
        let of_name = |words: &str| words.split_whitespace().any(|word| word == name);
        let header = HEADERS.iter().find(|(_, words)| of_name(words));
        found.extend(header.map(|(header, _)| *header));
    }
    found
}

/// What stands behind `std::`.
fn names(text: &str) -> impl Iterator<Item = &str> {
    let is_letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
    text.split("std::").skip(1).map(move |rest| {
        let end = rest.find(|c| !is_letter(c)).unwrap_or(rest.len());
        &rest[..end]
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn everything_that_is_written_out_has_its_header() {
        let text = [
            include_str!("functions.txt"),
            include_str!("values.txt"),
            include_str!("sheet.txt"),
            include_str!("journal.txt"),
            include_str!("spelling.rs"),
            include_str!("statement.rs"),
            include_str!("steps.rs"),
            include_str!("wide.rs"),
        ];
        let text = text.concat().replace("use std::collections", "");
        for name in names(&text) {
            let known = headers(&format!("std::{name}"));
            assert!(known.len() == 1 || ["mem", ""].contains(&name), "std::{name}");
        }
        assert!(headers("std::all_of(x)").contains("algorithm"));
    }
}
