//! Names in a text: every symbol, and every place that mentions it.
//!
//! The index is built from the tree, so it is available however broken the program is; only the
//! meaning of the words after dots comes from the resolver, as far as it could resolve them. A name
//! of a drawing belongs to its rule; a parameter or the result belongs to the op and is the same in
//! all its rules. In scripts the innermost declaration counts.

mod drawing;
mod expression;
mod script;
mod symbol;
mod walk;

pub use symbol::{List, Mention, Names, Role, SideName, Symbol, SymbolId, SymbolKind};
