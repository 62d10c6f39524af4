//! The proof: its laws, what it infers, its counterexamples, and that it tells the truth.

mod aliases;
mod battery;
mod families;
mod laws;
mod properties;
mod published;
mod witness;
