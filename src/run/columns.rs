//! The columns of a program's attributes on a mesh.
//!
//! Before a run each attribute that the code uses gets a column, or takes over the one of its name
//! that the mesh already has. Scratch attributes have names that no file can contain, and are
//! removed after the run.
//!
//! A question leaves the mesh as it is: an attribute that the mesh lacks has a *stand-in* meanwhile,
//! a column with such a name, all of whose values are the default. It may stay for the next question
//! until the mesh has the attribute itself.

use super::lower::Names;
use crate::compile::lower;
use crate::diagnostic::Diagnostic;
use crate::diagram::{Attribute, Type};
use crate::mesh::{Column, ColumnConflict, ColumnId, ElementKind, Mesh, Value, WantedAttribute};
use crate::rewrite::{Assembler, Code, Inst, Machine, Unwatched};
use crate::source::Span;

/// The columns of attributes on a mesh, by their numbers, and the defaults that some of them have in
/// the program but not on the mesh.
pub(crate) type ToAsk = (Vec<Option<ColumnId>>, Vec<(ColumnId, Value)>);

/// The columns that a run needs, by the numbers of the attributes.
#[derive(Clone, Debug, Default)]
pub(crate) struct Columns {
    needed: Vec<Option<Needed>>,
    /// The attributes that are declared with a default, and that the code does not use: new elements
    /// have the default where the mesh has the attribute.
    unused: Vec<(ElementKind, String, Value)>,
}

/// A column that is needed.
#[derive(Clone, Debug)]
struct Needed {
    kind: ElementKind,
    name: String,
    /// The name of the column that stands in for it.
    stand_in: String,
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
                Inst::StoreAttribute { attribute, .. } | Inst::DeferAttribute { attribute, .. } => {
                    (*attribute, true)
                }
                _ => continue,
            };
            if let Some(used) = used.get_mut(usize::from(attribute)) {
                *used = true;
                written[usize::from(attribute)] |= writes;
            }
        }
        let unused = attributes.iter().zip(&used).filter(|(attribute, used)| {
            !*used && !attribute.private && attribute.default.is_some()
        });
        let unused = unused.filter_map(|(attribute, _)| {
            let kind = attribute.element.element_kind()?;
            // One without a value is an error where it is used.
            Some((kind, attribute.name.clone(), default(attribute).ok()?))
        });
        let unused = unused.collect();
        let needed = (0..).zip(attributes.iter().zip(used.into_iter().zip(written)));
        let needed = needed.map(|(number, (attribute, (used, written))): (u32, _)| {
            let kind = attribute.element.element_kind().filter(|_| used);
            let needed = kind.map(|kind| {
                let name = &attribute.name;
                let default = default(attribute)?;
                Ok(Needed {
                    kind,
                    name: match attribute.private {
                        true => format!("private {number} {name}"),
                        false => name.clone(),
                    },
                    stand_in: format!("{}{default:?}", stand_in(name)),
                    default,
                    private: attribute.private,
                    written,
                    span: attribute.span,
                })
            });
            needed.transpose()
        });
        Ok(Self { needed: needed.collect::<Result<_, _>>()?, unused })
    }

    /// The attributes, without scratch attributes.
    pub(super) fn public(&self) -> impl Iterator<Item = WantedAttribute<'_>> {
        let needed = self.needed.iter().flatten().filter(|needed| !needed.private);
        needed.map(|needed| (needed.kind, needed.name.as_str(), needed.default))
    }

    /// The kind and the name of each column, with the number of its attribute.
    pub(crate) fn names(&self) -> impl Iterator<Item = (ElementKind, &str, u16)> {
        let all = (0..).zip(&self.needed);
        all.filter_map(|(number, needed)| {
            needed.as_ref().map(|needed| (needed.kind, needed.name.as_str(), number))
        })
    }

    /// Adds the columns to a mesh, and returns their ids by the numbers of the attributes. All
    /// attributes of the program that the mesh has get its defaults.
    ///
    /// # Errors
    /// The mesh has a column of the same name with values of another type; it is as it was.
    pub(crate) fn bind(&self, mesh: &mut Mesh) -> Result<Vec<Option<ColumnId>>, Diagnostic> {
        for needed in self.needed.iter().flatten() {
            if mesh.find_column(needed.kind, &needed.name).is_some() {
                let known = mesh.add_column(needed.kind, &needed.name, needed.default);
                known.map_err(|conflict| needed.conflict(&conflict))?;
            }
        }
        for (kind, name, default) in &self.unused {
            if let Some(column) = mesh.find_column(*kind, name) {
                // One of another type is another attribute.
                let _ = mesh.set_default(column, *default);
            }
        }
        let mut bind = |needed: &Needed| {
            let (kind, name, default) = (needed.kind, &needed.name, needed.default);
            let column = mesh.add_column(kind, name, default).map_err(|c| needed.conflict(&c))?;
            // A column that was already there may have another default; its type is the same.
            let _ = mesh.set_default(column, default);
            Ok(column)
        };
        self.needed.iter().map(|needed| needed.as_ref().map(&mut bind).transpose()).collect()
    }

    /// Finds the columns on a mesh that stays as it is, but for scratch attributes and stand-ins.
    ///
    /// # Errors
    /// As for [`bind`](Self::bind).
    pub(crate) fn bind_to_ask(&self, mesh: &mut Mesh) -> Result<ToAsk, Diagnostic> {
        let mut defaults = Vec::new();
        let mut bind = |needed: &Needed| {
            let Needed { kind, name, stand_in, default, private, .. } = needed;
            if !private && mesh.find_column(*kind, name).is_none() {
                let known = mesh.find_column(*kind, stand_in);
                return Ok(known.unwrap_or_else(|| mesh.append_column(*kind, stand_in, *default)));
            }
            let column = mesh.add_column(*kind, name, *default);
            let column = column.map_err(|conflict| needed.conflict(&conflict))?;
            let has = mesh.column(column).map(Column::default_value);
            if has.is_some_and(|has| !has.is_identical(*default)) {
                defaults.push((column, *default));
            }
            Ok(column)
        };
        let columns = self.needed.iter().map(|needed| needed.as_ref().map(&mut bind).transpose());
        Ok((columns.collect::<Result<_, _>>()?, defaults))
    }

    /// True if a mesh lacks one of the attributes, or has another default for it.
    pub(crate) fn are_new_to(&self, mesh: &Mesh) -> bool {
        let column = |kind, name| mesh.find_column(kind, name).and_then(|id| mesh.column(id));
        let has_other =
            |column: &Column, default: Value| !column.default_value().is_identical(default);
        let mut unused = self.unused.iter();
        self.public().any(|(kind, name, default)| {
            column(kind, name).is_none_or(|column| has_other(column, default))
        }) || unused.any(|(kind, name, default)| {
            column(*kind, name).is_some_and(|column| has_other(column, *default))
        })
    }

    /// Removes the stand-ins for the attributes. Returns whether there were any.
    pub(crate) fn replace_stand_ins(&self, mesh: &mut Mesh) -> bool {
        self.public().fold(false, |any, (kind, name, _)| any | replace_stand_in(mesh, kind, name))
    }

    /// Resets the scratch attributes that the code may have written to their defaults.
    pub(crate) fn clear(&self, mesh: &mut Mesh) {
        let needed = self.needed.iter().flatten();
        for needed in needed.filter(|needed| needed.private && needed.written) {
            if let Some(column) = mesh.find_column(needed.kind, &needed.name) {
                mesh.clear_column(column);
            }
        }
    }

    /// Removes the scratch attributes from a mesh.
    pub(crate) fn release(&self, mesh: &mut Mesh) {
        for needed in self.needed.iter().flatten().filter(|needed| needed.private) {
            if let Some(column) = mesh.find_column(needed.kind, &needed.name) {
                mesh.remove_column(column);
            }
        }
    }
}

