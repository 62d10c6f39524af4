//! Lexing: from text to tokens, with the comments kept separately.
//!
//! Characters that belong to no token are reported and dropped, so that the parser never sees them.
//! A malformed number or text is reported and kept.

use super::text::{holes, read_text};
use super::token::{Token, TokenKind};
use crate::diagnostic::Diagnostic;
use crate::source::{FileId, Span};
use logos::Logos;
use std::ops::Range;

/// The maximum number of runs of unknown characters that are reported individually.
const MOST_UNKNOWN: usize = 16;

/// The purpose of a comment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CommentKind {
    /// `// …`
    Plain,
    /// `/// …`, on the item that follows.
    Doc,
    /// `//! …`, on the file.
    FileDoc,
}

/// A comment and its place, without the line end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Comment {
    /// Its purpose.
    pub kind: CommentKind,
    /// Its place in the source, slashes included.
    pub span: Span,
}

impl Comment {
    /// Its text, without the slashes, the first space and trailing white space.
    pub fn text(self, source: &str) -> &str {
        let whole = source.get(self.span.range()).unwrap_or("");
        let marks = match self.kind {
            CommentKind::Plain => 2,
            CommentKind::Doc | CommentKind::FileDoc => 3,
        };
        let said = whole.get(marks..).unwrap_or("").trim_end();
        said.strip_prefix(' ').unwrap_or(said)
    }
}

/// The tokens and comments of a text.
#[derive(Clone, Debug)]
pub struct Lexed {
    /// Every token, in order.
    pub tokens: Vec<Token>,
    /// Every comment, in order.
    pub comments: Vec<Comment>,
    /// The errors: characters that belong to no token, and malformed tokens.
    pub diagnostics: Vec<Diagnostic>,
    /// The places of all errors, in order. Of very many unknown characters, not all have a
    /// diagnostic.
    pub wrong: Vec<Span>,
    /// The ends of texts that a quote within a value cuts off: what follows in the item is no code.
    pub cut_off: Vec<Span>,
}

/// Reads all tokens and comments of a text.
pub fn lex(file: FileId, text: &str) -> Lexed {
    let mut lexed = Lexed {
        tokens: Vec::with_capacity(text.len() / 4),
        comments: Vec::new(),
        diagnostics: Vec::new(),
        wrong: Vec::new(),
        cut_off: Vec::new(),
    };
    let mut unknown: Vec<Span> = Vec::new();
    lexed.read(Span::new(file, 0, text.len()), text, &mut unknown);
    lexed.wrong = lexed.diagnostics.iter().map(Diagnostic::span).chain(unknown.clone()).collect();
    lexed.wrong.sort_unstable();
    report_unknown(text, &unknown, &mut lexed.diagnostics);
    lexed
}

impl Lexed {
    /// Reads all tokens of a part of the text.
    fn read(&mut self, part: Span, text: &str, unknown: &mut Vec<Span>) {
        let (file, offset) = (part.file, part.start as usize);
        let mut broken_off = false;
        for (kind, range) in TokenKind::lexer(&text[part.range()]).spanned() {
            let range = range.start + offset..range.end + offset;
            let span = Span::new(file, range.start, range.end);
            let Ok(kind) = kind else {
                match unknown.last_mut() {
                    Some(last) if broken_off => *last = last.to(span),
                    _ => unknown.push(span),
                }
                broken_off = true;
                continue;
            };
            broken_off = false;
            let word = &text[range];
            match kind {
                // The first line of a `/* … */` comment is a token, the others are dropped.
                TokenKind::Foreign if word.starts_with(['#', '/']) => {
                    let length = word.lines().next().unwrap_or("").trim_end().len() as u32;
                    let span = Span { end: span.start + length, ..span };
                    self.tokens.push(Token { kind, span });
                }
                TokenKind::Comment => self.comments.push(comment(span, word)),
                TokenKind::BadNumber => self.number(TokenKind::BadNumber, span, word),
                TokenKind::Int | TokenKind::Real => self.number(kind, span, word),
                TokenKind::Text => self.text_with_values(span, text, unknown),
                TokenKind::OpenText => self.open_text(span),
                kind => self.tokens.push(Token { kind, span }),
            }
        }
    }

