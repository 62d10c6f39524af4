//! Values in pointer code: names, pointers that are followed, entries of lists, conditions.

use crate::diagram::{Binary, Builtin, FoldFunction, Pointer, Type, Unary};

/// A parameter of a routine.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Parameter {
    pub name: String,
    pub ty: Type,
    /// The value if a call gives none; it may refer to earlier parameters.
    pub default: Option<Term>,
}

impl Parameter {
    /// A parameter without a default.
    pub fn new(name: String, ty: Type) -> Self {
        let default = None;
        Self { name, ty, default }
    }

    /// True if its default is the same for all calls.
    pub fn has_constant(&self) -> bool {
        let mut has_names = false;
        let default = self.default.as_ref();
        default.inspect(|term| term.names(&mut |_| has_names = true));
        default.is_some() && !has_names
    }
}

/// A loop over the indices of a cycle.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct IndexLoop {
    /// The name of the index, which runs from 0.
    pub index: String,
    /// The name of the number of indices.
    pub size: String,
}

/// An attribute that the program declares.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Attribute {
    /// Its name in the program.
    pub declared: String,
    /// Its name in code.
    pub name: String,
    /// The name of its column, where attributes are stored in columns.
    pub column: String,
    /// The type of the elements that have it.
    pub element: Type,
    /// The type of its values.
    pub ty: Type,
}

/// A value.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Term {
    Name(String),
    Bool(bool),
    Int(i64),
    Real(f64),
    /// `h.next`, `v.halfedge`
    Follow(Pointer, Box<Term>),
    /// `e.crease`
    Attribute(Attribute, Box<Term>),
    Unary(Unary, Box<Term>),
    Binary(Binary, Box<Term>, Box<Term>),
    Call(Function, Vec<Term>),
    /// A function of the program.
    Invoke(String, Vec<Term>),
    If(Box<Term>, Box<Term>, Box<Term>),
    Fold(Box<Fold>),
    /// The entry of a list at `shift` from the index, modulo its size; without an index, from 0.
    Member {
        list: String,
        index: Option<String>,
        shift: i64,
        size: String,
    },
    /// True if something holds for some index.
    Some(IndexLoop, Box<Term>),
}

/// An aggregate.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Fold {
    pub function: FoldFunction,
    pub ty: Type,
    pub variable: Parameter,
    /// The name of the elements around another that it runs over.
    pub around: &'static str,
    pub element: Term,
    pub filter: Option<Term>,
    pub body: Term,
    pub body_type: Type,
}

/// A function that is called.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Function {
    /// A builtin.
    Builtin(Builtin),
    /// An operation on values of this type.
    Of(Operation, Type),
    /// A function by its name among the spellings.
    Named(&'static str),
    /// The answer of a preview to a question with this name, about elements.
    OfPreview(&'static str),
}

/// The operations on vectors and matrices whose spelling depends on their type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Operation {
    /// An operator with two sides; the type is that of the left one.
    Operator(Binary),
    Negate,
    /// A builtin.
    Builtin(Builtin),
    /// A value of the type, from its parts or columns.
    Make,
    /// A value of the type, from a vector with one part less, and that part.
    Extend,
    /// The first parts, as a vector of that type.
    First(Type),
    /// A component.
    Part(u8),
    /// A column of a matrix.
    Column(u8),
}

impl Term {
    pub fn name(name: impl Into<String>) -> Self {
        Self::Name(name.into())
    }

    pub fn follow(self, pointer: Pointer) -> Self {
        Self::Follow(pointer, Box::new(self))
    }

    pub fn is(self, other: Self) -> Self {
        Self::Binary(Binary::EqualElement, Box::new(self), Box::new(other))
    }

    pub fn equals(self, other: Self) -> Self {
        Self::Binary(Binary::EqualInt, Box::new(self), Box::new(other))
    }

    pub fn differs_from(self, other: Self) -> Self {
        self.is(other).not()
    }

    pub fn not(self) -> Self {
        match self {
            Self::Unary(Unary::Not, term) => *term,
            Self::Bool(value) => Self::Bool(!value),
            term => Self::Unary(Unary::Not, Box::new(term)),
        }
    }

    pub fn and(self, other: Self) -> Self {
        Self::Binary(Binary::And, Box::new(self), Box::new(other))
    }

    pub fn or(self, other: Self) -> Self {
        Self::Binary(Binary::Or, Box::new(self), Box::new(other))
    }

    /// The condition that a face is a hole.
    pub fn hole(self) -> Self {
        Self::Call(Function::Builtin(Builtin::IsHole), vec![self])
    }

    /// A call of a function by its name among the spellings.
    pub fn call(name: &'static str, args: Vec<Self>) -> Self {
        Self::Call(Function::Named(name), args)
    }

    pub fn then(self, then: Self, otherwise: Self) -> Self {
        Self::If(Box::new(self), Box::new(then), Box::new(otherwise))
    }

    /// The condition that it holds for some index.
    pub fn for_some(self, indices: IndexLoop) -> Self {
        Self::Some(indices, Box::new(self))
    }

    /// Reports its parts.
    fn parts<'t>(&'t self, see: &mut dyn FnMut(&'t Term)) {
        match self {
            Self::Name(_) | Self::Bool(_) | Self::Int(_) | Self::Real(_) | Self::Member { .. } => {}
            Self::Some(_, of)
            | Self::Follow(_, of)
            | Self::Attribute(_, of)
            | Self::Unary(_, of) => see(of),
            Self::Binary(_, left, right) => [left, right].into_iter().for_each(|part| see(part)),
            Self::Call(_, args) | Self::Invoke(_, args) => args.iter().for_each(see),
            Self::If(condition, then, otherwise) => {
                [condition, then, otherwise].into_iter().for_each(|part| see(part));
            }
            Self::Fold(fold) => {
                [&fold.element].into_iter().chain(&fold.filter).chain([&fold.body]).for_each(see);
            }
        }
    }

    /// Reports every attribute in it.
    pub fn attributes(&self, see: &mut dyn FnMut(&Attribute)) {
        if let Self::Attribute(attribute, _) = self {
            see(attribute);
        }
        self.parts(&mut |part| part.attributes(see));
    }

    /// Reports every name in it.
    pub fn names(&self, see: &mut dyn FnMut(&str)) {
        match self {
            Self::Name(name) => see(name),
            Self::Member { list, index, shift, size } => {
                see(list);
                index.iter().for_each(|index| see(index));
                if *shift != 0 {
                    see(size);
                }
            }
            Self::Some(indices, _) => see(&indices.size),
            _ => {}
        }
        self.parts(&mut |part| part.names(see));
    }
}
