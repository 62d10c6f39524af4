//! Enumerations in messages.

/// Words as an enumeration: "x, y and z".
pub fn all_of<S: AsRef<str>>(words: impl IntoIterator<Item = S>) -> String {
    joined(words, "and")
}

/// Words as alternatives: "x, y or z".
pub fn one_of<S: AsRef<str>>(words: impl IntoIterator<Item = S>) -> String {
    joined(words, "or")
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
