//! The names of the functions of the language.

use crate::diagram::{Type, functions};

/// The function that puts a sequence into random order.
pub(super) const SHUFFLE: &str = "shuffle";

/// The types that are made of parts: `vec3(x, y, z)`.
pub(super) const CONSTRUCTORS: [Type; 5] =
    [Type::Vec2, Type::Vec3, Type::Vec4, Type::Mat3, Type::Mat4];

/// The names of all functions but the aggregates.
pub(super) fn function_names() -> impl Iterator<Item = &'static str> {
    let known = functions().map(|(known, _)| known);
    known.chain(CONSTRUCTORS.map(Type::word)).chain([SHUFFLE])
}
