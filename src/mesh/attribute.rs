//! Typed columns of attributes, one value per slot of an element kind.
//!
//! A column is made with a default; every slot has it until a value is written, and has it again
//! when the slot is given to a new element. Columns are found by name once and read by [`ColumnId`]
//! afterwards. Positions are not a column: every vertex has one, and the mesh stores them
//! separately.

use std::fmt;

use glam::{DMat3, DMat4, DVec2, DVec3, DVec4};

use super::id::ElementKind;
use super::prefetch::prefetch;

/// A type that an attribute can have. Implemented for exactly the types of [`Value`].
pub trait Attribute: Copy + Sized {
    const TYPE: AttributeType;

    fn from_value(value: Value) -> Option<Self>;
    #[doc(hidden)]
    fn slice(data: &ColumnData) -> Option<&[Self]>;
    #[doc(hidden)]
    fn slice_mut(data: &mut ColumnData) -> Option<&mut [Self]>;
}

/// Declares the attribute types: one line, with the name, the number of components and the zero,
/// makes a value, a column and the conversions.
macro_rules! attribute_types {
    ($($variant:ident($type:ty) $name:literal $width:literal $zero:expr;)*) => {
        /// The type of a column.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum AttributeType { $($variant),* }

        /// One value of any attribute type.
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub enum Value { $($variant($type)),* }

        /// The values of a column, densely.
        #[derive(Clone, Debug)]
        pub enum ColumnData { $($variant(Vec<$type>)),* }

        impl AttributeType {
            /// All types.
            pub const ALL: &'static [Self] = &[$(Self::$variant),*];

            pub fn name(self) -> &'static str {
                match self { $(Self::$variant => $name),* }
            }

            /// The number of components of a value.
            #[inline]
            pub fn width(self) -> usize {
                match self { $(Self::$variant => $width),* }
            }

            /// The value whose components are all zero.
            pub fn zero(self) -> Value {
                match self { $(Self::$variant => Value::$variant($zero)),* }
            }

            /// The bytes of a value in a column.
            #[inline]
            pub(crate) fn size(self) -> usize {
                match self { $(Self::$variant => size_of::<$type>()),* }
            }
        }

        impl Value {
            /// The value as one number, to be shown in colour: a vector or matrix by its length
            /// (Frobenius norm), a truth value as 0 or 1.
            pub fn magnitude(self) -> f64 {
                match self {
                    Self::Bool(holds) => f64::from(u8::from(holds)),
                    Self::Int(count) => count as f64,
                    Self::Real(real) => real,
                    other => other.reals().iter().map(|x| x * x).sum::<f64>().sqrt(),
                }
            }

            pub fn attribute_type(self) -> AttributeType {
                match self { $(Self::$variant(_) => AttributeType::$variant),* }
            }

            pub(super) fn column(self, len: usize) -> ColumnData {
                match self { $(Self::$variant(x) => ColumnData::$variant(vec![x; len])),* }
            }
        }

        impl ColumnData {
            /// The type of the values.
            #[inline]
            pub fn attribute_type(&self) -> AttributeType {
                match self { $(Self::$variant(_) => AttributeType::$variant),* }
            }

            /// The number of values.
            pub fn len(&self) -> usize {
                match self { $(Self::$variant(xs) => xs.len()),* }
            }

            /// True if there are no values.
            pub fn is_empty(&self) -> bool {
                self.len() == 0
            }

            /// Calls `see` with each value, in order.
            pub fn each(&self, mut see: impl FnMut(Value)) {
                match self { $(Self::$variant(xs) => xs.iter().for_each(|&x| see(Value::$variant(x)))),* }
            }

            /// The address of the values, and their number.
            #[cfg(feature = "native")]
            #[inline]
            pub(super) fn memory(&self) -> (*const u8, usize) {
                match self { $(Self::$variant(xs) => (xs.as_ptr().cast(), xs.len())),* }
            }

            /// As [`ColumnData::memory`], for writing.
            #[cfg(feature = "native")]
            #[inline]
            pub(super) fn memory_mut(&mut self) -> (*mut u8, usize) {
                match self { $(Self::$variant(xs) => (xs.as_mut_ptr().cast(), xs.len())),* }
            }

            /// Requests the memory of a value.
            pub(super) fn prefetch(&self, index: usize) {
                match self { $(Self::$variant(xs) => prefetch(xs, index),)* }
            }

            pub(super) fn get(&self, index: usize) -> Option<Value> {
                match self { $(Self::$variant(xs) => xs.get(index).copied().map(Value::$variant)),* }
            }

            /// Returns false if the index or the type is not the column's.
            pub(super) fn set(&mut self, index: usize, value: Value) -> bool {
                match (self, value) {
                    $((Self::$variant(xs), Value::$variant(x)) => match xs.get_mut(index) {
                        Some(slot) => { *slot = x; true }
                        None => false,
                    },)*
                    _ => false,
                }
            }

            pub(super) fn fill(&mut self, value: Value) {
                match (self, value) {
                    $((Self::$variant(xs), Value::$variant(x)) => xs.fill(x),)*
                    _ => {}
                }
            }

            /// The values at some places, in their order.
            pub(super) fn gathered(&self, places: &[u32]) -> Self {
                match self {
                    $(Self::$variant(xs) => {
                        Self::$variant(places.iter().map(|&place| xs[place as usize]).collect())
                    })*
                }
            }

            /// Reserves room for `more` further values; false if there is no memory.
            pub(super) fn reserve(&mut self, more: usize) -> bool {
                match self { $(Self::$variant(xs) => xs.try_reserve_exact(more).is_ok()),* }
            }

            /// The bytes that one value takes, and those that all take.
            fn bytes(&self) -> [usize; 2] {
                let size = self.attribute_type().size();
                match self { $(Self::$variant(xs) => [size, size * xs.capacity()]),* }
            }

            fn shrink(&mut self, len: usize) {
                match self { $(Self::$variant(xs) => xs.truncate(len)),* }
            }

            #[inline]
            fn reset(&mut self, index: usize, value: &Value) {
                match (self, value) {
                    $((Self::$variant(xs), Value::$variant(x)) => {
                        if let Some(slot) = xs.get_mut(index) {
                            *slot = *x;
                        }
                    })*
                    _ => {}
                }
            }

            #[inline]
            fn grow(&mut self, len: usize, value: &Value) {
                match (self, value) {
                    $((Self::$variant(xs), Value::$variant(x)) => match xs.len() + 1 == len {
                        true => xs.push(*x),
                        false => xs.resize(len, *x),
                    },)*
                    _ => {}
                }
            }
        }

        $(impl Attribute for $type {
            const TYPE: AttributeType = AttributeType::$variant;

            fn from_value(value: Value) -> Option<Self> {
                match value { Value::$variant(x) => Some(x), _ => None }
            }

            fn slice(data: &ColumnData) -> Option<&[Self]> {
                match data { ColumnData::$variant(xs) => Some(xs), _ => None }
            }

            fn slice_mut(data: &mut ColumnData) -> Option<&mut [Self]> {
                match data { ColumnData::$variant(xs) => Some(xs), _ => None }
            }
        })*
    };
}

