//! A slow and literal implementation of the language reference: what a drawing matches, and what
//! its rewrite does. It shares only the data of a rule and the mesh with the checker and the
//! machine, searches where they compute, and never checks whether an op is sound.

pub mod completion;
pub mod examples;
pub mod maps;
pub mod matching;
pub mod mutating;
pub mod mutating_families;
pub mod printing;
pub mod random;
pub mod rewriting;
pub mod same;
pub mod truth;
pub mod unrolling;
