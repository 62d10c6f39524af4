//! What resolving makes of a text, and what it says of a wrong one.
//!
//! Every diagnostic has a case here, with all that it says.

mod drawings;
mod examples;
mod expressions;
mod items;
mod limits;
mod scripts;
mod told;
