//! Code shared by the tests: random numbers, small meshes, pages, and a literal reference
//! implementation of the language, with which tests compare the checker and the machine.

pub mod dice;
pub mod emission;
pub mod engines;
pub mod guarded;
pub mod meshes;
pub mod pages;
pub mod reference;

pub use hedgerow;
