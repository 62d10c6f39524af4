//! Emitted code, compiled and run against the machine: the same result up to renumbering, and
//! the same refusals, at places of many small meshes.
//!
//! The C++ is compiled with `g++` against two small mesh classes, one with fields and one with
//! accessors. The Rust is committed as `emitted.rs`, so that it is compiled with the tests;
//! `UPDATE=1` writes it anew.

#[rustfmt::skip]
#[allow(clippy::all, unused_variables)]
mod emitted;

mod columns;
mod cpp;
mod everything;
#[path = "../reference/examples.rs"]
#[allow(dead_code)]
mod examples;
#[path = "../guard/meshes.rs"]
#[allow(dead_code)]
mod meshes;
#[path = "../guard/ops.rs"]
#[allow(dead_code)]
mod ops;
mod places;
mod rust;
mod subjects;
mod told;
