//! Typed expressions: what a `require` asks, an assignment sets, a script computes.
//!
//! An int stands where a real is wanted only through an explicit [`Unary::ToReal`], so
//! that whoever lowers an expression never guesses.

use super::NameId;
use crate::source::Span;

/// The type of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Type {
    Bool,
    Int,
    Real,
    Vec3,
    Text,
    Vertex,
    Halfedge,
    Edge,
    Face,
}

impl Type {
    /// The word for it.
    pub fn word(self) -> &'static str {
        match self {
            Type::Bool => "bool",
            Type::Int => "int",
            Type::Real => "real",
            Type::Vec3 => "vec3",
            Type::Text => "text",
            Type::Vertex => "vertex",
            Type::Halfedge => "halfedge",
            Type::Edge => "edge",
            Type::Face => "face",
        }
    }

    /// Whether values of this type are elements of the mesh.
    pub fn is_element(self) -> bool {
        matches!(
            self,
            Type::Vertex | Type::Halfedge | Type::Edge | Type::Face
        )
    }
}

/// A typed expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    /// Its type.
    pub ty: Type,
    /// What it is.
    pub kind: ExprKind,
    /// Where it stands.
    pub span: Span,
}

/// What an expression is.
#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// A truth value.
    Bool(bool),
    /// An int.
    Int(i64),
    /// A real.
    Real(f64),
    /// A text.
    Text(String),
    /// A drawn element of the rule (in operations only).
    Element(NameId),
    /// The element of a family at the free index plus a constant: `v[i+1]`. There is none
    /// in a rule that was unrolled.
    Member(NameId, i32),
    /// A parameter of the op by its position (values and elements that a rule does
    /// not draw); in scripts, a variable by its number.
    Local(u32),
    /// `h.next`, `v.halfedge`.
    Follow(Pointer, Box<Expr>),
    /// `v.position`, an attribute.
    Read(Access, Box<Expr>),
    /// `v.position.x`: a component of a vector, 0 to 2.
    Component(u8, Box<Expr>),
    /// `vec3(x, y, z)`
    Vector(Box<[Expr; 3]>),
    /// An operator with one operand.
    Unary(Unary, Box<Expr>),
    /// An operator with two operands; `and` and `or` evaluate the right one only if needed.
    Binary(Binary, Box<Expr>, Box<Expr>),
    /// A built-in function.
    Call(Builtin, Vec<Expr>),
    /// `if c { x } else { y }`
    If(Box<Expr>, Box<Expr>, Box<Expr>),
    /// `mean(x for e in edges where c)`, `count(edges)`
    Fold(Box<Fold>),
}

/// A pointer of the mesh, as navigation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Pointer {
    Next,
    Prev,
    Twin,
    /// Of a halfedge: its origin.
    Vertex,
    /// Of a halfedge: where it ends.
    Target,
    Edge,
    Face,
    /// Of a vertex, edge or face: its halfedge.
    VertexHalfedge,
    EdgeHalfedge,
    FaceHalfedge,
}

/// A stored attribute of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Access {
    /// `v.position`
    Position,
}

/// An operator with one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Unary {
    NegateInt,
    NegateReal,
    NegateVec3,
    Not,
    ToReal,
}

/// An operator with two operands of fixed types.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Binary {
    AddInt,
    SubtractInt,
    MultiplyInt,
    /// Rounds towards minus infinity; by zero it is a run-time error.
    Div,
    /// Has the sign of the divisor; by zero it is a run-time error.
    Mod,
    AddReal,
    SubtractReal,
    MultiplyReal,
    DivideReal,
    AddVec3,
    SubtractVec3,
    /// Component by component.
    MultiplyVec3,
    /// A vector by a real on its right.
    ScaleVec3,
    /// A vector by a real on its right.
    DivideVec3,
    EqualInt,
    EqualReal,
    EqualVec3,
    EqualBool,
    EqualText,
    /// Two elements of one kind.
    EqualElement,
    LessInt,
    LessEqualInt,
    LessReal,
    LessEqualReal,
    And,
    Or,
}

