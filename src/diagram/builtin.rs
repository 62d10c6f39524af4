//! The builtin functions of the language: their words, overloads, and the part of the mesh
//! that they traverse.
//!
//! Each row of the table is a word. Register code and emitted code are chosen by the [`Builtin`] of
//! a call.

use super::Type;

/// A function for particular types of arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Builtin {
    DegreeVertex,
    DegreeFace,
    BoundaryVertex,
    BoundaryHalfedge,
    BoundaryEdge,
    IsHole,
    Adjacent,
    LinkCondition,
    StarShaped,
    KernelCentroid,
    LengthEdge,
    LengthHalfedge,
    LengthVector,
    Area,
    NormalFace,
    NormalVertex,
    CentroidFace,
    CentroidEdge,
    MixReal,
    MixVector,
    Dot,
    Cross,
    /// The third component of the cross product of two vectors in the plane.
    CrossPlane,
    /// The zero vector stays zero; one that is not finite becomes NaN.
    Normalize,
    Distance,
    Angle,
    AngleCorner,
    Cotangent,
    /// The angle by which the surface turns at an edge; zero on the boundary.
    DihedralAngle,
    AbsInt,
    AbsReal,
    MinInt,
    MaxInt,
    MinReal,
    MaxReal,
    MinVector,
    MaxVector,
    ClampInt,
    ClampReal,
    Sqrt,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    /// The angle of the point (second, first).
    Atan2,
    Exp,
    Log,
    Pow,
    Floor,
    Ceil,
    /// Rounds half to even.
    Round,
    Random,
    RandomInt,
    /// A matrix with a real on the diagonal, zero elsewhere: `mat3(1)`.
    Diagonal,
    /// The first three rows and columns of a matrix of four: `mat3(m)`.
    UpperLeft,
    Outer,
    Transpose,
    Inverse,
    Determinant,
    /// The vector that the matrix maps to the given one.
    Solve,
    IsNan,
    IsFinite,
}

/// The type that a function takes as an argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wanted {
    /// A value of one type.
    Is(Type),
    /// A vector, or a vertex for its position.
    Point,
}

/// The part of the mesh that a function traverses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Extent {
    /// At most a few elements.
    Bounded,
    /// The orbit of the first argument, a vertex or a face.
    Orbit,
    /// The orbits of the ends of an edge.
    Ends,
    /// The loops of the halfedges of an edge.
    Sides,
}

/// One way to call a function.
#[derive(Clone, Copy, Debug)]
pub struct Overload {
    /// The types it takes.
    pub wanted: &'static [Wanted],
    pub result: Type,
    /// The function.
    pub builtin: Builtin,
    extent: Extent,
}

impl Builtin {
    /// The part of the mesh that it traverses.
    pub fn extent(self) -> Extent {
        let mut ways = FUNCTIONS.iter().flat_map(|(_, ways)| *ways);
        ways.find(|way| way.builtin == self).map_or(Extent::Bounded, |way| way.extent)
    }

    /// True if it draws random numbers.
    pub fn is_random(self) -> bool {
        matches!(self, Self::Random | Self::RandomInt)
    }
}

/// The overloads of a function; empty if there is no such function.
pub fn overloads(name: &str) -> &'static [Overload] {
    let found = FUNCTIONS.iter().find(|(known, _)| *known == name);
    found.map_or(&[], |(_, overloads)| overloads)
}

/// The names of the functions.
pub fn functions() -> impl Iterator<Item = &'static str> {
    FUNCTIONS.iter().map(|(name, _)| *name)
}

use Builtin::*;

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

const fn of(wanted: &'static [Wanted], result: Type, builtin: Builtin) -> Overload {
    Overload { wanted, result, builtin, extent: Extent::Bounded }
}

const fn around(wanted: &'static [Wanted], result: Type, builtin: Builtin) -> Overload {
    Overload { extent: Extent::Orbit, ..of(wanted, result, builtin) }
}

const fn at_ends(wanted: &'static [Wanted], result: Type, builtin: Builtin) -> Overload {
    Overload { extent: Extent::Ends, ..of(wanted, result, builtin) }
}

const fn along_sides(wanted: &'static [Wanted], result: Type, builtin: Builtin) -> Overload {
    Overload { extent: Extent::Sides, ..of(wanted, result, builtin) }
}

