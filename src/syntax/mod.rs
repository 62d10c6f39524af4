//! Text to tree: tokens, comments kept, a parser that recovers.
//!
//! `parse` never fails: it answers with a tree of what could be read, the tokens and
//! comments for a formatter, and a diagnostic for everything else. It knows how things are
//! written and nothing of what they mean; `resolve` takes it from there.

mod token;

pub mod text;

mod lex;

pub mod tree;

mod parts;

mod shift;

pub mod foreign_syntax;

mod parse;

pub use foreign_syntax::written_elsewhere;
pub use lex::{Comment, CommentKind, Lexed, lex};
pub use parse::{Parsed, parse, parse_again};
pub use parts::Part;
pub use token::{Token, TokenKind};
