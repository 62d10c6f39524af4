//! The language server, which speaks the Language Server Protocol.
//!
//! [`Server`] takes and returns messages; [`serve`] carries them over standard input and output.
//! Every answer is computed in [`analysis`](crate::analysis) as plain data, for whatever text an
//! editor holds; here only positions and names are converted to those of the protocol. One loop
//! owns the documents. Requests are answered in order of arrival, except those that are cancelled
//! before their turn; between messages, ops are proved one by one, and when all are, diagnostics
//! are published. Requests about all ops of a document wait until then, without blocking others.

// Messages and streams.
pub mod message;
mod stdio;

mod server;

mod lifecycle;

mod requests;

mod notifications;

// The client and its documents.
mod client;
mod document;
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

// Work besides requests and answers.
mod diagram_page;
mod progress;
mod subprocess;

pub use position::Encoding;
pub use server::Server;
pub use stdio::{serve, serve_on};
pub use subprocess::Subprocess;
