//! A whole file: its items, their doc comments, and the diagnostics.

use super::certain::keep_certain;
use super::cut::cut;
use super::depth::{DEEPEST, too_deep};
use super::failure::Failure;
use super::input::{self, Rule, Source};
use super::item::item;
use super::leftover::brace_too_many;
use super::report::{Around, report_all};
use super::slip::mended;
use crate::diagnostic::Diagnostic;
use crate::source::{FileId, Span};
use crate::syntax::foreign_syntax::{Found, Mended, tell};
use crate::syntax::lex::{Comment, CommentKind, Lexed, lex};
use crate::syntax::token::{Token, TokenKind as T};
use crate::syntax::tree::{File, Item};
use chumsky::Parser;

/// The result of parsing a text.
#[derive(Clone, Debug)]
pub struct Parsed {
    /// The tree, as far as it could be read.
    pub tree: File,
    /// Every token, in order.
    pub tokens: Vec<Token>,
    /// Every comment, in order.
    pub comments: Vec<Comment>,
    /// The diagnostics, in the order of their places.
    pub diagnostics: Vec<Diagnostic>,
    /// The items that could be parsed only after foreign syntax was replaced.
    pub mended: Vec<Span>,
}

/// Parses any text, in time linear in its length.
pub fn parse(file: FileId, text: &str) -> Parsed {
    parsed(file, text, true)
}

/// The same, without trying its fixes.
pub(super) fn parse_once(file: FileId, text: &str) -> Parsed {
    parsed(file, text, false)
}

fn parsed(file: FileId, text: &str, tries: bool) -> Parsed {
    let Lexed { tokens, comments, mut diagnostics, wrong, cut_off } = lex(file, text);
    let (mut misread, mut mended) = (Vec::new(), Vec::new());
    let report = (&mut diagnostics, &mut misread, &mut mended);
    let items = items(text, (&tokens, &comments), [&wrong, &cut_off], report, tries);
    let tree = File { docs: file_docs(text, &tokens, &comments), items, misread };
    diagnostics.extend(divisors_in_comments(text, &tokens, &comments));
    diagnostics.extend(privates_at_line_ends(text, &tokens));
    diagnostics.sort_by_key(|diagnostic| diagnostic.span().start);
    diagnostics.dedup_by_key(|diagnostic| diagnostic.span().start);
    Parsed { tree, tokens, comments, diagnostics, mended }
}

fn items(
    text: &str,
    (tokens, comments): (&[Token], &[Comment]),
    [wrong, cut_off]: [&[Span]; 2],
    (diagnostics, misread, mended): (&mut Vec<Diagnostic>, &mut Vec<Span>, &mut Vec<Span>),
    tries: bool,
) -> Vec<Item> {
    let grammar = item();
    let mut reading = Reading { text, grammar: &grammar, diagnostics, misread, mended, tries };
    let mut docs = Docs { text, comments, next: 0 };
    let mut items = Vec::new();
    for range in cut(text, tokens) {
        let first = tokens[range.start].span;
        let before = range.start.checked_sub(1).map(|at| tokens[at].span);
        let whole = first.to(tokens[range.end - 1].span);
        let first_of = |spans: &[Span]| {
            let first = spans.partition_point(|span| span.start < whole.start);
            spans.get(first).copied().filter(|span| span.start < whole.end)
        };
        if first_of(wrong).is_some() {
            reading.misread.push(whole);
        }
        let told = reading.diagnostics.len();
        let next = tokens.get(range.end).copied();
        for (first, mut item) in reading.items(&tokens[range], next) {
            document(&mut item, docs.of_item(before, first));
            items.push(item);
        }
        if let Some(end) = first_of(cut_off) {
            let before = |found: &Diagnostic| found.span().start < end.start;
            let found = reading.diagnostics.split_off(told);
            reading.diagnostics.extend(found.into_iter().filter(before));
        }
    }
    items
}

