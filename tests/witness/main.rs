//! The counterexamples of rejected operations.

#[path = "../pages/mod.rs"]
mod pages;

mod mutants;
mod page;
