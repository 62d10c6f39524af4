//! Input of the grammar: the tokens of one item, and the source text.

use super::failure::Failure;
use crate::source::{FileId, Span};
use crate::syntax::token::{Token, TokenKind};
use chumsky::inspector::SimpleState;
use chumsky::prelude::*;
use chumsky::span::Span as Place;
use std::ops::Range;

type Split<'t> = fn(&'t Token) -> (&'t TokenKind, &'t Span);

/// The tokens of one item.
pub(super) type Tokens<'t> =
    chumsky::input::MappedInput<'t, TokenKind, Span, &'t [Token], Split<'t>>;

/// The source text, from which the text of names and numbers is read.
pub(super) type Source<'t> = SimpleState<&'t str>;

/// The failures and the state of the grammar.
pub(super) type Extra<'t> = extra::Full<Failure, Source<'t>, ()>;

/// A rule of the grammar.
pub(super) type Rule<'t, O> = Boxed<'t, 't, Tokens<'t>, O, Extra<'t>>;

/// The context of a rule that builds a part of the tree: the span, the source text, the failures.
pub(super) type Scene<'t, 'b> = chumsky::input::MapExtra<'t, 'b, Tokens<'t>, Extra<'t>>;

/// The input of the grammar for some tokens; `end` is the span after them.
pub(super) fn tokens(tokens: &[Token], end: Span) -> Tokens<'_> {
    let split: Split = |token| (&token.kind, &token.span);
    tokens.map(end, split)
}

/// The text of what a rule has just read.
pub(super) fn slice<'t>(scene: &mut Scene<'t, '_>) -> &'t str {
    let span = scene.span();
    scene.state().0.get(span.range()).unwrap_or("")
}

impl Place for Span {
    type Context = FileId;
    type Offset = u32;

    /// A rule that reads nothing begins at the next token and ends at the previous one; such a span
    /// is made empty, never inverted.
    fn new(file: FileId, range: Range<u32>) -> Self {
        let (start, end) = (range.start, range.end.max(range.start));
        Span { file, start, end }
    }

    fn context(&self) -> FileId {
        self.file
    }

    fn start(&self) -> u32 {
        self.start
    }

    fn end(&self) -> u32 {
        self.end
    }
}
