//! Emitted code, compiled, run and compared with the machine: the same result up to renumbering,
//! and the same refusals, at places of many small meshes; and compiled in every style and with
//! every reserved word as a name.
//!
//! The C++ is compiled with `g++` against two small mesh classes, one with fields and one with
//! accessors, the Rust with `rustc` against the library as built for the tests. The emitted code of
//! a few operations is committed, to be read; `UPDATE=1` rewrites it.

mod compiled;
mod cpp;
mod everything;
mod golden;
mod headers;
mod members;
mod rust;
mod told;
