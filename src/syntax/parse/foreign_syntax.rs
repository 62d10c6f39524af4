//! Foreign syntax in the grammar: forms from other languages, and their equivalents here.

use super::failure::{Failure, Mistake, Phrase};
use super::input::{Extra, Rule, Tokens, slice};
use super::report::{Around, begins_line};
use crate::diagnostic::Diagnostic;
use crate::source::Span;
use crate::syntax::token::{Token, TokenKind as T};
use crate::syntax::tree::Ident;
use chumsky::input::InputRef;
use chumsky::prelude::*;

type Input<'t, 'p> = InputRef<'t, 'p, Tokens<'t>, Extra<'t>>;

/// The maximum number of tokens that are searched backwards.
const FARTHEST: usize = 64;

/// The text of the note about a block without braces.
pub(super) const IN_BRACES: &str = "a block stands in braces";

const COMMENT: &str = "a comment begins with `//` and ends with its line";

/// Adds to a diagnostic how something is written here, if the failure is at a form from another
/// language.
pub(super) fn told_here(told: Diagnostic, failure: &Failure, around: &Around) -> Diagnostic {
    let tokens = around.item;
    let at = tokens.partition_point(|token| token.span.start < failure.span.start);
    let (before, rest) = tokens.split_at(at);
    let [here, after @ ..] = rest else { return told };
    let last = before.last().map(|token| token.kind);
    let touches = |one: &Token, other: &Token| one.span.end == other.span.start;
    match here.kind {
        T::Equals if before.last().is_some_and(|last| is_sign(last, here)) => {
            let changed = changed(before, around.text).unwrap_or("x");
            let sign = last.and_then(T::spelling).unwrap_or("+");
            told.note(format!("a change is written out: `{changed} = {changed} {sign} …`"))
        }
        T::Plus | T::Minus if last == Some(here.kind) => {
            told.note("a change is written out: `x = x + 1`")
        }
        T::LeftParen if is_field(before) => told.note(
            "a pointer is read without parentheses, `h.next`; a function stands in front: \
             `degree(v)`",
        ),
        T::LeftParen if last == Some(T::For) => {
            told.note("a loop has no parentheses: `for v in vertices where … { … }`")
        }
        T::Equals
            if in_condition(before)
                && !after.first().is_some_and(|token| token.kind.is_comparison()) =>
        {
            written(told, here.span, "==")
        }
        T::Bar => match after.first().filter(|next| next.kind == T::Bar) {
            Some(next) if touches(here, next) => written(told, here.span.to(next.span), "or"),
            _ => told,
        },
        T::Edge | T::Vertex | T::Face | T::Hole
            if last == Some(T::In) && after.first().is_some_and(|next| next.kind == T::Dot) =>
        {
            let kind = here.kind.spelling().unwrap_or("");
            told.note(format!(
                "`{kind}` is a kind, not an element: what is around one stands behind the name of \
                 a parameter or a variable, as in `for v in vertices {{ for h in v.halfedges {{ … }} }}`"
            ))
        }
        T::Edge if last == Some(T::In) => written(told, here.span, "edges"),
        T::Vertex if last == Some(T::In) => written(told, here.span, "vertices"),
        T::Face if last == Some(T::In) => written(told, here.span, "faces"),
        T::Hole if last == Some(T::In) => written(told, here.span, "holes"),
        T::Slash if after.first().is_some_and(|next| next.kind == T::Star) => told.note(COMMENT),
        T::Star if last == Some(T::Slash) => told.note(COMMENT),
        T::LeftBracket => told.note("there are no lists; a vector is `vec3(x, y, z)`"),
        T::Comma => match before_bare_parentheses(before) {
            Some(T::Print) => told.note("what is printed stands without parentheses"),
            Some(T::Assert) => told.note("it is written `assert c else \"…\"`"),
            Some(_) => told.note("a vector is `vec3(x, y, z)`"),
            None => told,
        },
        T::If if failure.wanted.has(T::Where) && !begins_line(around.text, here.span) => {
            written(told, here.span, "where")
        }
        T::For if failure.wanted.has(T::Where) => told.note(
            "an aggregate goes over one sequence, and its value may be another aggregate: \
             `max(max(length(e) for e in f.edges) for f in faces)`",
        ),
        T::DotDot => told.note("a range stands in the head of a loop: `for i in 0..n { … }`"),
        T::Require | T::Guard if failure.wanted.has(T::LeftBrace) => {
            told.note("a condition stands in the braces of the op, between `before` and `after`")
        }
        T::Colon if failure.wanted.has(T::LeftBrace) => told.note(IN_BRACES),
        _ if failure.wanted.has(T::LeftBrace) && failure.wanted.phrases().next().is_none() => {
            told.note(format!("{IN_BRACES}: `{{ … }}`"))
        }
        _ if failure.wanted.has(T::Else) && is_value_of_if(before) => {
            told.note("an `if` that is a value says what it is otherwise: `if c { x } else { y }`")
        }
        T::Arrow if failure.wanted.phrases().any(|phrase| phrase == Phrase::Arrow) => {
            told.note("an arrow has the name of its halfedge: `v0 -a-> v1`")
        }
        T::Word
            if failure.wanted.phrases().any(|phrase| phrase == Phrase::DrawingStatement)
                && after.first().is_some_and(|next| begins_arrow(next.kind)) =>
        {
            told.note("a loop begins with its kind and its name: `face f: v0 -a-> …`")
        }
        T::Word => match around.text.get(here.span.range()) {
            Some("then" | "do") if failure.wanted.has(T::LeftBrace) => told.note(IN_BRACES),
            Some("of") if failure.wanted.has(T::In) => written(told, here.span, "in"),
            Some(word) if begins_item(failure) => match item_word(word) {
                Some(ours) => written(told, here.span, ours),
                None => told,
            },
            _ => told,
        },
        _ => told,
    }
}

