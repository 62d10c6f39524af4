//! A halfedge mesh: elements, pointers, attributes.

mod attribute;
mod connectivity;
mod id;
mod slots;

pub use attribute::{
    Attribute, AttributeType, Column, ColumnConflict, ColumnData, ColumnId, Value,
};
pub use connectivity::{HalfedgeRecord, Mesh};
pub use id::{EdgeId, ElementKind, FaceId, HalfedgeId, VertexId};
