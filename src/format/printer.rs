//! The printer: takes tokens and comments in order, and lays out the documents made of them.
//!
//! A statement is a document in the sense of Ph. Wadler, "A prettier printer", 2003; it is laid out
//! as soon as it is complete, and becomes part of the next larger one as finished lines.

use crate::source::Span;
use crate::syntax::{Comment, Token, TokenKind};
use pretty::{DocAllocator, DocBuilder, RcAllocator};

/// The maximum length of a line before it is broken, in characters.
pub const WIDTH: usize = 100;

/// The indentation of a block.
pub(super) const INDENT: usize = 2;

/// The indentation of a continuation line.
pub(super) const HANG: isize = 4;

/// A document that can still be laid out in several ways.
pub(super) type Doc = DocBuilder<'static, RcAllocator>;

/// Finished lines, without line breaks and without the indentation of their surroundings.
pub(super) type Lines = Vec<String>;

/// A text that is never broken.
pub(super) fn text(words: impl Into<String>) -> Doc {
    RcAllocator.text(words.into())
}

/// A space or a line break.
pub(super) fn line() -> Doc {
    RcAllocator.line()
}

/// Nothing or a line break.
pub(super) fn soft() -> Doc {
    RcAllocator.line_()
}

/// A line break.
pub(super) fn hard() -> Doc {
    RcAllocator.hardline()
}

/// Nothing.
pub(super) fn nil() -> Doc {
    RcAllocator.nil()
}

/// Documents one after the other, joined in pairs, and the pairs in pairs: dropping a chain of them
/// would nest as many calls.
pub(super) fn joined(mut docs: Vec<Doc>) -> Doc {
    while docs.len() > 1 {
        let mut rest = docs.into_iter();
        let pair = || {
            let first = rest.next()?;
            Some(match rest.next() {
                Some(second) => first.append(second),
                None => first,
            })
        };
        docs = std::iter::from_fn(pair).collect();
    }
    docs.pop().unwrap_or_else(nil)
}

/// The lines of a document at a width.
pub(super) fn laid_out(doc: Doc, width: usize) -> Lines {
    let text = doc.into_doc().pretty(width).to_string();
    text.lines().map(|line| line.trim_end().to_owned()).collect()
}

/// The width of a text, in characters.
pub(super) fn width_of(text: &str) -> usize {
    text.chars().count()
}

/// Takes tokens and comments in order.
pub(super) struct Printer<'t> {
    pub(super) source: &'t str,
    tokens: &'t [Token],
    comments: &'t [Comment],
    /// The next token.
    at: usize,
    /// The next comment.
    comment: usize,
}

impl<'t> Printer<'t> {
    /// A printer at the start of a text.
    pub fn new(source: &'t str, tokens: &'t [Token], comments: &'t [Comment]) -> Self {
        Self { source, tokens, comments, at: 0, comment: 0 }
    }

    /// The kind of the next token.
    pub fn peek(&self) -> Option<TokenKind> {
        self.tokens.get(self.at).map(|token| token.kind)
    }

    /// The start of the next token; after the last, the end of the text.
    pub fn next_start(&self) -> usize {
        self.tokens.get(self.at).map_or(self.source.len(), |token| token.span.start as usize)
    }

    /// The end of the token or comment that was taken last.
    pub fn taken_end(&self) -> usize {
        let token = self.at.checked_sub(1).map(|at| self.tokens[at].span.end);
        let comment = self.comment.checked_sub(1).map(|at| self.comments[at].span.end);
        token.max(comment).unwrap_or(0) as usize
    }

    /// True if a comment is inside of a span, or before it and not taken yet.
    pub fn has_comment(&self, span: Span) -> bool {
        self.comments.get(self.comment).is_some_and(|comment| comment.span.start < span.end)
    }

    /// The number of line breaks between two places of the text.
    pub fn line_ends(&self, from: usize, to: usize) -> usize {
        let between = self.source.get(from..to).unwrap_or("");
        between.matches('\n').count()
    }

    /// True if a span lies on one line.
    pub fn on_one_line(&self, span: Span) -> bool {
        self.line_ends(span.start as usize, span.end as usize) == 0
    }

    /// Takes the next token, after the comments before it, each of which is followed by a line
    /// break.
    pub fn token(&mut self) -> Doc {
        let tight = matches!(
            self.peek(),
            Some(
                TokenKind::LeftParen
                    | TokenKind::RightParen
                    | TokenKind::Comma
                    | TokenKind::Colon
                    | TokenKind::DoubleColon
                    | TokenKind::Dot
            )
        );
        let gap = if tight { "  " } else { "" };
        let comments = self.comments_before_next().into_iter();
        let mut docs: Vec<Doc> =
            comments.map(|comment| text(format!("{gap}{comment}")).append(hard())).collect();
        docs.push(text(self.word()));
        joined(docs)
    }

    /// Takes all tokens up to the end of a span verbatim, after the comments before them.
    pub fn uncut(&mut self, span: Span) -> Doc {
        let comments = self.comments_before_next().into_iter();
        let mut docs: Vec<Doc> = comments.map(|comment| text(comment).append(hard())).collect();
        docs.push(text(self.verbatim(span.start as usize, span.end as usize)));
        joined(docs)
    }

