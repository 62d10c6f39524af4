//! The counterexamples of rejected operations, and the arguments for proved ones.

#[path = "../pages/mod.rs"]
mod pages;

mod files;
mod mutants;
mod page;
