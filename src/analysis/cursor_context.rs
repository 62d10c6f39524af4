//! The syntactic context of a cursor, derived from the tokens before it: so it is known even where
//! nothing around it can be parsed.

use std::ops::Range;

use super::drawing_context::{Wanted, side};
use super::following_words::{Following, ends_statement, ends_value, following, kind, opening};
use super::names::SideName;
use super::snapshot::Snapshot;
use crate::syntax::tree::{self, Item, Rule};
use crate::syntax::{Token, TokenKind as T};

/// The syntactic context of a cursor.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum CursorContext {
    /// Between items.
    Top,
    /// In a comment, a text or a number, or where a new name is declared.
    Nowhere,
    /// In the quotes of a `use`, and what stands between these.
    Path(Range<usize>),
    /// A type is wanted.
    Type,
    /// The type of an element is wanted.
    Kind,
    /// The type of a value that is no element is wanted.
    ValueType,
    /// After `keeps`.
    Property,
    /// After `guard`.
    Level,
    /// Among the names of an `alias`.
    Alias,
    /// After the arrow of an op's head.
    Result,
    /// After `mesh =` or `mesh ==`.
    Mesh,
    /// Only these words fit.
    Words(&'static [&'static str]),
    /// A value goes on with one of these words, or something else begins.
    GoesOn(&'static [&'static str], Box<CursorContext>),
    /// In an op, between its parts.
    OpBody,
    /// In a subscript: the letter of the index.
    Index(String),
    /// In a side of a rule, and what the drawing wants there.
    Side(SideName, Wanted),
    /// A value is wanted; the [`Start`] says what else may begin here.
    Value(Start),
    /// After a dot: the tokens of the value before it, without subscripts.
    Field(Vec<Token>),
    /// After `::`: the qualifier before it.
    File(String),
}

/// The forms that may begin where a value is wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// A statement may begin.
    Statement,
    /// Only a value fits.
    Value,
    /// A sequence is wanted.
    Sequence,
    /// The default of an attribute is wanted.
    Default,
}

/// The space between the last token and the cursor, or the word at it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Gap {
    Nothing,
    Blanks,
    LineEnd,
}

/// The tokens before the word at a byte.
pub fn before(snapshot: &Snapshot, offset: usize) -> &[Token] {
    let tokens = &snapshot.parsed().tokens;
    let end = tokens.partition_point(|token| (token.span.start as usize) < offset);
    match tokens[..end].last() {
        Some(word) if word.kind.is_wordlike() && word.span.end as usize >= offset => {
            &tokens[..end - 1]
        }
        _ => &tokens[..end],
    }
}

/// The letters of the word before a byte, if the cursor is in one or behind it.
pub fn letters_before(snapshot: &Snapshot, offset: usize) -> &str {
    let before = snapshot.text().get(..offset).unwrap_or_default();
    let is_letter = |sign: char| sign.is_alphanumeric() || sign == '_';
    &before[before.trim_end_matches(is_letter).len()..]
}

/// The token that follows the word at a byte on its line.
pub fn next_on_line(snapshot: &Snapshot, offset: usize) -> Option<T> {
    let mut behind = snapshot.parsed().tokens[before(snapshot, offset).len()..].iter();
    let next = behind.find(|token| token.span.start as usize >= offset)?;
    let gap = snapshot.text().get(offset..next.span.start as usize)?;
    (!gap.contains('\n')).then_some(next.kind)
}

