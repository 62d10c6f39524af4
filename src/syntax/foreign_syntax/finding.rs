//! Foreign syntax that was found in one place.

use super::pattern::{Class, What};
use super::place::{CODE, HEAD, Item, PARAMETERS};
use super::table::{Form, Piece};
use super::types::type_meant;
use super::value::operand_end;
use crate::diagnostic::Edit;
use crate::source::Span;
use crate::syntax::token::{Token, TokenKind as T};
use std::ops::Range;

/// A piece of foreign syntax found in a text.
#[derive(Clone, Debug)]
pub struct Found {
    /// An identifier, so that the same form is reported once: a line of the table, a sign, or the
    /// place of a misspelt keyword.
    pub what: usize,
    /// The place that is reported.
    pub span: Span,
    /// The message.
    pub says: String,
    /// The edits that replace it, if the meaning is certain.
    pub edits: Option<Vec<Edit>>,
    /// True if the rest of the item may not be parsed as it was meant.
    pub ends: bool,
    /// The code of its error.
    pub code: &'static str,
}

impl Found {
    /// A slip of the pen at a place, in which other text is meant. Each is reported.
    pub(in crate::syntax) fn slip(span: Span, says: String, text: String) -> Self {
        Self {
            what: usize::MAX / 2 + span.start as usize,
            span,
            says,
            edits: Some(vec![Edit { span, text }]),
            ends: false,
            code: "syntax-error",
        }
    }
}

/// A match of a pattern of the table.
pub(super) struct Match<'t, 'i> {
    pub form: &'static Form,
    pub item: &'i Item<'t>,
    /// The tokens of each element.
    pub parts: Vec<Range<usize>>,
}

