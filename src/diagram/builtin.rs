//! The builtin functions of the language: their words, meanings, overloads, and the part of the
//! mesh that they traverse.
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
        let mut ways = FUNCTIONS.iter().flat_map(|(_, _, ways)| *ways);
        ways.find(|way| way.builtin == self).map_or(Extent::Bounded, |way| way.extent)
    }

    /// True if it draws random numbers.
    pub fn is_random(self) -> bool {
        matches!(self, Self::Random | Self::RandomInt)
    }
}

/// The overloads of a function; empty if there is no such function.
pub fn overloads(name: &str) -> &'static [Overload] {
    let found = FUNCTIONS.iter().find(|(known, ..)| *known == name);
    found.map_or(&[], |(.., overloads)| overloads)
}

/// The functions, each with its meaning.
pub fn functions() -> impl Iterator<Item = (&'static str, &'static str)> {
    FUNCTIONS.iter().map(|(name, meaning, _)| (*name, *meaning))
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

/// The functions by name, each with its meaning and its overloads. The constructors and the
/// aggregates are not among them.
const FUNCTIONS: &[(&str, &str, &[Overload])] = &[
    (
        "degree",
        "how many spokes a vertex has, or corners a face",
        &[around(&[V], INT, DegreeVertex), around(&[F], INT, DegreeFace)],
    ),
    (
        "boundary",
        "as a property: the holes keep their number and their vertices; as a function: whether an element lies on a hole",
        &[
            around(&[V], BOOL, BoundaryVertex),
            of(&[H], BOOL, BoundaryHalfedge),
            of(&[E], BOOL, BoundaryEdge),
            of(&[F], BOOL, IsHole),
        ],
    ),
    (
        "hole",
        "a boundary loop: a cycle of `next` with nothing in it; as a function: whether a face is one",
        &[of(&[F], BOOL, IsHole)],
    ),
    ("adjacent", "whether an edge joins two vertices", &[around(&[V, V], BOOL, Adjacent)]),
    (
        "link_condition",
        "whether contracting an edge, and the triangles at it, leaves a simple mesh of polygons simple",
        &[at_ends(&[E], BOOL, LinkCondition)],
    ),
    (
        "star_shaped",
        "whether the border of the faces at both ends of an edge has a kernel, from which all of it is seen; false if one of them lies on a hole",
        &[at_ends(&[E], BOOL, StarShaped)],
    ),
    (
        "kernel_centroid",
        "the centroid of that kernel, where one vertex for both ends turns no triangle over; not finite if there is none",
        &[at_ends(&[E], VEC3, KernelCentroid)],
    ),
    (
        "length",
        "the length of an edge, a halfedge or a vector",
        &[
            of(&[E], REAL, LengthEdge),
            of(&[H], REAL, LengthHalfedge),
            of(&[X], REAL, LengthVector),
            of(&[X2], REAL, LengthVector),
            of(&[X4], REAL, LengthVector),
        ],
    ),
    ("area", "the area of a face", &[around(&[F], REAL, Area)]),
    (
        "normal",
        "the unit normal of a face, or at a vertex; zero where there is no area",
        &[around(&[F], VEC3, NormalFace), around(&[V], VEC3, NormalVertex)],
    ),
    (
        "centroid",
        "the mean of the corners of a face, or of the ends of an edge",
        &[around(&[F], VEC3, CentroidFace), of(&[E], VEC3, CentroidEdge)],
    ),
    ("midpoint", "the middle of an edge", &[of(&[E], VEC3, CentroidEdge)]),
    (
        "mix",
        "from the first towards the second, by the third, from 0 to 1",
        &[
            of(&[R, R, R], REAL, MixReal),
            of(&[X, X, R], VEC3, MixVector),
            of(&[X2, X2, R], VEC2, MixVector),
            of(&[X4, X4, R], VEC4, MixVector),
        ],
    ),
    (
        "dot",
        "the scalar product",
        &[of(&[X, X], REAL, Dot), of(&[X2, X2], REAL, Dot), of(&[X4, X4], REAL, Dot)],
    ),
    ("cross", "the vector product", &[of(&[X, X], VEC3, Cross), of(&[X2, X2], REAL, CrossPlane)]),
    (
        "normalize",
        "the same direction, with length 1",
        &[of(&[X], VEC3, Normalize), of(&[X2], VEC2, Normalize), of(&[X4], VEC4, Normalize)],
    ),
    (
        "distance",
        "how far two points are apart",
        &[of(&[P, P], REAL, Distance), of(&[X2, X2], REAL, Distance)],
    ),
    (
        "outer",
        "a column times a row: a matrix",
        &[of(&[X, X], MAT3, Outer), of(&[X4, X4], MAT4, Outer)],
    ),
    (
        "transpose",
        "the matrix whose columns are the rows",
        &[of(&[M3], MAT3, Transpose), of(&[M4], MAT4, Transpose)],
    ),
    (
        "determinant",
        "the determinant of a matrix",
        &[of(&[M3], REAL, Determinant), of(&[M4], REAL, Determinant)],
    ),
    (
        "inverse",
        "the inverse of a matrix; of a singular one it is not a number",
        &[of(&[M3], MAT3, Inverse), of(&[M4], MAT4, Inverse)],
    ),
    (
        "solve",
        "the vector that a matrix takes to another; of a singular one it is not a number",
        &[of(&[M3, X], VEC3, Solve), of(&[M4, X4], VEC4, Solve)],
    ),
    (
        "is_nan",
        "whether a component is not a number",
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
        "whether all components are finite",
        &[
            of(&[R], BOOL, IsFinite),
            of(&[X2], BOOL, IsFinite),
            of(&[X], BOOL, IsFinite),
            of(&[X4], BOOL, IsFinite),
            of(&[M3], BOOL, IsFinite),
            of(&[M4], BOOL, IsFinite),
        ],
    ),
    (
        "angle",
        "the angle between two directions, or of the corner where a halfedge starts, in radians; of a corner of a hole, in the hole; at most half a turn, zero if a direction has no length",
        &[of(&[X, X], REAL, Angle), of(&[H], REAL, AngleCorner)],
    ),
    (
        "cotangent",
        "the cotangent of the angle opposite to a halfedge in its triangle, in a larger face as seen from the corner before it, zero in a hole: `(cotangent(h) + cotangent(h.twin)) / 2` is the weight of an edge",
        &[of(&[H], REAL, Cotangent)],
    ),
    (
        "dihedral_angle",
        "the angle between the normals at an edge, positive where it stands out",
        &[along_sides(&[E], REAL, DihedralAngle)],
    ),
    ("abs", "the size without the sign", &[of(&[I], INT, AbsInt), of(&[R], REAL, AbsReal)]),
    (
        "min",
        "the smaller of two, of vectors in each component, or the least over a sequence",
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
        "the larger of two, of vectors in each component, or the greatest over a sequence",
        &[
            of(&[I, I], INT, MaxInt),
            of(&[R, R], REAL, MaxReal),
            of(&[X, X], VEC3, MaxVector),
            of(&[X2, X2], VEC2, MaxVector),
            of(&[X4, X4], VEC4, MaxVector),
        ],
    ),
    (
        "clamp",
        "the first, but no less than the second and no more than the third",
        &[of(&[I, I, I], INT, ClampInt), of(&[R, R, R], REAL, ClampReal)],
    ),
    ("sqrt", "the square root", &[of(&[R], REAL, Sqrt)]),
    ("sin", "the sine of an angle in radians", &[of(&[R], REAL, Sin)]),
    ("cos", "the cosine of an angle in radians", &[of(&[R], REAL, Cos)]),
    ("tan", "the tangent of an angle in radians", &[of(&[R], REAL, Tan)]),
    ("asin", "the angle with this sine", &[of(&[R], REAL, Asin)]),
    ("acos", "the angle with this cosine", &[of(&[R], REAL, Acos)]),
    ("atan2", "the angle of the direction with this y and this x", &[of(&[R, R], REAL, Atan2)]),
    ("exp", "e to the power of a number", &[of(&[R], REAL, Exp)]),
    ("log", "the natural logarithm", &[of(&[R], REAL, Log)]),
    ("pow", "the first to the power of the second", &[of(&[R, R], REAL, Pow)]),
    ("floor", "the whole number below, as a real", &[of(&[R], REAL, Floor)]),
    ("ceil", "the whole number above, as a real", &[of(&[R], REAL, Ceil)]),
    ("round", "the nearest int, of two the even one", &[of(&[R], INT, Round)]),
    (
        "random",
        "a random number: `random()` a real from 0 up to 1, `random(n)` an int from 0 up to n; `--seed` says which",
        &[of(&[], REAL, Random), of(&[I], INT, RandomInt)],
    ),
];
