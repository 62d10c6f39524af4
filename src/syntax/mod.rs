//! From text to tree: a lexer that keeps comments, and a parser that recovers from errors.
//!
//! `parse` never fails: it returns a tree of what could be read, the tokens and comments for a
//! formatter, and a diagnostic for everything else. It deals with syntax only; `resolve` determines
//! the meaning.

mod token;

pub mod text;

mod lex;

pub mod tree;

mod head;

mod parts;

pub mod foreign_syntax;

mod parse;

pub use foreign_syntax::written_elsewhere;
pub use head::place_of_use;
pub use lex::{Comment, CommentKind, Lexed, lex};
pub use parse::{Parsed, parse};
pub use parts::Part;
pub use token::{Token, TokenKind};

/// True if a text can be a name.
pub fn is_name(text: &str) -> bool {
    let tokens = lex(Default::default(), text).tokens;
    matches!(tokens.as_slice(), [only] if only.kind.is_name() && only.span.range() == (0..text.len()))
}
