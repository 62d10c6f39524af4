//! The words that can follow a name or a value: `in`, `where`, `by`, `else`, `and`.

use super::cursor_context::Gap;
use super::snapshot::Snapshot;
use crate::resolve::signatures;
use crate::syntax::{Token, TokenKind as T};

/// The words that can follow a name or a value.
pub(super) enum Following {
    /// Nothing else can follow.
    Only(&'static [&'static str]),
    /// Something else can follow, too.
    Also(&'static [&'static str]),
}

/// The operators that are words.
const OPERATORS: &[&str] = &["and", "div", "mod", "or"];

/// The words that can follow the tokens of an item, before a gap; `in_block` is true where a
/// statement can be a value.
pub(super) fn following(
    snapshot: &Snapshot,
    tokens: &[Token],
    gap: Gap,
    in_block: bool,
) -> Option<Following> {
    use Following::{Also, Only};
    let last = tokens.len().checked_sub(1)?;
    let begins_loop = |kind| matches!(kind, T::For | T::Drain | T::Update);
    if tokens[last].kind == T::Word && kind(tokens, last.checked_sub(1)?).is_some_and(begins_loop) {
        return Some(Only(&["in"]));
    }
    if tokens[last].kind == T::RightBrace {
        return behind_block(tokens);
    }
    if !kind(tokens, last).is_some_and(ends_value) {
        return None;
    }
    let alone = || (in_block && gap != Gap::LineEnd).then_some(Also(OPERATORS));
    let mut closed = 0_usize;
    let mut is_first = true;
    for at in (0..=last).rev() {
        let here = kind(tokens, at)?;
        match here {
            _ if closed == 0 && begins_statement(tokens, at + 1) => return alone(),
            T::RightParen | T::TextTail => closed += 1,
            T::LeftParen if closed == 0 => return in_parens(snapshot, &tokens[..at], is_first),
            T::TextHead | T::TextMiddle if closed == 0 => return Some(Only(OPERATORS)),
            T::LeftParen | T::TextHead => closed -= 1,
            _ if closed > 0 => {}
            T::Comma => is_first = false,
            T::In => {
                return match kind(tokens, at.checked_sub(2)?)? {
                    T::Drain => Some(Only(&["by"])),
                    T::For | T::Update => Some(Only(&["where"])),
                    _ => None,
                };
            }
            T::By => return Some(Only(&["while", "div", "mod"])),
            T::Where | T::While | T::If => return Some(Only(OPERATORS)),
            T::Require | T::Assert => {
                return Some(match gap {
                    Gap::LineEnd => Also(&["and", "or", "else"]),
                    _ => Only(&["and", "or", "div", "mod", "else"]),
                });
            }
            T::Equals if asks(tokens, at) => return None,
            T::Equals | T::Print | T::Return => {
                return Some(Also(match gap {
                    Gap::LineEnd => &["and", "or"],
                    _ => OPERATORS,
                }));
            }
            T::LeftBrace | T::RightBrace => return alone(),
            _ if !goes_on(here) => return None,
            _ => {}
        }
    }
    None
}

/// `else`, if some tokens end with the block of an `if`: nothing else, if that is a value.
fn behind_block(tokens: &[Token]) -> Option<Following> {
    let mut at = opening(tokens)?;
    loop {
        at = at.checked_sub(1)?;
        match kind(tokens, at)? {
            T::If => break,
            T::RightParen | T::TextTail => at = opening(tokens.get(..=at)?)?,
            T::Let | T::Equals | T::Must => {}
            here if !goes_on(here) => return None,
            _ => {}
        }
    }
    let before = at.checked_sub(1).and_then(|before| kind(tokens, before));
    let is_statement = before.is_some_and(|before| ends_statement(before) || before == T::Else);
    Some(if is_statement { Following::Also(&["else"]) } else { Following::Only(&["else"]) })
}

/// True if an `=` belongs to an `if let`.
fn asks(tokens: &[Token], equals: usize) -> bool {
    let before = |back| equals.checked_sub(back).and_then(|at| kind(tokens, at));
    before(2) == Some(T::Let) && before(3) == Some(T::If)
}

/// The bracket, or the head of a text, that the last of some tokens closes.
pub(super) fn opening(tokens: &[Token]) -> Option<usize> {
    let mut open = 0_usize;
    tokens.iter().rposition(|token| {
        match token.kind {
            T::RightParen | T::RightBracket | T::RightBrace | T::TextTail => open += 1,
            T::LeftParen | T::LeftBracket | T::LeftBrace | T::TextHead => {
                open = open.saturating_sub(1);
            }
            _ => {}
        }
        open == 0
    })
}

/// The words that can follow an argument in the parentheses behind some tokens: `for` only the first
/// one, of a function that takes a value for each element of a sequence.
fn in_parens(snapshot: &Snapshot, tokens: &[Token], is_first: bool) -> Option<Following> {
    if let [.., item, _] = tokens
        && matches!(item.kind, T::Op | T::Script | T::Fn)
    {
        return None; // parameters
    }
    let function = tokens.last().map_or("", |name| snapshot.sources().slice(name.span));
    let mut ways = signatures(function).into_iter().flat_map(|way| way.takes);
    Some(Following::Only(match is_first && ways.any(|takes| takes.contains(" for ")) {
        true => &["and", "div", "for", "mod", "or"],
        false => OPERATORS,
    }))
}

/// The kind of a token; a field that is called as a keyword, `h.vertex`, is a word.
pub(super) fn kind(tokens: &[Token], at: usize) -> Option<T> {
    let here = tokens.get(at)?.kind;
    let is_field = at > 0 && tokens[at - 1].kind == T::Dot && here.is_wordlike();
    Some(if is_field { T::Word } else { here })
}

/// True if a value can end with a token.
pub(super) fn ends_value(kind: T) -> bool {
    let is_constant = matches!(kind, T::Int | T::Real | T::True | T::False | T::Text | T::TextTail);
    is_constant || matches!(kind, T::Word | T::RightParen | T::RightBracket)
}

/// True if the next token can begin a statement.
pub(super) fn ends_statement(kind: T) -> bool {
    ends_value(kind) || matches!(kind, T::LeftBrace | T::RightBrace | T::Break | T::Continue)
}

/// True if a token cannot continue the value before it: another statement has begun.
pub(super) fn begins_statement(tokens: &[Token], at: usize) -> bool {
    let before = at.checked_sub(1).and_then(|before| kind(tokens, before));
    before.is_some_and(ends_value) && kind(tokens, at).is_some_and(begins_value)
}

fn begins_value(kind: T) -> bool {
    matches!(kind, T::Word | T::Int | T::Real | T::True | T::False | T::Not | T::Can | T::Must)
}

/// True if a token may be inside of a value.
pub(super) fn goes_on(kind: T) -> bool {
    ends_value(kind)
        || begins_value(kind)
        || matches!(kind, T::And | T::Or | T::Div | T::Mod | T::Why)
        || matches!(kind, T::Dot | T::DotDot | T::DoubleColon | T::LeftBracket)
        || matches!(kind, T::Plus | T::Minus | T::Star | T::Slash)
        || matches!(kind, T::Equal | T::NotEqual | T::Less | T::LessEqual)
        || matches!(kind, T::Greater | T::GreaterEqual)
}
