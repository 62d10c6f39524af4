//! The properties that an op claims to keep.

use crate::diagnostic::{Diagnostic, quoted};
use crate::diagram::Property;
use crate::source::Span;
use crate::syntax::tree::Ident;

use super::report::Report;
use super::suggestion::suggest;

/// The properties that `keeps` claims; `map` is what the checker always proves.
pub(super) fn properties(keeps: &[Ident], report: &mut Report) -> Vec<(Property, Span)> {
    let mut properties = Vec::new();
    for word in keeps {
        let known = |property: &Property| property.word() == word.text;
        match Property::ALL.into_iter().find(known) {
            Some(property) => properties.push((property, word.span)),
            None if word.text == "map" => {}
            None => {
                let message = format!("there is no property `{}` to keep", word.text);
                let error = Diagnostic::error("unknown-property", message, word.span);
                let words = Property::ALL.map(Property::word);
                let words = [&words[..], &["map"]].concat();
                let error = suggest(error, &word.text, word.span, words.iter().copied())
                    .note(format!("the properties are {}", quoted(&words)));
                report.add(error);
            }
        }
    }
    properties
}
