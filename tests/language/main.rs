//! The language: the parser, names and types, the formatter, the grammars next to the parser, the
//! pages that explain messages, and the layers of the source.

mod diagnostic;
mod explain;
mod files;
mod foreign;
mod format;
mod grammar;
mod layers;
mod library;
mod memory;
mod resolve;
mod source;
mod syntax;
mod words;
mod written;
