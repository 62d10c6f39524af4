//! The halfedge mesh: construction, invariants, changes, comparison, reading and writing.

mod arrays;
mod binary;
mod build;
mod compare;
mod displaced;
mod dump;
mod ears;
mod files;
mod journal;
mod laws;
mod link;
mod lost;
mod measure;
mod memory;
mod obj;
mod order;
mod repair;
mod shapes;
mod threads;
mod walk;
