//! Patterns over tokens, written as text.
//!
//! A pattern is a list of elements separated by spaces:
//!
//! | element | stands for |
//! | --- | --- |
//! | `face`, `del/remove` | a token with this spelling, or one of several |
//! | `$a` | a name, optionally with a subscript |
//! | `$a=(/,` | a token with one of these spellings, kept |
//! | `$a:word` | a name or a keyword |
//! | `$a:verb` | the same, but not `if` |
//! | `$a:vertex` | a name that stands for a vertex in a loop somewhere in the item |
//! | `$a:rim` | a name that a statement `hole` or `loop` has in the item, or unlike `f0` |
//! | `$a:variable` | the name of a variable of a block around |
//! | `$a:type` | the name of a type, also in another language or a mesh library |
//! | `$a:kind` | the same, of an element |
//! | `$a:text` | a text in quotes |
//! | `$a:number` | a number |
//! | `$a:names` | zero or more names, optionally separated by commas |
//! | `$a:part` | anything on the line with balanced brackets, up to what follows |
//! | `$a:some` | the same, at least one token |
//! | `$a:line` | the same, up to the end of the statement |
//! | `$a:apart` | all that is left of the line of text, apart from what stands before it |
//! | `$a:prose` | the same, if it begins with two words |
//! | `$a:plain` | the same, without the arrow of a path |
//! | `$a:inside` | the same over several lines: the contents of brackets |
//! | `$a:value` | a part of at least one token, without braces, statements and a sign at its end |
//! | `$a:whole` | a value as far as it goes on, with a statement or nothing behind it |
//! | `$a:bound` | the same, at least one token, without commas and conditions |
//! | `$a:place` | a name with what is read behind it, `v.position.x` |
//! | `$a:owner` | the same, or with what is called behind it, before what is read or called last |
//! | `$a:operand` | a number, or a name with what is read and called behind it |
//! | `$a:exponent` | the same, without a power behind it |
//! | `$a:degree` | the same, beginning with a number |
//! | `$i:next` | a step of what `$i` stands for by one: `i++` |
//! | `@` | `$b`, what can stand before a value |
//! | `$:end` | nothing, at the end of a line or before the next statement of a drawing |
//! | `$:sign` | nothing, before a sign with which the value before it would go on |
//!
//! With `~` before it, an element touches the previous one; with `_`, it is on the same line. A
//! pattern that begins with `^` matches only where a statement begins. A hole that occurs again
//! stands for the same text.

use super::place::{Item, goes_on};
use super::types::{is_element, is_type};
use super::value::{is_of_statement, operand_end, owner_ends, place_end, whole_end};
use crate::syntax::token::{Token, TokenKind as T};
use std::ops::Range;

/// The element `@`.
const BEFORE_VALUE: &str = "$b=(/,/=/+/-/{/}/return/not/and/or/if/while/where/by/require/print/assert/else/</>/<=/>=/==/!=";

/// The maximum number of tokens of a hole.
const LONGEST: usize = 400;

/// A parsed pattern.
#[derive(Debug)]
pub(super) struct Pattern {
    begins: bool,
    pub elements: Vec<Element>,
}

#[derive(Debug)]
pub(super) struct Element {
    touches: bool,
    same_line: bool,
    pub what: What,
}

