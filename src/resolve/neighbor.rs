//! Neighbors: what may be meant where a value is of another kind.

use crate::diagram::Type;
use crate::syntax::tree;

use super::words::short;

/// The fields from a value of type `ty` to one of type `wanted`, if that is near.
pub(super) fn path(ty: Type, wanted: Type) -> Option<&'static str> {
    Some(match (ty, wanted) {
        (Type::Halfedge, Type::Vertex) => "vertex",
        (Type::Halfedge, Type::Edge) => "edge",
        (Type::Halfedge, Type::Face) => "face",
        (Type::Halfedge, Type::Vec3) => "vertex.position",
        (Type::Vertex, Type::Vec3) => "position",
        (Type::Vertex | Type::Edge | Type::Face, Type::Halfedge) => "halfedge",
        _ => return None,
    })
}

/// The note on what of type `wanted` belongs to a value of type `ty`.
pub(super) fn near(written: &tree::Expr, ty: Type, wanted: Type) -> Option<String> {
    let text = short(written, 3)?;
    let of = ty.a_word();
    Some(match (ty, wanted) {
        (Type::Edge, Type::Vec3) => format!("the middle of {of} is `midpoint({text})`"),
        (Type::Face, Type::Vec3) => format!("the middle of {of} is `centroid({text})`"),
        (Type::Halfedge, Type::Vec3) => {
            format!("{of} goes from `{text}.vertex.position` to `{text}.target.position`")
        }
        (Type::Halfedge, Type::Vertex) => format!("{of} begins at `{text}.{}`", path(ty, wanted)?),
        (_, Type::Vec3) => format!("the position of {of} is `{text}.{}`", path(ty, wanted)?),
        (Type::Edge, Type::Halfedge) => {
            format!("the halfedges of {of} are `{text}.halfedge` and `{text}.halfedge.twin`")
        }
        (_, Type::Halfedge) => format!("one halfedge of {of} is `{text}.{}`", path(ty, wanted)?),
        _ => format!("the {} of {of} is `{text}.{}`", wanted.word(), path(ty, wanted)?),
    })
}