/// The context of the cursor at a byte.
pub fn place(snapshot: &Snapshot, offset: usize) -> CursorContext {
    // A comment ends with its line; its blanks there are not part of its span.
    let before_cursor = snapshot.text().get(..offset).unwrap_or_default();
    let line = before_cursor.rfind('\n').map_or(0, |end| end + 1);
    let in_comment = snapshot.parsed().comments.iter().any(|comment| {
        let start = comment.span.start as usize;
        line <= start && start < offset
    });
    if in_comment {
        return CursorContext::Nowhere;
    }
    let tokens = before(snapshot, offset);
    let Some(last) = tokens.last() else { return CursorContext::Top };
    let is_text = matches!(last.kind, T::Text | T::TextTail | T::OpenText);
    if is_text && last.span.end as usize >= offset {
        let is_use = tokens.iter().rev().nth(1).map(|token| token.kind) == Some(T::Use);
        let written = snapshot.sources().slice(last.span);
        let is_open = written.len() == 1 || !written.ends_with('"');
        let is_inside = (last.span.end as usize) > offset || is_open;
        let range = last.span.range();
        return match (is_use, is_inside) {
            (true, true) => CursorContext::Path(range.start + 1..range.end - usize::from(!is_open)),
            _ => CursorContext::Nowhere,
        };
    }
    // Between two dots a word of a chain is missing.
    let is_dot = last.kind == T::Dot || last.kind == T::DotDot && last.span.end as usize > offset;
    if is_dot {
        return CursorContext::Field(operand(snapshot, &tokens[..tokens.len() - 1]));
    }
    if last.kind == T::DoubleColon {
        let file = tokens.iter().rev().nth(1).map(|token| snapshot.sources().slice(token.span));
        return CursorContext::File(file.unwrap_or_default().to_owned());
    }
    let start = tokens.iter().rposition(|token| begins_item(snapshot, *token));
    let Some(start) = start else { return CursorContext::Top };
    let item = &tokens[start..];
    if is_in_subscript(item) {
        let letter = index(snapshot, item).filter(|_| last.kind == T::LeftBracket);
        return letter.map_or(CursorContext::Nowhere, CursorContext::Index);
    }
    let gap = gap(snapshot, tokens, offset);
    match within(item, gap) {
        CursorContext::Value(_) if is_mesh(snapshot, item) => CursorContext::Mesh,
        found @ (CursorContext::Value(_)
        | CursorContext::Side(_, Wanted::Statement)
        | CursorContext::OpBody
        | CursorContext::Nowhere) => {
            let in_block = matches!(found, CursorContext::Value(_));
            match following(snapshot, item, gap, in_block) {
                Some(Following::Only(words)) => CursorContext::Words(words),
                Some(Following::Also(words)) => CursorContext::GoesOn(words, Box::new(found)),
                None => found,
            }
        }
        found => found,
    }
}

/// The space behind some tokens, which are all before the cursor or the word at it.
fn gap(snapshot: &Snapshot, tokens: &[Token], offset: usize) -> Gap {
    let next = snapshot.parsed().tokens.get(tokens.len());
    let end = next.map_or(offset, |next| offset.min(next.span.start as usize));
    let start = tokens.last().map_or(end, |last| end.min(last.span.end as usize));
    match snapshot.text().get(start..end) {
        None | Some("") => Gap::Nothing,
        Some(blanks) if blanks.contains('\n') => Gap::LineEnd,
        _ => Gap::Blanks,
    }
}

/// True if the tokens of an item end in a subscript.
fn is_in_subscript(item: &[Token]) -> bool {
    let is_index = |kind| matches!(kind, T::Word | T::Int | T::Plus | T::Minus);
    let open = item.iter().rfind(|token| !is_index(token.kind));
    open.is_some_and(|token| token.kind == T::LeftBracket)
}

/// The letter of the index that the tokens of an item declare last.
fn index(snapshot: &Snapshot, item: &[Token]) -> Option<String> {
    let each = item.iter().rposition(|token| token.kind == T::Each)?;
    Some(snapshot.sources().slice(item.get(each + 1)?.span).to_owned())
}

/// True if the tokens of an item end with `mesh =`, `mesh ==` or `mesh !=`, and it is a test.
fn is_mesh(snapshot: &Snapshot, tokens: &[Token]) -> bool {
    let [Token { kind: T::Test, .. }, .., word, sign] = tokens else { return false };
    matches!(sign.kind, T::Equals | T::Equal | T::NotEqual)
        && snapshot.sources().slice(word.span) == "mesh"
}

/// True if a token begins an item: it is a keyword of items, and first on its line or after a
/// closing brace.
pub(super) fn begins_item(snapshot: &Snapshot, token: Token) -> bool {
    let is_keyword =
        matches!(token.kind, T::Op | T::Script | T::Fn | T::Attr | T::Use | T::Test | T::Private);
    let before = snapshot.text().get(..token.span.start as usize).filter(|_| is_keyword);
    let is_blank = |sign: char| sign != '\n' && sign.is_whitespace();
    before.map(|before| before.trim_end_matches(is_blank)).is_some_and(|before| {
        before.trim_start_matches('\u{feff}').is_empty() || before.ends_with(['\n', '}'])
    })
}

