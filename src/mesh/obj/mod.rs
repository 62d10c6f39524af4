//! Wavefront OBJ in and out.
//!
//! A file is read through `tobj`, which parses numbers and faces; `filter` stands
//! before it and sees to what it does not: lines for errors, continued lines, groups
//! that would tear the surface apart, the file's own numbering. What the mesh has no
//! place for (texture coordinates, normals, groups, materials) is kept beside it and
//! written back; `attributes` makes values of it where a program wants them. Curves, points and lines are passed over.
//!
//! In memory ids start at 0 and slots are reused; in a file numbers start at 1 and have
//! no gaps. [`Obj`] remembers which elements came from the file, and under which number.

mod attributes;
mod error;
mod filter;
mod kept;
mod lines;
mod numbers;
mod read;
mod write;

pub use attributes::WantedAttribute;
pub use error::{Indexed, ObjError, ObjReason};
pub use numbers::{Obj, WrittenNumbers};
pub use read::{read_obj, read_obj_from};
pub use write::{expect_writable, replace_file, write_obj, write_obj_to};