/// True if an arrow of a loop begins with this token.
fn begins_arrow(kind: T) -> bool {
    matches!(kind, T::Minus | T::Equals | T::FatArrow)
}

/// `elif` followed by the beginning of a condition: a mistake that is parsed as `else if`.
pub(super) fn else_if<'t>() -> Rule<'t, ()> {
    let contracted = |word: &str| matches!(word, "elif" | "elsif" | "elseif");
    let goes_on = |kind: T| !matches!(kind, T::Equals | T::Dot | T::RightBrace);
    ahead(move |input, kind, text| {
        kind == T::Word && contracted(text) && input.peek().is_some_and(goes_on)
    })
    .ignore_then(any())
    .validate(|_, scene, emitter| emitter.emit(Failure::mistake(Mistake::ElseIf, scene.span())))
    .boxed()
}

/// True if other languages use the word for a null value.
pub(super) fn is_nothing(word: &str) -> bool {
    matches!(word, "null" | "nullptr" | "None" | "nil" | "NULL" | "Null")
}

/// A missing type of a parameter: a mistake, and a type with an empty name.
pub(super) fn no_type<'t>() -> Rule<'t, Ident> {
    let ends = |kind: T| matches!(kind, T::Comma | T::RightParen | T::Equals);
    ahead(move |_, kind, _| ends(kind))
        .map_with(|(), scene| Ident { text: String::new(), span: scene.span() })
        .boxed()
}

/// `std::polygon` or `std/polygon` in place of a text: a mistake, and the path that is meant.
pub(super) fn bare_path<'t>() -> Rule<'t, (String, Span)> {
    let word = select! { kind if T::is_wordlike(kind) => () };
    let between = choice((just(T::DoubleColon), just(T::Slash), just(T::Dot)));
    word.separated_by(between)
        .at_least(1)
        .validate(|(), scene, emitter| {
            let span = scene.span();
            emitter.emit(Failure::mistake(Mistake::BarePath, span));
            (path_meant(slice(scene)), span)
        })
        .boxed()
}

