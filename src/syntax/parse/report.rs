//! From failures of the grammar to diagnostics: the one place with the words.

use super::failure::{Failure, Mistake, Phrase};
use crate::diagnostic::Diagnostic;
use crate::source::Span;
use crate::syntax::token::{Token, TokenKind as T};

/// What surrounds a failure.
pub(super) struct Around<'t> {
    /// The text of the file.
    pub text: &'t str,
    /// The tokens of the item.
    pub item: &'t [Token],
    /// The token behind the item, if any.
    pub next: Option<Token>,
    /// The last brace of the item that nothing closes.
    pub unclosed: Option<Token>,
}

/// Tells a failure in words.
pub(super) fn report(failure: Failure, around: &Around) -> Diagnostic {
    match failure.mistake {
        Some(mistake) => mistaken(mistake, failure.span),
        None => unexpected(failure, around),
    }
}

fn mistaken(mistake: Mistake, span: Span) -> Diagnostic {
    match mistake {
        Mistake::ChainedComparison => {
            let message = "comparisons cannot be chained";
            let both = "write `a < b and b < c`";
            Diagnostic::error("chained-comparison", message, span).note(both)
        }
        Mistake::TwiceDrawn(first) => {
            let message = "this side of the rule is already drawn";
            let found = Diagnostic::error("drawn-twice", message, span);
            found
                .label(first, "drawn here first")
                .note("alternatives are written `rule name { … }`")
        }
        Mistake::Misplaced(place) => Diagnostic::error("misplaced-part", place, span),
        Mistake::CalledFamily => {
            let message = "what is called has no subscript";
            Diagnostic::error("syntax-error", message, span)
        }
        Mistake::RuleAmongParts => {
            let message = "an op has either rules or drawings of its own";
            let found = Diagnostic::error("misplaced-part", message, span);
            found.note("move these drawings into a `rule name { … }`")
        }
    }
}

fn unexpected(failure: Failure, around: &Around) -> Diagnostic {
    let found = match failure.found {
        Some(_) => shown(failure.span, around.text),
        None => end_of(around),
    };
    let wanted = listed(&wanted(&failure));
    let place = failure.context.and_then(|context| place(context, around));
    let mut message = if wanted.is_empty() {
        format!("unexpected {found}")
    } else {
        format!("expected {wanted}, found {found}")
    };
    if let Some(place) = place {
        message = format!("{message} {place}");
    }
    let told = Diagnostic::error("syntax-error", message, failure.span);
    match around.unclosed {
        Some(open) if failure.wanted.has(T::RightBrace) => {
            let mark = open.kind;
            told.label(open.span, format!("this {mark} is not closed"))
        }
        _ => told,
    }
}

/// A token as it is written, cut where it is long.
fn shown(span: Span, text: &str) -> String {
    const LONGEST: usize = 24;
    let written = text.get(span.range()).unwrap_or("");
    if written.chars().count() <= LONGEST {
        format!("`{written}`")
    } else {
        let start: String = written.chars().take(LONGEST).collect();
        format!("`{start}…`")
    }
}

fn end_of(around: &Around) -> String {
    match around.next {
        Some(next) => shown(next.span, around.text),
        None => "the end of the file".to_owned(),
    }
}

/// What was wanted, in words; how a name or a value could go on only if nothing else was.
fn wanted(failure: &Failure) -> Vec<String> {
    let all = failure.wanted;
    let weak = |phrase: &Phrase| matches!(phrase, Phrase::Operator | Phrase::Subscript);
    let strong = all.phrases().filter(|phrase| !weak(phrase));
    let mut words: Vec<String> = strong.map(|phrase| phrase.words().to_owned()).collect();
    words.extend(all.tokens().map(|kind| kind.to_string()));
    if words.is_empty() {
        words.extend(all.phrases().map(|phrase| phrase.words().to_owned()));
    }
    words
}

fn listed(words: &[String]) -> String {
    match words {
        [] => String::new(),
        [only] => only.clone(),
        [first @ .., last] => format!("{} or {last}", first.join(", ")),
    }
}

/// `in the face statement `f0``, from the tokens at the start of what could not be read.
fn place(context: Span, around: &Around) -> Option<String> {
    let tokens = around.item;
    let at = tokens.partition_point(|token| token.span.start < context.start);
    let (first, rest) = tokens.get(at..)?.split_first()?;
    let keyword = first.kind.spelling().filter(|_| first.kind.is_keyword())?;
    let name = rest.first().filter(|token| token.kind.is_name());
    let name = name.map(|name| shown(name.span, around.text));
    let sort = match first.kind {
        T::Face | T::Hole | T::Loop | T::Edge | T::Vertex => " statement",
        T::Op | T::Script | T::Fn | T::Attr => "",
        T::Before | T::After => return Some(format!("in `{keyword}`")),
        _ => return Some(format!("in the `{keyword}` statement")),
    };
    Some(match name {
        Some(name) => format!("in the {keyword}{sort} {name}"),
        None => format!("in the {keyword}{sort}"),
    })
}

/// The last brace of an item that nothing closes.
pub(super) fn unclosed(tokens: &[Token]) -> Option<Token> {
    let mut open: Vec<Token> = Vec::new();
    for &token in tokens {
        match token.kind {
            T::LeftBrace => open.push(token),
            T::RightBrace => {
                open.pop();
            }
            _ => {}
        }
    }
    open.pop()
}
