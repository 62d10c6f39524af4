//! The counterexamples of rejected operations, and the arguments for proved ones.

mod confirmed;
mod files;
mod mutants;
mod page;
mod smallest;
