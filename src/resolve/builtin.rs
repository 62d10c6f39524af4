//! The functions of the language: what they are called, take and give.

use crate::diagram::{Builtin, Type};

/// The type that a function wants at one place.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wanted {
    /// A value of one type.
    Is(Type),
    /// A vector, or a vertex for its position.
    Point,
}

/// One way to call a function.
#[derive(Clone, Copy, Debug)]
pub(super) struct Overload {
    /// The types it takes.
    pub(super) wanted: &'static [Wanted],
    /// The type it gives.
    pub(super) result: Type,
    /// The function.
    pub(super) builtin: Builtin,
}

const BOOL: Type = Type::Bool;
const INT: Type = Type::Int;
const REAL: Type = Type::Real;
const VEC2: Type = Type::Vec2;
const VEC3: Type = Type::Vec3;
const VEC4: Type = Type::Vec4;
const MAT3: Type = Type::Mat3;
const MAT4: Type = Type::Mat4;

const I: Wanted = Wanted::Is(Type::Int);
const R: Wanted = Wanted::Is(Type::Real);
const X: Wanted = Wanted::Is(Type::Vec3);
const X2: Wanted = Wanted::Is(Type::Vec2);
const X4: Wanted = Wanted::Is(Type::Vec4);
const M3: Wanted = Wanted::Is(Type::Mat3);
const M4: Wanted = Wanted::Is(Type::Mat4);
const V: Wanted = Wanted::Is(Type::Vertex);
const H: Wanted = Wanted::Is(Type::Halfedge);
const E: Wanted = Wanted::Is(Type::Edge);
const F: Wanted = Wanted::Is(Type::Face);
const P: Wanted = Wanted::Point;

const fn f(wanted: &'static [Wanted], result: Type, builtin: Builtin) -> Overload {
    Overload { wanted, result, builtin }
}

