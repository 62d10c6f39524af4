//! Emitted code, compiled and run against the machine: the same result up to renumbering, and
//! the same refusals, at places of many small meshes; and, in every style and with every reserved
//! word as a name, handed to compilers.
//!
//! The C++ is compiled with `g++` against two small mesh classes, one with fields and one with
//! accessors, the Rust with `rustc` against the library as it was built for the tests. A few
//! operations are committed as they are emitted, to be read; `UPDATE=1` writes them anew.

mod compiled;
mod cpp;
mod everything;
mod golden;
mod headers;
mod rust;
mod told;
