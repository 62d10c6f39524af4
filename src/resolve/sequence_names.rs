//! The names of sequences of elements and of the aggregates over them.

use crate::diagram::{Elements, FoldFunction, Type};

/// The sequences of the whole mesh.
pub(super) const WHOLE_MESH: [(&str, Elements); 5] = [
    ("vertices", Elements::Vertices),
    ("halfedges", Elements::Halfedges),
    ("edges", Elements::Edges),
    ("faces", Elements::Faces),
    ("holes", Elements::Holes),
];

pub(super) const FOLDS: [(&str, FoldFunction); 9] = [
    ("mean", FoldFunction::Mean),
    ("sum", FoldFunction::Sum),
    ("min", FoldFunction::Min),
    ("max", FoldFunction::Max),
    ("argmin", FoldFunction::ArgMin),
    ("argmax", FoldFunction::ArgMax),
    ("count", FoldFunction::Count),
    ("any", FoldFunction::Any),
    ("all", FoldFunction::All),
];

/// The names of the aggregates.
pub(super) fn fold_names() -> impl Iterator<Item = &'static str> {
    FOLDS.iter().map(|(known, _)| *known)
}

/// The fields of a type that are sequences.
pub(super) fn sequences_of(ty: Type) -> &'static [&'static str] {
    match ty {
        Type::Vertex => &["halfedges", "edges", "faces", "neighbors"],
        Type::Face => &["halfedges", "vertices", "edges", "ears", "patch"],
        Type::Edge => &["vertices", "faces"],
        _ => &[],
    }
}
