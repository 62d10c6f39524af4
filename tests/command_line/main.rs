//! The binary, as used by a person or a program: its output, its exit codes, and that no input
//! makes it panic or leave a partly written file behind.

mod advice;
mod attributes;
mod bench;
mod commands;
mod emitted;
mod formatting;
mod hostile;
mod interrupted;
mod learn;
mod library;
mod meshes;
mod outputs;
mod play;
mod programs;
mod streams;
#[cfg(unix)]
mod terminal;
mod usage;
