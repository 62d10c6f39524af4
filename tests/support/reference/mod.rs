//! A slow and literal reading of the language's page: what a drawing matches, and what its
//! rewrite does. It shares nothing with the checker and the machine but the data of a rule
//! and the mesh, searches where they compute, and never asks whether an op is sound.

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
