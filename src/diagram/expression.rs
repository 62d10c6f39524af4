//! Typed expressions: the values of conditions, of assignments and in scripts.
//!
//! An int is used as a real only through an explicit [`Unary::ToReal`], so that lowering an
//! expression never guesses.

use super::op::without_article;
use super::{Builtin, NameId};
use crate::mesh::{ElementKind, Elements};
use crate::source::Span;

/// The type of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Type {
    Bool,
    Int,
    Real,
    Vec2,
    Vec3,
    Vec4,
    Mat3,
    Mat4,
    Text,
    Vertex,
    Halfedge,
    Edge,
    Face,
}

impl Type {
    /// All types.
    pub const ALL: [Type; 13] = [
        Type::Bool,
        Type::Int,
        Type::Real,
        Type::Vec2,
        Type::Vec3,
        Type::Vec4,
        Type::Mat3,
        Type::Mat4,
        Type::Text,
        Type::Vertex,
        Type::Halfedge,
        Type::Edge,
        Type::Face,
    ];

    /// The type of this name.
    pub fn named(word: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|ty| ty.word() == word)
    }

    /// The word for it.
    pub fn word(self) -> &'static str {
        without_article(self.a_word())
    }

    /// The word with its article.
    pub fn a_word(self) -> &'static str {
        match self {
            Type::Bool => "a bool",
            Type::Int => "an int",
            Type::Real => "a real",
            Type::Vec2 => "a vec2",
            Type::Vec3 => "a vec3",
            Type::Vec4 => "a vec4",
            Type::Mat3 => "a mat3",
            Type::Mat4 => "a mat4",
            Type::Text => "a text",
            Type::Vertex => "a vertex",
            Type::Halfedge => "a halfedge",
            Type::Edge => "an edge",
            Type::Face => "a face",
        }
    }

    /// The kind of element that values of this type are.
    pub fn element_kind(self) -> Option<ElementKind> {
        match self {
            Type::Vertex => Some(ElementKind::Vertex),
            Type::Halfedge => Some(ElementKind::Halfedge),
            Type::Edge => Some(ElementKind::Edge),
            Type::Face => Some(ElementKind::Face),
            _ => None,
        }
    }

    /// The text of the zero of this type, if an attribute can have it.
    pub fn zero(self) -> Option<String> {
        match self {
            Type::Bool => Some("false".to_owned()),
            Type::Int | Type::Real => Some("0".to_owned()),
            _ if self.is_vector() || self.is_matrix() => Some(format!("{}(0)", self.word())),
            _ => None,
        }
    }

    /// True if values of this type are vectors.
    pub fn is_vector(self) -> bool {
        matches!(self, Type::Vec2 | Type::Vec3 | Type::Vec4)
    }

    /// True if values of this type are square matrices.
    pub fn is_matrix(self) -> bool {
        matches!(self, Type::Mat3 | Type::Mat4)
    }

    /// The number of components of a vector, of rows and columns of a matrix; else 1.
    pub fn size(self) -> u8 {
        match self {
            Type::Vec2 => 2,
            Type::Vec3 | Type::Mat3 => 3,
            Type::Vec4 | Type::Mat4 => 4,
            _ => 1,
        }
    }

    /// True if values of this type are elements of the mesh.
    pub fn is_element(self) -> bool {
        self.element_kind().is_some()
    }
}

impl From<ElementKind> for Type {
    fn from(kind: ElementKind) -> Self {
        match kind {
            ElementKind::Vertex => Type::Vertex,
            ElementKind::Halfedge => Type::Halfedge,
            ElementKind::Edge => Type::Edge,
            ElementKind::Face => Type::Face,
        }
    }
}

/// A typed expression.
#[derive(Clone, Debug, PartialEq)]
pub struct Expr {
    pub ty: Type,
    pub kind: ExprKind,
    pub span: Span,
}

#[derive(Clone, Debug, PartialEq)]
pub enum ExprKind {
    /// A truth value.
    Bool(bool),
    Int(i64),
    Real(f64),
    Text(String),
    /// A drawn element of the rule (in operations only).
    Element(NameId),
    /// The element of a family at the free index plus a constant: `v[i+1]`. There is none in an
    /// unrolled rule.
    Member(NameId, i32),
    /// A parameter of the op by its position (values and elements that a rule does
    /// not draw); in scripts, a variable by its number.
    Local(u32),
    /// `h.next`, `v.halfedge`.
    Follow(Pointer, Box<Expr>),
    /// `v.position`, an attribute.
    Read(Access, Box<Expr>),
    /// `v.position.x`: the part of a vector or matrix that begins at this number. Matrices are
    /// stored column by column, so their columns are parts, too.
    Component(u8, Box<Expr>),
    /// `vec3(x, y, z)`, `vec4(p, 1)`: a vector, or a matrix by its columns, from parts with as many
    /// components in total.
    Vector(Vec<Expr>),
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
    /// A function of the program, by its number there, and an argument for each parameter.
    Invoke(u32, Vec<Expr>),
    /// An operation of the program, by its number, with its arguments, which is tested and not
    /// applied: as a bool, whether it would apply; as a text, why it would refuse.
    Try(u32, Vec<Expr>),
    /// `let x = …` in a block that is a value: the variable's number, its value, and the value of
    /// the block.
    Let(u32, Box<Expr>, Box<Expr>),
}

