//! Words that formatting keeps: tokens and comments in their order, and whatever is neither.

use crate::source::{FileId, Span};
use crate::syntax::{Comment, CommentKind, Lexed, Parsed, Token, TokenKind};

/// The words of a text.
#[derive(Clone, Copy, Debug)]
pub(super) struct Words<'t> {
    source: &'t str,
    tokens: &'t [Token],
    comments: &'t [Comment],
}

/// A token or a comment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Word<'t> {
    Token(TokenKind, &'t str),
    Comment(CommentKind, &'t str),
}

impl<'t> Words<'t> {
    /// The words of a parsed text.
    pub(super) fn of(source: &'t str, parsed: &'t Parsed) -> Self {
        Self { source, tokens: &parsed.tokens, comments: &parsed.comments }
    }

    /// The words of a text that has only been lexed.
    pub(super) fn lexed(source: &'t str, lexed: &'t Lexed) -> Self {
        Self { source, tokens: &lexed.tokens, comments: &lexed.comments }
    }

    /// The end of the text.
    pub(super) fn end(self) -> usize {
        self.source.len()
    }

    /// All tokens and comments, in order.
    pub(super) fn all(self) -> impl Iterator<Item = (Span, Word<'t>)> {
        let said = move |span: Span| self.source.get(span.range()).unwrap_or("");
        self.spans().map(move |(span, what)| {
            let word = match what {
                // A foreign comment may span several lines, whose line breaks may change.
                Ok(kind @ TokenKind::Foreign) => {
                    Word::Token(kind, said(span).lines().next().unwrap_or("").trim_end())
                }
                Ok(kind) => Word::Token(kind, said(span)),
                Err(kind) => Word::Comment(kind, said(span)),
            };
            (span, word)
        })
    }

    /// The places of all tokens and comments, in order.
    pub(super) fn places(self) -> impl Iterator<Item = Span> {
        self.spans().map(|(span, _)| span)
    }

    fn spans(self) -> impl Iterator<Item = (Span, Result<TokenKind, CommentKind>)> {
        let mut tokens = self.tokens.iter().peekable();
        let mut comments = self.comments.iter().peekable();
        std::iter::from_fn(move || {
            let is_comment = match (tokens.peek(), comments.peek()) {
                (Some(token), Some(comment)) => comment.span.start < token.span.start,
                (token, _) => token.is_none(),
            };
            if is_comment {
                comments.next().map(|comment| (comment.span, Err(comment.kind)))
            } else {
                tokens.next().map(|token| (token.span, Ok(token.kind)))
            }
        })
    }

    /// The characters that belong to no token, no comment and no white space, and their places.
    pub(super) fn leftovers(self) -> impl Iterator<Item = (usize, char)> {
        let source = self.source;
        let mut at = 0;
        let end = Span::new(FileId(0), source.len(), source.len());
        let gaps = self.places().chain([end]).map(move |span| {
            let from = std::mem::replace(&mut at, span.end as usize);
            (from, source.get(from..span.start as usize).unwrap_or(""))
        });
        let is_space = |c: char| c.is_ascii_whitespace() || c == '\u{FEFF}';
        gaps.flat_map(move |(from, gap)| {
            gap.char_indices()
                .filter(move |&(_, c)| !is_space(c))
                .map(move |(at, c)| (from + at, c))
        })
    }
}