/// The tokens of the value that some tokens end with, such as `e.halfedge` or `f(e)`, without
/// subscripts: `v[i+1]`.
fn operand(snapshot: &Snapshot, tokens: &[Token]) -> Vec<Token> {
    let start = start_of_operand(snapshot, tokens).unwrap_or(tokens.len());
    let mut in_subscript = false;
    let mut kept = tokens[start..].to_vec();
    kept.retain(|token| {
        let was_inside = in_subscript;
        in_subscript = token.kind == T::LeftBracket || was_inside && token.kind != T::RightBracket;
        !in_subscript && !was_inside
    });
    kept
}

/// The index of the first token of the value that some tokens end with.
fn start_of_operand(snapshot: &Snapshot, tokens: &[Token]) -> Option<usize> {
    let kind = |at: usize| tokens.get(at).map(|token| token.kind);
    let mut start = tokens.len();
    loop {
        let mut at = start.checked_sub(1)?;
        if kind(at) == Some(T::RightBracket) {
            at = opening(&tokens[..=at])?.checked_sub(1)?;
        }
        if kind(at) == Some(T::RightParen) {
            let open = opening(&tokens[..=at])?;
            return Some(start_of_call(snapshot, tokens, open));
        }
        kind(at).filter(|kind| kind.is_wordlike())?;
        match at.checked_sub(1) {
            Some(dot) if kind(dot) == Some(T::Dot) => start = dot,
            _ => return Some(at),
        }
    }
}

/// The index of the first token of the call whose parenthesis opens at one; that of the parenthesis
/// if nothing is called.
fn start_of_call(snapshot: &Snapshot, tokens: &[Token], open: usize) -> usize {
    let Some(name) = open.checked_sub(1) else { return open };
    let is_called = (tokens[name].kind.is_name() || tokens[name].kind == T::Hole)
        && gap(snapshot, &tokens[..open], tokens[open].span.start as usize) != Gap::LineEnd;
    match tokens[..name] {
        _ if !is_called => open,
        [.., _, of] if of.kind == T::DoubleColon => name - 2,
        _ => name,
    }
}

/// The context where the tokens of an item end.
fn within(mut tokens: &[Token], gap: Gap) -> CursorContext {
    if let [Token { kind: T::Private, .. }, item, ..] = tokens
        && item.kind != T::Attr
    {
        tokens = &tokens[1..];
    }
    let mut open: Vec<(T, T)> = Vec::new();
    let mut opener = tokens[0].kind;
    let mut closed = false;
    for token in &tokens[1..] {
        match token.kind {
            T::LeftBrace => open.push((T::LeftBrace, opener)),
            T::LeftParen => open.push((T::LeftParen, opener)),
            T::RightBrace => {
                while let Some((bracket, of)) = open.pop() {
                    if bracket == T::LeftBrace {
                        opener = of;
                        break;
                    }
                }
                closed = open.is_empty();
                // After a side the op continues; after a block its steps do.
                if matches!(opener, T::Before | T::After | T::Rule | T::Steps) {
                    opener = open.last().map_or(tokens[0].kind, |(_, of)| *of);
                }
            }
            T::RightParen => {
                open.pop_if(|(bracket, _)| *bracket == T::LeftParen);
            }
            // A step.
            T::Require if opener == T::Steps => {}
            T::Before | T::After | T::Rule | T::Steps => opener = token.kind,
            T::Require | T::Guard | T::Alias | T::Each => opener = token.kind,
            _ => {}
        }
    }
    let Some(last) = kind(tokens, tokens.len() - 1) else { return CursorContext::Nowhere };
    let in_parens = open.last().is_some_and(|(bracket, _)| *bracket == T::LeftParen);
    let mut blocks = open.iter().rev().filter(|(bracket, _)| *bracket == T::LeftBrace);
    let found = match tokens[0].kind {
        _ if closed => CursorContext::Top,
        T::Use if last == T::Text && gap == Gap::LineEnd => CursorContext::Top,
        T::Use => CursorContext::Nowhere,
        T::Attr | T::Private => attribute(tokens, gap),
        first => match blocks.find(|(_, of)| *of != T::Each) {
            None => head(tokens, last, in_parens),
            Some((_, T::Before)) => side(tokens, SideName::Before, gap),
            Some((_, T::After)) => side(tokens, SideName::After, gap),
            Some((_, T::Steps)) => value(last),
            Some(_) if first == T::Op => op_body(tokens, opener, last, gap),
            Some(_) => value(last),
        },
    };
    match found {
        // Nothing else begins before the parenthesis is closed.
        CursorContext::Value(Start::Statement)
        | CursorContext::Side(_, Wanted::Statement)
        | CursorContext::OpBody
        | CursorContext::Top
            if in_parens =>
        {
            CursorContext::Nowhere
        }
        found => found,
    }
}