/// A pointer of the mesh, as navigation.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
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

impl Pointer {
    /// The word after the dot.
    pub fn word(self) -> &'static str {
        match self {
            Self::Next => "next",
            Self::Prev => "prev",
            Self::Twin => "twin",
            Self::Vertex => "vertex",
            Self::Target => "target",
            Self::Edge => "edge",
            Self::Face => "face",
            Self::VertexHalfedge | Self::EdgeHalfedge | Self::FaceHalfedge => "halfedge",
        }
    }
}

/// A stored attribute of an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Access {
    /// `v.position`
    Position,
    /// An attribute that the program declares, by its number.
    Declared(u32),
}

/// An attribute that a program declares.
#[derive(Clone, Debug, PartialEq)]
pub struct Attribute {
    pub name: String,
    /// The span of its name.
    pub span: Span,
    pub docs: Vec<String>,
    /// The type of the elements that have it.
    pub element: Type,
    /// The type of its values.
    pub ty: Type,
    /// The place behind its type, where its default stands.
    pub behind: Span,
    /// The constant that a new element gets; `None` also if there is an error in it.
    pub default: Option<Expr>,
    /// True if it is declared without a default: then an op gives each new element its value.
    pub lacks_default: bool,
    /// True if a new element rather gets the value of what it [comes from](super::Rule::inherited).
    pub inherits: bool,
    /// True if it is temporary, and removed when the run is over.
    pub private: bool,
}

/// An operator with one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Unary {
    NegateInt,
    NegateReal,
    /// A vector or a matrix.
    NegateVector,
    Not,
    ToReal,
}

/// An operator with two operands of fixed types.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
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
    /// Of vectors and of matrices, component by component.
    AddVector,
    SubtractVector,
    /// Vectors, component by component.
    MultiplyVector,
    /// A vector or matrix by a real on its right.
    ScaleVector,
    DivideVector,
    MultiplyMatrices,
    /// A matrix by a vector on its right.
    Transform,
    EqualInt,
    EqualReal,
    /// Two vectors or two matrices.
    EqualVector,
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

/// The elements a loop or an aggregate runs over.
#[derive(Clone, Debug, PartialEq)]
pub enum Collection {
    /// Those of the whole mesh: `vertices`.
    All(Elements),
    /// Those around an element: `v.halfedges`.
    Around(Around, Expr),
}

/// The elements around an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Around {
    /// The spokes of a vertex, counterclockwise.
    VertexHalfedges,
    VertexEdges,
    /// Without holes.
    VertexFaces,
    VertexNeighbors,
    FaceHalfedges,
    FaceVertices,
    FaceEdges,
    /// The order in which corners are cut off, the best shaped first.
    FaceEars,
    /// The same for a triangulation that bends little.
    FacePatch,
    EdgeVertices,
    /// Without holes.
    EdgeFaces,
}

impl Collection {
    /// The elements of the whole mesh; `None` for those around an element.
    pub fn all(&self) -> Option<Elements> {
        match self {
            Self::All(of) => Some(*of),
            Self::Around(..) => None,
        }
    }

    /// The element that it lies around; `None` for one of the whole mesh.
    pub fn base(&self) -> Option<&Expr> {
        match self {
            Self::All(_) => None,
            Self::Around(_, base) => Some(base),
        }
    }

    /// The type of its elements.
    pub fn element(&self) -> Type {
        use Around::*;
        match self {
            Self::All(of) => of.kind().into(),
            Self::Around(around, _) => match around {
                VertexNeighbors | FaceVertices | EdgeVertices => Type::Vertex,
                VertexHalfedges | FaceHalfedges | FaceEars | FacePatch => Type::Halfedge,
                VertexEdges | FaceEdges => Type::Edge,
                VertexFaces | EdgeFaces => Type::Face,
            },
        }
    }
}

/// An aggregate over a collection.
#[derive(Clone, Debug, PartialEq)]
pub struct Fold {
    pub function: FoldFunction,
    /// The variable's number, among the script's (or op's) variables.
    pub variable: u32,
    pub collection: Collection,
    /// The condition that selects elements.
    pub filter: Option<Expr>,
    /// The value of each; for `count` of elements, `true`.
    pub body: Expr,
}

/// The function of an aggregate. Without elements, `sum` and `count` are zero; `mean`, `min`,
/// `max`, `argmin` and `argmax` are a run-time error.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FoldFunction {
    Mean,
    Sum,
    Min,
    Max,
    /// The first element with the least, or the greatest, value.
    ArgMin,
    ArgMax,
    /// The number of bodies that are true.
    Count,
    /// True if any, or all, of the bodies are true.
    Any,
    All,
}

impl FoldFunction {
    /// True if one body may decide the result, so that the others are not evaluated.
    pub fn ends_early(self) -> bool {
        self.ends_early_at(false) || self.ends_early_at(true)
    }

    /// True if a body with this value decides the result, which is this value.
    pub fn ends_early_at(self, value: bool) -> bool {
        matches!((self, value), (Self::Any, true) | (Self::All, false))
    }
}
