//! Names in a text: every symbol, and every place that mentions it.
//!
//! The index is made of the tree, so it is there however broken the program is; only which words
//! behind dots are attributes, the resolver knows, as far as it could read them. A name of a
//! drawing belongs to its rule; one that is a parameter or the result belongs to the op and is the
//! same in all its rules. In scripts the innermost declaration counts.

mod drawing;
mod expression;
mod script;
mod symbol;
mod walk;

pub use symbol::{List, Mention, Names, Role, SideName, Symbol, SymbolId, SymbolKind};