impl Needed {
    fn conflict(&self, conflict: &ColumnConflict) -> Diagnostic {
        let message = format!("{conflict} on this mesh");
        Diagnostic::error("attribute-conflict", message, self.span)
    }
}

/// The beginning of the names of all stand-ins.
const STANDS_IN: &str = "for ";

/// The beginning of the names of the stand-ins for an attribute, which end with the default.
fn stand_in(name: &str) -> String {
    format!("{STANDS_IN}{name} ")
}

/// Removes the stand-ins for an attribute from a mesh. Returns whether there were any.
pub(crate) fn replace_stand_in(mesh: &mut Mesh, kind: ElementKind, name: &str) -> bool {
    remove(mesh, kind, &stand_in(name))
}

/// Removes all stand-ins from a mesh.
pub(crate) fn remove_stand_ins(mesh: &mut Mesh) {
    for kind in ElementKind::ALL {
        remove(mesh, kind, STANDS_IN);
    }
}

/// Removes the columns whose names begin so. Returns whether there were any.
fn remove(mesh: &mut Mesh, kind: ElementKind, beginning: &str) -> bool {
    let begins = |(_, column): &(ColumnId, &Column)| column.name().starts_with(beginning);
    let found: Vec<_> = mesh.columns(kind).filter(begins).map(|(id, _)| id).collect();
    // The last first, since those behind one that is removed have other ids afterwards.
    found.iter().rev().for_each(|&id| mesh.remove_column(id));
    !found.is_empty()
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
