//! Halfedge tables as text: meshes with all their contents, including ones that no OBJ file can
//! hold.
//!
//! A line holds one element with its pointers, `-` where one is missing. `mesh WORD` begins a
//! table, so that one file can show a mesh before and after an operation; `name WORD` lists the
//! elements that a name denotes, in all tables. `attribute KIND WORD TYPE DEFAULT` begins a column
//! of the table, and each `value` line after it gives one element a value other than the default.
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
//! An element that has no line is not alive, whatever points at it. Numbers are printed with the
//! fewest digits that read back as the same number, so a table survives the round trip exactly;
//! scratch columns, whose names programs cannot use, are left out.

use super::connectivity::Mesh;
use super::id::Element;

mod error;
mod read;
mod table;
mod write;

pub use error::{DumpError, DumpReason};
pub use read::read_dump;
pub use write::write_dump;
pub(super) use write::write_table;

/// Tables and names, as in a file.
#[derive(Clone, Debug, Default)]
pub struct Dump {
    /// The remarks, which are written at the top.
    pub remarks: Vec<String>,
    /// Each table with its name.
    pub meshes: Vec<(String, Mesh)>,
    /// The elements of each name, all of one kind.
    pub names: Vec<(String, Vec<Element>)>,
}
