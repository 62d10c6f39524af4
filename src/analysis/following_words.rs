//! The words that alone can follow a name or a value: `in`, `where`, `by`, `else`.

use crate::syntax::{Token, TokenKind as T};

/// The words that can follow the tokens of an item, if nothing else can; `on_line` if the line has
/// not ended behind them.
pub(super) fn following(tokens: &[Token], on_line: bool) -> Option<&'static [&'static str]> {
    let last = tokens.len().checked_sub(1)?;
    let begins_loop = |kind| matches!(kind, T::For | T::Drain | T::Update);
    if tokens[last].kind == T::Word && kind(tokens, last.checked_sub(1)?).is_some_and(begins_loop) {
        return Some(&["in"]);
    }
    if !kind(tokens, last).is_some_and(ends_value) {
        return None;
    }
    let mut closed = 0_usize;
    for at in (0..=last).rev() {
        let here = kind(tokens, at)?;
        let begins = closed == 0 && kind(tokens, at + 1).is_some_and(begins_value);
        match here {
            // Two values in a row: another statement has begun.
            _ if begins && ends_value(here) => return None,
            T::RightParen => closed += 1,
            T::LeftParen => closed = closed.checked_sub(1)?,
            _ if closed > 0 => {}
            T::In => {
                return match kind(tokens, at.checked_sub(2)?)? {
                    T::Drain => Some(&["by"]),
                    T::For | T::Update => Some(&["where"]),
                    _ => None,
                };
            }
            T::By => return Some(&["while", "div", "mod"]),
            T::Where | T::While | T::If => return Some(&["and", "or", "div", "mod"]),
            T::Require | T::Assert => {
                return on_line.then_some(&["and", "or", "div", "mod", "else"]);
            }
            _ if !goes_on(here) => return None,
            _ => {}
        }
    }
    None
}

/// The kind of a token; a field that is called as a keyword, `h.vertex`, is a word.
fn kind(tokens: &[Token], at: usize) -> Option<T> {
    let here = tokens.get(at)?.kind;
    let is_field = at > 0 && tokens[at - 1].kind == T::Dot && here.is_wordlike();
    Some(if is_field { T::Word } else { here })
}

fn ends_value(kind: T) -> bool {
    let is_number = matches!(kind, T::Int | T::Real | T::True | T::False);
    is_number || matches!(kind, T::Word | T::RightParen | T::RightBracket)
}

fn begins_value(kind: T) -> bool {
    matches!(kind, T::Word | T::Int | T::Real | T::True | T::False | T::Not | T::Can | T::Must)
}

/// True if a token may be inside of a value.
fn goes_on(kind: T) -> bool {
    ends_value(kind)
        || begins_value(kind)
        || matches!(kind, T::And | T::Or | T::Div | T::Mod | T::Why)
        || matches!(kind, T::Dot | T::DotDot | T::DoubleColon | T::LeftBracket)
        || matches!(kind, T::Plus | T::Minus | T::Star | T::Slash)
        || matches!(kind, T::Equal | T::NotEqual | T::Less | T::LessEqual)
        || matches!(kind, T::Greater | T::GreaterEqual)
}