/// The meaning of an element.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum What {
    /// A token with one of these spellings.
    Written(Vec<&'static str>),
    /// A hole: tokens that can be referred to by a name.
    Hole(&'static str, Class),
}

/// The class of a hole.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Class {
    Name,
    OneOf(Vec<&'static str>),
    Word,
    Verb,
    Number,
    Vertex,
    Rim,
    Variable,
    Type,
    Kind,
    Text,
    Names,
    Part,
    Some,
    Line,
    Apart,
    Prose,
    Plain,
    Inside,
    Value,
    Whole,
    Bound,
    Place,
    Owner,
    Operand,
    Exponent { is_number: bool },
    Next,
    End,
    Sign,
}

impl Pattern {
    /// Parses a pattern.
    pub(super) fn of(written: &'static str) -> Self {
        let (begins, written) = without_mark(written, '^');
        Self { begins, elements: written.split_whitespace().map(Element::of).collect() }
    }

    /// The spellings of the tokens with which it begins; `None` if there are others.
    pub(super) fn first_words(&self) -> Option<&[&'static str]> {
        match &self.elements.first()?.what {
            What::Written(words) | What::Hole(_, Class::OneOf(words)) => Some(words),
            What::Hole(..) => None,
        }
    }

    /// The tokens of each element, if the pattern matches at a token; `begins` is true if a
    /// statement can begin there.
    pub(super) fn matched(
        &self,
        item: &Item,
        at: usize,
        begins: bool,
    ) -> Option<Vec<Range<usize>>> {
        if self.begins && !begins {
            return None;
        }
        // Most patterns fail at their first element: nothing is allocated for them.
        let mut found = Vec::new();
        rest_matches(&self.elements, item, at, &mut found).then_some(found)
    }
}

impl Element {
    fn of(written: &'static str) -> Self {
        let written = if written == "@" { BEFORE_VALUE } else { written };
        let (touches, written) = without_mark(written, '~');
        let (same_line, written) = without_mark(written, '_');
        let what = match written.strip_prefix('$') {
            Some(hole) => hole_of(hole),
            None => What::Written(ways(written)),
        };
        Self { touches, same_line, what }
    }

    fn hole(&self) -> Option<&'static str> {
        match self.what {
            What::Hole(name, _) => Some(name),
            What::Written(_) => None,
        }
    }
}

/// Whether a mark stands before a pattern or an element, and what is marked.
fn without_mark(written: &'static str, mark: char) -> (bool, &'static str) {
    match written.strip_prefix(mark) {
        Some(rest) if !rest.is_empty() => (true, rest),
        _ => (false, written),
    }
}

fn hole_of(written: &'static str) -> What {
    if let Some((name, of)) = written.split_once('=') {
        return What::Hole(name, Class::OneOf(ways(of)));
    }
    let (name, class) = written.split_once(':').unwrap_or((written, "name"));
    let class = match class {
        "word" => Class::Word,
        "verb" => Class::Verb,
        "number" => Class::Number,
        "vertex" => Class::Vertex,
        "rim" => Class::Rim,
        "variable" => Class::Variable,
        "type" => Class::Type,
        "kind" => Class::Kind,
        "text" => Class::Text,
        "names" => Class::Names,
        "part" => Class::Part,
        "some" => Class::Some,
        "line" => Class::Line,
        "apart" => Class::Apart,
        "prose" => Class::Prose,
        "plain" => Class::Plain,
        "inside" => Class::Inside,
        "value" => Class::Value,
        "whole" => Class::Whole,
        "bound" => Class::Bound,
        "place" => Class::Place,
        "owner" => Class::Owner,
        "operand" => Class::Operand,
        "exponent" => Class::Exponent { is_number: false },
        "degree" => Class::Exponent { is_number: true },
        "next" => Class::Next,
        "end" => Class::End,
        "sign" => Class::Sign,
        _ => Class::Name,
    };
    What::Hole(name, class)
}

