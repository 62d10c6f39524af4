//! Halfedge tables as text: meshes with all that they have, also such as no OBJ file can hold.
//!
//! A line holds one element with its pointers, `-` where one is missing. `mesh WORD` begins a
//! table, so that one file can show a mesh before and after something; `name WORD` says what a
//! name stands for, in all of them. `attribute KIND WORD TYPE DEFAULT` begins a column of the
//! table, and each `value` line behind it gives one element another value than the default.
//! `#` begins a remark.
//!
//! ```text
//! # flip: `a.twin` is not set
//! mesh before
//! vertex 0 halfedge 0 at 1 0 0
//! halfedge 0 next 1 prev 2 twin 3 vertex 0 edge 0 face 0
//! edge 0 halfedge 0
//! face 0 halfedge 0
//! hole 1 halfedge 3
//! attribute edge crease real 0
//! value 0 2.5
//! name v0 vertex 0
//! name P halfedge 3 4
//! ```
//!
//! An element that has no line does not live, whatever points at it. Numbers are printed with the
//! fewest digits that read back as the same number, so a table makes the round trip exactly;
//! scratch columns, whose names no program can say, are left out.

use super::connectivity::Mesh;
use super::id::Element;

mod error;
mod read;
mod table;
mod write;

pub use error::{DumpError, DumpReason};
pub use read::read_dump;
pub use write::write_dump;

/// Tables and names, as in a file.
#[derive(Clone, Debug, Default)]
pub struct Dump {
    /// The remarks at the top.
    pub remarks: Vec<String>,
    /// Each table with its name.
    pub meshes: Vec<(String, Mesh)>,
    /// The elements of each name: elements of one kind.
    pub names: Vec<(String, Vec<Element>)>,
}
