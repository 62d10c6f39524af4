//! The language server: the Language Server Protocol, translated.
//!
//! [`Server`] takes messages and makes messages; [`serve`] carries them over standard input
//! and output. Every answer is computed in [`analysis`](crate::analysis) as plain data, for
//! whatever text an editor holds; here it only gets positions and the protocol's names. One
//! loop owns the documents. Requests are answered in the order they come in, one that is
//! cancelled before its turn is not; between messages, ops are proved one by one, and when
//! all are, diagnostics are published. What is asked about all ops of a document waits until then,
//! and keeps no other question waiting.

// What comes and goes.
pub mod message;
mod stdio;

mod server;

mod lifecycle;

mod requests;

mod notifications;

// What is known of the client and its texts.
mod client;
mod document;
mod documents;
mod files;
pub mod position;
pub mod uri;
mod workspace;

// The answers, a file for each kind.
mod actions;
mod completion;
mod diagnostics;
mod diagram;
mod formatting;
mod hints;
mod hover;
mod lenses;
pub mod markdown;
mod navigation;
mod symbols;
mod tokens;

// What happens beside the conversation.
mod diagram_page;
mod progress;
mod subprocess;

pub use position::Encoding;
pub use server::Server;
pub use stdio::{serve, serve_on};
pub use subprocess::Subprocess;
