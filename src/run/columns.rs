//! The columns of a program's attributes on a mesh.
//!
//! Before a run each attribute that the code uses gets a column, or takes over the one of its name
//! that the mesh already has. Scratch attributes have names that no file can contain, and are
//! removed after the run.

use super::lower::Names;
use crate::compile::lower;
use crate::diagnostic::Diagnostic;
use crate::diagram::{Attribute, Type};
use crate::mesh::{ColumnId, ElementKind, Mesh, Value, WantedAttribute};
use crate::rewrite::{Assembler, Code, Inst, Machine, Unwatched};
use crate::source::Span;

/// The columns that a run needs, by the numbers of the attributes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Columns(Vec<Option<Needed>>);

/// A column that is needed.
#[derive(Clone, Debug)]
struct Needed {
    kind: ElementKind,
    name: String,
    /// The value of a new element.
    default: Value,
    private: bool,
    /// Whether the code may write to it.
    written: bool,
    span: Span,
}

impl Columns {
    /// The columns that the given code needs, with that of the functions that it calls.
    ///
    /// # Errors
    /// The default of an attribute has no value, such as `1 div 0`.
    pub(super) fn of<'c>(
        attributes: &[Attribute],
        code: impl IntoIterator<Item = &'c Code>,
    ) -> Result<Self, Diagnostic> {
        let (mut used, mut written) =
            (vec![false; attributes.len()], vec![false; attributes.len()]);
        for inst in code.into_iter().flat_map(Code::with_called).flat_map(|code| &code.insts) {
            let (attribute, writes) = match inst {
                Inst::LoadAttribute { attribute, .. } => (*attribute, false),
                Inst::StoreAttribute { attribute, .. } | Inst::HoldAttribute { attribute, .. } => {
                    (*attribute, true)
                }
                _ => continue,
            };
            if let Some(used) = used.get_mut(usize::from(attribute)) {
                *used = true;
                written[usize::from(attribute)] |= writes;
            }
        }
        let needed = (0..).zip(attributes.iter().zip(used.into_iter().zip(written)));
        let needed = needed.map(|(number, (attribute, (used, written))): (u32, _)| {
            let kind = attribute.element.element_kind().filter(|_| used);
            let needed = kind.map(|kind| {
                let name = &attribute.name;
                Ok(Needed {
                    kind,
                    name: match attribute.private {
                        true => format!("private {number} {name}"),
                        false => name.clone(),
                    },
                    default: default(attribute)?,
                    private: attribute.private,
                    written,
                    span: attribute.span,
                })
            });
            needed.transpose()
        });
        Ok(Self(needed.collect::<Result<_, _>>()?))
    }

    /// The attributes, without scratch attributes.
    pub(super) fn public(&self) -> impl Iterator<Item = WantedAttribute<'_>> {
        let needed = self.0.iter().flatten().filter(|needed| !needed.private);
        needed.map(|needed| (needed.kind, needed.name.as_str(), needed.default))
    }

    /// The kind and the name of each column, with the number of its attribute.
    pub(crate) fn names(&self) -> impl Iterator<Item = (ElementKind, &str, u16)> {
        let all = (0..).zip(&self.0);
        all.filter_map(|(number, needed)| {
            needed.as_ref().map(|needed| (needed.kind, needed.name.as_str(), number))
        })
    }

    /// Adds the columns to a mesh, and returns their ids by the numbers of the attributes.
    ///
    /// # Errors
    /// The mesh has a column of the same name with values of another type.
    pub(crate) fn bind(&self, mesh: &mut Mesh) -> Result<Vec<Option<ColumnId>>, Diagnostic> {
        let bind = |needed: &Needed| {
            let (kind, name, default) = (needed.kind, &needed.name, needed.default);
            let column = mesh.add_column(kind, name, default).map_err(|conflict| {
                let message = format!("{conflict} on this mesh");
                Diagnostic::error("attribute-conflict", message, needed.span)
            })?;
            // A column that was already there may have another default; its type is the same.
            let _ = mesh.set_default(column, default);
            Ok(column)
        };
        let mut bind = bind;
        self.0.iter().map(|needed| needed.as_ref().map(&mut bind)).map(Option::transpose).collect()
    }

    /// Resets the scratch attributes that the code may have written to their defaults.
    pub(crate) fn clear(&self, mesh: &mut Mesh) {
        for needed in self.0.iter().flatten().filter(|needed| needed.private && needed.written) {
            if let Some(column) = mesh.find_column(needed.kind, &needed.name) {
                mesh.clear_column(column);
            }
        }
    }

    /// Removes the scratch attributes from a mesh.
    pub(crate) fn release(&self, mesh: &mut Mesh) {
        for needed in self.0.iter().flatten().filter(|needed| needed.private) {
            if let Some(column) = mesh.find_column(needed.kind, &needed.name) {
                mesh.remove_column(column);
            }
        }
    }
}

/// The initial value of an attribute: its default, or zero.
fn default(attribute: &Attribute) -> Result<Value, Diagnostic> {
    let mut machine = Machine::default();
    let Some(default) = &attribute.default else { return Ok(value(attribute.ty, &[])) };
    let (mut asm, mut names) = (Assembler::new(), Names::default());
    let from = lower(&mut asm, &mut names, default);
    let failed = |message: String| {
        let message = format!("the default of `{}` has no value: {message}", attribute.name);
        Diagnostic::error("attribute-default", message, default.span)
    };
    let code = asm.finish().map_err(|error| failed(error.to_string()))?;
    let outcome = machine.run(&mut Mesh::default(), &code, &[], &mut Unwatched);
    outcome.map_err(|trap| failed(trap.to_string()))?;
    let slots = machine.window().get(usize::from(from.0)..);
    Ok(value(attribute.ty, slots.unwrap_or_default()))
}

/// The value of a type in slots; missing slots count as zero.
fn value(ty: Type, slots: &[u64]) -> Value {
    let slot = |at: usize| slots.get(at).copied().unwrap_or(0);
    let real = |at: usize| f64::from_bits(slot(at));
    match ty {
        Type::Bool => Value::Bool(slot(0) != 0),
        Type::Vec2 => Value::Vec2(std::array::from_fn(real).into()),
        Type::Vec3 => Value::Vec3(std::array::from_fn(real).into()),
        Type::Vec4 => Value::Vec4(std::array::from_fn(real).into()),
        Type::Mat3 => Value::Mat3(glam::DMat3::from_cols_array(&std::array::from_fn(real))),
        Type::Mat4 => Value::Mat4(glam::DMat4::from_cols_array(&std::array::from_fn(real))),
        Type::Real => Value::Real(real(0)),
        // No attribute holds a text or an element.
        Type::Int | Type::Text | Type::Vertex | Type::Halfedge | Type::Edge | Type::Face => {
            Value::Int(slot(0) as i64)
        }
    }
}