impl<'t> Match<'t, '_> {
    fn hole(&self, name: &str) -> Option<Range<usize>> {
        let elements = &self.form.seen().elements;
        let at = elements
            .iter()
            .position(|element| matches!(&element.what, What::Hole(known, _) if *known == name))?;
        self.parts.get(at).cloned()
    }

    fn is_end(&self, at: usize) -> bool {
        let element = self.form.seen().elements.get(at);
        element.is_some_and(|of| matches!(of.what, What::Hole(_, Class::End)))
    }

    /// The range of all matched tokens.
    pub(super) fn all(&self) -> Range<usize> {
        let start = self.parts.first().map_or(0, |part| part.start);
        let end = self.parts.last().map_or(start, |part| part.end);
        start..end
    }

    /// A template with the holes filled in.
    fn filled(&self, pieces: &[Piece], template: &str) -> String {
        let (Some(first), Some(last)) = (pieces.first(), pieces.last()) else {
            return String::new();
        };
        let mut text = String::new();
        let mut at = first.place.start;
        let mut rest = pieces.iter();
        while let Some(piece) = rest.next() {
            text.push_str(template.get(at..piece.place.start).unwrap_or(""));
            at = piece.place.end;
            let Some(range) = piece.hole.and_then(|hole| self.hole(hole)) else {
                text.push_str(template.get(piece.place.clone()).unwrap_or(""));
                continue;
            };
            // An operand stands without parentheses.
            let bare = [" (", "-("].iter().any(|open| text.ends_with(open));
            let is_operand =
                range.len() == 1 || operand_end(self.item, range.start) == Some(range.end);
            if bare && is_operand && template[at..].starts_with(')') {
                text.pop();
                at = rest.next().map_or(at, |closing| closing.place.end);
            }
            text.push_str(self.text(piece.hole, range));
        }
        text.push_str(template.get(at..last.place.end).unwrap_or(""));
        text
    }

    /// The text of a hole; a foreign type is translated.
    fn text(&self, hole: Option<&str>, range: Range<usize>) -> &'t str {
        hole.and_then(|hole| self.renamed(hole, range.clone())).unwrap_or(self.item.slice(range))
    }

    /// The name in this language of a foreign type in a hole, in the head of an item or in a block.
    fn renamed(&self, hole: &str, range: Range<usize>) -> Option<&'static str> {
        let is_type = hole == "t" && matches!(self.form.place, HEAD | PARAMETERS | CODE);
        is_type.then(|| type_meant(self.item.slice(range)))?
    }

    /// The number of elements and pieces that agree at the front, and at the back.
    fn shared(&self, pieces: &[Piece]) -> (usize, usize) {
        let elements = &self.form.seen().elements;
        let count = elements.len() - usize::from(self.is_end(elements.len().wrapping_sub(1)));
        let same = |element: usize, piece: usize| match (&elements[element].what, &pieces[piece]) {
            // A foreign type is replaced.
            (What::Hole(hole, _), piece) => {
                piece.hole == Some(*hole)
                    && self.renamed(hole, self.parts[element].clone()).is_none()
            }
            (What::Written(ways), piece) => {
                piece.hole.is_none() && matches!(ways.as_slice(), [only] if *only == piece.word)
            }
        };
        let most = count.min(pieces.len());
        let front = (0..most).take_while(|&at| same(at, at)).count();
        let back =
            (0..most - front).take_while(|&at| same(count - 1 - at, pieces.len() - 1 - at)).count();
        (front, back)
    }

    /// The part that differs, and the edit that corrects it.
    fn difference(&self, pieces: &[Piece], template: &str) -> (Span, Edit) {
        let elements = self.form.seen().elements.len();
        let count = elements - usize::from(self.is_end(elements.wrapping_sub(1)));
        let (front, back) = self.shared(pieces);
        let text = folded(self.filled(&pieces[front..pieces.len() - back], template));
        let tokens = self.parts[front..count - back].iter().cloned();
        let tokens = tokens.filter(|range| !range.is_empty());
        let (first, last) = tokens.fold((usize::MAX, 0), |(first, last), range| {
            (first.min(range.start), last.max(range.end))
        });
        let token = |at: usize| self.item.token(at).map(|token| token.span);
        match (token(first), last.checked_sub(1).and_then(token)) {
            (Some(first), Some(last)) => {
                let span = first.to(last);
                (span, self.spaced(Edit { span, text }))
            }
            _ => {
                // Something is only missing: it is inserted after the part that agrees, or before
                // everything.
                if front == 0 {
                    let span = token(self.all().start).unwrap_or_default();
                    return (span, self.spaced(Edit { span: span.before(), text }));
                }
                let before = self.parts[..front].iter().map(|range| range.end).max();
                let before = before.and_then(|end| end.checked_sub(1)).and_then(token);
                let span = before.unwrap_or_default();
                (span, self.spaced(Edit { span: span.after(), text }))
            }
        }
    }

    /// Adds spaces to an edit where it would merge with the text next to it, and takes those before a
    /// colon.
    fn spaced(&self, edit: Edit) -> Edit {
        let Edit { span, mut text } = edit;
        let (before, behind) = self.item.around(span.start, span.end);
        let is_word = |c: char| c.is_alphanumeric() || matches!(c, '_' | '"' | '\'');
        let ends = |text: &str| text.chars().next_back().is_some_and(|c| is_word(c) || c == ')');
        let begins = |text: &str| text.chars().next().is_some_and(is_word);
        let apart = begins(&text) || text.starts_with(['{', '=', '!']) || text.starts_with("//");
        let is_step = before.ends_with("++") || before.ends_with("--");
        let is_head = before.ends_with(':') && !before.ends_with("::") && begins(&text);
        if (ends(before) || is_step) && (apart || before.ends_with(')') && text.starts_with('-'))
            || is_head
        {
            text.insert(0, ' ');
        }
        if ends(&text) && (begins(behind) || behind.starts_with(['=', '|'])) {
            text.push(' ');
        }
        let blanks = before.len() - before.trim_end_matches(' ').len();
        let blanks = if text.starts_with(':') { blanks as u32 } else { 0 };
        Edit { span: Span { start: span.start - blanks, ..span }, text }
    }

    /// The tokens that replace the matched ones.
    pub(super) fn written(&self) -> Vec<Token> {
        let kept: Vec<&str> = self.form.ours().iter().filter_map(|piece| piece.hole).collect();
        let elements = self.form.seen().elements.iter().zip(&self.parts);
        // New tokens take the spans of tokens that are not kept.
        let places = elements
            .filter(
                |(element, _)| !matches!(element.what, What::Hole(name, _) if kept.contains(&name)),
            )
            .flat_map(|(_, range)| self.item.tokens[range.clone()].iter().map(|token| token.span));
        let mut places = places.peekable();
        let start = self.item.token(self.all().start).map(|token| token.span.before());
        let mut last = start.unwrap_or_default();
        let mut tokens = Vec::new();
        for piece in self.form.ours() {
            match piece.hole.and_then(|hole| self.hole(hole)) {
                Some(range) => tokens.extend_from_slice(&self.item.tokens[range]),
                None => {
                    let place =
                        std::iter::from_fn(|| places.next_if(|place| place.start < last.end));
                    place.for_each(drop);
                    let span = places.next().unwrap_or(last.after());
                    tokens.push(Token { kind: piece.kind, span });
                }
            }
            last = tokens.last().map_or(last, |token| token.span);
        }
        tokens
    }

    /// The finding with its message.
    pub(super) fn found(&self, what: usize) -> Found {
        let (pieces, template) = self.form.fix();
        let (span, edit) = self.difference(pieces, template);
        let first = self.item.token(self.all().start);
        let seen = self.seen_word();
        let says = self.form.says.replace("{}", seen);
        let says = self.form.holes_of_says().fold(says, |says, hole| {
            let range = self.hole(hole).unwrap_or_default();
            says.replace(&format!("${hole}"), self.text(Some(hole), range))
        });
        Found {
            what,
            span,
            says,
            edits: self.form.is_sure().then(|| vec![edit]),
            ends: self.form.ends(),
            code: match first.is_some_and(|token| token.kind == T::Foreign) {
                true => "unknown-character",
                false => "syntax-error",
            },
        }
    }

    /// The text matched by the first literal element of the pattern.
    fn seen_word(&self) -> &'t str {
        let elements = self.form.seen().elements.iter().zip(&self.parts);
        let mut literal = elements.filter(|(element, _)| matches!(element.what, What::Written(_)));
        literal.next().map_or("", |(_, range)| self.item.slice(range.clone()))
    }
}

/// The text of a range or its end, with `11` in place of `10 + 1`.
fn folded(text: String) -> String {
    let next = || {
        let end = text.strip_suffix(" + 1")?;
        let before = end.trim_end_matches(|c: char| c.is_ascii_digit());
        let next = end[before.len()..].parse::<i64>().ok()?.checked_add(1)?;
        (before.is_empty() || before.ends_with("..")).then(|| format!("{before}{next}"))
    };
    next().unwrap_or(text)
}