    /// Takes all comments before the next token.
    pub fn comments_before_next(&mut self) -> Lines {
        std::iter::from_fn(|| self.pending_comment()).map(str::to_owned).collect()
    }

    /// Takes the next token, which has no comment before it.
    pub fn word(&mut self) -> &'t str {
        let Some(token) = self.tokens.get(self.at) else { return "" };
        self.at += 1;
        self.source.get(token.span.range()).unwrap_or("")
    }

    /// Takes all tokens up to the end of a span, with nothing between them.
    pub fn words(&mut self, span: Span) -> String {
        let mut words = String::new();
        while let Some(token) = self.tokens.get(self.at)
            && token.span.end <= span.end
        {
            words.push_str(self.word());
        }
        words
    }

    /// Takes all tokens up to the end of a span, with nothing but comments between them.
    pub fn tokens(&mut self, span: Span) -> Doc {
        let mut docs = Vec::new();
        while let Some(token) = self.tokens.get(self.at)
            && token.span.end <= span.end
        {
            docs.push(self.token());
        }
        joined(docs)
    }

    /// Takes everything up to a place verbatim.
    pub fn verbatim(&mut self, from: usize, to: usize) -> &'t str {
        let before = |span: Span| span.end as usize <= to;
        while self.tokens.get(self.at).is_some_and(|t| before(t.span)) {
            self.at += 1;
        }
        while self.comments.get(self.comment).is_some_and(|c| before(c.span)) {
            self.comment += 1;
        }
        self.source.get(from..to).unwrap_or("")
    }

    /// Takes the next comment, if it is before the next token.
    fn pending_comment(&mut self) -> Option<&'t str> {
        let limit = self.next_start();
        let comment = self.comments.get(self.comment)?;
        if comment.span.start as usize >= limit {
            return None;
        }
        self.comment += 1;
        self.source.get(comment.span.range())
    }

    /// Takes the comments after the last token on its line, two spaces before each.
    pub fn comments_of_line(&mut self) -> String {
        let mut taken = String::new();
        while let Some(comment) = self.comments.get(self.comment)
            && (comment.span.start as usize) < self.next_start()
            && self.line_ends(self.taken_end(), comment.span.start as usize) == 0
        {
            let words = self.pending_comment().unwrap_or("");
            taken.push_str("  ");
            taken.push_str(words);
        }
        taken
    }

    /// Takes the comments before the next token, as lines: those on the last line are appended to
    /// it, the others get lines of their own. One blank line is kept, but none at the start.
    pub fn gap(&mut self, lines: &mut Lines) {
        let behind = self.comments_of_line();
        if let Some(last) = lines.last_mut() {
            last.push_str(&behind);
        } else if !behind.is_empty() {
            lines.push(behind.trim_start().to_owned());
        }
        while let Some(comment) = self.comments.get(self.comment)
            && (comment.span.start as usize) < self.next_start()
        {
            self.blank(lines, comment.span.start as usize);
            lines.extend(self.pending_comment().map(str::to_owned));
        }
        self.blank(lines, self.next_start());
    }

    /// Takes the comments before a closing brace: as [`Printer::gap`], but without a blank
    /// line at the end.
    pub fn last_gap(&mut self, lines: &mut Lines) {
        self.gap(lines);
        if lines.last().is_some_and(String::is_empty) {
            lines.pop();
        }
    }

    fn blank(&self, lines: &mut Lines, to: usize) {
        if !lines.is_empty() && self.line_ends(self.taken_end(), to) > 1 {
            lines.push(String::new());
        }
    }
}

/// The content of a block, between two braces.
pub(super) struct Block {
    /// The comments before the opening brace.
    pub above: Lines,
    /// The comments after the opening brace, on its line.
    pub opening: String,
    /// The lines inside.
    pub lines: Lines,
    /// True if the author wrote it on one line, and it can be on one.
    pub short: bool,
}

impl Block {
    /// The block over several lines.
    pub fn long(&self) -> Doc {
        let above = self.above.iter().map(|line| text(line).append(hard()));
        let above = joined(above.collect());
        if self.lines.is_empty() && self.opening.is_empty() {
            return above.append(text("{}"));
        }
        let lines = self.lines.iter().map(|line| hard().append(text(line)));
        let inside = joined(lines.collect()).nest(INDENT as isize);
        above
            .append(text(format!("{{{}", self.opening)))
            .append(inside)
            .append(hard())
            .append(text("}"))
    }

    /// The block on one line; only for a short one.
    pub fn one_line(&self) -> Doc {
        match self.lines.first() {
            Some(line) => text(format!("{{ {line} }}")),
            None => text("{}"),
        }
    }

    /// The block on one line if it is short and everything up to the next line break fits.
    pub fn doc(&self) -> Doc {
        if self.short { self.long().flat_alt(self.one_line()).group() } else { self.long() }
    }
}
