//! What resolving makes of a text, and what it says of a wrong one.

mod examples;
mod limits;
mod mutated;
mod pages;
mod told;
