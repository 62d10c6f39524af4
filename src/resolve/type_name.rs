//! Names of types.

use crate::diagnostic::Diagnostic;
use crate::diagram::Type;
use crate::syntax::foreign_syntax::type_word;
use crate::syntax::tree::Ident;

use super::foreign_words::{self, Here};
use super::report::Report;
use super::words::quoted;

/// The type of this name; reports an unknown one.
pub(super) fn type_named(word: &Ident, report: &mut Report) -> Option<Type> {
    let found = Type::ALL.into_iter().find(|ty| ty.word() == word.text);
    if found.is_some() {
        return found;
    }
    if word.text.is_empty() {
        // The type is missing, and the parser has reported it.
        report.fail();
        return None;
    }
    let message = format!("there is no type `{}`", word.text);
    let error = Diagnostic::error("unknown-type", message, word.span);
    let known = Type::ALL.map(Type::word);
    let ours = type_word(&word.text).map(Here::Written);
    let error = foreign_words::tell(error, (&word.text, word.span), ours, known)
        .note(format!("the types are {}", quoted(&known)));
    report.add(error);
    None
}
