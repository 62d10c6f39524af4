//! Halfedge meshes: what the language works on, knowing nothing of the language.
//!
//! A mesh is three kinds of orbit of halfedges. Every halfedge lies in one cycle of
//! `next`, its face; in one pair of `twin`s, its edge; and in one cycle of next-spoke,
//! counterclockwise `h -> h.prev.twin`, its vertex. Boundaries are loops too: a hole is
//! a face with a flag, so that on a valid mesh no pointer of a halfedge is missing.
//!
//! The tables store what they are told. Whether they are a mesh is for `validate` to
//! say, and how good a mesh for the levels. Operations are not here.

mod attribute;
mod build;
mod connectivity;
mod geometry;
mod id;
mod level;
mod link;
mod obj;
mod polygons;
pub mod shape;
mod slots;
pub mod validate;
mod walk;

pub use attribute::{
    Attribute, AttributeType, Column, ColumnConflict, ColumnData, ColumnId, Value,
};
pub use build::BuildError;
pub use connectivity::{HalfedgeRecord, Mesh};
pub use id::{EdgeId, Element, ElementKind, FaceId, HalfedgeId, VertexId};
pub use level::{BelowLevel, Level, highest_level, validate_level};
pub use obj::{
    Indexed, Obj, ObjError, ObjReason, WrittenNumbers, read_obj, read_obj_from, write_obj,
    write_obj_to,
};
pub use polygons::Polygons;
pub use validate::{Invalid, validate};
pub use walk::{LoopWalk, SpokeWalk};
