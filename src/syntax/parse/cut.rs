//! Cutting a file into items, before any of them is parsed.
//!
//! An item begins at its keyword outside all braces, or, inside braces that are not closed, at a
//! keyword that can begin nothing else, so that a broken item ends where the next one begins.

use super::foreign_syntax::item_word;
use crate::syntax::foreign_syntax::keyword_meant;
use crate::syntax::token::{Token, TokenKind as T};
use std::ops::Range;

/// The token range of each item, in order; together they cover all tokens.
pub(super) fn cut(text: &str, tokens: &[Token]) -> Vec<Range<usize>> {
    let mut starts = Vec::new();
    let mut open = 0_usize;
    let closings = Closings::of(text, tokens);
    for at in 0..tokens.len() {
        if begins_item(text, tokens, at, open > 0) && !closings.is_inside(text, tokens, at, open) {
            starts.push(at);
            open = 0;
        }
        match tokens[at].kind {
            T::LeftBrace => open += 1,
            T::RightBrace => open = open.saturating_sub(1),
            _ => {}
        }
    }
    if starts.first() != Some(&0) && !tokens.is_empty() {
        starts.insert(0, 0);
    }
    let ends = starts.iter().skip(1).copied().chain([tokens.len()]);
    starts.iter().copied().zip(ends).map(|(start, end)| start..end).collect()
}

/// How far braces are closed after each token, up to where an item certainly begins.
struct Closings {
    /// The number of open braces before each token; negative if more are closed than opened.
    depths: Vec<i32>,
    /// The minimum depth after each token, up to where an item certainly begins.
    least: Vec<i32>,
}

impl Closings {
    fn of(text: &str, tokens: &[Token]) -> Self {
        let mut depth = 0;
        let mut depths = Vec::with_capacity(tokens.len());
        for token in tokens {
            depths.push(depth);
            depth += match token.kind {
                T::LeftBrace => 1,
                T::RightBrace => -1,
                _ => 0,
            };
        }
        let mut least = vec![depth; tokens.len()];
        let mut behind = depth;
        for at in (0..tokens.len()).rev() {
            least[at] = behind;
            let ends = begins_item(text, tokens, at, true) && indent(text, tokens, at) == Some(0);
            behind = if ends { depths[at] } else { behind.min(depths[at]) };
        }
        Self { depths, least }
    }

    /// True if the declaration at a token is inside an item whose `open` braces are all closed
    /// after it: the declaration is misplaced, and no brace is missing.
    fn is_inside(&self, text: &str, tokens: &[Token], at: usize, open: usize) -> bool {
        let kinds = [T::Attr, T::Private, T::Fn, T::Op, T::Script, T::Use];
        let declares = kinds.contains(&tokens[at].kind);
        open > 0
            && declares
            && indent(text, tokens, at) != Some(0)
            && i64::from(self.least[at]) <= i64::from(self.depths[at]) - open as i64
    }
}

/// True if an item begins here; `inside` is true inside braces, where more evidence is needed.
fn begins_item(text: &str, tokens: &[Token], at: usize, inside: bool) -> bool {
    let kind = |ahead: usize| tokens.get(at + ahead).map(|token| token.kind);
    let named = kind(1).is_some_and(T::is_name);
    let declares = |kind| matches!(kind, T::Op | T::Script | T::Fn | T::Attr);
    let is_private = |at: usize| {
        let [private, item] = tokens.get(at..at + 2).unwrap_or_default() else { return false };
        let between = text.get(private.span.end as usize..item.span.start as usize);
        declares(item.kind)
            && is_private_word(text, private)
            && between.is_some_and(|between| {
                let mut lines = between.lines().map(str::trim);
                // A doc comment belongs to what stands behind it.
                lines.all(|line| {
                    line.is_empty() || line.starts_with("//") && !line.starts_with("///")
                })
            })
    };
    let (sure, hard) = match tokens[at].kind {
        _ if at.checked_sub(1).is_some_and(is_private) => return false,
        T::Op | T::Script | T::Fn => (named && kind(2) == Some(T::LeftParen), true),
        T::Use => (kind(1) == Some(T::Text), true),
        T::Test => (kind(1) == Some(T::Text), false),
        T::Private if is_private(at) => (true, false),
        // `private nf f`: a misspelt word follows.
        T::Private => {
            let is_word = kind(1) == Some(T::Word) && indent(text, tokens, at + 1).is_none();
            return is_word && !inside && indent(text, tokens, at).is_some();
        }
        T::Word if is_private(at) => return !inside || indent(text, tokens, at) == Some(0),
        T::Attr => (named && kind(2) == Some(T::Colon), true),
        // `def f`: a foreign word, followed by another.
        T::Word => {
            let is_item = text.get(tokens[at].span.range()).and_then(item_word).is_some();
            let named = kind(1).is_some_and(T::is_wordlike);
            return is_item && named && !inside && indent(text, tokens, at) == Some(0);
        }
        _ => return false,
    };
    let Some(indent) = indent(text, tokens, at) else { return sure && !inside };
    sure || hard && (indent == 0 || !inside)
}

/// True if a token is `private`, perhaps misspelt.
fn is_private_word(text: &str, token: &Token) -> bool {
    let word = || text.get(token.span.range()).unwrap_or("");
    token.kind == T::Private
        || token.kind == T::Word && keyword_meant(word(), [T::Private]).is_some()
}

/// The indentation of a token, if it is the first on its line.
fn indent(text: &str, tokens: &[Token], at: usize) -> Option<usize> {
    let start = tokens[at].span.start as usize;
    let before = match at.checked_sub(1) {
        Some(before) => tokens[before].span.end as usize,
        None => return Some(0),
    };
    let between = text.get(before..start)?;
    between.rfind('\n').map(|line_end| between.len() - line_end - 1)
}
