//! compile
mod expression;
pub use expression::{Scope, lower};
