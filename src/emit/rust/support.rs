//! Support functions of emitted code besides those of the mesh, emitted where they are used.

use std::collections::BTreeSet;

/// The text of each function follows a line with its name.
const TEXTS: &str =
    concat!(include_str!("functions.txt"), include_str!("values.txt"), include_str!("preview.txt"));

/// The names and texts of all functions, in order.
fn functions() -> impl Iterator<Item = (&'static str, &'static str)> {
    let parts = TEXTS.split("//@ ").skip(1);
    parts.filter_map(|part| part.split_once('\n'))
}

/// The names of all functions.
pub(in crate::emit) fn written_out() -> impl Iterator<Item = &'static str> {
    functions().map(|(name, _)| name)
}

/// The functions of these names, and those that they call, in order.
pub(super) fn needed(mut used: BTreeSet<&'static str>) -> Vec<(&'static str, &'static str)> {
    loop {
        let count = used.len();
        for (name, text) in functions() {
            if used.contains(name) {
                used.extend(functions().map(|(other, _)| other).filter(|other| calls(text, other)));
            }
        }
        if used.len() == count {
            return functions().filter(|(name, _)| used.contains(name)).collect();
        }
    }
}

/// True if a text calls a function.
pub(super) fn calls(text: &str, name: &str) -> bool {
    text.match_indices(&format!("{name}(")).any(|(at, _)| {
        let before = text[..at].chars().next_back();
        !before.is_some_and(|c| c.is_ascii_alphanumeric() || c == '_' || c == ':' || c == '.')
    })
}
