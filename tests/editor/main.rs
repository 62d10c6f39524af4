//! The language server: every answer, whole conversations, and what no editor should do.

#[path = "../dice/mod.rs"]
mod dice;
#[path = "../pages/mod.rs"]
mod pages;

mod answers;
mod client;
mod commands;
mod conversation;
mod edits;
mod extension;
mod latency;
mod proofs;
mod shown;
mod sound;
mod workspace;
