//! The language server: every response, whole conversations, and invalid requests.

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
