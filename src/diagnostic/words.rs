//! Enumerations in messages.

/// Words as an enumeration: "x, y and z".
pub fn all_of<S: AsRef<str>>(words: impl IntoIterator<Item = S>) -> String {
    joined(words, "and")
}

/// The most words of a long enumeration that are told.
const MOST: usize = 6;

/// Words as an enumeration; of many, only the first: "u, v, w and 14 more".
pub fn some_of<S: AsRef<str>>(words: impl IntoIterator<Item = S>) -> String {
    let words: Vec<S> = words.into_iter().collect();
    // One more would take as much room as its name.
    if words.len() <= MOST + 1 {
        return all_of(words);
    }
    let rest = format!("{} more", words.len() - MOST);
    let first = words.iter().take(MOST).map(AsRef::as_ref);
    all_of(first.chain([rest.as_str()]))
}

/// Words as alternatives: "x, y or z".
pub fn one_of<S: AsRef<str>>(words: impl IntoIterator<Item = S>) -> String {
    joined(words, "or")
}

/// Names in backticks: "`x`, `y`".
pub fn quoted(names: impl IntoIterator<Item = impl std::fmt::Display>) -> String {
    let names: Vec<_> = names.into_iter().map(|name| format!("`{name}`")).collect();
    names.join(", ")
}

/// A number with its noun: "1 case", "2 cases".
pub fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

fn joined<S: AsRef<str>>(words: impl IntoIterator<Item = S>, conjunction: &str) -> String {
    let words: Vec<S> = words.into_iter().collect();
    let words: Vec<&str> = words.iter().map(AsRef::as_ref).collect();
    match words.as_slice() {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [most @ .., last] => format!("{} {conjunction} {last}", most.join(", ")),
    }
}
