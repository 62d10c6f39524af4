//! The headers that a text needs.

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
        "abs acos asin atan atan2 ceil cos exp fabs floor fmax fmin ilogb isfinite isnan log \
         nearbyint pow scalbn sin sqrt tan",
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

/// The headers of the names that follow `std::` in a text.
pub fn headers(text: &str) -> BTreeSet<&'static str> {
    let mut found = BTreeSet::new();
    for name in names(text) {
        let of_name = |words: &str| words.split_whitespace().any(|word| word == name);
        let header = HEADERS.iter().find(|(_, words)| of_name(words));
        found.extend(header.map(|(header, _)| *header));
    }
    found
}

/// The names that follow `std::`.
pub fn names(text: &str) -> impl Iterator<Item = &str> {
    let is_letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
    text.split("std::").skip(1).map(move |rest| {
        let end = rest.find(|c| !is_letter(c)).unwrap_or(rest.len());
        &rest[..end]
    })
}
