//! A whole file: its items, their comments, and what is wrong.

use super::again::Known;
use super::cut::cut;
use super::depth::{DEEPEST, too_deep};
use super::input::{self, Rule, Source};
use super::item::item;
use super::report::{Around, report};
use crate::diagnostic::Diagnostic;
use crate::source::{FileId, Span};
use crate::syntax::lex::{Comment, CommentKind, Lexed, lex};
use crate::syntax::token::Token;
use crate::syntax::tree::{File, Item};
use chumsky::Parser;
use std::ops::Range;

/// What a text says, and what is wrong with it.
#[derive(Clone, Debug)]
pub struct Parsed {
    /// What could be read.
    pub tree: File,
    /// Every token, in order.
    pub tokens: Vec<Token>,
    /// Every comment, in order.
    pub comments: Vec<Comment>,
    /// What is wrong, in the order of its places.
    pub diagnostics: Vec<Diagnostic>,
}

/// Reads a text. Takes any text, in time linear in its length.
pub fn parse(file: FileId, text: &str) -> Parsed {
    parse_with(file, text, &Known::default())
}

/// The same, where some items are known.
pub(super) fn parse_with(file: FileId, text: &str, known: &Known) -> Parsed {
    let Lexed { tokens, comments, mut diagnostics } = lex(file, text);
    let tree = File {
        docs: file_docs(text, &tokens, &comments),
        items: items(text, &tokens, &comments, &mut diagnostics, known),
    };
    diagnostics.sort_by_key(|diagnostic| diagnostic.span().start);
    diagnostics.dedup_by_key(|diagnostic| diagnostic.span().start);
    Parsed { tree, tokens, comments, diagnostics }
}

fn items(
    text: &str,
    tokens: &[Token],
    comments: &[Comment],
    diagnostics: &mut Vec<Diagnostic>,
    known: &Known,
) -> Vec<Item> {
    let grammar = item();
    let mut reading = Reading { text, tokens, grammar: &grammar, diagnostics };
    let mut docs = Docs { text, comments, next: 0 };
    let mut items = Vec::new();
    for range in cut(text, tokens) {
        let first = tokens[range.start].span;
        let before = range.start.checked_sub(1).map(|at| tokens[at].span);
        let docs = docs.of_item(before, first);
        let whole = first.to(tokens[range.end - 1].span);
        let known = known.item(text, whole);
        let mut item = known.unwrap_or_else(|| reading.item(range));
        document(&mut item, docs);
        items.push(item);
    }
    items
}

/// The file docs before the first token.
fn file_docs(text: &str, tokens: &[Token], comments: &[Comment]) -> Vec<String> {
    let head = tokens.first().map_or(u32::MAX, |token| token.span.start);
    comments
        .iter()
        .take_while(|comment| comment.span.start < head)
        .filter(|comment| comment.kind == CommentKind::FileDoc)
        .map(|comment| comment.text(text).to_owned())
        .collect()
}

struct Reading<'t, 'g> {
    text: &'t str,
    tokens: &'t [Token],
    grammar: &'g Rule<'t, Item>,
    diagnostics: &'g mut Vec<Diagnostic>,
}

impl Reading<'_, '_> {
    fn item(&mut self, range: Range<usize>) -> Item {
        let inside = &self.tokens[range.clone()];
        let whole = match inside {
            [first, .., last] => first.span.to(last.span),
            [only] => only.span,
            [] => Span::default(),
        };
        if let Some(token) = too_deep(inside) {
            let message = format!("this nests deeper than {DEEPEST} levels");
            let found = Diagnostic::error("nesting-too-deep", message, token.span);
            let counted = "open brackets, chained operators, dots and branches all count";
            self.diagnostics.push(found.note(counted));
            return Item::Broken(whole);
        }
        let mut source = Source::from(self.text);
        let input = input::tokens(inside, whole.after());
        let (item, failures) =
            self.grammar.parse_with_state(input, &mut source).into_output_errors();
        if failures.is_empty() {
            return item.unwrap_or(Item::Broken(whole));
        }
        let next = self.tokens.get(range.end).copied();
        let around = Around::new(self.text, inside, next);
        let told = failures.into_iter().map(|failure| report(failure, &around));
        self.diagnostics.extend(told);
        item.unwrap_or(Item::Broken(whole))
    }
}

/// Gives doc comments to what they are about. Both lists are in order, so one walk is enough.
struct Docs<'t> {
    text: &'t str,
    comments: &'t [Comment],
    next: usize,
}

impl Docs<'_> {
    /// The doc comments between the token `before` and the `first` token of an item.
    fn of_item(&mut self, before: Option<Span>, first: Span) -> Vec<String> {
        let after = before.map_or(0, |token| token.end);
        let mut docs = Vec::new();
        while let Some(comment) = self.comments.get(self.next)
            && comment.span.start < first.start
        {
            if comment.kind == CommentKind::Doc && comment.span.start >= after {
                docs.push(comment.text(self.text).to_owned());
            }
            self.next += 1;
        }
        docs
    }
}

fn document(item: &mut Item, said: Vec<String>) {
    match item {
        Item::Attr(attr) => attr.docs = said,
        Item::Fn(function) => function.docs = said,
        Item::Op(op) => op.docs = said,
        Item::Script(script) => script.docs = said,
        Item::Use(_) | Item::Test(_) | Item::Broken(_) => {}
    }
}