/// Warnings of comments that consist of an int behind a value: `n = i // 2` divides ints in other
/// languages.
fn divisors_in_comments(text: &str, tokens: &[Token], comments: &[Comment]) -> Vec<Diagnostic> {
    let is_value = |kind| matches!(kind, T::Word | T::Int | T::RightParen);
    let computes = |kind| matches!(kind, T::Equals | T::Print | T::Return | T::LeftParen);
    let told = comments.iter().filter_map(|comment| {
        let divisor = comment.text(text);
        let start = comment.span.start as usize;
        let line = text.get(..start)?.rfind('\n').map_or(0, |end| end + 1);
        let at = |place: usize| tokens.partition_point(|token| (token.span.start as usize) < place);
        let before = &tokens[at(line)..at(start)];
        let is_divisor = comment.kind == CommentKind::Plain
            && divisor.parse::<u32>().is_ok()
            && before.last().is_some_and(|last| is_value(last.kind))
            && before.iter().any(|token| computes(token.kind));
        let message = "`//` begins a comment, so nothing is divided";
        let told = Diagnostic::warning("divisor-in-comment", message, comment.span);
        is_divisor.then(|| told.note(format!("an int is divided by `x div {divisor}`")))
    });
    told.collect()
}

/// Warnings of `private` behind an item whose line ends there: it belongs to the next item.
fn privates_at_line_ends<'t>(
    text: &'t str,
    tokens: &'t [Token],
) -> impl Iterator<Item = Diagnostic> + 't {
    let is_broken = |one: &Token, other: &Token| {
        let between = text.get(one.span.end as usize..other.span.start as usize);
        between.is_some_and(|between| between.contains('\n'))
    };
    let declares = |kind| matches!(kind, T::Op | T::Script | T::Fn | T::Attr);
    tokens.windows(4).filter_map(move |next| {
        let [before, private, item, name] = next else { return None };
        let is_last = private.kind == T::Private && declares(item.kind);
        if !is_last || is_broken(before, private) || !is_broken(private, item) {
            return None;
        }
        let name = text.get(name.span.range()).unwrap_or("");
        let message =
            format!("`private` belongs to `{name}` on a later line, not to what stands before it");
        let told = Diagnostic::warning("trailing-private", message, private.span);
        let kind = item.kind.spelling().unwrap_or("");
        Some(told.note(format!("it stands on the line of its item: `private {kind} {name}`")))
    })
}

/// The file doc comments before the first token.
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
    grammar: &'g Rule<'t, Item>,
    diagnostics: &'g mut Vec<Diagnostic>,
    misread: &'g mut Vec<Span>,
    mended: &'g mut Vec<Span>,
    /// True if fixes are tried.
    tries: bool,
}