/// The path that `std::polygon` means.
pub(super) fn path_meant(written: &str) -> String {
    let path = written.trim_end_matches(".hedge");
    format!("{}.hedge", path.replace("::", "/").replace('.', "/"))
}

/// Consumes nothing, and fails unless `is_one` accepts the kind and the text of the next token; it
/// may also look at the input after that token.
fn ahead<'t>(is_one: impl Fn(&mut Input<'t, '_>, T, &str) -> bool + 't) -> Rule<'t, ()> {
    custom(move |input: &mut Input<'t, '_>| {
        let start = input.save();
        let kind = input.next();
        let span = input.span_since(start.cursor());
        let text = input.state().0.get(span.range()).unwrap_or("");
        let found = kind.is_some_and(|kind| is_one(input, kind, text));
        input.rewind(start);
        if found { Ok(()) } else { Err(Failure::at(span)) }
    })
    .boxed()
}

fn written(told: Diagnostic, span: Span, word: &str) -> Diagnostic {
    told.saying(format!("here it is written `{word}`")).fix(format!("write `{word}`"), span, word)
}

/// True if a token and the equals sign after it form one sign, as in `+=`.
fn is_sign(token: &Token, equals: &Token) -> bool {
    let signs = [T::Plus, T::Minus, T::Star, T::Slash];
    signs.contains(&token.kind) && token.span.end == equals.span.start
}

/// True if the token after these belongs to a condition.
fn in_condition(before: &[Token]) -> bool {
    let near = before.iter().rev().take(FARTHEST).map(|token| token.kind);
    let mut words = near.skip_while(|kind| {
        let is_word = kind.is_keyword() && !matches!(kind, T::And | T::Or | T::Not);
        let is_end = matches!(kind, T::LeftBrace | T::RightBrace | T::Equals);
        !is_word && !is_end
    });
    matches!(words.next(), Some(T::If | T::While | T::Where | T::Assert | T::Require))
}

/// The left operand of a sign like `+=`: the text before it on its line.
fn changed<'t>(before: &[Token], text: &'t str) -> Option<&'t str> {
    let until = before.last()?.span.start as usize;
    let line = text.get(..until)?.rsplit(['\n', '{']).next()?.trim();
    (!line.is_empty() && !line.contains(char::is_whitespace)).then_some(line)
}

/// True if the last of these tokens is a word after a dot.
fn is_field(before: &[Token]) -> bool {
    matches!(before, [.., dot, word] if dot.kind == T::Dot && word.kind.is_wordlike())
}

/// True if these tokens end with the block of an `if`.
fn is_value_of_if(before: &[Token]) -> bool {
    let mut near = before.iter().rev().take(FARTHEST);
    near.next().is_some_and(|last| last.kind == T::RightBrace)
        && near.any(|token| token.kind == T::If)
}

/// True if an item was expected.
fn begins_item(failure: &Failure) -> bool {
    failure.wanted.phrases().any(|phrase| phrase == Phrase::Item)
}

/// The keyword of this language for a foreign word that begins an item.
pub(super) fn item_word(word: &str) -> Option<&'static str> {
    Some(match word {
        "def" | "function" | "func" | "fun" | "define" => "fn",
        "import" | "include" | "from" | "open" => "use",
        "operation" | "operator" | "rewrite" => "op",
        "attribute" | "property" => "attr",
        "main" | "program" | "algorithm" => "script",
        _ => return None,
    })
}

/// The token before the open parenthesis around the next token, if it is not the parenthesis of a
/// call.
fn before_bare_parentheses(before: &[Token]) -> Option<T> {
    let mut closed = 0;
    for (at, token) in before.iter().enumerate().rev().take(FARTHEST) {
        match token.kind {
            T::RightParen => closed += 1,
            T::LeftParen if closed > 0 => closed -= 1,
            T::LeftParen => {
                let called = at.checked_sub(1).map(|last| before[last].kind);
                return called.filter(|kind| !kind.is_name() && *kind != T::Hole);
            }
            T::LeftBrace | T::RightBrace => return None,
            _ => {}
        }
    }
    None
}