/// The functions by name, each with its overloads. The constructors and the
/// aggregates are not among them.
const FUNCTIONS: &[(&str, &[Overload])] = &[
    ("degree", &[around(&[V], INT, DegreeVertex), around(&[F], INT, DegreeFace)]),
    (
        "boundary",
        &[
            around(&[V], BOOL, BoundaryVertex),
            of(&[H], BOOL, BoundaryHalfedge),
            of(&[E], BOOL, BoundaryEdge),
            of(&[F], BOOL, IsHole),
        ],
    ),
    ("hole", &[of(&[F], BOOL, IsHole)]),
    ("adjacent", &[around(&[V, V], BOOL, Adjacent)]),
    ("link_condition", &[at_ends(&[E], BOOL, LinkCondition)]),
    ("star_shaped", &[at_ends(&[E], BOOL, StarShaped)]),
    ("kernel_centroid", &[at_ends(&[E], VEC3, KernelCentroid)]),
    (
        "length",
        &[
            of(&[E], REAL, LengthEdge),
            of(&[H], REAL, LengthHalfedge),
            of(&[X], REAL, LengthVector),
            of(&[X2], REAL, LengthVector),
            of(&[X4], REAL, LengthVector),
        ],
    ),
    ("area", &[around(&[F], REAL, Area)]),
    ("normal", &[around(&[F], VEC3, NormalFace), around(&[V], VEC3, NormalVertex)]),
    ("centroid", &[around(&[F], VEC3, CentroidFace), of(&[E], VEC3, CentroidEdge)]),
    ("midpoint", &[of(&[E], VEC3, CentroidEdge)]),
    (
        "mix",
        &[
            of(&[R, R, R], REAL, MixReal),
            of(&[X, X, R], VEC3, MixVector),
            of(&[X2, X2, R], VEC2, MixVector),
            of(&[X4, X4, R], VEC4, MixVector),
        ],
    ),
    ("dot", &[of(&[X, X], REAL, Dot), of(&[X2, X2], REAL, Dot), of(&[X4, X4], REAL, Dot)]),
    ("cross", &[of(&[X, X], VEC3, Cross), of(&[X2, X2], REAL, CrossPlane)]),
    (
        "normalize",
        &[of(&[X], VEC3, Normalize), of(&[X2], VEC2, Normalize), of(&[X4], VEC4, Normalize)],
    ),
    ("distance", &[of(&[P, P], REAL, Distance), of(&[X2, X2], REAL, Distance)]),
    ("outer", &[of(&[X, X], MAT3, Outer), of(&[X4, X4], MAT4, Outer)]),
    ("transpose", &[of(&[M3], MAT3, Transpose), of(&[M4], MAT4, Transpose)]),
    ("determinant", &[of(&[M3], REAL, Determinant), of(&[M4], REAL, Determinant)]),
    ("inverse", &[of(&[M3], MAT3, Inverse), of(&[M4], MAT4, Inverse)]),
    ("solve", &[of(&[M3, X], VEC3, Solve), of(&[M4, X4], VEC4, Solve)]),
    (
        "is_nan",
        &[
            of(&[R], BOOL, IsNan),
            of(&[X2], BOOL, IsNan),
            of(&[X], BOOL, IsNan),
            of(&[X4], BOOL, IsNan),
            of(&[M3], BOOL, IsNan),
            of(&[M4], BOOL, IsNan),
        ],
    ),
    (
        "is_finite",
        &[
            of(&[R], BOOL, IsFinite),
            of(&[X2], BOOL, IsFinite),
            of(&[X], BOOL, IsFinite),
            of(&[X4], BOOL, IsFinite),
            of(&[M3], BOOL, IsFinite),
            of(&[M4], BOOL, IsFinite),
        ],
    ),
    ("angle", &[of(&[X, X], REAL, Angle), of(&[H], REAL, AngleCorner)]),
    ("cotangent", &[of(&[H], REAL, Cotangent)]),
    ("dihedral_angle", &[along_sides(&[E], REAL, DihedralAngle)]),
    ("abs", &[of(&[I], INT, AbsInt), of(&[R], REAL, AbsReal)]),
    (
        "min",
        &[
            of(&[I, I], INT, MinInt),
            of(&[R, R], REAL, MinReal),
            of(&[X, X], VEC3, MinVector),
            of(&[X2, X2], VEC2, MinVector),
            of(&[X4, X4], VEC4, MinVector),
        ],
    ),
    (
        "max",
        &[
            of(&[I, I], INT, MaxInt),
            of(&[R, R], REAL, MaxReal),
            of(&[X, X], VEC3, MaxVector),
            of(&[X2, X2], VEC2, MaxVector),
            of(&[X4, X4], VEC4, MaxVector),
        ],
    ),
    ("clamp", &[of(&[I, I, I], INT, ClampInt), of(&[R, R, R], REAL, ClampReal)]),
    ("sqrt", &[of(&[R], REAL, Sqrt)]),
    ("sin", &[of(&[R], REAL, Sin)]),
    ("cos", &[of(&[R], REAL, Cos)]),
    ("tan", &[of(&[R], REAL, Tan)]),
    ("asin", &[of(&[R], REAL, Asin)]),
    ("acos", &[of(&[R], REAL, Acos)]),
    ("atan2", &[of(&[R, R], REAL, Atan2)]),
    ("exp", &[of(&[R], REAL, Exp)]),
    ("log", &[of(&[R], REAL, Log)]),
    ("pow", &[of(&[R, R], REAL, Pow)]),
    ("floor", &[of(&[R], REAL, Floor)]),
    ("ceil", &[of(&[R], REAL, Ceil)]),
    ("round", &[of(&[R], INT, Round)]),
    ("random", &[of(&[], REAL, Random), of(&[I], INT, RandomInt)]),
];