impl<'t> Reading<'t, '_> {
    /// The items that the tokens form, usually one, each with the span of its first token.
    fn items(&mut self, tokens: &'t [Token], next: Option<Token>) -> Vec<(Span, Item)> {
        let whole = whole(tokens);
        let first = tokens.first().map_or(whole, |token| token.span);
        if let Some(token) = too_deep(tokens) {
            self.misread.push(whole);
            let message = format!("this nests deeper than {DEEPEST} levels");
            let found = Diagnostic::error("nesting-too-deep", message, token.span);
            let counted = "open brackets, chained operators, dots and branches all count";
            self.diagnostics.push(found.note(counted));
            return vec![(first, Item::Broken(whole))];
        }
        let (as_it_is, failures) = read(self.grammar, self.text, tokens);
        if failures.is_empty() {
            return vec![(first, as_it_is.unwrap_or(Item::Broken(whole)))];
        }
        if let Some(item) = as_it_is.as_ref()
            && let (own, behind) = split_after(tokens, item)
            && failures.iter().all(|failure| item.span().end <= failure.span.start)
            && let Some(told) = brace_too_many(own, behind)
        {
            self.misread.push(self::whole(behind));
            self.diagnostics.push(told);
            return as_it_is.map(|item| (first, item)).into_iter().collect();
        }
        let Mended { tokens: mended, found } = mended(self.text, tokens, &failures);
        let wrong = failures.iter().map(|failure| failure.span);
        let wrong = wrong.chain(found.iter().map(|found| found.span));
        self.misread.push(misread(tokens, as_it_is.as_ref(), wrong));
        if found.is_empty() {
            let around = Around::new(self.text, tokens, next);
            self.diagnostics.extend(report_all(failures, &around));
            return vec![(first, as_it_is.unwrap_or(Item::Broken(whole)))];
        }
        self.mended.push(whole);
        let known = self.diagnostics.len();
        let mut items = Vec::new();
        // The replaced tokens do not live as long as the text, so they need their own grammar.
        let grammar = item();
        let ranges = cut(self.text, &mended);
        for (number, range) in ranges.iter().cloned().enumerate() {
            // Each item reports its own findings, so that it is known which items are valid.
            let begin = if number == 0 { 0 } else { mended[range.start].span.start };
            let next_begin = ranges.get(number + 1).map(|next| mended[next.start].span.start);
            let here = begin..next_begin.unwrap_or(u32::MAX);
            let own = found.iter().filter(|found| here.contains(&found.span.start));
            let own = tell(self.text, own.cloned().collect());
            let inside = &mended[range];
            let here = self::whole(inside);
            let (item, failures) = match too_deep(inside) {
                None => read(&grammar, self.text, inside),
                Some(_) => (None, Vec::new()),
            };
            let around = Around::new(self.text, inside, next);
            let mut told = report_all(failures, &around);
            let first = told.first().cloned().filter(|_| own.is_empty());
            told.retain(|told| !is_consequence(self.text, told, &found));
            // An invalid item always has a diagnostic.
            told.extend(first.filter(|_| told.is_empty()));
            self.diagnostics.extend(own.into_iter().chain(told));
            items.push((here.before(), item.unwrap_or(Item::Broken(here))));
        }
        if items.is_empty() {
            self.diagnostics.extend(tell(self.text, found));
            items.push((first, Item::Broken(whole)));
        }
        if self.tries {
            keep_certain(self.text, whole, &mut self.diagnostics[known..]);
        }
        items
    }
}

fn read<'t>(
    grammar: &Rule<'t, Item>,
    text: &'t str,
    tokens: &'t [Token],
) -> (Option<Item>, Vec<Failure>) {
    let mut source = Source::from(text);
    let input = input::tokens(tokens, whole(tokens).after());
    grammar.parse_with_state(input, &mut source).into_output_errors()
}

/// The failures of an item.
pub(super) fn failures(text: &str, tokens: &[Token]) -> Vec<Failure> {
    read(&item(), text, tokens).1
}

fn whole(tokens: &[Token]) -> Span {
    match tokens {
        [first, .., last] => first.span.to(last.span),
        [only] => only.span,
        [] => Span::default(),
    }
}

/// The text that could not be read as it is written: all tokens or, if nothing is `wrong` in the
/// item that they begin with, those behind it.
fn misread(tokens: &[Token], item: Option<&Item>, mut wrong: impl Iterator<Item = Span>) -> Span {
    let end = item.map_or(0, |item| item.span().end);
    let (read, behind) = item.map_or((&[][..], tokens), |item| split_after(tokens, item));
    let is_closed = read.last().is_some_and(|last| last.kind == T::RightBrace);
    let is_behind = is_closed && !behind.is_empty() && wrong.all(|wrong| end <= wrong.start);
    whole(if is_behind { behind } else { tokens })
}

/// The tokens of an item, and those behind it.
fn split_after<'t>(tokens: &'t [Token], item: &Item) -> (&'t [Token], &'t [Token]) {
    let end = item.span().end;
    tokens.split_at(tokens.partition_point(|token| token.span.start < end))
}

/// True if an error only follows from a finding: on the same line as the foreign syntax, or after
/// foreign syntax whose meaning is uncertain.
fn is_consequence(text: &str, told: &Diagnostic, found: &[Found]) -> bool {
    let at = told.span().start;
    found.iter().any(|found| {
        let between = match found.span.start <= at {
            true => text.get(found.span.start as usize..at as usize),
            false => text.get(at as usize..found.span.start as usize),
        };
        let same_line = between.is_some_and(|between| !between.contains('\n'));
        same_line || found.ends && found.span.start <= at
    })
}

/// Attaches doc comments to items. Both lists are in order, so one pass is enough.
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
