//! The table of built-in fields of elements, vectors and matrices.

use crate::diagram::{Access, Pointer, Type};

use super::sequence_names::sequences_of;

/// The kind of a field.
#[derive(Clone, Copy)]
pub(super) enum Field {
    Pointer(Pointer, Type),
    Attribute(Access, Type),
    Part(u8, Type),
}

/// The fields of a type that are values.
pub(super) fn fields_of(ty: Type) -> &'static [(&'static str, Field)] {
    use Field::{Attribute, Part, Pointer as To};
    use Type::{Real, Vec3, Vec4};
    match ty {
        Type::Halfedge => &[
            ("next", To(Pointer::Next, Type::Halfedge)),
            ("prev", To(Pointer::Prev, Type::Halfedge)),
            ("twin", To(Pointer::Twin, Type::Halfedge)),
            ("vertex", To(Pointer::Vertex, Type::Vertex)),
            ("target", To(Pointer::Target, Type::Vertex)),
            ("edge", To(Pointer::Edge, Type::Edge)),
            ("face", To(Pointer::Face, Type::Face)),
        ],
        Type::Vertex => &[
            ("position", Attribute(Access::Position, Type::Vec3)),
            ("halfedge", To(Pointer::VertexHalfedge, Type::Halfedge)),
        ],
        Type::Edge => &[("halfedge", To(Pointer::EdgeHalfedge, Type::Halfedge))],
        Type::Face => &[("halfedge", To(Pointer::FaceHalfedge, Type::Halfedge))],
        Type::Vec2 => &[("x", Part(0, Real)), ("y", Part(1, Real))],
        Type::Vec3 => &[("x", Part(0, Real)), ("y", Part(1, Real)), ("z", Part(2, Real))],
        Type::Vec4 => &[
            ("x", Part(0, Real)),
            ("y", Part(1, Real)),
            ("z", Part(2, Real)),
            ("w", Part(3, Real)),
        ],
        // Matrices are stored by columns, as is usual in graphics.
        Type::Mat3 => &[("x", Part(0, Vec3)), ("y", Part(3, Vec3)), ("z", Part(6, Vec3))],
        Type::Mat4 => &[
            ("x", Part(0, Vec4)),
            ("y", Part(4, Vec4)),
            ("z", Part(8, Vec4)),
            ("w", Part(12, Vec4)),
        ],
        Type::Bool | Type::Int | Type::Real | Type::Text => &[],
    }
}

/// The built-in attribute of this name of elements of type `ty`, and the type of its values.
pub(super) fn attribute(ty: Type, word: &str) -> Option<(Access, Type)> {
    fields_of(ty).iter().find_map(|(known, field)| match field {
        Field::Attribute(access, value) if *known == word => Some((*access, *value)),
        _ => None,
    })
}

/// The names of the built-in attributes of elements of type `ty`.
pub(super) fn attributes_of(ty: Type) -> Vec<&'static str> {
    let attribute = |(known, field): &(&'static str, Field)| {
        matches!(field, Field::Attribute(..)).then_some(*known)
    };
    fields_of(ty).iter().filter_map(attribute).collect()
}

/// True if type `ty` has a built-in field or sequence of this name.
pub(super) fn is_taken(ty: Type, word: &str) -> bool {
    fields_of(ty).iter().any(|(known, _)| *known == word) || sequences_of(ty).contains(&word)
}

/// True if an element has a pointer of this name.
pub(super) fn is_pointer(word: &str) -> bool {
    let mut fields = Type::ALL.into_iter().filter(|ty| ty.is_element()).flat_map(fields_of);
    fields.any(|(known, field)| *known == word && matches!(field, Field::Pointer(..)))
}
