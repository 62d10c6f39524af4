//! Wavefront OBJ.
//!
//! A file is read in one pass by a reader of its own. The crate `tobj` renumbers the vertices of
//! each group by their first use and drops the others, so that groups tear the surface apart and
//! the numbers of the file are lost; it reports no lines, knows no continued lines, ignores a
//! fourth number, and invents a texture index where one is missing. Working around this, by
//! rewriting every file for it and inventing polygons to recover the numbers, took four times as
//! long. Material libraries, which are another format, are still read with it
//! ([`MeshFile::read_materials`](super::MeshFile::read_materials)).
//!
//! Texture coordinates, normals, objects, groups, materials and smoothing groups are
//! [kept](super::kept) beside the mesh and written back. Fourth numbers of vertices become the
//! attribute `weight` (1 if there is none), those of colours `alpha`. Points, lines, curves and
//! unknown statements are reported when the mesh is written; comments are not kept, since what they
//! say of one file need not hold for the next.

mod parts;
mod read;
mod write;

pub(super) use parts::read;
pub(super) use write::{vertex_columns, write};
