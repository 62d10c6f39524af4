//! The language server: every answer, whole conversations, and what no editor should do.

mod answers;
mod client;
mod commands;
mod conversation;
mod edits;
mod extension;
mod latency;
mod proofs;
mod protocol;
mod shown;
mod sound;
mod workspace;
