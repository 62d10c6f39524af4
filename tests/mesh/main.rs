//! The halfedge mesh: construction, invariants, changes, comparison, reading and writing.

mod arrays;
mod binary;
mod build;
mod compare;
mod displaced;
mod dump;
mod ears;
mod files;
mod formats;
#[cfg(target_os = "linux")]
mod huge_pages;
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

#[cfg(target_os = "linux")]
#[global_allocator]
static ALLOCATOR: hedgerow::huge_pages::HugePages = hedgerow::huge_pages::HugePages;
