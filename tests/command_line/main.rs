//! The binary, as a person or a program meets it: what it answers, its exit codes, and that
//! no input whatsoever makes it panic or leaves half a file behind.

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
mod usage;
