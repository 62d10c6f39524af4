//! compile
mod expression;
pub use expression::{Scope, each, element_kind, elements, lower, lower_into, width};
