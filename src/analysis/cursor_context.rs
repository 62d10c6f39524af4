//! The syntactic context of a cursor, derived from the tokens before it: so it is known even where
//! nothing around it can be parsed.

use std::ops::Range;

use super::following_words::following;
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
    /// After `keeps`.
    Property,
    /// After `guard`.
    Level,
    /// After the arrow of an op's head.
    Result,
    /// After `mesh =` or `mesh ==`.
    Mesh,
    /// Only these words fit.
    Words(&'static [&'static str]),
    /// In an op, between its parts.
    OpBody,
    /// In a side of a rule, and what the drawing wants there.
    Side(SideName, Wanted),
    /// A value is wanted; the [`Start`] says what else may begin here.
    Value(Start),
    /// After a dot: the words of the chain before it, such as `e`, `halfedge`.
    Field(Vec<String>),
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

/// The next part that a drawing wants.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    Statement,
    Face,
    Edge,
    LoopVertex,
    /// The vertex of a vertex statement.
    StarVertex,
    LoopHalfedge,
    /// A path of a loop.
    Path,
    EdgeHalfedge,
    /// A spoke, or a statement.
    Spoke,
    Fan,
    /// Something new, or a statement.
    New,
    /// Something to erase, or a statement.
    Erase,
    /// Something to keep, or a statement.
    Keep,
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
    if last.kind == T::Dot {
        return CursorContext::Field(chain(snapshot, &tokens[..tokens.len() - 1]));
    }
    if last.kind == T::DoubleColon {
        let file = tokens.iter().rev().nth(1).map(|token| snapshot.sources().slice(token.span));
        return CursorContext::File(file.unwrap_or_default().to_owned());
    }
    let start = tokens.iter().rposition(|token| begins_item(snapshot, *token));
    let Some(start) = start else { return CursorContext::Top };
    let item = &tokens[start..];
    let gap = &snapshot.text()[last.span.end as usize..offset.max(last.span.end as usize)];
    match within(item) {
        CursorContext::Value(_) if is_mesh(snapshot, item) => CursorContext::Mesh,
        found @ (CursorContext::Value(_) | CursorContext::OpBody | CursorContext::Nowhere) => {
            following(item, !gap.contains('\n')).map_or(found, CursorContext::Words)
        }
        found => found,
    }
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
    let before = &snapshot.text()[..token.span.start as usize];
    let line = before.rsplit('\n').next().unwrap_or("");
    is_keyword && (line.trim().is_empty() || line.trim_end().ends_with('}'))
}

/// The words of the chain that the tokens end with, such as `e.halfedge.`.
fn chain(snapshot: &Snapshot, tokens: &[Token]) -> Vec<String> {
    let mut words = Vec::new();
    let mut at = tokens.len();
    while let Some(token) = at.checked_sub(1).map(|before| tokens[before]) {
        if token.kind == T::RightBracket {
            // A subscript: `v[i+1]`.
            let open = tokens[..at].iter().rposition(|token| token.kind == T::LeftBracket);
            match open {
                Some(open) => at = open,
                None => break,
            }
            continue;
        }
        if !token.kind.is_wordlike() {
            break;
        }
        words.push(snapshot.sources().slice(token.span).to_owned());
        at -= 1;
        if at.checked_sub(1).map(|dot| tokens[dot].kind) != Some(T::Dot) {
            break;
        }
        at -= 1;
    }
    words.reverse();
    words
}

/// The context where the tokens of an item end.
fn within(mut tokens: &[Token]) -> CursorContext {
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
            T::Before | T::After | T::Rule | T::Steps | T::Require | T::Guard | T::Each => {
                opener = token.kind;
            }
            _ => {}
        }
    }
    let last = tokens[tokens.len() - 1].kind;
    match tokens[0].kind {
        _ if closed => CursorContext::Top,
        T::Use => CursorContext::Nowhere,
        T::Attr | T::Private => match last {
            T::Colon => CursorContext::Type,
            T::Equals => CursorContext::Value(Start::Default),
            T::Private => CursorContext::Words(&["attr", "fn", "op", "script"]),
            T::Attr => CursorContext::Nowhere,
            _ => CursorContext::Type,
        },
        first => match open.iter().rev().find(|(bracket, _)| *bracket == T::LeftBrace) {
            None => head(tokens, last),
            Some((_, T::Before)) => side(tokens, SideName::Before),
            Some((_, T::After)) => side(tokens, SideName::After),
            Some((_, T::Steps)) => value(last),
            Some((_, T::Each)) => CursorContext::Nowhere,
            Some(_) if first == T::Op => op_body(opener, last),
            Some(_) => value(last),
        },
    }
}