/// The spellings in `a/b`; a slash is alone or the last of several, `+/-//`.
fn ways(written: &'static str) -> Vec<&'static str> {
    match written.strip_suffix("//") {
        Some(others) => others.split('/').chain(["/"]).collect(),
        None if written == "/" => vec![written],
        None => written.split('/').collect(),
    }
}

/// True if the elements that are not found yet match from a token on; the tokens of each are added
/// to `found`.
fn rest_matches(
    elements: &[Element],
    item: &Item,
    at: usize,
    found: &mut Vec<Range<usize>>,
) -> bool {
    let known = found.len();
    let Some(element) = elements.get(known) else { return true };
    if element.touches && !item.touches(at) {
        return false;
    }
    if element.same_line && item.ends_line(at) {
        return false;
    }
    let same = elements[..known].iter().position(|other| other.hole() == element.hole());
    let same = element.hole().and(same).map(|first| item.slice(found[first].clone()));
    for end in ends(&element.what, item, at, same) {
        found.push(at..end);
        if rest_matches(elements, item, end, found) {
            return true;
        }
        found.truncate(known);
    }
    false
}

/// The possible ends of an element that begins at a token, in the order in which they are tried;
/// `same` is the text of an earlier hole of its name.
fn ends(what: &What, item: &Item, at: usize, same: Option<&str>) -> Vec<usize> {
    if let (What::Hole(_, Class::Next), Some(name)) = (what, same) {
        return next_end(item, at, name).into_iter().collect();
    }
    let mut ends = all_ends(what, item, at);
    ends.retain(|&end| same.is_none_or(|same| item.slice(at..end) == same));
    ends
}

fn all_ends(what: &What, item: &Item, at: usize) -> Vec<usize> {
    let kind = item.kind(at);
    let one = |is: bool| if is { vec![at + 1] } else { Vec::new() };
    let named = |is: bool| item.name_end(at).filter(|_| is).into_iter().collect();
    match what {
        What::Written(ways) => one(kind.is_some() && ways.contains(&item.word(at))),
        What::Hole(_, class) => match class {
            Class::OneOf(ways) => one(kind.is_some() && ways.contains(&item.word(at))),
            Class::Name => named(true),
            Class::Vertex => named(item.is_vertex(item.word(at))),
            Class::Rim => named(item.is_rim(item.word(at))),
            Class::Variable => named(item.is_variable(at)),
            Class::Type => one(is_type(item.word(at))),
            Class::Kind => one(is_element(item.word(at))),
            Class::Verb => one(kind.is_some_and(|kind| kind.is_wordlike() && kind != T::If)),
            Class::Word => one(kind.is_some_and(T::is_wordlike)),
            Class::Number => one(matches!(kind, Some(T::Int | T::Real))),
            Class::Text => text_end(item, at).into_iter().collect(),
            Class::Names => names_ends(item, at),
            Class::Part => paired(item, at, |end| item.ends_line(end)),
            Class::Some => {
                let ends = paired(item, at, |end| item.ends_line(end));
                ends.into_iter().filter(|&end| end > at).collect()
            }
            Class::Line => {
                // A value goes on behind an operator, on whichever line it stands.
                let is_operator = |at: usize| {
                    item.kind(at).is_some_and(|kind| {
                        kind == T::Star || goes_on(kind) && kind != T::LeftParen
                    })
                };
                let continues = |end: usize| {
                    is_operator(end) && !item.is_step(end)
                        || end.checked_sub(1).is_some_and(is_operator)
                };
                let is_over =
                    |end| item.begins_comment(end) || item.ends_line(end) && !continues(end);
                paired(item, at, is_over).last().copied().into_iter().collect()
            }
            Class::Apart | Class::Prose => {
                let is_word = |at: usize| item.kind(at).is_some_and(T::is_wordlike);
                let is_prose = is_word(at) && is_word(at + 1) && !item.ends_text_line(at + 1);
                let fits = !item.touches(at) && (*class == Class::Apart || is_prose);
                (at..).find(|&end| item.ends_text_line(end)).filter(|_| fits).into_iter().collect()
            }
            Class::Plain => {
                let line = paired(item, at, |end| item.ends_line(end)).pop();
                let is_plain =
                    |end: &usize| (at..*end).all(|at| item.kind(at) != Some(T::FatArrow));
                line.filter(is_plain).into_iter().collect()
            }
            Class::Inside => paired(item, at, |_| false),
            Class::Value => {
                let mut ends = paired(item, at, |end| {
                    let is_over = |kind| kind == T::LeftBrace || is_of_statement(kind);
                    item.ends_line(end) || item.kind(end).is_some_and(is_over)
                });
                let is_sign = |kind: T| kind == T::Star || goes_on(kind);
                ends.retain(|&end| end > at && !item.kind(end - 1).is_some_and(is_sign));
                ends
            }
            Class::Whole => whole_end(item, at).into_iter().collect(),
            Class::Bound => {
                let ends = paired(item, at, |end| item.ends_line(end));
                let is_bound = |end: &usize| (at..*end).all(|at| !decides(item.word(at)));
                ends.into_iter().filter(|&end| end > at).take_while(is_bound).collect()
            }
            Class::Place => place_end(item, at).into_iter().collect(),
            Class::Owner => owner_ends(item, at),
            Class::Operand => operand_end(item, at).into_iter().collect(),
            Class::Exponent { is_number } => {
                let is_last = |&end: &usize| {
                    item.word(end) != "^" && [end, end + 1].map(|at| item.word(at)) != ["*", "*"]
                };
                let is_meant = !is_number || matches!(kind, Some(T::Int | T::Real));
                operand_end(item, at).filter(is_last).filter(|_| is_meant).into_iter().collect()
            }
            Class::Next => Vec::new(),
            Class::End => {
                // The head of a loop goes on with its condition, on whichever line that stands.
                let ends = item.ends_line(at) && item.kind(at) != Some(T::Where)
                    || item.begins_drawing_statement(at);
                ends.then_some(at).into_iter().collect()
            }
            Class::Sign => {
                let goes_on = matches!(item.word(at), "-" | "+" | "(");
                goes_on.then_some(at).into_iter().collect()
            }
        },
    }
}

/// True if a word separates values, compares or combines conditions.
fn decides(word: &str) -> bool {
    let signs = [",", "|", "&", "&&", "?", "=", "==", "!=", "<", "<=", ">", ">="];
    signs.contains(&word) || matches!(word, "and" | "or")
}

/// The end of a step of a name by one.
fn next_end(item: &Item, at: usize, name: &str) -> Option<usize> {
    let steps: [&[&str]; 4] = [
        &[name, "+", "+"],
        &["+", "+", name],
        &[name, "+", "=", "1"],
        &[name, "=", name, "+", "1"],
    ];
    let is_here = |step: &&[&str]| (at..).zip(*step).all(|(at, word)| item.word(at) == *word);
    steps.into_iter().find(is_here).map(|step| at + step.len())
}

fn text_end(item: &Item, at: usize) -> Option<usize> {
    match item.kind(at)? {
        T::Text => Some(at + 1),
        T::TextHead => {
            let tail = (at..at + LONGEST).find(|&at| item.kind(at) == Some(T::TextTail))?;
            Some(tail + 1)
        }
        _ => None,
    }
}

fn names_ends(item: &Item, at: usize) -> Vec<usize> {
    let mut ends = vec![at];
    let mut end = at;
    while end < at + LONGEST {
        match item.name_end(end) {
            Some(next) => end = next,
            None if item.kind(end) == Some(T::Comma) && end > at => end += 1,
            None => break,
        }
        ends.push(end);
    }
    ends
}

/// The possible ends of a run of tokens with balanced brackets that begins at a token, nearest
/// first, up to a token for which `over` holds.
pub(super) fn paired(item: &Item, at: usize, over: impl Fn(usize) -> bool) -> Vec<usize> {
    let mut ends = vec![at];
    let mut depth = 0_usize;
    for end in at..at + LONGEST {
        let Some(Token { kind, .. }) = item.token(end) else { break };
        if depth == 0 && over(end) {
            break;
        }
        match kind {
            T::LeftParen | T::LeftBrace | T::LeftBracket => depth += 1,
            T::RightParen | T::RightBrace | T::RightBracket if depth == 0 => break,
            T::RightParen | T::RightBrace | T::RightBracket => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            ends.push(end + 1);
        }
    }
    ends
}