    /// A text with embedded values, cut at these: the text between them becomes separate tokens,
    /// and the values are lexed like anything else.
    fn text_with_values(&mut self, span: Span, text: &str, unknown: &mut Vec<Span>) {
        let word = &text[span.range()];
        let holes = holes(word);
        if holes.values.is_empty() {
            return self.text(span, TokenKind::Text, word);
        }
        let place = |range: Range<usize>| {
            let start = span.start as usize;
            Span::new(span.file, start + range.start, start + range.end)
        };
        let mut kind = TokenKind::TextHead;
        let mut begin = 0;
        for hole in holes.values {
            self.text(place(begin..hole.start), kind, &word[begin..hole.start]);
            self.read(place(hole.clone()), text, unknown);
            kind = TokenKind::TextMiddle;
            begin = hole.end;
        }
        let tail = place(begin..word.len());
        let is_cut_off = self.cut_off.last().is_some_and(|cut| {
            let between = text.get(cut.end as usize..span.start as usize);
            between.is_some_and(|between| !between.contains('\n'))
        });
        if holes.is_open && !is_cut_off {
            let message = "a value in a text ends with `}`";
            let found = Diagnostic::error("unterminated-text", message, tail);
            let note = if holes.is_nested {
                self.cut_off.push(tail);
                "a quote ends the text: one that is meant in it is bound before, by `let`"
            } else {
                "a brace that stands for itself is written `\\{`"
            };
            self.diagnostics.push(found.saying("no closing `}`").note(note));
        }
        self.text(tail, TokenKind::TextTail, &word[begin..]);
    }

    fn number(&mut self, kind: TokenKind, span: Span, word: &str) {
        let kind = match kind {
            TokenKind::BadNumber if word.ends_with('.') || word.matches('.').count() > 1 => {
                self.point_too_many(span, word);
                TokenKind::Real
            }
            TokenKind::BadNumber => {
                let message = format!("`{word}` is neither a number nor a name");
                let found = Diagnostic::error("malformed-number", message, span);
                let digits = word.trim_end_matches(|c: char| c.is_alphabetic());
                // `0f` may be meant as a name.
                let is_real = digits.contains(['.', 'e', 'E'])
                    && matches!(&word[digits.len()..], "f" | "F" | "d" | "l" | "L" | "u");
                let written = |ours: &str, note: &str| {
                    found.clone().note(note).fix(format!("write `{ours}`"), span, ours)
                };
                self.diagnostics.push(match decimal(word) {
                    Some(ours) => written(&ours, "an int consists of decimal digits"),
                    None if is_real => {
                        written(digits, "a number has no letter for its type behind it")
                    }
                    None => found.note(
                        "a name does not begin with a digit, and between a number and a name stands \
                         a space or an operator",
                    ),
                });
                if is_real { TokenKind::Real } else { TokenKind::Int }
            }
            TokenKind::Int if word.parse::<i64>().is_err() => {
                self.too_large(
                    span,
                    "an int",
                    "9223372036854775807, and at least -9223372036854775807 - 1",
                );
                kind
            }
            TokenKind::Real if !word.parse::<f64>().is_ok_and(f64::is_finite) => {
                self.too_large(span, "a real", "1.7976931348623157e308");
                kind
            }
            _ => kind,
        };
        self.tokens.push(Token { kind, span });
    }

    /// `5.`, `1.2.3`
    fn point_too_many(&mut self, span: Span, word: &str) {
        let found = |message| Diagnostic::error("malformed-number", message, span);
        let whole = word.strip_suffix('.').filter(|digits| !digits.contains('.'));
        self.diagnostics.push(match whole {
            Some(digits) => found("a number has a digit behind its point").fix(
                format!("write `{digits}.0`"),
                span,
                format!("{digits}.0"),
            ),
            None => found("a number consists of digits, with at most one point between them"),
        });
    }

