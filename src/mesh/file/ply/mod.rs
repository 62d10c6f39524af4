//! The Stanford polygon file format, PLY: text, or binary in either byte order.
//!
//! The head of such a file names the properties of each element and their types, so a file can hold
//! any attributes of a mesh. The crates `ply-rs`, `ply-rs-bw` and `serde-ply` require these names
//! at compile time, or make a map of names to values for each vertex; here the columns are
//! determined when the file is read, and are read and written as columns.
//!
//! | property | attribute |
//! | --- | --- |
//! | `nx ny nz`, `red green blue` (whole numbers divided by their greatest), `s t` or `u v` | `normal`, `color`, `uv` of the vertex or face |
//! | a number `NAME` | `NAME: … int` or `real` |
//! | a list `NAME` of always 2, 3, 4, 9 or 16 numbers | `NAME: … vec2`, `vec3`, `vec4`, `mat3`, `mat4` |
//! | lists `texcoord` (2 numbers for each corner), `uv` and `normal` (3) of a face, empty if it has none | as `vt` and `vn` in OBJ |
//! | a list `NAME` of a face of 1, 2, … numbers for each of its corners | `NAME: halfedge …` |
//! | numbers of the element `edge`, after `vertex1 vertex2` | `NAME: edge …` |
//! | `object`, `group`, `material`, `smoothing` of a face, where comments name their values | as `o`, `g`, `usemtl`, `s` in OBJ |
//!
//! Facts that a head cannot express are in comments that other programs ignore:
//! `comment attribute KIND NAME TYPE DEFAULT`, as in halfedge tables, and ` as PROPERTY` behind it
//! where another property has the name; `comment material 0 NAME` and the like; `comment mtllib
//! NAME`. Other comments and `obj_info` are kept. Reals are written with 32 bits where that is exact.
//! If two properties would be attributes of one name, the second gets an underscore.

mod body;
mod header;
mod read;
mod write;

pub(super) use read::read;
pub(super) use write::write;