/// The functions by name, each with its overloads. The constructors and the
/// aggregates stand apart.
const FUNCTIONS: &[(&str, &[Overload])] = &[
    ("degree", &[f(&[V], INT, Builtin::DegreeVertex), f(&[F], INT, Builtin::DegreeFace)]),
    (
        "boundary",
        &[
            f(&[V], BOOL, Builtin::BoundaryVertex),
            f(&[H], BOOL, Builtin::BoundaryHalfedge),
            f(&[E], BOOL, Builtin::BoundaryEdge),
            f(&[F], BOOL, Builtin::IsHole),
        ],
    ),
    ("hole", &[f(&[F], BOOL, Builtin::IsHole)]),
    ("adjacent", &[f(&[V, V], BOOL, Builtin::Adjacent)]),
    ("link_condition", &[f(&[E], BOOL, Builtin::LinkCondition)]),
    ("star_shaped", &[f(&[E], BOOL, Builtin::StarShaped)]),
    ("kernel_centroid", &[f(&[E], VEC3, Builtin::KernelCentroid)]),
    (
        "length",
        &[
            f(&[E], REAL, Builtin::LengthEdge),
            f(&[H], REAL, Builtin::LengthHalfedge),
            f(&[X], REAL, Builtin::LengthVector),
            f(&[X2], REAL, Builtin::LengthVector),
            f(&[X4], REAL, Builtin::LengthVector),
        ],
    ),
    ("area", &[f(&[F], REAL, Builtin::Area)]),
    ("normal", &[f(&[F], VEC3, Builtin::NormalFace), f(&[V], VEC3, Builtin::NormalVertex)]),
    ("centroid", &[f(&[F], VEC3, Builtin::CentroidFace), f(&[E], VEC3, Builtin::CentroidEdge)]),
    ("midpoint", &[f(&[E], VEC3, Builtin::CentroidEdge)]),
    (
        "mix",
        &[
            f(&[R, R, R], REAL, Builtin::MixReal),
            f(&[X, X, R], VEC3, Builtin::MixVector),
            f(&[X2, X2, R], VEC2, Builtin::MixVector),
            f(&[X4, X4, R], VEC4, Builtin::MixVector),
        ],
    ),
    (
        "dot",
        &[
            f(&[X, X], REAL, Builtin::Dot),
            f(&[X2, X2], REAL, Builtin::Dot),
            f(&[X4, X4], REAL, Builtin::Dot),
        ],
    ),
    ("cross", &[f(&[X, X], VEC3, Builtin::Cross), f(&[X2, X2], REAL, Builtin::CrossPlane)]),
    (
        "normalize",
        &[
            f(&[X], VEC3, Builtin::Normalize),
            f(&[X2], VEC2, Builtin::Normalize),
            f(&[X4], VEC4, Builtin::Normalize),
        ],
    ),
    ("distance", &[f(&[P, P], REAL, Builtin::Distance), f(&[X2, X2], REAL, Builtin::Distance)]),
    ("outer", &[f(&[X, X], MAT3, Builtin::Outer), f(&[X4, X4], MAT4, Builtin::Outer)]),
    ("transpose", &[f(&[M3], MAT3, Builtin::Transpose), f(&[M4], MAT4, Builtin::Transpose)]),
    ("determinant", &[f(&[M3], REAL, Builtin::Determinant), f(&[M4], REAL, Builtin::Determinant)]),
    ("inverse", &[f(&[M3], MAT3, Builtin::Inverse), f(&[M4], MAT4, Builtin::Inverse)]),
    ("solve", &[f(&[M3, X], VEC3, Builtin::Solve), f(&[M4, X4], VEC4, Builtin::Solve)]),
    (
        "is_nan",
        &[
            f(&[R], BOOL, Builtin::IsNan),
            f(&[X2], BOOL, Builtin::IsNan),
            f(&[X], BOOL, Builtin::IsNan),
            f(&[X4], BOOL, Builtin::IsNan),
            f(&[M3], BOOL, Builtin::IsNan),
            f(&[M4], BOOL, Builtin::IsNan),
        ],
    ),
    (
        "is_finite",
        &[
            f(&[R], BOOL, Builtin::IsFinite),
            f(&[X2], BOOL, Builtin::IsFinite),
            f(&[X], BOOL, Builtin::IsFinite),
            f(&[X4], BOOL, Builtin::IsFinite),
            f(&[M3], BOOL, Builtin::IsFinite),
            f(&[M4], BOOL, Builtin::IsFinite),
        ],
    ),
    ("angle", &[f(&[X, X], REAL, Builtin::Angle), f(&[H], REAL, Builtin::AngleCorner)]),
    ("cotangent", &[f(&[H], REAL, Builtin::Cotangent)]),
    ("dihedral_angle", &[f(&[E], REAL, Builtin::DihedralAngle)]),
    ("abs", &[f(&[I], INT, Builtin::AbsInt), f(&[R], REAL, Builtin::AbsReal)]),
    ("min", &[f(&[I, I], INT, Builtin::MinInt), f(&[R, R], REAL, Builtin::MinReal)]),
    ("max", &[f(&[I, I], INT, Builtin::MaxInt), f(&[R, R], REAL, Builtin::MaxReal)]),
    ("sqrt", &[f(&[R], REAL, Builtin::Sqrt)]),
    ("sin", &[f(&[R], REAL, Builtin::Sin)]),
    ("cos", &[f(&[R], REAL, Builtin::Cos)]),
    ("tan", &[f(&[R], REAL, Builtin::Tan)]),
    ("asin", &[f(&[R], REAL, Builtin::Asin)]),
    ("acos", &[f(&[R], REAL, Builtin::Acos)]),
    ("atan2", &[f(&[R, R], REAL, Builtin::Atan2)]),
    ("exp", &[f(&[R], REAL, Builtin::Exp)]),
    ("log", &[f(&[R], REAL, Builtin::Log)]),
    ("pow", &[f(&[R, R], REAL, Builtin::Pow)]),
    ("floor", &[f(&[R], REAL, Builtin::Floor)]),
    ("ceil", &[f(&[R], REAL, Builtin::Ceil)]),
    ("round", &[f(&[R], INT, Builtin::Round)]),
    ("random", &[f(&[], REAL, Builtin::Random), f(&[I], INT, Builtin::RandomInt)]),
];

/// The function that puts a sequence into random order.
pub(super) const SHUFFLE: &str = "shuffle";

/// The types that are made of parts: `vec3(x, y, z)`.
pub(super) const CONSTRUCTORS: [Type; 5] = [VEC2, VEC3, VEC4, MAT3, MAT4];

/// The ways to call a function; none if there is no such function.
pub(super) fn overloads(name: &str) -> &'static [Overload] {
    let found = FUNCTIONS.iter().find(|(known, _)| *known == name);
    found.map_or(&[], |(_, overloads)| overloads)
}

/// The names of all functions but the aggregates.
pub(super) fn function_names() -> impl Iterator<Item = &'static str> {
    let known = FUNCTIONS.iter().map(|(known, _)| *known);
    known.chain(CONSTRUCTORS.map(Type::word)).chain([SHUFFLE])
}
