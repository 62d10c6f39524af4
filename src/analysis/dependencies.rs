//! The errors that concern some items: their own, and those of the items that they name, directly or
//! through others.

use std::collections::HashMap;

use super::Analysis;
use super::files::touches;
use crate::diagnostic::Diagnostic;
use crate::source::{Sources, Span};
use crate::syntax::tree::Item;
use crate::syntax::{TokenKind, parse};

impl Analysis {
    /// The diagnostics without the errors of items on which those at some places do not depend, and
    /// the number of these errors.
    ///
    /// What is in no item that has a name, as a missing file, concerns all.
    pub fn concerning(&self, asked: &[Span], sources: &Sources) -> (Vec<Diagnostic>, usize) {
        if self.is_sound() {
            return (self.diagnostics.clone(), 0);
        }
        let parsed: Vec<_> =
            sources.ids().map(|file| parse(file, sources.get(file).text())).collect();
        let items: Vec<_> = parsed
            .iter()
            .flat_map(|file| file.tree.items.iter().map(move |item| (item, file)))
            .collect();
        let mut named: HashMap<&str, Vec<usize>> = HashMap::new();
        for (at, (item, _)) in items.iter().enumerate() {
            if let Some(name) = item.name() {
                named.entry(&name.text).or_default().push(at);
            }
        }
        let is_asked = |item: &Item| asked.iter().any(|&place| touches(item.span(), place));
        let mut is_needed: Vec<_> = items.iter().map(|(item, _)| is_asked(item)).collect();
        let mut open: Vec<_> = (0..items.len()).filter(|&at| is_needed[at]).collect();
        while let Some(at) = open.pop() {
            let (item, file) = items[at];
            let until = |end: u32| file.tokens.partition_point(|token| token.span.start < end);
            let tokens = &file.tokens[until(item.span().start)..until(item.span().end)];
            for (place, token) in tokens.iter().enumerate() {
                // An attribute is read behind a dot, everything else is called.
                let is_read = place > 0 && tokens[place - 1].kind == TokenKind::Dot;
                let next = tokens.get(place + 1).map(|next| next.kind);
                let is_meant = |at: usize| match items[at].0 {
                    Item::Attr(_) => is_read,
                    _ => next == Some(TokenKind::LeftParen),
                };
                let of_name = named.get(sources.slice(token.span)).into_iter().flatten();
                for &called in of_name.filter(|&&at| is_meant(at)) {
                    if !std::mem::replace(&mut is_needed[called], true) {
                        open.push(called);
                    }
                }
            }
        }
        let is_of_others = |told: &&Diagnostic| {
            let touched = |item: &Item| touches(item.span(), told.span());
            let mut own = (0..items.len()).filter(|&at| touched(items[at].0)).peekable();
            let is_other = |at: usize| {
                !is_needed[at] && !matches!(items[at].0, Item::Use(_) | Item::Broken(_))
            };
            told.is_error() && own.peek().is_some() && own.all(is_other)
        };
        let (others, concerning): (Vec<_>, Vec<_>) =
            self.diagnostics.iter().partition(is_of_others);
        (concerning.into_iter().cloned().collect(), others.len())
    }
}
