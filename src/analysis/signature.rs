//! Signature help: the call around a cursor, and which argument is being written.

use super::snapshot::Snapshot;
use super::words::meaning;
use crate::resolve::signatures;
use crate::source::Span;
use crate::syntax::TokenKind as T;
use crate::syntax::tree::{Ident, Item, Param};

/// One way to call something.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Call {
    /// The signature as it is written: `split(e: edge) -> m`.
    pub label: String,
    /// Its parameters, as they are written in the label.
    pub params: Vec<String>,
    /// Its documentation.
    pub about: String,
}

/// The signatures of the call around a cursor, and the index of the argument there.
pub fn signature(snapshot: &Snapshot, offset: usize) -> Option<(Vec<Call>, usize)> {
    let tokens = &snapshot.parsed().tokens;
    let end = tokens.partition_point(|token| (token.span.end as usize) <= offset);
    let (mut depth, mut argument) = (0_usize, 0);
    for at in (1..end).rev() {
        match tokens[at].kind {
            T::RightParen => depth += 1,
            T::LeftParen if depth > 0 => depth -= 1,
            T::LeftParen if tokens[at - 1].kind.is_wordlike() => {
                let before = |back| Some(tokens[usize::checked_sub(at, back)?]);
                let is_head =
                    before(2).is_some_and(|token| matches!(token.kind, T::Op | T::Script | T::Fn));
                let is_qualified = before(2).is_some_and(|token| token.kind == T::DoubleColon);
                let first = before(3).filter(|_| is_qualified).unwrap_or(tokens[at - 1]);
                let span = Span { start: first.span.start, ..tokens[at - 1].span };
                let word = snapshot.sources().slice(span);
                let calls = if is_head { Vec::new() } else { calls(snapshot, word) };
                return (!calls.is_empty()).then_some((calls, argument));
            }
            T::LeftParen => return None,
            T::Comma if depth == 0 => argument += 1,
            T::LeftBrace | T::RightBrace => return None,
            _ => {}
        }
    }
    None
}

fn calls(snapshot: &Snapshot, word: &str) -> Vec<Call> {
    let (items, own_name) = snapshot.items_for(word);
    let is_meant = |head: &Head| head.name == own_name;
    if let Some(head) = items.filter_map(Head::of).find(is_meant) {
        let params: Vec<String> =
            head.params.iter().map(|param| written(snapshot, param)).collect();
        let label = format!("{word}{}", head.signature(snapshot));
        return vec![Call { label, params, about: head.docs.join("\n") }];
    }
    let ways = signatures(word).into_iter().map(|way| {
        let params: Vec<String> = way.takes.iter().map(|ty| (*ty).to_owned()).collect();
        let gives = way.gives.map(|ty| format!(" -> {}", ty.word()));
        Call {
            label: format!("{word}({}){}", params.join(", "), gives.unwrap_or_default()),
            params,
            about: meaning(word).unwrap_or("").to_owned(),
        }
    });
    ways.collect()
}

/// The head of an item that can be called.
pub(super) struct Head<'t> {
    pub name: &'t str,
    pub params: &'t [Param],
    pub result: Option<&'t Ident>,
    /// Its doc comment, a line each.
    pub docs: &'t [String],
}

impl<'t> Head<'t> {
    /// The head of an item, if that can be called.
    pub fn of(item: &'t Item) -> Option<Self> {
        let (name, params, result, docs) = match item {
            Item::Op(op) => (&op.name, &op.params, &op.result, &op.docs),
            Item::Fn(function) => {
                (&function.name, &function.params, &function.result, &function.docs)
            }
            Item::Script(script) => (&script.name, &script.params, &None, &script.docs),
            _ => return None,
        };
        Some(Self { name: &name.text, params, result: result.as_ref(), docs })
    }

    /// The parameters and the result: `(e: edge) -> m`.
    pub fn signature(&self, snapshot: &Snapshot) -> String {
        let params: Vec<_> = self.params.iter().map(|param| written(snapshot, param)).collect();
        let result = self.result.map(|result| format!(" -> {}", result.text));
        format!("({}){}", params.join(", "), result.unwrap_or_default())
    }
}

/// A parameter as it is declared; of a long default only that there is one.
fn written(snapshot: &Snapshot, param: &Param) -> String {
    let default = param.default.as_ref().map(|value| snapshot.sources().slice(value.span));
    let is_short = |value: &&str| value.len() <= LONGEST_DEFAULT && !value.contains('\n');
    let default = default.map(|value| Some(value).filter(is_short).unwrap_or("…"));
    let optional = default.map_or(String::new(), |value| format!(" = {value}"));
    format!("{}: {}{optional}", param.name.ident.text, param.ty.text)
}

/// The length of the longest default that is shown, in bytes.
const LONGEST_DEFAULT: usize = 20;