attribute_types! {
    Bool(bool) "bool" 1 false;
    Int(i64) "int" 1 0;
    Real(f64) "real" 1 0.0;
    Vec2(DVec2) "vec2" 2 DVec2::ZERO;
    Vec3(DVec3) "vec3" 3 DVec3::ZERO;
    Vec4(DVec4) "vec4" 4 DVec4::ZERO;
    Mat3(DMat3) "mat3" 9 DMat3::ZERO;
    Mat4(DMat4) "mat4" 16 DMat4::ZERO;
}

impl Value {
    /// The reals that make up a value, matrices column by column; none for a bool or an int.
    pub fn reals(&self) -> &[f64] {
        match self {
            Self::Bool(_) | Self::Int(_) => &[],
            Self::Real(x) => std::slice::from_ref(x),
            Self::Vec2(x) => AsRef::<[f64; 2]>::as_ref(x),
            Self::Vec3(x) => AsRef::<[f64; 3]>::as_ref(x),
            Self::Vec4(x) => AsRef::<[f64; 4]>::as_ref(x),
            Self::Mat3(x) => AsRef::<[f64; 9]>::as_ref(x),
            Self::Mat4(x) => AsRef::<[f64; 16]>::as_ref(x),
        }
    }

    /// The value made of these reals, the inverse of [`Value::reals`]; `None` if they are too many
    /// or too few, or the type is not made of reals.
    pub fn from_reals(ty: AttributeType, reals: &[f64]) -> Option<Self> {
        use AttributeType::{Mat3, Mat4, Real, Vec2, Vec3, Vec4};
        match (ty, reals) {
            (Real, &[x]) => Some(Self::Real(x)),
            (Vec2, &[x, y]) => Some(Self::Vec2(DVec2::new(x, y))),
            (Vec3, &[x, y, z]) => Some(Self::Vec3(DVec3::new(x, y, z))),
            (Vec4, &[x, y, z, w]) => Some(Self::Vec4(DVec4::new(x, y, z, w))),
            (Mat3, reals) => Some(Self::Mat3(DMat3::from_cols_array(reals.try_into().ok()?))),
            (Mat4, reals) => Some(Self::Mat4(DMat4::from_cols_array(reals.try_into().ok()?))),
            _ => None,
        }
    }

