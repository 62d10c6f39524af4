//! The names of the built-in functions.

use crate::diagram::{Type, functions};

/// The function that puts a sequence in random order.
pub(super) const SHUFFLE: &str = "shuffle";

/// The types that are constructed from components: `vec3(x, y, z)`.
pub(super) const CONSTRUCTORS: [Type; 5] =
    [Type::Vec2, Type::Vec3, Type::Vec4, Type::Mat3, Type::Mat4];

/// The names of all functions except the aggregates.
pub(super) fn function_names() -> impl Iterator<Item = &'static str> {
    functions().chain(CONSTRUCTORS.map(Type::word)).chain([SHUFFLE])
}
