//! Code shared by the tests: random numbers, small meshes, pages, and a literal reading of the
//! language that tests hold the checker and the machine against.

pub mod dice;
pub mod emission;
pub mod engines;
pub mod guarded;
pub mod meshes;
pub mod pages;
pub mod reference;

pub use {glam, hedgerow};
