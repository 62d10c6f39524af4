//! Tokens to tree.
//!
//! A file is first cut into items by their keywords alone, and the depth of each is
//! measured; then the grammar reads one item at a time. So a broken item harms no other,
//! nothing nests deeper than the stack allows, and the time is linear in the text. Within
//! an item, a statement that cannot be read is skipped and stands in the tree as `Broken`.

mod action;
mod cut;
mod depth;
mod drawing;
mod expression;
mod failure;
mod file;
mod input;
mod item;
mod name;
mod recover;
mod report;

pub use file::{Parsed, parse};
