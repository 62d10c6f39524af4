//! The counterexamples of rejected operations, and the arguments for proved ones.

#[path = "../pages/mod.rs"]
mod pages;
#[path = "../reference/mod.rs"]
mod reference;

mod confirmed;
mod files;
mod mutants;
mod page;
