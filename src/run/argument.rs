//! Arguments: values that a caller passes for the parameters of a script.

use std::num::TryFromIntError;

use glam::{DMat3, DMat4, DVec2, DVec3, DVec4};

use crate::compile::width;
use crate::diagram::Type;
use crate::mesh::{EdgeId, Element, ElementKind, FaceId, HalfedgeId, Mesh, VertexId};

/// A value for a parameter.
#[derive(Clone, Debug, PartialEq)]
pub enum Argument {
    Bool(bool),
    Int(i64),
    /// A finite number, as is each component of a vector.
    Real(f64),
    /// The components of a vector or matrix of this type, as many as it has; matrices column by
    /// column.
    Reals(Type, Vec<f64>),
    Text(String),
    /// An element of the mesh that the script runs on.
    Element(ElementKind, u32),
}

impl Argument {
    /// Parses a value of a type: `true`, `12`, `0.5`, `1,2,3`, any text, or the number of an
    /// element.
    pub fn parse(text: &str, ty: Type) -> Option<Self> {
        let text = text.trim();
        match ty {
            Type::Bool => text.parse().ok().map(Self::Bool),
            Type::Int => text.parse().ok().map(Self::Int),
            Type::Real => real(text).map(Self::Real),
            Type::Vec2 | Type::Vec3 | Type::Vec4 | Type::Mat3 | Type::Mat4 => {
                reals(text, ty).map(|parts| Self::Reals(ty, parts))
            }
            Type::Text => Some(Self::Text(text.to_owned())),
            Type::Vertex | Type::Halfedge | Type::Edge | Type::Face => {
                element(ty.element_kind()?, text)
            }
        }
    }

    /// The type of the value.
    pub fn ty(&self) -> Type {
        match self {
            Self::Bool(_) => Type::Bool,
            Self::Int(_) => Type::Int,
            Self::Real(_) => Type::Real,
            Self::Reals(ty, _) => *ty,
            Self::Text(_) => Type::Text,
            Self::Element(kind, _) => (*kind).into(),
        }
    }

    /// The number of the element, if it is one that is not in the mesh.
    pub(super) fn missing_in(&self, mesh: &Mesh) -> Option<u32> {
        match *self {
            Self::Element(kind, id) if !mesh.is_alive(kind, id) => Some(id),
            _ => None,
        }
    }

    /// The number of its components, unless a vector or matrix of its type has as many.
    pub(super) fn wrong_count(&self) -> Option<usize> {
        match self {
            Self::Reals(ty, parts) => {
                let is_wide = ty.is_vector() || ty.is_matrix();
                let fits = is_wide && parts.len() == usize::from(width(*ty));
                (!fits).then_some(parts.len())
            }
            _ => None,
        }
    }

    /// Whether its numbers are finite.
    pub(super) fn is_finite(&self) -> bool {
        match self {
            Self::Real(value) => value.is_finite(),
            Self::Reals(_, parts) => parts.iter().all(|part| part.is_finite()),
            _ => true,
        }
    }

    /// Appends the slots of the value; a text is added to the texts of the code.
    pub(super) fn fill(&self, texts: &mut Vec<String>, slots: &mut Vec<u64>) {
        match self {
            Self::Bool(value) => slots.push(u64::from(*value)),
            Self::Int(value) => slots.push(*value as u64),
            Self::Real(value) => slots.push(value.to_bits()),
            Self::Reals(_, parts) => slots.extend(parts.iter().map(|part| part.to_bits())),
            Self::Text(text) => {
                // Equal texts have equal numbers.
                let number = texts.iter().position(|known| known == text).unwrap_or_else(|| {
                    texts.push(text.clone());
                    texts.len() - 1
                });
                slots.push(number as u64);
            }
            Self::Element(_, id) => slots.push(u64::from(*id)),
        }
    }
}

/// Conversions to arguments: `edge.into()`, `0.5.into()`.
macro_rules! from {
    ($($type:ty: $from:expr;)*) => {
        $(impl From<$type> for Argument {
            fn from(value: $type) -> Self {
                let from: fn($type) -> Self = $from;
                from(value)
            }
        })*
    };
}

from! {
    bool: Self::Bool;
    i64: Self::Int;
    i32: |value| Self::Int(value.into());
    u32: |value| Self::Int(value.into());
    f64: Self::Real;
    f32: |value| Self::Real(value.into());
    String: Self::Text;
    &str: |value| Self::Text(value.to_owned());
    [f64; 2]: |value| Self::Reals(Type::Vec2, value.into());
    [f64; 3]: |value| Self::Reals(Type::Vec3, value.into());
    [f64; 4]: |value| Self::Reals(Type::Vec4, value.into());
    DVec2: |value| Self::Reals(Type::Vec2, value.to_array().into());
    DVec3: |value| Self::Reals(Type::Vec3, value.to_array().into());
    DVec4: |value| Self::Reals(Type::Vec4, value.to_array().into());
    DMat3: |value| Self::Reals(Type::Mat3, value.to_cols_array().into());
    DMat4: |value| Self::Reals(Type::Mat4, value.to_cols_array().into());
    Element: |value| Self::Element(value.kind, value.index);
    VertexId: |value| Element::from(value).into();
    HalfedgeId: |value| Element::from(value).into();
    EdgeId: |value| Element::from(value).into();
    FaceId: |value| Element::from(value).into();
}

/// Conversions of whole numbers that may be too large.
macro_rules! try_from {
    ($($type:ty)*) => {
        $(impl TryFrom<$type> for Argument {
            type Error = TryFromIntError;

            fn try_from(value: $type) -> Result<Self, TryFromIntError> {
                value.try_into().map(Self::Int)
            }
        })*
    };
}

try_from! { u64 usize isize }

/// An example of the text of a value of a type, if there is a short one.
pub(super) fn sample(ty: Type) -> Option<&'static str> {
    match ty {
        Type::Bool => Some("true"),
        Type::Int => Some("12"),
        Type::Real => Some("0.5"),
        Type::Vec2 => Some("1,0.5"),
        Type::Vec3 => Some("1,0.5,2"),
        Type::Vec4 => Some("1,0.5,2,1"),
        _ => None,
    }
}

/// A description of the values of a type, for a message about a wrong value.
pub(super) fn wanted(ty: Type) -> String {
    let words = match ty {
        Type::Bool => return "`true` or `false`".to_owned(),
        Type::Int => "a whole number",
        Type::Real => "a number",
        Type::Vec2 => "two numbers",
        Type::Vec3 => "three numbers",
        Type::Vec4 => "four numbers",
        Type::Mat3 => "nine numbers with commas between them, column by column",
        Type::Mat4 => "sixteen numbers with commas between them, column by column",
        Type::Text => "a text",
        Type::Vertex | Type::Halfedge | Type::Edge | Type::Face => "the number of an element",
    };
    match sample(ty) {
        Some(sample) => format!("{words} such as `{sample}`"),
        None => words.to_owned(),
    }
}

fn real(text: &str) -> Option<f64> {
    text.trim().parse().ok().filter(|value: &f64| value.is_finite())
}

/// Parses the components of a vector or matrix, with or without parentheses.
fn reals(text: &str, ty: Type) -> Option<Vec<f64>> {
    let inner = text.strip_prefix('(').map_or(Some(text), |rest| rest.strip_suffix(')'))?;
    let parts: Option<Vec<f64>> = inner.split(',').map(real).collect();
    parts.filter(|parts| parts.len() == usize::from(width(ty)))
}

fn element(kind: ElementKind, text: &str) -> Option<Argument> {
    text.parse().ok().map(|id| Argument::Element(kind, id))
}
