//! Braces that are never closed: where a `}` is missing, by the indentation of the lines.

use crate::syntax::token::{Token, TokenKind as T};

/// The braces and lines of the tokens of an item.
pub(super) struct Braces<'t> {
    item: &'t [Token],
    /// For each token, and for the end, the index of the innermost open brace before it.
    open: Vec<Option<usize>>,
    /// For each token, the index of the first token of its line.
    line: Vec<usize>,
    /// The width of the indentation of each line, at its first token.
    width: Vec<usize>,
}

/// A brace that is not closed.
pub(super) struct Unclosed {
    /// The index of the brace.
    pub brace: usize,
    /// The index of the first token of the statement whose block it opens.
    pub head: usize,
    /// The index of the first token that is not inside of the block, as it is indented.
    pub end: usize,
    /// True if the block is on the line of its brace.
    pub on_one_line: bool,
    /// True if the block is indented more than its statement.
    pub is_indented: bool,
}

impl<'t> Braces<'t> {
    /// Collects the braces and lines of the tokens of an item.
    pub(super) fn new(text: &str, item: &'t [Token]) -> Self {
        let (mut line, mut width) = (Vec::new(), vec![0; item.len()]);
        let mut before = 0;
        for (at, token) in item.iter().enumerate() {
            let gap = text.get(before..token.span.start as usize).unwrap_or("");
            let begins = at == 0 || gap.contains('\n');
            if begins {
                let start = gap.rsplit('\n').next().unwrap_or("");
                width[at] = start.len() - start.trim_start().len();
            }
            line.push(if begins { at } else { line[at - 1] });
            before = token.span.end as usize;
        }
        Self { item, open: open_braces(item), line, width }
    }

    /// The innermost brace that is open before a token, if braces are missing in this item.
    pub(super) fn open_at(&self, at: usize) -> Option<usize> {
        self.open.last().copied().flatten().and(self.open.get(at).copied().flatten())
    }

    /// True if exactly one brace is never closed.
    pub(super) fn lack_one(&self) -> bool {
        let open = self.item.iter().fold(0_usize, |open, token| match token.kind {
            T::LeftBrace => open + 1,
            T::RightBrace => open.saturating_sub(1),
            _ => open,
        });
        open == 1
    }

    /// The brace that is not closed: one that something certainly is outside of, one whose closing
    /// brace is indented less than its statement, and so probably closes the surrounding block, or
    /// else the one that is open.
    pub(super) fn unclosed(&self, open: usize) -> Unclosed {
        if let Some((brace, end)) = self.outside() {
            return self.ending(brace, end);
        }
        let inner = self.item.iter().enumerate().find_map(|(at, token)| {
            let begins_line = token.kind == T::RightBrace && self.line[at] == at;
            let opened = self.open[at].filter(|_| begins_line)?;
            (self.width[at] < self.width[self.head(opened)]).then_some(opened)
        });
        let brace = inner.unwrap_or(open);
        let body = self.body(brace);
        let mut behind = brace + 1..self.item.len();
        let end = behind.find(|&at| self.line[at] == at && self.width[at] < body);
        self.ending(brace, end.unwrap_or(self.item.len()))
    }

    /// The first token that cannot be inside of the innermost open block, and the brace of that: an
    /// `else` that follows no block, or a `)` that closes a parenthesis around the block.
    fn outside(&self) -> Option<(usize, usize)> {
        let mut open: Vec<usize> = Vec::new();
        let is = |at: &usize, kind: T| self.item[*at].kind == kind;
        for (at, token) in self.item.iter().enumerate() {
            match token.kind {
                T::LeftBrace | T::LeftParen => open.push(at),
                T::RightBrace => while open.pop().is_some_and(|at| !is(&at, T::LeftBrace)) {},
                T::RightParen if open.last().is_some_and(|at| is(at, T::LeftParen)) => {
                    open.pop();
                }
                T::RightParen if open.iter().any(|at| is(at, T::LeftParen)) => {
                    return Some((*open.last()?, at));
                }
                T::Else if self.is_misplaced(at) => return Some((self.open[at]?, at)),
                _ => {}
            }
        }
        None
    }

    /// True if an `else` before a block follows no block, or is indented less than what is around.
    fn is_misplaced(&self, at: usize) -> bool {
        let kind = |at: usize| self.item.get(at).map(|token| token.kind);
        let begins_block = matches!(kind(at + 1), Some(T::LeftBrace | T::If));
        let follows_block = at > 0 && kind(at - 1) == Some(T::RightBrace);
        let is_less = |open| self.line[at] == at && self.width[at] < self.body(open);
        begins_block && (!follows_block || self.open[at].is_some_and(is_less))
    }

    /// The brace that is not closed, and the index of the token before which its block ends.
    fn ending(&self, brace: usize, end: usize) -> Unclosed {
        let head = self.head(brace);
        Unclosed {
            brace,
            head,
            end,
            on_one_line: end > brace + 1 && self.line[end - 1] == self.line[brace],
            is_indented: self.width[head] < self.body(brace),
        }
    }

    /// The least indentation of a line of the block of a brace.
    fn body(&self, brace: usize) -> usize {
        match self.item.get(brace + 1) {
            Some(next) if next.kind != T::RightBrace && self.line[brace + 1] == brace + 1 => {
                self.width[brace + 1]
            }
            _ => self.width[self.line[brace]] + 1,
        }
    }

    /// The first token of the statement whose block a brace opens: its line, or an earlier one if
    /// the head is wrapped.
    fn head(&self, brace: usize) -> usize {
        let body = self.body(brace);
        let is_brace = |at: usize| matches!(self.item[at].kind, T::LeftBrace | T::RightBrace);
        let mut head = self.line[brace];
        while head > 0 && self.width[head] >= body && !is_brace(head) && !is_brace(head - 1) {
            head = self.line[head - 1];
        }
        head
    }
}

fn open_braces(tokens: &[Token]) -> Vec<Option<usize>> {
    let mut open: Vec<usize> = Vec::new();
    let mut before = Vec::with_capacity(tokens.len() + 1);
    for (at, token) in tokens.iter().enumerate() {
        before.push(open.last().copied());
        match token.kind {
            T::LeftBrace => open.push(at),
            T::RightBrace => {
                open.pop();
            }
            _ => {}
        }
    }
    before.push(open.last().copied());
    before
}
