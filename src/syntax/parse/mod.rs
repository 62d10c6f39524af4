//! From tokens to tree.
//!
//! A file is first cut into items by their keywords alone, and the depth of each is measured; then
//! the grammar parses one item at a time. So a broken item does not affect others, nesting cannot
//! overflow the stack, and the time is linear in the text. Within an item, a statement that cannot
//! be read is skipped and becomes `Broken` in the tree. Where one wrong or missing token is all that
//! is in the way, it is put right first, so that it is the only error.

mod file;

mod cut;
mod depth;

mod item;

mod drawing;

mod action;

mod expression;

mod name;

mod text;

mod recover;

mod failure;

mod report;

mod unclosed;

mod leftover;

mod slip;

mod foreign_syntax;

mod certain;

mod input;

pub use file::{Parsed, parse};