/// The context in the head of an item.
fn head(tokens: &[Token], last: T) -> CursorContext {
    let keeps = tokens.iter().any(|token| token.kind == T::Keeps);
    match last {
        T::Colon => CursorContext::Type,
        T::Arrow if tokens[0].kind == T::Op => CursorContext::Result,
        T::Arrow => CursorContext::Type,
        T::Equals => CursorContext::Value(Start::Value),
        T::Keeps | T::Comma if keeps => CursorContext::Property,
        _ => CursorContext::Nowhere,
    }
}

fn op_body(opener: T, last: T) -> CursorContext {
    match (opener, last) {
        (_, T::Guard) => CursorContext::Level,
        (_, T::Rule) => CursorContext::Nowhere,
        (T::Require, T::Word | T::RightParen | T::True | T::False | T::Int | T::Real) => {
            CursorContext::OpBody
        }
        (T::Require, T::Text) => CursorContext::OpBody,
        (T::Require, T::Else) => CursorContext::Nowhere,
        (T::Require, T::In) => CursorContext::Value(Start::Sequence),
        (T::Require, _) => CursorContext::Value(Start::Value),
        _ => CursorContext::OpBody,
    }
}

/// The context in the block of a script.
fn value(last: T) -> CursorContext {
    CursorContext::Value(match last {
        T::LeftBrace
        | T::RightBrace
        | T::RightParen
        | T::Word
        | T::Int
        | T::Real
        | T::Text
        | T::Parallel => Start::Statement,
        T::In => Start::Sequence,
        T::Let | T::Var | T::For | T::Drain | T::Update => return CursorContext::Nowhere,
        T::Colon => return CursorContext::Type,
        _ => Start::Value,
    })
}

/// The context in a drawing.
fn side(tokens: &[Token], side: SideName) -> CursorContext {
    let begins = |kind| {
        matches!(
            kind,
            T::Face | T::Hole | T::Loop | T::Edge | T::Vertex | T::New | T::Keep | T::Erase
        )
    };
    let stops = |kind| begins(kind) || matches!(kind, T::Before | T::After | T::Equals);
    let start = tokens.iter().rposition(|token| stops(token.kind));
    let Some(start) = start else { return CursorContext::Side(side, Wanted::Statement) };
    let rest: Vec<T> = tokens[start + 1..].iter().map(|token| token.kind).collect();
    let last = rest.last().copied();
    let has_colon = rest.contains(&T::Colon);
    let wanted = match tokens[start].kind {
        T::Equals => match last {
            // `=P=>` ends with its own arrow, behind which the loop goes on.
            _ if is_path(tokens, start) && rest.contains(&T::FatArrow) => in_loop(last),
            // A value ends with a word, a number or a parenthesis.
            Some(T::Word | T::RightParen | T::Int | T::Real) => Wanted::Statement,
            _ if is_path(tokens, start) => Wanted::Path,
            _ => return CursorContext::Value(Start::Value),
        },
        T::Face | T::Hole | T::Loop => match last {
            None => Wanted::Face,
            // Behind its first vertex.
            Some(T::Word) if !rest.contains(&T::Arrow) && !rest.contains(&T::FatArrow) => {
                return CursorContext::Nowhere;
            }
            _ if has_colon => in_loop(last),
            _ => return CursorContext::Nowhere,
        },
        T::Edge => match last {
            None => Wanted::Edge,
            Some(T::Colon | T::Bar) => Wanted::EdgeHalfedge,
            _ if !rest.contains(&T::Bar) => return CursorContext::Nowhere,
            _ => Wanted::Statement,
        },
        T::Vertex => match last {
            None => Wanted::StarVertex,
            Some(T::Star) => Wanted::Fan,
            _ if has_colon => Wanted::Spoke,
            _ => return CursorContext::Nowhere,
        },
        T::New => Wanted::New,
        T::Erase => Wanted::Erase,
        T::Keep => Wanted::Keep,
        _ => Wanted::Statement,
    };
    CursorContext::Side(side, wanted)
}

/// The part that a loop wants behind its colon.
fn in_loop(last: Option<T>) -> Wanted {
    match last {
        Some(T::Colon | T::Arrow | T::FatArrow) => Wanted::LoopVertex,
        Some(T::Minus) => Wanted::LoopHalfedge,
        _ => Wanted::Statement,
    }
}

/// True if an `=` begins an arrow of a loop: a vertex precedes it, after a colon or another arrow.
fn is_path(tokens: &[Token], equals: usize) -> bool {
    let kind = |back: usize| equals.checked_sub(back).map(|at| tokens[at].kind);
    kind(1).is_some_and(T::is_wordlike)
        && matches!(kind(2), Some(T::Colon | T::Arrow | T::FatArrow))
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
