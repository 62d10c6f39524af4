//! The proof: its laws, what it infers, its counterexamples, and its soundness.

mod aliases;
mod battery;
mod families;
mod laws;
mod properties;
mod published;
mod witness;
