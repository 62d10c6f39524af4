//! Names of types.

use crate::diagnostic::{Diagnostic, quoted};
use crate::diagram::Type;
use crate::syntax::foreign_syntax::type_word;
use crate::syntax::tree::Ident;

use super::foreign_words::{self, Here};
use super::report::Report;

/// The type of this name; reports an unknown one.
pub(super) fn type_named(word: &Ident, report: &mut Report) -> Option<Type> {
    type_among(word, |_| true, report)
}

/// The type of this name; reports an unknown one, with those that `fit`.
pub(super) fn type_among(
    word: &Ident,
    fit: impl Fn(&Type) -> bool,
    report: &mut Report,
) -> Option<Type> {
    let found = Type::named(&word.text);
    if found.is_some() {
        return found;
    }
    if word.text.is_empty() {
        // The type is missing, and the parser has reported it.
        return report.fail_silently();
    }
    let message = format!("there is no type `{}`", word.text);
    let error = Diagnostic::error("unknown-type", message, word.span);
    let known: Vec<&str> = Type::ALL.into_iter().filter(fit).map(Type::word).collect();
    let error = match word.text.to_lowercase().as_str() {
        "list" | "array" | "set" | "map" | "dict" | "queue" | "stack" | "deque" | "heap" => error
            .note(
                "there are no lists: an attribute marks elements, `attr chosen: vertex bool`, and \
                 `drain v in vertices by key(v)` takes them in an order that changes on the way",
            ),
        _ => error,
    };
    let ours = type_word(&word.text).filter(|ours| known.contains(ours)).map(Here::Written);
    let error = foreign_words::tell(error, (&word.text, word.span), ours, known.iter().copied())
        .note(format!("the types are {}", quoted(&known)));
    report.reject(error)
}