    /// True if the values agree bit for bit, which for reals is not quite `==`.
    pub fn is_identical(self, other: Self) -> bool {
        match self {
            Self::Bool(_) | Self::Int(_) => self == other,
            _ => {
                let bits = |x: &f64| x.to_bits();
                let [ours, theirs] = [self.reals(), other.reals()];
                self.attribute_type() == other.attribute_type()
                    && ours.iter().map(bits).eq(theirs.iter().map(bits))
            }
        }
    }
}

impl fmt::Display for AttributeType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The place of a column in its mesh, and in every clone of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ColumnId {
    pub kind: ElementKind,
    pub(super) place: u32,
}

/// A column of that name exists already, with values of another type.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ColumnConflict {
    pub kind: ElementKind,
    pub name: String,
    pub has: AttributeType,
    pub wanted: AttributeType,
}

impl fmt::Display for ColumnConflict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { kind, name, has, wanted } = self;
        write!(f, "the {kind} attribute `{name}` is of type {has}, not {wanted}")
    }
}

impl std::error::Error for ColumnConflict {}

/// True if a program can contain the name of an attribute, and files hold it.
pub fn is_public_name(name: &str) -> bool {
    !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '\'')
}

/// One column with its name and default.
#[derive(Clone, Debug)]
pub struct Column {
    pub(super) name: String,
    pub(super) default: Value,
    pub(super) data: ColumnData,
}

impl Column {
    pub fn name(&self) -> &str {
        &self.name
    }

    pub fn attribute_type(&self) -> AttributeType {
        self.default.attribute_type()
    }

    /// True if a program can contain the name. Columns with other names are scratch or bookkeeping,
    /// and are not written to files.
    pub fn is_public(&self) -> bool {
        is_public_name(&self.name)
    }

    pub fn default_value(&self) -> Value {
        self.default
    }

    /// All values by slot, dead slots included.
    #[inline]
    pub fn data(&self) -> &ColumnData {
        &self.data
    }
}

/// The columns of one element kind.
#[derive(Clone, Debug, Default)]
pub(super) struct Columns(pub(super) Vec<Column>);

impl Columns {
    #[inline]
    pub(super) fn reset(&mut self, index: usize) {
        for column in &mut self.0 {
            column.data.reset(index, &column.default);
        }
    }

    /// The bytes that the columns take.
    pub(super) fn bytes(&self) -> usize {
        self.0.iter().map(|column| column.data.bytes()[1]).sum()
    }

    /// The bytes that the values of one element take.
    pub(super) fn bytes_of_one(&self) -> usize {
        self.0.iter().map(|column| column.data.bytes()[0]).sum()
    }

    /// Reserves room for `more` further values in each column; false if there is no memory.
    pub(super) fn reserve(&mut self, more: usize) -> bool {
        self.0.iter_mut().all(|column| column.data.reserve(more))
    }

    pub(super) fn shrink(&mut self, len: usize) {
        for column in &mut self.0 {
            column.data.shrink(len);
        }
    }

    #[inline]
    pub(super) fn grow(&mut self, len: usize) {
        for column in &mut self.0 {
            column.data.grow(len, &column.default);
        }
    }
}