/// The context in the declaration of an attribute.
fn attribute(tokens: &[Token], gap: Gap) -> CursorContext {
    let Some(colon) = tokens.iter().position(|token| token.kind == T::Colon) else {
        return match tokens {
            [private] if private.kind == T::Private => {
                CursorContext::Words(&["attr", "fn", "op", "script"])
            }
            _ => CursorContext::Nowhere,
        };
    };
    match &tokens[colon + 1..] {
        [] => CursorContext::Kind,
        [_] => CursorContext::ValueType,
        [_, _] if gap == Gap::LineEnd => CursorContext::Top,
        [_, _] => CursorContext::Nowhere,
        [_, _, equals] if equals.kind == T::Equals => CursorContext::Value(Start::Default),
        [.., last] if !ends_value(last.kind) => CursorContext::Value(Start::Value),
        _ if gap == Gap::LineEnd => CursorContext::Top,
        _ => CursorContext::Nowhere,
    }
}

/// The context in the head of an item.
fn head(tokens: &[Token], last: T, in_parens: bool) -> CursorContext {
    let is_op = tokens[0].kind == T::Op;
    let keeps = tokens.iter().any(|token| token.kind == T::Keeps);
    let is_result = tokens.iter().nth_back(1).is_some_and(|token| token.kind == T::Arrow);
    match last {
        T::Colon => CursorContext::Type,
        T::Arrow if is_op => CursorContext::Result,
        T::Arrow => CursorContext::Type,
        T::Equals => CursorContext::Value(Start::Value),
        T::Keeps | T::Comma if keeps => CursorContext::Property,
        _ if keeps || in_parens || !is_op => CursorContext::Nowhere,
        _ if last == T::RightParen || is_result => CursorContext::Words(&["keeps"]),
        _ => CursorContext::Nowhere,
    }
}

fn op_body(tokens: &[Token], opener: T, last: T, gap: Gap) -> CursorContext {
    match (opener, last) {
        (_, T::Guard) => CursorContext::Level,
        (_, T::Rule) => CursorContext::Nowhere,
        (T::Alias, _) if lists_more(tokens, last) || gap != Gap::LineEnd => CursorContext::Alias,
        (T::Require, T::Else) => CursorContext::Nowhere,
        (T::Require, T::In) => CursorContext::Value(Start::Sequence),
        (T::Require, last) if !ends_value(last) => CursorContext::Value(Start::Value),
        _ => CursorContext::OpBody,
    }
}

/// True if the tokens end in an `alias` that lists too few names, or with a comma of one.
fn lists_more(tokens: &[Token], last: T) -> bool {
    let start = tokens.iter().rposition(|token| token.kind == T::Alias);
    start.is_some_and(|start| tokens.len() - start <= 2) || last == T::Comma
}

/// The context in the block of a script.
fn value(last: T) -> CursorContext {
    CursorContext::Value(match last {
        last if ends_statement(last) || last == T::Parallel => Start::Statement,
        T::In => Start::Sequence,
        T::Let | T::Var | T::For | T::Drain | T::Update => return CursorContext::Nowhere,
        T::Colon => return CursorContext::Type,
        _ => Start::Value,
    })
}

/// The rule that a cursor is in or, as it may be unfinished, after; with the indices of its item
/// and of the rule.
pub fn rule_near(snapshot: &Snapshot, offset: usize) -> Option<(usize, usize, &Rule)> {
    let (item, op) = op_near(snapshot, offset)?;
    let touched = op.rules.iter().position(|rule| rule.span.touches(offset));
    let behind = || op.rules.iter().rposition(|rule| rule.span.start as usize <= offset);
    let rule = touched.or_else(behind)?;
    Some((item, rule, &op.rules[rule]))
}

/// The op that a cursor is in or, as it may be unfinished, after; with the index of its item.
pub fn op_near(snapshot: &Snapshot, offset: usize) -> Option<(usize, &tree::Op)> {
    let (at, item) = item_near(snapshot, offset)?;
    Some((at, item.op()?))
}

/// The item that a cursor is in or after, and its index.
pub fn item_near(snapshot: &Snapshot, offset: usize) -> Option<(usize, &Item)> {
    let mut items = snapshot.items().iter().enumerate().rev();
    items.find(|(_, item)| (item.span().start as usize) <= offset)
}