    fn too_large(&mut self, span: Span, what: &str, most: &str) {
        let found = Diagnostic::error("number-too-large", "this number is too large", span);
        self.diagnostics.push(found.note(format!("{what} is at most {most}")));
    }

    /// A text, or a part of one, with its delimiters.
    fn text(&mut self, span: Span, kind: TokenKind, word: &str) {
        self.tokens.push(Token { kind, span });
        for (range, escape) in read_text(word).unknown {
            let start = span.start as usize;
            let place = Span::new(span.file, start + range.start, start + range.end);
            let message = format!("`{escape}` is not an escape");
            let found = Diagnostic::error("unknown-escape", message, place);
            let known = r#"the escapes are `\n`, `\t`, `\"`, `\\`, `\{` and `\}`"#;
            self.diagnostics.push(found.note(known));
        }
    }

    fn open_text(&mut self, span: Span) {
        let message = "a text must end on the line on which it begins";
        let found = Diagnostic::error("unterminated-text", message, span);
        self.diagnostics.push(found.saying("no closing `\"`"));
        let kind = TokenKind::Text;
        self.tokens.push(Token { kind, span });
    }
}

/// The decimal digits of an int in another base or with `_` between its digits.
fn decimal(word: &str) -> Option<String> {
    let digits = word.replace('_', "");
    let radix = match digits.get(..2)? {
        "0x" | "0X" => 16,
        "0o" | "0O" => 8,
        "0b" | "0B" => 2,
        _ => return digits.parse::<i64>().ok().map(|_| digits),
    };
    i64::from_str_radix(&digits[2..], radix).ok().map(|value| value.to_string())
}

fn comment(span: Span, word: &str) -> Comment {
    let kind = if word.starts_with("//!") {
        CommentKind::FileDoc
    } else if word.starts_with("///") && !word.starts_with("////") {
        CommentKind::Doc
    } else {
        CommentKind::Plain
    };
    let length = word.trim_end().len();
    let start = span.start as usize;
    let span = Span::new(span.file, start, start + length);
    Comment { kind, span }
}

fn report_unknown(text: &str, unknown: &[Span], diagnostics: &mut Vec<Diagnostic>) {
    for &span in unknown.iter().take(MOST_UNKNOWN) {
        let run = &text[span.range()];
        let mut chars = run.chars();
        let (first, more) = (chars.next().unwrap_or('?'), chars.next().is_some());
        let shown = shown(first);
        let message = if more {
            format!("unknown characters, beginning with {shown}")
        } else {
            format!("unknown character {shown}")
        };
        let found = Diagnostic::error("unknown-character", message, span);
        let is_prime =
            first == '\u{2032}' && text[..span.start as usize].ends_with(char::is_alphanumeric);
        diagnostics.push(match usual(first) {
            Some(usual) if is_prime && !more => found.fix(format!("write `{usual}`"), span, usual),
            Some(usual) => found.note(format!("here it is written `{usual}`")),
            None => found,
        });
    }
    if let [_, ..] = unknown.get(MOST_UNKNOWN..).unwrap_or_default() {
        let span = unknown[MOST_UNKNOWN];
        let count = unknown.len() - MOST_UNKNOWN;
        let message = format!("unknown characters in {count} more places from here on");
        diagnostics.push(Diagnostic::error("unknown-character", message, span));
    }
}

fn shown(character: char) -> String {
    if character.is_control() {
        format!("U+{:04X}", u32::from(character))
    } else {
        format!("`{character}`")
    }
}

/// The ASCII character for a typographic quote or prime.
fn usual(character: char) -> Option<&'static str> {
    Some(match character {
        '\u{2032}' | '\u{2019}' | '\u{2018}' => "'",
        '\u{201C}' | '\u{201D}' => "\"",
        _ => return None,
    })
}
