//! Text to tree: tokens, comments kept, a parser that recovers.

pub mod tree;