/// A function that is part of the language. Types in, type out:
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Builtin {
    /// vertex -> int: its spokes. Of a face: its corners.
    DegreeVertex,
    DegreeFace,
    /// -> bool: does it lie on a hole?
    BoundaryVertex,
    BoundaryHalfedge,
    BoundaryEdge,
    /// face -> bool: is it a hole?
    IsHole,
    /// vertex, vertex -> bool: does an edge join them?
    Adjacent,
    /// edge -> bool
    LinkCondition,
    /// edge -> real; halfedge -> real
    LengthEdge,
    LengthHalfedge,
    /// vec3 -> real
    LengthVec3,
    /// face -> real
    Area,
    /// -> vec3
    NormalFace,
    NormalVertex,
    CentroidFace,
    /// edge -> vec3: its midpoint.
    CentroidEdge,
    /// real, real, real -> real; vec3, vec3, real -> vec3
    MixReal,
    MixVec3,
    Dot,
    Cross,
    /// vec3 -> vec3; the zero vector stays zero.
    Normalize,
    /// vec3, vec3 -> real
    Distance,
    /// vec3, vec3 -> real: the angle between two vectors in radians.
    Angle,
    AbsInt,
    AbsReal,
    MinInt,
    MaxInt,
    MinReal,
    MaxReal,
    Sqrt,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    /// real, real -> real: the angle of the point (second, first).
    Atan2,
    Exp,
    Log,
    Pow,
    Floor,
    Ceil,
    /// real -> int: half to even.
    Round,
}

/// The elements a loop or an aggregate runs over.
#[derive(Clone, Debug, PartialEq)]
pub enum Collection {
    /// `vertices`, `halfedges`, `edges`, `faces` (without holes), `holes`: all of the mesh.
    Vertices,
    /// All halfedges.
    Halfedges,
    /// All edges.
    Edges,
    /// All faces that are not holes.
    Faces,
    /// All holes.
    Holes,
    /// `v.halfedges`: its spokes, counterclockwise.
    VertexHalfedges(Expr),
    /// `v.edges`
    VertexEdges(Expr),
    /// `v.faces`, without holes
    VertexFaces(Expr),
    /// `v.neighbors`
    VertexNeighbors(Expr),
    /// `f.halfedges`
    FaceHalfedges(Expr),
    /// `f.vertices`
    FaceVertices(Expr),
    /// `f.edges`
    FaceEdges(Expr),
    /// `e.vertices`
    EdgeVertices(Expr),
    /// `e.faces`, without holes
    EdgeFaces(Expr),
}

impl Collection {
    /// The type of its elements.
    pub fn element(&self) -> Type {
        use Collection::*;
        match self {
            Vertices | VertexNeighbors(_) | FaceVertices(_) | EdgeVertices(_) => Type::Vertex,
            Halfedges | VertexHalfedges(_) | FaceHalfedges(_) => Type::Halfedge,
            Edges | VertexEdges(_) | FaceEdges(_) => Type::Edge,
            Faces | Holes | VertexFaces(_) | EdgeFaces(_) => Type::Face,
        }
    }
}

/// An aggregate over a collection.
#[derive(Clone, Debug, PartialEq)]
pub struct Fold {
    /// What is made of the values.
    pub function: FoldFunction,
    /// The variable's number, among the script's (or op's) variables.
    pub variable: u32,
    /// What it runs over.
    pub collection: Collection,
    /// Which elements count.
    pub filter: Option<Expr>,
    /// The value of each; for `count` of elements, `true`.
    pub body: Expr,
}

/// What an aggregate makes of its values. Of nothing: `sum` and `count` are zero; `mean`,
/// `min` and `max` are a run-time error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum FoldFunction {
    Mean,
    Sum,
    Min,
    Max,
    /// How many of the bodies are true.
    Count,
    /// Whether any, or all, of the bodies are true.
    Any,
    All,
}
